// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangles.H"
#include "foamFile.H"
#include "addToRunTimeSelectionTable.H"

#include <algorithm>
#include <limits>

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(triangles, 0);
addToRunTimeSelectionTable(groundPart, triangles, dictionary);


namespace
{

constexpr label trianglesPerLeaf = 4;

// The tree is halved at the median: 64 levels hold any number of triangles
constexpr label stackSize = 64;

// Surfaces of separate parts that touch differ by rounding errors of the
// input (STL in single precision, corners from sines); relative to the edge
constexpr scalar touching = 1e-5;

boundBox boxOf(const corners& t)
{
    return boundBox(min(t[0], min(t[1], t[2])), max(t[0], max(t[1], t[2])));
}

bool isOpen(const unsigned char bits, const triangleHit::regionType region)
{
    return region != triangleHit::face && (bits >> (region - 1) & 1);
}

} // namespace


triangles::triangles(const UList<corners>& all, const UList<label>& zone)
    : triangles_(all.size()), zone_(all.size())
{
    label used = 0;
    forAll (all, i)
    {
        if (mag(areaVector(all[i])) > 0)
        {
            triangles_[used] = all[i];
            zone_[used++] = zone[i];
        }
    }
    triangles_.resize(used);
    zone_.resize(used);
    prepare();
}


triangles::triangles(const dictionary& dict, const fileName& directory)
{
    const inputFile pointsFile(directory / dict.get<fileName>("points"));
    const List<vector> points = readList<vector>(pointsFile);
    zone_ =
        readList<label>(inputFile(directory / dict.get<fileName>("zoneLabels"))
        );
    if (points.size() != 3 * zone_.size())
    {
        pointsFile.damaged(
            "it has " + std::to_string(points.size())
                + " points where three for each of "
                + std::to_string(zone_.size()) + " triangles are expected",
            nullptr
        );
    }
    triangles_.resize(zone_.size());
    forAll (triangles_, i)
    {
        triangles_[i] = {points[3 * i], points[3 * i + 1], points[3 * i + 2]};
    }
    prepare();
}


void triangles::prepare()
{
    const label n = triangles_.size();
    normal_.resize(n);
    order_.resize(n);
    scalar largest = 0;
    forAll (triangles_, i)
    {
        normal_[i] = unitNormal(triangles_[i]);
        order_[i] = i;
        for (const point& p : triangles_[i])
        {
            largest = max(largest, cmptMax(cmptMag(p)));
        }
    }
    roundOff_ = 4 * std::numeric_limits<scalar>::epsilon() * largest;

    nodes_.clear();
    if (n)
    {
        nodes_.reserve(2 * std::size_t(n));
        buildNode(0, n);
    }
    findOpenEdges();
}


label triangles::buildNode(const label first, const label count)
{
    const label me = label(nodes_.size());
    boundBox box = boxOf(triangles_[order_[first]]);
    for (label k = 1; k < count; ++k)
    {
        const boundBox other = boxOf(triangles_[order_[first + k]]);
        box.min() = min(box.min(), other.min());
        box.max() = max(box.max(), other.max());
    }
    nodes_.push_back({box, first, count});
    if (count <= trianglesPerLeaf)
    {
        return me;
    }

    const vector span = box.span();
    const direction axis = span.x() >= span.y()
                             ? (span.x() >= span.z() ? 0 : 2)
                             : (span.y() >= span.z() ? 1 : 2);
    const label half = count / 2;
    const auto centre = [&](const label i)
    {
        const corners& t = triangles_[i];
        return t[0][axis] + t[1][axis] + t[2][axis];
    };
    std::nth_element(
        order_.begin() + first,
        order_.begin() + first + half,
        order_.begin() + first + count,
        [&](const label a, const label b)
        {
            const scalar ca = centre(a), cb = centre(b);
            return ca != cb ? ca < cb : a < b;
        }
    );
    buildNode(first, half);
    const label second = buildNode(first + half, count - half);
    nodes_[std::size_t(me)].first = second;
    nodes_[std::size_t(me)].count = 0;
    return me;
}


template<class Reach, class Visit>
void triangles::search(const point& x, const Reach& reach, const Visit& visit)
    const
{
    if (nodes_.empty())
    {
        return;
    }
    label stack[stackSize];
    label top = 0;
    stack[top++] = 0;
    while (top)
    {
        const label me = stack[--top];
        const node& here = nodes_[std::size_t(me)];
        if (distanceSqr(here.box, x) > reach())
        {
            continue;
        }
        for (label k = 0; k < here.count; ++k)
        {
            visit(order_[here.first + k]);
        }
        if (!here.count)
        {
            label near = me + 1, far = here.first;
            if (distanceSqr(nodes_[std::size_t(far)].box, x)
                < distanceSqr(nodes_[std::size_t(near)].box, x))
            {
                std::swap(near, far);
            }
            stack[top++] = far;
            stack[top++] = near;
        }
    }
}


bool triangles::touches(const point& x, const scalar tolerance, const label i)
    const
{
    bool found = false;
    search(
        x,
        [&] { return found ? scalar(-1) : sqr(tolerance); },
        [&](const label j)
        {
            found = found
                 || (j != i
                     && nearestOnTriangle(triangles_[j], normal_[j], x).distance
                            <= tolerance);
        }
    );
    return found;
}


unsigned char triangles::openCorners(const label i) const
{
    unsigned char bits = 0;
    for (label k = 0; k < 3; ++k)
    {
        const point& p = triangles_[i][k];
        const scalar tolerance = touching * mag(triangles_[i][(k + 1) % 3] - p);
        search(
            p,
            [&] { return sqr(tolerance); },
            [&](const label j)
            {
                for (label e = 0; e < 3; ++e)
                {
                    const corners& t = triangles_[j];
                    if ((open_[std::size_t(j)] >> e & 1)
                        && (mag(t[e] - p) <= tolerance
                            || mag(t[(e + 1) % 3] - p) <= tolerance))
                    {
                        bits = static_cast<unsigned char>(bits | 8 << k);
                    }
                }
            }
        );
    }
    return bits;
}


void triangles::findOpenEdges()
{
    open_.assign(std::size_t(triangles_.size()), 0);
    forAll (triangles_, i)
    {
        for (label e = 0; e < 3; ++e)
        {
            const point &a = triangles_[i][e], &b = triangles_[i][(e + 1) % 3];
            if (!touches(0.5 * (a + b), touching * mag(b - a), i))
            {
                unsigned char& bits = open_[std::size_t(i)];
                bits = static_cast<unsigned char>(bits | 1 << e);
            }
        }
    }
    std::vector<unsigned char> corner(open_.size());
    forAll (triangles_, i)
    {
        corner[std::size_t(i)] = openCorners(i);
    }
    forAll (triangles_, i)
    {
        unsigned char& bits = open_[std::size_t(i)];
        bits = static_cast<unsigned char>(bits | corner[std::size_t(i)]);
    }
}


boundBox triangles::bounds() const
{
    return nodes_.empty() ? boundBox() : nodes_.front().box;
}


label triangles::nTriangles() const
{
    return triangles_.size();
}


void triangles::nearest(const point& x, const scalar radius, groundHit& hit)
    const
{
    if (!hit.found)
    {
        hit.distance = radius;
    }
    search(
        x,
        [&]
        {
            // with room for a tie
            const scalar d = mag(hit.distance) * (1 + 1e-8) + roundOff_;
            return d * d;
        },
        [&](const label i)
        {
            const triangleHit candidate =
                nearestOnTriangle(triangles_[i], normal_[i], x);
            const rank which = compare(candidate, roundOff_, hit);
            take(
                which,
                candidate,
                normal_[i],
                zone_[i],
                isOpen(open_[std::size_t(i)], candidate.region),
                hit
            );
        }
    );
}


void triangles::elevation(const scalar x, const scalar y, groundHit& hit) const
{
    if (nodes_.empty())
    {
        return;
    }
    label stack[stackSize];
    label top = 0;
    stack[top++] = 0;
    while (top)
    {
        const label me = stack[--top];
        const node& here = nodes_[std::size_t(me)];
        const boundBox& box = here.box;
        if (x < box.min().x() - roundOff_ || x > box.max().x() + roundOff_
            || y < box.min().y() - roundOff_ || y > box.max().y() + roundOff_)
        {
            continue;
        }
        for (label k = 0; k < here.count; ++k)
        {
            const label i = order_[here.first + k];
            scalar z = 0;
            if (verticalMeets(triangles_[i], x, y, z)
                && (!hit.found || z > hit.nearest.z()))
            {
                hit.found = true;
                hit.nearest = point(x, y, z);
                hit.normal = normal_[i];
                hit.zone = zone_[i];
            }
        }
        if (!here.count)
        {
            stack[top++] = me + 1;
            stack[top++] = here.first;
        }
    }
}


void triangles::meet(const point& x, const vector& step, wayHit& hit) const
{
    const scalar radiusSqr = 0.25 * magSqr(step) * (1 + 1e-9);
    search(
        x + 0.5 * step,
        [&] { return radiusSqr; },
        [&](const label i)
        { meetTriangle(triangles_[i], normal_[i], x, step, hit); }
    );
}


void triangles::elements(
    const scalar spacing, const boundBox& within, surfaceElements& elements
) const
{
    forAll (triangles_, i)
    {
        appendElements(triangles_[i], zone_[i], spacing, within, elements);
    }
}


void triangles::sections(
    const scalar spacing, const sectionPlane& plane, surfaceElements& elements
) const
{
    forAll (triangles_, i)
    {
        appendSections(triangles_[i], zone_[i], spacing, plane, elements);
    }
}


void triangles::surface(label, groundMesh& mesh) const
{
    forAll (triangles_, i)
    {
        face f(3);
        forAll (f, k)
        {
            f[k] = mesh.points.size();
            mesh.points.append(triangles_[i][k]);
        }
        mesh.faces.append(f);
        mesh.zone.append(zone_[i]);
    }
}


void triangles::removeZone(const label zone)
{
    label used = 0;
    forAll (triangles_, i)
    {
        if (zone_[i] != zone)
        {
            triangles_[used] = triangles_[i];
            zone_[used++] = zone_[i];
        }
    }
    triangles_.resize(used);
    zone_.resize(used);
    prepare();
}


dictionary triangles::write(const fileName& directory, const word& name) const
{
    List<vector> points(3 * triangles_.size());
    forAll (points, i)
    {
        points[i] = triangles_[i / 3][i % 3];
    }
    const word pointsName = name + "Points", zoneName = name + "Zones";
    const IOstreamOption binary(IOstream::BINARY);
    writeList(directory / pointsName, "vectorField", points, binary);
    writeList(directory / zoneName, "labelList", zone_, binary);

    dictionary dict;
    dict.add("type", typeName);
    dict.add("points", pointsName);
    dict.add("zoneLabels", zoneName);
    return dict;
}

} // namespace lpf
} // namespace Foam
