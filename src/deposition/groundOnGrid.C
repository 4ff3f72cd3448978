// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundOnGrid.H"


namespace Foam
{
namespace lpf
{

groundOnGrid sampleGround(const ground& bed, const planGrid& grid)
{
    const scalar none = noValue;
    groundOnGrid result{
        scalarField(grid.size(), none), scalarField(grid.size(), none)};

    for (label j = 0; j < grid.ny; ++j)
    {
        for (label i = 0; i < grid.nx; ++i)
        {
            const point c = grid.centre(i, j);
            const groundHit hit = bed.elevation(c.x(), c.y());
            if (hit.found)
            {
                result.elevation[grid.index(i, j)] = hit.nearest.z();
                result.cosSlope[grid.index(i, j)] = hit.normal.z();
            }
        }
    }
    return result;
}


scalarField heightsAbove(const ground& bed, const vectorField& x)
{
    scalarField heights(x.size(), noValue);
    forAll (x, i)
    {
        const groundHit hit = bed.elevation(x[i].x(), x[i].y());
        if (hit.found)
        {
            heights[i] = x[i].z() - hit.nearest.z();
        }
    }
    return heights;
}

} // namespace lpf
} // namespace Foam
