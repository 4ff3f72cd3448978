// SPDX-License-Identifier: GPL-3.0-or-later
#include "viscosityModel.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(viscosityModel, 0);
defineRunTimeSelectionTable(viscosityModel, dictionary);

const word viscosityModel::usual("Newtonian");

wordList viscosityModel::names()
{
    return dictionaryConstructorTablePtr_->sortedToc();
}

autoPtr<viscosityModel> viscosityModel::New(const dictionary& phase)
{
    const word name = readChoice(phase, "viscosity", names(), usual);
    return dictionaryConstructorTablePtr_->cfind(name)()(phase);
}

const dictionary& viscosityCoeffs(
    const dictionary& phase, const word& model, const string& example
)
{
    const word key(model + "Coeffs");
    const dictionary* coeffs = optionalDictionary(phase, key);
    if (!coeffs)
    {
        refuse(
            phase,
            key,
            "The numbers of viscosity " + model + " are missing; write " + key
                + " { " + example + " }"
        );
    }
    return *coeffs;
}

scalar notNegative(
    const dictionary& coeffs,
    const word& key,
    const dimensionSet& dims,
    const char* reason
)
{
    bounds allowed;
    allowed.lower = 0;
    allowed.reason = reason;
    return readNumber(coeffs, key, dims, allowed);
}

scalar readMuMax(const dictionary& coeffs, const word& leastName, scalar least)
{
    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "it is the viscosity of what does not yield, in Pa s; "
                      "write 100 to 10000 times that of the flow";
    const scalar muMax =
        readNumber(coeffs, "muMax", dimDynamicViscosity, positive);
    if (muMax < least)
    {
        refuse(
            coeffs,
            "muMax",
            "muMax = " + Foam::name(muMax) + " Pa s is below " + leastName
                + " = " + Foam::name(least)
                + " Pa s: the fluid would be thinner at rest than in motion. "
                  "Write 100 to 10000 times "
                + leastName
        );
    }
    return muMax;
}

} // namespace lpf
} // namespace Foam
