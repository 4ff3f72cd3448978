// SPDX-License-Identifier: GPL-3.0-or-later
// Viscosities against their laws, exact decay of shear, flow over ground that
// water sticks to, momentum and energy at any viscosity.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "interphase.H"
#include "sampleGrains.H"
#include "sampleGround.H"

#include <cmath>
#include <sstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double rho = 1000;

std::string newtonian(double mu)
{
    std::ostringstream text;
    text << "NewtonianCoeffs { mu " << mu << "; }";
    return text.str();
}

//- The same liquid through the passes that rates of shear need
std::string newtonianByRate(double mu)
{
    std::ostringstream text;
    text << "viscosity Bingham; BinghamCoeffs { muP " << mu
         << "; tau0 0; muMax " << mu << "; }";
    return text.str();
}

//- mu times a rate of shear
double stress(const std::string& phase, double rate)
{
    double mu = 0;
    viscosityModel::New(dictOf(phase))->mu(1, &rate, &mu);
    return mu * rate;
}

//- What a box of water is made of
struct waterBoxShape
{
    int dimensions = 3;
    int n[3] = {8, 8, 20};
    double dx = 0.1;
    bool floor = false; //!< z = 0, else periodic along z
    std::string zone = "floor { friction none; waterFriction noSlip; }";
    double jitter = 0;
};

autoPtr<ground> floorOf(const waterBoxShape& s)
{
    const double far = 1e3, z = s.floor ? 0 : -far;
    // in plane strain the ground is as wide as the plane is thick
    const double a = s.dimensions == 3 ? -2 * s.n[1] * s.dx : 0;
    const double b = s.dimensions == 3 ? -a + s.n[1] * s.dx : 1;
    const double L = s.n[0] * s.dx;
    const point p(-2 * L, a, z), q(3 * L, a, z), r(3 * L, b, z),
        t(-2 * L, b, z);
    List<corners> all;
    all.append(corners{p, q, r});
    all.append(corners{p, r, t});
    return groundOf(all);
}

//- Water alone, periodic along x and y, and along z or over a floor
class waterBox
{
    static sceneProperties sceneOf(const waterBoxShape& s)
    {
        sceneProperties scene = {};
        scene.spacing = s.dx;
        scene.h = scene.largestH = 1.3 * s.dx;
        scene.dimensions = s.dimensions;
        scene.planeThickness = 1;
        scene.planeNormal = vector(0, 1, 0);
        scene.g = Zero;
        scene.cyclic.lower = Zero;
        scene.cyclic.period = vector(
            s.n[0] * s.dx,
            s.dimensions == 3 ? s.n[1] * s.dx : 0,
            s.floor ? 0 : s.n[2] * s.dx
        );
        scene.domain = boundBox(vector::uniform(-1e4), vector::uniform(1e4));
        return scene;
    }

    static waterScheme schemeOf(bool implicitly)
    {
        waterScheme scheme;
        scheme.artificialViscosity = 0;
        scheme.densityDiffusion = 0;
        scheme.densityRelaxation = 0;
        scheme.implicitViscosity = implicitly;
        return scheme;
    }

public:
    waterBoxShape shape;
    autoPtr<ground> bed;
    groundContact contact;
    autoPtr<equationOfState> state;
    autoPtr<viscosityModel> viscosity;
    waterDynamics dynamics;

    waterBox(const waterBoxShape& s, const std::string& phase, bool implicitly)
        : shape(s), bed(floorOf(s)), contact(
                                         *bed,
                                         dictOf("zones { " + s.zone + " }"),
                                         s.dx,
                                         4 * s.dx,
                                         s.dimensions == 2 ? 1 : 0,
                                         vector(0, 1, 0)
                                     ),
          state(equationOfState::New(
              dictOf("rho 1000; TaitCoeffs { soundSpeed 20; }"), {}
          )),
          viscosity(viscosityModel::New(dictOf(phase))),
          dynamics(
              lpfPairs::loadPairEngine("auto"),
              sceneOf(s),
              schemeOf(implicitly),
              *state,
              *viscosity,
              contact
          )
    {
        randomNumbers random(1);
        waterStore& w = dynamics.water;
        const int ny = s.dimensions == 3 ? s.n[1] : 1;
        w.resize(s.n[0] * ny * s.n[2]);
        int i = 0;
        for (int x = 0; x < s.n[0]; ++x)
        {
            for (int y = 0; y < ny; ++y)
            {
                for (int z = 0; z < s.n[2]; ++z)
                {
                    vector at = s.dx * vector(x + 0.5, y + 0.5, z + 0.5);
                    const vector off = random.inCube(s.jitter * s.dx);
                    at += vector(
                        off.x(), s.dimensions == 3 ? off.y() : 0, off.z()
                    );
                    set(w.x, i, at);
                    w.mass[i] = rho * std::pow(s.dx, s.dimensions);
                    w.id[i] = i;
                    w.rho[i] = rho;
                    ++i;
                }
            }
        }
    }

    template<class Velocity>
    void setU(const Velocity& U)
    {
        waterStore& w = dynamics.water;
        for (int i = 0; i < w.size(); ++i)
        {
            set(w.U, i, U(at(w.x, i)));
        }
    }

    //- Viscosity and a push [m/s2] over dt; what pressure does left out, and
    //  the particles where they are
    void step(double dt, const vector& push = Zero)
    {
        waterStore& w = dynamics.water;
        dynamics.arrange(0);
        dynamics.divergence();
        dynamics.accelerations();
        for (int i = 0; i < w.size(); ++i)
        {
            const vector a = at(w.friction, i) + push;
            set(w.a, i, dynamics.implicitViscosity() ? push : a);
        }
        dynamics.kick(dt);
        dynamics.relaxViscosity(dt);
    }

    vector momentum() const { return dynamics.energy().momentum; }
    double kinetic() const { return dynamics.energy().kinetic; }

    //- Amplitude of a shear wave
    double amplitude(const vector& k, const vector& direction) const
    {
        const waterStore& w = dynamics.water;
        double sum = 0;
        for (int i = 0; i < w.size(); ++i)
        {
            sum += 2 * (at(w.U, i) & direction) * std::sin(k & at(w.x, i));
        }
        return sum / w.size();
    }
};

} // namespace


TEST_CASE("viscosities: stress at a rate, by hand")
{
    const std::string bingham =
        "viscosity Bingham; BinghamCoeffs { muP 0.5; tau0 50; muMax 1000; }";
    CHECK(stress(bingham, 10) == Approx(55));
    CHECK(stress(bingham, 1) == Approx(50.5));
    CHECK(stress(bingham, 1e-3) == Approx(1)); // creeps, muMax
    const std::string power =
        "viscosity HerschelBulkleyPapanastasiou; "
        "HerschelBulkleyPapanastasiouCoeffs { k 2; n 0.5; tau0 30; m 100; "
        "muMax 1e5; }";
    CHECK(stress(power, 4) == Approx(34));
    CHECK(stress(power, 100) == Approx(50));
    CHECK(stress(power, 0.01) == Approx(0.2 + 30 * (1 - std::exp(-1))));
    const std::string casson =
        "viscosity Casson; CassonCoeffs { muInf 0.1; tau0 10; muMax 500; }";
    CHECK(stress(casson, 100) == Approx(40));
    CHECK(stress(casson, 10) == Approx(11 + 2 * std::sqrt(10.0)));
    CHECK_FALSE(stress(casson, 100) == Approx(41).epsilon(0.02));
    for (const std::string& phase : {bingham, power, casson})
    {
        const autoPtr<viscosityModel> model =
            viscosityModel::New(dictOf(phase));
        double rate = 0, mu = 0;
        model->mu(1, &rate, &mu);
        CHECK(std::isfinite(mu));
        CHECK(mu <= model->largest());
        CHECK(model->largest() >= model->molecular());
    }
}


TEST_CASE("viscosity: rates of shear are exact for a linear field on a lattice")
{
    waterBoxShape s;
    s.n[0] = s.n[1] = s.n[2] = 10;
    const tensor L(0.3, -1, 2, 0.5, -0.7, 1.5, -0.4, 0.9, 0.6);
    const symmTensor D = symm(L);
    const double exact = std::sqrt(2.0) * mag(D);
    waterBox b(
        s,
        "viscosity Bingham; BinghamCoeffs { muP 0; tau0 1; muMax 1e9; }",
        false
    );
    b.setU([&](const vector& x) { return L & x; });
    b.step(1e-9);
    const waterStore& w = b.dynamics.water;
    int inside = 0;
    double worst = 0;
    for (int i = 0; i < w.size(); ++i)
    {
        const vector x = at(w.x, i);
        if (cmptMin(x) > 0.3 && cmptMax(x) < 0.7)
        {
            ++inside;
            worst = max(worst, mag(b.dynamics.shearRate(i) / exact - 1));
        }
    }
    CHECK(inside >= 8);
    CHECK(worst < 1e-12);
}


TEST_CASE("viscosity: shear decays as exp(-nu k^2 t)")
{
    struct wave
    {
        int dimensions;
        int n[3];
        vector k, direction;
    };
    const double dx = 0.1, axis = 2 * M_PI / (24 * dx);
    const double across = 2 * M_PI / (32 * dx);
    const wave waves[] = {
        {2, {8, 1, 24}, vector(0, 0, axis), vector(1, 0, 0)},
        {2,
         {32, 1, 32},
         vector(across, 0, across),
         vector(1, 0, -1) / std::sqrt(2.0)},
        {3, {8, 8, 24}, vector(0, 0, axis), vector(1, 0, 0)},
        {3,
         {32, 8, 32},
         vector(across, 0, across),
         vector(1, 0, -1) / std::sqrt(2.0)}};
    for (const wave& v : waves)
    {
        waterBoxShape s;
        s.dimensions = v.dimensions;
        std::copy_n(v.n, 3, s.n);
        s.dx = dx;
        for (const double mu : {1e-6, 1e6})
        {
            for (const bool implicitly : {true, false})
            {
                waterBox b(
                    s,
                    implicitly ? newtonian(mu) : newtonianByRate(mu),
                    implicitly
                );
                b.setU([&](const vector& x)
                       { return 1e-3 * std::sin(v.k & x) * v.direction; });
                const double rate = mu / rho * magSqr(v.k);
                const int steps = 80;
                const double dt = 1 / (rate * steps);
                for (int k = 0; k < steps; ++k)
                {
                    b.step(dt);
                }
                const double found =
                    -std::log(b.amplitude(v.k, v.direction) / 1e-3);
                // what Euler's step makes of exp(-rate dt); the implicit one
                // is right
                const double exact =
                    implicitly ? 1 : -steps * std::log1p(-1.0 / steps);
                INFO(
                    v.dimensions << " dimensions, mu " << mu << " implicit "
                                 << implicitly << ": " << found
                );
                CHECK(found == Approx(exact).epsilon(0.02));
                // the amplitude itself, 2 % of what it was
                CHECK(mag(std::exp(-found) - std::exp(-1.0)) < 0.02);
                CHECK_FALSE(1.05 * found == Approx(exact).epsilon(0.02));
            }
        }
    }
}


TEST_CASE("viscosity: pairs take 2 eta D:D of a shear, up to free surfaces")
{
    const double mu = 3, shear = 2;
    const vector along = vector(0.6, 0.8, 0);
    for (const double jitter : {0.0, 0.2})
    {
        waterBoxShape s;
        s.floor = true;
        s.zone = "floor { friction none; }";
        s.jitter = jitter;
        waterBox b(s, newtonianByRate(mu), false);
        b.setU([&](const vector& x) { return shear * x.z() * along; });
        const double dt = 1e-9;
        b.step(dt);
        const double volume =
            b.dynamics.water.size() * std::pow(s.dx, s.dimensions);
        const double exact = mu * sqr(shear) * volume;
        const double found = b.dynamics.ledger.viscous / dt;
        INFO("jitter " << jitter << ": " << found / exact);
        CHECK(found == Approx(exact).epsilon(jitter > 0 ? 0.01 : 1e-5));
    }
}


TEST_CASE("viscosity: at the explicit limit motion dies away")
{
    waterBoxShape s;
    s.n[2] = 8;
    s.floor = true;
    s.zone = "floor { friction none; }";
    s.jitter = 0.2;
    const double mu = 1;
    waterBox b(s, newtonianByRate(mu), false);
    randomNumbers random(7);
    b.setU([&](const vector&) { return random.inCube(1); });
    const double dt = 0.125 * sqr(1.3 * s.dx) * rho / mu;
    int raised = 0;
    for (int k = 0; k < 100; ++k)
    {
        const double before = b.kinetic();
        b.step(dt);
        raised += b.kinetic() > before;
    }
    CHECK(raised == 0);
}


TEST_CASE("viscosity: passes over pairs are those that are stated")
{
    waterBoxShape s;
    s.n[2] = 8;
    s.zone = "floor { friction none; }";
    // h c0/(10 nu) of 260 and of 26
    CHECK(waterBox(s, newtonian(10), false).dynamics.pairPasses() == 4);
    CHECK(waterBox(s, newtonian(1), false).dynamics.pairPasses() == 2);
    CHECK(waterBox(s, newtonianByRate(1), false).dynamics.pairPasses() == 4);
    CHECK(waterBox(s, newtonian(1), true).dynamics.pairPasses() == 3);
}


TEST_CASE("implicit viscosity: second order in time")
{
    waterBoxShape s;
    s.dimensions = 2;
    s.n[2] = 24;
    const vector k(0, 0, 2 * M_PI / (s.n[2] * s.dx)), along(1, 0, 0);
    const double mu = 1, rate = mu / rho * magSqr(k);
    double found[3];
    for (int run = 0; run < 3; ++run)
    {
        const int steps = 4 << run;
        waterBox b(s, newtonian(mu), true);
        b.setU([&](const vector& x) { return std::sin(k & x) * along; });
        for (int n = 0; n < steps; ++n)
        {
            b.step(1 / (rate * steps));
        }
        found[run] = b.amplitude(k, along);
    }
    const double order =
        std::log2((found[0] - found[1]) / (found[1] - found[2]));
    INFO("order " << order);
    CHECK(order > 1.8);
    CHECK(order < 2.3);
}


TEST_CASE("implicit viscosity: momentum exact, energy never up, at any dt nu")
{
    waterBoxShape s;
    s.n[0] = s.n[1] = s.n[2] = 8;
    s.jitter = 0.2;
    randomNumbers random(3);
    for (const char* phase :
         {"NewtonianCoeffs { mu 1; }",
          "viscosity Bingham; BinghamCoeffs { muP 1e-3; tau0 1; muMax 1e3; }"})
    {
        waterBox b(s, phase, true);
        waterStore& w = b.dynamics.water;
        int raised = 0;
        double worst = 0;
        for (int k = 0; k < 40; ++k)
        {
            b.setU([&](const vector&) { return random.inCube(1); });
            const double before = b.kinetic();
            const vector momentum = b.momentum();
            b.step(std::pow(10, random(-9, 6)));
            raised += b.kinetic() > before * (1 + 1e-14);
            double sum = 0;
            for (int i = 0; i < w.size(); ++i)
            {
                sum += w.mass[i];
            }
            worst = max(worst, mag(b.momentum() - momentum) / sum);
        }
        INFO(phase);
        CHECK(raised == 0);
        CHECK(worst < 1e-13);
    }
}


TEST_CASE("implicit viscosity: a block that turns is left alone")
{
    waterBoxShape s;
    s.n[0] = s.n[1] = s.n[2] = 16;
    s.jitter = 0.1;
    waterBox b(s, newtonian(1e6), true);
    waterStore& w = b.dynamics.water;
    // only a ball of it, so that no neighbour is across the box
    const vector middle = vector::uniform(0.8);
    int kept = 0;
    for (int i = 0; i < w.size(); ++i)
    {
        if (mag(at(w.x, i) - middle) < 0.5)
        {
            set(w.x, kept, at(w.x, i));
            ++kept;
        }
    }
    w.truncate(kept);
    b.setU([&](const vector& x) { return vector(1, 2, 3) ^ (x - middle); });
    const double before = b.kinetic();
    b.step(1);
    CHECK(b.kinetic() == Approx(before).epsilon(1e-6));

    // and one that falls, with rounding for all its shear
    randomNumbers random(5);
    b.setU([&](const vector&)
           { return vector(0, 0, -50) + random.inCube(1e-13); });
    b.step(1);
    CHECK(b.dynamics.iterations() < 1000);
}


namespace
{

//- u over G H^2/mu of a layer with a free surface that is pushed from rest, at
//  z/H and nu t/H^2
double startUp(double z, double t)
{
    double u = z - 0.5 * z * z;
    for (int n = 0; n < 60; ++n)
    {
        const double k = (n + 0.5) * M_PI;
        u -= 2 / (k * k * k) * std::sin(k * z) * std::exp(-k * k * t);
    }
    return u;
}

//- Largest error over the largest velocity, of a layer at a time
double offStartUp(const waterBox& b, double G, double mu, double time)
{
    const waterStore& w = b.dynamics.water;
    const double H = b.shape.n[2] * b.shape.dx;
    const double scale = G * H * H / mu;
    const double t = mu / rho * time / (H * H);
    double worst = 0;
    for (int i = 0; i < w.size(); ++i)
    {
        const double exact = startUp(w.x[2][i] / H, t);
        worst = max(worst, mag(w.U[0][i] / scale - exact));
    }
    return worst / startUp(1, t);
}

} // namespace


TEST_CASE("no slip: a layer on a floor starts up as the series says")
{
    struct run
    {
        int dimensions;
        bool implicitly;
        double step; // of H^2/nu
    };
    for (const run& r :
         {run{2, true, 2e-3}, run{2, false, 4e-4}, run{3, true, 4e-3}})
    {
        waterBoxShape s;
        s.dimensions = r.dimensions;
        s.floor = true;
        const double H = s.n[2] * s.dx;
        const double mu = r.implicitly ? 1e4 : 1.0, push = 1e-3;
        waterBox b(
            s, r.implicitly ? newtonian(mu) : newtonianByRate(mu), r.implicitly
        );
        const double unit = H * H * rho / mu;
        double time = 0;
        for (const double until : {0.1, 0.4, 1.2})
        {
            while (time < until * unit)
            {
                b.step(r.step * unit, vector(push, 0, 0));
                time += r.step * unit;
            }
            const double off = offStartUp(b, rho * push, mu, time);
            INFO(
                r.dimensions << " dimensions, implicit " << r.implicitly
                             << " at " << until << ": " << off
            );
            CHECK(off < 0.02);
        }
        // what another viscosity would be
        CHECK(offStartUp(b, rho * push, 1.05 * mu, time) > 0.03);
        CHECK(offStartUp(b, rho * push, 0.93 * mu, time) > 0.03);
    }
}


TEST_CASE("no slip: the floor takes the momentum, the ledger has it")
{
    waterBoxShape s;
    s.n[2] = 10;
    s.floor = true;
    for (const bool implicitly : {true, false})
    {
        waterBox b(s, newtonian(10), implicitly);
        b.setU([](const vector&) { return vector(1, 0, 0); });
        const vector before = b.momentum();
        const double energy = b.kinetic();
        for (int k = 0; k < 20; ++k)
        {
            b.step(1e-2);
        }
        const balance& l = b.dynamics.ledger;
        CHECK(b.momentum().x() < 0.99 * before.x());
        CHECK(
            mag(b.momentum() - before - l.frictionImpulse) < 1e-12 * mag(before)
        );
        CHECK(l.viscous == Approx(energy - b.kinetic()).epsilon(0.03));
    }
}


TEST_CASE("Bingham: plug and shear of a layer on a floor")
{
    waterBoxShape s;
    s.dimensions = 2;
    s.n[2] = 24;
    s.dx = 0.01;
    s.floor = true;
    // surface at H, yields below H - tau0/G
    const double H = s.n[2] * s.dx, push = 1, G = rho * push, muP = 10;
    const double tau0 = 0.4 * G * H;
    std::ostringstream phase;
    phase << "viscosity Bingham; BinghamCoeffs { muP " << muP << "; tau0 "
          << tau0 << "; muMax " << 1000 * muP << "; }";
    waterBox b(s, phase.str(), true);
    const double unit = H * H * rho / muP;
    for (int k = 0; k < 250; ++k)
    {
        b.step(0.01 * unit, vector(push, 0, 0));
    }
    const waterStore& w = b.dynamics.water;
    const double yields = H - tau0 / G;
    const double plug = 0.5 * G * sqr(yields) / muP;
    double worst = 0;
    for (int i = 0; i < w.size(); ++i)
    {
        const double z = min(w.x[2][i], yields);
        const double exact = G * z * (yields - 0.5 * z) / muP;
        worst = max(worst, mag(w.U[0][i] - exact) / plug);
    }
    INFO("worst " << worst);
    CHECK(worst < 0.05);
}
