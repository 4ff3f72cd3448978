// SPDX-License-Identifier: GPL-3.0-or-later
// Elastic grains with mu(I) yield, at single points: limits and steady shear
// from published numbers, the law itself, rotation, separation, cohesion, and
// the cones that an angle of friction is mapped to.

#include <catch2/catch.hpp>

#include "frictionMapping.H"
#include "granularRheology.H"
#include "sampleCase.H"
#include "sampleGrains.H"

#include "StringStream.H"

#include <array>
#include <cmath>
#include <sstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

//- Material and stiffness of a test
struct material
{
    double muS = 0.3839, mu2 = 0.6494; // Gao et al. (2023)
    double cohesion = 0, d = 0.005, rho = 2600, E = 1e7, nu = 0.3;
    const char* mapping = "tanPhi";
    std::string number = "I0 0.28;", dilatancy = "none;";
    const char* rheology = "muI";

    double K() const { return E / (3 * (1 - 2 * nu)); }
    double G() const { return E / (2 * (1 + nu)); }
};


//- One grain and its rheology
class testGrain
{
    autoPtr<granularRheology> rheology_;
    double mass_ = 2;
    double L_[9] = {}, sigma_[6] = {};
    double I_ = 0;

    static double degrees(double x) { return x * 3.14159265358979323846 / 180; }

public:
    material m;
    double rho = 1300, rhoRef = 1300;
    rheologyLosses lost;

    explicit testGrain(const material& given = material()) : m(given)
    {
        std::ostringstream text;
        text.precision(17);
        text << "rho " << m.rho << "; diameter " << m.d << "; rheology "
             << m.rheology << "; " << m.rheology << "Coeffs { muS " << m.muS
             << "; mu2 " << m.mu2 << "; " << m.number << " cohesion "
             << m.cohesion << "; frictionMapping " << m.mapping
             << "; dilatancy " << m.dilatancy << " nu " << m.nu << "; E " << m.E
             << "; }";
        const dictionary phase(IStringStream(text.str())());
        const dictionary& coeffs =
            phase.subDict(std::string(m.rheology) + "Coeffs");
        rheology_ =
            granularRheology::New(phase, elasticity(coeffs, {1300, 10, 1}));
    }

    //- Friction given as angles
    static material angles(double low, double high, double I0)
    {
        material m;
        m.muS = std::tan(degrees(low));
        m.mu2 = std::tan(degrees(high));
        std::ostringstream number;
        number.precision(17);
        number << "I0 " << I0 << ";";
        m.number = number.str();
        return m;
    }

    //- At rest under p
    void press(double p)
    {
        rho = rhoRef * (1 + p / m.K());
        for (const std::size_t c : {0, 3, 5})
        {
            sigma_[c] = -p;
        }
    }

    void setSigma(const symmTensor& s)
    {
        for (direction c = 0; c < 6; ++c)
        {
            sigma_[c] = s[c];
        }
    }

    void step(const tensor& L, double dt)
    {
        for (direction c = 0; c < 9; ++c)
        {
            L_[c] = L[c];
        }
        grainArrays arrays = {};
        arrays.n = 1;
        for (std::size_t c = 0; c < 9; ++c)
        {
            arrays.L[c] = L_ + c;
        }
        for (std::size_t c = 0; c < 6; ++c)
        {
            arrays.sigma[c] = sigma_ + c;
        }
        arrays.rho = &rho;
        arrays.rhoRef = &rhoRef;
        arrays.mass = &mass_;
        arrays.inertialNumber = &I_;
        lost = rheology_->correct(arrays, dt);
    }

    //- In tension t, no shear
    void pull(double t) { press(-t); }

    //- Plane shear at a rate until nothing changes
    void shear(double rate, int steps, double strain)
    {
        const tensor L(0, 0, rate, 0, 0, 0, 0, 0, 0);
        for (int k = 0; k < steps; ++k)
        {
            step(L, strain / rate);
        }
    }

    symmTensor sigma() const
    {
        symmTensor s;
        for (direction c = 0; c < 6; ++c)
        {
            s[c] = sigma_[c];
        }
        return s;
    }

    //- Plane shear and, at the end, the volume at which p is what it was
    void shearAtPressure(double rate, double dt, double p)
    {
        const double wanted = rhoRef * (1 + p / m.K());
        // rho <- rho (1 - e/2)/(1 + e/2)
        const double e = 2 * (rho - wanted) / (rho + wanted);
        tensor L(0, 0, rate, 0, 0, 0, 0, 0, 0);
        L += e / (3 * dt) * tensor::I;
        step(L, dt);
    }

    grainPoint point() const
    {
        grainPoint g = {};
        g.sigma = {
            sigma_[0], sigma_[1], sigma_[2], sigma_[3], sigma_[4], sigma_[5]};
        g.rho = rho;
        g.rhoRef = rhoRef;
        g.mass = mass_;
        return g;
    }

    double stored() const { return rheology_->storedEnergy(point()); }

    bool yields() const { return rheology_->yields(point()); }

    double p() const { return -tr(sigma()) / 3; }
    symmTensor deviator() const { return dev(sigma()); }
    double rootJ2() const { return std::sqrt(0.5 * magSqr(deviator())); }
    double I() const { return I_; }
    double mass() const { return mass_; }
};


//- Rate of shear for an inertial number, by its definition
double rateOf(double I, double p, const material& m)
{
    return I / m.d * std::sqrt(p / m.rho);
}

} // namespace


TEST_CASE("muI: friction tan 21 when quasi-static, tan 33 when rapid")
{
    // Gao et al. (2023): 21 and 33 degrees; the stress is of the material, the
    // shear of any size
    for (const double p : {50.0, 5000.0})
    {
        testGrain slow(testGrain::angles(21, 33, 0.28));
        slow.press(p);
        slow.shear(rateOf(1e-8, p, slow.m), 400, 1e-5);
        CHECK(slow.p() == Approx(p).epsilon(1e-9));
        CHECK(slow.rootJ2() / p == Approx(0.38386).epsilon(2e-5));
        CHECK(slow.yields());

        testGrain rapid(testGrain::angles(21, 33, 0.28));
        rapid.press(p);
        rapid.shear(rateOf(1e7, p, rapid.m), 400, 1e-4);
        CHECK(rapid.rootJ2() / p == Approx(0.64941).epsilon(2e-5));
        CHECK(rapid.yields());
    }
}


TEST_CASE(
    "muI: simple shear at constant pressure, published pairs of angle and I"
)
{
    struct pair
    {
        double angle, I;
    };
    struct law
    {
        const char* name;
        material m;
        std::vector<pair> pairs;
    };
    // slopes on which a layer flows uniformly, tan(angle) = mu(I)
    material sand;
    sand.muS = 0.38;
    sand.mu2 = 0.64;
    sand.number = "I0 0.3;";
    const law laws[] = {
        {"Gao et al. (2023)",
         testGrain::angles(21, 33, 0.28),
         {{22, 0.02301},
          {24, 0.08415},
          {26, 0.17989},
          {28, 0.35172},
          {30, 0.75185}}},
        {"Jop et al. (2006), glass beads",
         testGrain::angles(20.9, 32.76, 0.279),
         {{22, 0.02582}, {24, 0.08918}, {26, 0.18967}, {28, 0.37408}}},
        {"sedFoam 1DAvalancheMuI", sand, {{26, 0.21226}}},
    };
    for (const law& l : laws)
    {
        for (const pair& x : l.pairs)
        {
            INFO(l.name << ", " << x.angle << " degrees");
            material m = l.m;
            m.d = 5.3e-4;
            const double p = 800;
            testGrain g(m);
            g.press(p);
            g.shear(rateOf(x.I, p, m), 3000, 1e-5);
            const double wanted =
                std::tan(x.angle * 3.14159265358979323846 / 180);
            // I is printed to five decimals
            CHECK(-g.sigma().xz() < 0);
            CHECK(g.sigma().xz() / p == Approx(wanted).epsilon(3e-5));
            CHECK(g.I() == Approx(x.I).epsilon(1e-6));
            CHECK(g.p() == Approx(p).epsilon(1e-9));
        }
    }
}


TEST_CASE("muI: elastic below yield, as Hooke's law says")
{
    testGrain g;
    const double p = 1000;
    g.press(p);
    const double strain = 1e-6;
    g.step(tensor(0, 0, 1, 0, 0, 0, 0, 0, 0), strain);
    CHECK(g.sigma().xz() == Approx(g.m.G() * strain).epsilon(1e-6));
    CHECK(g.lost.plastic == 0);
    CHECK(g.lost.separation == 0);
    CHECK(!g.yields());
    // compression by the bulk modulus
    g.step(-tensor::I / 3, strain);
    CHECK(g.p() == Approx(p + g.m.K() * strain).epsilon(1e-6));
    CHECK(g.lost.plastic == 0);
}


TEST_CASE("muI: a rigid rotation turns the stress and keeps its size")
{
    randomNumbers random(61);
    for (const double angle : {1e-3, 0.05, 0.7, 3.0})
    {
        testGrain g;
        const double p = 1000;
        g.press(p);
        const symmTensor s = dev(symm(random.anyTensor(150)));
        g.setSigma(s - p * symmTensor(symmTensor::I));
        const double size = g.rootJ2();
        REQUIRE(size < 0.3 * p);
        vector axis = random.inCube(1);
        axis /= mag(axis);
        const tensor L(
            0,
            -axis.z(),
            axis.y(),
            axis.z(),
            0,
            -axis.x(),
            -axis.y(),
            axis.x(),
            0
        );
        const int steps = 1000;
        for (int k = 0; k < steps; ++k)
        {
            g.step(L, angle);
        }
        CHECK(g.rootJ2() == Approx(size).epsilon(1e-12));
        CHECK(g.p() == Approx(p).epsilon(1e-12));
        CHECK(g.lost.plastic == 0);

        // Rodrigues' formula; a step turns by 2 atan(angle/2)
        const double turn = steps * 2 * std::atan(angle / 2);
        const tensor squared = sqr(axis) - tensor::I;
        const tensor Q =
            tensor::I + std::sin(turn) * L + (1 - std::cos(turn)) * squared;
        CHECK(mag(g.deviator() - symm(Q & s & Q.T())) < 1e-10 * size);
    }
}


TEST_CASE("muI: separated grains carry no stress")
{
    randomNumbers random(62);
    for (int k = 0; k < 100; ++k)
    {
        testGrain g;
        g.press(500);
        g.setSigma(
            symm(random.anyTensor(100)) - 500 * symmTensor(symmTensor::I)
        );
        // opened far beyond what pressure holds together, and sheared
        const tensor L = random.anyTensor(2) + 5 * tensor::I;
        g.step(L, 1e-2);
        CHECK(mag(g.sigma()) == 0);
        CHECK(g.I() == 0);
        for (int n = 0; n < 50; ++n)
        {
            g.step(L, 1e-2);
        }
        CHECK(mag(g.sigma()) == 0);
        // the volume of a grain stays bounded
        CHECK(g.rho >= 0.8 * g.rhoRef);
        CHECK(std::isfinite(g.rho));

        // and the stress comes back only when they meet again
        g.step(-0.1 * tensor::I, 1e-3);
        CHECK(mag(g.sigma()) == 0);
        g.step(-10 * tensor::I, 1e-2);
        CHECK(g.p() > 0);
    }
}


namespace
{

//- One step of shear from rest under p
struct firstStep
{
    material m;
    double p, dt, rate;
};

//- What came of how many
struct outcomes
{
    int separated = 0, elastic = 0, yielded = 0;
};


// The law itself, not its closed form: with gammaDot the plastic shear rate,
//     S = mu(I) p + c, I = gammaDot d sqrt(rho_p/p)
void checkLaw(const firstStep& s, outcomes& all)
{
    const material& m = s.m;
    testGrain g(m);
    g.press(s.p);
    g.step(tensor(0, 0, s.rate, 0, 0, 0, 0, 0, 0), s.dt);

    // what the density holds of p, to its digits; nothing but xz is sheared,
    // and the diagonal has only the digits of p
    const double p = g.p(), S = mag(g.sigma().xz());
    const double S_tr = m.G() * s.dt * s.rate;
    REQUIRE(std::isfinite(S));
    REQUIRE(std::isfinite(p));
    REQUIRE(std::isfinite(g.lost.plastic));
    CHECK(p >= 0);
    CHECK(std::abs(p - s.p) < 1e-15 * m.K() + 1e-12 * s.p);
    CHECK(S <= m.mu2 * p * (1 + 1e-12));
    if (p <= 0)
    {
        ++all.separated;
        CHECK(S == 0);
        return;
    }
    if (S_tr <= m.muS * p)
    {
        ++all.elastic;
        CHECK(S == Approx(S_tr).epsilon(1e-12));
        CHECK(g.lost.plastic == 0);
        return;
    }
    ++all.yielded;
    CHECK(S >= m.muS * p * (1 - 1e-12));
    CHECK(g.lost.plastic >= 0);
    const double I = (S_tr - S) / (m.G() * s.dt) * m.d * std::sqrt(m.rho / p);
    const double mu = m.muS + (m.mu2 - m.muS) * I / (0.28 + I);
    // S_tr - S loses the digits that the two share
    CHECK(S == Approx(mu * p).epsilon(1e-12 + 1e-15 * S_tr / (S_tr - S)));
}

//- One of the values; digit by digit, a number chooses from several lists
double pick(std::initializer_list<double> values, std::size_t& number)
{
    const double chosen = values.begin()[number % values.size()];
    number /= values.size();
    return chosen;
}

} // namespace


TEST_CASE("muI: no violation of the law over all pressures and stiffnesses")
{
    outcomes all;
    for (std::size_t k = 0; k < 8 * 5 * 4 * 3 * 4; ++k)
    {
        std::size_t number = k;
        firstStep s;
        s.p = pick({1e-12, 1e-9, 1e-6, 1e-3, 1, 1e3, 1e6, 1e9}, number);
        s.m.E = pick({1e4, 1e6, 1e8, 1e10, 1e12}, number);
        s.m.d = pick({1e-6, 1e-3, 0.1, 10}, number);
        s.dt = pick({1e-8, 1e-5, 1e-3}, number);
        s.rate = pick({1e-6, 1e-2, 1e2, 1e5}, number);
        // more pressure would compress it by a tenth and beyond
        if (s.p <= 0.1 * s.m.E)
        {
            checkLaw(s, all);
        }
    }
    CHECK(all.yielded > 300);
    CHECK(all.elastic > 300);
    CHECK(all.separated > 20);
    CHECK(all.yielded + all.elastic + all.separated > 1500);
}


TEST_CASE("muI: cohesion holds shear and a tension of c over mu_s")
{
    material m;
    m.cohesion = 300;
    testGrain g(m);
    g.shear(1e-6, 2000, 1e-5);
    CHECK(g.p() == Approx(0).margin(1e-9));
    CHECK(g.rootJ2() == Approx(m.cohesion).epsilon(1e-3));

    testGrain pulled(m);
    for (int k = 0; k < 1000; ++k)
    {
        pulled.step(tensor::I / 3, 1e-6);
    }
    CHECK(-pulled.p() == Approx(m.cohesion / m.muS).epsilon(1e-9));
    CHECK(pulled.rootJ2() < 1e-9 * m.cohesion);
}


TEST_CASE("muI: strength with cohesion, S = mu p + c in pressure and tension")
{
    material m;
    m.cohesion = 300;
    for (const double p : {-700.0, -300.0, -10.0, 0.0, 10.0, 300.0, 5000.0})
    {
        INFO("p " << p);
        // of the order of what the density holds of p
        const double digits = 1e-8;
        // there is no inertial number in tension: any rate is slow
        const double scale = std::max(p, 300.0);
        testGrain slow(m);
        slow.press(p);
        slow.shear(rateOf(1e-8, scale, m), 400, 1e-5);
        CHECK(slow.p() == Approx(p).margin(digits));
        CHECK(slow.sigma().xz() == Approx(m.muS * p + 300).epsilon(2e-5));

        testGrain rapid(m);
        rapid.press(p);
        rapid.shear(rateOf(1e7, scale, m), 400, 1e-4);
        const double limit = (p > 0 ? m.mu2 : m.muS) * p + 300;
        CHECK(rapid.sigma().xz() == Approx(limit).epsilon(2e-5));
        CHECK(rapid.p() == Approx(p).margin(digits));
        CHECK(rapid.lost.separation == 0);
    }
}


TEST_CASE("muI: at the apex nothing is left but the tension c/mu_s")
{
    material m;
    m.cohesion = 300;
    const double apex = 300 / 0.3839; // 781.45 Pa
    testGrain g(m);
    g.press(1000);
    g.shear(1, 10, 1e-5);
    REQUIRE(g.rootJ2() > 0);
    g.step(tensor::I, 1e-3);
    CHECK(-g.p() == Approx(apex).epsilon(1e-12));
    CHECK(g.rootJ2() < 1e-9);
    CHECK(g.lost.plastic == 0);
    CHECK(g.lost.separation > 0);
    CHECK(g.I() == 0);
    g.shear(1, 10, 1e-5);
    CHECK(g.rootJ2() < 1e-9);
    // it opens further at the same tension, and closes again
    g.step(tensor::I, 1e-3);
    CHECK(-g.p() == Approx(apex).epsilon(1e-12));
    g.step(-tensor::I, 3e-3);
    CHECK(g.p() > 0);
}


TEST_CASE("muI: the work of shear in tension is booked as plastic")
{
    material m;
    m.cohesion = 300;
    testGrain g(m);
    g.pull(400);
    double work = 0, lost = 0;
    for (int k = 0; k < 8000; ++k)
    {
        // from the second cycle on the stress comes back to where it was
        const double L = (k / 1000) % 2 == 0 ? 1 : -1, dt = 1e-6;
        const symmTensor old = g.sigma();
        g.step(tensor(0, 0, L, 0, 0, 0, 0, 0, 0), dt);
        if (k >= 4000)
        {
            const double mean = 0.5 * (old.xz() + g.sigma().xz());
            work += mean * L * dt * g.mass() / g.rho;
            lost += g.lost.plastic;
        }
    }
    // 4000 steps of 1e-6 at 300 - 0.3839 400 = 146.44 Pa, less the elastic part
    // of the turns
    CHECK(work < 4e-3 * 146.44 * g.mass() / g.rho);
    CHECK(work > 0.9 * 4e-3 * 146.44 * g.mass() / g.rho);
    CHECK(lost == Approx(work).epsilon(1e-4));
}


namespace
{

//- Mohr and Coulomb: principal stresses that yield at an angle, with cohesion
struct mohrCircle
{
    double phi, c;

    //- Radius where the mean of the largest and smallest is M
    double radius(double M) const
    {
        return M * std::sin(phi) + c * std::cos(phi);
    }
};

//- How far sqrt(J2) is off the cone of the mapping, over p
double offCone(const char* name, double rootJ2, double p, double phi, double c)
{
    const std::string text = std::string("frictionMapping ") + name + ";";
    const auto cone = frictionMapping::New(dictionary(IStringStream(text)()));
    const double mu = std::tan(phi);
    return (rootJ2 - cone->slope(mu) * p - cone->strength(c, mu)) / p;
}

} // namespace


TEST_CASE("frictionMapping: each meets Mohr and Coulomb in the state it is for")
{
    for (const double angle : {5.0, 21.0, 30.0, 45.0, 70.0})
    {
        const double phi = angle * 3.14159265358979323846 / 180;
        for (const double c : {0.0, 120.0, 4000.0})
        {
            INFO(angle << " degrees, c " << c);
            const mohrCircle yield = {phi, c};
            const double M = 1000, r = yield.radius(M);

            // the stress between is the mean: plane flow of constant volume
            CHECK(std::abs(offCone("sinPhi", r, M, phi, c)) < 1e-14);

            // s2 = s3, pressed along the third
            const double rootJ2 = 2 * r / std::sqrt(3.0);
            const double pressed = (M + r + 2 * (M - r)) / 3;
            CHECK(
                std::abs(offCone("compressionCone", rootJ2, pressed, phi, c))
                < 1e-14
            );

            // associated flow with no rate out of the plane: the deviator
            // there is 2 alpha sqrt(J2)/3, alpha = sin/sqrt(3 + sin^2)
            const double sine = std::sin(phi);
            const double alpha =
                std::sqrt(3.0) * sine / std::sqrt(3 + sine * sine);
            const double S = r / std::sqrt(1 - alpha * alpha / 3);
            const double p = M + alpha * S / 3;
            CHECK(std::abs(offCone("planeStrain", S, p, phi, c)) < 1e-14);

            // the plane of tau = c + p tan(phi) itself
            CHECK(
                std::abs(offCone("tanPhi", c + M * std::tan(phi), M, phi, c))
                < 1e-14
            );
        }
    }
}


TEST_CASE("muI: the same 30 degrees on four cones, slow and rapid")
{
    struct mapped
    {
        const char* name;
        double slow, rapid; // sqrt(J2)/p of 30 and 40 degrees
    };
    const mapped cones[] = {
        {"planeStrain", 0.480384, 0.602627},
        {"sinPhi", 0.5, 0.642788},
        {"tanPhi", 0.577350, 0.839100},
        {"compressionCone", 0.692820, 0.944625},
    };
    for (const mapped& cone : cones)
    {
        INFO(cone.name);
        material m = testGrain::angles(30, 40, 0.28);
        m.mapping = cone.name;
        m.cohesion = 200;
        const double p = 800;
        const double k = 200 * cone.slow / 0.577350;
        testGrain slow(m);
        slow.press(p);
        slow.shear(rateOf(1e-8, p, m), 400, 1e-5);
        CHECK(slow.rootJ2() == Approx(cone.slow * p + k).epsilon(3e-6));
        testGrain rapid(m);
        rapid.press(p);
        rapid.shear(rateOf(1e7, p, m), 400, 1e-4);
        CHECK(rapid.rootJ2() == Approx(cone.rapid * p + k).epsilon(3e-6));
        // the apex is that of Mohr and Coulomb on every cone
        testGrain pulled(m);
        pulled.pull(1e4);
        pulled.shear(1e-3, 10, 1e-5);
        CHECK(-pulled.p() == Approx(200 / 0.577350).epsilon(1e-6));
    }
}


TEST_CASE("muI: the work of a closed cycle is what is booked as lost")
{
    // shear to and fro beyond yield at constant volume: the stress comes back
    // to where it was, its work has gone into plastic flow
    testGrain g;
    g.press(1000);
    const double rate = 1, dt = 1e-6;
    const auto cycle = [&](double& work, double& lost)
    {
        work = lost = 0;
        for (int k = 0; k < 4000; ++k)
        {
            const double L = (k / 1000) % 2 == 0 ? rate : -rate;
            const symmTensor old = g.sigma();
            g.step(tensor(0, 0, L, 0, 0, 0, 0, 0, 0), dt);
            const double mean = 0.5 * (old.xz() + g.sigma().xz());
            work += mean * L * dt * g.mass() / g.rho;
            lost += g.lost.plastic;
        }
    };
    double work = 0, lost = 0;
    cycle(work, lost);
    cycle(work, lost);
    CHECK(work > 0);
    CHECK(lost == Approx(work).epsilon(1e-4));
    CHECK(g.lost.separation == 0);
}


TEST_CASE("muJ: published friction of spheres in viscous flow, any rate")
{
    // Boyer et al. (2011), contact part: 0.32 + 0.38/(1 + 0.005/J)
    struct pair
    {
        double J, mu;
    };
    for (const pair x :
         {pair{5e-5, 0.32 + 0.38 / 101}, pair{5e-3, 0.51}, pair{0.045, 0.662}})
    {
        material m;
        m.rheology = "muJ";
        m.number = "J0 0.005; fluidViscosity 2.5;";
        m.muS = 0.32;
        m.mu2 = 0.7;
        const double p = 300;
        testGrain g(m);
        g.press(p);
        g.shear(x.J * p / 2.5, 20000, 1e-5);
        CHECK(g.sigma().xz() / p == Approx(x.mu).epsilon(1e-5));
        CHECK(g.I() == Approx(x.J).epsilon(1e-6));
    }
}


TEST_CASE("dilatancy: at constant pressure packing goes to that of steady shear"
)
{
    // phi of slow shear 0.58, less 0.2 I
    const double p = 500, strain = 2e-4;
    for (const double start : {0.5, 0.54, 0.62})
    {
        for (const double I : {1e-6, 0.1})
        {
            material m;
            m.dilatancy = "linear; linearCoeffs { phiC 0.58; slope 0.2; "
                          "rate 4; }";
            testGrain g(m);
            const double rate = rateOf(I, p, m);
            g.rhoRef = start * 2600;
            g.press(p);
            // until it yields, and then by a strain of 0.1
            while (g.rhoRef == start * 2600)
            {
                g.shearAtPressure(rate, strain / rate, p);
            }
            const double end = 0.58 - 0.2 * I;
            // phi/(phi - end) d phi = -4 phi end dgamma, logistic in the strain
            const double first = g.rhoRef / 2600;
            for (int k = 0; k < 500; ++k)
            {
                g.shearAtPressure(rate, strain / rate, p);
            }
            const double grown = std::exp(-4 * end * 500 * strain);
            const double phi = end / (1 - (first - end) / first * grown);
            CHECK(g.rhoRef / 2600 == Approx(phi).epsilon(2e-4));
            CHECK((phi > start) == (start < end));
            CHECK(g.p() == Approx(p).epsilon(2e-3));
            for (int k = 0; k < 40000; ++k)
            {
                g.shearAtPressure(rate, strain / rate, p);
            }
            CHECK(g.rhoRef / 2600 == Approx(end).epsilon(1e-5));
        }
    }
}


TEST_CASE("dilatancy: at constant volume loose grains lose their pressure")
{
    const double strain = 3e-5;
    const auto sheared = [&](double phi, double rate, const char* law)
    {
        material m;
        m.dilatancy = law;
        testGrain g(m);
        g.rhoRef = phi * 2600;
        g.press(500);
        const double volume = g.rho;
        g.shear(rate, 200000, strain);
        CHECK(g.rho == Approx(volume).epsilon(1e-12));
        return g.p();
    };
    const char* linear =
        "linear; linearCoeffs { phiC 0.58; slope 0.2; rate 4; }";
    // what is left is the pressure at which phi is that of steady shear:
    // I = 0.03/0.2, p = rho_p (rate d/I)^2
    CHECK(
        sheared(0.55, 10, linear)
        == Approx(2600 * std::pow(10 * 0.005 / 0.15, 2)).epsilon(0.01)
    );
    // dense ones press as their density says at phi of steady shear
    CHECK(
        sheared(0.59, 0.01, linear)
        == Approx(1e7 / 1.2 * (0.59 / 0.58 - 1) + 500 * 0.59 / 0.58)
               .epsilon(1e-3)
    );
    CHECK(sheared(0.55, 10, "none;") == Approx(500).epsilon(1e-6));
}


TEST_CASE("dilatancy: Boyer et al. (2011), 0.585/(1 + sqrt(J)) in steady shear")
{
    material m;
    m.rheology = "muJ";
    m.number = "J0 0.005; fluidViscosity 2.5;";
    m.dilatancy = "Boyer; BoyerCoeffs { phiC 0.585; rate 4; }";
    const double p = 300, J = 0.01;
    testGrain g(m);
    g.rhoRef = 0.6 * 2600;
    g.press(p);
    const double rate = J * p / 2.5;
    for (int k = 0; k < 30000; ++k)
    {
        g.shearAtPressure(rate, 2e-4 / rate, p);
    }
    CHECK(g.rhoRef / 2600 == Approx(0.531818).epsilon(1e-4));
}


TEST_CASE("dilatancy: what it stores comes from the work of the shear")
{
    for (const double start : {0.55, 0.6})
    {
        material m;
        m.dilatancy = "linear; linearCoeffs { phiC 0.58; slope 0.2; rate 4; }";
        testGrain g(m);
        g.rhoRef = start * 2600;
        g.press(500);
        const double before = g.stored(), rate = 1, dt = 1e-6;
        double work = 0, lost = 0;
        for (int k = 0; k < 20000; ++k)
        {
            const symmTensor old = g.sigma();
            g.step(tensor(0, 0, rate, 0, 0, 0, 0, 0, 0), dt);
            work += 0.5 * (old.xz() + g.sigma().xz()) * rate * dt * g.mass()
                  / g.rho;
            lost += g.lost.plastic;
        }
        const double change = g.stored() - before;
        CHECK(std::abs(change) > 1e-3 * work);
        CHECK(work - lost == Approx(change).epsilon(1e-3));
    }
}
