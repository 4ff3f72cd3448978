// SPDX-License-Identifier: GPL-3.0-or-later
// Time integrations by the order of their error, on waves of finite amplitude
// with viscosity and damping; energy over many periods; the ledger; nothing
// kept that is not asked for.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "sampleGrains.H"
#include "sampleGround.H"
#include "sampleScene.H"
#include "timeIntegration.H"
#include "wendlandC2.H"

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx, rhoGrain = 2600, solid = 0.6;
constexpr int cells = 8;
constexpr double period = cells * dx, k = 2 * M_PI / period;

//- Drag takes the slip of what is smoothed, at first order in dt/tau where it
//  changes within a kernel: the order of the rest is looked at without
class noDrag : public dragLaw
{
public:
    scalar beta(const dragPoint&, scalar) const override { return 0; }
};

//- A periodic box of one phase or both, in which waves run along z
struct waveBox
{
    sceneProperties scene = periodicScene(dx, h, period, Zero);
    autoPtr<ground> bed = groundFarAway();
    groundContact contact;
    autoPtr<timeIntegration> integration;
    flow all;
    double time = 0, dtBefore = 0;

    explicit waveBox(const std::string& name)
        : contact(
            *bed,
            dictOf("zones { floor { friction none; } }"),
            dx,
            4 * dx,
            0,
            vector(0, 1, 0)
        ),
          integration(
              timeIntegration::New(dictOf("timeIntegration " + name + ";"))
          )
    {
    }

    //- Elastic grains, pressed together
    void
    addGrains(bool wet, const schemeProperties& scheme, double pressed = 0.3)
    {
        const dictionary phase(
            dictOf("rho 2600; diameter 1e-3; rheology muI; muICoeffs "
                   "{ muS 4; mu2 4; I0 0.28; nu 0.3; E 1e6; }")
        );
        const elasticity elastic(
            phase.subDict("muICoeffs"), {solid * rhoGrain, 1, 1}
        );
        all.rheology.reset(granularRheology::New(phase, elastic).ptr());
        all.grains.reset(new grainDynamics(
            lpfPairs::loadPairEngine("auto"),
            scene,
            scheme,
            *all.rheology,
            contact,
            wet
        ));
        integration->prepare(all);
        grainStore& g = all.grains->grains;
        fill(g, solid * rhoGrain);
        for (int i = 0; i < g.size(); ++i)
        {
            g.rhoRef[i] = solid * rhoGrain;
            g.rho[i] = (1 + pressed) * g.rhoRef[i];
            g.mass[i] *= 1 + pressed;
            const double p = pressed * elastic.K();
            for (std::size_t c = 0; c < 6; ++c)
            {
                g.sigma[c][i] = c == 0 || c == 3 || c == 5 ? -p : 0;
            }
        }
    }

    void addWater(bool withGrains)
    {
        waterScheme scheme;
        scheme.artificialViscosity = 0;
        scheme.densityRelaxation = 0;
        all.state.reset(equationOfState::New(
                            dictOf("rho 1000; TaitCoeffs { soundSpeed 30; }"),
                            {}
        )
                            .ptr());
        all.viscosity.reset(
            viscosityModel::New(dictOf("NewtonianCoeffs { mu 200; }")).ptr()
        );
        all.water.reset(new waterDynamics(
            lpfPairs::loadPairEngine("auto"),
            scene,
            scheme,
            *all.state,
            *all.viscosity,
            contact,
            withGrains
        ));
        integration->prepare(all);
        waterStore& w = all.water->water;
        const double rho = 1100, share = withGrains ? 1 - solid : 1;
        fill(w, share * rho);
        for (int i = 0; i < w.size(); ++i)
        {
            w.rho[i] = rho;
        }
    }

    void couple()
    {
        all.law.reset(new noDrag);
        all.coupling.reset(new interphase(
            lpfPairs::loadPairEngine("auto"),
            *all.grains,
            *all.water,
            *all.law,
            rhoGrain,
            0.1
        ));
    }

    void fill(particleStore& s, double density)
    {
        // in order: noise between neighbours would hide the waves
        randomNumbers random(3);
        const std::vector<vector> x =
            jitteredLattice(random, Zero, {cells, cells, cells}, dx, 0);
        s.resize(int(x.size()));
        for (int i = 0; i < s.size(); ++i)
        {
            set(s.x, i, x[std::size_t(i)]);
            s.mass[i] = density * dx * dx * dx;
            s.id[i] = i;
        }
    }

    //- Along and across the wave
    void setWave(particleStore& s, double speed)
    {
        for (int i = 0; i < s.size(); ++i)
        {
            const double u = speed * std::sin(k * s.x[2][i]);
            set(s.U, i, vector(u, 0, 0.5 * u));
        }
    }

    void run(double duration, int steps)
    {
        const double dt = duration / steps;
        for (int n = 0; n < steps; ++n)
        {
            integration->begin(all, dtBefore, time);
            if (n == 0)
            {
                for (phaseDynamics* phase : all.phases())
                {
                    phase->ledger.initial = phase->energy();
                }
            }
            integration->finish(all, dtBefore, dt, time);
            time += dt;
            dtBefore = dt;
        }
        // velocities to the time of the positions
        integration->begin(all, dtBefore, time);
    }

    //- Velocities by phase and id
    std::vector<vector> velocities() const
    {
        std::vector<vector> all_;
        for (const phaseDynamics* phase : all.phases())
        {
            const particleStore& s = phase->particles();
            const std::size_t first = all_.size();
            all_.resize(first + std::size_t(s.size()));
            for (int i = 0; i < s.size(); ++i)
            {
                all_[first + std::size_t(s.id[i])] = at(s.U, i);
            }
        }
        return all_;
    }
};

enum class phasesOf
{
    grains,
    water,
    both
};

std::unique_ptr<waveBox> waves(const std::string& name, phasesOf which)
{
    std::unique_ptr<waveBox> b(new waveBox(name));
    constexpr double speed = 1.5;
    if (which != phasesOf::water)
    {
        schemeProperties scheme;
        scheme.bulkDamping = 0.2;
        scheme.shearDamping = 0.2;
        scheme.noiseDamping = 0.2;
        b->addGrains(which == phasesOf::both, scheme);
        b->setWave(b->all.grains->grains, speed);
    }
    if (which != phasesOf::grains)
    {
        b->addWater(which == phasesOf::both);
        b->setWave(b->all.water->water, -speed);
    }
    if (which == phasesOf::both)
    {
        b->couple();
    }
    return b;
}

double difference(const std::vector<vector>& a, const std::vector<vector>& b)
{
    double sum = 0;
    for (std::size_t i = 0; i < a.size(); ++i)
    {
        sum += magSqr(a[i] - b[i]);
    }
    return std::sqrt(sum / double(a.size()));
}

//- From the differences of three runs, each of twice the steps
double observedOrder(const std::string& name, phasesOf which)
{
    constexpr double duration = 0.01;
    constexpr int fewest = 24;
    std::vector<vector> U[3];
    for (int n = 0; n < 3; ++n)
    {
        const auto b = waves(name, which);
        b->run(duration, fewest << n);
        U[n] = b->velocities();
    }
    return std::log2(difference(U[0], U[1]) / difference(U[1], U[2]));
}

void checkOrders(phasesOf which)
{
    const double second = observedOrder("predictorCorrector", which);
    const double first = observedOrder("leapfrog", which);
    INFO("order: predictorCorrector " << second << ", leapfrog " << first);
    CHECK(second > 1.8);
    CHECK(second < 2.3);
    // or the test would say nothing
    CHECK(first < 1.5);
}

} // namespace


TEST_CASE("time integration: order 2 of damped waves in grains")
{
    checkOrders(phasesOf::grains);
}


TEST_CASE("time integration: order 2 of viscous waves in water")
{
    checkOrders(phasesOf::water);
}


TEST_CASE("time integration: order 2 of waves in grains and water")
{
    checkOrders(phasesOf::both);
}


TEST_CASE("time integration: an elastic wave keeps its energy")
{
    for (const std::string name : {"leapfrog", "predictorCorrector"})
    {
        waveBox b(name);
        b.addGrains(false, {}, 0.01);
        b.setWave(b.all.grains->grains, 0.1);
        const double start = b.all.energy().kinetic;
        const double c = b.all.rheology->elastic().c();
        const double dt = 0.3 * h / c;
        b.run(400 * dt, 400); // about ten periods of compression
        const balance& ledger = b.all.grains->ledger;
        const energyState now = b.all.energy();
        const double lost = ledger.unexplained(now) / start;
        INFO(name << ": unexplained " << lost << " of the kinetic energy");
        CHECK(mag(lost) < 0.02);
        CHECK(ledger.plastic == 0);
        CHECK(mag(now.momentum - ledger.initial.momentum) < 1e-10);
    }
}


namespace
{

//- The wave number that a corrected gradient sees along an axis of the lattice
double wavenumberSeen()
{
    const lpfPairs::wendlandC2 W(h, 3);
    double wave = 0, moment = 0;
    for (int x = -3; x <= 3; ++x)
    {
        for (int y = -3; y <= 3; ++y)
        {
            for (int z = -3; z <= 3; ++z)
            {
                const double rSqr = dx * dx * (x * x + y * y + z * z);
                if (rSqr > 0 && rSqr < 4 * h * h)
                {
                    const double F = W.gradByDistance(rSqr);
                    wave += F * z * dx * std::sin(k * z * dx);
                    moment += F * z * dx * z * dx;
                }
            }
        }
    }
    return wave / moment;
}

} // namespace


TEST_CASE("time integration: shear damping is a viscosity of elastic waves")
{
    // Kelvin and Voigt: energy ~ exp(-nu k^2 t), nu = beta c h, besides what
    // oscillates with it
    constexpr double beta = 0.1;
    for (const std::string name : {"leapfrog", "predictorCorrector"})
    {
        schemeProperties scheme;
        scheme.shearDamping = beta;
        waveBox b(name);
        b.addGrains(false, scheme, 0.01);
        grainStore& g = b.all.grains->grains;
        for (int i = 0; i < g.size(); ++i)
        {
            set(g.U, i, vector(0.1 * std::sin(k * g.x[2][i]), 0, 0));
        }
        const energyState start = b.all.energy();
        const elasticity& elastic = b.all.rheology->elastic();
        const double rate = beta * elastic.c() * h * sqr(wavenumberSeen());
        // whole periods, after which only the decay is left
        const double shearSpeed = std::sqrt(elastic.G() / g.rho[0]);
        const double duration = 2 * 2 * M_PI / (shearSpeed * wavenumberSeen());
        const int steps = int(duration * elastic.c() / (0.1 * h));
        b.run(duration, steps);
        const energyState now = b.all.energy();
        const double left = now.kinetic / start.kinetic;
        const double expected = std::exp(-rate * duration);
        const balance& ledger = b.all.grains->ledger;
        INFO(name << ": " << left << " left, " << expected << " expected");
        CHECK(expected < 0.6);
        CHECK(mag(left / expected - 1) < 0.05);
        CHECK(mag(ledger.artificial / start.kinetic - (1 - left)) < 0.05);
        CHECK(ledger.plastic == 0);
        CHECK(mag(now.momentum - ledger.initial.momentum) < 1e-10);
    }
}


TEST_CASE("time integration: shear damping leaves a steady flow alone")
{
    // what yields keeps its stress, so that only turning is left of its rate
    schemeProperties scheme;
    scheme.shearDamping = 0.3;
    waveBox b("leapfrog");
    b.addGrains(false, scheme, 0.01);
    grainStore& g = b.all.grains->grains;
    for (int i = 0; i < g.size(); ++i)
    {
        set(g.U, i, vector(60 * std::sin(k * g.x[2][i]), 0, 0));
    }
    const double dt = 0.1 * h / b.all.rheology->elastic().c();
    b.run(40 * dt, 40);
    const balance& ledger = b.all.grains->ledger;
    INFO("artificial " << ledger.artificial << " of " << ledger.plastic);
    CHECK(ledger.plastic > 0);
    CHECK(ledger.artificial < 0.05 * ledger.plastic);
}


TEST_CASE("time integration: only what is asked for is kept")
{
    waveBox plain("leapfrog"), twice("predictorCorrector");
    plain.addGrains(false, {});
    twice.addGrains(false, {});
    const grainStore& g = plain.all.grains->grains;
    const std::size_t one = g.rho.bytes();
    CHECK(lpf::bytes(g.UStart) + lpf::bytes(g.sigmaStart) == 0);
    CHECK(g.rhoStart.bytes() + g.rhoRefStart.bytes() == 0);
    CHECK(twice.all.grains->grains.bytes() == g.bytes() + 11 * one);
    CHECK(plain.integration->evaluations() == 1);
    CHECK(twice.integration->evaluations() == 2);
}
