// SPDX-License-Identifier: GPL-3.0-or-later
// Contact, and the paper's boundary force: single particles against sums over
// the elements done here, steps of any length, what the ledger has of it.

#include <catch2/catch.hpp>

#include "engineLoader.H"
#include "grainDynamics.H"
#include "sampleGrains.H"
#include "sampleGround.H"
#include "waterDynamics.H"
#include "wendlandC2.H"

#include <cmath>
#include <sstream>
#include <string>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double dx = 0.1, h = 1.3 * dx, gravity = 9.81, omega = 20;
constexpr double width = 4;

//- Two slopes that meet along y at z = 0: left and right of x = 0 they rise by
//  so much a metre outwards; negative: a ridge
autoPtr<ground> slopes(double left, double right)
{
    const double L = width / 2;
    const point a(-L, -L, left * L), b(0, -L, 0), c(0, L, 0),
        d(-L, L, left * L);
    const point e(L, -L, right * L), f(L, L, right * L);
    List<corners> all;
    all.append(corners{a, b, c});
    all.append(corners{a, c, d});
    all.append(corners{b, e, f});
    all.append(corners{b, f, c});
    return groundOf(all);
}

sceneProperties sceneOf(const vector& g, bool plane)
{
    sceneProperties scene = {};
    scene.spacing = dx;
    scene.h = scene.largestH = h;
    scene.dimensions = plane ? 2 : 3;
    scene.planeThickness = plane ? 0.05 : 1;
    scene.planeNormal = vector(0, 1, 0);
    scene.g = g;
    scene.domain = boundBox(vector::uniform(-1e4), vector::uniform(1e4));
    return scene;
}

std::string text(double a)
{
    std::ostringstream s;
    s << a;
    return s.str();
}

std::string boundary(const std::string& speed, const std::string& friction)
{
    return "contact penalty; penaltyCoeffs { omega " + speed + "; } zones "
         + "{ floor { " + friction + " } }";
}

//- One grain without stress over a ground
class oneGrain
{
    autoPtr<ground> bed_;
    groundContact contact_;
    autoPtr<granularRheology> rheology_;
    schemeProperties scheme_;
    bool plane_;

    static dictionary phase()
    {
        return dictOf("rho 2600; diameter 0.01; rheology muI; muICoeffs "
                      "{ muS 0.4; mu2 0.6; I0 0.3; nu 0.3; E 1e8; }");
    }

public:
    grainDynamics dynamics;

    oneGrain(
        autoPtr<ground> bed,
        const std::string& boundaryText,
        const vector& g = Zero,
        bool plane = false
    )
        : bed_(std::move(bed)), contact_(
                                    *bed_,
                                    dictOf(boundaryText),
                                    dx,
                                    2 * h + dx,
                                    plane ? 0.05 : 0,
                                    vector(0, 1, 0)
                                ),
          rheology_(granularRheology::New(
              phase(), elasticity(phase().subDict("muICoeffs"), {1300, 10, 1})
          )),
          plane_(plane), dynamics(
                             lpfPairs::loadPairEngine("auto"),
                             sceneOf(g, plane),
                             scheme_,
                             *rheology_,
                             contact_
                         )
    {
        grainStore& s = dynamics.grains;
        s.resize(1);
        for (auto& sigma : s.sigma)
        {
            sigma[0] = 0;
        }
        s.rho[0] = s.rhoRef[0] = 1300;
        s.mass[0] = 1.3;
        s.id[0] = s.zone[0] = 0;
    }

    void put(const vector& x, const vector& U)
    {
        set(dynamics.grains.x, 0, x);
        set(dynamics.grains.U, 0, U);
    }

    vector U() { return at(dynamics.grains.U, 0); }

    //- What is left of a velocity there after dt, without a kick
    vector after(const vector& x, const vector& start, double dt)
    {
        put(x, start);
        dynamics.rates(1e-12, 0);
        set(dynamics.grains.U, 0, start);
        dynamics.pushOffGround(dt);
        return U();
    }

    double soundSpeed() const { return rheology_->elastic().c(); }

    //- (T 4.19) over the mass and omega, by looking at all elements
    vector perOmega(const vector& x, const vector& v) const
    {
        const lpfPairs::wendlandC2 W(h, plane_ ? 2 : 3);
        const surfaceElements all =
            plane_ ? bed_->sections(0.25 * dx, {vector(0, 1, 0), 0})
                   : bed_->elements(dx);
        vector f(Zero);
        forAll (all.x, q)
        {
            const double A = mag(all.nA[q]);
            const vector n = all.nA[q] / A;
            const vector r = x - all.x[q];
            if ((v & n) < 0 && (r & n) > -0.1 * dx)
            {
                f -= 2 * h * W.value(magSqr(r)) * A / max(0.1 * dx, mag(r))
                   * (v & n) * n;
            }
        }
        return f;
    }
};

const char* const smooth = "friction none;";

} // namespace


TEST_CASE("penalty: what approaches a plane slows as the sum over its elements")
{
    const vector U(0.3, -0.2, -1.5);
    for (const bool plane : {false, true})
    {
        oneGrain grain(slopes(0.3, -0.3), boundary("20", smooth), Zero, plane);
        const vector n = vector(0.3, 0, 1) / std::sqrt(1.09);
        const vector along = U - (U & n) * n;
        for (const double d : {0.15, 0.4, 0.5, 1.1, 2.2})
        {
            INFO("distance " << d << " dx, plane strain " << plane);
            const vector x = vector(0.234, 0, -0.0702) + d * dx * n;
            const double rate = omega * (grain.perOmega(x, U) & n) / -(U & n);
            CHECK(rate > 0);
            const double dt = 1e-4;
            const vector left = grain.after(x, U, dt);
            CHECK(
                (left & n) == Approx((U & n) / (1 + dt * rate)).epsilon(1e-9)
            );
            CHECK(mag(left - (left & n) * n - along) < 1e-13);

            // many short steps: exp(-rate t)
            vector v = U;
            for (int k = 0; k < 200; ++k)
            {
                v = grain.after(x, v, 0.005 / rate);
            }
            CHECK((v & n) == Approx((U & n) * std::exp(-1.0)).epsilon(0.003));
        }
    }
}


TEST_CASE("penalty: omega auto is the speed of sound of the phase")
{
    oneGrain grain(slopes(0, 0), boundary("auto", smooth));
    const vector x(0.01, 0.02, 0.05), U(0, 0, -1);
    const double dt = 1e-6;
    const double rate = grain.soundSpeed() * grain.perOmega(x, U).z();
    CHECK(grain.after(x, U, dt).z() == Approx(-1 / (1 + dt * rate)));
}


TEST_CASE("penalty: what leaves or passes along feels nothing")
{
    oneGrain grain(slopes(0, 0), boundary("1e6", "friction Coulomb; mu 1;"));
    const vector all[] = {{1, 2, 0}, {0, 0, 3}, {-2, 1, 1e-9}};
    for (const vector& U : all)
    {
        CHECK(grain.after(vector(0, 0, 0.5 * dx), U, 1) == U);
    }
    const balance& b = grain.dynamics.ledger;
    CHECK(mag(b.wallImpulse) + mag(b.frictionImpulse) == 0);
    CHECK(b.projection == 0);
}


TEST_CASE("penalty: implicit over planes, gullies and ridges, energy never up")
{
    randomNumbers random(19);
    const double shapes[][2] = {{0, 0}, {0.6, 1.2}, {-0.5, -0.9}, {2, -0.3}};
    for (const double* s : shapes)
    {
        for (int k = 0; k < 200; ++k)
        {
            const double times = std::pow(10.0, random(-6, 6));
            oneGrain grain(
                slopes(s[0], s[1]),
                boundary(
                    text(times * h),
                    k % 2 ? smooth : "friction Coulomb; mu 0.4;"
                )
            );
            const double x = random(-dx, dx);
            const vector where(
                x, random(-dx, dx), (x < 0 ? -x * s[0] : x * s[1]) + dx
            );
            const vector U = random.inCube(3);
            const vector left = grain.after(where, U, 1);
            INFO(s[0] << " " << s[1] << ", omega dt/h " << times);
            CHECK(mag(left) <= mag(U) * (1 + 1e-14));
        }
    }
}


TEST_CASE("penalty: the step is implicit in the elements that count, too")
{
    randomNumbers random(23);
    const double shapes[][2] = {{0.6, 1.2}, {-0.5, -0.9}, {2, -0.3}};
    double worst = 0;
    for (const double* s : shapes)
    {
        oneGrain grain(slopes(s[0], s[1]), boundary("20", smooth));
        for (int k = 0; k < 200; ++k)
        {
            const double x = random(-dx, dx),
                         dt = std::pow(10.0, random(-4, -2));
            const vector where(x, 0, (x < 0 ? -x * s[0] : x * s[1]) + dx);
            // too slow for contact within the step
            const vector U = random.inCube(1e-3 * dx / dt);
            const vector left = grain.after(where, U, dt);
            const vector f = omega * grain.perOmega(where, left);
            worst = max(worst, mag(left - U - dt * f) / mag(U));
        }
    }
    CHECK(worst < 1e-9);
}


TEST_CASE("penalty: friction by the normal impulse; ledger of a step")
{
    const vector g(2, 0, -gravity);
    const double mu = 0.3, dt = 2e-4;
    oneGrain grain(
        slopes(0, 0), boundary("20", "friction Coulomb; mu 0.3;"), g
    );
    const vector start(1, -0.5, -2);
    grain.put(vector(0.03, 0.01, 0.4 * dx), start);
    grainDynamics& d = grain.dynamics;
    d.rates(dt, 0);
    d.kick(0.5 * dt);
    d.kick(0.5 * dt);
    const vector kicked = grain.U();
    d.pushOffGround(dt);
    const vector U = grain.U();
    const double m = 1.3, dv = U.z() - kicked.z();
    CHECK(dv > 0);
    const vector slip(kicked.x(), kicked.y(), 0), now(U.x(), U.y(), 0);
    CHECK(mag(slip) - mag(now) == Approx(mu * dv));
    CHECK(mag(slip ^ now) < 1e-14);

    const balance& b = d.ledger;
    CHECK(b.wallImpulse.z() == Approx(m * dv));
    CHECK(b.wallNormalImpulse == Approx(m * dv));
    CHECK(b.projectionNormalImpulse == 0);
    CHECK(
        mag(m * (U - start) - b.gravityImpulse - b.wallImpulse
            - b.frictionImpulse)
        < 1e-14
    );
    const double work = m * dt * (g & (0.5 * (start + U)));
    const double change = 0.5 * m * (magSqr(U) - magSqr(start));
    CHECK(change == Approx(work - b.projection - b.friction).epsilon(1e-12));
    CHECK(b.projection > 0);
    CHECK(b.friction > 0);
    CHECK(
        mag(at(d.grains.a, 0) - (U - start) / dt) < 1e-9 * mag(U - start) / dt
    );
}


TEST_CASE("contact: what sets a grain back does work as the leapfrog does")
{
    const vector g(0.5, 0, -gravity);
    const double dt = 2e-3, m = 1.3;
    // the penalty, which is not asked for, so that no image pushes
    oneGrain grain(slopes(0, 0), boundary("1", "friction Coulomb; mu 0.3;"), g);
    const vector x(0.03, 0.01, 0.12 * dx), start(1, -0.5, -2);
    grain.put(x, start);
    grainDynamics& d = grain.dynamics;
    const auto step = [&]()
    {
        d.rates(dt, 0);
        d.kick(0.5 * dt);
        d.kick(0.5 * dt);
        d.drift(dt, 0);
    };
    step();
    const balance& b = d.ledger;
    const vector U = grain.U(), y = at(d.grains.x, 0);
    CHECK(U.z() == 0);
    CHECK(y.z() == Approx(0.1 * dx));
    const double change = 0.5 * m * (magSqr(U) - magSqr(start));
    const double work = m * dt * (g & (0.5 * (start + U)));
    const double lifted = m * (g & (y - x - dt * U));
    CHECK(b.friction > 0);
    CHECK(
        b.projection + b.friction
        == Approx(work + lifted - change).epsilon(1e-12)
    );

    // at rest it is set back from every step, and nothing is lost
    grain.put(vector(0.03, 0.01, 0.1 * dx), Zero);
    d.ledger = balance();
    step();
    CHECK(mag(grain.U().z()) == 0);
    CHECK(b.projectionNormalImpulse == Approx(m * gravity * dt));
    CHECK(mag(b.projection) < 1e-12 * m * sqr(gravity * dt));
}

TEST_CASE("contact: in plane strain the ground goes on along the normal")
{
    autoPtr<ground> bed = slopes(0, 0);
    const point beyond(0.03, -width / 2 - 0.01, 0.05 * dx);
    for (const double thickness : {0.0, 0.05})
    {
        const groundContact contact(
            *bed,
            dictOf("zones { floor { friction none; } }"),
            dx,
            2 * h + dx,
            thickness,
            vector(0, 1, 0)
        );
        const groundHit hit = contact.signedDistance(beyond, dx);
        CHECK(hit.found == (thickness > 0));
        // the floor itself ends where it does
        CHECK(!contact.signedDistance(point(3, 0, 0.05 * dx), 2).found);
    }
}

TEST_CASE("penalty: it leaks under load, as fast as the sum says; contact holds"
)
{
    const vector g(0, 0, -gravity);
    oneGrain grain(slopes(0, 0), boundary("5", smooth), g);
    grainDynamics& d = grain.dynamics;
    grain.put(vector(0.05, 0.05, 0.5 * dx), Zero);
    const double dt = 1e-3;
    double lowest = 1, sinking = 0, there = 0;
    for (int k = 0; k < 4000; ++k)
    {
        d.rates(dt, 0);
        d.kick(dt);
        d.pushOffGround(dt);
        if (k == 100)
        {
            sinking = -grain.U().z();
            there = d.grains.x[2][0];
        }
        d.drift(dt, 0);
        lowest = min(lowest, d.grains.x[2][0]);
    }
    const vector down(0, 0, -1), where(0.05, 0.05, there);
    const double K = grain.perOmega(where, down).z();
    CHECK(sinking == Approx(gravity / (5 * K)).epsilon(0.05));
    CHECK(d.grains.x[2][0] < 0.11 * dx);
    CHECK(lowest > 0.1 * dx * (1 - 1e-9));

    const balance& b = d.ledger;
    CHECK(b.projectionNormalImpulse > 0.01 * b.wallNormalImpulse);
    const double m = 1.3, fell = 0.5 * dx - d.grains.x[2][0];
    CHECK(b.projection == Approx(m * gravity * fell).epsilon(1e-3));
    CHECK(
        mag(m * grain.U() - b.gravityImpulse - b.wallImpulse
            - b.projectionImpulse)
        < 1e-9 * mag(b.gravityImpulse)
    );
}


TEST_CASE("penalty: a particle of water, and no ground in its divergence")
{
    auto bed = slopes(0, 0);
    groundContact contact(
        *bed, dictOf(boundary("auto", smooth)), dx, 4 * dx, 0, vector(0, 1, 0)
    );
    const auto state = equationOfState::New(
        dictOf("rho 1000; TaitCoeffs { soundSpeed 30; }"), {}
    );
    const auto viscosity =
        viscosityModel::New(dictOf("NewtonianCoeffs { mu 0; }"));
    waterScheme scheme;
    scheme.groundLag = 0;
    waterDynamics d(
        lpfPairs::loadPairEngine("auto"),
        sceneOf(Zero, false),
        scheme,
        *state,
        *viscosity,
        contact
    );
    d.water.resize(1);
    d.water.mass[0] = 1;
    d.water.rho[0] = 1000;
    const vector x(0.02, 0, 0.6 * dx), U(0.5, 0.1, -1);
    set(d.water.x, 0, x);
    set(d.water.U, 0, U);
    d.rates(1e-5, 0);
    CHECK(d.water.rate[0] == 0);
    CHECK(mag(at(d.water.a, 0)) == 0);
    const double dt = 1e-4;
    d.pushOffGround(dt);
    oneGrain sums(slopes(0, 0), boundary("30", smooth));
    const double rate = 30 * sums.perOmega(x, U).z();
    const vector left = at(d.water.U, 0);
    CHECK(left.z() == Approx(-1 / (1 + dt * rate)));
    CHECK(mag(vector(left.x() - U.x(), left.y() - U.y(), 0)) < 1e-15);
    CHECK(d.ledger.projection > 0);
}
