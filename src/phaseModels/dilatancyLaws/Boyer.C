// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dilatancyLaws::Boyer
Description  phi_eq = phiC/(1 + sqrt(N))                             (T 3.38)
             F. Boyer, E. Guazzelli, O. Pouliquen, Phys. Rev. Lett. 107 (2011)
             188301, eq. 6, of J: phiC 0.585 of spheres.
Range        rheology muJ; J from 1e-6 to 0.2
Units        [-]
Usage        dilatancy Boyer; BoyerCoeffs { phiC 0.585; rate 4; }
*/
#include "dilatancyLaw.H"
#include "inputCheck.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace dilatancyLaws
{

class Boyer : public dilatancyLaw
{
public:
    TypeName("Boyer");

    explicit Boyer(const dictionary& coeffs) : dilatancyLaw(coeffs)
    {
        allowOnly(coeffs, {"phiC", "rate"});
    }

    scalar steady(scalar number) const override
    {
        return phiC_ / (1 + sqrt(number)); // (T 3.38)
    }
};

defineTypeNameAndDebug(Boyer, 0);
addToRunTimeSelectionTable(dilatancyLaw, Boyer, dictionary);

} // namespace dilatancyLaws
} // namespace lpf
} // namespace Foam
