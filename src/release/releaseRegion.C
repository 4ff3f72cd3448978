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
        "type", "zone", "velocity", "spacing", "lattice", "grains", "water"});
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


autoPtr<releaseRegion> releaseRegion::above(const scalar volume) const
{
    refuse(
        dict_.subDict("water"),
        "excess",
        "A release of type " + type()
            + " has no walls that would hold the excess of "
            + Foam::name(volume)
            + " m3 on top of it. Use saturation 1 and a second release of water"
              " alone, or a release of type box, tank or fill"
    );
}

} // namespace lpf
} // namespace Foam
