// SPDX-License-Identifier: GPL-3.0-or-later
// Laws of the ground against the tractions they are made for, at single places,
// under slabs of grains and of water, and in steps of any length.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "grainDynamics.H"
#include "sampleGrains.H"
#include "triangles.H"
#include "waterDynamics.H"

#include "StringStream.H"

#include <cmath>
#include <functional>
#include <string>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, gravity = 9.81;

dictionary dictOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}

std::unique_ptr<groundLaw> lawOfWater(const std::string& zone)
{
    return groundLaw::forWater(dictOf("friction none; waterFriction " + zone));
}

//- A uniform flow of depth h on a slope, seen by a particle of water at d
groundPlace placeIn(double h, double d, double slope, double rho)
{
    groundPlace p = {};
    p.distance = p.stressHeight = d;
    p.g = gravity;
    p.gNormal = gravity * std::cos(slope);
    p.normalStress = rho * p.gNormal * (h - d);
    p.rho = rho;
    p.spacing = 0.01;
    return p;
}

//- Speed of a plug of depth h in the end, from rest, in steps of dt
double terminal(
    const groundLaw& law, double h, double slope, double dt, bool& reversed
)
{
    const groundPlace place = placeIn(h, 0.05, slope, 1000);
    const groundTraction t = law.at(place);
    double u = 0;
    for (int k = 0; k < 10000; ++k)
    {
        const double drive = gravity * std::sin(slope) * dt;
        const double dry = law.mu() * place.gNormal * dt;
        const double w = max(0.0, u + drive - dry);
        u = slowed(w, 1 + dt * t.linear / h, dt * t.quadratic / h);
        reversed = reversed || u < 0;
    }
    return u;
}

//- Two quads of ground at z = 0 that meet at x = middle, zones left and right
autoPtr<ground> floors(double middle)
{
    List<corners> all;
    labelList zones;
    const double L = 20;
    const double ends[2][2] = {{-L, middle}, {middle, L}};
    for (label k = 0; k < 2; ++k)
    {
        const point p(ends[k][0], -L, 0), q(ends[k][1], -L, 0),
            r(ends[k][1], L, 0), t(ends[k][0], L, 0);
        all.append(corners{p, q, r});
        all.append(corners{p, r, t});
        zones.append(k);
        zones.append(k);
    }
    PtrList<groundPart> parts;
    parts.append(autoPtr<groundPart>(new triangles(all, zones)));
    return autoPtr<ground>::New(
        std::move(parts), wordList({"left", "right"}), Zero, ""
    );
}

constexpr int across = 6;

sceneProperties periodicScene()
{
    sceneProperties scene = {};
    scene.spacing = dx;
    scene.h = scene.largestH = 1.3 * dx;
    scene.dimensions = 3;
    scene.planeThickness = 1;
    scene.planeNormal = vector(0, 1, 0);
    scene.g = vector(0, 0, -gravity);
    scene.cyclic.lower = Zero;
    scene.cyclic.period = vector(across * dx, across * dx, 0);
    scene.domain = boundBox(vector::uniform(-1e4), vector::uniform(1e4));
    return scene;
}

std::vector<vector> slabPlaces(int layers)
{
    std::vector<vector> all;
    for (int x = 0; x < across; ++x)
    {
        for (int y = 0; y < across; ++y)
        {
            for (int z = 0; z < layers; ++z)
            {
                all.push_back(dx * vector(x + 0.5, y + 0.5, z + 0.5));
            }
        }
    }
    return all;
}

constexpr double area = across * across * dx * dx;

//- Force on the ground over its area from what a short kick does to particles
template<class Dynamics>
vector traction(Dynamics& d)
{
    const double dt = 1e-7;
    const vector before = d.ledger.frictionImpulse;
    d.kick(dt);
    return -(d.ledger.frictionImpulse - before) / (dt * area);
}

//- Water at rest on a level floor but for a common velocity along x
class waterSlab
{
    autoPtr<ground> bed_;
    groundContact contact_;
    autoPtr<equationOfState> state_;
    autoPtr<viscosityModel> viscosity_;

    static waterScheme scheme()
    {
        waterScheme s;
        s.artificialViscosity = s.densityDiffusion = s.densityRelaxation = 0;
        return s;
    }

public:
    waterDynamics dynamics;

    waterSlab(const std::string& zone, int layers, double speed)
        : bed_(floors(-10)),
          contact_(
              *bed_,
              dictOf(
                  "zones { left { friction none; } right { friction none; "
                  + zone + " } }"
              ),
              dx,
              4 * dx,
              0,
              vector(0, 1, 0)
          ),
          state_(equationOfState::New(
              dictOf("rho 1000; TaitCoeffs { soundSpeed 200; }"), {}
          )),
          viscosity_(viscosityModel::New(dictOf("NewtonianCoeffs { mu 0; }"))),
          dynamics(
              lpfPairs::loadPairEngine("auto"),
              periodicScene(),
              scheme(),
              *state_,
              *viscosity_,
              contact_
          )
    {
        const auto places = slabPlaces(layers);
        waterStore& w = dynamics.water;
        w.resize(static_cast<int>(places.size()));
        for (int i = 0; i < w.size(); ++i)
        {
            const vector x = places[static_cast<std::size_t>(i)];
            set(w.x, i, x);
            set(w.U, i, vector(speed, 0, 0));
            w.rho[i] = state_->density(1000 * gravity * (layers * dx - x.z()));
            w.mass[i] = w.rho[i] * dx * dx * dx;
            w.id[i] = i;
        }
        dynamics.rates(1e-9, 0);
    }
};

//- Grains whose lowest layers carry the weight of a depth
class grainSlab
{
    autoPtr<ground> bed_;
    groundContact contact_;
    autoPtr<granularRheology> rheology_;
    schemeProperties scheme_;

    static dictionary phase()
    {
        return dictOf("rho 2600; diameter 0.01; rheology muI; muICoeffs "
                      "{ muS 5; mu2 5; I0 0.3; nu 0.3; E 1e8; }");
    }

public:
    grainDynamics dynamics;

    grainSlab(
        const std::string& left,
        const std::string& right,
        int layers,
        const vector& U,
        double middle = -10
    )
        : bed_(floors(middle)),
          contact_(
              *bed_,
              dictOf("zones { left { " + left + " } right { " + right + " } }"),
              dx,
              4 * dx,
              0,
              vector(0, 1, 0)
          ),
          rheology_(granularRheology::New(
              phase(), elasticity(phase().subDict("muICoeffs"), {1300, 10, 1})
          )),
          dynamics(
              lpfPairs::loadPairEngine("auto"),
              periodicScene(),
              scheme_,
              *rheology_,
              contact_
          )
    {
        const auto places = slabPlaces(layers);
        const double K = rheology_->elastic().K();
        grainStore& g = dynamics.grains;
        g.resize(static_cast<int>(places.size()));
        for (int i = 0; i < g.size(); ++i)
        {
            const vector x = places[static_cast<std::size_t>(i)];
            // the stress of the lowest layer is that of the ground
            const double p = 1300 * gravity * (layers * dx - x.z() + 0.5 * dx);
            set(g.x, i, x);
            set(g.U, i, U);
            for (const std::size_t c : {0, 3, 5})
            {
                g.sigma[c][i] = -p;
            }
            g.rhoRef[i] = 1300;
            g.rho[i] = 1300 * (1 + p / K);
            g.mass[i] = 1300 * dx * dx * dx;
            g.id[i] = i;
            g.zone[i] = 0;
        }
        dynamics.rates(1e-12, 0);
    }
};

} // namespace


TEST_CASE("ground laws: uniform flow comes to the speed of the formula")
{
    const double h = 0.8, slope = 0.3;
    const double sine = std::sin(slope), cosine = std::cos(slope);
    struct flow
    {
        std::string zone;
        double speed;
    };
    const flow flows[] = {
        {"Voellmy; waterFrictionCoeffs { mu 0.1; xi 450; }",
         std::sqrt(450 * h * (sine - 0.1 * cosine))},
        {"Voellmy; waterFrictionCoeffs { mu 0.2; ru 0.75; xi 450; }",
         std::sqrt(450 * h * (sine - 0.05 * cosine))},
        {"Manning; waterFrictionCoeffs { n 0.05; }",
         std::pow(h, 2.0 / 3) * std::sqrt(sine) / 0.05},
        {"laminar; waterFrictionCoeffs { viscosity 120; profile "
         "depthAveraged; }",
         1000 * gravity * sine * h * h / (3 * 120)},
        // of a particle at 0.05 in a plug: tau = mu u/d
        {"laminar; waterFrictionCoeffs { viscosity 120; profile "
         "wallDistance; }",
         1000 * gravity * sine * h * 0.05 / 120},
    };
    for (const flow& f : flows)
    {
        const auto law = lawOfWater(f.zone);
        for (const double dt : {0.01, 1.0, 1e4})
        {
            INFO(f.zone << ", dt " << dt);
            bool reversed = false;
            const double u = terminal(*law, h, slope, dt, reversed);
            CHECK(u == Approx(f.speed).epsilon(1e-9));
            CHECK(!reversed);
        }
    }
    // a slope below mu: it stops and stays
    bool reversed = false;
    const auto held =
        lawOfWater("Voellmy; waterFrictionCoeffs { mu 0.4; xi 9; }");
    CHECK(terminal(*held, h, 0.3, 0.1, reversed) == 0);
    CHECK(!reversed);
}


TEST_CASE("ground laws: a step of any length slows and never turns")
{
    randomNumbers random(71);
    for (int k = 0; k < 10000; ++k)
    {
        const auto decade = [&](double low, double high)
        { return std::pow(10.0, random(low, high)); };
        const double w = decade(-12, 3), dt = decade(-9, 6);
        const double linear = decade(-9, 9), quadratic = decade(-9, 9);
        const double u = slowed(w, 1 + dt * linear, dt * quadratic);
        REQUIRE(u >= 0);
        REQUIRE(u <= w);
        // the implicit step itself
        CHECK(
            u + dt * (linear * u + quadratic * u * u)
            == Approx(w).epsilon(1e-12)
        );
    }
}


TEST_CASE("ground laws: the depth is that over the particle, at least a layer")
{
    for (const double d : {0.01, 0.05, 0.4})
    {
        CHECK(placeIn(0.8, d, 0.5, 1000).depth() == Approx(0.8));
        CHECK(placeIn(0.8, d, 0.5, 1900).depth() == Approx(0.8));
    }
    groundPlace splash = placeIn(0.8, 0.003, 0.5, 1000);
    splash.normalStress = 0;
    CHECK(splash.depth() == 0.01);
}


TEST_CASE("ground laws: traction on water that slides")
{
    const double u = 3, n = 0.04, mu = 200, rho = 1000;
    struct wanted
    {
        std::string zone;
        std::function<double(double)> tau; // of the depth
    };
    const wanted all[] = {
        {"waterFriction Voellmy; waterFrictionCoeffs { mu 0; xi 500; }",
         [&](double) { return rho * gravity * u * u / 500; }},
        {"waterFriction Voellmy; waterFrictionCoeffs { mu 0.2; xi 500; }",
         [&](double h) { return rho * gravity * (0.2 * h + u * u / 500); }},
        {"waterFriction Manning; waterFrictionCoeffs { n 0.04; }",
         [&](double h)
         { return rho * gravity * n * n * u * u / std::cbrt(h); }},
        {"waterFriction laminar; waterFrictionCoeffs { viscosity 200; "
         "profile depthAveraged; }",
         [&](double h) { return 3 * mu * u / h; }},
    };
    for (const wanted& w : all)
    {
        for (const int layers : {2, 4, 7})
        {
            INFO(w.zone << ", " << layers << " layers");
            waterSlab slab(w.zone, layers, u);
            const vector t = traction(slab.dynamics);
            // N over a lattice at rest is off by its discrete pressure
            CHECK(t.x() == Approx(w.tau(layers * dx)).epsilon(0.02));
            CHECK(mag(t - vector(t.x(), 0, 0)) < 1e-9 * mag(t));
        }
        // one layer has less of the kernel over the ground
        waterSlab thin(w.zone, 1, u);
        const double ratio = traction(thin.dynamics).x() / w.tau(dx);
        CHECK(ratio > 0.9);
        CHECK(ratio < 1.01);
    }
    waterSlab smooth("waterFriction freeSlip;", 4, u);
    CHECK(mag(traction(smooth.dynamics)) == 0);
}


TEST_CASE("ground laws: traction on grains that slide")
{
    const double u = 2, rho = 1300;
    const vector along(0.6 * u, -0.8 * u, 0);
    struct wanted
    {
        std::string zone;
        std::function<double(double)> tau; // of the depth
    };
    const wanted all[] = {
        {"friction Voellmy; mu 0; xi 300;",
         [&](double) { return rho * gravity * u * u / 300; }},
        {"friction laminar; viscosity 90; profile depthAveraged;",
         [&](double h) { return 3 * 90 * u / h; }},
        {"friction none;", [&](double) { return 0.0; }},
    };
    for (const wanted& w : all)
    {
        for (const int layers : {2, 4, 7})
        {
            INFO(w.zone << ", " << layers << " layers");
            grainSlab slab("friction none;", w.zone, layers, along);
            const vector t = traction(slab.dynamics);
            CHECK((t & along) / u == Approx(w.tau(layers * dx)).epsilon(0.01));
            CHECK(mag(t ^ along) <= 1e-9 * u * mag(t));
        }
    }
    // dry friction beside it, on the normal force that Coulomb friction has
    const std::string dry = "mu 0.3; ru 0.2;", none = "friction none;";
    grainSlab both(none, "friction Voellmy; xi 300; " + dry, 4, along);
    grainSlab plain(none, "friction Coulomb; " + dry, 4, along);
    grainSlab turbulent(none, "friction Voellmy; mu 0; xi 300;", 4, along);
    const vector sum = traction(plain.dynamics) + traction(turbulent.dynamics);
    CHECK(mag(traction(both.dynamics) - sum) < 1e-6 * mag(sum));
    CHECK(mag(traction(plain.dynamics)) > 0);
}


TEST_CASE("ground laws: noSlip stops the grains next to the ground alone")
{
    grainSlab slab("friction none;", "friction noSlip;", 3, vector(5, -4, 0));
    const vector before = slab.dynamics.energy().momentum;
    slab.dynamics.kick(1e-7);
    const grainStore& g = slab.dynamics.grains;
    for (int i = 0; i < g.size(); ++i)
    {
        const vector U = at(g.U, i);
        const double speed = std::hypot(U.x(), U.y());
        if (g.x[2][i] < dx)
        {
            CHECK(speed < 1e-12);
        }
        else
        {
            CHECK(speed == Approx(std::sqrt(41.0)).epsilon(1e-3));
        }
    }
    // the ledger has the work and the impulse
    const double third = 0.5 * 41 * 1300 * area * dx;
    CHECK(slab.dynamics.ledger.friction == Approx(third).epsilon(1e-3));
    CHECK(
        mag(slab.dynamics.ledger.frictionImpulse + before / 3)
        < 1e-3 * mag(before)
    );
}


TEST_CASE("ground laws: each zone has its own, by the nearest ground")
{
    grainSlab slab(
        "friction Voellmy; mu 0; xi 1;",
        "friction freeSlip;",
        2,
        vector(1, 0, 0),
        across * dx / 2
    );
    slab.dynamics.kick(1e-3);
    const grainStore& g = slab.dynamics.grains;
    for (int i = 0; i < g.size(); ++i)
    {
        const bool left = g.x[0][i] < across * dx / 2;
        CHECK((g.U[0][i] < 1 - 1e-6) == left);
    }
}


TEST_CASE("ground laws: scenes without them have nothing of them")
{
    const vector U(1, 0, 0);
    grainSlab plain("friction none;", "friction Coulomb; mu 0.3;", 3, U);
    grainSlab rough("friction none;", "friction Voellmy; mu 0.3; xi 9;", 3, U);
    CHECK(rough.dynamics.bytes() > plain.dynamics.bytes());

    auto bed = floors(0);
    const sceneProperties scene = periodicScene();
    groundContact contact(
        *bed,
        dictOf("zones { left { friction Coulomb; mu 1; waterFriction noSlip; } "
               "right { friction none; } }"),
        dx,
        4 * dx,
        0,
        vector(0, 1, 0)
    );
    CHECK(!groundResistance::forPhase(contact, scene, &groundZone::grains));
    CHECK(!groundResistance::forPhase(contact, scene, &groundZone::water));
    CHECK(contact.anyStick());
}
