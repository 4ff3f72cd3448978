// SPDX-License-Identifier: GPL-3.0-or-later
#include "equationOfState.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(equationOfState, 0);
defineRunTimeSelectionTable(equationOfState, dictionary);

namespace
{

scalar autoSoundSpeed(const soundSpeedScale& s, scalar rho0)
{
    constexpr scalar machInverse = 10;
    constexpr scalar stiffer = 9;
    const scalar flow = machInverse * max(s.maxSpeed, 2 * sqrt(s.gH));
    const scalar bed = sqrt(stiffer * s.porosity * s.skeleton / rho0);
    return max(flow, bed); // (T 5.5)
}

} // namespace

equationOfState::equationOfState(
    const dictionary& phase,
    const dictionary& coeffs,
    const soundSpeedScale& scale
)
{
    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "the density of the water, e.g. 1000 kg/m3";
    rho0_ = readNumber(phase, "rho", dimDensity, positive);

    const bool isWord = coeffs.found("soundSpeed")
                     && coeffs.lookup("soundSpeed").size() == 1
                     && coeffs.lookup("soundSpeed")[0].isWord();
    if (isWord && coeffs.lookup("soundSpeed")[0].wordToken() != "auto")
    {
        refuse(
            coeffs,
            "soundSpeed",
            "soundSpeed is a number in m/s or auto; write soundSpeed auto;"
        );
    }
    bounds speed;
    speed.lower = 0;
    speed.lowerOpen = true;
    speed.reason = "at least ten times the largest speed of the flow keeps the "
                   "density within 1 %";
    c0_ = isWord || !coeffs.found("soundSpeed")
            ? autoSoundSpeed(scale, rho0_)
            : readNumber(coeffs, "soundSpeed", dimVelocity, speed);
    if (!(c0_ > 0))
    {
        refuse(
            coeffs,
            "soundSpeed",
            "soundSpeed auto needs a speed, but depth, gravity and the "
            "expected speed are all zero; write it in m/s"
        );
    }
}

autoPtr<equationOfState>
equationOfState::New(const dictionary& phase, const soundSpeedScale& scale)
{
    const word name = readChoice(
        phase,
        "equationOfState",
        dictionaryConstructorTablePtr_->sortedToc(),
        "Tait"
    );
    return dictionaryConstructorTablePtr_->cfind(name)()(phase, scale);
}

} // namespace lpf
} // namespace Foam
