// SPDX-License-Identifier: GPL-3.0-or-later
// Deposit maps on bodies whose volume, thickness and outline are known.

#include <catch2/catch.hpp>

#include "bulkColumns.H"
#include "columnSample.H"
#include "contours.H"
#include "depositionControls.H"
#include "depositionFields.H"
#include "heightField.H"
#include "overlapScore.H"
#include "runoutPath.H"
#include "sampleCase.H"

#include "IStringStream.H"
#include "mathematicalConstants.H"

#include <cmath>
#include <fstream>
#include <random>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

const scalar pi = constant::mathematical::pi;

//- Plane z = -slope x for |x|, |y| < 100
ground inclined(const scalar slope)
{
    const heightGrid grid{3, 3, -100, -100, 100, 100};
    scalarField z(9);
    forAll (z, v)
    {
        z[v] = -slope * (-100 + 100 * scalar(v % 3));
    }
    PtrList<groundPart> parts(1);
    parts.set(0, new heightField(grid, std::move(z), 0));
    return ground(std::move(parts), {"bed"}, point::zero, "");
}

//- Particles of one volume, at rest unless U is set after
cloudSample particles(const vectorField& x, const scalar volume, const scalar h)
{
    const label n = x.size();
    return cloudSample{
        x,
        vectorField(n, vector::zero),
        scalarField(n, 1500 * volume),
        scalarField(n, volume),
        scalarField(n, h)};
}

//- Lattice of spacing dx from 0 to (lx, ly), layers upwards from the plane
cloudSample
slab(const scalar dx, const scalar lx, const scalar ly, const label layers)
{
    DynamicList<point> x;
    for (scalar a = 0.5 * dx; a < lx; a += dx)
    {
        for (scalar b = 0.5 * dx; b < ly; b += dx)
        {
            for (label k = 0; k < layers; ++k)
            {
                x.append(point(a, b, (scalar(k) + 0.5) * dx));
            }
        }
    }
    return particles(vectorField(x), pow3(dx), 1.3 * dx);
}

planGrid cells(
    const scalar x0,
    const scalar y0,
    const scalar side,
    const label nx,
    const label ny
)
{
    planGrid grid;
    grid.x0 = x0;
    grid.y0 = y0;
    grid.dx = grid.dy = side;
    grid.nx = nx;
    grid.ny = ny;
    return grid;
}

//- Ground at z = 0 below all cells
groundOnGrid level(const planGrid& grid)
{
    return {
        scalarField(grid.size(), scalar(0)),
        scalarField(grid.size(), scalar(1))};
}

raster asRaster(const planGrid& grid, const scalarField& values)
{
    raster r;
    r.nx = grid.nx;
    r.ny = grid.ny;
    r.dx = grid.dx;
    r.dy = grid.dy;
    r.x0 = grid.x0 + 0.5 * grid.dx;
    r.y0 = grid.y0 + 0.5 * grid.dy;
    r.values = values;
    r.missing.resize(values.size(), false);
    return r;
}

} // namespace


TEST_CASE("deposition: cells hold the volume of the particles to round-off")
{
    std::mt19937 random(7);
    std::uniform_real_distribution<double> unit(0, 1);
    const label n = 500;
    vectorField x(n);
    cloudSample sample = particles(x, 1, 1);
    for (label i = 0; i < n; ++i)
    {
        sample.x[i] = point(40 * unit(random), 25 * unit(random), unit(random));
        sample.volume[i] = 0.1 + unit(random);
        sample.h[i] = 1 + unit(random);
    }
    const scalarField heights(sample.x.component(vector::Z)());

    // Finer than the particles, as fine, and far coarser
    for (const scalar side : {0.3, 1.0, 7.0})
    {
        const label nx = label(std::ceil(50 / side));
        const label ny = label(std::ceil(35 / side));
        const planGrid grid = cells(-5, -5, side, nx, ny);
        const columnSample now =
            sampleColumns(grid, level(grid), sample, heights, 0);
        const scalar held = sum(now.thicknessVertical) * grid.cellArea();

        REQUIRE(mag(held / sum(sample.volume) - 1) < 1e-12);
        REQUIRE(mag(now.volumeOutside) < 1e-12 * held);
    }

    // A grid that cuts through the body: what it misses is counted
    const planGrid part = cells(10, 3, 1, 12, 9);
    const columnSample now =
        sampleColumns(part, level(part), sample, heights, 0);
    const scalar held = sum(now.thicknessVertical) * part.cellArea();

    REQUIRE(held == Approx(now.volumeInside).epsilon(1e-12));
    REQUIRE(
        now.volumeInside + now.volumeOutside
        == Approx(sum(sample.volume)).epsilon(1e-12)
    );
    // The share of a uniform body in the window: 12 x 9 of 40 x 25; with 108
    // expected of 1000 parts the draw scatters by 10 %
    REQUIRE(
        now.volumeInside / sum(sample.volume) == Approx(0.108).epsilon(0.3)
    );
}


TEST_CASE("deposition: thickness and depth of a level slab are its height")
{
    const scalar dx = 0.02;
    const label layers = GENERATE(1, 5, 20);
    const cloudSample sample = slab(dx, 1, 0.6, layers);
    const scalarField heights(heightsAbove(inclined(0), sample.x));

    // Cells that do not fit the lattice
    const planGrid grid = cells(-0.2, -0.2, 0.037, 38, 27);
    const columnSample now =
        sampleColumns(grid, level(grid), sample, heights, 0.5 * dx);
    const scalar height = scalar(layers) * dx;
    for (label j = 0; j < grid.ny; ++j)
    {
        for (label i = 0; i < grid.nx; ++i)
        {
            const point c = grid.centre(i, j);
            const label k = grid.index(i, j);
            // 2h and half a cell from the edge the slab is endless. What is
            // left is the ripple of the lattice under the kernel
            const scalar inside =
                min(min(c.x(), 1 - c.x()), min(c.y(), 0.6 - c.y()));
            if (inside > 2.6 * dx + 0.5 * 0.037)
            {
                CHECK(now.thicknessVertical[k] == Approx(height).epsilon(0.01));
                CHECK(now.depth[k] == Approx(height).epsilon(0.005));
            }
            if (inside < -2.6 * dx - 0.5 * 0.037)
            {
                CHECK(now.thicknessVertical[k] == 0);
                CHECK(now.depth[k] == 0);
            }
        }
    }
}


TEST_CASE("deposition: nothing is smeared through the wall of a flume")
{
    // Ground from y = 0 to 0.6 only; the slab fills it
    const scalar dx = 0.02;
    const cloudSample sample = slab(dx, 1, 0.6, 8);
    const planGrid grid = cells(-0.2, -0.2, dx, 70, 50);
    groundOnGrid bed = level(grid);
    forAll (bed.elevation, c)
    {
        const scalar y = grid.centre(c % grid.nx, c / grid.nx).y();
        bed.elevation[c] = y > 0 && y < 0.6 ? 0 : noValue;
    }
    const scalarField heights(sample.x.component(vector::Z)());
    const columnSample now =
        sampleColumns(grid, bed, sample, heights, 0.5 * dx);

    REQUIRE(
        sum(now.thicknessVertical) * grid.cellArea()
        == Approx(sum(sample.volume)).epsilon(1e-12)
    );
    for (label j = 0; j < grid.ny; ++j)
    {
        const label k = grid.index(35, j);
        if (hasValue(bed.elevation[k]))
        {
            // Even up to the wall; a kernel just cut there is 7 % off in the
            // first row of cells, one that goes through it loses half
            CHECK(now.thicknessVertical[k] == Approx(8 * dx).epsilon(0.02));
        }
        else
        {
            CHECK(now.thicknessVertical[k] == 0);
        }
    }
}


TEST_CASE("deposition: grains above a flow do not lift its depth")
{
    const scalar dx = 0.1;
    cloudSample sample = slab(dx, 3, 3, 10);
    // One grain in the air, 2 m above a flow of 1 m
    sample.x.append(point(1.5, 1.5, 3));
    sample.U.append(vector::zero);
    // by value: append would read its argument after it has moved the list
    sample.mass.append(scalar(sample.mass[0]));
    sample.volume.append(scalar(sample.volume[0]));
    sample.h.append(scalar(sample.h[0]));
    const scalarField heights(sample.x.component(vector::Z)());

    const planGrid grid = cells(1.4, 1.4, 0.2, 1, 1);
    const columnSample now =
        sampleColumns(grid, level(grid), sample, heights, 0.05);

    REQUIRE(now.depth[0] == Approx(1).epsilon(0.05));
}


TEST_CASE("deposition: normal thickness on a slope of 30 degrees")
{
    const scalar dx = 0.05, angle = pi / 6;
    const label layers = 8;
    const ground bed = inclined(std::tan(angle));
    // Layers parallel to the slope, laid along it
    cloudSample sample = slab(dx, 3, 2, layers);
    for (point& x : sample.x)
    {
        const scalar along = x.x(), up = x.z();
        x.x() = along * std::cos(angle) + up * std::sin(angle);
        x.z() = -along * std::sin(angle) + up * std::cos(angle);
    }
    const planGrid grid = cells(1, 0.7, dx, 12, 12);
    const columnSample now = sampleColumns(
        grid, level(grid), sample, heightsAbove(bed, sample.x), 0.5 * dx
    );
    depositionFields fields(grid.size());
    fields.add(0, now, sampleGround(bed, grid), 0.5 * dx);

    const scalar normal = scalar(layers) * dx;
    const scalar vertical = normal / std::cos(angle);
    for (label c = 0; c < grid.size(); ++c)
    {
        CHECK(fields.thicknessVertical[c] == Approx(vertical).epsilon(0.01));
        CHECK(fields.thicknessNormal[c] == Approx(normal).epsilon(0.01));
        // The header promises half a particle
        CHECK(mag(fields.depth[c] - vertical) < 0.5 * dx);
    }
}


TEST_CASE("deposition: plane strain keeps thickness as volume per plan area")
{
    const scalar dx = 0.02, thick = 0.1;
    DynamicList<point> x;
    for (scalar a = 0.5 * dx; a < 2; a += dx)
    {
        for (label k = 0; k < 6; ++k)
        {
            x.append(point(a, 0, (scalar(k) + 0.5) * dx));
        }
    }
    const cloudSample sample =
        particles(vectorField(x), dx * dx * thick, 1.3 * dx);
    planGrid grid = cells(-0.1, 0, dx, 110, 1);
    grid.flat = 1;
    grid.dy = thick;
    grid.y0 = -0.5 * thick;
    const scalarField heights(sample.x.component(vector::Z)());
    const columnSample now =
        sampleColumns(grid, level(grid), sample, heights, 0.5 * dx);

    REQUIRE(
        sum(now.thicknessVertical) * grid.cellArea()
        == Approx(sum(sample.volume)).epsilon(1e-12)
    );
    const label middle = grid.index(55, 0);
    REQUIRE(now.thicknessVertical[middle] == Approx(6 * dx).epsilon(0.005));
    REQUIRE(now.depth[middle] == Approx(6 * dx).epsilon(0.005));
}


TEST_CASE("deposition: maxima, arrival and missing ground over three times")
{
    groundOnGrid bed{scalarField(2, scalar(0)), scalarField(2, scalar(1))};
    bed.elevation[1] = noValue;
    bed.cosSlope[1] = noValue;
    depositionFields fields(2);
    const scalar thickness[3] = {0, 2, 1}, speed[3] = {0, 3, 0.5};
    for (label k = 0; k < 3; ++k)
    {
        const columnSample now{
            scalarField(2, thickness[k]),
            scalarField(2, thickness[k]),
            scalarField(2, speed[k]),
            scalarField(2, 2 * speed[k]),
            0,
            0};
        fields.add(10.0 * scalar(k), now, bed, 0.5);
    }
    REQUIRE(fields.thicknessVertical[0] == 1);
    REQUIRE(fields.maxThicknessVertical[0] == 2);
    REQUIRE(fields.maxDepth[0] == 2);
    REQUIRE(fields.maxSpeed[0] == 3);
    REQUIRE(fields.maxParticleSpeed[0] == 6);
    REQUIRE(fields.arrivalTime[0] == 10);

    REQUIRE(fields.maxThicknessVertical[1] == 2);
    REQUIRE_FALSE(hasValue(fields.thicknessNormal[1]));
    REQUIRE_FALSE(hasValue(fields.maxDepth[1]));
    REQUIRE(fields.arrivalTime[1] == 10);
}


TEST_CASE("deposition: speed of the depth average and of the particles")
{
    const scalar dx = 0.1;
    cloudSample sample = slab(dx, 2, 2, 4);
    forAll (sample.x, i)
    {
        // 1 m/s at the bottom layer, 4 m/s at the top
        sample.U[i] = vector(std::round(sample.x[i].z() / dx + 0.5), 0, 0);
    }
    const planGrid grid = cells(0.9, 0.9, 0.2, 1, 1);
    const scalarField heights(sample.x.component(vector::Z)());
    const columnSample now =
        sampleColumns(grid, level(grid), sample, heights, 0.05);

    REQUIRE(now.meanSpeed[0] == Approx(2.5).epsilon(1e-12));
    REQUIRE(now.maxSpeed[0] == 4);
}


TEST_CASE("runoutPath: lengths in plan and along the surface")
{
    const scalar angle = pi / 6;
    const ground bed = inclined(std::tan(angle));
    const pathLine line{
        "centre",
        pointField({point(0, 0, 0), point(30, 0, 0), point(30, 20, 0)}),
        pathLength::surface,
        0.7};
    const runoutPath surface(line, bed, dictionary::null);
    pathLine level(line);
    level.length = pathLength::plan;
    const runoutPath plan(level, bed, dictionary::null);

    // Down the slope 30/cos, then along the contour line 20
    REQUIRE(plan.endDistance() == Approx(50));
    REQUIRE(surface.endDistance() == Approx(30 / std::cos(angle) + 20));
    REQUIRE(surface.planAt(surface.distance(17)) == Approx(17));

    // Beside the line: its nearest point; beyond its ends: straight on
    REQUIRE(plan.distance(plan.project(point(12, 3, 0))) == Approx(12));
    REQUIRE(plan.distance(plan.project(point(34, 8, 0))) == Approx(38));
    REQUIRE(plan.distance(plan.project(point(30, 23, 0))) == Approx(53));
    REQUIRE(plan.distance(plan.project(point(-2, 0, 0))) == Approx(-2));
    REQUIRE(
        surface.distance(surface.project(point(-2, 0, 0)))
        == Approx(-2 / std::cos(angle))
    );
}


TEST_CASE("runoutPath: front is the furthest point above half a spacing")
{
    const scalar dx = 0.5, h = 1.3 * dx;
    const ground bed = inclined(0);
    const cloudSample sample = slab(dx, 20, 6, 4);
    const planGrid grid = cells(-3, -3, dx, 60, 24);
    const scalarField heights(sample.x.component(vector::Z)());
    const columnSample now =
        sampleColumns(grid, level(grid), sample, heights, 0.5 * dx);
    const pathLine line{
        "centre",
        pointField({point(1, 3, 0), point(25, 3, 0)}),
        pathLength::plan,
        dx};
    const runoutPath path(line, bed, dictionary::null);
    const scalar front = path.front(grid, now.thicknessVertical, 0.5 * dx) + 1;

    // The edge at 20 is smeared over 2h and the averaging of a cell. An eighth
    // of the height 4 dx is passed beyond the edge, never 2h + dx beyond it
    REQUIRE(front > 20);
    REQUIRE(front < 20 + 2 * h + dx);
    // Where thickness is just half a spacing, on the same interpolation
    REQUIRE(
        interpolate(grid, now.thicknessVertical, front, 3)
        == Approx(0.5 * dx).epsilon(0.02)
    );
    // A limit that half the height passes: the edge itself
    REQUIRE(
        path.front(grid, now.thicknessVertical, 2 * dx) + 1
        == Approx(20).margin(0.1 * dx)
    );
    REQUIRE_FALSE(hasValue(path.front(grid, now.thicknessVertical, 100)));

    // Mass along 0 to 20 is uniform; the path starts at 1
    const scalarField fronts(path.massFronts(
        sample.x, sample.mass, scalarField(scalarList({0.95, 0.99}))
    ));
    REQUIRE(fronts[0] == Approx(18).margin(0.5 * dx));
    REQUIRE(fronts[1] == Approx(18.8).margin(0.5 * dx));
}


TEST_CASE("overlapScore: CSI counts each kind of cell once")
{
    const boolList simulated({true, true, true, false, false});
    const boolList observed({true, true, false, true, false});
    const overlapScore score = compare(simulated, observed);

    REQUIRE(score.truePositive == 2);
    REQUIRE(score.falsePositive == 1);
    REQUIRE(score.falseNegative == 1);
    REQUIRE(score.csi() == 0.5);
    REQUIRE(compare(observed, observed).csi() == 1);
    REQUIRE(compare(boolList(3, false), boolList(3, false)).csi() == 0);
}


TEST_CASE("deposition: outline of a cone")
{
    // Columns of the volume of the cone of height H and radius R above them
    const scalar dx = 1, H = 6, R = 20, h = 1.3 * dx;
    DynamicList<point> x;
    DynamicList<scalar> volume;
    for (scalar a = -R + 0.5 * dx; a < R; a += dx)
    {
        for (scalar b = -R + 0.5 * dx; b < R; b += dx)
        {
            const scalar height = H * (1 - std::hypot(a, b) / R);
            if (height > 0)
            {
                x.append(point(a, b, 0.5 * height));
                volume.append(height * dx * dx);
            }
        }
    }
    cloudSample sample = particles(vectorField(x), 1, h);
    sample.volume = scalarField(volume);
    const scalarField heights(sample.x.component(vector::Z)());

    // Cells that do not fit the lattice, far from any symmetry
    const planGrid grid = cells(-26.3, -25.1, 0.9, 58, 57);
    const columnSample now =
        sampleColumns(grid, level(grid), sample, heights, 0.5);
    const raster map = asRaster(grid, now.thicknessVertical);

    // Columns at cell centres against the integral: H/R of a cell at the rim
    REQUIRE(now.volumeInside == Approx(pi * R * R * H / 3).epsilon(2e-3));
    for (const scalar level : {2.0, 3.0})
    {
        const polygonSet outline = areasAbove(map, level);
        const scalar r = R * (1 - level / H);
        // Smoothing a cone shifts its lines inwards by <r2>/(4 r), <r2> =
        // 0.556 h2 of the kernel and dx2/6 of the averaging over a cell;
        // chords of a circle lie inside it by at most dx2/(8 r)
        const scalar shift =
            (0.556 * h * h + 0.9 * 0.9 / 6) / (4 * r) + 0.9 * 0.9 / (8 * r);

        REQUIRE(outline.polygons.size() == 1);
        REQUIRE(outline.nHoles() == 0);
        REQUIRE(outline.area() < pi * r * r * 1.002);
        REQUIRE(outline.area() > pi * sqr(r - shift) * 0.998);
    }
}


TEST_CASE("contours: holes, nothing, everything, missing cells")
{
    const planGrid grid = cells(1000, 5000, 2, 40, 40);
    scalarField ring(grid.size());
    for (label j = 0; j < grid.ny; ++j)
    {
        for (label i = 0; i < grid.nx; ++i)
        {
            const point c = grid.centre(i, j) - point(1040, 5040, 0);
            ring[grid.index(i, j)] = 10 - mag(std::hypot(c.x(), c.y()) - 20);
        }
    }
    raster map = asRaster(grid, ring);
    const polygonSet annulus = areasAbove(map, 0.0);

    // From radius 10 to 30; chords and the linear interpolation of a distance
    // are off by dx2/(8 r) each
    REQUIRE(annulus.polygons.size() == 1);
    REQUIRE(annulus.nHoles() == 1);
    REQUIRE(annulus.area() == Approx(pi * (900 - 100)).epsilon(0.01));
    REQUIRE(annulus.polygons[0].contains(point2D(1060, 5040)));
    REQUIRE_FALSE(annulus.polygons[0].contains(point2D(1040, 5040)));

    REQUIRE(areasAbove(map, 1000).polygons.empty());
    // Everything: to the edge of the raster
    REQUIRE(areasAbove(map, -1000).area() == Approx(80 * 80));

    // Missing cells belong to no area
    for (label j = 0; j < grid.ny; ++j)
    {
        for (label i = 0; i < grid.nx / 2; ++i)
        {
            map.missing[map.index(i, j)] = true;
        }
    }
    REQUIRE(areasAbove(map, 0).area() == Approx(pi * 400).epsilon(0.05));
}


TEST_CASE("depositionControls: defaults, and a wrong word is an error")
{
    const releaseScales scales{0.02, 0.026, -1, 0};
    IStringStream good("outline { above 0.005; }"
                       "paths { flume { points ((0 0) (3 0));"
                       " pathLength surface; } }");
    const dictionary dict(good);
    const depositionControls controls =
        readDepositionControls(dict, scales, "flume");

    REQUIRE(controls.cellSize == 0.02);
    REQUIRE(controls.outlineAbove == 0.005);
    REQUIRE(controls.title == "flume");
    REQUIRE(controls.paths.size() == 1);
    REQUIRE(controls.paths[0].points[1] == point(3, 0, 0));

    const planGrid grid = sampleGrid(
        dict,
        controls,
        scales,
        boundBox(point(0, -0.25, 0), point(3, 0.25, 1)),
        point::zero
    );
    // Room: a twentieth of the 3 m along x, 2h + cell = 0.072 along y; lines
    // at multiples of the cell
    REQUIRE(grid.x0 == Approx(-0.16));
    REQUIRE(grid.x0 + scalar(grid.nx) * grid.dx >= 3.15);
    REQUIRE(grid.y0 == Approx(-0.34));

    const bool before = FatalIOError.throwExceptions();
    for (const char* wrong :
         {"cellsize 1;",
          "cellSize -1;",
          "outline { above 0; }",
          "extent ((0 0) (-1 5));",
          "paths { a { points ((0 0) (1 1)); } }",
          "paths { a { pathLength plan; } }",
          "map { width 10; }"})
    {
        IStringStream stream(wrong);
        const dictionary bad(stream);
        CHECK_THROWS(readDepositionControls(bad, scales, "flume"));
    }
    FatalIOError.throwExceptions(before);
}


namespace
{

//- Grains of 2500 kg/m3, 0.6 of the bulk, 1 x 1 x 0.5 m, and water in them
struct wetBed
{
    static constexpr scalar dx = 0.05, present = 0.5 * dx;
    planGrid grid = cells(-0.5, -0.5, 0.05, 40, 40);
    cloudSample grains = slab(dx, 1, 1, 10), water;

    //- water: layers of the lattice, in the pores as far as there are grains
    wetBed(const label layers, const scalar saturation)
        : water(slab(dx, 1, 1, layers))
    {
        grains.mass = 2500 * 0.6 * grains.volume;
        water.space = water.volume;
        forAll (water.x, i)
        {
            water.volume[i] *= water.x[i].z() < 0.5 ? 0.4 * saturation : 1;
        }
        water.mass = 1000 * water.volume;
    }

    columnSample columns(const cloudSample& sample) const
    {
        const scalarField heights(sample.x.component(vector::Z)());
        return sampleColumns(grid, level(grid), sample, heights, 0);
    }

    columnSample bulk() const
    {
        const columnSample g = columns(grains), w = columns(water);
        return bulkColumns(
            grid, {g, 2500, present}, {w, 1000, present}, present
        );
    }

    label middle() const { return grid.index(20, 20); }
};

} // namespace


TEST_CASE("deposition: water in the pores takes no room")
{
    // partly full, full, 0.1 m of water on top
    const label k = GENERATE(0, 1, 2);
    const label layers[] = {10, 10, 12};
    const scalar S[] = {0.5, 1, 1};
    const wetBed bed(layers[k], S[k]);
    const columnSample grains = bed.columns(bed.grains), bulk = bed.bulk();
    const scalar height = scalar(layers[k]) * wetBed::dx;
    const label c = bed.middle();
    CHECK(bulk.thicknessVertical[c] == Approx(height).epsilon(0.01));
    CHECK(bulk.depth[c] == Approx(height).epsilon(0.03));
    CHECK(bulk.volumeInside == Approx(height).epsilon(1e-9));
    CHECK(sum(bulk.mass) == Approx(750 + sum(bed.water.mass)).epsilon(1e-12));
    if (k == 0)
    {
        CHECK(
            max(mag(bulk.thicknessVertical - grains.thicknessVertical)) < 1e-12
        );
    }
    const columnSample water = bed.columns(bed.water);
    CHECK(
        water.thicknessVertical[c]
        == Approx(0.2 * S[k] + height - 0.5).epsilon(0.01)
    );
    // by the space that the particles take, not by the volume of their water
    CHECK(water.depth[c] == Approx(height).epsilon(0.03));
}

TEST_CASE("deposition: where one phase is alone, the bulk is that phase")
{
    wetBed bed(10, 1);
    bed.water.x = bed.water.x + vector(0, 0, 0);
    for (point& x : bed.water.x)
    {
        x.x() += 5;
    }
    bed.grid = cells(-0.5, -0.5, 0.05, 140, 40);
    const columnSample grains = bed.columns(bed.grains);
    const columnSample water = bed.columns(bed.water), bulk = bed.bulk();
    forAll (bulk.depth, c)
    {
        const bool left = bed.grid.centre(c % 140, c / 140).x() < 3;
        const columnSample& alone = left ? grains : water;
        REQUIRE(
            mag(bulk.thicknessVertical[c] - alone.thicknessVertical[c]) < 1e-12
        );
        if (bulk.thicknessVertical[c] > wetBed::present)
        {
            REQUIRE(bulk.depth[c] == alone.depth[c]);
        }
    }
}

TEST_CASE("deposition: the speed of the bulk is that of its momentum")
{
    wetBed bed(10, 1);
    bed.grains.U = vector(1, 0, 0);
    bed.water.U = vector(3, 0, 0);
    const columnSample bulk = bed.bulk();
    // 1500 kg/m3 of grains, 400 of water
    CHECK(
        bulk.meanSpeed[bed.middle()]
        == Approx((1500 * 1 + 400 * 3) / 1900.0).epsilon(1e-9)
    );
    CHECK(bulk.maxSpeed[bed.middle()] == 3);
    const cloudTotals all = totals(joined(bed.grains, bed.water));
    CHECK(all.mass == Approx(950));
    CHECK(all.meanSpeed == Approx((750 * 1 + 200 * 3) / 950.0));
}

TEST_CASE("deposition: volume of water is its mass over its density")
{
    cloudState state;
    state.positions = vectorField(2, vector::zero);
    state.vectors.set("U", vectorField(state.size(), vector::zero));
    state.scalars.set("mass", scalarField(2, 2.0));
    state.scalars.set("alpha", scalarField(2, 0.4));
    state.scalars.set("rho", scalarField(2, 1010.0)); // compressed a little
    const releaseScales scales{0.2, 0.26, -1, 0, 0.1, 0.13};
    const cloudSample water =
        sampleOf(state, "water", 1000, scales.of("water"));
    CHECK(water.volume[0] == Approx(0.002));
    CHECK(water.taken()[0] == Approx(0.005));
    CHECK(water.h[0] == 0.13);
    const cloudSample grains = sampleOf(state, "grains", 2500, scales);
    CHECK(grains.volume[0] == Approx(2 / 1010.0));
    CHECK(grains.h[0] == 0.26);
    state.scalars.erase("alpha");
    CHECK(
        errorOf([&] { sampleOf(state, "water", 1000, scales); }
        ).find("has no field alpha")
        != std::string::npos
    );
}

TEST_CASE("deposition: water has lengths of its own")
{
    const temporaryFolder folder;
    mkDir(folder.path() / "constant");
    const auto read = [&](const std::string& text)
    {
        std::ofstream(folder.path() / "constant" / "releaseProperties")
            << "FoamFile { version 2.0; format ascii; class dictionary; object"
               " releaseProperties; }\nspacing 0.2; smoothingLength 0.26; "
            << text << '\n';
        return readReleaseScales(folder.path());
    };
    const releaseScales alone = read("");
    CHECK(alone.of("water").spacing == 0.2);
    CHECK(alone.of("water").smoothingLength == 0.26);
    const releaseScales both =
        read("waterSpacing 0.1; waterSmoothingLength 0.13;");
    CHECK(both.of("water").spacing == 0.1);
    CHECK(both.of("water").smoothingLength == 0.13);
    CHECK(both.of("grains").spacing == 0.2);
    CHECK(both.of("bulk").spacing == 0.2);
}

TEST_CASE("a sample needs the velocity of the particles", "[deposition]")
{
    cloudState state = sampleCloud(8);
    state.scalars.set("mass", scalarField(8, 1));
    state.scalars.set("rho", scalarField(8, 1500));
    state.vectors.set("U", vectorField(8, vector(3, 0, 0)));
    const releaseScales scales{0.1, 0.13, -1, 0};
    CHECK(
        totals(sampleOf(state, "grains", 2500, scales)).meanSpeed == Approx(3)
    );
    state.vectors.erase("U");
    const std::string error =
        errorOf([&] { sampleOf(state, "grains", 2500, scales); });
    CHECK(error.find("has no field U") != std::string::npos);
}
