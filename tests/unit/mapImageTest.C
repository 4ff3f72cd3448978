// SPDX-License-Identifier: GPL-3.0-or-later
// Pictures: round numbers at their axes, and files that are pictures.

#include <catch2/catch.hpp>

#include "axisTicks.H"
#include "mapImage.H"
#include "OSspecific.H"
#include "plotImage.H"

#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

//- Width and height of a PNG file, zero if it is none
std::pair<unsigned, unsigned> pngSize(const fileName& file)
{
    std::ifstream stream(file, std::ios::binary);
    unsigned char head[24] = {};
    stream.read(reinterpret_cast<char*>(head), 24);
    const std::string signature(reinterpret_cast<const char*>(head) + 1, 3);
    const auto number = [&](const int k)
    {
        return unsigned(head[k]) << 24 | unsigned(head[k + 1]) << 16
             | unsigned(head[k + 2]) << 8 | unsigned(head[k + 3]);
    };
    return signature == "PNG" ? std::make_pair(number(16), number(20))
                              : std::make_pair(0U, 0U);
}

} // namespace


TEST_CASE("axisTicks: steps are 1, 2 or 5 times a power of ten")
{
    REQUIRE(roundStep(10, 10) == Approx(1));
    REQUIRE(roundStep(3.53, 10) == Approx(0.5));
    REQUIRE(roundStep(25.3, 10) == Approx(5));
    REQUIRE(roundStep(4.2e-3, 6) == Approx(1e-3));
    REQUIRE(roundBelow(999) == Approx(500));
    REQUIRE(roundBelow(1000) == Approx(1000));

    const scalarField marks(ticks(-0.5, 3.1, 1));
    REQUIRE(marks == scalarField(scalarList({0.0, 1.0, 2.0, 3.0})));

    REQUIRE(tickLabel(1491000, 500) == "1491000");
    REQUIRE(tickLabel(0.05, 0.05) == "0.05");
    REQUIRE(tickLabel(2, 0.5) == "2.0");
    REQUIRE(threeDigits(4673219) == "4.67e+06");
    REQUIRE(threeDigits(46732) == "46700");
    REQUIRE(threeDigits(0.07692) == "0.0769");
}


TEST_CASE("mapImage: viridis gets lighter all the way")
{
    scalar last = -1;
    for (label k = 0; k <= 100; ++k)
    {
        const colour c = viridis(0.01 * scalar(k));
        const scalar light = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        CHECK(light > last);
        last = light;
    }
}

TEST_CASE("mapImage: blues get darker all the way")
{
    scalar last = 1;
    for (label k = 0; k <= 100; ++k)
    {
        const colour c = blues(0.01 * scalar(k));
        const scalar light = 0.2126 * c.r + 0.7152 * c.g + 0.0722 * c.b;
        CHECK(light < last);
        CHECK(c.b >= c.r);
        last = light;
    }
}


TEST_CASE("plotImage: vectors that are all zero, one far larger than others")
{
    const fileName folder = "plotImageTest." + Foam::name(pid());
    mkDir(folder);
    plotContent plot;
    plot.xTitle = "x [m]";
    plot.panels.resize(2);
    for (plotPanel& panel : plot.panels)
    {
        panel.isSection = true;
        panel.title = "section";
        panel.vectors.resize(1);
        panel.vectors[0].at = pointField(30, point(1000, 2000, 0));
        panel.vectors[0].vectors = vectorField(30, vector::zero);
    }
    plot.panels[1].vectors[0].at[29] = point(1010, 2005, 0);
    plot.panels[1].vectors[0].vectors = vector(1, 1, 5);
    plot.panels[1].vectors[0].vectors[29] = vector(1e6, 0, 0);
    writePlot(folder / "vectors.png", plot, 1500);
    CHECK(pngSize(folder / "vectors.png").first == 1500);
    CHECK(pngSize(folder / "vectors.png").second < 3000);
    rmDir(folder);
}


TEST_CASE("mapImage, plotImage: write pictures without a display")
{
    const fileName folder = "mapImageTest." + Foam::name(pid());
    mkDir(folder);

    mapContent map;
    map.nx = 60;
    map.ny = 40;
    map.x0 = 1.49e6;
    map.y0 = 5.2e6;
    map.dx = map.dy = 20;
    map.ground.resize(2400);
    map.value.resize(2400);
    forAll (map.ground, c)
    {
        map.ground[c] = 300 + 5 * scalar(c % 60);
        map.value[c] = max(0.0, 10 - mag(scalar(c % 60) - 30));
    }
    // A hole in the ground, one row without deposit: neither may stop it
    map.ground[100] = map.noGround;
    map.crs = "EPSG:2193";
    map.title = "test";
    map.caption = stringList({"one line", "another"});
    writeMap(folder / "map.png", map, 1200);
    CHECK(pngSize(folder / "map.png").first >= 900);
    CHECK(pngSize(folder / "map.png").second >= 600);

    // Each panel of a series is as high as the others
    mapLines path;
    path.name = "path";
    path.lines = List<pointField>(1, pointField(1, point(1.49e6, 5.2e6, 0)));
    map.lines.append(path);
    List<mapPanel> panels(1);
    panels[0] = {"t = 1 s", {{"grains", {}, {}, false}}};
    unsigned height[3];
    for (unsigned& h : height)
    {
        writeMapSeries(folder / "series.png", map, panels, 1200);
        CHECK(pngSize(folder / "series.png").first >= 1000);
        h = pngSize(folder / "series.png").second;
        panels.append(mapPanel(panels[0]));
    }
    CHECK(height[1] > height[0] + 500);
    CHECK(mag(int(height[2] - 2 * height[1] + height[0])) < 3);

    // Nothing deposited, ground level
    map.ground = 0;
    map.value = 0;
    writeMap(folder / "empty.png", map, 1200);
    CHECK(pngSize(folder / "empty.png").first >= 900);

    plotContent plot;
    plot.panels.resize(1);
    plot.panels[0].curves.resize(1);
    plot.panels[0].curves[0] = {
        "front",
        scalarField(scalarList({0.0, 1.0, 2.0})),
        scalarField(scalarList({-VGREAT, 0.5, 1.2}))};
    writePlot(folder / "curves.png", plot, 1500);
    CHECK(pngSize(folder / "curves.png").first == 1500);

    rmDir(folder);
}
