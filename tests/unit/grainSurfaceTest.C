// SPDX-License-Identifier: GPL-3.0-or-later
// Where the free surface of grains is (T 6.20), so that drag does not take the
// kernel that it cuts for a thinner bed (T 6.21): blocks of a lattice with flat
// and inclined faces, edges and corners; clouds of grains that are spread out.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "grainDynamics.H"
#include "latticeSums.H"
#include "sampleGrains.H"
#include "sampleGround.H"
#include "sampleScene.H"

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx, rho0 = 1500;

//- No stress
class stressless : public granularRheology
{
public:
    stressless()
        : granularRheology(elasticity(dictOf("nu 0.3; E 1e6;"), {rho0, 10, 1}))
    {
    }
    rheologyLosses correct(const grainArrays&, double) const override
    {
        return {};
    }
    bool yields(const grainPoint&) const override { return true; }
    double storedEnergy(const grainPoint&) const override { return 0; }
};

sceneProperties openScene()
{
    sceneProperties scene = periodicScene(dx, h, 1, Zero);
    scene.cyclic.period = Zero;
    return scene;
}

//- Grains in water, after one evaluation of their rates
struct body
{
    sceneProperties scene = openScene();
    stressless stress;
    groundContact contact;
    grainDynamics grains;
    const lpfPairs::wendlandC2 W = lpfPairs::wendlandC2(h, 3);

    body(ground& bed, const std::vector<vector>& x)
        : contact(
            bed,
            dictOf("zones { floor { friction none; } }"),
            dx,
            4 * dx,
            0,
            vector(0, 1, 0)
        ),
          grains(
              lpfPairs::loadPairEngine("auto"), scene, {}, stress, contact, true
          )
    {
        grainStore& g = grains.grains;
        g.resize(int(x.size()));
        for (int i = 0; i < g.size(); ++i)
        {
            set(g.x, i, x[std::size_t(i)]);
            set(g.U, i, Zero);
            g.mass[i] = rho0 * dx * dx * dx;
            g.id[i] = i;
            g.rho[i] = g.rhoRef[i] = rho0;
        }
        grains.rates(1e-6, 0);
    }

    //- Share of its place that the bed fills, as the plain sum and by (T 6.21)
    double sum(int i) const
    {
        const grainStore& g = grains.grains;
        double total = 0;
        for (int j = 0; j < g.size(); ++j)
        {
            total += dx * dx * dx * W.value(magSqr(at(g.x, i) - at(g.x, j)));
        }
        return total;
    }
    double read(int i) const
    {
        return sum(i) / (1 - grains.groundShare(i) - grains.surfaceShare(i, h));
    }
};

//- Of the points of a lattice around the origin those within
template<class Inside>
std::vector<vector> block(const Inside& inside)
{
    constexpr int n = 8;
    std::vector<vector> x;
    for (int i = -n; i <= n; ++i)
    {
        for (int j = -n; j <= n; ++j)
        {
            for (int k = -n; k <= n; ++k)
            {
                const vector p(i * dx, j * dx, k * dx);
                if (inside(p))
                {
                    x.push_back(p);
                }
            }
        }
    }
    return x;
}

struct extremes
{
    double least = 1e30, most = -1e30, mean = 0;
    int count = 0;

    void take(double v)
    {
        least = min(least, v);
        most = max(most, v);
        mean = (mean * count + v) / (count + 1);
        ++count;
    }
};

//- What is read of grains that `where` chooses
template<class Where>
extremes readOf(const body& b, const Where& where)
{
    extremes e;
    for (int i = 0; i < b.grains.grains.size(); ++i)
    {
        if (where(at(b.grains.grains.x, i)))
        {
            e.take(b.read(i));
        }
    }
    return e;
}

} // namespace


TEST_CASE("surface of grains: flat and inclined, the bed is full")
{
    autoPtr<ground> bed = groundFarAway();
    const double full =
        lpfPairs::latticeFill(lpfPairs::wendlandC2(h, 3), dx, 3);
    for (const double slope : {0.0, 0.5, 1.0})
    {
        const vector n = vector(slope, 0, 1) / std::sqrt(1 + sqr(slope));
        const body b(
            *bed, block([&](const vector& x) { return mag(n & x) < 2.6 * dx; })
        );
        // out of sight of the sides of the block
        const extremes e = readOf(
            b,
            [&](const vector& x)
            { return mag(x.x()) < 2.5 * dx && mag(x.y()) < 0.5 * dx; }
        );
        INFO("slope " << slope << " " << e.least << " to " << e.most);
        CHECK(e.count > 20);
        CHECK(e.least > full - 0.03);
        CHECK(e.most < full + 0.04);
    }
}


TEST_CASE("surface of grains: edges, corners, other smoothing lengths")
{
    autoPtr<ground> bed = groundFarAway();
    const body b(
        *bed,
        block([](const vector& x) { return cmptMax(cmptMag(x)) < 3.5 * dx; })
    );
    const auto outer = [](double x) { return mag(x) > 2.5 * dx; };
    const extremes edge = readOf(
        b,
        [&](const vector& x)
        { return outer(x.x()) && outer(x.y()) && mag(x.z()) < 0.5 * dx; }
    );
    const extremes corner = readOf(
        b,
        [&](const vector& x)
        { return outer(x.x()) && outer(x.y()) && outer(x.z()); }
    );
    CHECK(edge.count == 4);
    CHECK(corner.count == 8);
    CHECK(edge.least == Approx(1).epsilon(0.06));
    CHECK(corner.least > 0.8);

    // a grain in the middle of a face, half a spacing deep: of kernels of h
    // and, away from it, of half of that
    const lpfPairs::surfaceShare plane(3);
    for (int i = 0; i < b.grains.grains.size(); ++i)
    {
        if (mag(at(b.grains.grains.x, i) - vector(0, 0, 3 * dx)) < 1e-9)
        {
            const double depth = 0.5 * dx;
            CHECK(
                b.grains.surfaceShare(i, h)
                == Approx(plane.atDepth(depth / h)).margin(0.02)
            );
            CHECK(
                b.grains.surfaceShare(i, h / 2)
                == Approx(plane.atDepth(2 * depth / h)).margin(0.02)
            );
        }
    }
}


TEST_CASE("surface of grains: layers on the ground")
{
    const double far = 5;
    autoPtr<ground> floor = groundOf(
        {{point(-far, -far, 0), point(far, -far, 0), point(far, far, 0)},
         {point(-far, -far, 0), point(far, far, 0), point(-far, far, 0)}}
    );
    for (int layers = 1; layers <= 4; ++layers)
    {
        std::vector<vector> x =
            block([&](const vector& p)
                  { return p.z() > -0.5 * dx && p.z() < (layers - 0.5) * dx; });
        for (vector& p : x)
        {
            p.z() += 0.5 * dx;
        }
        const body b(*floor, x);
        const extremes e = readOf(
            b, [](const vector& p) { return max(mag(p.x()), mag(p.y())) < dx; }
        );
        INFO(layers << " layers " << e.least << " to " << e.most);
        CHECK(e.least > 0.95);
        CHECK(e.most < 1.1);
    }
}


// The plain sum is larger than the true fraction, for each grain stands in its
// own share of it; the surface must not add to that
TEST_CASE("surface of grains: a cloud that is spread out stays so")
{
    autoPtr<ground> bed = groundFarAway();
    randomNumbers random(5);
    for (const double apart : {1.25, 1.6, 2.0})
    {
        const double spacing = apart * dx;
        const body b(
            *bed,
            jitteredLattice(random, Zero, {11, 11, 11}, spacing, 0.3 * spacing)
        );
        extremes sum, read;
        for (int i = 0; i < b.grains.grains.size(); ++i)
        {
            sum.take(b.sum(i));
            read.take(b.read(i));
        }
        INFO(
            "true " << std::pow(apart, -3) << " sum " << sum.mean << " read "
                    << read.mean << ", at most " << read.most
        );
        CHECK(read.mean < 1.05 * sum.mean);
        CHECK(read.most < 1.1 * sum.most);
    }
}
