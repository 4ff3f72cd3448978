// SPDX-License-Identifier: GPL-3.0-or-later
// Water that is moved to where there is room (T 5.23): the packing evens out,
// a lattice and shallow water stay, and the work is booked.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "sampleGrains.H"
#include "sampleGround.H"
#include "sampleScene.H"
#include "waterDynamics.H"
#include "wendlandC2.H"

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx, rho0 = 1000, c0 = 20;
constexpr int cells = 8;
constexpr double period = cells * dx;

//- A periodic box of water under the pressure head [m], at rest
struct waterBox
{
    sceneProperties scene = periodicScene(dx, h, period, vector(0, 0, -9.81));
    autoPtr<ground> bed = groundFarAway();
    groundContact contact;
    autoPtr<equationOfState> state;
    autoPtr<viscosityModel> viscosity;
    std::unique_ptr<waterDynamics> water;

    waterBox(double jitter, double head, scalar shifting)
        : contact(
            *bed,
            dictOf("zones { floor { friction none; } }"),
            dx,
            4 * dx,
            0,
            vector(0, 1, 0)
        ),
          state(equationOfState::New(
              dictOf("rho 1000; TaitCoeffs { soundSpeed 20; }"), {}
          )),
          viscosity(viscosityModel::New(dictOf("NewtonianCoeffs { mu 0; }")))
    {
        waterScheme scheme;
        scheme.artificialViscosity = scheme.densityDiffusion = 0;
        scheme.densityRelaxation = 0;
        scheme.shifting = shifting;
        water.reset(new waterDynamics(
            lpfPairs::loadPairEngine("auto"),
            scene,
            scheme,
            *state,
            *viscosity,
            contact
        ));
        randomNumbers random(11);
        const std::vector<vector> x =
            jitteredLattice(random, Zero, {cells, cells, cells}, dx, jitter);
        waterStore& w = water->water;
        w.resize(int(x.size()));
        for (int i = 0; i < w.size(); ++i)
        {
            set(w.x, i, x[std::size_t(i)]);
            w.mass[i] = rho0 * dx * dx * dx;
            w.id[i] = i;
            w.rho[i] = rho0 * (1 + 9.81 * head / sqr(c0));
        }
    }

    //- The particles where the shift alone takes them
    void shiftOnly(int steps)
    {
        waterStore& w = water->water;
        for (int k = 0; k < steps; ++k)
        {
            water->rates(1e-3, 0);
            water->drift(1e-3, 0);
        }
        CHECK(w.size() == cells * cells * cells);
    }

    //- sum V W of each particle with its periodic images, less its mean: rms
    double unevenness() const
    {
        const lpfPairs::wendlandC2 W(h, 3);
        const waterStore& w = water->water;
        std::vector<double> S;
        double mean = 0, square = 0;
        for (int i = 0; i < w.size(); ++i)
        {
            double sum = 0;
            for (int j = 0; j < w.size(); ++j)
            {
                const vector d = nearest(at(w.x, i) - at(w.x, j), period);
                sum += magSqr(d) < sqr(2 * h) ? W.value(magSqr(d)) : 0;
            }
            S.push_back(sum * dx * dx * dx);
            mean += S.back() / w.size();
        }
        for (const double s : S)
        {
            square += sqr(s - mean) / w.size();
        }
        return std::sqrt(square);
    }
};

} // namespace


TEST_CASE("shifting: evens the packing out, and books its work")
{
    waterBox b(0.2 * dx, 5, 3);
    b.water->rates(0, 0);
    b.water->ledger.initial = b.water->energy();
    const double before = b.unevenness();
    b.shiftOnly(100);
    const double after = b.unevenness();
    INFO("from " << before << " to " << after);
    CHECK(after < 0.2 * before);
    CHECK(b.water->ledger.shifting != 0);
    const double booked = mag(b.water->ledger.shifting);
    const double open =
        mag(b.water->ledger.unexplained(b.water->energy())) / booked;
    INFO("share of the work that is not booked " << 1e6 * open << "e-6");
    CHECK(open < 1e-6);
}


TEST_CASE("shifting: nothing in a lattice, and nothing under a low head")
{
    for (const bool jittered : {false, true})
    {
        waterBox b(jittered ? 0.2 * dx : 0, jittered ? 0.9 * h : 5, 3);
        b.water->rates(0, 0);
        realArrays<3> x;
        const waterStore& w = b.water->water;
        lpf::resize(x, w.size());
        for (int i = 0; i < w.size(); ++i)
        {
            set(x, i, at(w.x, i));
        }
        b.shiftOnly(1);
        double moved = 0;
        for (int i = 0; i < w.size(); ++i)
        {
            moved = max(moved, mag(at(w.x, i) - at(x, i)));
        }
        CHECK(moved < 1e-12 * dx);
    }
}
