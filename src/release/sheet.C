// SPDX-License-Identifier: GPL-3.0-or-later
#include "sheet.H"
#include "inputCheck.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Columns per spacing along each axis of a volume that has no closed form
constexpr label finer = 4;

// Deviation of the volume up to which columns are rounded plainly
constexpr scalar roundingTolerance = 0.01;


// Numbers from 0 to 1, evenly spread over any patch of columns: the plastic
// sequence of M. Roberts (2018)
scalar spread(const FixedList<label, 2>& column)
{
    const scalar r =
        column[0] * 0.7548776662466927 + column[1] * 0.5698402909980532;
    return r - std::floor(r);
}


label particlesIn(const scalar layers, const scalar roundUp)
{
    // a whole number of layers stays one
    return label(std::floor(layers * (1 + 1e-9) + roundUp));
}


wordList joined(const wordList& a, const wordList& b)
{
    wordList all(a);
    all.append(b);
    return all;
}

} // namespace


template<class Visit>
void sheet::forColumns(const lattice& grid, const Visit& visit) const
{
    const boundBox area = plan();
    const point& origin = scene_->bed.origin();
    const vector from = grid.coordinates(area.min() - origin);
    const vector to = grid.coordinates(area.max() - origin);
    boundBox box(min(from, to), max(from, to));
    // also for axes that are turned about the vertical
    box.add(grid.coordinates(
        point(area.min().x(), area.max().y(), area.min().z()) - origin
    ));
    box.add(grid.coordinates(
        point(area.max().x(), area.min().y(), area.min().z()) - origin
    ));
    const auto ri = grid.range(0, box.min().x(), box.max().x());
    const auto rj = grid.range(1, box.min().y(), box.max().y());
    for (label j = rj[0]; j <= rj[1]; ++j)
    {
        for (label i = ri[0]; i <= ri[1]; ++i)
        {
            const point foot =
                grid.position(vector(grid.centre(0, i), grid.centre(1, j), 0));
            groundHit hit = scene_->bed.elevation(foot.x(), foot.y());
            if (!hit.found)
            {
                hit.nearest = foot;
            }
            const scalar t = thickness(hit);
            if (t > 0)
            {
                visit(FixedList<label, 2>{i, j}, hit, t);
            }
        }
    }
}


sheet::sheet(const dictionary& dict, const wordList& keywords)
    : releaseRegion(dict, joined(keywords, {"position"})),
      below_(
          readChoice(dict, "position", {"onGround", "inGround"}, "onGround")
          == "inGround"
      )
{
}


scalar sheet::thickness(const groundHit& hit) const
{
    const point x = hit.nearest + scene_->bed.origin();
    const scalar t = thicknessAt(x.x(), x.y());
    return normal_ && hit.found ? t / hit.normal.z() : t;
}


scalar sheet::lowering(const scalar x, const scalar y) const
{
    return below_ ? thicknessAt(x, y) : 0;
}


void sheet::place(const releaseScene& scene)
{
    releaseRegion::place(scene);
    const vector z(0, 0, 1);
    if (mag(scene.up - z) > 1e-9 || mag(scene.grid.e(2) - z) > 1e-9)
    {
        FatalIOErrorInFunction(dict_)
            << "A release with a vertical thickness needs gravity along -z and"
            << " an upright lattice." << nl
            << "Remove lattice { axes .. } or turn it about z only."
            << exit(FatalIOError);
    }
    label off = 0;
    point first = Zero;
    forColumns(
        scene_->grid,
        [&](const FixedList<label, 2>&, const groundHit& hit, scalar)
        {
            if (!hit.found && !off++)
            {
                first = hit.nearest + scene_->bed.origin();
            }
        }
    );
    if (off)
    {
        FatalIOErrorInFunction(dict_)
            << off << " columns of the release have no ground beneath, the"
            << " first at (" << first.x() << ' ' << first.y() << ")." << nl
            << "The release reaches out of the elevation model or of its"
            << " window, or lies over cells without data." << nl
            << "Enlarge the window, fill the cells (gdal_fillnodata.py), or"
            << " cut the release." << exit(FatalIOError);
    }
}


scalar sheet::columnVolume() const
{
    lattice fine(scene_->grid);
    fine.spacing /= finer;
    scalar sum = 0;
    forColumns(
        fine,
        [&](const FixedList<label, 2>&, const groundHit&, const scalar t)
        { sum += t; }
    );
    return sum * fine.particleVolume() / fine.spacing;
}


bool sheet::roundingKeepsVolume() const
{
    const scalar s = scene_->grid.spacing;
    scalar exact = 0, rounded = 0;
    forColumns(
        scene_->grid,
        [&](const FixedList<label, 2>&, const groundHit&, const scalar t)
        {
            exact += t / s;
            rounded += particlesIn(t / s, 0.5);
        }
    );
    return mag(rounded - exact) <= roundingTolerance * exact;
}


scalar sheet::depthAt(const point& x) const
{
    const groundHit hit = scene_->bed.elevation(x.x(), x.y());
    if (!hit.found)
    {
        return -1;
    }
    const scalar height = x.z() - hit.nearest.z();
    return height >= 0 ? max(thickness(hit) - height, scalar(-1)) : -1;
}


void sheet::fill(DynamicList<seed>& seeds) const
{
    const scalar s = scene_->grid.spacing;
    const bool plain = roundingKeepsVolume();
    forColumns(
        scene_->grid,
        [&](const FixedList<label, 2>& column,
            const groundHit& hit,
            const scalar t)
        {
            const label n = particlesIn(t / s, plain ? 0.5 : spread(column));
            for (label k = 0; k < n; ++k)
            {
                const scalar height = (k + 0.5) * s;
                seeds.append(
                    {hit.nearest + vector(0, 0, height),
                     max(t - height, scalar(0)),
                     column}
                );
            }
        }
    );
}

} // namespace lpf
} // namespace Foam
