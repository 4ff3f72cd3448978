// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygonTriangles.H"

namespace Foam
{
namespace lpf
{

namespace
{

// Twice the area, as a vector; relative to the first corner
vector outlineArea(const UList<point>& outline)
{
    vector sum = Zero;
    forAll (outline, i)
    {
        sum += (outline[i] - outline[0])
             ^ (outline[outline.fcIndex(i)] - outline[0]);
    }
    return sum;
}


// Twice the area of a b c seen along n, positive when counter-clockwise
scalar area(const point& a, const point& b, const point& c, const vector& n)
{
    return ((b - a) ^ (c - a)) & n;
}


// Corner k may be cut off: it is convex and holds no other corner
bool isEar(
    const UList<point>& x,
    const DynamicList<label>& left,
    const label k,
    const vector& n,
    const scalar least
)
{
    const label a = left[left.rcIndex(k)], b = left[k],
                c = left[left.fcIndex(k)];
    if (!(area(x[a], x[b], x[c], n) > least))
    {
        return false;
    }
    for (const label p : left)
    {
        if (p != a && p != b && p != c && area(x[a], x[b], x[p], n) >= -least
            && area(x[b], x[c], x[p], n) >= -least
            && area(x[c], x[a], x[p], n) >= -least)
        {
            return false;
        }
    }
    return true;
}


// A corner in the middle of a straight line, left over by the cuts
bool isFlat(
    const UList<point>& x,
    const DynamicList<label>& left,
    const label k,
    const vector& n,
    const scalar least
)
{
    const point &a = x[left[left.rcIndex(k)]], &c = x[left[left.fcIndex(k)]];
    return mag(area(a, x[left[k]], c, n)) <= least;
}

// Do the edges from i and from k, that share no corner, meet?
bool meet(const UList<point>& x, const label i, const label k, const vector& n)
{
    const point &a = x[i], &b = x[x.fcIndex(i)];
    const point &c = x[k], &d = x[x.fcIndex(k)];
    const auto sides = [&](scalar p, scalar q)
    { return (p > 0 && q < 0) || (p < 0 && q > 0); };
    return sides(area(a, b, c, n), area(a, b, d, n))
        && sides(area(c, d, a, n), area(c, d, b, n));
}


bool crossesItself(const UList<point>& x, const vector& n)
{
    forAll (x, i)
    {
        for (label k = i + 2; k < x.size(); ++k)
        {
            if (x.fcIndex(k) != i && meet(x, i, k, n))
            {
                return true;
            }
        }
    }
    return false;
}

} // namespace


scalar unevenness(const UList<point>& outline)
{
    const vector twice = outlineArea(outline);
    const vector n = twice / max(mag(twice), VSMALL);
    scalar most = 0, size = 0;
    for (const point& p : outline)
    {
        most = max(most, mag((p - outline[0]) & n));
        size = max(size, mag(p - outline[0]));
    }
    return most / max(size, VSMALL);
}


List<corners> triangulate(const UList<point>& outline)
{
    const vector twice = outlineArea(outline);
    DynamicList<corners> result;
    if (!(mag(twice) > 0))
    {
        return List<corners>();
    }
    const vector n = twice / mag(twice);
    const scalar least = 1e-12 * mag(twice);
    if (crossesItself(outline, n))
    {
        return List<corners>();
    }
    DynamicList<label> left(identity(outline.size()));
    while (left.size() > 3)
    {
        label ear = -1;
        for (label k = 0; k < left.size() && ear < 0; ++k)
        {
            ear = isEar(outline, left, k, n, least) ? k : -1;
        }
        if (ear < 0)
        {
            return List<corners>();
        }
        result.append(corners{
            outline[left[left.rcIndex(ear)]],
            outline[left[ear]],
            outline[left[left.fcIndex(ear)]]});
        left.remove(ear);
    }
    if (!isFlat(outline, left, 0, n, least))
    {
        result.append(corners{
            outline[left[0]], outline[left[1]], outline[left[2]]});
    }
    return List<corners>(result);
}

} // namespace lpf
} // namespace Foam
