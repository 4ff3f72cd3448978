// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::frictionMappings::planeStrain
Description  alpha = 3 tan(phi)/sqrt(9 + 12 tan(phi)^2)               (T 3.34)
             The cone that fails as Mohr and Coulomb do in plane strain with
             associated flow (dilatancy of the size of the friction). Drucker
             and Prager (1952).
Range        made for associated flow; the flow of mu(I) is isochoric, for which
             sinPhi is exact and this is low by 4 % at 30 degrees
Units        [-]
Usage        frictionMapping planeStrain;
*/
#include "frictionMapping.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace frictionMappings
{

class planeStrain : public frictionMapping
{
public:
    TypeName("planeStrain");

    scalar slope(scalar mu) const override
    {
        return 3 * mu / sqrt(9 + 12 * sqr(mu)); // (T 3.34)
    }
};

defineTypeNameAndDebug(planeStrain, 0);
addToRunTimeSelectionTable(frictionMapping, planeStrain, dictionary);

} // namespace frictionMappings
} // namespace lpf
} // namespace Foam
