// SPDX-License-Identifier: GPL-3.0-or-later
#include "heightField.H"
#include "foamFile.H"
#include "addToRunTimeSelectionTable.H"

#include <cmath>
#include <limits>

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(heightField, 0);
addToRunTimeSelectionTable(groundPart, heightField, dictionary);


namespace
{

// Cell that holds a coordinate in cells, or the nearest one
label place(const scalar s, const label last)
{
    return s > 0 ? (s < last ? label(s) : last) : 0;
}

} // namespace


heightField::heightField(
    const heightGrid& grid, scalarField&& z, const label zone
)
    : grid_(grid), z_(std::move(z)), zone_(zone)
{
    prepare();
}


heightField::heightField(const dictionary& dict, const fileName& directory)
    : zone_(dict.get<label>("zoneLabel"))
{
    const inputFile gridFile(directory / dict.get<fileName>("grid"));
    const List<scalar> place = readList<scalar>(gridFile);
    const FixedList<label, 2> size(dict.lookup("size"));
    const inputFile heightsFile(directory / dict.get<fileName>("heights"));
    z_ = readList<scalar>(heightsFile);
    if (place.size() != 4)
    {
        gridFile.damaged("it does not hold x0 y0 dx dy", nullptr);
    }
    grid_ = {size[0], size[1], place[0], place[1], place[2], place[3]};
    if (z_.size() != size[0] * size[1])
    {
        heightsFile.damaged(
            "it has " + std::to_string(z_.size()) + " heights where "
                + std::to_string(size[0]) + " x " + std::to_string(size[1])
                + " are expected",
            nullptr
        );
    }
    prepare();
}


void heightField::prepare()
{
    scalar low = hole(), high = -hole();
    for (const scalar z : z_)
    {
        if (z < hole())
        {
            low = min(low, z);
            high = max(high, z);
        }
    }
    if (low > high)
    {
        bounds_ = boundBox();
        return;
    }
    const point from(grid_.x0, grid_.y0, low);
    const point to(
        grid_.x0 + (grid_.nx - 1) * grid_.dx,
        grid_.y0 + (grid_.ny - 1) * grid_.dy,
        high
    );
    bounds_ = boundBox(from, to);
    roundOff_ = 4 * std::numeric_limits<scalar>::epsilon()
              * max(cmptMax(cmptMag(from)), cmptMax(cmptMag(to)));
}


point heightField::position(const label v) const
{
    const label j = v / grid_.nx, i = v - j * grid_.nx;
    return point(grid_.x0 + i * grid_.dx, grid_.y0 + j * grid_.dy, z_[v]);
}


corners heightField::cornersOf(const FixedList<label, 3>& vertices) const
{
    return {
        position(vertices[0]), position(vertices[1]), position(vertices[2])};
}


heightField::cellTriangles heightField::cell(const label i, const label j) const
{
    // counter-clockwise seen from above
    const FixedList<label, 4> v{
        vertex(i, j), vertex(i + 1, j), vertex(i + 1, j + 1), vertex(i, j + 1)};
    label holes = 0, last = -1;
    forAll (v, k)
    {
        if (isHole(v[k]))
        {
            ++holes;
            last = k;
        }
    }
    cellTriangles result;
    if (holes == 0)
    {
        // first corner of the diagonal
        const label k =
            mag(z_[v[0]] - z_[v[2]]) <= mag(z_[v[1]] - z_[v[3]]) ? 0 : 1;
        result.count = 2;
        result.vertices[0] = {v[k], v[k + 1], v[k + 2]};
        result.vertices[1] = {v[k], v[k + 2], v[(k + 3) % 4]};
    }
    else if (holes == 1)
    {
        result.count = 1;
        result.vertices[0] = {
            v[(last + 1) % 4], v[(last + 2) % 4], v[(last + 3) % 4]};
    }
    return result;
}


bool heightField::isOpenVertex(const label v) const
{
    const label j = v / grid_.nx, i = v - j * grid_.nx;
    // With the four neighbours there, each of the four cells around has at
    // least the triangle at this vertex
    return i == 0 || j == 0 || i == grid_.nx - 1 || j == grid_.ny - 1
        || isHole(v - 1) || isHole(v + 1) || isHole(v - grid_.nx)
        || isHole(v + grid_.nx);
}


bool heightField::isOpenEdge(const label v, const label w) const
{
    const label jv = v / grid_.nx, iv = v - jv * grid_.nx;
    const label jw = w / grid_.nx, iw = w - jw * grid_.nx;
    if (iv != iw && jv != jw)
    {
        return isHole(vertex(iv, jw)) || isHole(vertex(iw, jv));
    }
    // A side of two cells: each gives a triangle when one more vertex is there
    const label di = (iv == iw) ? 1 : 0, dj = 1 - di;
    for (const label side : {-1, 1})
    {
        const label i = iv + side * di, j = jv + side * dj;
        if (i < 0 || j < 0 || i >= grid_.nx || j >= grid_.ny)
        {
            return true;
        }
        const label shift = vertex(side * di, side * dj);
        if (isHole(v + shift) && isHole(w + shift))
        {
            return true;
        }
    }
    return false;
}


bool heightField::isOpen(
    const FixedList<label, 3>& vertices, const triangleHit::regionType region
) const
{
    switch (region)
    {
    case triangleHit::face:
        return false;
    case triangleHit::edge0:
        return isOpenEdge(vertices[0], vertices[1]);
    case triangleHit::edge1:
        return isOpenEdge(vertices[1], vertices[2]);
    case triangleHit::edge2:
        return isOpenEdge(vertices[2], vertices[0]);
    default:
        return isOpenVertex(vertices[region - triangleHit::corner0]);
    }
}


boundBox heightField::bounds() const
{
    return bounds_;
}


label heightField::nTriangles() const
{
    label n = 0;
    for (label j = 0; j < grid_.ny - 1; ++j)
    {
        for (label i = 0; i < grid_.nx - 1; ++i)
        {
            n += cell(i, j).count;
        }
    }
    return n;
}


bool heightField::isFar(
    const label i, const label j, const point& x, const groundHit& hit
) const
{
    scalar low = hole(), high = -hole();
    for (const label v :
         {vertex(i, j),
          vertex(i + 1, j),
          vertex(i, j + 1),
          vertex(i + 1, j + 1)})
    {
        if (!isHole(v))
        {
            low = min(low, z_[v]);
            high = max(high, z_[v]);
        }
    }
    const point from(grid_.x0 + i * grid_.dx, grid_.y0 + j * grid_.dy, low);
    const point to(
        grid_.x0 + (i + 1) * grid_.dx, grid_.y0 + (j + 1) * grid_.dy, high
    );
    // with room for a tie
    const scalar reach = mag(hit.distance) * (1 + 1e-8) + roundOff_;
    return low > high || distanceSqr(boundBox(from, to), x) > sqr(reach);
}


void heightField::nearestInCell(
    const label i, const label j, const point& x, groundHit& hit
) const
{
    if (isFar(i, j, x, hit))
    {
        return;
    }
    const cellTriangles here = cell(i, j);
    for (label k = 0; k < here.count; ++k)
    {
        const corners t = cornersOf(here.vertices[k]);
        const vector n = unitNormal(t);
        const triangleHit candidate = nearestOnTriangle(t, n, x);
        const rank which = compare(candidate, roundOff_, hit);
        if (which != rank::further)
        {
            const bool open = isOpen(here.vertices[k], candidate.region);
            take(which, candidate, n, zone_, open, hit);
        }
    }
}


void heightField::nearest(const point& x, const scalar radius, groundHit& hit)
    const
{
    if (!hit.found)
    {
        hit.distance = radius;
    }
    const label mx = grid_.nx - 2, my = grid_.ny - 2;
    const scalar reach = mag(hit.distance);
    if (mx < 0 || my < 0 || x.x() < bounds_.min().x() - reach
        || x.x() > bounds_.max().x() + reach
        || x.y() < bounds_.min().y() - reach
        || x.y() > bounds_.max().y() + reach)
    {
        return;
    }
    const label ci = place((x.x() - grid_.x0) / grid_.dx, mx);
    const label cj = place((x.y() - grid_.y0) / grid_.dy, my);
    const scalar side = min(grid_.dx, grid_.dy);
    const label rings = max(max(ci, mx - ci), max(cj, my - cj));
    nearestInCell(ci, cj, x, hit);
    for (label r = 1; r <= rings; ++r)
    {
        // x is in the centre cell or outside of the grid: ring r is at least
        // r - 1 cells away
        if ((r - 1) * side > mag(hit.distance) * (1 + 1e-8) + roundOff_)
        {
            break;
        }
        for (label j = max(cj - r, 0); j <= min(cj + r, my); ++j)
        {
            const bool whole = (j == cj - r || j == cj + r);
            const label step = whole ? 1 : 2 * r;
            for (label i = ci - r; i <= ci + r; i += step)
            {
                if (i >= 0 && i <= mx)
                {
                    nearestInCell(i, j, x, hit);
                }
            }
        }
    }
}


void heightField::elevation(const scalar x, const scalar y, groundHit& hit)
    const
{
    const label mx = grid_.nx - 2, my = grid_.ny - 2;
    const scalar s = (x - grid_.x0) / grid_.dx, t = (y - grid_.y0) / grid_.dy;
    if (mx < 0 || my < 0 || !(s >= -1e-12 * grid_.nx)
        || !(t >= -1e-12 * grid_.ny) || s > (mx + 1) * (1 + 1e-12)
        || t > (my + 1) * (1 + 1e-12))
    {
        return;
    }
    const label i = min(label(max(s, scalar(0))), mx);
    const label j = min(label(max(t, scalar(0))), my);
    const cellTriangles here = cell(i, j);
    for (label k = 0; k < here.count; ++k)
    {
        const corners c = cornersOf(here.vertices[k]);
        scalar z = 0;
        if (verticalMeets(c, x, y, z) && (!hit.found || z > hit.nearest.z()))
        {
            hit.found = true;
            hit.nearest = point(x, y, z);
            hit.normal = unitNormal(c);
            hit.zone = zone_;
        }
    }
}


void heightField::meet(const point& x, const vector& step, wayHit& hit) const
{
    const label mx = grid_.nx - 2, my = grid_.ny - 2;
    const boundBox way(min(x, x + step), max(x, x + step));
    if (mx < 0 || my < 0 || !bounds_.overlaps(way))
    {
        return;
    }
    const vector cell(grid_.dx, grid_.dy, 1);
    const point corner(grid_.x0, grid_.y0, 0);
    const vector from = cmptDivide(way.min() - corner, cell);
    const vector to = cmptDivide(way.max() - corner, cell);
    for (label j = place(from.y(), my); j <= place(to.y(), my); ++j)
    {
        for (label i = place(from.x(), mx); i <= place(to.x(), mx); ++i)
        {
            const cellTriangles here = this->cell(i, j);
            for (label k = 0; k < here.count; ++k)
            {
                const corners t = cornersOf(here.vertices[k]);
                meetTriangle(t, unitNormal(t), x, step, hit);
            }
        }
    }
}


void heightField::elements(
    const scalar spacing, const boundBox& within, surfaceElements& elements
) const
{
    const label mx = grid_.nx - 2, my = grid_.ny - 2;
    const vector cell(grid_.dx, grid_.dy, 1);
    const point corner(grid_.x0, grid_.y0, 0);
    const vector from = cmptDivide(within.min() - corner, cell);
    const vector to = cmptDivide(within.max() - corner, cell);
    for (label j = place(from.y(), my); j <= place(to.y(), my); ++j)
    {
        for (label i = place(from.x(), mx); i <= place(to.x(), mx); ++i)
        {
            const cellTriangles here = this->cell(i, j);
            for (label k = 0; k < here.count; ++k)
            {
                appendElements(
                    cornersOf(here.vertices[k]),
                    zone_,
                    spacing,
                    within,
                    elements
                );
            }
        }
    }
}


void heightField::sections(
    const scalar spacing, const sectionPlane& plane, surfaceElements& elements
) const
{
    for (label j = 0; j < grid_.ny - 1; ++j)
    {
        for (label i = 0; i < grid_.nx - 1; ++i)
        {
            const cellTriangles here = this->cell(i, j);
            for (label k = 0; k < here.count; ++k)
            {
                appendSections(
                    cornersOf(here.vertices[k]), zone_, spacing, plane, elements
                );
            }
        }
    }
}


void heightField::surface(const label most, groundMesh& mesh) const
{
    // every n-th vertex of both directions; the far rows may be left out
    label stride = 1;
    const auto count = [&]
    {
        const label nx = (grid_.nx - 1) / stride;
        const label ny = (grid_.ny - 1) / stride;
        return 2.0 * nx * ny;
    };
    while (count() > most)
    {
        ++stride;
    }
    const label nx = (grid_.nx - 1) / stride + 1;
    const label ny = (grid_.ny - 1) / stride + 1;
    if (nx < 2 || ny < 2)
    {
        return;
    }
    scalarField z(nx * ny);
    forAll (z, v)
    {
        z[v] = z_[vertex(v % nx * stride, v / nx * stride)];
    }
    const heightField coarse(
        {nx, ny, grid_.x0, grid_.y0, stride * grid_.dx, stride * grid_.dy},
        std::move(z),
        zone_
    );
    const label first = mesh.points.size();
    forAll (coarse.z_, v)
    {
        // a hole is used by no face; its height must not blow up the display
        point p = coarse.position(v);
        p.z() = coarse.isHole(v) ? bounds_.min().z() : p.z();
        mesh.points.append(p);
    }
    for (label c = 0; c < (nx - 1) * (ny - 1); ++c)
    {
        const cellTriangles here = coarse.cell(c % (nx - 1), c / (nx - 1));
        for (label k = 0; k < here.count; ++k)
        {
            face f(3);
            forAll (f, m)
            {
                f[m] = first + here.vertices[k][m];
            }
            mesh.faces.append(f);
            mesh.zone.append(zone_);
        }
    }
}


void heightField::removeZone(const label zone)
{
    if (zone == zone_)
    {
        z_ = hole();
        prepare();
    }
}


dictionary heightField::write(const fileName& directory, const word& name) const
{
    const word gridName = name + "Grid", heightsName = name + "Heights";
    const IOstreamOption binary(IOstream::BINARY);
    const List<scalar> place{grid_.x0, grid_.y0, grid_.dx, grid_.dy};
    writeList(directory / gridName, "scalarField", place, binary);
    writeList(directory / heightsName, "scalarField", z_, binary);

    dictionary dict;
    dict.add("type", typeName);
    dict.add("size", FixedList<label, 2>{grid_.nx, grid_.ny});
    dict.add("grid", gridName);
    dict.add("heights", heightsName);
    dict.add("zoneLabel", zone_);
    return dict;
}

} // namespace lpf
} // namespace Foam
