// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::frictionMappings::sinPhi
Description  alpha = sin(phi)                                         (T 3.33)
             The cone that fails as Mohr and Coulomb do in plane strain without
             dilatancy, which is the flow that mu(I) has here: the stress out
             of the plane is then p, sqrt(J2) the radius of Mohr's circle.
             Chen and Han (1988).
Range        exact for isochoric plastic flow in plane strain
Units        [-]
Usage        frictionMapping sinPhi;
*/
#include "frictionMapping.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace frictionMappings
{

class sinPhi : public frictionMapping
{
public:
    TypeName("sinPhi");

    scalar slope(scalar mu) const override
    {
        return mu / sqrt(1 + sqr(mu)); // (T 3.33)
    }
};

defineTypeNameAndDebug(sinPhi, 0);
addToRunTimeSelectionTable(frictionMapping, sinPhi, dictionary);

} // namespace frictionMappings
} // namespace lpf
} // namespace Foam
