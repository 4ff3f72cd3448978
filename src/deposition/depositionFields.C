// SPDX-License-Identifier: GPL-3.0-or-later
#include "depositionFields.H"

namespace Foam
{
namespace lpf
{

depositionFields::depositionFields(const label nCells)
    : thicknessVertical(nCells, scalar(0)), thicknessNormal(nCells, scalar(0)),
      depth(nCells, scalar(0)), maxThicknessVertical(nCells, scalar(0)),
      maxDepth(nCells, scalar(0)), maxSpeed(nCells, scalar(0)),
      maxParticleSpeed(nCells, scalar(0)), arrivalTime(nCells, noValue)
{
}


void depositionFields::add(
    const scalar time,
    const columnSample& now,
    const groundOnGrid& bed,
    const scalar present
)
{
    thicknessVertical = now.thicknessVertical;
    forAll (arrivalTime, c)
    {
        const scalar thickness = now.thicknessVertical[c];
        const bool grounded = hasValue(bed.elevation[c]);
        const scalar depthNow = grounded ? now.depth[c] : noValue;

        thicknessNormal[c] = grounded ? thickness * bed.cosSlope[c] : noValue;
        depth[c] = depthNow;
        maxThicknessVertical[c] = max(maxThicknessVertical[c], thickness);
        maxDepth[c] = grounded ? max(maxDepth[c], depthNow) : noValue;
        maxSpeed[c] = max(maxSpeed[c], now.meanSpeed[c]);
        maxParticleSpeed[c] = max(maxParticleSpeed[c], now.maxSpeed[c]);
        if (!hasValue(arrivalTime[c]) && thickness > present)
        {
            arrivalTime[c] = time;
        }
    }
}

} // namespace lpf
} // namespace Foam
