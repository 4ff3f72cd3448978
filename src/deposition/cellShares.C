// SPDX-License-Identifier: GPL-3.0-or-later
#include "cellShares.H"

#include "DynamicList.H"
#include "labelList.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

//- Shape of Wendland C2; the factor in front cancels in the shares
inline scalar shape(const scalar q)
{
    if (q >= 2)
    {
        return 0;
    }
    const scalar s = 1 - 0.5 * q;
    return s * s * s * s * (2 * q + 1);
}

//- Cells without ground below and left of a corner, for sums of rectangles
class groundCount
{
    const planGrid& grid_;
    labelList sum_;

    label at(const label i, const label j) const
    {
        return sum_[i + (grid_.nx + 1) * j];
    }

public:
    groundCount(const planGrid& grid, const scalarField& ground)
        : grid_(grid), sum_((grid.nx + 1) * (grid.ny + 1), label(0))
    {
        for (label j = 0; j < grid.ny; ++j)
        {
            for (label i = 0; i < grid.nx; ++i)
            {
                sum_[i + 1 + (grid.nx + 1) * (j + 1)] =
                    at(i + 1, j) + at(i, j + 1) - at(i, j)
                    + (ground[grid.index(i, j)] > 0 ? 0 : 1);
            }
        }
    }

    //- Ground everywhere in the rectangle around a cell, as far as the grid
    bool isWhole(label i, label j, label ri, label rj) const
    {
        const label i0 = max(i - ri, label(0)), j0 = max(j - rj, label(0));
        const label i1 = min(i + ri + 1, grid_.nx);
        const label j1 = min(j + rj + 1, grid_.ny);
        return at(i1, j1) - at(i0, j1) - at(i1, j0) + at(i0, j0) == 0;
    }
};

} // namespace


cellShares::cellShares(
    const planGrid& grid, const groundOnGrid& bed, const scalarField& h
)
    : grid_(grid)
{
    for (int axis = 0; axis < 2; ++axis)
    {
        n_[axis] = axis == grid.flat
                     ? 1
                     : max(label(1), label(std::ceil(2 * side(axis) / min(h))));
        step_[axis] = side(axis) / scalar(n_[axis]);
    }
    findEnds(bed, average(h));
}


//- Cells of one axis within reach of x, as a half-open range
std::pair<label, label>
cellShares::range(const int axis, const scalar x, const scalar reach) const
{
    if (grid_.flat == axis)
    {
        return {0, 1};
    }
    const scalar p = (x - lower(axis)) / side(axis);
    const scalar r = reach / side(axis);
    return {label(std::floor(p - r)), label(std::ceil(p + r))};
}


//- Distance of point k of an axis from x; nothing varies along flat
scalar cellShares::offset(const int axis, const label k, const scalar x) const
{
    return grid_.flat == axis
             ? 0
             : lower(axis) + (scalar(k) + 0.5) * step_[axis] - x;
}


//- Points of a cell along one axis that the kernel reaches, half open: a cell
//  may be much larger than that
std::pair<label, label>
cellShares::points(const int axis, const label cell, const plume& from) const
{
    const label first = cell * n_[axis], last = first + n_[axis];
    if (grid_.flat == axis)
    {
        return {first, last};
    }
    const scalar p = (from.x[direction(axis)] - lower(axis)) / step_[axis];
    const scalar r = 2 * from.h / step_[axis] + 1;
    return {
        max(first, label(std::floor(p - r))),
        min(last, label(std::ceil(p + r)) + 1)};
}


scalar
cellShares::kernelSum(const label i, const label j, const plume& from) const
{
    const auto columns = points(0, i, from), rows = points(1, j, from);
    scalar total = 0;
    for (label k = rows.first; k < rows.second; ++k)
    {
        const scalar sy = sqr(offset(1, k, from.x.y()));
        for (label l = columns.first; l < columns.second; ++l)
        {
            const scalar sx = sqr(offset(0, l, from.x.x()));
            total += shape(sqrt(sx + sy) / from.h);
        }
    }
    return total;
}


//- Of the cells around a particle at the centre of a cell
List<cellShares::neighbour> cellShares::kernelTable(const scalar h) const
{
    const plume probe{grid_.centre(0, 0), h, true};
    const auto columns = range(0, probe.x.x(), 2 * h);
    const auto rows = range(1, probe.x.y(), 2 * h);
    DynamicList<neighbour> table;
    for (label dj = rows.first; dj < rows.second; ++dj)
    {
        for (label di = columns.first; di < columns.second; ++di)
        {
            table.append(neighbour{di, dj, kernelSum(di, dj, probe)});
        }
    }
    return List<neighbour>(std::move(table));
}


template<class Test>
labelList cellShares::nearEnd(
    const List<neighbour>& kernel, const scalarField& ground, const Test& isCut
) const
{
    // Cells with ground that the kernel connects with cells without. Most have
    // none of these around, which a count of the rectangle tells at once
    const groundCount count(grid_, ground);
    label reach[2] = {0, 0};
    for (const neighbour& d : kernel)
    {
        reach[0] = max(reach[0], mag(d.di));
        reach[1] = max(reach[1], mag(d.dj));
    }
    DynamicList<label> near;
    for (label c = 0; c < grid_.size(); ++c)
    {
        if (ground[c] > 0
            && !count.isWhole(c % grid_.nx, c / grid_.nx, reach[0], reach[1])
            && isCut(c))
        {
            near.append(c);
        }
    }
    return labelList(std::move(near));
}


void cellShares::findEnds(const groundOnGrid& bed, const scalar h)
{
    scalarField ground(grid_.size());
    forAll (ground, c)
    {
        ground[c] = hasValue(bed.elevation[c]) ? 1 : 0;
    }
    if (min(ground) > 0)
    {
        return;
    }
    end_ = ground;

    scalar whole = 0;
    const List<cellShares::neighbour> kernel(kernelTable(h));
    for (const neighbour& d : kernel)
    {
        whole += d.K;
    }
    const auto convolved = [&](const label c)
    {
        const label i = c % grid_.nx, j = c / grid_.nx;
        scalar total = 0;
        for (const neighbour& d : kernel)
        {
            total += weight(i + d.di, j + d.dj) * d.K;
        }
        return total;
    };

    const labelList near(nearEnd(
        kernel,
        ground,
        [&](const label c) { return convolved(c) < whole * (1 - 1e-12); }
    ));
    // Eight rounds leave less than a thousandth
    for (label round = 0; round < 8; ++round)
    {
        scalarField next(near.size());
        forAll (near, k)
        {
            const label c = near[k];
            next[k] = sqrt(end_[c] * whole / convolved(c));
        }
        forAll (near, k)
        {
            end_[near[k]] = next[k];
        }
    }
}


scalar
cellShares::sumCell(const label i, const label j, const plume& from) const
{
    if (end_.empty() || !from.isGrounded)
    {
        return kernelSum(i, j, from);
    }
    const scalar a = weight(i, j);
    return a > 0 ? a * kernelSum(i, j, from) : 0;
}


scalar cellShares::sumAll(const plume& from) const
{
    const auto columns = range(0, from.x.x(), 2 * from.h);
    const auto rows = range(1, from.x.y(), 2 * from.h);
    scalar total = 0;
    for (label j = rows.first; j < rows.second; ++j)
    {
        for (label i = columns.first; i < columns.second; ++i)
        {
            total += sumCell(i, j, from);
        }
    }
    return total;
}

} // namespace lpf
} // namespace Foam
