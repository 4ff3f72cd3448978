// SPDX-License-Identifier: GPL-3.0-or-later
#include "overlapScore.H"

namespace Foam
{
namespace lpf
{

scalar overlapScore::csi() const
{
    const label either = truePositive + falsePositive + falseNegative;
    return either > 0 ? scalar(truePositive) / scalar(either) : 0;
}


overlapScore compare(const boolList& simulated, const boolList& observed)
{
    overlapScore score;
    forAll (observed, c)
    {
        score.truePositive += label(simulated[c] && observed[c]);
        score.falsePositive += label(simulated[c] && !observed[c]);
        score.falseNegative += label(!simulated[c] && observed[c]);
    }
    return score;
}

} // namespace lpf
} // namespace Foam
