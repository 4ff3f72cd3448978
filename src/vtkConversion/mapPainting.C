// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapPainting.H"

#include "axisTicks.H"
#include "DynamicList.H"

#include <vtkCellArray.h>
#include <vtkDoubleArray.h>
#include <vtkFlyingEdges2D.h>
#include <vtkImageData.h>
#include <vtkNew.h>
#include <vtkPointData.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace Foam
{
namespace lpf
{

namespace
{

const colour dark{0.1, 0.1, 0.1};

//- Light on level ground
constexpr scalar levelShade = 0.86;

constexpr scalar captionLine = 34;
const textStyle captionStyle{21, dark, anchor::left, false, false};


//- Light on each cell from the gradient of the ground, as a shade of grey
scalarField relief(const mapContent& map)
{
    scalarField shade(map.nx * map.ny, scalar(1));
    const auto z = [&](const label i, const label j, const scalar deflt)
    {
        const label c = min(max(i, label(0)), map.nx - 1)
                      + map.nx * min(max(j, label(0)), map.ny - 1);
        return map.ground[c] > map.noGround ? map.ground[c] : deflt;
    };
    // Cells between the two neighbours, one of which is missing at an edge
    const auto span = [](const label k, const label n)
    { return scalar(k > 0 && k < n - 1 ? 2 : 1); };
    // Unit vector to the sun: north-west, 45 degrees high
    const vector sun(-0.5, 0.5, std::sqrt(0.5));
    for (label j = 0; j < map.ny; ++j)
    {
        for (label i = 0; i < map.nx; ++i)
        {
            const scalar here = map.ground[i + map.nx * j];
            if (here > map.noGround)
            {
                const vector normal(
                    -(z(i + 1, j, here) - z(i - 1, j, here)) / span(i, map.nx)
                        / map.dx,
                    -(z(i, j + 1, here) - z(i, j - 1, here)) / span(j, map.ny)
                        / map.dy,
                    1
                );
                const scalar light = (normal & sun) / mag(normal);
                shade[i + map.nx * j] = std::clamp(
                    levelShade + 0.55 * (light - sun.z()), 0.35, 1.0
                );
            }
        }
    }
    return shade;
}


//- The four cells around a position and their weights. Cells without ground
//  and deposit have none: the layer in a flume does not fade out beyond its
//  walls. Nothing is painted where the nearest cell is one of those
struct stencil
{
    label cell[4];
    scalar weight[4];
    bool isPainted;

    scalar operator()(const scalarField& f) const
    {
        scalar sum = 0;
        for (int k = 0; k < 4; ++k)
        {
            sum += weight[k] > 0 ? weight[k] * f[cell[k]] : 0;
        }
        return sum;
    }
};


bool isKnown(const mapContent& map, const label c)
{
    return map.ground[c] > map.noGround || map.value[c] > 0;
}


//- p, q: position in units of cells from the lower left centre
stencil around(const mapContent& map, scalar p, scalar q)
{
    p = std::clamp(p, scalar(0), scalar(map.nx - 1));
    q = std::clamp(q, scalar(0), scalar(map.ny - 1));
    const label i = min(label(p), max(map.nx - 2, label(0)));
    const label j = min(label(q), max(map.ny - 2, label(0)));
    const label right = map.nx > 1 ? 1 : 0, up = map.ny > 1 ? map.nx : 0;
    const label c = i + map.nx * j;
    const scalar a = p - scalar(i), b = q - scalar(j);

    stencil s{
        {c, c + right, c + up, c + up + right},
        {(1 - a) * (1 - b), a * (1 - b), (1 - a) * b, a * b},
        isKnown(map, c + (a > 0.5 ? right : 0) + (b > 0.5 ? up : 0))};
    scalar total = 0;
    for (int k = 0; k < 4; ++k)
    {
        s.weight[k] = isKnown(map, s.cell[k]) ? s.weight[k] : 0;
        total += s.weight[k];
    }
    for (scalar& w : s.weight)
    {
        w = total > 0 ? w / total : 0;
    }
    return s;
}


} // namespace


pointField
outlineOf(const scalar x0, const scalar y0, const scalar x1, const scalar y1)
{
    return pointField({
        point(x0, y0, 0),
        point(x1, y0, 0),
        point(x1, y1, 0),
        point(x0, y1, 0),
        point(x0, y0, 0),
    });
}


void paintCells(
    painter& picture,
    const mapContent& map,
    const mapFrame& place,
    const scalar top
)
{
    const scalarField shade(relief(map));
    for (label y = label(place.y0); y < label(place.y1) + 1; ++y)
    {
        for (label x = label(place.x0); x < label(place.x1) + 1; ++x)
        {
            const stencil near = around(
                map,
                (scalar(x) + 0.5 - place.x0) / (place.scale * map.dx) - 0.5,
                (scalar(y) + 0.5 - place.y0) / (place.scale * map.dy) - 0.5
            );
            if (!near.isPainted)
            {
                continue;
            }
            const scalar grey = near(shade);
            const scalar value = near(map.value);
            colour ink{grey, grey, grey};
            if (value > map.valueFrom)
            {
                // A little of the relief shows through, the colour stays
                // that of the bar
                const scalar light = min(1.0, 1 + 0.2 * (grey - levelShade));
                const colour c = map.colours(value / top);
                ink = {light * c.r, light * c.g, light * c.b};
            }
            picture.blend(x, y, ink, 1);
        }
    }
}


namespace
{

//- Lowest and highest ground; highest < lowest when there is none
std::pair<scalar, scalar> groundRange(const mapContent& map)
{
    scalar low = VGREAT, high = -VGREAT;
    for (const scalar z : map.ground)
    {
        if (z > map.noGround)
        {
            low = min(low, z);
            high = max(high, z);
        }
    }
    return {low, high};
}


//- All four cells around a position between cell centres have ground
bool isOnGround(const mapContent& map, const scalar p, const scalar q)
{
    const label i = label(p), i1 = min(i + 1, map.nx - 1);
    const label j = label(q), j1 = min(j + 1, map.ny - 1);
    return map.ground[i + map.nx * j] > map.noGround
        && map.ground[i1 + map.nx * j] > map.noGround
        && map.ground[i + map.nx * j1] > map.noGround
        && map.ground[i1 + map.nx * j1] > map.noGround;
}


//- Contours of the ground through VTK; pairs of points, world coordinates
List<pointField> groundContours(const mapContent& map, const scalar interval)
{
    const auto [low, high] = groundRange(map);
    if (map.nx < 2 || map.ny < 2 || high < low)
    {
        return {};
    }
    // Where there is no ground: the lowest, and what is drawn there is cut
    vtkNew<vtkDoubleArray> values;
    for (const scalar z : map.ground)
    {
        values->InsertNextValue(z > map.noGround ? z : low);
    }
    vtkNew<vtkImageData> image;
    image->SetDimensions(int(map.nx), int(map.ny), 1);
    image->GetPointData()->SetScalars(values);
    vtkNew<vtkFlyingEdges2D> edges;
    edges->SetInputData(image);
    const scalarField levels(ticks(low, high, interval));
    forAll (levels, k)
    {
        edges->SetValue(int(k), levels[k]);
    }
    edges->Update();

    vtkPolyData* result = edges->GetOutput();
    vtkNew<vtkIdList> ids;
    DynamicList<pointField> segments;
    auto* cells = result->GetLines();
    for (cells->InitTraversal(); cells->GetNextCell(ids);)
    {
        pointField segment(2);
        bool isKnownGround = true;
        for (label k = 0; k < 2; ++k)
        {
            const double* p = result->GetPoint(ids->GetId(k));
            isKnownGround = isKnownGround && isOnGround(map, p[0], p[1]);
            segment[k] = point(
                map.x0 + (p[0] + 0.5) * map.dx,
                map.y0 + (p[1] + 0.5) * map.dy,
                0
            );
        }
        if (isKnownGround)
        {
            segments.append(segment);
        }
    }
    return List<pointField>(std::move(segments));
}


//- World coordinates to pixels
pointField
pixels(const mapContent& map, const mapFrame& place, const pointField& line)
{
    pointField result(line.size());
    forAll (line, k)
    {
        result[k] = point(
            place.x0 + place.scale * (line[k].x() - map.x0),
            place.y0 + place.scale * (line[k].y() - map.y0),
            0
        );
    }
    return result;
}


//- Round interval between contours of the ground, about 25 of them; 0: level
scalar contourInterval(const mapContent& map)
{
    const auto [low, high] = groundRange(map);
    const scalar smallest = 1e-3 * scalar(map.nx) * map.dx;
    return high - low > smallest ? roundStep(high - low, 25) : 0;
}


} // namespace


void paintLines(painter& picture, const mapContent& map, const mapFrame& place)
{
    picture.clip(
        label(place.x0),
        label(place.y0),
        label(place.x1) + 1,
        label(place.y1) + 1
    );
    const scalar interval = contourInterval(map);
    if (interval > 0)
    {
        for (const pointField& line : groundContours(map, interval))
        {
            picture.line(pixels(map, place, line), {{0.45, 0.38, 0.3}, 1.1, 0});
        }
    }
    for (const mapLines& kind : map.lines)
    {
        for (const pointField& line : kind.lines)
        {
            const pointField p(pixels(map, place, line));
            if (kind.hasEdge && kind.style.dash <= 0)
            {
                picture.line(p, {{1, 1, 1}, kind.style.width + 2.5, 0});
            }
            picture.line(p, kind.style);
        }
    }
    picture.clipNothing();
}


namespace
{

void paintAxisNames(
    painter& picture,
    const mapContent& map,
    const mapFrame& place,
    const bool hasX
)
{
    const bool local = map.crs.empty();
    textStyle axes{22, dark, anchor::centre, false, false};
    if (hasX)
    {
        picture.text(
            0.5 * (place.x0 + place.x1),
            place.y0 - 58,
            local ? string("x [m]") : "East [m]   (" + map.crs + ")",
            axes
        );
    }
    axes.upright = true;
    picture.text(
        24, 0.5 * (place.y0 + place.y1), local ? "y [m]" : "North [m]", axes
    );
}

} // namespace


void paintFrame(
    painter& picture,
    const mapContent& map,
    const mapFrame& place,
    const bool hasX
)
{
    picture.line(
        outlineOf(place.x0, place.y0, place.x1, place.y1), {dark, 2, 0}
    );
    const textStyle labels{20, dark, anchor::centre, false, false};
    const scalar width = scalar(map.nx) * map.dx;
    const scalar height = scalar(map.ny) * map.dy;
    // A label every 160 pixels leaves room for seven digits
    const scalar step = roundStep(
        max(width, height),
        max(label(2), label(place.scale * max(width, height) / 160))
    );
    for (const scalar x : ticks(map.x0, map.x0 + width, step))
    {
        const scalar p = place.x0 + place.scale * (x - map.x0);
        picture.line(
            pointField({point(p, place.y0, 0), point(p, place.y0 - 9, 0)}),
            {dark, 2, 0}
        );
        picture.text(
            p, place.y0 - 26, hasX ? tickLabel(x, step) : string(), labels
        );
    }
    textStyle side = labels;
    side.at = anchor::right;
    // The same step on both axes, unless that leaves the short one bare
    const bool isBare = ticks(map.y0, map.y0 + height, step).size() < 2;
    const scalar yStep =
        isBare
            ? roundStep(height, max(label(2), label(place.scale * height / 70)))
            : step;
    for (const scalar y : ticks(map.y0, map.y0 + height, yStep))
    {
        const scalar p = place.y0 + place.scale * (y - map.y0);
        picture.line(
            pointField({point(place.x0, p, 0), point(place.x0 - 9, p, 0)}),
            {dark, 2, 0}
        );
        picture.text(place.x0 - 15, p, tickLabel(y, yStep), side);
    }
    paintAxisNames(picture, map, place, hasX);
}


//- Names of the lines; returns where the next block may start
scalar
paintKey(painter& picture, const mapContent& map, const scalar x, scalar y)
{
    const auto entry = [&](const lineStyle& style, const string& name)
    {
        picture.line(pointField({point(x, y, 0), point(x + 50, y, 0)}), style);
        picture.text(x + 62, y, name, {20, dark, anchor::left, false, false});
        y -= 32;
    };
    for (const mapLines& kind : map.lines)
    {
        entry(kind.style, kind.name);
    }
    const scalar interval = contourInterval(map);
    if (interval > 0)
    {
        entry(
            {{0.45, 0.38, 0.3}, 1.1, 0},
            "ground, every " + tickLabel(interval, interval) + " m"
        );
    }
    return y;
}


void paintScaleBar(
    painter& picture, const mapFrame& place, const scalar x, const scalar y
)
{
    const scalar length = roundBelow(260 / place.scale);
    const scalar pixel = place.scale * length;
    const label parts = 4;
    for (label k = 0; k < parts; ++k)
    {
        const scalar a = x + pixel * scalar(k) / parts;
        const scalar b = x + pixel * scalar(k + 1) / parts;
        picture.fillRectangle(a, y, b, y + 12, k % 2 ? colour{1, 1, 1} : dark);
    }
    picture.line(outlineOf(x, y, x + pixel, y + 12), {dark, 1.5, 0});
    const textStyle style{20, dark, anchor::centre, false, false};
    const bool inKilometres = length >= 1000;
    picture.text(x, y - 16, "0", style);
    picture.text(
        x + pixel,
        y - 16,
        inKilometres ? tickLabel(length / 1000, 1) + " km"
                     : tickLabel(length, length) + " m",
        style
    );
}


void paintArrow(
    painter& picture, const mapContent& map, const scalar x, const scalar y
)
{
    const scalar h = 62;
    picture.fillPolygon(
        pointField({
            point(x, y + h, 0),
            point(x - 16, y, 0),
            point(x, y + 14, 0),
            point(x + 16, y, 0),
        }),
        dark
    );
    picture.text(
        x,
        y + h + 16,
        map.crs.empty() ? "y" : "N",
        {24, dark, anchor::centre, true, false}
    );
}

scalar captionHeight(const mapContent& map)
{
    return captionLine * scalar(map.caption.size()) + 25;
}


scalar captionWidth(const string& line)
{
    return painter::textWidth(line, captionStyle);
}


void paintCaption(painter& picture, const mapContent& map, const scalar x)
{
    forAll (map.caption, k)
    {
        picture.text(
            x,
            25 + captionLine * (scalar(map.caption.size() - k) - 0.5),
            map.caption[k],
            captionStyle
        );
    }
}

} // namespace lpf
} // namespace Foam
