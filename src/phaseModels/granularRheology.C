// SPDX-License-Identifier: GPL-3.0-or-later
#include "granularRheology.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(granularRheology, 0);
defineRunTimeSelectionTable(granularRheology, dictionary);

word granularRheology::nameOf(const dictionary& phase)
{
    const word name(phase.get<word>("rheology"));
    if (!dictionaryConstructorTablePtr_->found(name))
    {
        FatalIOErrorInFunction(phase)
            << "rheology " << name << " is not known; write one of "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }
    return name;
}

autoPtr<granularRheology>
granularRheology::New(const dictionary& phase, const elasticity& elastic)
{
    const word name(nameOf(phase));
    return dictionaryConstructorTablePtr_->cfind(name)()(phase, elastic);
}

} // namespace lpf
} // namespace Foam
