// SPDX-License-Identifier: GPL-3.0-or-later
#include "releaseRegion.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(releaseRegion, 0);
defineRunTimeSelectionTable(releaseRegion, dictionary);


autoPtr<releaseRegion>
releaseRegion::New(const dictionary& dict, const releaseContext& context)
{
    const word type =
        readChoice(dict, "type", dictionaryConstructorTablePtr_->sortedToc());
    return dictionaryConstructorTablePtr_->cfind(type)()(dict, context);
}


releaseRegion::releaseRegion(const dictionary& dict, const wordList& keywords)
    : dict_(dict)
{
    wordList valid(keywords);
    valid.append(wordList{
        "type", "zone", "velocity", "spacing", "lattice", "grains"});
    allowOnly(dict, valid);
}


string releaseRegion::crs() const
{
    return "";
}


scalar releaseRegion::lowering(scalar, scalar) const
{
    return 0;
}


void releaseRegion::place(const releaseScene& scene)
{
    scene_ = &scene;
}

} // namespace lpf
} // namespace Foam
