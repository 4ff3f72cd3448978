// SPDX-License-Identifier: GPL-3.0-or-later
// Grains whose density follows how they are packed (T 3.17), and that are moved
// to where there is room (T 3.18), where they shear: against direct sums;
// nothing at rest; momentum and energy.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "grainDynamics.H"
#include "sampleGrains.H"
#include "sampleGround.H"
#include "sampleScene.H"
#include "wendlandC2.H"

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx, rho0 = 1500, pressure = 1e3;
constexpr int cells = 8;
constexpr double period = cells * dx;

//- Keeps the stress and shows the velocity gradient, by id
class sameStress : public granularRheology
{
public:
    const grainStore* grains = nullptr;
    mutable std::vector<tensor> L;

    sameStress()
        : granularRheology(elasticity(dictOf("nu 0.3; E 1e6;"), {rho0, 10, 1}))
    {
    }

    rheologyLosses correct(const grainArrays& a, double) const override
    {
        L.resize(static_cast<std::size_t>(a.n));
        for (int i = 0; i < a.n; ++i)
        {
            tensor& t = L[static_cast<std::size_t>(grains->id[i])];
            for (direction c = 0; c < 9; ++c)
            {
                t[c] = a.L[c][i];
            }
        }
        return {};
    }

    bool yields(const grainPoint&) const override { return true; }

    double storedEnergy(const grainPoint& at) const override
    {
        return at.mass * sqr(at.rho / rho0 - 1);
    }
};

//- A periodic box of grains under a pressure that shears along x
struct grainBox
{
    sceneProperties scene = periodicScene(dx, h, period, vector(0, 0, -9.81));
    autoPtr<ground> bed = groundFarAway();
    groundContact contact;
    sameStress stress;
    std::unique_ptr<grainDynamics> body;

    grainBox(double jitter, double speed, scalar relaxation, scalar shifting)
        : contact(
            *bed,
            dictOf("zones { floor { friction none; } }"),
            dx,
            4 * dx,
            0,
            vector(0, 1, 0)
        )
    {
        schemeProperties scheme;
        scheme.densityRelaxation = relaxation;
        scheme.shifting = shifting;
        body.reset(new grainDynamics(
            lpfPairs::loadPairEngine("auto"), scene, scheme, stress, contact
        ));
        stress.grains = &body->grains;
        randomNumbers random(7);
        const std::vector<vector> x =
            jitteredLattice(random, Zero, {cells, cells, cells}, dx, jitter);
        grainStore& g = body->grains;
        g.resize(int(x.size()));
        for (int i = 0; i < g.size(); ++i)
        {
            set(g.x, i, x[std::size_t(i)]);
            const double phase = 2 * M_PI * x[std::size_t(i)].z() / period;
            set(g.U, i, vector(speed * std::sin(phase), 0, 0));
            g.mass[i] = rho0 * dx * dx * dx;
            g.id[i] = i;
            g.rho[i] = g.rhoRef[i] = rho0 * random(0.98, 1.02);
            for (std::size_t c = 0; c < 6; ++c)
            {
                const bool diagonal = c == 0 || c == 3 || c == 5;
                g.sigma[c][i] = diagonal ? -pressure : 0;
            }
        }
    }

    //- task(j, x_i - x_j, its square) for all others and i itself
    template<class Task>
    void around(int i, const Task& task) const
    {
        const grainStore& g = body->grains;
        for (int j = 0; j < g.size(); ++j)
        {
            const vector d = nearest(at(g.x, i) - at(g.x, j), period);
            if (magSqr(d) < sqr(2 * h))
            {
                task(j, d, magSqr(d));
            }
        }
    }
};

//- sum dx^3 W over a lattice, by its own loop
double latticeSum()
{
    const lpfPairs::wendlandC2 W(h, 3);
    double sum = 0;
    for (int n = 0; n < 343; ++n)
    {
        const int i = n % 7 - 3, j = n / 7 % 7 - 3, k = n / 49 - 3;
        const double rSqr = dx * dx * (i * i + j * j + k * k);
        sum += rSqr < sqr(2 * h) ? W.value(rSqr) * dx * dx * dx : 0;
    }
    return sum;
}

double shearRate(const tensor& L)
{
    return std::sqrt(2 * magSqr(dev(symm(L))));
}

} // namespace


TEST_CASE("packing of grains: the density goes to the sum of the masses")
{
    constexpr double dt = 1e-3, k = 0.7;
    grainBox b(0.1 * dx, 2, k, 0);
    b.body->rates(0, 0); // order by cells, without a change
    const lpfPairs::wendlandC2 W(h, 3);
    const grainStore& g = b.body->grains;
    std::vector<double> rho, S;
    for (int i = 0; i < g.size(); ++i)
    {
        double sum = 0;
        b.around(
            i,
            [&](int j, const vector&, double rSqr)
            { sum += g.mass[j] * W.value(rSqr); }
        );
        rho.push_back(g.rho[i]);
        S.push_back(sum / latticeSum());
    }
    const double before = b.body->energy().elastic;
    b.body->rates(dt, 0);
    double worst = 0, largest = 0;
    for (int i = 0; i < g.size(); ++i)
    {
        const auto n = std::size_t(i);
        const double gdot = shearRate(b.stress.L[std::size_t(g.id[i])]);
        const double change = dt * k * gdot * (S[n] - rho[n]);
        worst = max(worst, mag(g.rho[i] - rho[n] - change));
        largest = max(largest, mag(change));
    }
    INFO("largest change " << largest << ", off by " << worst);
    CHECK(largest > 0.1);
    CHECK(worst < 1e-9 * largest);
    const double lost = before - b.body->energy().elastic;
    CHECK(b.body->ledger.diffusion == Approx(lost).epsilon(1e-9));
}


TEST_CASE("packing of grains: they move to where there is room")
{
    constexpr double dt = 1e-3, A = 0.6;
    grainBox b(0.1 * dx, 2, 0, A);
    b.body->rates(dt, 0);
    const lpfPairs::wendlandC2 W(h, 3);
    const grainStore& g = b.body->grains;
    std::vector<vector> goal;
    for (int i = 0; i < g.size(); ++i)
    {
        vector gradS = Zero;
        b.around(
            i,
            [&](int j, const vector& d, double rSqr)
            { gradS += g.mass[j] / g.rho[j] * W.gradByDistance(rSqr) * d; }
        );
        const double gdot = shearRate(b.stress.L[std::size_t(g.id[i])]);
        goal.push_back(
            at(g.x, i) + dt * (at(g.U, i) - A * gdot * sqr(h) * gradS)
        );
    }
    b.body->drift(dt, 0);
    double worst = 0;
    for (int i = 0; i < g.size(); ++i)
    {
        const vector off = nearest(at(g.x, i) - goal[std::size_t(i)], period);
        worst = max(worst, mag(off));
    }
    CHECK(worst < 1e-12 * dx);
    CHECK(mag(b.body->ledger.shifting) > 1e-9);
}


TEST_CASE("packing of grains: at rest nothing changes")
{
    constexpr double dt = 1e-3;
    grainBox with(0.1 * dx, 0, 1, 1), without(0.1 * dx, 0, 0, 0);
    for (grainBox* b : {&with, &without})
    {
        b->body->rates(dt, 0);
        b->body->drift(dt, 0);
    }
    const grainStore &a = with.body->grains, &c = without.body->grains;
    int same = 0;
    for (int i = 0; i < a.size(); ++i)
    {
        same += a.rho[i] == c.rho[i] && at(a.x, i) == at(c.x, i);
    }
    CHECK(same == a.size());
    CHECK(with.body->ledger.diffusion == 0);
    CHECK(with.body->ledger.shifting == 0);
}
