// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dragLaws::Gidaspow
Description  Ergun in a packed bed, Wen and Yu in a suspension, blended:
                 beta = (1 - phi) beta_E + phi beta_W               (T 6.6)
                 beta_E = 150 xi_p^2 mu/(xi_f d^2) + 1.75 xi_p rho u/d
                 beta_W = 3/4 (C_d Re) xi_p mu/d^2 xi_f^-2.65
                 C_d Re = 24 (1 + 0.15 Re^0.687), Re < 1000; 0.44 Re above
                 Re  = xi_f rho u d/mu
                 phi = atan(150 1.75 (0.2 - xi_p))/pi + 1/2
             Gao et al. (2023) eqs 18-22 with the errata of doc/theory.md; the
             products C_d Re keep it finite at u = 0.
Usage        drag Gidaspow;                    // constant/interphaseProperties
*/
#include "dragLaw.H"

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
    static scalar ergun(const dragPoint& p, scalar u)
    {
        return 150 * sqr(p.solid) * p.mu / (p.fluid * sqr(p.diameter))
             + 1.75 * p.solid * p.density * u / p.diameter;
    }

    static scalar wenYu(const dragPoint& p, scalar u)
    {
        const scalar muByDSqr = p.mu / sqr(p.diameter);
        const scalar Re = p.fluid * p.density * u * p.diameter / p.mu;
        const scalar CdRe =
            Re < 1000 ? 24 * (1 + 0.15 * std::pow(Re, 0.687)) : 0.44 * Re;
        return 0.75 * CdRe * p.solid * muByDSqr * std::pow(p.fluid, -2.65);
    }

public:
    TypeName("Gidaspow");

    explicit Gidaspow(const dictionary&) {}

    scalar beta(const dragPoint& p, scalar u) const override
    {
        const scalar phi =
            std::atan(150 * 1.75 * (0.2 - p.solid)) / constant::mathematical::pi
            + 0.5;
        return (1 - phi) * ergun(p, u) + phi * wenYu(p, u); // (T 6.6)
    }
};

defineTypeNameAndDebug(Gidaspow, 0);
addToRunTimeSelectionTable(dragLaw, Gidaspow, dictionary);

} // namespace dragLaws
} // namespace lpf
} // namespace Foam
