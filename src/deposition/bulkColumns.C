// SPDX-License-Identifier: GPL-3.0-or-later
#include "bulkColumns.H"

namespace Foam
{
namespace lpf
{

namespace
{

scalar
depthOf(const phaseColumns& grains, const phaseColumns& water, const label c)
{
    const scalar tg = grains.columns.thicknessVertical[c];
    const scalar tw = water.columns.thicknessVertical[c];
    const bool isGrains = tg > grains.present, isWater = tw > water.present;
    if (isGrains && isWater)
    {
        return max(grains.columns.depth[c], water.columns.depth[c]);
    }
    return isGrains || (!isWater && tg > tw) ? grains.columns.depth[c]
                                             : water.columns.depth[c];
}


template<class T>
Field<T> appended(const Field<T>& a, const Field<T>& b)
{
    Field<T> all(a);
    all.append(b);
    return all;
}

} // namespace


columnSample bulkColumns(
    const planGrid& grid,
    const phaseColumns& grains,
    const phaseColumns& water,
    const scalar present
)
{
    const columnSample &g = grains.columns, &w = water.columns;
    const scalarField zero(grid.size(), scalar(0));
    columnSample bulk{zero, zero, zero, zero, 0, 0, zero, {}};
    bulk.mass = g.mass + w.mass;
    bulk.momentum = g.momentum + w.momentum;
    bulk.maxSpeed = max(g.maxSpeed, w.maxSpeed);
    bulk.volumeOutside = g.volumeOutside + w.volumeOutside;
    forAll (zero, c)
    {
        const scalar solid = g.mass[c] / (grains.density * grid.cellArea());
        const scalar thickness =
            max(g.thicknessVertical[c], solid + w.thicknessVertical[c]);
        bulk.thicknessVertical[c] = thickness;
        bulk.volumeInside += thickness * grid.cellArea();
        if (thickness > present)
        {
            bulk.depth[c] = depthOf(grains, water, c);
            bulk.meanSpeed[c] = mag(bulk.momentum[c]) / bulk.mass[c];
        }
    }
    return bulk;
}


cloudSample joined(const cloudSample& grains, const cloudSample& water)
{
    cloudSample all;
    all.x = appended(grains.x, water.x);
    all.U = appended(grains.U, water.U);
    all.mass = appended(grains.mass, water.mass);
    all.volume = appended(grains.volume, water.volume);
    all.h = appended(grains.h, water.h);
    all.space = appended(grains.taken(), water.taken());
    return all;
}

} // namespace lpf
} // namespace Foam
