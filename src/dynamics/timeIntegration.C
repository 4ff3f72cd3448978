// SPDX-License-Identifier: GPL-3.0-or-later
#include "timeIntegration.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(timeIntegration, 0);
defineRunTimeSelectionTable(timeIntegration, dictionary);

autoPtr<timeIntegration> timeIntegration::New(const dictionary& dict)
{
    const word name = readChoice(
        dict,
        "timeIntegration",
        dictionaryConstructorTablePtr_->sortedToc(),
        "leapfrog"
    );
    return dictionaryConstructorTablePtr_->cfind(name)()();
}

} // namespace lpf
} // namespace Foam
