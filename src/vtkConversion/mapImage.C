// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapImage.H"

#include "axisTicks.H"
#include "error.H"
#include "mapPainting.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Sizes in pixels
constexpr scalar leftMargin = 150;
constexpr scalar rightMargin = 40;
constexpr scalar topMargin = 90;
constexpr scalar bottomMargin = 90; // tick labels and name of the axis
constexpr scalar panelWidth = 420;
constexpr scalar largestMapHeight = 1500;

const colour dark{0.1, 0.1, 0.1};


//- Where things are: frame of the map, panel of the keys
struct layout : mapFrame
{
    label width, height;
    scalar panelX, panelTop;
    scalar barHeight;
    bool panelBelow;
};

layout arrange(const mapContent& map, const label width)
{
    const scalar mapWidth = scalar(map.nx) * map.dx;
    const scalar mapHeight = scalar(map.ny) * map.dy;
    layout at;
    at.panelBelow = mapWidth > 1.8 * mapHeight;
    const scalar beside = at.panelBelow ? rightMargin : panelWidth;
    const scalar wide = scalar(width) - leftMargin - beside;
    at.scale = min(wide / mapWidth, largestMapHeight / mapHeight);

    const scalar h = at.scale * mapHeight;
    at.barHeight =
        at.panelBelow ? 170 : max(scalar(170), min(scalar(420), h - 480));
    // Beside the map the panel needs its own height
    const scalar body =
        at.panelBelow ? h : max(h, at.barHeight + 480 - bottomMargin);
    const scalar below =
        bottomMargin + (at.panelBelow ? 250 : 0) + captionHeight(map);

    at.x0 = leftMargin;
    at.x1 = at.x0 + at.scale * mapWidth;
    at.width = label(max(at.x1 + beside, scalar(900)));
    at.height = label(topMargin + body + below);
    at.y1 = scalar(at.height) - topMargin;
    at.y0 = at.y1 - h;
    at.panelX = at.panelBelow ? at.x0 : at.x1 + 45;
    at.panelTop = at.panelBelow ? at.y0 - bottomMargin - 20 : at.y1;
    return at;
}


void paintColourBar(
    painter& picture,
    const mapContent& map,
    const layout& place,
    const scalar top
)
{
    const scalar x0 = place.panelX, x1 = x0 + 36;
    const scalar y1 = place.panelTop - 45, y0 = y1 - place.barHeight;
    picture.text(
        x0,
        place.panelTop - 14,
        map.valueTitle,
        {22, dark, anchor::left, true, false}
    );
    for (label y = label(y0); y < label(y1); ++y)
    {
        const scalar part = (scalar(y) + 0.5 - y0) / (y1 - y0);
        picture.fillRectangle(
            x0, scalar(y), x1, scalar(y) + 1, map.colours(part)
        );
    }
    picture.line(outlineOf(x0, y0, x1, y1), {dark, 1.5, 0});
    const scalar step = roundStep(top, label(place.barHeight / 34));
    for (const scalar v : ticks(0, top, step))
    {
        const scalar y = y0 + v / top * (y1 - y0);
        picture.line(
            pointField({point(x1, y, 0), point(x1 + 8, y, 0)}), {dark, 1.5, 0}
        );
        picture.text(
            x1 + 14,
            y,
            tickLabel(v, step),
            {20, dark, anchor::left, false, false}
        );
    }
}


void paintPanel(
    painter& picture,
    const mapContent& map,
    const layout& place,
    const scalar top
)
{
    paintColourBar(picture, map, place, top);
    if (place.panelBelow)
    {
        const scalar y = place.panelTop - 45;
        const scalar third = max(scalar(330), (place.x1 - place.x0) / 3);
        paintKey(picture, map, place.x0 + third, y);
        paintScaleBar(picture, place, place.x0 + 2 * third, y - 40);
        paintArrow(picture, map, place.x0 + 2 * third + 20, y - 160);
        return;
    }
    const scalar x = place.panelX;
    const scalar y =
        paintKey(picture, map, x, place.panelTop - 45 - place.barHeight - 50);
    paintScaleBar(picture, place, x, y - 40);
    paintArrow(picture, map, x + 20, y - 180);
}

//- Colour at 0..1 of a table with n steps
colour between(const colour* table, const label n, const scalar part)
{
    const scalar p = scalar(n) * std::clamp(part, scalar(0), scalar(1));
    const label k = min(label(p), n - 1);
    const scalar a = p - scalar(k);
    const colour &c = table[k], &d = table[k + 1];
    return {
        (1 - a) * c.r + a * d.r,
        (1 - a) * c.g + a * d.g,
        (1 - a) * c.b + a * d.b};
}

} // namespace


colour viridis(const scalar part)
{
    // Every sixteenth of the table of matplotlib (CC0)
    static const colour table[] = {
        {0.267004, 0.004874, 0.329415},
        {0.282327, 0.094955, 0.417331},
        {0.278826, 0.175490, 0.483397},
        {0.258965, 0.251537, 0.524736},
        {0.229739, 0.322361, 0.545706},
        {0.199430, 0.387607, 0.554642},
        {0.172719, 0.448791, 0.557885},
        {0.149039, 0.508051, 0.557250},
        {0.127568, 0.566949, 0.550556},
        {0.120638, 0.625828, 0.533488},
        {0.157851, 0.683765, 0.501686},
        {0.246070, 0.738910, 0.452024},
        {0.369214, 0.788888, 0.382914},
        {0.515992, 0.831158, 0.294279},
        {0.678489, 0.863742, 0.189503},
        {0.845561, 0.887322, 0.099702},
        {0.993248, 0.906157, 0.143936}};
    return between(table, 16, part);
}


colour blues(const scalar part)
{
    // Blues of nine classes by ColorBrewer, without the palest, which is the
    // colour of a level ground
    static const colour table[] = {
        {0.871, 0.922, 0.969},
        {0.776, 0.859, 0.937},
        {0.620, 0.792, 0.882},
        {0.420, 0.682, 0.839},
        {0.259, 0.573, 0.776},
        {0.129, 0.443, 0.710},
        {0.031, 0.318, 0.612},
        {0.031, 0.188, 0.420}};
    return between(table, 7, part);
}


void writeMap(const fileName& file, const mapContent& map, const label width)
{
    const label n = map.nx * map.ny;
    if (map.ground.size() != n || map.value.size() != n || n < 1)
    {
        FatalErrorInFunction << "ground and value need " << n
                             << " cells, they have " << map.ground.size()
                             << " and " << map.value.size() << exit(FatalError);
    }
    const layout place = arrange(map, width);
    painter picture(place.width, place.height);

    // Top of the colour bar: a round number just above the largest value
    const scalar largest = max(max(map.value), VSMALL);
    const scalar step = roundStep(largest, 10);
    const scalar top =
        largest > VSMALL ? step * std::ceil(largest / step - 1e-9) : 1;

    paintCells(picture, map, place, top);
    paintLines(picture, map, place);
    paintFrame(picture, map, place);
    paintPanel(picture, map, place, top);
    picture.text(
        place.x0,
        place.y1 + 45,
        map.title,
        {30, dark, anchor::left, true, false}
    );
    paintCaption(picture, map, place.x0);
    picture.write(file);
}

} // namespace lpf
} // namespace Foam
