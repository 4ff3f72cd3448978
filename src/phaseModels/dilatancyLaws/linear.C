// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dilatancyLaws::linear
Description  phi_eq = phiC - slope N                                 (T 3.37)
             F. da Cruz et al., Phys. Rev. E 72 (2005) 021309, of I; Pailha and
             Pouliquen (2009) of the viscous number.
Range        I or J below about 0.3
Units        [-]
Usage        dilatancy linear; linearCoeffs { phiC 0.58; slope 0.2; rate 4; }
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

class linear : public dilatancyLaw
{
    scalar slope_;

public:
    TypeName("linear");

    explicit linear(const dictionary& coeffs) : dilatancyLaw(coeffs)
    {
        allowOnly(coeffs, {"phiC", "rate", "slope"});
        bounds notNegative;
        notNegative.lower = 0;
        notNegative.reason = "packings of rapid shear are loose; 0.2 of I";
        slope_ = readNumber(coeffs, "slope", dimless, notNegative);
    }

    scalar steady(scalar number) const override
    {
        return phiC_ - slope_ * number; // (T 3.37)
    }
};

defineTypeNameAndDebug(linear, 0);
addToRunTimeSelectionTable(dilatancyLaw, linear, dictionary);

} // namespace dilatancyLaws
} // namespace lpf
} // namespace Foam
