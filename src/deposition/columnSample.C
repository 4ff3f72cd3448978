// SPDX-License-Identifier: GPL-3.0-or-later
#include "columnSample.H"

#include "cellShares.H"
#include "labelList.H"

#include <algorithm>
#include <cmath>
#include <vector>

namespace Foam
{
namespace lpf
{

namespace
{

//- Particles by plan bins at least as wide as their reach
class planBins
{
    scalar x0_, y0_, side_;
    label nx_, ny_;
    labelList start_, particle_;

    static label slot(const scalar p, const label n)
    {
        // as numbers first: a reach may be too large for a label
        return label(max(scalar(0), min(scalar(n - 1), p)));
    }

    label binOf(const point& x) const
    {
        return slot((x.x() - x0_) / side_, nx_)
             + nx_ * slot((x.y() - y0_) / side_, ny_);
    }

public:
    //- Particles further than side outside the grid gather in the border
    //  bins, where the shares that they have are zero
    planBins(const planGrid& grid, const vectorField& x, const scalar side)
        : x0_(grid.x0 - side), y0_(grid.y0 - side), side_(side),
          nx_(label(std::ceil(scalar(grid.nx) * grid.dx / side)) + 2),
          ny_(label(std::ceil(scalar(grid.ny) * grid.dy / side)) + 2),
          start_(nx_ * ny_ + 1, label(0)), particle_(x.size())
    {
        forAll (x, i)
        {
            ++start_[binOf(x[i]) + 1];
        }
        for (label b = 0; b < nx_ * ny_; ++b)
        {
            start_[b + 1] += start_[b];
        }
        labelList next(start_);
        forAll (x, i)
        {
            particle_[next[binOf(x[i])]++] = i;
        }
    }

    //- Visit the particles of all bins within reach of a rectangle, in an
    //  order that does not depend on the cell
    template<class Visit>
    void around(
        const point& centre,
        const scalar reachX,
        const scalar reachY,
        const Visit& visit
    ) const
    {
        const label i0 = slot((centre.x() - reachX - x0_) / side_, nx_);
        const label i1 = slot((centre.x() + reachX - x0_) / side_, nx_);
        const label j0 = slot((centre.y() - reachY - y0_) / side_, ny_);
        const label j1 = slot((centre.y() + reachY - y0_) / side_, ny_);
        for (label j = j0; j <= j1; ++j)
        {
            for (label k = start_[i0 + nx_ * j]; k < start_[i1 + nx_ * j + 1];
                 ++k)
            {
                visit(particle_[k]);
            }
        }
    }
};

//- Part of a column: volume spread evenly over a range of heights
struct segment
{
    scalar lower, upper, volume;
};

//- Height below which the given share of the volume of the column lies, to
//  1e-9 of the volume. The volume below is a polygon over the height: Newton's
//  steps, kept inside of what is known, end in a few
scalar quantile(const std::vector<segment>& column, const scalar share)
{
    scalar low = GREAT, high = -GREAT, total = 0;
    for (const segment& s : column)
    {
        low = min(low, s.lower);
        high = max(high, s.upper);
        total += s.volume;
    }
    scalar z = low + share * (high - low);
    for (label round = 0; round < 60; ++round)
    {
        scalar missing = share * total, slope = 0;
        for (const segment& s : column)
        {
            const scalar density = s.volume / (s.upper - s.lower);
            if (z >= s.upper)
            {
                missing -= s.volume;
            }
            else if (z > s.lower)
            {
                missing -= density * (z - s.lower);
                slope += density;
            }
        }
        if (mag(missing) <= 1e-9 * total)
        {
            break;
        }
        (missing > 0 ? low : high) = z;
        const scalar next = slope > 0 ? z + missing / slope : low;
        z = next > low && next < high ? next : 0.5 * (low + high);
    }
    return z;
}


//- Top of the column; see the header of columnSample
scalar top(const std::vector<segment>& column)
{
    if (column.empty())
    {
        return noValue;
    }
    const scalar low = quantile(column, 0.05);
    const scalar high = quantile(column, 0.95);
    return high + (high - low) * 0.05 / 0.9;
}

//- Everything that one cell gathers from the particles around it
class cellGather
{
    const planGrid& grid_;
    const cloudSample& sample_;
    const scalarField& heights_;
    const cellShares shares_;
    const scalarField size_;
    List<plume> plumes_;
    scalarField sumAll_;

    std::vector<segment> column_;

public:
    scalar volume = 0;
    scalar mass = 0;
    vector momentum = vector::zero;
    scalar maxSpeed = 0;

    cellGather(
        const planGrid& grid,
        const groundOnGrid& bed,
        const cloudSample& sample,
        const scalarField& heights
    )
        : grid_(grid), sample_(sample), heights_(heights),
          shares_(grid, bed, sample.h),
          // Side of the cube, or of the square in a plane strain scene
          size_(
              grid.flat < 0
                  ? scalarField(cbrt(sample.taken()))
                  : scalarField(sqrt(
                      sample.taken() / (grid.flat == 0 ? grid.dx : grid.dy)
                  ))
          ),
          plumes_(sample.size()), sumAll_(sample.size())
    {
        forAll (plumes_, p)
        {
            plume& from = plumes_[p];
            from = {sample.x[p], sample.h[p], hasValue(heights[p])};
            sumAll_[p] = shares_.sumAll(from);
            if (sumAll_[p] <= 0)
            {
                // On a tip of ground that no cell centre sees
                from.isGrounded = false;
                sumAll_[p] = shares_.sumAll(from);
            }
        }
    }

    void clear()
    {
        volume = mass = maxSpeed = 0;
        momentum = vector::zero;
        column_.clear();
    }

    void add(const label i, const label j, const label p)
    {
        const point c = grid_.centre(i, j);
        const vector& x = sample_.x[p];
        const scalar ax = grid_.flat == 0 ? 0 : mag(x.x() - c.x());
        const scalar ay = grid_.flat == 1 ? 0 : mag(x.y() - c.y());
        const scalar reach = 2 * sample_.h[p];

        if (ax <= 0.5 * (grid_.dx + size_[p])
            && ay <= 0.5 * (grid_.dy + size_[p]))
        {
            maxSpeed = max(maxSpeed, mag(sample_.U[p]));
        }
        if (ax > reach + 0.5 * grid_.dx || ay > reach + 0.5 * grid_.dy)
        {
            return;
        }
        const scalar share = shares_.sumCell(i, j, plumes_[p]) / sumAll_[p];
        if (share <= 0)
        {
            return;
        }
        volume += share * sample_.volume[p];
        mass += share * sample_.mass[p];
        momentum += share * sample_.mass[p] * sample_.U[p];
        if (hasValue(heights_[p]))
        {
            const scalar lower = max(scalar(0), heights_[p] - 0.5 * size_[p]);
            // A grain deep below the ground lies on it, thin
            const scalar upper =
                max(heights_[p] + 0.5 * size_[p], lower + 0.01 * size_[p]);
            column_.push_back({lower, upper, share * sample_.volume[p]});
        }
    }

    //- Height of the top above the ground
    scalar depth() const { return top(column_); }
};

} // namespace


columnSample sampleColumns(
    const planGrid& grid,
    const groundOnGrid& bed,
    const cloudSample& sample,
    const scalarField& heights,
    const scalar present
)
{
    const scalarField zero(grid.size(), scalar(0));
    const vectorField none(grid.size(), vector::zero);
    columnSample result{zero, zero, zero, zero, 0, 0, zero, none};
    if (!sample.size())
    {
        return result;
    }

    const scalar reach = 2 * max(sample.h);
    const planBins bins(grid, sample.x, reach);
    cellGather cell(grid, bed, sample, heights);
    for (label c = 0; c < grid.size(); ++c)
    {
        const label i = c % grid.nx, j = c / grid.nx;
        cell.clear();
        bins.around(
            grid.centre(i, j),
            grid.flat == 0 ? GREAT : reach + 0.5 * grid.dx,
            grid.flat == 1 ? GREAT : reach + 0.5 * grid.dy,
            [&](const label p) { cell.add(i, j, p); }
        );
        result.thicknessVertical[c] = cell.volume / grid.cellArea();
        result.maxSpeed[c] = cell.maxSpeed;
        result.volumeInside += cell.volume;
        result.mass[c] = cell.mass;
        result.momentum[c] = cell.momentum;
        if (result.thicknessVertical[c] > present)
        {
            result.depth[c] = cell.depth();
            result.meanSpeed[c] = mag(cell.momentum) / cell.mass;
        }
    }
    result.volumeOutside = sum(sample.volume) - result.volumeInside;
    return result;
}

} // namespace lpf
} // namespace Foam
