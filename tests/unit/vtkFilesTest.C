// SPDX-License-Identifier: GPL-3.0-or-later
// What a viewer sees is what we have written: the case itself through the
// OpenFOAM reader that ParaView uses, and our VTK files.

#include <catch2/catch.hpp>

#include "fieldUnits.H"
#include "ground.H"
#include "sampleCase.H"
#include "timeSeries.H"
#include "vtkFiles.H"

#include <vtkCell.h>
#include <vtkCellData.h>
#include <vtkDataArray.h>
#include <vtkDoubleArray.h>
#include <vtkFieldData.h>
#include <vtkInformation.h>
#include <vtkInformationStringKey.h>
#include <vtkMultiBlockDataSet.h>
#include <vtkNew.h>
#include <vtkOpenFOAMReader.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>
#include <vtkStringArray.h>
#include <vtkXMLPolyDataReader.h>

#include <fstream>
#include <iostream>
#include <iterator>
#include <set>
#include <type_traits>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

//- A part of the case as ParaView names it, e.g. {"boundary", "terrain"}
vtkPolyData*
blockOf(vtkMultiBlockDataSet* blocks, const std::vector<std::string>& path)
{
    vtkDataObject* at = blocks;
    for (const std::string& name : path)
    {
        auto* parent = vtkMultiBlockDataSet::SafeDownCast(at);
        at = nullptr;
        for (unsigned i = 0; parent && i < parent->GetNumberOfBlocks(); ++i)
        {
            const char* title =
                parent->GetMetaData(i)->Get(vtkCompositeDataSet::NAME());
            if (title && name == title)
            {
                at = parent->GetBlock(i);
            }
        }
    }
    return vtkPolyData::SafeDownCast(at);
}


//- Largest difference of values, relative to the largest value
template<class T>
scalar difference(vtkDataArray* array, const UList<T>& expected)
{
    constexpr int n = std::is_same_v<T, scalar> ? 1 : 3;
    REQUIRE(array);
    REQUIRE(array->GetNumberOfTuples() == expected.size());
    REQUIRE(array->GetNumberOfComponents() == n);
    scalar largest = VSMALL;
    scalar error = 0;
    forAll (expected, i)
    {
        const auto* x = reinterpret_cast<const scalar*>(&expected[i]);
        for (int d = 0; d < n; ++d)
        {
            largest = std::max(largest, std::abs(x[d]));
            error = std::max(error, std::abs(array->GetComponent(i, d) - x[d]));
        }
    }
    return error / largest;
}


//- A case as ParaView's OpenFOAM reader shows it, from <case>/case.foam.
//  The reader keeps floats
class caseInReader
{
    vtkNew<vtkOpenFOAMReader> reader_;

public:
    explicit caseInReader(const fileName& caseDir)
    {
        const fileName file(caseDir / "case.foam");
        {
            const std::ofstream make(file);
        }
        reader_->SetFileName(file.c_str());
        reader_->UpdateInformation();
        // a part of the case that the user can choose, clouds chosen already
        CHECK(reader_->GetPatchArrayStatus("patch/terrain") == 0);
        reader_->EnableAllPatchArrays();
        reader_->EnableAllLagrangianArrays();
    }

    label nTimes() const
    {
        return label(reader_->GetTimeValues()->GetNumberOfTuples());
    }

    void showTime(const scalar time) const { reader_->UpdateTimeStep(time); }

    void
    compareGround(const pointField& points, const faceList& triangles) const
    {
        vtkPolyData* seen =
            blockOf(reader_->GetOutput(), {"boundary", "terrain"});
        REQUIRE(seen);
        REQUIRE(seen->GetNumberOfCells() == triangles.size());
        // the reader numbers the points of a patch anew
        scalar error = 0;
        forAll (triangles, i)
        {
            for (label k = 0; k < 3; ++k)
            {
                const double* x =
                    seen->GetPoint(seen->GetCell(i)->GetPointId(k));
                const point given = points[triangles[i][k]];
                error = std::max(error, mag(given - point(x[0], x[1], x[2])));
            }
        }
        CHECK(error <= 1e-7 * boundBox(points, false).mag());
    }

    void compareCloud(const word& name, const cloudState& cloud) const
    {
        vtkPolyData* seen = blockOf(reader_->GetOutput(), {"lagrangian", name});
        REQUIRE(seen);
        CHECK(seen->GetNumberOfCells() == cloud.size());
        CHECK(
            difference<vector>(seen->GetPoints()->GetData(), cloud.positions)
            < 1e-7
        );
        vtkPointData* data = seen->GetPointData();
        forAllConstIters (cloud.scalars, i)
        {
            INFO(i.key());
            CHECK(
                difference<scalar>(data->GetArray(i.key().c_str()), *i) < 1e-7
            );
        }
        forAllConstIters (cloud.vectors, i)
        {
            INFO(i.key());
            CHECK(
                difference<vector>(data->GetArray(i.key().c_str()), *i) < 1e-7
            );
        }
        const labelField& id = cloud.labels["id"];
        REQUIRE(data->GetArray("id"));
        forAll (id, i)
        {
            REQUIRE(data->GetArray("id")->GetComponent(i, 0) == id[i]);
        }
        REQUIRE(data->GetArray("sigma"));
        CHECK(
            data->GetArray("sigma")->GetComponent(3, 2)
            == Approx(cloud.symmTensors["sigma"][3].zz())
        );
    }
};


vtkSmartPointer<vtkPolyData> readVtp(const fileName& file)
{
    vtkNew<vtkXMLPolyDataReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    return reader->GetOutput();
}


//- The times that a viewer finds in <name>.pvd
std::string timesIn(const fileName& pvd)
{
    std::ifstream is(pvd);
    std::string times, line;
    while (std::getline(is, line))
    {
        const std::string key("timestep=\"");
        const auto at = line.find(key);
        if (at != std::string::npos)
        {
            const auto begin = at + key.size();
            times += line.substr(begin, line.find('"', begin) - begin) + " ";
        }
    }
    return times;
}

} // namespace


TEST_CASE("OpenFOAM reader of ParaView: ground and cloud as we wrote them")
{
    const auto format = GENERATE(IOstreamOption::ASCII, IOstreamOption::BINARY);
    const temporaryFolder folder;
    const label n = 500;
    writeSampleCase(folder.path(), n, IOstreamOption(format));
    pointField points;
    faceList triangles;
    sampleGround(points, triangles);

    const caseInReader seen(folder.path());
    CHECK(seen.nTimes() == 2);
    seen.showTime(0.5);
    seen.compareGround(points, triangles);
    const cloudState cloud = readCloud(folder.path() / "0.5", "grains");
    CHECK(cloud.size() == n);
    seen.compareCloud("grains", cloud);
}


// For tests/cases/quick/foamTools: not run unless asked for by the tag
TEST_CASE("OpenFOAM reader of ParaView: the case LPF_CASE", "[.case]")
{
    REQUIRE(std::getenv("LPF_CASE"));
    const fileName caseDir(std::getenv("LPF_CASE"));
    const caseInReader seen(caseDir);
    const autoPtr<ground> terrain = ground::read(caseDir);
    pointField points;
    faceList triangles;
    labelList zone;
    terrain().triangles(points, triangles, zone);
    REQUIRE(triangles.size() <= 200000);

    for (const fileName& dir : readDir(caseDir, fileName::DIRECTORY))
    {
        scalar time;
        if (!readScalar(dir, time))
        {
            continue;
        }
        seen.showTime(time);
        seen.compareGround(points, triangles);
        for (const word& cloud : cloudNames(caseDir / dir))
        {
            const cloudState state = readCloud(caseDir / dir, cloud);
            std::cout << "Time = " << dir << ": " << state.size()
                      << " particles of " << cloud << ", " << triangles.size()
                      << " triangles\n";
            seen.compareCloud(cloud, state);
        }
    }
}


TEST_CASE("write a sample case into LPF_CASE", "[.writeCase]")
{
    REQUIRE(std::getenv("LPF_CASE"));
    const bool ascii = std::getenv("LPF_ASCII");
    writeSampleCase(
        std::getenv("LPF_CASE"),
        2000,
        IOstreamOption(ascii ? IOstreamOption::ASCII : IOstreamOption::BINARY)
    );
}


TEST_CASE("vtkFiles: large coordinates and all fields come back exactly")
{
    const temporaryFolder folder;
    const cloudState cloud = sampleCloud(100);
    const vtkFrame frame{point(2.7e6 + 0.1, 1.2e6 + 0.3, 3e3), 12.5, "WKT"};
    writeCloudVtp(folder.path() / "grains.vtp", cloud, frame);
    const auto grains = readVtp(folder.path() / "grains.vtp");

    CHECK(grains->GetNumberOfVerts() == 100);
    const vectorField global(cloud.positions + frame.origin);
    CHECK(difference<vector>(grains->GetPoints()->GetData(), global) == 0);
    vtkPointData* data = grains->GetPointData();
    CHECK(data->GetNumberOfArrays() == 5);
    CHECK(difference<vector>(data->GetArray("U"), cloud.vectors["U"]) == 0);
    vtkDataArray* sigma = data->GetArray("sigma");
    REQUIRE(sigma);
    CHECK(std::string(sigma->GetComponentName(3)) == "XY");
    CHECK(sigma->GetComponent(7, 3) == cloud.symmTensors["sigma"][7].xy());
    CHECK(
        std::string(sigma->GetInformation()->Get(vtkDataArray::UNITS_LABEL()))
        == "Pa"
    );
    vtkFieldData* about = grains->GetFieldData();
    REQUIRE(about->GetArray("TimeValue"));
    CHECK(about->GetArray("TimeValue")->GetComponent(0, 0) == 12.5);
    CHECK(about->GetAbstractArray("crs") != nullptr);
}


TEST_CASE("vtkFiles: the ground with zone and elevation")
{
    const temporaryFolder folder;
    pointField points;
    faceList triangles;
    sampleGround(points, triangles);
    labelList zone(triangles.size(), 1);
    zone[0] = 0;
    writeGroundVtp(
        folder.path() / "terrain.vtp",
        points,
        triangles,
        zone,
        {"chute", "plate"},
        {point(0, 0, 1000), 0, ""}
    );
    const auto ground = readVtp(folder.path() / "terrain.vtp");
    CHECK(ground->GetNumberOfPolys() == triangles.size());
    REQUIRE(ground->GetCellData()->GetArray("zone"));
    CHECK(ground->GetCellData()->GetArray("zone")->GetComponent(1, 0) == 1);
    REQUIRE(ground->GetPointData()->GetArray("elevation"));
    CHECK(
        ground->GetPointData()->GetArray("elevation")->GetComponent(2, 0)
        == 999.75
    );
    auto* names = vtkStringArray::SafeDownCast(
        ground->GetFieldData()->GetAbstractArray("zoneNames")
    );
    REQUIRE(names);
    CHECK(names->GetValue(1) == "plate");
}


TEST_CASE("timeSeries: a restart gives no duplicates, a rerun nothing stale")
{
    const temporaryFolder folder;
    const fileName dir(folder.path());
    const auto touch = [&](const word& name)
    {
        std::ofstream(dir / name) << name;
        return fileName(name);
    };
    {
        timeSeries first(dir, "grains");
        first.set(0, touch("grains_0.vtp"));
        first.set(0.1, touch("grains_10.vtp"));
        first.set(1.0 / 3, touch("grains_33.vtp"));
        first.write();
    }
    CHECK(timesIn(dir / "grains.pvd") == "0 0.1 0.3333333333333333 ");

    // go on: the last time is converted again
    std::map<scalar, fileName> data;
    timeSeries second(dir, "grains");
    second.set(1.0 / 3, "grains_33.vtp");
    second.set(0.5, touch("grains_50.vtp"));
    second.write();
    CHECK(timesIn(dir / "grains.pvd") == "0 0.1 0.3333333333333333 0.5 ");

    // purged: 0.1 is no time of the case any more but was of this run
    timeSeries purged(dir, "grains");
    purged.prune({{1.0 / 3, dir / "grains_0.vtp"}, {0.5, dir / "newer"}});
    CHECK(purged.files().count(0.1) == 1);

    // a file that is gone, a time that the case does not have
    rm(dir / "grains_0.vtp");
    timeSeries rerun(dir, "grains");
    rerun.prune({{0, dir / "grains_10.vtp"}, {0.1, dir / "grains_10.vtp"}});
    rerun.write();
    CHECK(timesIn(dir / "grains.pvd") == "0.1 ");
}


TEST_CASE("vtk: every field of a cloud in the design has units")
{
    std::ifstream is(getEnv("LPF_PROJECT_DIR") + "/doc/design.md");
    std::string line;
    bool isCloud = false;
    std::set<std::string> fields;
    while (std::getline(is, line))
    {
        isCloud = line.rfind("## ", 0) == 0
                    ? line.find("Files of a cloud") != std::string::npos
                    : isCloud;
        if (!isCloud || line.rfind("| `", 0) != 0)
        {
            continue;
        }
        // names stand in the first cell, each in a pair of ticks
        const std::string names = line.substr(0, line.find('|', 1));
        for (auto at = names.find('`'); at != std::string::npos;
             at = names.find('`', names.find('`', at + 1) + 1))
        {
            fields.insert(names.substr(at + 1, names.find('`', at + 1) - at - 1)
            );
        }
    }
    fields.erase("positions");
    CHECK(fields.size() >= 14);
    for (const std::string& name : fields)
    {
        INFO(name);
        CHECK(!unitsOf(word(name)).empty());
    }
    CHECK(unitsOf("drag") == "m/s2");
    CHECK(unitsOf("gradPForce") == "m/s2");
    CHECK(unitsOf("S") == "1");
}
