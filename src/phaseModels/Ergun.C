// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dragLaws::Ergun
Description  Packed bed:
                 beta = 150 xi_p^2 mu/(xi_f d^2) + 1.75 xi_p rho u/d (T 6.12)
             which is dp/dx = 150 xi_p^2 mu U/(xi_f^3 d^2)
                            + 1.75 xi_p rho U^2/(xi_f^3 d), U = xi_f u.
             S. Ergun, Chem. Eng. Prog. 48 (1952) 89.
Range        beds: solid fraction from about 0.2 to 0.74, any Re that beds have.
             In a thin suspension it goes to 0 with xi_p^2 at small Re: no
             drag on a single grain. Take Gidaspow or DiFelice there.
Units        beta [kg/(m3 s)], u [m/s]
Usage        drag Ergun;                       // constant/interphaseProperties
*/
#include "dragCorrelations.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace dragLaws
{

class Ergun : public dragLaw
{
public:
    TypeName("Ergun");

    explicit Ergun(const dictionary&) {}

    scalar beta(const dragPoint& p, scalar u) const override
    {
        return ergunBeta(p, u); // (T 6.12)
    }
};

defineTypeNameAndDebug(Ergun, 0);
addToRunTimeSelectionTable(dragLaw, Ergun, dictionary);

} // namespace dragLaws
} // namespace lpf
} // namespace Foam
