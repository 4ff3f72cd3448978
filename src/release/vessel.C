// SPDX-License-Identifier: GPL-3.0-or-later
#include "vessel.H"
#include "inputCheck.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Columns per spacing of the volume integral
constexpr label columnsPerSpacing = 4;

// Rounding errors of lattice and frame over the spacing
constexpr scalar onFace = 1e-6;

} // namespace


vector frame::components(const vector& r) const
{
    const scalar det = edges[0] & (edges[1] ^ edges[2]);
    return vector(
               r & (edges[1] ^ edges[2]),
               r & (edges[2] ^ edges[0]),
               r & (edges[0] ^ edges[1])
           )
         / det;
}


scalar frame::volume() const
{
    return mag(edges[0] & (edges[1] ^ edges[2]));
}


frame frameBetween(const point& a, const point& b, const tensor& axes)
{
    const vector u = axes & (b - a);
    frame result;
    result.corner = a;
    for (direction k = 0; k < 3; ++k)
    {
        const vector e = axes.row(k);
        result.corner += min(u[k], scalar(0)) * e;
        result.edges[k] = mag(u[k]) * e;
    }
    return result;
}


frame readBox(const dictionary& dict, const tensor& axes)
{
    const auto ends = dict.get<List<point>>("box");
    frame result{Zero, {Zero, Zero, Zero}};
    if (ends.size() == 2)
    {
        result = frameBetween(ends[0], ends[1], axes);
    }
    if (!(result.volume() > 0))
    {
        refuse(
            dict,
            "box",
            "box is two opposite corners of a space with a volume,"
            " ((x0 y0 z0) (x1 y1 z1)) [m]; its edges run along the axes of"
            " the lattice."
        );
    }
    return result;
}


//- Columns over the first two edges; one across in plane strain
struct vessel::columnGrid
{
    FixedList<label, 2> n{0, 0};
    label across = -1; //!< edge across the plane, or -1
    scalar at = 0;     //!< its coordinate 0..1 there
    scalar area = 0;   //!< of a column [m2]
};


vessel::vessel(
    const dictionary& dict, const wordList& keywords, const frame& space
)
    : releaseRegion(dict, keywords), frame_(space)
{
}


void vessel::readOutline(const dictionary& dict)
{
    if (!dict.found("outline"))
    {
        return;
    }
    const auto points = dict.get<List<point>>("outline");
    if (points.size() < 3)
    {
        refuse(dict, "outline", "An outline has at least three points.");
    }
    ring r(points.size());
    forAll (points, i)
    {
        const vector s = frame_.coordinates(points[i]);
        r[i] = point2D(s.x(), s.y());
    }
    outline_.rings = List<ring>(1, r);
}


boundBox vessel::plan() const
{
    boundBox box = boundBox(boundBox::invertedBox);
    for (label k = 0; k < 8; ++k)
    {
        box.add(
            frame_.corner + scalar(k & 1) * frame_.edges[0]
            + scalar(k >> 1 & 1) * frame_.edges[1]
            + scalar(k >> 2) * frame_.edges[2]
        );
    }
    return box;
}


void vessel::place(const releaseScene& scene)
{
    releaseRegion::place(scene);
    frame_.corner -= scene.bed.origin();
}


vessel::columnGrid vessel::layOut() const
{
    const lattice& grid = scene_->grid;
    const vector up = unitUp();
    columnGrid result;
    scalar area = 1;
    for (label k = 0; k < 2; ++k)
    {
        const vector& edge = frame_.edges[k];
        result.n[k] =
            max(label(std::ceil(columnsPerSpacing * mag(edge) / grid.spacing)),
                1);
        area /= result.n[k];
        if (grid.acrossAxis >= 0
            && mag(edge & grid.e(direction(grid.acrossAxis)))
                   > (1 - 1e-9) * mag(edge))
        {
            const vector normal = grid.e(direction(grid.acrossAxis));
            result.across = k;
            result.at =
                ((grid.origin - frame_.corner) & normal) / (edge & normal);
            area *= result.n[k] * grid.thickness / mag(edge);
            result.n[k] = 1;
        }
    }
    if (grid.acrossAxis >= 0
        && (result.across < 0 || result.at < 0 || result.at > 1))
    {
        FatalIOErrorInFunction(dict_)
            << "The plane of plane strain, through the lattice origin, does"
            << " not cut this release, or no edge of it is normal to the"
            << " plane." << nl
            << "Move the release or set lattice { origin .. }."
            << exit(FatalIOError);
    }
    result.area = area * mag((frame_.edges[0] ^ frame_.edges[1]) & up);
    return result;
}


scalar vessel::distance(const point& x) const
{
    // far enough to know the side of every point
    const scalar radius = 2 * (scene_->bed.bounds().mag() + plan().mag());
    const groundHit hit = scene_->bed.signedDistance(x, radius);
    return hit.found ? hit.distance : (hit.border ? -VSMALL : radius);
}


scalar vessel::reach(const point& x, const vector& e, const scalar length) const
{
    const scalar shortest = scene_->grid.spacing / (4 * columnsPerSpacing);
    scalar t = 0;
    while (t < length)
    {
        const scalar d = distance(x - t * e);
        if (d < 0)
        {
            break;
        }
        // no ground is nearer than d
        t = min(t + max(d, shortest), length);
    }
    if (distance(x - t * e) >= 0)
    {
        return length;
    }
    // the last step went into the ground
    scalar a = max(t - shortest, scalar(0)), b = t;
    for (label k = 0; k < 48; ++k)
    {
        const scalar m = 0.5 * (a + b);
        (distance(x - m * e) >= 0 ? a : b) = m;
    }
    return a;
}


List<vessel::freeColumn> vessel::freeColumns() const
{
    const columnGrid grid = layOut();
    const vector up = unitUp();
    const scalar length = mag(frame_.edges[2]);
    DynamicList<freeColumn> columns;
    for (label j = 0; j < grid.n[1]; ++j)
    {
        for (label i = 0; i < grid.n[0]; ++i)
        {
            const scalar s = grid.across == 0 ? grid.at : (i + 0.5) / grid.n[0];
            const scalar t = grid.across == 1 ? grid.at : (j + 0.5) / grid.n[1];
            if (outline_.rings.empty() || outline_.contains(point2D(s, t)))
            {
                const point base =
                    frame_.corner + s * frame_.edges[0] + t * frame_.edges[1];
                // the top may lie on a ceiling, but for rounding
                const scalar top = distance(base + length * up) < 0
                                     ? length - onFace * scene_->grid.spacing
                                     : length;
                const scalar free = reach(base + top * up, up, top);
                columns.append({base, grid.area, top - free, length});
            }
        }
    }
    return List<freeColumn>(columns);
}


scalar vessel::volumeBelow(const UList<freeColumn>& columns) const
{
    const scalar rise = surfaceNormal_ & unitUp();
    scalar sum = 0;
    for (const freeColumn& c : columns)
    {
        scalar top = c.to, foot = c.from;
        if (hasSurface_)
        {
            top = min(top, (surfaceHeight_ - (surfaceNormal_ & c.base)) / rise);
        }
        if (hasFloor_)
        {
            foot =
                max(foot,
                    (floorHeight_ - (floorNormal_ & c.base))
                        / (floorNormal_ & unitUp()));
        }
        sum += c.area * max(top - foot, scalar(0));
    }
    return sum;
}


bool vessel::fillTo(const scalar volume, scalar& room)
{
    const List<freeColumn> columns = freeColumns();
    scalar low = GREAT, high = -GREAT;
    for (const freeColumn& c : columns)
    {
        low = min(low, surfaceNormal_ & (c.base + c.from * unitUp()));
        high = max(high, surfaceNormal_ & (c.base + c.to * unitUp()));
    }
    surfaceHeight_ = high;
    room = volumeBelow(columns);
    if (room < volume)
    {
        return false;
    }
    for (label i = 0; i < 60; ++i)
    {
        surfaceHeight_ = 0.5 * (low + high);
        (volumeBelow(columns) < volume ? low : high) = surfaceHeight_;
    }
    return true;
}


bool vessel::fillLevel(const scalar volume, scalar& room)
{
    hasSurface_ = true;
    surfaceNormal_ = scene_->up;
    return (unitUp() & scene_->up) > 0 && fillTo(volume, room);
}


void vessel::refuseExcess(const scalar volume, const scalar room) const
{
    refuse(
        dict_.subDict("water"),
        "excess",
        "Above the bed there is room for " + Foam::name(room)
            + " m3 within the box, the excess is " + Foam::name(volume)
            + " m3. Make the box higher"
    );
}


autoPtr<releaseRegion> vessel::above(const scalar volume) const
{
    autoPtr<vessel> layer(new vessel(*this));
    layer->hasFloor_ = true;
    layer->floorNormal_ = surfaceNormal_;
    layer->floorHeight_ = surfaceHeight_;
    scalar room = 0;
    if (!layer->fillLevel(volume, room))
    {
        refuseExcess(volume, room);
    }
    return autoPtr<releaseRegion>(layer.release());
}


scalar vessel::volume() const
{
    return volumeBelow(freeColumns());
}


bool vessel::contains(const point& x) const
{
    const vector s = frame_.coordinates(x);
    const scalar tolerance = onFace * scene_->grid.spacing;
    for (direction k = 0; k < 3; ++k)
    {
        const scalar little = tolerance / mag(frame_.edges[k]);
        if (s[k] < -little || s[k] >= 1 - little)
        {
            return false;
        }
    }
    return (outline_.rings.empty() || outline_.contains(point2D(s.x(), s.y())))
        && (!hasSurface_ || (surfaceNormal_ & x) < surfaceHeight_ - tolerance)
        && (!hasFloor_ || (floorNormal_ & x) >= floorHeight_ - tolerance);
}


scalar vessel::depth(const point& x) const
{
    const vector e3 = scene_->grid.e(2);
    const scalar s = frame_.coordinates(x).z();
    const scalar perLength = frame_.components(e3).z();
    scalar result = perLength > 0 ? (1 - s) / perLength : GREAT;
    if (hasSurface_ && (surfaceNormal_ & e3) > 0)
    {
        result =
            min(result,
                (surfaceHeight_ - (surfaceNormal_ & x)) / (surfaceNormal_ & e3)
            );
    }
    return result;
}


bool vessel::isFree(const point& x) const
{
    // less than to the top, which may lie on a ceiling
    const scalar height = (1 - frame_.coordinates(x).z()) * mag(frame_.edges[2])
                        - onFace * scene_->grid.spacing;
    return distance(x) >= leastWallDistance * scene_->grid.spacing
        && reach(x, -unitUp(), height) >= height;
}


void vessel::fill(DynamicList<seed>& seeds) const
{
    const lattice& grid = scene_->grid;
    boundBox box = boundBox(boundBox::invertedBox);
    for (label k = 0; k < 8; ++k)
    {
        box.add(grid.coordinates(
            frame_.corner + scalar(k & 1) * frame_.edges[0]
            + scalar(k >> 1 & 1) * frame_.edges[1]
            + scalar(k >> 2) * frame_.edges[2]
        ));
    }
    FixedList<FixedList<label, 2>, 3> range;
    for (direction k = 0; k < 3; ++k)
    {
        range[k] = grid.range(k, box.min()[k], box.max()[k]);
    }
    for (label k = range[2][0]; k <= range[2][1]; ++k)
    {
        for (label j = range[1][0]; j <= range[1][1]; ++j)
        {
            for (label i = range[0][0]; i <= range[0][1]; ++i)
            {
                const point x = grid.centre({i, j, k});
                if (contains(x) && isFree(x))
                {
                    seeds.append({x, depth(x), {i, j}});
                }
            }
        }
    }
}

} // namespace lpf
} // namespace Foam
