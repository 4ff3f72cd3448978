// SPDX-License-Identifier: GPL-3.0-or-later
// What a viewer sees is what we have written: the case itself through the
// OpenFOAM reader that ParaView uses, and our VTK files.

#include <catch2/catch.hpp>

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
#include <iterator>

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


//- Largest difference of values; the OpenFOAM reader keeps floats
scalar difference(vtkDataArray* array, const UList<vector>& expected)
{
    REQUIRE(array);
    REQUIRE(array->GetNumberOfTuples() == expected.size());
    REQUIRE(array->GetNumberOfComponents() == 3);
    scalar largest = 0;
    forAll (expected, i)
    {
        for (direction d = 0; d < 3; ++d)
        {
            largest = std::max(
                largest, std::abs(array->GetComponent(i, d) - expected[i][d])
            );
        }
    }
    return largest;
}


fileName touched(const fileName& caseDir)
{
    const fileName file(caseDir / "case.foam");
    const std::ofstream make(file);
    return file;
}


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

    vtkNew<vtkOpenFOAMReader> reader;
    reader->SetFileName(touched(folder.path()).c_str());
    reader->UpdateInformation();
    CHECK(reader->GetTimeValues()->GetNumberOfTuples() == 2);
    CHECK(reader->GetPatchArrayStatus("patch/terrain") == 0);
    CHECK(reader->GetPatchArrayStatus("lagrangian/grains") == 1);
    reader->EnableAllPatchArrays();
    reader->EnableAllLagrangianArrays();
    reader->SetTimeValue(0.5);
    reader->Update();

    vtkPolyData* terrain =
        blockOf(reader->GetOutput(), {"boundary", "terrain"});
    REQUIRE(terrain);
    pointField points;
    faceList triangles;
    sampleGround(points, triangles);
    REQUIRE(terrain->GetNumberOfCells() == triangles.size());
    forAll (triangles, i)
    {
        // the reader numbers the points of a patch anew
        for (label k = 0; k < 3; ++k)
        {
            const point x = points[triangles[i][k]];
            const double* seen =
                terrain->GetPoint(terrain->GetCell(i)->GetPointId(k));
            CHECK(x == point(seen[0], seen[1], seen[2]));
        }
    }

    vtkPolyData* grains =
        blockOf(reader->GetOutput(), {"lagrangian", "grains"});
    REQUIRE(grains);
    const cloudState cloud = readCloud(folder.path() / "0.5", "grains");
    CHECK(grains->GetNumberOfCells() == n);
    CHECK(difference(grains->GetPoints()->GetData(), cloud.positions) < 1e-7);
    vtkPointData* data = grains->GetPointData();
    CHECK(difference(data->GetArray("U"), cloud.vectors["U"]) < 1e-7);
    REQUIRE(data->GetArray("id"));
    CHECK(data->GetArray("id")->GetComponent(3, 0) == n - 4);
    REQUIRE(data->GetArray("sigma"));
    CHECK(data->GetArray("sigma")->GetNumberOfComponents() == 6);
    CHECK(
        data->GetArray("sigma")->GetComponent(3, 2)
        == Approx(cloud.symmTensors["sigma"][3].zz())
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
    CHECK(difference(grains->GetPoints()->GetData(), global) == 0);
    vtkPointData* data = grains->GetPointData();
    CHECK(data->GetNumberOfArrays() == 5);
    CHECK(difference(data->GetArray("U"), cloud.vectors["U"]) == 0);
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
