// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::granularRheologies::muI: elastic grains that yield at
             Drucker-Prager and flow by mu(I).
Description  rho  <- rho (1 - dt tr L/2)/(1 + dt tr L/2)              (T 3.3)
             p     = K (rho/rhoRef - 1), not below -c/mu_s            (T 3.4)
             s_tr  = Q s Q^T + 2 G dt dev D                           (T 3.6)
                     Q the Cayley rotation of the spin over dt: exact for any
                     dt, where the Jaumann rate grows |s|
             S_tr  = sqrt(s_tr:s_tr/2)
             S_tr <= mu_s p + c: elastic. Else S solves
                     S = mu(I) p + c with gammaDot = (S_tr - S)/(G dt)
                     (backward Euler, closed form)                    (T 3.7)
             mu(I) = mu_s + (mu_2 - mu_s)/(I0/I + 1),
             I     = gammaDot d sqrt(rho_p/p)
             Jop, Forterre, Pouliquen, Nature 441 (2006) 727, with
             gammaDot = sqrt(2 dev D:dev D); Gao et al. (2023) eqs 12-17 with
             the errata of doc/theory.md. The closed form: Dunatunga and Kamrin,
             J. Fluid Mech. 779 (2015) 483, eq. 3.15.
             mu_s, mu_2 and c here are the slopes and the strength of the cone,
             frictionMapping of what the user gives              (T 3.16)
Limits       p -> 0: s -> 0, no division by p or gammaDot. Separated grains
             (p = 0, c = 0) carry no stress; rho is kept above 0.8 rhoRef,
             because V = mass/rho would grow without bound. In tension, which
             only cohesion bears, I has no meaning: S = mu_s p + c at any rate,
             and at the apex p = -c/mu_s no shear.
Usage        rheology muI;
             muICoeffs
             {
                 muS 0.3839; mu2 0.6494; I0 0.28;      // [-]
                 cohesion [1 -1 -2 0 0 0 0] 0;         // c, shear, [Pa]
                 frictionMapping tanPhi;               // frictionMapping.H
                 nu 0.3; E auto; initialStress geostatic;
             }
*/
#include "frictionMapping.H"
#include "granularRheology.H"
#include "inputCheck.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace granularRheologies
{

using pair::SymmTensor;
using pair::Tensor;
using pair::Vec;

class muI : public pointwiseRheology<muI>
{
    scalar muS_, mu2_, I0_, cohesion_, diameter_, rhoGrain_;
    scalar apex_; //!< the lowest p, a tension [Pa]

    //- Lowest density as a share of rhoRef
    static constexpr scalar loosest = 0.8;

    void read(const dictionary& phase);

    //- p of the density, cut off at the apex of the cone
    scalar pressure(scalar rho, scalar rhoRef) const
    {
        return max(apex_, elastic_.K() * (rho / rhoRef - 1)); // (T 3.4)
    }

    //- sqrt(J2) up to which grains are elastic
    scalar yieldStress(scalar p) const
    {
        return max(scalar(0), muS_ * p + cohesion_);
    }

    //- Energy that yield takes out of a volume in one step: the work of the
    //  mean stress of the step, as the leapfrog does it, on the plastic strain
    //  (s_tr - s)/(2 G)                                             (T 3.8)
    scalar dissipation(
        const SymmTensor<scalar>& sOld,
        const SymmTensor<scalar>& s_tr,
        const SymmTensor<scalar>& s
    ) const;

    scalar yieldedStress(scalar S_tr, scalar p, scalar dt) const;

public:
    TypeName("muI");

    muI(const dictionary& phase, const elasticity& elastic)
        : pointwiseRheology<muI>(elastic)
    {
        read(phase);
    }

    rheologyLosses correctPoint(grainPoint& g, scalar dt) const;

    scalar storedEnergyOf(const grainPoint& g) const;
};

defineTypeNameAndDebug(muI, 0);
addToRunTimeSelectionTable(granularRheology, muI, dictionary);

void muI::read(const dictionary& phase)
{
    const dictionary& coeffs = phase.subDict("muICoeffs");
    allowOnly(
        coeffs,
        {"muS",
         "mu2",
         "I0",
         "cohesion",
         "frictionMapping",
         "nu",
         "E",
         "stiffness",
         "initialStress",
         "K0"}
    );

    bounds friction;
    friction.lower = 0;
    friction.upper = 5;
    friction.lowerOpen = true;
    friction.reason = "a friction coefficient is tan(phi), between 0 and 5; "
                      "write tan of the angle of friction";
    const scalar muS = readNumber(coeffs, "muS", dimless, friction);
    const scalar mu2 = readNumber(coeffs, "mu2", dimless, friction);
    if (mu2 < muS)
    {
        refuse(
            coeffs,
            "mu2",
            "mu2 = " + Foam::name(mu2) + " is below muS = " + Foam::name(muS)
                + ": friction would fall as the shear rate grows. Write mu2 >= "
                  "muS (equal: rate-independent)"
        );
    }

    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "it must be positive";
    I0_ = readNumber(coeffs, "I0", dimless, positive);

    bounds notNegative;
    notNegative.lower = 0;
    notNegative.reason = "cohesion is a strength, zero or positive";
    const scalar c =
        readNumber(coeffs, "cohesion", dimPressure, notNegative, 0);

    const autoPtr<frictionMapping> cone = frictionMapping::New(coeffs);
    muS_ = cone->slope(muS);
    mu2_ = cone->slope(mu2);
    cohesion_ = cone->strength(c, muS);
    apex_ = cohesion_ > 0 ? -cohesion_ / muS_ : 0;

    diameter_ = readNumber(phase, "diameter", dimLength, positive);
    rhoGrain_ = readNumber(phase, "rho", dimDensity, positive);
}

//- sqrt(J2) after yield                                             (T 3.7)
//  S0 = mu_s p + c, S2 = mu_2 p + c, a = I0 G dt sqrt(p)/(d sqrt(rho_p)):
//  S^2 - B S + H = 0 with B = S2 + S_tr + a, H = S2 S_tr + S0 a; the smaller
//  root, written without cancellation
scalar muI::yieldedStress(scalar S_tr, scalar p, scalar dt) const
{
    const scalar S0 = yieldStress(p);
    const scalar S2 = p > 0 ? mu2_ * p + cohesion_ : S0;
    const scalar a = I0_ * elastic_.G() * dt * sqrt(max(p, scalar(0)))
                   / (diameter_ * sqrt(rhoGrain_));
    const scalar B = S2 + S_tr + a;
    const scalar H = S2 * S_tr + S0 * a;

    return 2 * H / (B + sqrt(max(scalar(0), B * B - 4 * H)));
}

namespace
{

SymmTensor<double> scaled(double f, const SymmTensor<double>& a)
{
    return {f * a.xx, f * a.xy, f * a.xz, f * a.yy, f * a.yz, f * a.zz};
}

SymmTensor<double> deviator(const SymmTensor<double>& a)
{
    const double mean = trace(a) / 3;
    return {a.xx - mean, a.xy, a.xz, a.yy - mean, a.yz, a.zz - mean};
}

//- a:a
double magnitudeSqr(const SymmTensor<double>& a)
{
    return a.xx * a.xx + a.yy * a.yy + a.zz * a.zz
         + 2 * (a.xy * a.xy + a.xz * a.xz + a.yz * a.yz);
}

//- Q s Q^T, Q = (I - Omega/2)^-1 (I + Omega/2), Omega = skew(L) dt
SymmTensor<double>
rotated(const SymmTensor<double>& s, const Tensor<double>& L, double dt)
{
    // axial vector of half the spin; Q v = v + 2/(1 + w.w) (w x v + w x w x v)
    const double f = 0.25 * dt;
    const Vec<double> w = {
        f * (L.z.y - L.y.z), f * (L.x.z - L.z.x), f * (L.y.x - L.x.y)};
    const double k = 2 / (1 + magSqr(w));
    const Tensor<double> Q = {
        {1 - k * (w.y * w.y + w.z * w.z),
         k * (w.x * w.y - w.z),
         k * (w.x * w.z + w.y)},
        {k * (w.x * w.y + w.z),
         1 - k * (w.x * w.x + w.z * w.z),
         k * (w.y * w.z - w.x)},
        {k * (w.x * w.z - w.y),
         k * (w.y * w.z + w.x),
         1 - k * (w.x * w.x + w.y * w.y)}};

    return symm(Q & full(s) & transpose(Q));
}

//- a:b
double inner(const SymmTensor<double>& a, const SymmTensor<double>& b)
{
    return a.xx * b.xx + a.yy * b.yy + a.zz * b.zz
         + 2 * (a.xy * b.xy + a.xz * b.xz + a.yz * b.yz);
}

} // namespace

scalar muI::dissipation(
    const SymmTensor<scalar>& sOld,
    const SymmTensor<scalar>& s_tr,
    const SymmTensor<scalar>& s
) const
{
    const SymmTensor<double> plastic = s_tr + scaled(-1, s);
    return inner(sOld + s, plastic) / (4 * elastic_.G()); // (T 3.8)
}

rheologyLosses muI::correctPoint(grainPoint& g, scalar dt) const
{
    rheologyLosses lost;
    const SymmTensor<double> D = symm(g.L);
    const SymmTensor<double> devD = deviator(D);
    const scalar trD = trace(D);
    lost.maxStrainRate = sqrt(magnitudeSqr(devD)) + mag(trD);

    const scalar rhoOld = g.rho;
    const scalar rhoFree =
        rhoOld * (1 - 0.5 * dt * trD) / (1 + 0.5 * dt * trD); // (T 3.3)
    g.rho = max(loosest * g.rhoRef, rhoFree);
    const scalar V = g.mass / g.rho;
    const scalar p = pressure(g.rho, g.rhoRef);
    if (p < 0)
    {
        // at the floor the work of the tension goes nowhere but into opening
        lost.separation -= p * (g.mass / rhoFree - V);
    }

    const SymmTensor<double> sOld = rotated(deviator(g.sigma), g.L, dt);
    const SymmTensor<double> s_tr =
        sOld + scaled(2 * elastic_.G() * dt, devD); // (T 3.6)
    const scalar S_tr = sqrt(0.5 * magnitudeSqr(s_tr));

    SymmTensor<double> s = s_tr;
    if (S_tr > yieldStress(p))
    {
        s = scaled(yieldedStress(S_tr, p, dt) / S_tr, s_tr); // (T 3.7)
        (p > apex_ ? lost.plastic : lost.separation) +=
            V * dissipation(sOld, s_tr, s);
    }
    g.sigma = s + SymmTensor<double>{-p, 0, 0, -p, 0, -p};
    g.inertialNumber =
        p > 0 ? sqrt(2 * magnitudeSqr(devD)) * diameter_ * sqrt(rhoGrain_ / p)
              : 0;
    return lost;
}

//- m int p/rho^2 drho from rhoRef, plus V S^2/(2 G)                 (T 3.9)
scalar muI::storedEnergyOf(const grainPoint& g) const
{
    const scalar K = elastic_.K();
    const scalar x = max(apex_ / K, g.rho / g.rhoRef - 1);
    const scalar rhoElastic = g.rhoRef * (1 + x);

    const scalar bulk = g.mass * K / g.rhoRef * (log1p(x) - x / (1 + x));
    const scalar opening = -apex_ * (g.mass / g.rho - g.mass / rhoElastic);
    const scalar shear =
        g.mass / g.rho * magnitudeSqr(deviator(g.sigma)) / (4 * elastic_.G());
    return bulk + (g.rho < rhoElastic ? opening : 0) + shear;
}

} // namespace granularRheologies
} // namespace lpf
} // namespace Foam
