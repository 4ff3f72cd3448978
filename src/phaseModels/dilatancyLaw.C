// SPDX-License-Identifier: GPL-3.0-or-later
#include "dilatancyLaw.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(dilatancyLaw, 0);
defineRunTimeSelectionTable(dilatancyLaw, dictionary);

wordList dilatancyLaw::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}

std::unique_ptr<dilatancyLaw> dilatancyLaw::New(const dictionary& rheology)
{
    wordList choices(names());
    choices.append("none");
    const word name = readChoice(rheology, "dilatancy", choices, "none");
    if (name == "none")
    {
        return nullptr;
    }
    const dictionary& coeffs = neededDictionary(
        rheology,
        name + "Coeffs",
        "write " + name + "Coeffs { phiC 0.58; rate 4; ... }"
    );
    return std::unique_ptr<dilatancyLaw>(
        dictionaryConstructorTablePtr_->cfind(name)()(coeffs).ptr()
    );
}

dilatancyLaw::dilatancyLaw(const dictionary& coeffs)
{
    bounds phi;
    phi.lower = 0.1;
    phi.upper = 0.74;
    phi.reason = "the solid fraction of slow steady shear; 0.58 of spheres, "
                 "the densest packing has 0.74";
    phiC_ = readNumber(coeffs, "phiC", dimless, phi);

    bounds rate;
    rate.lower = 0;
    rate.upper = 100;
    rate.reason = "tan of the angle of dilatancy per solid fraction; glass "
                  "beads have 4";
    rate_ = readNumber(coeffs, "rate", dimless, rate);
}

} // namespace lpf
} // namespace Foam
