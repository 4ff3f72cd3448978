// SPDX-License-Identifier: GPL-3.0-or-later
#include "plotImage.H"

#include "axisTicks.H"
#include "DynamicList.H"
#include "ListOps.H"

#include <algorithm>
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
constexpr scalar sectionHeight = 560; // one with heights drawn larger
constexpr scalar leastHeight = 220;   // of a section true to scale
constexpr scalar largestHeight = 900; // of such a one
constexpr scalar panelGap = 40;
constexpr scalar panelTitle = 45;
constexpr scalar axisRoom = 100;
constexpr scalar captionLine = 34;
constexpr scalar keyLine = 34;

// Arrows in pixels, see the header
constexpr scalar usualArrow = 45;
constexpr scalar usualShare = 0.95;
constexpr scalar longestArrow = 3 * usualArrow;

const colour dark{0.1, 0.1, 0.1};
const colour grain{0.55, 0.55, 0.55};
const colour arrowInk{0.000, 0.447, 0.698};
const colour cutInk{0.84, 0.1, 0.1};

const lineStyle curveStyles[] = {
    {{0.000, 0.447, 0.698}, 3.0, 0},
    {{0.835, 0.369, 0.000}, 3.0, 14},
    {{0.000, 0.620, 0.451}, 3.0, 7},
    {{0.800, 0.475, 0.655}, 3.0, 22},
    {{0.902, 0.624, 0.000}, 3.0, 10},
    {{0.337, 0.706, 0.914}, 3.0, 5}};
constexpr label nStyles = 6;


lineStyle styleOf(const plotPanel& panel, const label curve)
{
    const lineStyle& own = panel.curves[curve].style;
    return own.width > 0 ? own : curveStyles[curve % nStyles];
}


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


//- Numbers from and to, before and after they are made round
struct interval
{
    scalar low = VGREAT, high = -VGREAT;

    void add(const scalar v)
    {
        low = min(low, v);
        high = max(high, v);
    }

    //- Never empty
    void widen(const label parts)
    {
        if (high - low < VSMALL)
        {
            low = min(low, high);
            high = low + 1;
        }
        const scalar step = roundStep(high - low, parts);
        low = step * std::floor(low / step + 1e-9);
        high = step * std::ceil(high / step - 1e-9);
    }
};


//- Step of the ticks, also where the panel is not as high as usual
scalar yStepOf(const axes& at)
{
    const scalar parts = 6 * (at.py1 - at.py0) / panelHeight;
    return roundStep(at.y1 - at.y0, max(label(2), label(parts)));
}


void paintAxes(
    painter& picture,
    const axes& at,
    const plotPanel& panel,
    const string& xTitle
)
{
    const scalar xStep = roundStep(at.x1 - at.x0, 10);
    const scalar yStep = yStepOf(at);
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


//- Pixels of an arrow per unit of the vectors; 0: all vectors are zero
scalar arrowScale(const plotVectors& of)
{
    scalarField sizes(of.vectors.size());
    forAll (sizes, k)
    {
        sizes[k] = std::hypot(of.vectors[k].x(), of.vectors[k].y());
    }
    Foam::sort(sizes);
    const label usual = label(usualShare * scalar(sizes.size()));
    const scalar size = sizes.empty() ? 0 : sizes[min(usual, sizes.size() - 1)];
    // a few that are not zero still show
    const scalar shown = size > VSMALL || sizes.empty() ? size : sizes.last();
    return shown > VSMALL ? usualArrow / shown : 0;
}


//- by: in pixels
void paintArrow(
    painter& picture, const point& from, const vector& by, const colour& ink
)
{
    const scalar length = mag(by);
    if (length < 0.5)
    {
        return;
    }
    const vector along = by / length;
    const vector across(-along.y(), along.x(), 0);
    const scalar head = min(scalar(10), 0.5 * length);
    const point tip = from + by;
    const point neck = tip - head * along;
    picture.line(pointField({from, neck}), {ink, 1.5, 0});
    picture.fillPolygon(
        pointField(
            {tip, neck + 0.38 * head * across, neck - 0.38 * head * across}
        ),
        ink
    );
}


void paintDot(painter& picture, const point& at)
{
    pointField corners(8);
    forAll (corners, k)
    {
        const scalar angle = (scalar(k) + 0.5) * 0.25 * M_PI;
        corners[k] = at + 3 * vector(std::cos(angle), std::sin(angle), 0);
    }
    picture.fillPolygon(corners, grain);
}


void paintVectors(painter& picture, const axes& at, const plotVectors& of)
{
    picture.clip(
        label(at.px0), label(at.py0), label(at.px1) + 1, label(at.py1) + 1
    );
    for (const point& x : of.at)
    {
        paintDot(picture, at(x.x(), x.y()));
    }
    const scalar scale = arrowScale(of);
    forAll (of.at, k)
    {
        const vector arrow =
            scale * vector(of.vectors[k].x(), of.vectors[k].y(), 0);
        const bool isCut = mag(arrow) > longestArrow;
        paintArrow(
            picture,
            at(of.at[k].x(), of.at[k].y()),
            isCut ? longestArrow / mag(arrow) * arrow : arrow,
            isCut ? cutInk : arrowInk
        );
    }
    picture.clipNothing();
}


//- Lines of the key, from the top of a panel down
class keyColumn
{
    painter& picture_;
    scalar x_, y_;

    void name(const string& words, const scalar back = 0)
    {
        picture_.text(
            x_ + 62 - back, y_, words, {20, dark, anchor::left, false, false}
        );
        y_ -= keyLine;
    }

public:
    keyColumn(painter& picture, const scalar x, const scalar top)
        : picture_(picture), x_(x), y_(top - 16)
    {
    }

    void line(const lineStyle& style, const string& words)
    {
        picture_.line(
            pointField({point(x_, y_, 0), point(x_ + 50, y_, 0)}), style
        );
        name(words);
    }

    void note(const string& words) { name(words, 62); }

    void vectors(const plotVectors& of)
    {
        paintDot(picture_, point(x_ + 25, y_, 0));
        name(of.dots);
        note(of.name + ":");
        const scalar scale = arrowScale(of);
        if (scale <= 0)
        {
            note("zero everywhere");
            return;
        }
        const scalar size = roundBelow(usualArrow / scale);
        const scalar longest = longestArrow / scale;
        paintArrow(
            picture_, point(x_, y_, 0), vector(scale * size, 0, 0), arrowInk
        );
        name(threeDigits(size) + " " + of.unit);
        const bool someCut = std::any_of(
            of.vectors.begin(),
            of.vectors.end(),
            [=](const vector& v) { return std::hypot(v.x(), v.y()) > longest; }
        );
        if (someCut)
        {
            paintArrow(picture_, point(x_, y_, 0), vector(45, 0, 0), cutInk);
            name("above " + threeDigits(longest) + ",");
            name("drawn as that");
        }
    }
};


void paintKey(painter& picture, const plotPanel& panel, const axes& at)
{
    keyColumn key(picture, at.px1 + 25, at.py1);
    forAll (panel.curves, c)
    {
        if (!panel.curves[c].name.empty())
        {
            key.line(styleOf(panel, c), panel.curves[c].name);
        }
    }
    for (const plotVectors& vectors : panel.vectors)
    {
        key.vectors(vectors);
    }
    if (panel.isSection && panel.vectors.empty())
    {
        const scalar stretch = (at.py1 - at.py0) / (at.y1 - at.y0)
                             * (at.x1 - at.x0) / (at.px1 - at.px0);
        key.note("heights drawn " + threeDigits(stretch) + " x");
    }
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
    picture.text(
        at.px0, at.py1 + 24, panel.title, {24, dark, anchor::left, true, false}
    );
    for (const plotVectors& vectors : panel.vectors)
    {
        paintVectors(picture, at, vectors);
    }
    forAll (panel.curves, c)
    {
        paintCurve(
            picture, at, panel.curves[c], styleOf(panel, c), plot.noPoint
        );
    }
    paintKey(picture, panel, at);
}


//- What a panel shows along x and y
struct range
{
    interval x, y;
};


range rangeOf(const plotPanel& panel, const plotContent& plot)
{
    range all;
    if (!panel.isSection)
    {
        all.x.add(0);
        all.y.add(0);
    }
    for (const plotCurve& curve : panel.curves)
    {
        forAll (curve.x, k)
        {
            all.x.add(curve.x[k]);
            if (curve.y[k] > plot.noPoint)
            {
                all.y.add(curve.y[k]);
            }
        }
    }
    for (const plotVectors& of : panel.vectors)
    {
        for (const point& p : of.at)
        {
            all.x.add(p.x());
            all.y.add(p.y());
        }
    }
    return all;
}


//- Pixels per metre of a section true to scale
scalar trueScale(const range& all, const scalar width)
{
    return min(
        width / max(all.x.high - all.x.low, VSMALL),
        largestHeight / max(all.y.high - all.y.low, VSMALL)
    );
}


//- The points of the arrows as they are drawn, so that none is cut; in a range
//  that they make larger themselves they only become shorter
range withArrows(range all, const plotPanel& panel, const scalar width)
{
    const scalar metre = 1 / trueScale(all, width);
    for (const plotVectors& of : panel.vectors)
    {
        const scalar scale = arrowScale(of);
        forAll (of.at, k)
        {
            const vector v(of.vectors[k].x(), of.vectors[k].y(), 0);
            const scalar length = mag(v) * scale;
            const scalar shown =
                length > longestArrow ? longestArrow / length : 1;
            // 5 pixels more for the head, and for the dot
            const vector tip = metre * shown * scale * v;
            const scalar rim = 5 * metre;
            all.x.add(of.at[k].x() + tip.x() - rim);
            all.x.add(of.at[k].x() + tip.x() + rim);
            all.y.add(of.at[k].y() + tip.y() - rim);
            all.y.add(of.at[k].y() + tip.y() + rim);
        }
    }
    return all;
}


//- What the panels show; those that share the x axis show the same of it
List<range> rangesOf(const plotContent& plot, const scalar width)
{
    List<range> ranges(plot.panels.size());
    interval shared;
    forAll (ranges, p)
    {
        const plotPanel& panel = plot.panels[p];
        ranges[p] = withArrows(rangeOf(panel, plot), panel, width);
        if (panel.xTitle.empty())
        {
            shared.add(ranges[p].x.low);
            shared.add(ranges[p].x.high);
        }
    }
    forAll (ranges, p)
    {
        if (plot.panels[p].xTitle.empty())
        {
            ranges[p].x = shared;
        }
    }
    return ranges;
}


//- Numbers of a panel, pixels from its lower left corner
axes windowOf(const plotPanel& panel, range all, const scalar width)
{
    all.x.widen(panel.isSection ? 30 : 10);
    all.y.widen(panel.isSection ? 30 : 6);
    const scalar keyHeight =
        keyLine * scalar(panel.curves.size() + 5 * panel.vectors.size() + 1);
    axes at{all.x.low, all.x.high, all.y.low, all.y.high, 0, width, 0, 0};
    at.py1 = max(panel.isSection ? sectionHeight : panelHeight, keyHeight);
    if (!panel.vectors.empty())
    {
        const scalar scale = trueScale(all, width);
        at.px1 = scale * (at.x1 - at.x0);
        at.py1 = max(max(leastHeight, keyHeight), scale * (at.y1 - at.y0));
        at.y1 = at.y0 + at.py1 / scale;
    }
    return at;
}


//- Room of a panel with what stands above and below it
scalar pitchOf(const plotPanel& panel, const axes& at)
{
    return at.py1 + panelGap + (panel.title.empty() ? 0 : panelTitle)
         + (panel.xTitle.empty() ? 0 : axisRoom - 20);
}

} // namespace


void writePlot(const fileName& file, const plotContent& plot, const label width)
{
    const label n = plot.panels.size();
    const scalar captionRoom = captionLine * scalar(plot.caption.size()) + 20;
    const scalar wide = scalar(width) - leftMargin - rightMargin;
    scalar height =
        topMargin + captionRoom + (plot.xTitle.empty() ? 0 : axisRoom);
    const List<range> ranges(rangesOf(plot, wide));
    List<axes> windows(n);
    forAll (windows, p)
    {
        windows[p] = windowOf(plot.panels[p], ranges[p], wide);
        height += pitchOf(plot.panels[p], windows[p]);
    }
    painter picture(width, label(height));

    scalar top = height - topMargin;
    forAll (windows, p)
    {
        const plotPanel& panel = plot.panels[p];
        axes at = windows[p];
        const scalar below = panel.title.empty() ? top : top - panelTitle;
        top -= pitchOf(panel, at);
        at.py0 = below - at.py1;
        at.py1 = below;
        at.px0 += leftMargin;
        at.px1 += leftMargin;
        const string& shared = p == n - 1 ? plot.xTitle : string::null;
        paintPanel(
            picture,
            plot,
            panel,
            at,
            panel.xTitle.empty() ? shared : panel.xTitle
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
