// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::dragLaws::Stokes
Description  Single spheres in creeping flow, each 3 pi mu d u:
                 beta = 18 xi_p mu/d^2                               (T 6.14)
             G. G. Stokes, Trans. Camb. Phil. Soc. 9 (1851) 8.
Range        Re below about 0.1, solid fraction below about 0.01: no hindrance
             by neighbours. The linear law to compare with; in beds it is an
             order of magnitude too small.
Units        beta [kg/(m3 s)]
Usage        drag Stokes;                      // constant/interphaseProperties
*/
#include "dragLaw.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace dragLaws
{

class Stokes : public dragLaw
{
public:
    TypeName("Stokes");

    explicit Stokes(const dictionary&) {}

    scalar beta(const dragPoint& p, scalar) const override
    {
        return 18 * p.solid * p.mu / sqr(p.diameter); // (T 6.14)
    }
};

defineTypeNameAndDebug(Stokes, 0);
addToRunTimeSelectionTable(dragLaw, Stokes, dictionary);

} // namespace dragLaws
} // namespace lpf
} // namespace Foam
