// SPDX-License-Identifier: GPL-3.0-or-later
#include "runoutPath.H"

#include "DynamicList.H"
#include "ListOps.H"
#include "error.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// A path much longer than its steps is a slip; more points do no harm then
constexpr scalar mostStations = 1e6;

scalar planDistance(const point& a, const point& b)
{
    return std::hypot(b.x() - a.x(), b.y() - a.y());
}

//- Without vertices that repeat the one before in plan
pointField distinct(const pointField& vertices)
{
    DynamicList<point> points;
    for (const point& x : vertices)
    {
        if (points.empty() || planDistance(points.last(), x) > 0)
        {
            points.append(x);
        }
    }
    return pointField(std::move(points));
}

//- Vertices, and points between them no further apart than step
pointField stations(const pointField& vertices, const scalar step)
{
    if (vertices.empty())
    {
        return {};
    }
    DynamicList<point> points;
    points.append(vertices[0]);
    for (label v = 1; v < vertices.size(); ++v)
    {
        const point a = vertices[v - 1];
        const scalar length = planDistance(a, vertices[v]);
        const label n = label(std::ceil(min(length / step, mostStations)));
        for (label k = 1; k <= n; ++k)
        {
            points.append(a + (scalar(k) / scalar(n)) * (vertices[v] - a));
        }
    }
    return pointField(std::move(points));
}

} // namespace


runoutPath::runoutPath(
    const pathLine& line, const ground& bed, const dictionary& context
)
    : name_(line.name), length_(line.length),
      vertices_(distinct(line.vertices)), corner_(vertices_.size(), scalar(0)),
      points_(stations(vertices_, line.step)), plan_(points_.size(), scalar(0)),
      distance_(points_.size(), scalar(0))
{
    if (points_.size() < 2)
    {
        FatalIOErrorInFunction(context)
            << "path " << name_ << " has no two different points in plan"
            << exit(FatalIOError);
    }
    for (point& x : points_)
    {
        const groundHit hit = bed.elevation(x.x(), x.y());
        if (!hit.found && length_ == pathLength::surface)
        {
            FatalIOErrorInFunction(context)
                << "path " << name_ << " leaves the ground at "
                << planText(x + bed.origin())
                << ": its length along the surface is not defined." << nl
                << "End the path on the ground, or write pathLength plan;"
                << exit(FatalIOError);
        }
        x.z() = hit.found ? hit.nearest.z() : 0;
    }
    for (label k = 1; k < vertices_.size(); ++k)
    {
        corner_[k] =
            corner_[k - 1] + planDistance(vertices_[k - 1], vertices_[k]);
    }
    for (label k = 1; k < points_.size(); ++k)
    {
        const scalar planStep = planDistance(points_[k - 1], points_[k]);
        plan_[k] = plan_[k - 1] + planStep;
        distance_[k] =
            distance_[k - 1]
            + (length_ == pathLength::plan ? planStep
                                           : mag(points_[k] - points_[k - 1]));
    }
}


namespace
{

//- Value at a of the polygon through (x, y), x increasing, straight on at
//  its ends
template<class Type>
Type polygonAt(const scalarField& x, const Field<Type>& y, const scalar a)
{
    const label last = x.size() - 1;
    const label below = label(findLower(x, a, 0, lessEqOp<scalar>()));
    const label k = min(last - 1, max(label(0), below));
    return y[k] + (a - x[k]) / (x[k + 1] - x[k]) * (y[k + 1] - y[k]);
}

} // namespace


scalar runoutPath::distance(const scalar s) const
{
    return polygonAt(plan_, distance_, s);
}


scalar runoutPath::planAt(const scalar distance) const
{
    return polygonAt(distance_, plan_, distance);
}


point runoutPath::position(const scalar s) const
{
    return polygonAt(plan_, points_, s);
}


scalar runoutPath::project(const point& x) const
{
    const label last = vertices_.size() - 1;
    scalar nearest = GREAT, result = 0;
    for (label k = 0; k < last; ++k)
    {
        const point& a = vertices_[k];
        const scalar dx = vertices_[k + 1].x() - a.x();
        const scalar dy = vertices_[k + 1].y() - a.y();
        const scalar step = corner_[k + 1] - corner_[k];
        // Position along the step, in steps
        scalar t = ((x.x() - a.x()) * dx + (x.y() - a.y()) * dy) / sqr(step);
        t = k > 0 ? max(scalar(0), t) : t;
        t = k < last - 1 ? min(scalar(1), t) : t;
        const scalar d2 =
            sqr(x.x() - a.x() - t * dx) + sqr(x.y() - a.y() - t * dy);
        if (d2 < nearest)
        {
            nearest = d2;
            result = corner_[k] + t * step;
        }
    }
    return result;
}


scalar runoutPath::front(
    const planGrid& grid, const scalarField& thickness, const scalar limit
) const
{
    const scalar step = 0.25 * min(grid.dx, grid.dy);
    const label n = max(label(1), label(std::ceil(planLength() / step)));
    scalar ahead = 0;
    for (label k = n; k >= 0; --k)
    {
        const scalar s = planLength() * scalar(k) / scalar(n);
        const point x = position(s);
        const scalar here = interpolate(grid, thickness, x.x(), x.y());
        if (here > limit)
        {
            const scalar part =
                k < n ? (here - limit) / (here - ahead) : scalar(0);
            return distance(s + part * planLength() / scalar(n));
        }
        ahead = here;
    }
    return noValue;
}


scalarField runoutPath::massFronts(
    const vectorField& x, const scalarField& mass, const scalarField& shares
) const
{
    scalarField s(x.size());
    forAll (x, i)
    {
        s[i] = project(x[i]);
    }
    const labelList order(sortedOrder(s));
    const scalar total = sum(mass);

    scalarField fronts(shares.size(), noValue);
    forAll (shares, f)
    {
        scalar behind = 0;
        for (const label i : order)
        {
            behind += mass[i];
            if (behind >= shares[f] * total)
            {
                fronts[f] = distance(s[i]);
                break;
            }
        }
    }
    return fronts;
}

} // namespace lpf
} // namespace Foam
