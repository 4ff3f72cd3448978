// SPDX-License-Identifier: GPL-3.0-or-later
#include "mapPainting.H"

namespace Foam
{
namespace lpf
{

namespace
{

// Sizes in pixels
constexpr scalar leftMargin = 150;
constexpr scalar rightMargin = 40;
constexpr scalar titleRoom = 90;
constexpr scalar panelTitle = 52;
constexpr scalar axisRoom = 110; // tick labels and name of the axis
constexpr scalar keyRoom = 180;
constexpr scalar keyLine = 32;
constexpr scalar largestPanel = 700;
constexpr scalar leastWidth = 1000;

const colour dark{0.1, 0.1, 0.1};


//- A map with the lines of a panel after its own
mapContent joined(const mapContent& map, const mapPanel& panel)
{
    mapContent all(map);
    all.lines.append(panel.lines);
    all.value = 0;
    return all;
}


//- Key, scale bar and arrow below the last map
void paintLegend(
    painter& picture,
    const mapContent& map,
    const mapFrame& last,
    const scalar width
)
{
    const scalar top = last.y0 - axisRoom;
    const scalar beside = last.x0 + 0.55 * (width - leftMargin - rightMargin);
    paintKey(picture, map, last.x0, top);
    paintScaleBar(picture, last, beside, top - 40);
    paintArrow(picture, map, beside + 330, top - 76);
}

} // namespace


void writeMapSeries(
    const fileName& file,
    const mapContent& map,
    const List<mapPanel>& panels,
    const label width
)
{
    const scalar wide = scalar(width) - leftMargin - rightMargin;
    const scalar mapWidth = scalar(map.nx) * map.dx;
    const scalar mapHeight = scalar(map.ny) * map.dy;
    mapFrame frame;
    frame.scale = min(wide / mapWidth, largestPanel / mapHeight);
    frame.x0 = leftMargin;
    frame.x1 = frame.x0 + frame.scale * mapWidth;

    const mapContent first(joined(map, panels.first()));
    scalar total = max(frame.x1 + rightMargin, leastWidth);
    for (const string& line : map.caption)
    {
        total = max(total, leftMargin + captionWidth(line) + rightMargin);
    }
    const scalar pitch = frame.scale * mapHeight + panelTitle;
    const scalar legend =
        max(keyRoom, keyLine * scalar(first.lines.size() + 2));
    const scalar height = titleRoom + scalar(panels.size()) * pitch + axisRoom
                        + legend + captionHeight(map);
    painter picture{label(total), label(height)};
    picture.text(
        leftMargin, height - 45, map.title, {30, dark, anchor::left, true}
    );
    forAll (panels, p)
    {
        const mapContent content(joined(map, panels[p]));
        frame.y1 = height - titleRoom - scalar(p) * pitch - panelTitle;
        frame.y0 = frame.y1 - frame.scale * mapHeight;
        paintCells(picture, content, frame, 1);
        paintLines(picture, content, frame);
        paintFrame(picture, content, frame, p + 1 == panels.size());
        picture.text(
            frame.x0,
            frame.y1 + 24,
            panels[p].title,
            {24, dark, anchor::left, true, false}
        );
    }
    paintLegend(picture, first, frame, total);
    paintCaption(picture, map, leftMargin);
    picture.write(file);
}

} // namespace lpf
} // namespace Foam
