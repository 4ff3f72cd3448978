// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dragLaws::Gidaspow
Description  Ergun in a packed bed, Wen and Yu in a suspension, blended:
                 beta = (1 - phi) beta_E + phi beta_W               (T 6.6)
                 beta_E, beta_W: Ergun.C, WenYu.C
                 phi = atan(150 1.75 (0.2 - xi_p))/pi + 1/2
             Gao et al. (2023) eqs 18-22 with the errata of doc/theory.md.
Range        solid fraction 0 to 0.74, any Re
Units        beta [kg/(m3 s)], u [m/s]
Usage        drag Gidaspow;                    // constant/interphaseProperties
*/
#include "dragCorrelations.H"

#include "addToRunTimeSelectionTable.H"
#include "mathematicalConstants.H"

namespace Foam
{
namespace lpf
{
namespace dragLaws
{

class Gidaspow : public dragLaw
{
public:
    TypeName("Gidaspow");

    explicit Gidaspow(const dictionary&) {}

    scalar beta(const dragPoint& p, scalar u) const override
    {
        const scalar phi =
            std::atan(150 * 1.75 * (0.2 - p.solid)) / constant::mathematical::pi
            + 0.5;
        return (1 - phi) * ergunBeta(p, u) + phi * wenYuBeta(p, u); // (T 6.6)
    }
};

defineTypeNameAndDebug(Gidaspow, 0);
addToRunTimeSelectionTable(dragLaw, Gidaspow, dictionary);

} // namespace dragLaws
} // namespace lpf
} // namespace Foam
