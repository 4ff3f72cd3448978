// SPDX-License-Identifier: GPL-3.0-or-later
#include "dragLaw.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(dragLaw, 0);
defineRunTimeSelectionTable(dragLaw, dictionary);

autoPtr<dragLaw> dragLaw::New(const dictionary& dict)
{
    const word name = readChoice(
        dict, "drag", dictionaryConstructorTablePtr_->sortedToc(), "Gidaspow"
    );
    return dictionaryConstructorTablePtr_->cfind(name)()(dict);
}

} // namespace lpf
} // namespace Foam
