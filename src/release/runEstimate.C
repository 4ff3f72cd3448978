// SPDX-License-Identifier: GPL-3.0-or-later
#include "runEstimate.H"

namespace Foam
{
namespace lpf
{

namespace
{

// Ratio of wave speed and speed of the flow: `stiffness` of E auto, its default
constexpr scalar speedRatio = 20;

// Time step over h/c
constexpr scalar courant = 0.3;

// Memory of a dry particle with its share of neighbour search and ground,
// as the flume printed
constexpr scalar bytesPerParticle = 700;

// Speed of the solver, two cores
constexpr scalar particleStepsPerSecond = 1.5e6;

} // namespace


runEstimate estimateRun(const runSize& size)
{
    runEstimate run;
    run.maxSpeed =
        size.maxSpeed > 0
            ? size.maxSpeed
            : Foam::sqrt(2 * size.g * max(size.drop, size.releaseHeight));
    run.waveSpeed =
        speedRatio
        * max(run.maxSpeed / 2, Foam::sqrt(size.g * size.releaseHeight));
    run.timeStep = courant * size.smoothingLength / run.waveSpeed;
    run.steps = size.endTime / run.timeStep;
    run.wallTime = run.steps * size.particles / particleStepsPerSecond;
    run.memory = size.particles * bytesPerParticle;
    return run;
}

} // namespace lpf
} // namespace Foam
