// SPDX-License-Identifier: GPL-3.0-or-later
// Water of terrainToParticles: how much there is, where it stands, its
// pressure, and what the grains in it feel.

#include <catch2/catch.hpp>

#include "releaseCase.H"

#include <cmath>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

const std::string start = "spacing 0.1; origin (0 0 0);" + floorPart;

//- 1 m x 1 m, 0.5 m high, 0.3 m3 of solid and 0.2 m3 of pores
std::string bed(const std::string& water)
{
    return "release { type box; corner (0 0 0); edges ((1 0 0) (0 1 0)"
           " (0 0 0.5)); grains { solidFraction 0.6; } water { "
         + water + " } }";
}

scalar highest(const cloudState& cloud, const vector& n)
{
    scalar most = -GREAT;
    for (const vector& x : cloud.positions)
    {
        most = max(most, n & x);
    }
    return most;
}

//- Compare each particle's pressure with rho g times its depth below a level
void checkHydrostatic(const cloudState& water, const scalar level)
{
    const scalarField& p = water.scalars["p"];
    forAll (p, i)
    {
        const scalar depth = level - water.positions[i].z();
        REQUIRE(p[i] == Approx(1000 * 10 * depth).epsilon(1e-9));
    }
}

} // namespace


TEST_CASE("the measures of water in a bed are four", "[release][water]")
{
    // 100 kg each way
    const std::string measure = GENERATE(
        std::string("saturation 0.5;"),
        std::string("trueFraction 0.25;"),
        std::string("dryBulkFraction 0.2;"),
        std::string("mass 100;")
    );
    const scene s(start + bed(measure), "grains water");
    const cloudState water = s.cloud("water");
    const cloudState dry = scene(start + blockPart).cloud();
    const cloudState grains = readCloud(s.path() / "0", "grains");
    REQUIRE(water.size() == 500);
    CHECK(sum(water.scalars["mass"]) == Approx(100).epsilon(1e-12));
    forAll (water.positions, i)
    {
        REQUIRE(water.positions[i] == grains.positions[i]);
        REQUIRE(water.scalars["S"][i] == Approx(0.5));
        REQUIRE(water.scalars["alpha"][i] == Approx(0.2));
        REQUIRE(water.scalars["p"][i] == 0);
        REQUIRE(water.labels["id"][i] == i);
        // partly filled pores leave the grains as they are
        REQUIRE(grains.symmTensors["sigma"][i] == dry.symmTensors["sigma"][i]);
    }
    const dictionary made = s.properties();
    CHECK(made.get<wordList>("phases") == wordList({"grains", "water"}));
    CHECK(made.get<scalar>("waterSpacing") == Approx(0.1));
    CHECK(made.get<scalar>("waterSmoothingLength") == Approx(0.13));
    CHECK(made.subDict("water").get<label>("count") == 500);
    CHECK(made.subDict("water").get<scalar>("mass") == Approx(100));
    CHECK(made.subDict("water").get<scalar>("volume") == Approx(0.1));
    CHECK(made.subDict("grains").get<scalar>("volume") == Approx(0.5));
}

TEST_CASE("grains under water weigh less by its density", "[release][water]")
{
    const scene s(start + bed("saturation 1;"), "grains water");
    const cloudState water = s.cloud("water");
    const cloudState grains = readCloud(s.path() / "0", "grains");
    CHECK(sum(water.scalars["mass"]) == Approx(200).epsilon(1e-12));
    checkHydrostatic(water, 0.5);
    forAll (grains.positions, i)
    {
        // total stress of 1500 + 400 kg/m3 less the pressure of the pores
        const scalar depth = 0.5 - grains.positions[i].z();
        REQUIRE(grains.symmTensors["sigma"][i].zz() == Approx(-9000 * depth));
        REQUIRE(water.scalars["alpha"][i] == Approx(0.4));
        REQUIRE(water.scalars["S"][i] == 1);
    }
}

TEST_CASE("water beyond the pores stands on top or nowhere", "[release][water]")
{
    const scene refused(start + bed("trueFraction 0.5;"), "grains water");
    const std::string text = refused.error();
    CHECK(refused.isUntouched());
    // 0.3 m3 of water, 0.2 m3 of pores
    CHECK(contains(text, "a saturation of 1.5"));
    CHECK(contains(text, "a true fraction of 0.5"));
    CHECK(contains(text, "The excess is 0.1 m3 or 100 kg"));
    CHECK(contains(text, "onTop"));

    const scene s(
        start + bed("trueFraction 0.5; excess onTop;"), "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(water.size() == 600);
    CHECK(sum(water.scalars["mass"]) == Approx(300).epsilon(1e-12));
    CHECK(highest(water, vector(0, 0, 1)) == Approx(0.55));
    checkHydrostatic(water, 0.6);
    scalar inPores = 0;
    forAll (water.positions, i)
    {
        const bool onTop = water.positions[i].z() > 0.5;
        REQUIRE(water.scalars["alpha"][i] == Approx(onTop ? 1 : 0.4));
        inPores += onTop ? 0 : water.scalars["mass"][i];
    }
    CHECK(inPores == Approx(200).epsilon(1e-12));
    CHECK(s.properties().get<scalar>("releaseHeight") == Approx(0.6));
    const cloudState grains = readCloud(s.path() / "0", "grains");
    const scalar depth = 0.5 - grains.positions[0].z();
    CHECK(grains.symmTensors["sigma"][0].zz() == Approx(-9000 * depth));
}

TEST_CASE("a second release of water stands on the bed", "[release][water]")
{
    const scene s(
        start
            + "release { bed { type box; corner (0 0 0); edges ((1 0 0) (0 1 0)"
              " (0 0 0.5)); grains { solidFraction 0.6; } water { saturation 1;"
              " } } lake { type box; corner (0 0 0.5); edges ((1 0 0) (0 1 0)"
              " (0 0 0.3)); water { } } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(water.size() == 800);
    checkHydrostatic(water, 0.8);
    CHECK(sum(water.scalars["mass"]) == Approx(500).epsilon(1e-12));
    CHECK(water.labels["zone"][0] == 0);
    CHECK(water.labels["zone"][799] == 1);
    CHECK(s.properties().get<scalar>("releaseHeight") == Approx(0.8));
}

TEST_CASE("free water gives way to a bed in it", "[release][water]")
{
    const scene s(
        start
            + "release { lake { type tank; box ((-0.5 -0.5 0) (1.5 1.5 2));"
              " level 0.8; water { } } bed { type box; corner (0 0 0);"
              " edges ((1 0 0) (0 1 0) (0 0 0.5)); grains { solidFraction 0.6;"
              " } water { saturation 1; } } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(water.size() == 20 * 20 * 8);
    // 4 m2 x 0.8 m less 0.3 m3 of solid
    CHECK(sum(water.scalars["mass"]) == Approx(2900).epsilon(1e-9));
    checkHydrostatic(water, 0.8);
    // the bed is the second release, and its water
    for (label i = 0; i < water.size(); ++i)
    {
        const point& x = water.positions[i];
        const bool inBed =
            x.x() > 0 && x.x() < 1 && x.y() > 0 && x.y() < 1 && x.z() < 0.5;
        REQUIRE(water.labels["zone"][i] == (inBed ? 1 : 0));
        REQUIRE(water.scalars["alpha"][i] == Approx(inBed ? 0.4 : 1));
    }
}

TEST_CASE("a dam break is water alone", "[release][water]")
{
    const scene s(
        start
            + "release { type box; corner (0 0 0); edges ((1 0 0) (0 1 0)"
              " (0 0 0.5)); water { mass 501; } velocity (1 0 0); }",
        "water"
    );
    const cloudState water = s.cloud("water");
    CHECK(water.size() == 500);
    CHECK(sum(water.scalars["mass"]) == Approx(501).epsilon(1e-12));
    CHECK(water.vectors["U"][7] == vector(1, 0, 0));
    CHECK(water.scalars["h"][7] == Approx(0.13));
    checkHydrostatic(water, 0.5);
    CHECK(!isDir(s.path() / "0" / "lagrangian" / "grains"));
    CHECK(!s.properties().found("grains"));
    CHECK(s.properties().get<wordList>("phases") == wordList({"water"}));
    CHECK(s.properties().get<scalar>("spacing") == Approx(0.1));
    CHECK(s.properties().get<scalar>("releaseHeight") == Approx(0.5));
}

TEST_CASE("water fills its box to a ceiling", "[release][water]")
{
    // the height of the ceiling is no whole number of halves, quarters, ..
    const std::string plate =
        "ground { floor { type polygon; points ((-1 -1 0) (2 -1 0) (2 2 0)"
        " (-1 2 0)); } ceiling { type polygon; points ((-1 -1 0.1) (-1 2 0.1)"
        " (2 2 0.1) (2 -1 0.1)); } }";
    const scalar layers = GENERATE(10, 20, 30, 40);
    const scalar spacing = 0.1 / layers;
    const std::string edge = Foam::name(4 * spacing);
    const scene s(
        "spacing " + Foam::name(spacing) + "; origin (0 0 0);" + plate
            + "release { type box; corner (0 0 0); edges ((" + edge
            + " 0 0) (0 " + edge + " 0) (0 0 0.1)); water {} }",
        "water"
    );
    CHECK(s.cloud("water").size() == 16 * layers);
}

TEST_CASE("water has a lattice of its own", "[release][water]")
{
    const scalar ratio = GENERATE(1, 1.3, 2);
    const scene s(
        "water { spacingRatio " + Foam::name(ratio) + "; }" + start
            + bed("saturation 1;"),
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(readCloud(s.path() / "0", "grains").size() == 500);
    CHECK(sum(water.scalars["mass"]) == Approx(200).epsilon(1e-12));
    CHECK(water.size() == Approx(500 * ratio * ratio * ratio).epsilon(0.08));
    CHECK(water.scalars["h"][0] == Approx(0.13 / ratio));
    CHECK(s.properties().get<scalar>("waterSpacing") == Approx(0.1 / ratio));
    checkHydrostatic(water, 0.5);
    CHECK(water.positions[0].z() == Approx(0.05 / ratio));
}

TEST_CASE("the spacing ratio is one for all water", "[release][water]")
{
    const std::string two =
        "release { bed { type box; corner (0 0 0); edges ((1 0 0) (0 1 0)"
        " (0 0 0.5)); grains { solidFraction 0.6; } water { saturation 1;"
        " spacingRatio 2; } } lake { type box; corner (0 0 0.5); edges ((1 0 0)"
        " (0 1 0) (0 0 0.3)); water { ";
    CHECK(
        scene(start + two + "} } }", "grains water").cloud("water").size()
        == 8 * 800
    );
    const scene s(start + two + "spacingRatio 1; } } }", "grains water");
    CHECK(contains(s.error(), "all water of a case has one spacing"));
}

TEST_CASE("on a slope the pressure is that below the level", "[release][water]")
{
    // a box, inclined with its lattice: the level is that of the fill
    const scene s(
        "spacing 0.02; origin (0 0 0);"
        "lattice { axes ((0.8 0 -0.6) (0 1 0) (0.6 0 0.8)); }"
        "ground { type plane; point (0 0 0); normal (0.6 0 0.8);"
        " direction (0.8 0 -0.6); size (20 20); zone floor; }"
        "release { type fill; box ((0 0 0) (1.4 0.5 0.7)); volume 0.1;"
        " surface level; grains { solidFraction 0.5; } water { dryBulkFraction"
        " 0.6; excess onTop; } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    // 0.05 m3 in the pores, 0.01 m3 on top
    CHECK(sum(water.scalars["mass"]) == Approx(60).epsilon(1e-12));
    const scalar level = water.positions[0].z() + water.scalars["p"][0] / 1e4;
    CHECK(level == Approx(highest(water, vector(0, 0, 1))).margin(0.01));
    checkHydrostatic(water, level);
    scalar free = 0;
    label nFree = 0;
    forAll (water.positions, i)
    {
        const bool onTop = water.scalars["alpha"][i] > 0.9;
        free += onTop ? water.scalars["mass"][i] : 0;
        nFree += onTop;
    }
    CHECK(free == Approx(10).epsilon(1e-9));
    CHECK(nFree * 8e-6 == Approx(0.01).epsilon(0.15));
}

TEST_CASE("level water stands on an inclined surface", "[release][water]")
{
    // bed parallel to a slope of 3 in 4, in a box that is closed below
    const scene s(
        "spacing 0.02; origin (0 0 0);"
        "lattice { axes ((0.8 0 -0.6) (0 1 0) (0.6 0 0.8)); }"
        "ground { type plane; point (0 0 0); normal (0.6 0 0.8);"
        " direction (0.8 0 -0.6); size (20 20); zone floor; }"
        "release { type fill; box ((0 0 0) (1.12 0.5 0.16)); volume 0.1;"
        " surface parallel; grains { solidFraction 0.5; } water { mass 80;"
        " excess onTop; } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(sum(water.scalars["mass"]) == Approx(80).epsilon(1e-12));
    scalar level = -GREAT;
    label nFree = 0;
    forAll (water.positions, i)
    {
        const scalar head = water.scalars["p"][i] / 1e4;
        if (water.scalars["alpha"][i] > 0.9)
        {
            ++nFree;
            level = nFree > 1 ? level : water.positions[i].z() + head;
            REQUIRE(water.positions[i].z() + head == Approx(level));
        }
    }
    CHECK(nFree * 8e-6 == Approx(0.03).epsilon(0.1));
    // the bed, 0.25 m thick: beneath the water the pressure goes on, where
    // the bed emerges it is that of seepage
    const vector n(0.6, 0, 0.8);
    label nUnder = 0, nBeside = 0;
    forAll (water.positions, i)
    {
        const point& x = water.positions[i];
        const scalar depth = 0.25 - (n & x);
        const scalar top = x.z() + 0.8 * depth;
        const scalar p = water.scalars["p"][i];
        if (depth > 0 && top < level - 0.01)
        {
            ++nUnder;
            REQUIRE(p == Approx(1e4 * (level - x.z())));
        }
        else if (depth > 0 && top > level)
        {
            ++nBeside;
            REQUIRE(p == Approx(8e3 * depth));
        }
    }
    CHECK(nUnder > 1000);
    CHECK(nBeside > 1000);
}

TEST_CASE(
    "a tank is filled on by what its bed does not hold", "[release][water]"
)
{
    const scene s(
        "spacing 0.05; origin (0 0 0);"
        "ground { floor { type polygon; points ((0 0 0) (1 0 0.5) (1 1 0.5)"
        " (0 1 0)); } walls { type box; zone floor; min (0 0 0); max (1 1 2);"
        " side inside; omit (zMin zMax); } }"
        "release { type tank; box ((-1 -1 -1) (3 3 3)); level 1;"
        " grains { solidFraction 0.5; } water { mass 575; excess onTop; } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(sum(water.scalars["mass"]) == Approx(575).epsilon(1e-12));
    // pores of 0.375 m3 below z = 1, 0.2 m3 over 1 m2 above
    const scalar level = water.positions[0].z() + water.scalars["p"][0] / 1e4;
    CHECK(level == Approx(1.2).epsilon(2e-3));
    checkHydrostatic(water, level);
}

TEST_CASE("a dry bed in a lake stays dry", "[release][water]")
{
    const scene s(
        start
            + "release { lake { type tank; box ((-0.5 -0.5 0) (1.5 1.5 2));"
              " level 0.8; water { } } bed { type box; corner (0 0 0);"
              " edges ((1 0 0) (0 1 0) (0 0 0.5)); grains { solidFraction 0.6;"
              " } } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(water.size() == 20 * 20 * 8 - 500);
    CHECK(sum(water.scalars["mass"]) == Approx(2700).epsilon(1e-9));
    const cloudState grains = readCloud(s.path() / "0", "grains");
    const scalar depth = 0.5 - grains.positions[0].z();
    CHECK(grains.symmTensors["sigma"][0].zz() == Approx(-15000 * depth));
}

TEST_CASE("memory of a run counts both phases", "[release][water]")
{
    const auto bytes = [](const label grains, const label water) {
        return estimateRun({grains, water, 0.13, 0.5, 20, 1}).memory;
    };
    // 2h is more than a tenth of the thickness: all are near the ground
    CHECK(bytes(0, 1000) == 1000 * (340 + 350));
    CHECK(bytes(1000, 0) == 1000 * (888 + 350));
    // more than each alone, but the records are the same memory
    const scalar alone = bytes(1000, 0) + bytes(0, 500);
    CHECK(bytes(1000, 500) == alone + 1000 * 240 + 500 * 112);
}

TEST_CASE("along a slope the pressure is that of seepage", "[release][water]")
{
    const scene s(
        "spacing 0.1; origin (0 0 0);"
        "lattice { axes ((0.8 0 -0.6) (0 1 0) (0.6 0 0.8)); }"
        "ground { type plane; point (0 0 0); normal (0.6 0 0.8);"
        " direction (0.8 0 -0.6); size (20 20); zone floor; }"
        "release { type box; corner (0 0 0); edges ((0.8 0 -0.6) (0 1 0)"
        " (0.3 0 0.4)); grains { solidFraction 0.6; } water { saturation 1; }"
        " }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    const cloudState grains = readCloud(s.path() / "0", "grains");
    const vector n(0.6, 0, 0.8);
    forAll (water.positions, i)
    {
        const scalar depth = 0.5 - (n & water.positions[i]);
        REQUIRE(water.scalars["p"][i] == Approx(1000 * 8 * depth));
        const symmTensor& sigma = grains.symmTensors["sigma"][i];
        REQUIRE((n & (sigma & n)) == Approx(-900 * 8 * depth));
    }
}

TEST_CASE("water on an inclined box is level", "[release][water]")
{
    const scene s(
        "spacing 0.05; origin (0 0 0);"
        "lattice { axes ((0.8 0 -0.6) (0 1 0) (0.6 0 0.8)); }"
        "ground { type plane; point (0 0 0); normal (0.6 0 0.8);"
        " direction (0.8 0 -0.6); size (20 20); zone floor; }"
        "release { type box; corner (0 0 0); edges ((0.8 0 -0.6) (0 1 0)"
        " (0.3 0 0.4)); grains { solidFraction 0.6; } water { mass 450;"
        " excess onTop; } }",
        "grains water"
    );
    const cloudState water = s.cloud("water");
    CHECK(sum(water.scalars["mass"]) == Approx(450).epsilon(1e-12));
    // 0.25 m3 over a plan of 0.8 x 1 m whose height falls by 0.6 m: the wedge
    // over the lower end holds 0.24 m3, 0.0125 m over the upper edge
    const scalar level = 0.4 + 0.01 / 0.8;
    label n = 0;
    forAll (water.positions, i)
    {
        if (water.scalars["alpha"][i] > 0.9)
        {
            ++n;
            const scalar depth = level - water.positions[i].z();
            REQUIRE(water.scalars["p"][i] == Approx(1e4 * depth).epsilon(1e-3));
        }
    }
    CHECK(n * 1.25e-4 == Approx(0.25).epsilon(0.05));
}

TEST_CASE("water in plane strain is one layer", "[release][water]")
{
    const scene s(
        start
            + "release { type box; corner (0 -1 0); edges ((1 0 0) (0 2 0)"
              " (0 0 0.5)); grains { solidFraction 0.6; } water { trueFraction"
              " 0.5; excess onTop; spacingRatio 2; } }",
        "grains water"
    );
    s.write(
        "constant/boundaryProperties",
        "planeStrain { normal (0 1 0); thickness 0.25; }"
    );
    const cloudState water = s.cloud("water");
    CHECK(water.size() == 20 * 12);
    CHECK(sum(water.scalars["mass"]) == Approx(75).epsilon(1e-12));
    checkHydrostatic(water, 0.6);
    for (const vector& x : water.positions)
    {
        REQUIRE(x.y() == 0);
    }
}

TEST_CASE("water on a sheet of grains is refused", "[release][water]")
{
    const std::string sheet =
        "spacing 1; ground { type polygon; zone floor; points ((-50 -50 0)"
        " (50 -50 0) (50 50 0) (-50 50 0)); }"
        "release { type polygon; file \"area.geojson\"; thickness vertical 5;"
        " grains { solidFraction 0.5; } water { ";
    const auto message = [](const scene& s)
    {
        s.raw(
            "area.geojson",
            R"({"type":"Feature","properties":{},"crs":{"type":"name",)"
            R"("properties":{"name":"EPSG:2193"}},"geometry":{"type":)"
            R"("Polygon","coordinates":[[[0,0],[20,0],[20,20],[0,20],)"
            R"([0,0]]]}})"
        );
        return s.error();
    };
    const scene over(
        sheet + "dryBulkFraction 0.6; excess onTop; } }", "grains water"
    );
    CHECK(contains(message(over), "type polygon has no walls"));
    CHECK(over.isUntouched());
    const scene full(sheet + "saturation 1; } }", "grains water");
    CHECK(message(full) == "");
    const cloudState water = readCloud(full.path() / "0", "water");
    CHECK(sum(water.scalars["mass"]) == Approx(1e6).epsilon(1e-12));
    checkHydrostatic(water, 5);
}

TEST_CASE("phases and releases agree", "[release][water]")
{
    const auto message =
        [](const std::string& release, const std::string& phases)
    {
        const scene s(start + release, phases);
        const std::string text = s.error();
        CHECK(s.isUntouched());
        return text;
    };
    const std::string pond = "release { type box; corner (0 0 0); edges"
                             " ((1 0 0) (0 1 0) (0 0 0.5)); water {} }";
    CHECK(contains(message(pond, "grains"), "does not list water"));
    CHECK(contains(message(blockPart, "water"), "does not list grains"));
    CHECK(contains(message(pond, "grains water"), "lists grains, but no"));
    CHECK(contains(message(blockPart, "grains water"), "lists water, but no"));
    CHECK(contains(message(blockPart, "grain"), "phases names what moves"));
    CHECK(contains(message(blockPart, "grains air"), "phases names what"));
    CHECK(contains(
        message(
            "release { type box; corner (0 0 0); edges ((1 0 0) (0 1 0)"
            " (0 0 0.5)); }",
            "grains"
        ),
        "neither grains nor water"
    ));
}

TEST_CASE("what water must not say", "[release][water]")
{
    const auto message =
        [](const std::string& release, const std::string& phases)
    {
        const scene s(start + release, phases);
        const std::string text = s.error();
        CHECK(s.isUntouched());
        return text;
    };
    const auto inBed = [&](const std::string& water)
    { return message(bed(water), "grains water"); };
    const auto alone = [&](const std::string& water)
    {
        return message(
            "release { type box; corner (0 0 0); edges ((1 0 0) (0 1 0)"
            " (0 0 0.5)); water { "
                + water + " } }",
            "water"
        );
    };
    const std::string none = inBed("");
    CHECK(contains(none, "is missing. Write exactly one of"));
    // 0.3 of 0.2, 3/7 of 0.3, 0.3 of 0.5 m3
    CHECK(contains(none, "60 kg, 128.571 kg and 150 kg"));
    CHECK(contains(
        inBed("saturation 1; mass 200;"), "said 2 times: saturation mass"
    ));
    CHECK(contains(inBed("saturation 0;"), "greater than 0"));
    CHECK(contains(inBed("trueFraction 1;"), "less than 1"));
    CHECK(contains(inBed("satuation 1;"), "do you mean 'saturation'"));
    CHECK(contains(inBed("mass 300; excess ontop;"), "Valid choices"));
    CHECK(contains(inBed("saturation 1; spacingRatio 9;"), "at most 4"));
    CHECK(contains(alone("saturation 1;"), "This release has no grains"));
    CHECK(contains(alone("excess onTop;"), "This release has no grains"));
    CHECK(contains(alone("spacingRatio 2;"), "has only one of them"));
    CHECK(contains(alone("mass -1;"), "greater than 0"));
    CHECK(contains(
        message(
            "release { type box; corner (0 0 0.5); edges ((1 0 0) (0 1 0)"
            " (0 0 -0.5)); grains { solidFraction 0.6; } water { mass 250;"
            " excess onTop; } }",
            "grains water"
        ),
        "does not look upwards"
    ));
    CHECK(contains(
        message(
            "release { type fill; box ((0 0 0) (1 1 0.55)); volume 0.5;"
            " surface level; grains { solidFraction 0.6; } water { mass 270;"
            " excess onTop; } }",
            "grains water"
        ),
        "Above the bed there is room for 0.05 m3 within the box, the excess is"
        " 0.07 m3"
    ));
    // less than half a spacing on top
    CHECK(contains(
        inBed("mass 230; excess onTop;"), "Water of release release has no"
    ));
}
