// SPDX-License-Identifier: GPL-3.0-or-later
// Drag laws against what was published of spheres and beds: Stokes' force,
// drag coefficients, exponents of the void fraction, the pressure that a bed
// loses, the velocity at which it is fluidised. Each bound fails for a law that
// is a tenth off.

#include <catch2/catch.hpp>

#include "dragLaw.H"

#include "StringStream.H"

#include <cmath>
#include <functional>
#include <memory>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

constexpr double rho = 1000, mu = 1e-3, d = 1e-3;

autoPtr<dragLaw> lawNamed(const std::string& name)
{
    return dragLaw::New(dictionary(IStringStream("drag " + name + ";")()));
}

dragPoint pointAt(double solid)
{
    return {solid, 1 - solid, rho, mu, d};
}

//- A law as it is, or spoiled
using betaOf = std::function<double(const dragPoint&, double)>;

betaOf given(const std::string& name, double spoiled = 1)
{
    const std::shared_ptr<dragLaw> law(lawNamed(name).ptr());
    return [law, spoiled](const dragPoint& p, double u)
    { return spoiled * law->beta(p, u); };
}

//- Slip at a Re of the superficial velocity
double slipAt(double Re, const dragPoint& p)
{
    return Re * mu / (p.fluid * rho * d);
}

//- Force on one grain, of all that share a volume [N]
double forceOnGrain(const betaOf& beta, const dragPoint& p, double u)
{
    const double perVolume = 6 * p.solid / (M_PI * d * d * d);
    return beta(p, u) * u / perVolume;
}

double offStokes(const betaOf& beta)
{
    const double u = 1e-8;
    return forceOnGrain(beta, pointAt(1e-6), u) / (3 * M_PI * mu * d * u) - 1;
}

//- Largest error of the drag coefficient of a single sphere against measured
//  ones (Lapple and Shepherd, Ind. Eng. Chem. 32 (1940) 605)
double offMeasuredSpheres(const betaOf& beta)
{
    const double Re[] = {0.1, 1, 10, 100, 1000};
    const double Cd[] = {244, 26.5, 4.1, 1.07, 0.46};
    double worst = 0;
    for (int k = 0; k < 5; ++k)
    {
        const dragPoint p = pointAt(1e-6);
        const double u = slipAt(Re[k], p);
        const double area = M_PI * d * d / 4;
        const double found =
            forceOnGrain(beta, p, u) / (0.5 * rho * u * u * area);
        worst = std::max(worst, std::abs(found / Cd[k] - 1));
    }
    return worst;
}

//- d ln(beta/xi_p)/d ln(xi_f) at a given superficial Re
double exponent(const betaOf& beta, double Re, double dense)
{
    const dragPoint p = pointAt(1e-6), q = pointAt(dense);
    const double thin = beta(p, slipAt(Re, p)) / p.solid;
    const double thick = beta(q, slipAt(Re, q)) / q.solid;
    return std::log(thick / thin) / std::log(q.fluid / p.fluid);
}

//- Pressure that a bed loses per length at a superficial velocity
double pressureLost(const betaOf& beta, const dragPoint& p, double U)
{
    return beta(p, U / p.fluid) * U / (p.fluid * p.fluid);
}

//- Superficial velocity at which the lost pressure carries the grains
double fluidisation(const betaOf& beta, const dragPoint& p, double weight)
{
    double low = 0, high = 1;
    for (int k = 0; k < 100; ++k)
    {
        const double U = 0.5 * (low + high);
        (pressureLost(beta, p, U) < weight ? low : high) = U;
    }
    return low;
}

} // namespace


TEST_CASE("drag laws: creeping single spheres, 3 pi mu d u")
{
    CHECK(std::abs(offStokes(given("Stokes"))) < 1e-5);
    CHECK(std::abs(offStokes(given("WenYu"))) < 1e-4);
    CHECK(std::abs(offStokes(given("Gidaspow"))) < 0.01);
    // C_d of DallaValle: 4.8^2 for 24
    CHECK(offStokes(given("DiFelice")) == Approx(-0.04).margin(1e-3));
    CHECK(std::abs(offStokes(given("Stokes", 1.1))) > 0.05);
}


TEST_CASE("drag laws: drag coefficients of single spheres as measured")
{
    CHECK(offMeasuredSpheres(given("WenYu")) < 0.05);
    CHECK(offMeasuredSpheres(given("WenYu", 1.1)) > 0.05);
    CHECK(offMeasuredSpheres(given("WenYu", 0.9)) > 0.05);
    // by hand: Re = 100, (0.63 + 0.48)^2 = 1.2321
    const dragPoint p = pointAt(1e-6);
    const double u = slipAt(100, p);
    const double Cd = forceOnGrain(given("DiFelice"), p, u)
                    / (0.5 * rho * u * u * M_PI * d * d / 4);
    CHECK(Cd == Approx(1.2321).epsilon(1e-4));
}


TEST_CASE("drag laws: exponents of the void fraction")
{
    // on beta at the same superficial Re
    CHECK(exponent(given("WenYu"), 1e-6, 0.4) == Approx(-2.65).margin(1e-3));
    CHECK(exponent(given("WenYu"), 500, 0.4) == Approx(-2.65).margin(1e-3));
    CHECK(exponent(given("DiFelice"), 1e-6, 0.4) == Approx(-2.7).margin(1e-3));
    CHECK(
        exponent(given("DiFelice"), std::pow(10, 1.5), 0.4)
        == Approx(1 - 3.05).margin(1e-3)
    );
    CHECK(exponent(given("DiFelice"), 1e7, 0.4) == Approx(-2.7).margin(1e-3));

    // settling: beta u = xi_p xi_f (rho_p - rho) g, U = xi_f u goes with
    // xi_f^n, n = 4.65 (Richardson and Zaki 1954), for creeping grains
    const auto n = [](const betaOf& beta)
    { return 2 - exponent(beta, 1e-6, 0.3); };
    CHECK(n(given("WenYu")) == Approx(4.65).epsilon(0.02));
    CHECK(n(given("DiFelice")) == Approx(4.65).epsilon(0.02));
    CHECK_FALSE(n(given("Stokes")) == Approx(4.65).epsilon(0.02));
}


TEST_CASE("drag laws: pressure lost in a fixed bed, by hand")
{
    // void fraction 0.4, 10 mm/s of water through 1 mm:
    // 150 mu U 0.36/(0.064 d^2) = 8437.5, 1.75 rho U^2 0.6/(0.064 d) = 1640.625
    const double exact = 10078.125;
    const dragPoint p = pointAt(0.6);
    CHECK(
        pressureLost(given("Ergun"), p, 0.01) == Approx(exact).epsilon(1e-12)
    );
    CHECK(
        pressureLost(given("Gidaspow"), p, 0.01) == Approx(exact).epsilon(0.01)
    );
    CHECK(
        pressureLost(given("DiFelice"), p, 0.01) == Approx(exact).epsilon(0.3)
    );
    CHECK_FALSE(
        pressureLost(given("Ergun", 1.1), p, 0.01)
        == Approx(exact).epsilon(0.05)
    );
}


TEST_CASE("drag laws: least velocity of fluidisation")
{
    // Ergun: Re = sqrt(C1^2 + C2 Ar) - C1, C1 = 150 (1 - e)/3.5,
    // C2 = e^3/1.75; for e = 0.4, Ar = 15696: Re = 9.432
    const double weight = 0.6 * 1600 * 9.81;
    const double Ar = d * d * d * rho * 1600 * 9.81 / (mu * mu);
    CHECK(Ar == Approx(15696));
    const double C1 = 150 * 0.6 / 3.5, C2 = 0.064 / 1.75;
    const double exact = (std::sqrt(C1 * C1 + C2 * Ar) - C1) * mu / (rho * d);
    CHECK(exact == Approx(9.432e-3).epsilon(1e-3));
    const dragPoint p = pointAt(0.6);
    CHECK(
        fluidisation(given("Ergun"), p, weight) == Approx(exact).epsilon(1e-9)
    );
    CHECK(
        fluidisation(given("Gidaspow"), p, weight)
        == Approx(exact).epsilon(0.05)
    );
    CHECK_FALSE(
        fluidisation(given("Ergun", 1.1), p, weight)
        == Approx(exact).epsilon(0.05)
    );
}


TEST_CASE("drag laws: finite without slip")
{
    for (const std::string name :
         {"DiFelice", "Ergun", "Gidaspow", "Stokes", "WenYu"})
    {
        for (const double solid : {1e-12, 0.3, 0.74})
        {
            const double beta = lawNamed(name)->beta(pointAt(solid), 0);
            INFO(name << " at " << solid);
            CHECK(std::isfinite(beta));
            CHECK(beta > 0);
        }
    }
}
