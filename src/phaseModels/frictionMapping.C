// SPDX-License-Identifier: GPL-3.0-or-later
#include "frictionMapping.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(frictionMapping, 0);
defineRunTimeSelectionTable(frictionMapping, dictionary);

autoPtr<frictionMapping> frictionMapping::New(const dictionary& coeffs)
{
    const word name = readChoice(
        coeffs,
        "frictionMapping",
        dictionaryConstructorTablePtr_->sortedToc(),
        "tanPhi"
    );
    return dictionaryConstructorTablePtr_->cfind(name)()();
}

} // namespace lpf
} // namespace Foam
