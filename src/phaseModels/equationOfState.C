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

void warnOfSoft(scalar c0, const soundSpeedScale& s)
{
    constexpr scalar machInverse = 5;
    const scalar fastest = max(s.maxSpeed, sqrt(s.gH));
    if (c0 < machInverse * fastest)
    {
        WarningInFunction
            << "soundSpeed " << c0 << " m/s is less than five times the speed "
            << "of this scene, " << fastest << " m/s, the larger one of "
            << "maxSpeed and sqrt(g H): the density of the water varies by "
            << 100 * sqr(fastest / c0) << " %. Write soundSpeed auto, or "
            << "at least " << 2 * machInverse * fastest << endl;
    }
}

// The real 1480 m/s, say
void warnOfHard(scalar c0, scalar automatic)
{
    constexpr scalar most = 5;
    if (automatic > 0 && c0 > most * automatic)
    {
        WarningInFunction
            << "soundSpeed " << c0 << " m/s is " << c0 / automatic
            << " times what auto takes, " << automatic
            << " m/s: steps are as much shorter, and water that meets itself "
            << "or the ground loses energy to the scheme (a dam break of five "
            << "layers 5 % at nine times, 19 % at 34 times). Write soundSpeed "
            << "auto" << endl;
    }
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
    const scalar automatic = autoSoundSpeed(scale, rho0_);
    c0_ = isWord || !coeffs.found("soundSpeed")
            ? automatic
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
    warnOfSoft(c0_, scale);
    warnOfHard(c0_, automatic);
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
