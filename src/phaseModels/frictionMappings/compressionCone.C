// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::frictionMappings::compressionCone
Description  alpha = 6 sin(phi)/(sqrt(3) (3 - sin(phi)))               (T 3.35)
             The cone through the edges of Mohr and Coulomb's pyramid where two
             principal stresses are equal and the third is larger: triaxial
             compression, as phi is measured in the laboratory. Chen and Han
             (1988).
Range        exact in triaxial compression, the strongest of all elsewhere:
             by 39 % above Mohr and Coulomb in plane strain at 30 degrees
Units        [-]
Usage        frictionMapping compressionCone;
*/
#include "frictionMapping.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace frictionMappings
{

class compressionCone : public frictionMapping
{
public:
    TypeName("compressionCone");

    scalar slope(scalar mu) const override
    {
        const scalar sinPhi = mu / sqrt(1 + sqr(mu));
        return 6 * sinPhi / (sqrt(scalar(3)) * (3 - sinPhi)); // (T 3.35)
    }
};

defineTypeNameAndDebug(compressionCone, 0);
addToRunTimeSelectionTable(frictionMapping, compressionCone, dictionary);

} // namespace frictionMappings
} // namespace lpf
} // namespace Foam
