// SPDX-License-Identifier: GPL-3.0-or-later
// Which elements of the ground lie behind another sheet of it.
#include "ground.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Ways around an element, over its plane by a share of the spacing: sheets
// that end that near to each other are taken to join
constexpr label nWays = 8;
constexpr scalar joined = 0.05;

// The ways turn and mirror with the element
vector wayAlong(const vector& e1, const vector& e2, const label k)
{
    const scalar diagonal = std::sqrt(0.5);
    const FixedList<scalar, nWays> cosine{
        1, diagonal, 0, -diagonal, -1, -diagonal, 0, diagonal};
    return cosine[k] * e1 + cosine[(k + nWays - 2) % nWays] * e2;
}

} // namespace


DynamicList<elementScreen> ground::screens(
    const surfaceElements& elements, const scalar spacing, const scalar reach
) const
{
    DynamicList<elementScreen> found;
    if (parts_.size() == 1 && !parts_[0].mayCrossItself())
    {
        return found;
    }
    label part = 0;
    forAll (elements.x, q)
    {
        while (q >= elements.ends[part])
        {
            ++part;
        }
        const vector n = elements.nA[q] / mag(elements.nA[q]);
        const point x = elements.x[q] + joined * spacing * n;
        const vector e1 = elements.along[q], e2 = n ^ e1;
        wayHit screen;
        vector way = Zero;
        for (label k = 0; k < nWays; ++k)
        {
            const vector step = reach * wayAlong(e1, e2, k);
            wayHit hit;
            forAll (parts_, i)
            {
                if (i != part || parts_[i].mayCrossItself())
                {
                    parts_[i].meet(x, step, hit);
                }
            }
            if (hit.behind && hit.at < screen.at)
            {
                screen = hit;
                way = step;
            }
        }
        if (screen.behind)
        {
            const vector toElement = elements.x[q] - (x + screen.at * way);
            found.append({q, screen.normal, toElement & screen.normal});
        }
    }
    return found;
}

} // namespace lpf
} // namespace Foam
