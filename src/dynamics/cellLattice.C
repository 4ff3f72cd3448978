// SPDX-License-Identifier: GPL-3.0-or-later
#include "cellLattice.H"

#include "orderedSum.H"

#include "error.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

cellLattice::cellLattice(scalar h, const cyclicBox& cyclic)
{
    for (direction d = 0; d < 3; ++d)
    {
        period_[d] = cyclic.period[d];
        lower_[d] = period_[d] > 0 ? cyclic.lower[d] : 0;
        edge_[d] = 2 * h;
        if (period_[d] > 0)
        {
            edge_[d] = period_[d] / std::floor(period_[d] / (2 * h));
        }
    }
}

inline long cellLattice::cellOf(double x, int d) const
{
    return static_cast<long>(std::floor((x - lower_[d]) / edge_[d]));
}

namespace
{

//- Least and largest of the numbers added
struct range
{
    double least = GREAT, most = -GREAT;

    void operator+=(const range& b)
    {
        least = std::min(least, b.least);
        most = std::max(most, b.most);
    }
};

} // namespace

void cellLattice::boundingBox(
    const realArrays<3>& x, int n, lpfPairs::cellGrid& grid
) const
{
    for (int d = 0; d < 3; ++d)
    {
        const double* xd = x[static_cast<std::size_t>(d)].data();
        const range ends = lpfPairs::orderedSum<range>(
            n,
            [&](int i) {
                return range{xd[i], xd[i]};
            }
        );
        grid.edge[d] = edge_[d];
        grid.lower[d] = lower_[d];
        grid.period[d] = period_[d];
        grid.first[d] = n > 0 ? cellOf(ends.least, d) : 0;
        const long last = n > 0 ? cellOf(ends.most, d) : 0;
        grid.n[d] = static_cast<int>(last - grid.first[d] + 1);
        if (period_[d] > 0)
        {
            grid.first[d] = 0;
            grid.n[d] = static_cast<int>(std::lround(period_[d] / edge_[d]));
        }
    }
}

void cellLattice::cellsOf(
    const realArrays<3>& x,
    int n,
    const lpfPairs::cellGrid& grid,
    indexArray& cell
) const
{
    cell.resize(n);
    lpfPairs::forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                long k[3];
                for (int d = 0; d < 3; ++d)
                {
                    const double xd = x[static_cast<std::size_t>(d)][i];
                    k[d] = cellOf(xd, d) - grid.first[d];
                    // rounding at the upper plane of a cyclic pair
                    k[d] = std::min<long>(std::max(k[d], 0L), grid.n[d] - 1);
                }
                cell[i] = static_cast<std::int32_t>(
                    (k[2] * grid.n[1] + k[1]) * grid.n[0] + k[0]
                );
            }
        }
    );
}

namespace
{

//- Offsets of the cells; is the order no longer that of the cells?
void countCells(const indexArray& cell, int n, sortedCells& cells)
{
    cells.moved = false;
    for (int i = 0; i < n; ++i)
    {
        ++cells.start[static_cast<std::size_t>(cell[i]) + 1];
        cells.moved = cells.moved || (i > 0 && cell[i] < cell[i - 1]);
    }
    for (std::size_t c = 0; c + 1 < cells.start.size(); ++c)
    {
        cells.start[c + 1] += cells.start[c];
    }
}

//- Stable order by cell; start serves as a cursor and is shifted back
void fillOrder(
    const indexArray& cell, int n, indexArray& order, sortedCells& cells
)
{
    for (int i = 0; i < n; ++i)
    {
        order[cells.start[static_cast<std::size_t>(cell[i])]++] = i;
    }
    for (std::size_t c = cells.start.size() - 1; c > 0; --c)
    {
        cells.start[c] = cells.start[c - 1];
    }
    cells.start[0] = 0;
}

} // namespace

void cellLattice::sort(
    const realArrays<3>& x, int n, indexArray& order, sortedCells& cells
) const
{
    lpfPairs::cellGrid& grid = cells.grid;
    boundingBox(x, n, grid);

    const double count = 1.0 * grid.n[0] * grid.n[1] * grid.n[2];
    if (!(count < 2e9))
    {
        FatalErrorInFunction
            << "The particles span " << grid.n[0] << " x " << grid.n[1] << " x "
            << grid.n[2] << " cells of " << grid.edge[0]
            << " m: some of them have left far behind the others. Give the "
            << "ground a smaller extent or the particles a larger spacing"
            << exit(FatalError);
    }

    indexArray cell;
    cellsOf(x, n, grid, cell);
    cells.start.assign(static_cast<std::size_t>(count) + 1, 0);
    countCells(cell, n, cells);
    if (cells.moved)
    {
        fillOrder(cell, n, order, cells);
    }
    grid.start = cells.start.data();
}

} // namespace lpf
} // namespace Foam
