// SPDX-License-Identifier: GPL-3.0-or-later
/*
Application  lpfToVTK
Description  Clouds and ground of a case as VTK XML files for ParaView:

                 VTK/<cloud>_<step>.vtp      each time, all fields
                 VTK/<cloud>.pvd             the times, for ParaView
                 VTK/<cloud>.vtp.series      the same in OpenFOAM's form
                 VTK/terrain.vtp             ground with zone and elevation

             Coordinates are those of the input (the local origin added back)
             in doubles.

Usage        lpfToVTK [-case dir] [-time ranges | -latestTime] [-noZero]
                 [-local]
*/

#include "argList.H"
#include "Time.H"
#include "timeSelector.H"
#include "OSspecific.H"

#include "cloudState.H"
#include "exitStatus.H"
#include "ground.H"
#include "releaseCheck.H"
#include "timeSeries.H"
#include "uniformTime.H"
#include "vtkFiles.H"

#include <set>

namespace
{

using namespace Foam;
using namespace Foam::lpf;

void describe()
{
    argList::addNote(
        "Write the clouds and the ground of a case as VTK XML files for "
        "ParaView:\nVTK/<cloud>.pvd (or .vtp.series) and VTK/terrain.vtp.\n"
        "Coordinates are those of the input, in doubles. ParaView draws in "
        "single\nprecision: if particles far from the origin look as if on "
        "a grid, use -local"
    );
    argList::noParallel();
    argList::noFunctionObjects();
    timeSelector::addOptions(false, false);
    argList::addBoolOption(
        "local",
        "Local coordinates, as in the case: the origin of "
        "constant/terrain/terrainProperties is not added"
    );
}


//- A number of each time for the names of files: the time step, so that it
//  does not change when other times come or go. The place in the list where
//  steps are not known or not unique
labelList fileNumbers(const fileName& caseDir, const instantList& times)
{
    labelList steps(times.size());
    std::set<label> seen;
    bool unique = true;
    forAll (times, i)
    {
        steps[i] = readUniformTime(caseDir / times[i].name()).index;
        unique = unique && seen.insert(steps[i]).second;
    }
    return unique ? steps : identity(times.size());
}


//- Times of the case that have this cloud, each with a file of it
std::map<scalar, fileName>
timesOf(const fileName& caseDir, const instantList& times, const word& cloud)
{
    std::map<scalar, fileName> found;
    for (const instant& t : times)
    {
        const fileName dir(caseDir / t.name() / "lagrangian" / cloud);
        for (const char* name : {"positions", "positions.gz"})
        {
            if (isFile(dir / name, false))
            {
                found[t.value()] = dir / name;
            }
        }
    }
    return found;
}


wordList cloudsOf(const fileName& caseDir, const instantList& times)
{
    wordHashSet names;
    for (const instant& t : times)
    {
        names.insert(cloudNames(caseDir / t.name()));
    }
    return names.sortedToc();
}


class converter
{
    const fileName caseDir_;
    const fileName dir_;
    const instantList all_; //!< times of the case
    const labelList numbers_;
    vtkFrame frame_;

public:
    converter(
        const fileName& caseDir, const instantList& all, const vtkFrame& frame
    )
        : caseDir_(caseDir), dir_(caseDir / "VTK"), all_(all),
          numbers_(fileNumbers(caseDir, all)), frame_(frame)
    {
    }

    void convertCloud(const word& cloud, const instantList& selected)
    {
        timeSeries series(dir_, cloud);
        const auto data = timesOf(caseDir_, all_, cloud);
        series.prune(data);
        forAll (all_, i)
        {
            const scalar t = all_[i].value();
            if (!selected.found(all_[i]) || !data.count(t))
            {
                continue;
            }
            const cloudState state =
                readCloud(caseDir_ / all_[i].name(), cloud);
            const fileName name(cloud + '_' + Foam::name(numbers_[i]) + ".vtp");
            frame_.time = t;
            writeCloudVtp(dir_ / name, state, frame_);
            series.set(t, name);
            Info << "Time = " << all_[i].name() << "    VTK/" << name.c_str()
                 << "    " << state.size() << " particles" << endl;
        }
        series.write();
        Info << "VTK/" << cloud << ".pvd    "
             << static_cast<label>(series.files().size()) << " times" << nl
             << endl;
    }
};


void convertGround(
    const fileName& caseDir, const ground& terrain, const vtkFrame& frame
)
{
    pointField points;
    faceList triangles;
    labelList zone;
    terrain.triangles(points, triangles, zone);
    writeGroundVtp(
        caseDir / "VTK" / "terrain.vtp",
        points,
        triangles,
        zone,
        terrain.zones(),
        frame
    );
    Info << "VTK/terrain.vtp    " << triangles.size() << " triangles, zones "
         << flatOutput(terrain.zones()) << nl << endl;
}

int convert(const argList& args)
{
    // without controlDict: all that is needed of it are the times
    Time runTime(
        args.rootPath(), args.caseName(), "system", "constant", false, false
    );
    const fileName caseDir(runTime.globalPath());

    instantList all(runTime.times());
    all = instantList(SubList<instant>(all, all.size() - 1, 1)); // no constant
    const instantList selected = timeSelector::select0(runTime, args);
    checkReleaseOf(caseDir, selected);

    const autoPtr<ground> terrain = ground::read(caseDir);
    vtkFrame frame{
        args.found("local") ? point(Zero) : terrain().origin(),
        0,
        terrain().crs()};
    Info << nl << "Coordinates "
         << (args.found("local") ? "local; the case has its origin at "
                                 : "of the input; added to local ones is ")
         << terrain().origin() << nl << endl;
    convertGround(caseDir, terrain(), frame);

    const wordList clouds = cloudsOf(caseDir, selected);
    if (clouds.empty())
    {
        FatalErrorInFunction
            << "No cloud in the times selected of " << caseDir << nl
            << "Run terrainToParticles and lpfSolver, or choose other times"
            << exit(FatalError);
    }
    converter converted(caseDir, all, frame);
    for (const word& cloud : clouds)
    {
        converted.convertCloud(cloud, selected);
    }
    Info << "End" << nl << endl;
    return 0;
}

} // namespace


int main(int argc, char* argv[])
{
    describe();
    const argList args(argc, argv);
    return lpf::exitStatus([&] { return convert(args); });
}
