// SPDX-License-Identifier: GPL-3.0-or-later
/*
Application  depositionSample
Description  Deposit maps and tables of a case: thickness, depth, maxima,
             arrival, fronts along paths, outline, scores against observed
             areas, as GeoTIFF, vector file, CSV and PNG.
Usage        depositionSample [-case <dir>] [-dict <file>]
                 [-time <ranges>] [-latestTime] [-noZero]
             Reads  system/depositionSampleDict, constant/terrain,
                    constant/releaseProperties, constant/phaseProperties,
                    <time>/lagrangian/<cloud>,
                    postProcessing/lpfSolver/<time>/phases.dat for a series
             Writes postProcessing/deposition/<first time sampled>/, with
                    _<last time> if later times are left out, anew and as a
                    whole; with more clouds than one a folder for each, and
                    beside them the pictures of a series
             Manual etc/caseDicts/annotated/depositionSampleDict
*/
#include "argList.H"
#include "Time.H"
#include "timeSelector.H"

#include "caseSampler.H"
#include "exitStatus.H"
#include "inputCheck.H"
#include "productFolder.H"
#include "products.H"
#include "seriesPictures.H"

#include <vector>

using namespace Foam;

namespace
{

fileName dictionaryFile(const argList& args)
{
    const fileName file = args.getOrDefault<fileName>(
        "dict", args.path() / "system" / "depositionSampleDict"
    );
    return file.isAbsolute() ? file : cwd() / file;
}


int sample(const argList& args)
{
    // Without controlDict: only the times are needed, not what else it says
    Time runTime(
        args.rootPath(), args.caseName(), "system", "constant", false, false
    );
    const instantList selected = timeSelector::select0(runTime, args);

    const dictionary dict = lpf::readDictionary(dictionaryFile(args));
    const lpf::caseSampler sampler(
        args.path(), dict, runTime.times(), selected
    );
    // What can be wrong with the input shows before anything is written
    std::vector<lpf::deposit> results;
    std::vector<lpf::findings> found;
    for (const word& cloud : sampler.clouds())
    {
        results.push_back(sampler.sample(cloud));
        found.push_back(lpf::findingsOf(results.back()));
    }
    const lpf::seriesTable forces =
        sampler.hasSeries()
            ? lpf::seriesTable(args.path(), "lpfSolver", "phases.dat")
            : lpf::seriesTable();
    lpf::productFolder folder(
        args.path() / "postProcessing" / "deposition", sampler.folderName()
    );
    for (std::size_t k = 0; k < results.size(); ++k)
    {
        lpf::writeProducts(
            folder.path(results[k].cloud, sampler.clouds()),
            results[k],
            found[k]
        );
    }
    if (sampler.hasSeries())
    {
        lpf::writeSeries(folder.top(), results, forces);
    }
    folder.commit();
    Info << "Written: " << folder.name() << nl << nl << "End" << nl << endl;
    return 0;
}

} // namespace


int main(int argc, char* argv[])
{
    argList::addNote("Deposit maps and tables of the written times");
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption(
        "dict", "file", "Read another file than system/depositionSampleDict"
    );
    timeSelector::addOptions(false, false);
    const argList args(argc, argv);
    if (!args.checkRootCase())
    {
        FatalError.exit(); // argList ends with status 0 after a return
    }
    return lpf::exitStatus([&] { return sample(args); });
}
