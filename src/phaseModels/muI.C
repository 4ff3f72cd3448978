// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::granularRheologies::muI: grains whose friction grows
             with the inertial number; frictionalRheology does the rest.
Description  mu(I) = mu_s + (mu_2 - mu_s)/(I0/I + 1),
             I     = gammaDot d sqrt(rho_p/p)                        (T 3.7)
             P. Jop, Y. Forterre, O. Pouliquen, Nature 441 (2006) 727; Gao et
             al. (2023) eqs 12-17 with the errata of doc/theory.md.
Range        I up to about 1; dry grains, or coarse ones in water
Usage        rheology muI;
             muICoeffs
             {
                 muS 0.3839; mu2 0.6494; I0 0.28;      // [-]
                 cohesion [1 -1 -2 0 0 0 0] 0;         // c, shear, [Pa]
                 frictionMapping tanPhi;               // frictionMapping.H
                 dilatancy none;                       // dilatancyLaw.H
                 nu 0.3; E auto; initialStress geostatic;
             }
*/
#include "frictionalRheology.H"

namespace Foam
{
namespace lpf
{
namespace granularRheologies
{

class inertialLaw
{
    scalar I0_, diameter_, rhoGrain_;

public:
    static wordList keywords() { return wordList({"I0"}); }

    inertialLaw(const dictionary& phase, const dictionary& coeffs)
    {
        bounds positive;
        positive.lower = 0;
        positive.lowerOpen = true;
        positive.reason =
            "it is part of the inertial number that friction rises with";
        I0_ = readNumber(coeffs, "I0", dimless, positive);
        diameter_ = readNumber(phase, "diameter", dimLength, positive);
        rhoGrain_ = readNumber(phase, "rho", dimDensity, positive);
    }

    scalar number(scalar gammaDot, scalar p) const
    {
        return gammaDot * diameter_ * sqrt(rhoGrain_ / p); // (T 3.7)
    }

    scalar halfway(scalar G, scalar dt, scalar p) const
    {
        return I0_ * G * dt * sqrt(p) / (diameter_ * sqrt(rhoGrain_));
    }
};

class muI : public frictionalRheology<inertialLaw>
{
public:
    TypeName("muI");

    muI(const dictionary& phase, const elasticity& elastic)
        : frictionalRheology<inertialLaw>(phase, elastic, typeName)
    {
    }
};

defineTypeNameAndDebug(muI, 0);
addToRunTimeSelectionTable(granularRheology, muI, dictionary);

} // namespace granularRheologies
} // namespace lpf
} // namespace Foam
