// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::frictionMappings::tanPhi
Description  alpha = tan(phi)                                         (T 3.32)
             mu is sqrt(J2)/p itself, as measured in flow down an incline, where
             the normal stresses are equal; the mapping of mu(I) and of Gao et
             al. (2023). P. Jop, Y. Forterre, O. Pouliquen, Nature 441 (2006)
             727.
Range        any state is stronger than Mohr and Coulomb say in plane strain:
             by 15 % at 30 degrees (sinPhi)
Units        [-]
Usage        frictionMapping tanPhi;
*/
#include "frictionMapping.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace frictionMappings
{

class tanPhi : public frictionMapping
{
public:
    TypeName("tanPhi");

    scalar slope(scalar mu) const override
    {
        return mu; // (T 3.32)
    }
};

defineTypeNameAndDebug(tanPhi, 0);
addToRunTimeSelectionTable(frictionMapping, tanPhi, dictionary);

} // namespace frictionMappings
} // namespace lpf
} // namespace Foam
