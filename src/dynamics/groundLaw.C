// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundLaw.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(groundLaw, 0);
defineRunTimeSelectionTable(groundLaw, grains);
defineRunTimeSelectionTable(groundLaw, water);

namespace
{

//- Keywords of a zone that are no law's
const wordList& ofZone()
{
    static const wordList words(
        {"friction", "waterFriction", "waterFrictionCoeffs", "opensAt"}
    );
    return words;
}

} // namespace

std::unique_ptr<groundLaw> groundLaw::forGrains(const dictionary& zone)
{
    const word name =
        readChoice(zone, "friction", grainsConstructorTablePtr_->sortedToc());
    return std::unique_ptr<groundLaw>(
        grainsConstructorTablePtr_->cfind(name)()(zone, ofZone()).ptr()
    );
}

std::unique_ptr<groundLaw> groundLaw::forWater(const dictionary& zone)
{
    const word key("waterFrictionCoeffs");
    const word name = readChoice(
        zone, "waterFriction", waterConstructorTablePtr_->sortedToc(), "none"
    );
    const auto make = waterConstructorTablePtr_->cfind(name)();
    if (const dictionary* coeffs = optionalDictionary(zone, key))
    {
        return std::unique_ptr<groundLaw>(make(*coeffs, wordList()).ptr());
    }
    // a message about what is missing in it has the line of the choice
    dictionary none(zone, dictionary());
    none.name() = zone.name() + "." + key;
    if (const entry* choice = zone.findEntry("waterFriction"))
    {
        none.add(*choice);
    }
    return std::unique_ptr<groundLaw>(
        make(none, wordList({"waterFriction"})).ptr()
    );
}

dryFriction dryFriction::read(const dictionary& dict)
{
    bounds mu;
    mu.lower = 0;
    mu.upper = 10;
    mu.reason = "a friction coefficient is the tangent of an angle; write "
                "0 to 1.5";
    bounds ru;
    ru.lower = 0;
    ru.upper = 1;
    ru.reason = "r_u is the share of the normal stress that pore pressure "
                "carries, 0 to 1";
    return {
        readNumber(dict, "mu", dimless, mu),
        readNumber(dict, "ru", dimless, ru, 0)};
}

} // namespace lpf
} // namespace Foam
