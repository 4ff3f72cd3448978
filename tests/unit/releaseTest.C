// SPDX-License-Identifier: GPL-3.0-or-later
// terrainToParticles from dictionaries to files: masses, places, stresses.

#include <catch2/catch.hpp>

#include "heightField.H"
#include "polygonTriangles.H"
#include "raster.H"
#include "releaseCase.H"

#include "polygons.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

const scalar pi = constant::mathematical::pi;

scalar lowest(const cloudState& cloud, const vector& n)
{
    scalar least = GREAT;
    for (const vector& x : cloud.positions)
    {
        least = min(least, n & x);
    }
    return least;
}

} // namespace


TEST_CASE("a block on a level floor is a whole lattice", "[release]")
{
    const scene s("spacing 0.1; origin (0 0 0);" + floorPart + blockPart);
    const cloudState cloud = s.cloud();
    REQUIRE(cloud.size() == 500);
    CHECK(lowest(cloud, vector(0, 0, 1)) == Approx(0.05).epsilon(1e-12));
    const scalar mass = 2500 * 0.6 * 0.5;
    CHECK(sum(cloud.scalars["mass"]) == Approx(mass).epsilon(1e-12));
    const labelField& id = cloud.labels["id"];
    forAll (id, i)
    {
        REQUIRE(id[i] == i);
    }
    CHECK(cloud.scalars["h"][0] == Approx(0.13));
    CHECK(s.properties().subDict("grains").get<label>("count") == 500);
    CHECK(s.properties().get<scalar>("releaseHeight") == Approx(0.5));
}

TEST_CASE("stress at rest is that of the depth below the top", "[release]")
{
    const scene s("spacing 0.1; origin (0 0 0);" + floorPart + blockPart);
    const cloudState cloud = s.cloud();
    const symmTensorField& sigma = cloud.symmTensors["sigma"];
    const scalarField& p = cloud.scalars["p"];
    const scalar K0 = 0.25 / 0.75;
    forAll (sigma, i)
    {
        const scalar depth = 0.5 - cloud.positions[i].z();
        const scalar vertical = -1500 * 10 * depth;
        CHECK(sigma[i].zz() == Approx(vertical));
        CHECK(sigma[i].xx() == Approx(K0 * vertical));
        CHECK(mag(sigma[i].xz()) < 1e-9);
        CHECK(p[i] == Approx(-vertical * (1 + 2 * K0) / 3));
    }
}

TEST_CASE("a lattice along an inclined plane turns the stress", "[release]")
{
    const scene s("spacing 0.1; origin (0 0 0);"
                  "lattice { axes ((0.8 0 -0.6) (0 1 0) (0.6 0 0.8)); }"
                  "ground { type plane; point (0 0 0); normal (0.6 0 0.8);"
                  " direction (0.8 0 -0.6); size (20 20); zone floor; }"
                  "release { type box; corner (0 0 0);"
                  " edges ((0.8 0 -0.6) (0 1 0) (0.3 0 0.4));"
                  " grains { solidFraction 0.6; mass 123.456; } }");
    const cloudState cloud = s.cloud();
    REQUIRE(cloud.size() == 500);
    const vector n(0.6, 0, 0.8);
    CHECK(lowest(cloud, n) == Approx(0.05));
    CHECK(sum(cloud.scalars["mass"]) == Approx(123.456).epsilon(1e-12));
    const symmTensor& sigma = cloud.symmTensors["sigma"][0];
    const scalar depth = 0.5 - (n & cloud.positions[0]);
    const scalar normal = -(123.456 / 0.5) * 8 * depth;
    CHECK((n & (sigma & n)) == Approx(normal));
    CHECK((vector(0, 1, 0) & (sigma & vector(0, 1, 0))) == Approx(normal / 3));
}

TEST_CASE("a tank with an inclined floor has its volume", "[release]")
{
    const scene s(
        "spacing 0.05; origin (0 0 0);"
        "ground { floor { type polygon; points ((0 0 0) (1 0 0.5) (1 1 0.5)"
        " (0 1 0)); } walls { type box; zone floor; min (0 0 0); max (1 1 2);"
        " side inside; omit (zMin zMax); } }"
        "release { type tank; box ((-1 -1 -1) (3 3 3)); level 1;"
        " grains { solidFraction 0.5; } }"
    );
    const cloudState cloud = s.cloud();
    CHECK(
        s.properties().subDict("grains").get<scalar>("volume")
        == Approx(0.75).epsilon(1e-3)
    );
    const vector n = vector(-0.5, 0, 1) / std::sqrt(1.25);
    CHECK(lowest(cloud, n) >= 0.35 * 0.05);
    for (const vector& x : cloud.positions)
    {
        REQUIRE(x.z() < 1);
        REQUIRE(mag(x.x() - 0.5) < 0.5);
    }
}

TEST_CASE("fill finds the surface of a volume", "[release]")
{
    const word surface = GENERATE(word("level"), word("parallel"));
    const scene s(
        "spacing 0.02; origin (0 0 0);"
        "lattice { axes ((0.8 0 -0.6) (0 1 0) (0.6 0 0.8)); }"
        "ground { type plane; point (0 0 0); normal (0.6 0 0.8);"
        " direction (0.8 0 -0.6); size (20 20); zone floor; }"
        "release { type fill; box ((0 0 0) (1.4 0.5 0.2)); volume 0.1;"
        " surface "
        + surface + "; grains { solidFraction 0.5; } }"
    );
    const cloudState cloud = s.cloud();
    const scalar lattice = cloud.size() * 8e-6;
    CHECK(lattice == Approx(0.1).epsilon(0.03));
    CHECK(sum(cloud.scalars["mass"]) == Approx(125).epsilon(1e-12));
}

TEST_CASE("a raster is released with its exact volume", "[release]")
{
    const scene s("spacing 2;"
                  "ground { type raster; file \"dem.asc\"; zone floor; }"
                  "release { type raster; file \"thickness.asc\";"
                  " grains { solidFraction 0.5; } }");
    std::string dem = "ncols 20\nnrows 20\nxllcenter 1000\nyllcenter 3000000\n"
                      "cellsize 10\nNODATA_value -9999\n";
    std::string thickness = dem;
    for (label row = 0; row < 20; ++row)
    {
        for (label i = 0; i < 20; ++i)
        {
            dem += std::to_string(0.5 * i + 300) + ' ';
            const bool in = i > 5 && i < 12 && row > 5 && row < 12;
            thickness += in ? "10 " : (i == 0 ? "-9999 " : "0 ");
        }
        dem += '\n';
        thickness += '\n';
    }
    s.raw("dem.asc", dem);
    s.raw("thickness.asc", thickness);
    const cloudState cloud = s.cloud();
    const dictionary grains = s.properties().subDict("grains");
    CHECK(grains.get<scalar>("volume") == Approx(36 * 100 * 10));
    CHECK(cloud.size() * 8 == Approx(36000).epsilon(0.02));
    const autoPtr<ground> bed = ground::read(s.path());
    CHECK(bed->origin().x() == 1000);
    CHECK(bed->origin().y() == 3000000);
    scalar least = GREAT;
    for (const vector& x : cloud.positions)
    {
        const groundHit hit = bed->elevation(x.x(), x.y());
        REQUIRE(hit.found);
        least = min(least, x.z() - hit.nearest.z());
    }
    CHECK(least == Approx(1));
}

TEST_CASE("an origin far from the ground is refused", "[release]")
{
    const auto from = [](const std::string& x)
    {
        return scene(
            "spacing 0.1; origin (" + x + " 0 0);" + floorPart + blockPart
        );
    };
    CHECK(from("-1e7").cloud().size() > 0);
    const scene far = from("-1e10");
    CHECK(contains(far.error(), "more than 1e9 spacings"));
    CHECK(far.isUntouched());
}

TEST_CASE("a release off the ground is refused", "[release]")
{
    const scene s("spacing 2;"
                  "ground { type raster; file \"dem.asc\"; zone floor; }"
                  "release { type raster; file \"thickness.asc\";"
                  " grains { solidFraction 0.5; } }");
    const std::string place = "xllcenter 0\nyllcenter 0\ncellsize 10\n"
                              "NODATA_value -9999\n";
    s.raw(
        "dem.asc",
        "ncols 4\nnrows 4\n" + place
            + "1 1 1 1\n1 -9999 1 1\n1 1 1 1\n1 1 1 1\n"
    );
    const std::string size = "ncols 4\nnrows 4\n";
    s.raw(
        "thickness.asc", size + place + "0 0 0 0\n0 5 5 0\n0 5 5 0\n0 0 0 0\n"
    );
    CHECK(contains(s.error(), "no ground beneath"));
    CHECK(s.isUntouched());
    s.raw("dem.asc", size + place + "1 1 1 1\n1 1 1 1\n1 1 1 1\n1 1 1 1\n");
    CHECK(contains(s.error(), "touches the border"));
    CHECK(s.isUntouched());
    s.raw("thickness.asc", size + place + "0 0 0 0\n0 0 0 0\n0 0 0 0\n0 0 0 0");
    CHECK(contains(s.error(), "there is no release"));
}

TEST_CASE("polygon thickness is vertical or normal to the slope", "[release]")
{
    const bool normal = GENERATE(false, true);
    const scene s(
        "spacing 1; origin (0 0 0);"
        "ground { type polygon; zone floor; points ((-50 -50 -50)"
        " (50 -50 50) (50 50 50) (-50 50 -50)); }"
        "release { type polygon; file \"area.geojson\"; thickness "
        + std::string(normal ? "normal" : "vertical")
        + " 5; grains { solidFraction 0.5; } }"
    );
    s.raw(
        "area.geojson",
        R"({"type":"Feature","properties":{},"crs":{"type":"name",)"
        R"("properties":{"name":"EPSG:2193"}},"geometry":{"type":"Polygon",)"
        R"("coordinates":[[[0,0],[20,0],[20,20],[0,20],[0,0]],)"
        R"([[5,5],[15,5],[15,15],[5,15],[5,5]]]}})"
    );
    const cloudState cloud = s.cloud();
    const scalar volume = 300 * 5 * (normal ? std::sqrt(2.) : 1);
    CHECK(
        s.properties().subDict("grains").get<scalar>("volume")
        == Approx(volume).epsilon(1e-6)
    );
    CHECK(cloud.size() == Approx(volume).epsilon(0.01));
    for (const vector& x : cloud.positions)
    {
        REQUIRE((mag(x.x() - 10) > 5 || mag(x.y() - 10) > 5));
    }
}

TEST_CASE("plane strain is one layer across", "[release]")
{
    const scene s(
        "spacing 0.1; origin (0 0 0);" + floorPart
        + "release { type box; corner (0 -1 0); edges ((1 0 0)"
          " (0 2 0) (0 0 0.5)); grains { solidFraction 0.6; } }"
    );
    s.write(
        "constant/boundaryProperties",
        "planeStrain { normal (0 1 0); thickness 0.25; }"
    );
    const cloudState cloud = s.cloud();
    CHECK(cloud.size() == 50);
    for (const vector& x : cloud.positions)
    {
        REQUIRE(x.y() == 0);
    }
    CHECK(
        sum(cloud.scalars["mass"])
        == Approx(2500 * 0.6 * 0.5 * 0.25).epsilon(1e-12)
    );
    CHECK(s.properties().get<label>("dimensions") == 2);
}

TEST_CASE("a cyclic pair is a whole number of spacings", "[release]")
{
    const scene s(
        "spacing 0.1; origin (0 0 0);" + floorPart
        + "release { type box; corner (-1 -1 0); edges ((3 0 0)"
          " (0 3 0) (0 0 0.5)); grains { solidFraction 0.6; } }"
    );
    s.write("constant/boundaryProperties", "cyclic { x (0 1.04); }");
    CHECK(contains(s.error(), "whole number of them"));
    s.write("constant/boundaryProperties", "cyclic { x (0 1); y (0.5 1.5); }");
    CHECK(s.cloud().size() == 10 * 10 * 5);
}

TEST_CASE("cyclic planes cut volume and mass of a release", "[release]")
{
    const std::string before = "spacing 0.1; origin (0 0 0);" + floorPart
                             + "release { type box; corner (-1 0 0); edges ((3 "
                               "0 0) (0 1 0) (0 0 0.5)); grains { "
                               "solidFraction 0.6; ";
    const scene s(before + "} }");
    s.write("constant/boundaryProperties", "cyclic { x (0 1); }");
    CHECK(
        sum(s.cloud().scalars["mass"])
        == Approx(2500 * 0.6 * 0.5).epsilon(1e-12)
    );
    const dictionary cyclic(s.properties().subDict("cyclic"));
    CHECK(readInterval(cyclic, "x") == Pair<scalar>(0, 1));

    const scene given(before + "mass 100; } }");
    given.write("constant/boundaryProperties", "cyclic { x (0 1); }");
    CHECK(contains(given.error(), "66.6667 % off release"));

    // 0.2 m of water on top of the pores, between the planes as elsewhere
    const scene wet(
        before + "} water { mass 2100; excess onTop; } }", "grains water"
    );
    wet.write("constant/boundaryProperties", "cyclic { x (0 1); }");
    CHECK(contains(wet.error(), "water of release"));
    const scene wetByVolume(
        before + "} water { dryBulkFraction 0.8; excess onTop; } }",
        "grains water"
    );
    wetByVolume.write("constant/boundaryProperties", "cyclic { x (0 1); }");
    CHECK(
        sum(wetByVolume.cloud("water").scalars["mass"])
        == Approx(1000 * 0.8 * 0.5).epsilon(1e-6)
    );
}

TEST_CASE("a velocity at the start counts in the largest speed", "[release]")
{
    const auto maxSpeed = [](const std::string& velocity)
    {
        const scene s(
            "spacing 0.1; origin (0 0 0);" + floorPart
            + "release { type box; corner (0 0 0); edges ((1 0 0) (0 1 0) (0 0 "
              "0.5)); velocity "
            + velocity + "; grains { solidFraction 0.6; } }"
        );
        s.prepare();
        return s.properties().get<scalar>("maxSpeed");
    };
    // from the top, 0.5 m over the floor, g = 10
    CHECK(maxSpeed("(0 0 0)") == Approx(std::sqrt(10)));
    CHECK(maxSpeed("(0 3 4)") == Approx(std::sqrt(35)));
}

TEST_CASE("the same scene elsewhere has the same particles", "[release]")
{
    const auto at = [](const std::string& x0, const std::string& x1)
    {
        const scene s(
            "spacing 0.0625; ground { type polygon; zone floor; points ((" + x0
            + " 0 0) (" + x1 + " 0 0.5) (" + x1 + " 2 0.5) (" + x0
            + " 2 0)); } release { type tank; box ((" + x0 + " 0 0) (" + x1
            + " 2 2)); level 1; grains { solidFraction 0.5; } }"
        );
        return s.cloud();
    };
    const cloudState one = at("0", "4"), far = at("3000000", "3000004");
    REQUIRE(one.size() == far.size());
    forAll (one.positions, i)
    {
        REQUIRE(mag(one.positions[i] - far.positions[i]) < 1e-12);
    }
}

TEST_CASE("a scene scaled by a power of two keeps its bits", "[release]")
{
    const auto at = [](const scalar scale)
    {
        const auto n = [scale](const scalar x)
        {
            std::ostringstream os;
            os.precision(17);
            os << x * scale;
            return os.str() + ' ';
        };
        const scene s(
            "spacing " + n(0.0625)
            + "; ground { type polygon; zone floor;"
              " points ((0 0 0) ("
            + n(4) + "0 " + n(0.7) + ") (" + n(4) + n(2) + n(0.7) + ") (0 "
            + n(2)
            + "0)); } release { type fill;"
              " box ((0 0 0) ("
            + n(4) + n(2) + n(2)
            + ")); surface level;"
              " volume "
            + n(3 * scale * scale) + "; grains { solidFraction 0.5; } }"
        );
        return s.cloud();
    };
    const cloudState one = at(1), large = at(1024), small = at(1. / 1024);
    REQUIRE(one.size() == large.size());
    REQUIRE(one.size() == small.size());
    forAll (one.positions, i)
    {
        REQUIRE(1024 * one.positions[i] == large.positions[i]);
        REQUIRE(one.positions[i] == 1024 * small.positions[i]);
        REQUIRE(1024 * one.scalars["p"][i] == large.scalars["p"][i]);
    }
}

TEST_CASE("wrong dictionaries leave the case as it was", "[release]")
{
    const auto message = [](const std::string& dict)
    {
        const scene s(dict);
        const std::string text = s.error();
        CHECK(s.isUntouched());
        return text;
    };
    const std::string start = "spacing 0.1; origin (0 0 0);";
    CHECK(contains(message(start + floorPart + "relaese { }"), "relaese"));
    CHECK(contains(message(start + floorPart + "release { }"), "No release"));
    CHECK(contains(
        message(start + floorPart + "release { type cylinder; }"), "box"
    ));
    CHECK(contains(message("spacing -1;" + floorPart + blockPart), "spacing"));
    CHECK(contains(
        message(
            start + floorPart
            + "release { type box; corner (0 0 -3); edges ((1 0 0) (0 1 0)"
              " (0 0 0.5)); grains { solidFraction 0.6; } }"
        ),
        "holds no particle"
    ));
    CHECK(contains(
        message(
            start + blockPart
            + "ground { type polygon; points ((0 0 0) (1 1 0) (1 0 0)"
              " (0 1 0)); }"
        ),
        "crosses itself"
    ));
    CHECK(contains(
        message(
            start + blockPart + "ground { type surface; file \"none.stl\"; }"
        ),
        "There is no file"
    ));
    CHECK(contains(
        message(
            start + floorPart + "lattice { axes ((1 0 0) (1 1 0) (0 0 1)); }"
            + blockPart
        ),
        "right angles"
    ));
    CHECK(contains(
        message(
            start + floorPart
            + "release { type fill; box ((0 0 0) (1 1 1)); volume 2;"
              " surface level; grains { solidFraction 0.5; } }"
        ),
        "holds only"
    ));
}

TEST_CASE("polygons of any shape are cut into triangles", "[release]")
{
    const List<point> comb{
        point(0, 0, 0),
        point(4, 0, 0),
        point(4, 2, 0),
        point(3, 2, 0),
        point(3, 1, 0),
        point(2, 1, 0),
        point(1, 1, 0),
        point(1, 2, 0),
        point(0, 2, 0),
        point(0, 1, 0)};
    scalar area = 0;
    for (const corners& t : triangulate(comb))
    {
        CHECK(areaVector(t).z() > 0);
        area += 0.5 * areaVector(t).z();
    }
    CHECK(area == Approx(6));
    const List<point> bow{
        point(0, 0, 0), point(1, 1, 0), point(1, 0, 0), point(0, 2, 0)};
    CHECK(triangulate(bow).empty());
}


TEST_CASE("an even sheet keeps its volume", "[release]")
{
    // 1.9 spacings thick: neither one nor two layers
    const scene s(
        "spacing 1; origin (0 0 0);" + floorPart
        + "release { type raster; file \"thickness.asc\";"
          " grains { solidFraction 0.5; } }"
    );
    std::string text = "ncols 16\nnrows 16\nxllcenter -7.5\nyllcenter -7.5\n"
                       "cellsize 1\n";
    for (label k = 0; k < 256; ++k)
    {
        const bool rim = k < 16 || k >= 240 || k % 16 == 0 || k % 16 == 15;
        text += rim ? "0 " : "1.9 ";
    }
    s.raw("thickness.asc", text);
    const cloudState cloud = s.cloud();
    CHECK(cloud.size() == Approx(196 * 1.9).epsilon(0.01));
}

TEST_CASE("a release in the ground lowers it", "[release]")
{
    const scene s("spacing 1; origin (0 0 0);"
                  "ground { type raster; file \"dem.asc\"; zone floor; }"
                  "release { type raster; file \"depth.asc\"; scale -1;"
                  " position inGround; grains { solidFraction 0.5; } }");
    std::string dem = "ncols 20\nnrows 20\nxllcenter 0\nyllcenter 0\n"
                      "cellsize 2\n";
    std::string depth = dem;
    for (label k = 0; k < 400; ++k)
    {
        const label j = k / 20, i = k % 20;
        dem += "50 ";
        depth += i > 6 && i < 13 && j > 6 && j < 13 ? "-5 " : "0 ";
    }
    s.raw("dem.asc", dem);
    s.raw("depth.asc", depth);
    const cloudState cloud = s.cloud();
    CHECK(cloud.size() == Approx(36 * 4 * 5).epsilon(0.02));
    const autoPtr<ground> bed = ground::read(s.path());
    CHECK(bed->elevation(19, 19).nearest.z() == Approx(45));
    CHECK(bed->elevation(5, 5).nearest.z() == Approx(50));
    for (const vector& x : cloud.positions)
    {
        // a particle over the rim, where the body thins out
        REQUIRE(x.z() < 51);
    }
}


namespace
{

//- The parts in comments of the manual of terrainToParticlesDict
std::vector<std::string> manualExamples()
{
    std::ifstream is(
        getEnv("LPF_PROJECT_DIR")
        + "/etc/caseDicts/annotated/terrainToParticlesDict"
    );
    const std::string text(
        (std::istreambuf_iterator<char>(is)), std::istreambuf_iterator<char>()
    );
    std::vector<std::string> examples;
    for (auto at = text.find("/*"); at != std::string::npos;
         at = text.find("/*", at + 1))
    {
        examples.push_back(text.substr(at + 2, text.find("*/", at) - at - 2));
    }
    return examples;
}

} // namespace


TEST_CASE("the examples of the manual are read", "[release]")
{
    const auto examples = manualExamples();
    REQUIRE(examples.size() == 2);
    const temporaryFolder folder;
    mkDir(folder.path() / "constant" / "triSurface");
    mkDir(folder.path() / "constant" / "gisdata");
    std::ofstream(folder.path() / "constant/triSurface/building.obj")
        << "g wall\nv 0 0 0\nv 1000 0 0\nv 0 1000 0\nf 1 2 3\n";

    const quiet silence;
    IStringStream groundText(examples[0]);
    const dictionary grounds(groundText);
    groundPieces pieces = readGround(
        grounds.subDict("ground"), {folder.path(), boundBox(point::zero)}
    );
    CHECK(pieces.triangles.size() == 2 + 2 + 10 + 480 + 1);
    CHECK(pieces.zones.found("building"));
    CHECK(pieces.bounds().max().x() == Approx(9));

    const List<feature> areas{
        feature{
            {{point2D(0, 0), point2D(9, 0), point2D(9, 9), point2D(0, 9)}},
            {1}},
        feature{
            {{point2D(20, 0), point2D(29, 0), point2D(29, 9), point2D(20, 9)}},
            {2}}};
    writeFeatures(
        folder.path() / "constant/gisdata/release.gpkg",
        featureType::polygons,
        areas,
        {"id"},
        ""
    );
    IStringStream releaseText(examples[1]);
    const dictionary releases(releaseText);
    label n = 0;
    for (const entry& e : releases.subDict("release"))
    {
        const auto region =
            releaseRegion::New(e.dict(), {folder.path(), tensor::I});
        CHECK(region->plan().span().x() > 0);
        ++n;
    }
    CHECK(n == 6);
}
