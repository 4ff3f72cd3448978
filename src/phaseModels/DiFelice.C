// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dragLaws::DiFelice
Description  From a single grain to a packed bed, the exponent of the void
             fraction by Re:
                 beta = 3/4 (C_d Re) xi_p mu/d^2 xi_f^(1 - chi)      (T 6.15)
                 C_d Re = (0.63 sqrt(Re) + 4.8)^2
                 chi = 3.7 - 0.65 exp(-(1.5 - log10 Re)^2/2)
                 Re = xi_f rho u d/mu
             that is the force F_0(U) xi_f^-chi on a grain, F_0 the drag of a
             single one at the superficial velocity U.
             R. Di Felice, Int. J. Multiphase Flow 20 (1994) 153; C_d of
             J. M. DallaValle, Micromeritics (1948): 23.04/Re at small Re, 4 %
             below Stokes.
Range        solid fraction 0 to about 0.6, any Re
Limits       u -> 0: chi -> 3.7, finite
Units        beta [kg/(m3 s)], u [m/s]
Usage        drag DiFelice;                    // constant/interphaseProperties
*/
#include "dragCorrelations.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace dragLaws
{

class DiFelice : public dragLaw
{
public:
    TypeName("DiFelice");

    explicit DiFelice(const dictionary&) {}

    scalar beta(const dragPoint& p, scalar u) const override
    {
        const scalar Re = superficialRe(p, u);
        const scalar CdRe = sqr(0.63 * std::sqrt(Re) + 4.8);
        const scalar fromPeak = 1.5 - std::log10(max(Re, VSMALL));
        const scalar chi = 3.7 - 0.65 * std::exp(-0.5 * sqr(fromPeak));
        return 0.75 * CdRe * p.solid * p.mu / sqr(p.diameter)
             * std::pow(p.fluid, 1 - chi); // (T 6.15)
    }
};

defineTypeNameAndDebug(DiFelice, 0);
addToRunTimeSelectionTable(dragLaw, DiFelice, dictionary);

} // namespace dragLaws
} // namespace lpf
} // namespace Foam
