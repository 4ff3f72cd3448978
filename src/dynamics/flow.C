// SPDX-License-Identifier: GPL-3.0-or-later
#include "flow.H"

namespace Foam
{
namespace lpf
{

std::vector<phaseDynamics*> flow::phases() const
{
    std::vector<phaseDynamics*> all;
    if (grains)
    {
        all.push_back(grains.get());
    }
    if (water)
    {
        all.push_back(water.get());
    }
    return all;
}

wordList flow::names() const
{
    wordList all;
    if (grains)
    {
        all.append("grains");
    }
    if (water)
    {
        all.append("water");
    }
    return all;
}

void flow::rates(scalar dt, scalar time, stage where)
{
    if (grains)
    {
        grains->rates(dt, time, where);
    }
    if (!water)
    {
        return;
    }
    if (!coupling)
    {
        water->rates(dt, time, where);
        return;
    }
    water->arrange(time);
    coupling->porosity();
    water->divergence(dt, where);
    water->correct(dt, where);
    water->accelerations();
    coupling->forces();
}

void flow::kick(scalar dt)
{
    if (grains)
    {
        grains->kick(dt);
    }
    if (water)
    {
        water->kick(dt);
    }
}

void flow::relax(scalar dt)
{
    if (water)
    {
        water->relaxViscosity(dt);
    }
    for (phaseDynamics* phase : phases())
    {
        phase->pushOffGround(dt);
    }
    if (coupling)
    {
        coupling->drag(dt);
    }
}

void flow::drift(scalar dt, scalar time)
{
    for (phaseDynamics* phase : phases())
    {
        phase->drift(dt, time);
    }
}

timeStepLimit flow::stableDeltaT() const
{
    timeStepLimit limit = {GREAT, "none"};
    if (grains)
    {
        limit.take(grains->stableDeltaT());
    }
    if (water)
    {
        limit.take(water->stableDeltaT());
    }
    if (coupling)
    {
        limit.take(coupling->stableDeltaT(CFL, rheology->elastic().c()));
    }
    return limit;
}

energyState flow::energy() const
{
    energyState total;
    for (const phaseDynamics* phase : phases())
    {
        total += phase->energy();
    }
    return total;
}

balance flow::ledger() const
{
    balance total;
    for (const phaseDynamics* phase : phases())
    {
        total += phase->ledger;
    }
    return total;
}

scalar flow::mass() const
{
    scalar total = 0;
    for (const phaseDynamics* phase : phases())
    {
        total += phase->mass().value();
    }
    return total;
}

scalar flow::leftMass() const
{
    scalar total = 0;
    for (const phaseDynamics* phase : phases())
    {
        total += phase->ledger.leftMass.value();
    }
    return total;
}

int flow::size() const
{
    int total = 0;
    for (const phaseDynamics* phase : phases())
    {
        total += phase->particles().size();
    }
    return total;
}

scalar flow::maxSpeed() const
{
    scalar fastest = 0;
    for (const phaseDynamics* phase : phases())
    {
        fastest = max(fastest, phase->maxSpeed());
    }
    return fastest;
}

scalar flow::movingMassShare(scalar threshold) const
{
    scalar moving = 0;
    for (const phaseDynamics* phase : phases())
    {
        moving += phase->movingMass(threshold);
    }
    const scalar all = mass();
    return all > 0 ? moving / all : 0;
}

vector flow::wallForceSum() const
{
    return (grains ? grains->wallForceSum() : vector(Zero))
         + (water ? water->wallForceSum() : vector(Zero));
}

bool flow::massCloses() const
{
    const std::vector<phaseDynamics*> all = phases();
    return std::all_of(
        all.begin(),
        all.end(),
        [](const phaseDynamics* phase) { return phase->massCloses(); }
    );
}

scalar flow::meanDrag(const phaseDynamics& phase) const
{
    if (!coupling)
    {
        return 0;
    }
    return phase.massMean(
        &phase == grains.get() ? grains->grains.drag : water->water.drag
    );
}

scalar flow::meanGradPForce(const phaseDynamics& phase) const
{
    if (!coupling)
    {
        return 0;
    }
    return &phase == grains.get() ? phase.massMean(grains->grains.gradPForce)
                                  : coupling->meanGradPForceOfWater();
}

std::size_t flow::bytes() const
{
    std::size_t total = coupling ? coupling->bytes() : 0;
    for (const phaseDynamics* phase : phases())
    {
        total += phase->bytes();
    }
    return total;
}

scalar flow::pairPasses() const
{
    return (grains ? grains->passes() : 0) + (water ? water->pairPasses() : 0)
         + (coupling ? coupling->pairPasses() : 0);
}

scalar flow::pairsOfParticle() const
{
    scalar pairs = 0;
    for (const phaseDynamics* phase : phases())
    {
        pairs += phase->pairs().size().pairs;
    }
    return pairs / max(size(), 1) - 1; // without the particle itself
}

scalar flow::waveSpeed() const
{
    return max(
        grains ? rheology->elastic().c() : 0, water ? state->c0() : scalar(0)
    );
}

std::vector<std::pair<word, passTimes>> flow::times() const
{
    std::vector<std::pair<word, passTimes>> all;
    if (grains)
    {
        all.emplace_back("grains", grains->times);
    }
    if (water)
    {
        all.emplace_back("water", water->times);
    }
    if (coupling)
    {
        all.emplace_back("between", coupling->times);
    }
    return all;
}

int flow::groundPasses() const
{
    return (grains ? 1 + grains->penaltyPasses() : 0)
         + (water ? water->groundPasses() : 0);
}

} // namespace lpf
} // namespace Foam
