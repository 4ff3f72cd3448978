// SPDX-License-Identifier: GPL-3.0-or-later
#include "pictureParts.H"

#include "crs.H"

namespace Foam
{
namespace lpf
{

//- All rings, closed
List<pointField> closedLines(const polygonSet& areas)
{
    DynamicList<pointField> lines;
    for (const polygon& area : areas.polygons)
    {
        for (const ring& points : area.rings)
        {
            pointField line(points.size() + 1);
            forAll (line, k)
            {
                const point2D& x = points[k % points.size()];
                line[k] = point(x.x(), x.y(), 0);
            }
            lines.append(line);
        }
    }
    return List<pointField>(std::move(lines));
}


mapLines pathLines(const deposit& result, const runoutPath& path)
{
    const label n = 400;
    pointField line(n + 1);
    forAll (line, k)
    {
        line[k] = path.position(path.planLength() * scalar(k) / n)
                + result.bed.origin();
    }
    return {
        "path " + path.name(),
        List<pointField>(1, line),
        {{0.35, 0.35, 0.35}, 2.0, 5}};
}


mapContent groundMap(const deposit& result)
{
    mapContent map;
    map.nx = result.grid.nx;
    map.ny = result.grid.ny;
    map.dx = result.grid.dx;
    map.dy = result.grid.dy;
    map.x0 = result.grid.x0 + result.bed.origin().x();
    map.y0 = result.grid.y0 + result.bed.origin().y();
    map.ground = result.bedCells.elevation;
    map.noGround = 0.5 * noValue;
    for (scalar& z : map.ground)
    {
        z += hasValue(z) ? result.bed.origin().z() : 0;
    }
    map.crs = result.bed.crs().empty() ? string() : crsName(result.bed.crs());
    return map;
}


colour phaseColour(const word& cloud)
{
    return cloud == "water" ? colour{0.000, 0.447, 0.698}
                            : colour{0.835, 0.369, 0.000};
}

} // namespace lpf
} // namespace Foam
