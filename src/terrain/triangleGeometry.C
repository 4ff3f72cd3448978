// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangleGeometry.H"

namespace Foam
{
namespace lpf
{

namespace
{

// Distances that differ by less count as equal. Rounding errors of a distance
// are some 1e-16 of the coordinates, far below it; a real difference of 1e-9
// of the distance decides nothing but the sign within 1e-9 of a bisector
constexpr scalar equallyNear = 1e-9;

triangleHit atPoint(
    const point& nearest,
    const point& x,
    const scalar height,
    const triangleHit::regionType region
)
{
    return {nearest, mag(x - nearest), height, region};
}

} // namespace


vector unitNormal(const corners& t)
{
    const vector n = areaVector(t);
    const scalar length = mag(n);
    return length > 0 ? n / length : vector(Zero);
}


// Regions of Voronoi by signs of dot products: Ericson, Real-Time Collision
// Detection (2005), 5.1.5
triangleHit nearestOnTriangle(const corners& t, const vector& n, const point& x)
{
    const vector ab = t[1] - t[0], ac = t[2] - t[0];
    const vector ax = x - t[0], bx = x - t[1], cx = x - t[2];
    const scalar height = n & ax;

    const scalar d1 = ab & ax, d2 = ac & ax;
    if (d1 <= 0 && d2 <= 0)
    {
        return atPoint(t[0], x, height, triangleHit::corner0);
    }
    const scalar d3 = ab & bx, d4 = ac & bx;
    if (d3 >= 0 && d4 <= d3)
    {
        return atPoint(t[1], x, height, triangleHit::corner1);
    }
    const scalar vc = d1 * d4 - d3 * d2;
    if (vc <= 0 && d1 >= 0 && d3 <= 0)
    {
        const point p = t[0] + (d1 / (d1 - d3)) * ab;
        return atPoint(p, x, height, triangleHit::edge0);
    }
    const scalar d5 = ab & cx, d6 = ac & cx;
    if (d6 >= 0 && d5 <= d6)
    {
        return atPoint(t[2], x, height, triangleHit::corner2);
    }
    const scalar vb = d5 * d2 - d1 * d6;
    if (vb <= 0 && d2 >= 0 && d6 <= 0)
    {
        const point p = t[0] + (d2 / (d2 - d6)) * ac;
        return atPoint(p, x, height, triangleHit::edge2);
    }
    const scalar va = d3 * d6 - d5 * d4;
    if (va <= 0 && d4 - d3 >= 0 && d5 - d6 >= 0)
    {
        const scalar s = (d4 - d3) / ((d4 - d3) + (d5 - d6));
        return atPoint(t[1] + s * (t[2] - t[1]), x, height, triangleHit::edge1);
    }
    // the plane itself, not the corners' sum, so that a plane is exact
    return {x - height * n, mag(height), height, triangleHit::face};
}


bool verticalMeets(const corners& t, scalar x, scalar y, scalar& z)
{
    const vector n = areaVector(t);
    if (!(n.z() > 0))
    {
        return false;
    }
    // edge functions; a rounding error may exclude a point of the edge from
    // both neighbours, so that a little is given
    const scalar little = 1e-12 * n.z();
    for (label i = 0; i < 3; ++i)
    {
        const point &p = t[i], &q = t[(i + 1) % 3];
        const scalar side =
            (q.x() - p.x()) * (y - p.y()) - (q.y() - p.y()) * (x - p.x());
        if (side < -little)
        {
            return false;
        }
    }
    z = t[0].z() - (n.x() * (x - t[0].x()) + n.y() * (y - t[0].y())) / n.z();
    return true;
}


void meetTriangle(
    const corners& t,
    const vector& n,
    const point& x,
    const vector& step,
    wayHit& hit
)
{
    const scalar rise = n & step;
    const scalar share = ((t[0] - x) & n) / (mag(rise) > 0 ? rise : VSMALL);
    if (mag(rise) <= 0 || share < 0 || share > 1
        || share > hit.at * (1 + equallyNear))
    {
        return;
    }
    const point at = x + share * step;
    for (label i = 0; i < 3; ++i)
    {
        const vector edge = t[(i + 1) % 3] - t[i];
        if (((edge ^ (at - t[i])) & n) < -equallyNear * magSqr(edge))
        {
            return;
        }
    }
    const bool behind = rise > 0;
    const bool tie = share >= hit.at * (1 - equallyNear);
    if (!tie || !behind)
    {
        hit = {share, behind, n};
    }
}


scalar distanceSqr(const boundBox& box, const point& x)
{
    scalar sum = 0;
    for (direction k = 0; k < 3; ++k)
    {
        const scalar d =
            max(max(box.min()[k] - x[k], x[k] - box.max()[k]), scalar(0));
        sum += d * d;
    }
    return sum;
}


rank compare(
    const triangleHit& candidate, const scalar roundOff, const groundHit& hit
)
{
    const scalar now = mag(hit.distance);
    const scalar difference = candidate.distance - now;
    if (!hit.found)
    {
        return difference <= 0 ? rank::nearer : rank::further;
    }
    const scalar tolerance = equallyNear * now + roundOff;
    if (mag(difference) <= tolerance)
    {
        return rank::tie;
    }
    return difference < 0 ? rank::nearer : rank::further;
}


void take(
    const rank which,
    const triangleHit& candidate,
    const vector& normal,
    const label zone,
    const bool open,
    groundHit& hit
)
{
    if (which == rank::further)
    {
        return;
    }
    hit.border = open && (which == rank::nearer || hit.border);
    if (which == rank::tie && mag(candidate.height) <= mag(hit.height))
    {
        return;
    }
    hit.found = true;
    hit.nearest = candidate.nearest;
    hit.height = candidate.height;
    hit.distance =
        candidate.height < 0 ? -candidate.distance : candidate.distance;
    hit.normal = normal;
    hit.zone = zone;
}


namespace
{

// Of two boxes side by side one has a point on the face between them
bool isWithin(const boundBox& box, const point& x)
{
    for (direction k = 0; k < 3; ++k)
    {
        if (x[k] < box.min()[k] || x[k] >= box.max()[k])
        {
            return false;
        }
    }
    return true;
}


bool mayBeWithin(const boundBox& box, const corners& t)
{
    return box.overlaps(
        boundBox(min(t[0], min(t[1], t[2])), max(t[0], max(t[1], t[2])))
    );
}


// What is the same for all elements of a triangle
struct elementRequest
{
    label zone;
    scalar spacingSqr;
    const boundBox& within;
};


// Halve across the longest edge until no edge is longer than spacing. nA is
// halved with it, so that the sum over the elements is nA to the last bit.
// Of equally long edges the oldest (age 0: edges of the whole triangle), not
// the first: the corners of a mirror image turn the other way round, and it
// must have the mirrored elements
void bisect(
    const corners& t,
    const FixedList<label, 3>& age,
    const vector& nA,
    const elementRequest& request,
    surfaceElements& elements
)
{
    if (!mayBeWithin(request.within, t))
    {
        return;
    }
    FixedList<scalar, 3> edge;
    for (label i = 0; i < 3; ++i)
    {
        edge[i] = magSqr(t[(i + 1) % 3] - t[i]);
    }
    const scalar longest = max(edge[0], max(edge[1], edge[2]));
    // spacing may be an edge divided by a number: a rounding error must not
    // double the elements
    label i = -1;
    for (label e = 0; e < 3; ++e)
    {
        if (edge[e] >= longest * (1 - 1e-9) && (i < 0 || age[e] < age[i]))
        {
            i = e;
        }
    }
    if (longest <= request.spacingSqr * (1 + 1e-9))
    {
        const point x = (t[0] + t[1] + t[2]) / 3;
        if (isWithin(request.within, x))
        {
            elements.x.append(x);
            elements.nA.append(nA);
            elements.zone.append(request.zone);
            elements.along.append((t[(i + 1) % 3] - t[i]) / std::sqrt(longest));
        }
        return;
    }
    const label j = (i + 1) % 3, k = (i + 2) % 3;
    const label cut = max(age[0], max(age[1], age[2])) + 1;
    const point m = 0.5 * (t[i] + t[j]);
    bisect(
        corners{t[i], m, t[k]},
        FixedList<label, 3>{age[i], cut, age[k]},
        0.5 * nA,
        request,
        elements
    );
    bisect(
        corners{m, t[j], t[k]},
        FixedList<label, 3>{age[i], age[j], cut},
        0.5 * nA,
        request,
        elements
    );
}

} // namespace


void appendElements(
    const corners& t,
    const label zone,
    const scalar spacing,
    const boundBox& within,
    surfaceElements& elements
)
{
    bisect(
        t,
        FixedList<label, 3>(label(0)),
        0.5 * areaVector(t),
        {zone, sqr(spacing), within},
        elements
    );
}


// A corner on the plane counts as on its upper side, so that triangles side by
// side neither both have what they share nor both lack it
void appendSections(
    const corners& t,
    const label zone,
    const scalar spacing,
    const sectionPlane& plane,
    surfaceElements& elements
)
{
    FixedList<scalar, 3> over;
    for (label i = 0; i < 3; ++i)
    {
        over[i] = (t[i] & plane.normal) - plane.offset;
    }
    FixedList<point, 2> end;
    label ends = 0;
    for (label i = 0; i < 3; ++i)
    {
        const label j = (i + 1) % 3;
        if ((over[i] >= 0) != (over[j] >= 0))
        {
            end[ends++] =
                t[i] + (over[i] / (over[i] - over[j])) * (t[j] - t[i]);
        }
    }
    if (ends < 2)
    {
        return;
    }
    const vector way = end[1] - end[0];
    vector n = areaVector(t);
    n -= (n & plane.normal) * plane.normal;
    if (!(mag(way) > 0) || !(mag(n) > 0))
    {
        return;
    }
    // an edge divided by a number has no piece more by rounding
    const scalar pieces = max(1, std::ceil(mag(way) / spacing * (1 - 1e-9)));
    for (label k = 0; k < label(pieces); ++k)
    {
        elements.x.append(end[0] + ((k + 0.5) / pieces) * way);
        elements.nA.append((mag(way) / pieces / mag(n)) * n);
        elements.zone.append(zone);
        elements.along.append(way / mag(way));
    }
}

} // namespace lpf
} // namespace Foam
