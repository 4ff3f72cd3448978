// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::granularRheologies::muJ: grains in a liquid so viscous
             that it hinders them more than their inertia; frictionalRheology
             does the rest.
Description  mu(J) = mu_s + (mu_2 - mu_s)/(J0/J + 1),
             J     = mu_f gammaDot/p                                 (T 3.39)
             The part of contacts of F. Boyer, E. Guazzelli, O. Pouliquen, Phys.
             Rev. Lett. 107 (2011) 188301, eq. 5; mu_s 0.32, mu_2 0.7, J0 0.005
             there. What the liquid itself carries between the grains, J +
             5/2 phi_m sqrt(J), is the stress of the water that is resolved.
             The field I of the output holds J.
Range        Stokes number rho_p d^2 gammaDot/mu_f below about 10
Usage        rheology muJ;
             muJCoeffs
             {
                 muS 0.32; mu2 0.7; J0 0.005;          // [-]
                 fluidViscosity [1 -1 -1 0 0 0 0] 1;   // mu_f [Pa s]
                 // the others as in muICoeffs
             }
*/
#include "frictionalRheology.H"

namespace Foam
{
namespace lpf
{
namespace granularRheologies
{

class viscousLaw
{
    scalar J0_, viscosity_;

public:
    static wordList keywords() { return wordList({"J0", "fluidViscosity"}); }

    viscousLaw(const dictionary&, const dictionary& coeffs)
    {
        bounds positive;
        positive.lower = 0;
        positive.lowerOpen = true;
        positive.reason = "it must be positive; 0.005 for spheres";
        J0_ = readNumber(coeffs, "J0", dimless, positive);
        positive.reason = "the liquid between the grains must have one; water "
                          "has 1e-3 Pa s";
        viscosity_ =
            readNumber(coeffs, "fluidViscosity", dimDynamicViscosity, positive);
    }

    scalar number(scalar gammaDot, scalar p) const
    {
        return viscosity_ * gammaDot / p; // (T 3.39)
    }

    scalar halfway(scalar G, scalar dt, scalar p) const
    {
        return J0_ * G * dt * p / viscosity_;
    }
};

class muJ : public frictionalRheology<viscousLaw>
{
public:
    TypeName("muJ");

    muJ(const dictionary& phase, const elasticity& elastic)
        : frictionalRheology<viscousLaw>(phase, elastic, typeName)
    {
    }
};

defineTypeNameAndDebug(muJ, 0);
addToRunTimeSelectionTable(granularRheology, muJ, dictionary);

} // namespace granularRheologies
} // namespace lpf
} // namespace Foam
