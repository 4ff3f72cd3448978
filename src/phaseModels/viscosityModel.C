// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscosityModel.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(viscosityModel, 0);
defineRunTimeSelectionTable(viscosityModel, dictionary);

autoPtr<viscosityModel> viscosityModel::New(const dictionary& phase)
{
    const word name = readChoice(
        phase,
        "viscosity",
        dictionaryConstructorTablePtr_->sortedToc(),
        "Newtonian"
    );
    return dictionaryConstructorTablePtr_->cfind(name)()(phase);
}

} // namespace lpf
} // namespace Foam
