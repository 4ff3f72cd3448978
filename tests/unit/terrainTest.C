// SPDX-License-Identifier: GPL-3.0-or-later
// The ground against surfaces whose distance is known in closed form.

#include <catch2/catch.hpp>

#include "ground.H"
#include "heightField.H"
#include "sampleCase.H"
#include "triangles.H"

#include "mathematicalConstants.H"

#include <cmath>
#include <cstring>
#include <random>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

const scalar pi = constant::mathematical::pi;

//- Corners of a quadrilateral as two triangles
void addQuad(
    DynamicList<corners>& list,
    const point& a,
    const point& b,
    const point& c,
    const point& d
)
{
    list.append(corners{a, b, c});
    list.append(corners{a, c, d});
}

ground groundOf(const DynamicList<corners>& list)
{
    PtrList<groundPart> parts(1);
    parts.set(0, new triangles(list, labelList(list.size(), Zero)));
    return ground(std::move(parts), {"bed"}, point::zero, "");
}

//- Two long strips that meet along y at 0: the free angle (degrees) between
//  them, symmetric about z
ground wedge(const scalar freeAngle)
{
    const scalar half = 0.5 * freeAngle * pi / 180;
    const vector down(std::sin(half), 0, std::cos(half));
    const vector left(-down.x(), 0, down.z());
    const vector y(0, 50, 0);
    DynamicList<corners> list;
    addQuad(list, -y, 50 * down - y, 50 * down + y, y);
    addQuad(list, 50 * left - y, -y, y, 50 * left + y);
    return groundOf(list);
}

//- Signed distance of the same wedge; positive within the free angle
scalar wedgeDistance(const scalar freeAngle, const point& x)
{
    const scalar half = 0.5 * freeAngle * pi / 180;
    const scalar r = std::hypot(x.x(), x.z());
    const scalar angle = std::fabs(std::atan2(x.x(), x.z()));
    const scalar off = std::fabs(half - angle);
    const scalar distance = off < 0.5 * pi ? r * std::sin(off) : r;
    return angle < half ? distance : -distance;
}

ground heightsOf(
    const heightGrid& grid, const std::function<scalar(scalar, scalar)>& z
)
{
    scalarField heights(grid.nx * grid.ny);
    forAll (heights, v)
    {
        const label j = v / grid.nx, i = v - j * grid.nx;
        heights[v] = z(grid.x0 + i * grid.dx, grid.y0 + j * grid.dy);
    }
    PtrList<groundPart> parts(1);
    parts.set(0, new heightField(grid, std::move(heights), 0));
    return ground(std::move(parts), {"bed"}, point::zero, "");
}

class randomPoints
{
    std::mt19937 engine_{7};
    std::uniform_real_distribution<scalar> unit_{-1, 1};

public:
    point operator()(const scalar size)
    {
        return size * vector(unit_(engine_), unit_(engine_), unit_(engine_));
    }
};

scalar totalArea(const surfaceElements& elements)
{
    scalar sum = 0;
    for (const vector& nA : elements.nA)
    {
        sum += mag(nA);
    }
    return sum;
}

bool sameBits(const scalar a, const scalar b)
{
    return std::memcmp(&a, &b, sizeof(scalar)) == 0;
}

} // namespace


TEST_CASE("edges of any angle have the exact signed distance", "[terrain]")
{
    // convex edge, right angle outside and inside, V-gully, chute and plate
    const scalar angle = GENERATE(300., 270., 200., 160., 90., 60., 20.);
    const ground bed = wedge(angle);
    randomPoints next;
    for (label i = 0; i < 2000; ++i)
    {
        const point x = next(2);
        const groundHit hit = bed.signedDistance(x, 10);
        REQUIRE(hit.found);
        REQUIRE(hit.distance == Approx(wedgeDistance(angle, x)).margin(1e-9));
        REQUIRE(mag(hit.nearest - x) == Approx(mag(hit.distance)));
    }
}

TEST_CASE("corners of a block and of a tank have the right sign", "[terrain]")
{
    DynamicList<corners> list;
    const auto p = [](int x, int y, int z) { return point(x, y, z); };
    addQuad(list, p(0, 0, 1), p(1, 0, 1), p(1, 1, 1), p(0, 1, 1));
    addQuad(list, p(0, 0, 0), p(0, 1, 0), p(1, 1, 0), p(1, 0, 0));
    addQuad(list, p(0, 0, 0), p(1, 0, 0), p(1, 0, 1), p(0, 0, 1));
    addQuad(list, p(0, 1, 0), p(0, 1, 1), p(1, 1, 1), p(1, 1, 0));
    addQuad(list, p(0, 0, 0), p(0, 0, 1), p(0, 1, 1), p(0, 1, 0));
    addQuad(list, p(1, 0, 0), p(1, 1, 0), p(1, 1, 1), p(1, 0, 1));
    const bool inside = GENERATE(false, true);
    if (inside)
    {
        for (corners& t : list)
        {
            std::swap(t[1], t[2]);
        }
    }
    const ground bed = groundOf(list);
    randomPoints next;
    for (label i = 0; i < 5000; ++i)
    {
        const point x = next(1.5) + point(0.5, 0.5, 0.5);
        vector out = Zero;
        scalar deepest = GREAT;
        for (direction k = 0; k < 3; ++k)
        {
            out[k] = max(max(-x[k], x[k] - 1), scalar(0));
            deepest = min(deepest, min(mag(x[k]), mag(x[k] - 1)));
        }
        const scalar block = mag(out) > 0 ? mag(out) : -deepest;
        const groundHit hit = bed.signedDistance(x, 10);
        REQUIRE(hit.distance == Approx(inside ? -block : block).margin(1e-9));
    }
}

TEST_CASE("the radius ends the search", "[terrain]")
{
    const ground bed = wedge(180);
    CHECK(bed.signedDistance(point(0.3, 0, 0.99), 1).found);
    CHECK_FALSE(bed.signedDistance(point(0.3, 0, 1.01), 1).found);
    const heightGrid grid{5, 5, -2, -2, 1, 1};
    const ground field = heightsOf(grid, [](scalar, scalar) { return 0.; });
    CHECK(field.signedDistance(point(0.3, 0, 0.99), 1).found);
    CHECK_FALSE(field.signedDistance(point(0.3, 0, 1.01), 1).found);
}

TEST_CASE("a trough of an arc is as far as its radius", "[terrain]")
{
    constexpr label n = 360;
    constexpr scalar radius = 2;
    DynamicList<corners> list;
    const auto circle = [](const label k, const scalar y)
    {
        const scalar a = pi * (scalar(k) / n - 0.5);
        return point(radius * std::sin(a), y, -radius * std::cos(a));
    };
    for (label k = 0; k < n; ++k)
    {
        addQuad(
            list,
            circle(k, -1),
            circle(k + 1, -1),
            circle(k + 1, 1),
            circle(k, 1)
        );
    }
    const ground bed = groundOf(list);
    const scalar sag = radius * (1 - std::cos(pi / n / 2));
    randomPoints next;
    for (label i = 0; i < 1000; ++i)
    {
        point x = next(0.9);
        x.z() = -1 + 0.8 * x.z();
        const scalar expected = radius - std::hypot(x.x(), x.z());
        const scalar d = bed.signedDistance(x, 10).distance;
        CHECK(d <= expected + 1e-12);
        CHECK(d >= expected - sag - 1e-12);
    }
}

TEST_CASE("a plane at 30 degrees to the raster is exact", "[terrain]")
{
    // slope 25 degrees, falling towards 30 degrees from x
    const scalar slope = std::tan(25 * pi / 180);
    const scalar cx = std::cos(pi / 6), cy = std::sin(pi / 6);
    const heightGrid grid{41, 31, -20, -15, 1, 1};
    const ground bed = heightsOf(
        grid,
        [&](const scalar x, const scalar y)
        { return -slope * (cx * x + cy * y); }
    );
    const vector n =
        vector(slope * cx, slope * cy, 1) / std::sqrt(1 + slope * slope);
    randomPoints next;
    for (label i = 0; i < 2000; ++i)
    {
        const point x = next(8);
        const groundHit hit = bed.signedDistance(x, 30);
        REQUIRE(hit.found);
        CHECK(hit.distance == Approx(n & x).margin(1e-12));
        CHECK(mag(hit.normal - n) < 1e-12);
        const groundHit above = bed.elevation(x.x(), x.y());
        CHECK(
            above.nearest.z()
            == Approx(-slope * (cx * x.x() + cy * x.y())).margin(1e-12)
        );
    }
}

TEST_CASE("height field and its triangles are the same ground", "[terrain]")
{
    const heightGrid grid{25, 21, -6, -5, 0.5, 0.5};
    const ground field = heightsOf(
        grid,
        [](const scalar x, const scalar y)
        {
            // with a hole
            return mag(x - 2) < 0.6 && mag(y) < 0.6
                     ? heightField::hole()
                     : std::sin(x) * std::cos(1.3 * y) + 0.2 * x;
        }
    );
    pointField points;
    faceList faces;
    labelList zone;
    field.triangles(points, faces, zone);
    DynamicList<corners> list;
    for (const face& f : faces)
    {
        list.append(corners{points[f[0]], points[f[1]], points[f[2]]});
    }
    const ground soup = groundOf(list);
    CHECK(field.nTriangles() == soup.nTriangles());
    randomPoints next;
    label holes = 0;
    for (label i = 0; i < 4000; ++i)
    {
        const point x = next(8);
        const groundHit a = field.signedDistance(x, 3);
        const groundHit b = soup.signedDistance(x, 3);
        REQUIRE(a.found == b.found);
        if (a.found)
        {
            CHECK(a.distance == Approx(b.distance).margin(1e-12));
        }
        const groundHit up = field.elevation(x.x(), x.y());
        const groundHit down = soup.elevation(x.x(), x.y());
        REQUIRE(up.found == down.found);
        if (up.found)
        {
            CHECK(up.nearest.z() == Approx(down.nearest.z()).margin(1e-12));
        }
        else
        {
            ++holes;
        }
    }
    CHECK(holes > 0);
}

TEST_CASE("beyond an open border there is no ground", "[terrain]")
{
    const heightGrid grid{5, 5, 0, 0, 1, 1};
    const ground field = heightsOf(grid, [](scalar, scalar) { return 0.; });
    DynamicList<corners> list;
    addQuad(
        list, point(0, 0, 0), point(4, 0, 0), point(4, 4, 0), point(0, 4, 0)
    );
    const ground plate = groundOf(list);
    for (const ground* bed : {&field, &plate})
    {
        CHECK(bed->signedDistance(point(2, 2, -0.1), 1).distance < 0);
        CHECK_FALSE(bed->signedDistance(point(4.1, 2, -0.1), 1).found);
        CHECK_FALSE(bed->signedDistance(point(-0.1, -0.1, -0.1), 1).found);
        CHECK(bed->signedDistance(point(4.1, 2, 0.1), 1).distance > 0);
    }
}

TEST_CASE("parts that touch leave no open edge between them", "[terrain]")
{
    // a chute that ends in the middle of the longer edge of a plate
    DynamicList<corners> list;
    addQuad(
        list,
        point(-1, -0.25, 0.5),
        point(0, -0.25, 0),
        point(0, 0.25, 0),
        point(-1, 0.25, 0.5)
    );
    addQuad(
        list, point(0, -2, 0), point(3, -2, 0), point(3, 2, 0), point(0, 2, 0)
    );
    const ground bed = groundOf(list);
    const groundHit hit = bed.signedDistance(point(-1e-3, 0, -1e-2), 1);
    CHECK(hit.found);
    CHECK(hit.distance < 0);
}

TEST_CASE("elements add up to the area to the last bit", "[terrain]")
{
    // long and thin: a side wall
    DynamicList<corners> list;
    addQuad(
        list,
        point(0, 0, 0),
        point(3.5, 0, 0),
        point(3.5, 0, 0.5),
        point(0, 0, 0.5)
    );
    const ground wall = groundOf(list);
    constexpr scalar spacing = 0.02;
    const surfaceElements e = wall.elements(spacing);
    CHECK(totalArea(e) == Approx(3.5 * 0.5).epsilon(1e-13));
    vector sum = Zero;
    for (const vector& nA : e.nA)
    {
        sum += nA;
    }
    CHECK(mag(sum - vector(0, -1.75, 0)) < 1e-12);
    // no more of them than elements of a fair shape need
    const scalar mean = 1.75 / e.x.size();
    CHECK(mean > spacing * spacing / 8);
    CHECK(mean < spacing * spacing / 2);

    const heightGrid grid{9, 9, 0, 0, 1, 1};
    const ground field = heightsOf(
        grid, [](const scalar x, const scalar y) { return 0.3 * x - 0.2 * y; }
    );
    const scalar exact = 64 * std::sqrt(1 + 0.09 + 0.04);
    for (const scalar s : {5., 1., 0.3})
    {
        CHECK(totalArea(field.elements(s)) == Approx(exact).epsilon(1e-13));
    }
}

namespace
{

//- A floor that rises to the right from z = 0, from x = -before to 1
void addSlope(DynamicList<corners>& list, const scalar before)
{
    const auto at = [](const scalar x, const scalar y)
    { return point(x, y, 0.4 * x); };
    addQuad(list, at(-before, 0), at(1, 0), at(1, 1), at(-before, 1));
}

//- A wall at y = 0 that looks towards +y, from z = low
void addFrontWall(DynamicList<corners>& list, const scalar low)
{
    addQuad(
        list, point(0, 0, low), point(0, 0, 1), point(1, 0, 1), point(1, 0, low)
    );
}

constexpr scalar fine = 0.05, reach = 0.2;

label screensOf(const DynamicList<corners>& list)
{
    const ground all = groundOf(list);
    return all.screens(all.elements(fine), fine, reach).size();
}

} // namespace

TEST_CASE("what goes on behind a sheet is screened off by it", "[terrain]")
{
    DynamicList<corners> list;
    addSlope(list, 0);
    addFrontWall(list, -0.3);
    const ground all = groundOf(list);
    const surfaceElements e = all.elements(fine);
    const auto screens = all.screens(e, fine, reach);
    const vector n = vector(-0.4, 0, 1) / std::sqrt(1.16);

    std::vector<bool> screened(static_cast<std::size_t>(e.x.size()));
    for (const elementScreen& s : screens)
    {
        const scalar height = e.x[s.element] & n;
        screened[static_cast<std::size_t>(s.element)] = true;
        CHECK(height < -1e-12);
        CHECK(s.height == Approx(height).epsilon(1e-12));
        CHECK(mag(s.normal - n) < 1e-12);
    }
    label below = 0;
    forAll (e.x, q)
    {
        const scalar height = e.x[q] & n;
        if (height < -1e-12 && height > -0.7 * reach)
        {
            ++below;
            CHECK(screened[static_cast<std::size_t>(q)]);
        }
    }
    CHECK(below > 100);
}

TEST_CASE("a raster and a wall through it screen each other", "[terrain]")
{
    DynamicList<corners> wall;
    addFrontWall(wall, -0.3);
    PtrList<groundPart> parts(2);
    scalarField z(11 * 21);
    forAll (z, v)
    {
        z[v] = 0.04 * (v % 11);
    }
    parts.set(0, new heightField({11, 21, 0, -1, 0.1, 0.1}, std::move(z), 0));
    parts.set(1, new triangles(wall, labelList(wall.size(), Zero)));
    const ground all(std::move(parts), {"bed"}, point::zero, "");
    const surfaceElements e = all.elements(fine);
    label ofRaster = 0, ofWall = 0;
    for (const elementScreen& s : all.screens(e, fine, reach))
    {
        const point& x = e.x[s.element];
        const bool raster = s.element < e.ends[0];
        CHECK((raster ? x.y() < 0 : x.z() < 0.4 * x.x()));
        ++(raster ? ofRaster : ofWall);
    }
    CHECK(ofRaster > 100);
    CHECK(ofWall > 100);
}

TEST_CASE("sheets that join screen nothing off", "[terrain]")
{
    SECTION("a wall that stands on a floor")
    {
        DynamicList<corners> list;
        addSlope(list, 0);
        addQuad(
            list,
            point(0, 0, 0),
            point(0, 0, 1),
            point(1, 0, 1),
            point(1, 0, 0.4)
        );
        CHECK(screensOf(list) == 0);
    }
    SECTION("ridge and valley, blunt and sharp")
    {
        for (const scalar freeAngle : {30., 90., 170., 190., 270., 340.})
        {
            const scalar half = 0.5 * freeAngle * pi / 180;
            const vector down(std::sin(half), 0, std::cos(half));
            const vector left(-down.x(), 0, down.z()), y(0, 1, 0);
            DynamicList<corners> list;
            addQuad(list, -y, down - y, down + y, y);
            addQuad(list, left - y, -y, y, left + y);
            CHECK(screensOf(list) == 0);
        }
    }
    SECTION("a plate with two faces, one on the other")
    {
        DynamicList<corners> list;
        const point a(0, 0, 0), b(1, 0, 0), c(1, 1, 0), d(0, 1, 0);
        addQuad(list, a, b, c, d);
        addQuad(list, a, d, c, b);
        // and another through it
        const vector e(-1, 0.5, -1), f(2, 0.5, -1), up(0, 0, 2);
        addQuad(list, e, f, f + up, e + up);
        addQuad(list, e, e + up, f + up, f);
        CHECK(screensOf(list) == 0);
    }
}

TEST_CASE("a section of the ground is a line in pieces", "[terrain]")
{
    // a channel: a floor with a step down to the right, a wall across; corners
    // on the plane of the section, and a side wall along it
    DynamicList<corners> list;
    addQuad(
        list, point(0, -1, 1), point(2, -1, 1), point(2, 0, 1), point(0, 0, 1)
    );
    addQuad(
        list, point(0, 0, 1), point(2, 0, 1), point(2, 1, 1), point(0, 1, 1)
    );
    addQuad(
        list, point(2, -1, 1), point(5, -1, 0), point(5, 1, 0), point(2, 1, 1)
    );
    addQuad(
        list, point(5, 1, 0), point(5, -1, 0), point(5, -1, 2), point(5, 1, 2)
    );
    addQuad(
        list, point(0, -1, 0), point(0, -1, 2), point(5, -1, 2), point(5, -1, 0)
    );
    const ground channel = groundOf(list);
    const vector slope = vector(1, 0, 3) / std::sqrt(10.);
    constexpr scalar spacing = 0.3;
    for (const scalar y : {-0.5, 0., 0.7})
    {
        const surfaceElements e =
            channel.sections(spacing, {vector(0, 1, 0), y});
        scalar level = 0, down = 0, across = 0;
        forAll (e.x, q)
        {
            const scalar length = mag(e.nA[q]);
            const vector n = e.nA[q] / length;
            const point& x = e.x[q];
            CHECK(length <= spacing * (1 + 1e-9));
            CHECK(mag(x.y() - y) < 1e-12);
            CHECK(mag(n & e.along[q]) < 1e-12);
            const bool onLevel = mag(n - vector(0, 0, 1)) < 1e-12;
            const bool onSlope = mag(n - slope) < 1e-12;
            const bool onWall = mag(n - vector(-1, 0, 0)) < 1e-12;
            CHECK(onLevel + onSlope + onWall == 1);
            CHECK((!onLevel || mag(x.z() - 1) < 1e-12));
            CHECK((!onSlope || mag(x.x() + 3 * x.z() - 5) < 1e-12));
            CHECK((!onWall || mag(x.x() - 5) < 1e-12));
            (onLevel ? level : onSlope ? down : across) += length;
        }
        CHECK(level == Approx(2).epsilon(1e-12));
        CHECK(down == Approx(std::sqrt(10.)).epsilon(1e-12));
        CHECK(across == Approx(2).epsilon(1e-12));
    }

    const heightGrid grid{9, 9, 0, 0, 1, 1};
    const ground field = heightsOf(
        grid, [](const scalar x, const scalar y) { return 0.3 * x - 0.2 * y; }
    );
    const surfaceElements e = field.sections(spacing, {vector(0, 1, 0), 3});
    CHECK(totalArea(e) == Approx(8 * std::sqrt(1.09)).epsilon(1e-12));
}

TEST_CASE("boxes side by side share the elements", "[terrain]")
{
    const heightGrid grid{9, 9, 0, 0, 1, 1};
    const ground field = heightsOf(
        grid, [](const scalar x, const scalar y) { return std::sin(x * y); }
    );
    const surfaceElements all = field.elements(0.4);
    label n = 0;
    scalar area = 0;
    for (const scalar x : {-1., 1., 3., 5., 7.})
    {
        for (const scalar y : {-1., 1.5, 4., 6.5})
        {
            const surfaceElements part = field.elements(
                0.4, boundBox(point(x, y, -9), point(x + 2, y + 2.5, 9))
            );
            n += part.x.size();
            area += totalArea(part);
        }
    }
    CHECK(n == all.x.size());
    CHECK(area == Approx(totalArea(all)).epsilon(1e-12));
}

TEST_CASE("lengths times a power of two give the same bits", "[terrain]")
{
    const auto shape = [](const scalar scale)
    {
        return heightsOf(
            {25, 21, -6 * scale, -5 * scale, 0.5 * scale, 0.5 * scale},
            [scale](const scalar x, const scalar y) {
                return scale
                     * (std::sin(x / scale) * std::cos(1.3 * y / scale));
            }
        );
    };
    const scalar scale = GENERATE(1024., 1. / 1024);
    const ground one = shape(1), other = shape(scale);
    randomPoints next;
    for (label i = 0; i < 2000; ++i)
    {
        const point x = next(6);
        const groundHit a = one.signedDistance(x, 2);
        const groundHit b = other.signedDistance(scale * x, 2 * scale);
        REQUIRE(a.found == b.found);
        if (a.found)
        {
            REQUIRE(sameBits(scale * a.distance, b.distance));
            REQUIRE(sameBits(a.normal.x(), b.normal.x()));
        }
    }
    const surfaceElements e = one.elements(0.2),
                          f = other.elements(0.2 * scale);
    REQUIRE(e.x.size() == f.x.size());
    forAll (e.x, i)
    {
        REQUIRE(sameBits(scale * e.x[i].z(), f.x[i].z()));
    }
}

TEST_CASE("the ground is read back as it was written", "[terrain]")
{
    const temporaryFolder folder;
    PtrList<groundPart> parts(2);
    scalarField z(12);
    forAll (z, v)
    {
        z[v] = std::sqrt(scalar(v)) / 3;
    }
    z[7] = heightField::hole();
    parts.set(
        0, new heightField({4, 3, 0.1, 0.2, 1. / 3, 0.7}, std::move(z), 0)
    );
    const List<corners> list{
        corners{point(0.1, 0, 0), point(1. / 3, 0, 0.7), point(0, 1, 0.3)},
        corners{point(0.1, 0, 0), point(0, 1, 0.3), point(-1, 0.2, 0.3)}};
    parts.set(1, new triangles(list, labelList{1, 2}));
    const string wkt(std::string(3000, 'x') + "\"quoted\"");
    const ground one(
        std::move(parts),
        {"terrain", "wall", "gate"},
        point(1489200.1, 5201200.3, 1. / 3),
        wkt
    );
    one.write(folder.path());
    const autoPtr<ground> other = ground::read(folder.path());
    CHECK(other->zones() == one.zones());
    CHECK(other->crs() == one.crs());
    for (direction k = 0; k < 3; ++k)
    {
        CHECK(sameBits(other->origin()[k], one.origin()[k]));
    }
    randomPoints next;
    for (label i = 0; i < 500; ++i)
    {
        const point x = next(1);
        const groundHit a = one.signedDistance(x, 5);
        const groundHit b = other->signedDistance(x, 5);
        REQUIRE(a.found == b.found);
        CHECK(sameBits(a.distance, b.distance));
        CHECK(a.zone == b.zone);
    }
}

TEST_CASE("a zone that is removed is not found", "[terrain]")
{
    PtrList<groundPart> parts(1);
    const List<corners> list{
        corners{point(0, 0, 0), point(1, 0, 0), point(0, 1, 0)},
        corners{point(0, 0, 1), point(1, 0, 1), point(0, 1, 1)}};
    parts.set(0, new triangles(list, labelList{0, 1}));
    ground bed(std::move(parts), {"floor", "gate"}, point::zero, "");
    const point x(0.2, 0.2, 0.9);
    CHECK(bed.signedDistance(x, 5).zone == 1);
    bed.removeZone("gate");
    CHECK(bed.signedDistance(x, 5).zone == 0);
    CHECK(bed.elements(0.1).zone.found(1) == false);
}
