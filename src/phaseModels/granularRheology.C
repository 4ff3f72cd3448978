// SPDX-License-Identifier: GPL-3.0-or-later
#include "granularRheology.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(granularRheology, 0);
defineRunTimeSelectionTable(granularRheology, dictionary);

autoPtr<granularRheology>
granularRheology::New(const dictionary& phase, const elasticity& elastic)
{
    const word name(phase.get<word>("rheology"));
    auto choice = dictionaryConstructorTablePtr_->cfind(name);

    if (!choice.found())
    {
        FatalIOErrorInFunction(phase)
            << "rheology " << name << " is not known; valid: "
            << dictionaryConstructorTablePtr_->sortedToc()
            << exit(FatalIOError);
    }
    return choice()(phase, elastic);
}

} // namespace lpf
} // namespace Foam
