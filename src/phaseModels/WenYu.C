// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dragLaws::WenYu
Description  Suspension:
                 beta = 3/4 (C_d Re) xi_p mu/d^2 xi_f^-2.65          (T 6.13)
                 C_d Re = 24 (1 + 0.15 Re^0.687), Re < 1000; 0.44 Re above
                 Re = xi_f rho u d/mu
             The exponent -2.65 is that on beta with C_d of the superficial Re;
             as a force on a grain at the superficial velocity U it is
             F_0(U) xi_f^-4.65 with the share of the pressure gradient.
             C. Y. Wen, Y. H. Yu, Chem. Eng. Prog. Symp. Ser. 62 (1966) 100;
             the form of D. Gidaspow, Multiphase Flow and Fluidization (1994);
             C_d of L. Schiller and A. Naumann.
Range        solid fraction 0 to about 0.2, up to 0.6 as an extrapolation; any
             Re. C_d drops by 2 % at Re = 1000.
Units        beta [kg/(m3 s)], u [m/s]
Usage        drag WenYu;                       // constant/interphaseProperties
*/
#include "dragCorrelations.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace dragLaws
{

class WenYu : public dragLaw
{
public:
    TypeName("WenYu");

    explicit WenYu(const dictionary&) {}

    scalar beta(const dragPoint& p, scalar u) const override
    {
        return wenYuBeta(p, u); // (T 6.13)
    }
};

defineTypeNameAndDebug(WenYu, 0);
addToRunTimeSelectionTable(dragLaw, WenYu, dictionary);

} // namespace dragLaws
} // namespace lpf
} // namespace Foam
