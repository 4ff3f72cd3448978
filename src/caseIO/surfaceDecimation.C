// SPDX-License-Identifier: GPL-3.0-or-later

#include "surfaceDecimation.H"
#include "boundBox.H"

#include <array>
#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using namespace Foam;

using cell = std::array<int, 3>;


scalar area(const pointField& points, const faceList& triangles)
{
    scalar sum = 0;
    for (const face& f : triangles)
    {
        sum += f.mag(points);
    }
    return sum;
}


//- For each point the one that stands for its grid cell: the nearest to the
//  centre of the cell
labelList representatives(const pointField& points, const scalar width)
{
    const point origin = boundBox(points, false).min();
    std::vector<cell> cells(static_cast<std::size_t>(points.size()));
    std::vector<scalar> fromCentre(cells.size());
    forAll (points, i)
    {
        const auto k = static_cast<std::size_t>(i);
        scalar sum = 0;
        for (direction d = 0; d < 3; ++d)
        {
            const scalar at = (points[i][d] - origin[d]) / width;
            cells[k][d] = static_cast<int>(std::floor(at));
            sum += sqr(at - cells[k][d] - 0.5);
        }
        fromCentre[k] = sum;
    }
    std::vector<label> order(cells.size());
    std::iota(order.begin(), order.end(), 0);
    std::sort(
        order.begin(),
        order.end(),
        [&](const label a, const label b)
        {
            const auto i = static_cast<std::size_t>(a);
            const auto j = static_cast<std::size_t>(b);
            return cells[i] != cells[j] ? cells[i] < cells[j]
                 : fromCentre[i] != fromCentre[j]
                     ? fromCentre[i] < fromCentre[j]
                     : a < b; // the same choice on every machine
        }
    );
    labelList standsFor(points.size());
    label first = order.empty() ? 0 : order.front();
    for (const label i : order)
    {
        if (cells[static_cast<std::size_t>(i)]
            != cells[static_cast<std::size_t>(first)])
        {
            first = i;
        }
        standsFor[i] = first;
    }
    return standsFor;
}


//- Triangles that keep three corners, each once, by the labels of old points
std::vector<std::array<label, 3>>
clustered(const faceList& triangles, const labelList& standsFor)
{
    std::vector<std::array<label, 3>> kept;
    for (const face& f : triangles)
    {
        std::array<label, 3> t = {
            standsFor[f[0]], standsFor[f[1]], standsFor[f[2]]};
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
        {
            // smallest first, orientation kept: equal triangles look equal
            std::rotate(
                t.begin(), std::min_element(t.begin(), t.end()), t.end()
            );
            kept.push_back(t);
        }
    }
    std::sort(kept.begin(), kept.end());
    kept.erase(std::unique(kept.begin(), kept.end()), kept.end());
    return kept;
}


//- Keep only the points that the triangles use
void compact(
    pointField& points,
    faceList& triangles,
    const std::vector<std::array<label, 3>>& kept
)
{
    labelList renumbered(points.size(), -1);
    pointField used(points.size());
    label n = 0;
    triangles.setSize(static_cast<label>(kept.size()));
    forAll (triangles, i)
    {
        face f(3);
        for (label k = 0; k < 3; ++k)
        {
            const label old =
                kept[static_cast<std::size_t>(i)][static_cast<std::size_t>(k)];
            if (renumbered[old] < 0)
            {
                renumbered[old] = n;
                used[n++] = points[old];
            }
            f[k] = renumbered[old];
        }
        triangles[i] = f;
    }
    used.setSize(n);
    points.transfer(used);
}

} // namespace


void Foam::lpf::decimate(
    pointField& points, faceList& triangles, const label nMax
)
{
    if (triangles.size() <= nMax)
    {
        return;
    }
    // two triangles a grid cell, as on a plane along the grid
    scalar width = std::sqrt(2 * area(points, triangles) / nMax);
    std::vector<std::array<label, 3>> kept;
    do
    {
        kept = clustered(triangles, representatives(points, width));
        // steep ground meets more cells than its area says
        width *=
            std::max(1.02, std::sqrt(static_cast<scalar>(kept.size()) / nMax));
    } while (kept.size() > static_cast<std::size_t>(nMax));
    compact(points, triangles, kept);
}
