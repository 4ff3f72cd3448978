// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotImage.H"

#include "axisTicks.H"
#include "DynamicList.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Sizes in pixels
constexpr scalar leftMargin = 130;
constexpr scalar rightMargin = 300; // names of the curves
constexpr scalar topMargin = 90;
constexpr scalar panelHeight = 400;
constexpr scalar panelGap = 40;
constexpr scalar axisRoom = 100;
constexpr scalar captionLine = 34;

const colour dark{0.1, 0.1, 0.1};

const lineStyle curveStyles[] = {
    {{0.000, 0.447, 0.698}, 3.0, 0},
    {{0.835, 0.369, 0.000}, 3.0, 14},
    {{0.000, 0.620, 0.451}, 3.0, 7},
    {{0.800, 0.475, 0.655}, 3.0, 22},
    {{0.902, 0.624, 0.000}, 3.0, 10},
    {{0.337, 0.706, 0.914}, 3.0, 5}};
constexpr label nStyles = 6;


//- A window of numbers onto a window of pixels
struct axes
{
    scalar x0, x1, y0, y1; // numbers
    scalar px0, px1, py0, py1;

    point operator()(const scalar x, const scalar y) const
    {
        return point(
            px0 + (x - x0) / (x1 - x0) * (px1 - px0),
            py0 + (y - y0) / (y1 - y0) * (py1 - py0),
            0
        );
    }
};


//- From and to, round and never empty; zero is in it unless startsAnywhere
void widen(scalar& low, scalar& high, const label parts)
{
    low = min(low, scalar(0));
    high = max(high, scalar(0));
    if (high - low < VSMALL)
    {
        high = low + 1;
    }
    const scalar step = roundStep(high - low, parts);
    low = step * std::floor(low / step + 1e-9);
    high = step * std::ceil(high / step - 1e-9);
}


void paintAxes(
    painter& picture,
    const axes& at,
    const plotPanel& panel,
    const string& xTitle
)
{
    const scalar xStep = roundStep(at.x1 - at.x0, 10);
    const scalar yStep = roundStep(at.y1 - at.y0, 6);
    const lineStyle grid{{0.88, 0.88, 0.88}, 1.2, 0};
    textStyle labels{20, dark, anchor::centre, false, false};
    for (const scalar x : ticks(at.x0, at.x1, xStep))
    {
        picture.line(pointField({at(x, at.y0), at(x, at.y1)}), grid);
        if (!xTitle.empty())
        {
            picture.text(
                at(x, at.y0).x(), at.py0 - 22, tickLabel(x, xStep), labels
            );
        }
    }
    labels.at = anchor::right;
    for (const scalar y : ticks(at.y0, at.y1, yStep))
    {
        picture.line(pointField({at(at.x0, y), at(at.x1, y)}), grid);
        picture.text(
            at.px0 - 10, at(at.x0, y).y(), tickLabel(y, yStep), labels
        );
    }
    picture.line(
        pointField({
            at(at.x0, at.y1),
            at(at.x0, at.y0),
            at(at.x1, at.y0),
        }),
        {dark, 2, 0}
    );
    textStyle title{22, dark, anchor::centre, false, false};
    picture.text(0.5 * (at.px0 + at.px1), at.py0 - 58, xTitle, title);
    title.upright = true;
    picture.text(26, 0.5 * (at.py0 + at.py1), panel.yTitle, title);
}


void paintCurve(
    painter& picture,
    const axes& at,
    const plotCurve& curve,
    const lineStyle& style,
    const scalar noPoint
)
{
    DynamicList<point> part;
    const auto draw = [&]()
    {
        if (part.size() == 1)
        {
            part.append(part[0] + vector(0.1, 0, 0));
        }
        picture.line(pointField(part), style);
        part.clear();
    };
    forAll (curve.x, k)
    {
        if (curve.y[k] > noPoint)
        {
            part.append(at(curve.x[k], curve.y[k]));
        }
        else
        {
            draw();
        }
    }
    draw();
}


void paintPanel(
    painter& picture,
    const plotContent& plot,
    const plotPanel& panel,
    const axes& at,
    const string& xTitle
)
{
    paintAxes(picture, at, panel, xTitle);
    forAll (panel.curves, c)
    {
        const lineStyle& style = curveStyles[c % nStyles];
        paintCurve(picture, at, panel.curves[c], style, plot.noPoint);

        const scalar y = at.py1 - 16 - 34 * scalar(c);
        picture.line(
            pointField({point(at.px1 + 25, y, 0), point(at.px1 + 75, y, 0)}),
            style
        );
        picture.text(
            at.px1 + 87,
            y,
            panel.curves[c].name,
            {20, dark, anchor::left, false, false}
        );
    }
}


//- Window of the numbers of a panel
axes windowOf(const plotPanel& panel, const plotContent& plot)
{
    axes at{0, 0, 0, 0, 0, 0, 0, 0};
    for (const plotCurve& curve : panel.curves)
    {
        forAll (curve.x, k)
        {
            at.x0 = min(at.x0, curve.x[k]);
            at.x1 = max(at.x1, curve.x[k]);
            if (curve.y[k] > plot.noPoint)
            {
                at.y0 = min(at.y0, curve.y[k]);
                at.y1 = max(at.y1, curve.y[k]);
            }
        }
    }
    widen(at.x0, at.x1, 10);
    widen(at.y0, at.y1, 6);
    return at;
}

} // namespace


void writePlot(const fileName& file, const plotContent& plot, const label width)
{
    const label n = plot.panels.size();
    const scalar captionRoom = captionLine * scalar(plot.caption.size()) + 20;
    const scalar height = topMargin + scalar(n) * (panelHeight + panelGap)
                        + axisRoom + captionRoom;
    painter picture(width, label(height));

    forAll (plot.panels, p)
    {
        axes at = windowOf(plot.panels[p], plot);
        at.px0 = leftMargin;
        at.px1 = scalar(width) - rightMargin;
        at.py1 = height - topMargin - scalar(p) * (panelHeight + panelGap);
        at.py0 = at.py1 - panelHeight;
        paintPanel(
            picture,
            plot,
            plot.panels[p],
            at,
            p == n - 1 ? plot.xTitle : string()
        );
    }
    picture.text(
        leftMargin,
        height - 40,
        plot.title,
        {30, dark, anchor::left, true, false}
    );
    forAll (plot.caption, k)
    {
        picture.text(
            leftMargin,
            20 + captionLine * (scalar(plot.caption.size() - k) - 0.5),
            plot.caption[k],
            {21, dark, anchor::left, false, false}
        );
    }
    picture.write(file);
}

} // namespace lpf
} // namespace Foam
