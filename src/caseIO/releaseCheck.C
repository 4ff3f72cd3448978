// SPDX-License-Identifier: GPL-3.0-or-later

#include "releaseCheck.H"
#include "cloudState.H"
#include "foamFile.H"
#include "inputCheck.H"
#include "OSspecific.H"

namespace
{

using namespace Foam;

const char* const old =
    "this time is of a run with other particles than terrainToParticles wrote "
    "last. ";

const char* const remedyOfSample =
    "Remove the old times (foamListTimes -rm), or choose others with -time";


//- At the start all particles are there, later some may have left
void checkCount(
    const fileName& timeDir,
    const word& cloud,
    const label released,
    const bool atStart
)
{
    const fileName file(timeDir / "lagrangian" / cloud / "positions");
    const label n = lpf::readPositions(lpf::inputFile(file)).size();
    if (n > released || (atStart && n != released))
    {
        FatalIOError("", "", 0, file, -1, -1)
            << "There are " << n << " particles of " << cloud
            << ", constant/releaseProperties has " << released << ": " << old
            << remedyOfSample << exit(FatalIOError);
    }
}

} // namespace


bool Foam::lpf::checkFingerprint(
    const dictionary& state, const dictionary& release, const string& remedy
)
{
    if (!release.found("fingerprint") || !state.found("release"))
    {
        return false;
    }
    const word mine = release.get<word>("fingerprint");
    const word its = state.get<word>("release");
    if (its != mine)
    {
        refuse(
            state,
            "release",
            "The state has the release " + its
                + ", constant/releaseProperties has " + mine + ": " + old
                + remedy
        );
    }
    return true;
}


void Foam::lpf::checkReleaseOf(
    const fileName& caseDir, const instantList& times
)
{
    const fileName releaseFile(caseDir / "constant" / "releaseProperties");
    if (!isFile(releaseFile))
    {
        return;
    }
    const dictionary release = readDictionary(releaseFile);
    for (const instant& t : times)
    {
        const fileName dir(caseDir / t.name());
        const fileName stateFile(dir / "uniform" / "lpfState");
        const bool continued = isFile(stateFile);
        if (continued
            && checkFingerprint(
                readDictionary(stateFile), release, remedyOfSample
            ))
        {
            continue;
        }
        for (const word& cloud : cloudNames(dir))
        {
            const dictionary* made = release.findDict(cloud);
            if (made && made->found("count"))
            {
                checkCount(dir, cloud, made->get<label>("count"), !continued);
            }
        }
    }
}
