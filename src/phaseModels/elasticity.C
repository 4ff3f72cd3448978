// SPDX-License-Identifier: GPL-3.0-or-later
#include "elasticity.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

namespace
{

//- E such that K + 4 G/3 = M
scalar youngsModulus(scalar M, scalar nu)
{
    return M * (1 + nu) * (1 - 2 * nu) / (1 - nu);
}

scalar automaticModulus(
    const dictionary& coeffs, const stiffnessScale& scale, scalar nu
)
{
    bounds limits;
    limits.lower = 5;
    limits.upper = 1000;
    limits.reason = "it is the ratio of the wave speed to the speeds of the "
                    "flow: below 5 the grains are as soft as foam, above 1000 "
                    "the time step serves nothing; write 10 to 40";
    const scalar C = readNumber(coeffs, "stiffness", dimless, limits, 20);
    const scalar speed = max(scale.maxSpeed / 2, sqrt(scale.gH));

    if (!(speed > 0))
    {
        FatalIOErrorInFunction(coeffs)
            << "E auto needs a speed, but the release height, gravity and "
               "the expected speed are all zero; give E in Pa"
            << exit(FatalIOError);
    }
    return youngsModulus(scale.rhoBulk * sqr(C * speed), nu);
}

} // namespace

elasticity::elasticity(const dictionary& coeffs, const stiffnessScale& scale)
{
    bounds nuLimits;
    nuLimits.lower = 0;
    nuLimits.upper = 0.49;
    nuLimits.reason = "Poisson's ratio of a granular skeleton lies between 0 "
                      "and 0.49; write 0.2 to 0.4";
    nu_ = readNumber(coeffs, "nu", dimless, nuLimits);

    bounds ELimits;
    ELimits.lower = 0;
    ELimits.lowerOpen = true;
    ELimits.reason = "a stiffness is positive; write auto or a value in Pa";

    const bool isWord = coeffs.found("E") && coeffs.lookup("E").size() == 1
                     && coeffs.lookup("E")[0].isWord();
    const bool automatic =
        isWord && coeffs.lookup("E")[0].wordToken() == "auto";
    if (!coeffs.found("E") || (isWord && !automatic))
    {
        refuse(
            coeffs,
            "E",
            "E is the stiffness of the grains; write E auto; or E "
            "[1 -1 -2 0 0 0 0] <number>; with a value in Pa"
        );
    }
    E_ = automatic ? automaticModulus(coeffs, scale, nu_)
                   : readNumber(coeffs, "E", dimPressure, ELimits);

    K_ = E_ / (3 * (1 - 2 * nu_)); // (T 3.2)
    G_ = E_ / (2 * (1 + nu_));
    c_ = sqrt((K_ + 4 * G_ / 3) / scale.rhoBulk);
}

} // namespace lpf
} // namespace Foam
