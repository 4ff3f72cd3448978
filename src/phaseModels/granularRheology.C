// SPDX-License-Identifier: GPL-3.0-or-later
#include "granularRheology.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(granularRheology, 0);
defineRunTimeSelectionTable(granularRheology, dictionary);

wordList granularRheology::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}

word granularRheology::nameOf(const dictionary& phase)
{
    return readChoice(phase, "rheology", names());
}

autoPtr<granularRheology>
granularRheology::New(const dictionary& phase, const elasticity& elastic)
{
    return dictionaryConstructorTablePtr_->cfind(nameOf(phase)
    )()(phase, elastic);
}

} // namespace lpf
} // namespace Foam
