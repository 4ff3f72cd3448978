// SPDX-License-Identifier: GPL-3.0-or-later
#include "products.H"

#include "axisTicks.H"
#include "pictureParts.H"
#include "plotImage.H"

namespace Foam
{
namespace lpf
{

namespace
{

const colour black{0.05, 0.05, 0.05};
const colour red{0.84, 0.1, 0.1};
const colour observedColours[] = {
    {0.1, 0.35, 0.85}, {0.75, 0.1, 0.7}, {0.0, 0.6, 0.55}};
const colour brown{0.55, 0.2, 0.05};


List<mapLines> linesOf(const deposit& result, const findings& found)
{
    const string above = threeDigits(result.controls.outlineAbove) + " m";
    DynamicList<mapLines> lines;
    for (const runoutPath& path : result.paths)
    {
        lines.append(pathLines(result, path));
    }
    forAll (found.observed, k)
    {
        lines.append(
            {"observed: " + found.scores[k].name,
             closedLines(found.observed[k]),
             {observedColours[k % 3], 2.6, 0}}
        );
    }
    if (result.records.size() > 1)
    {
        lines.append(
            {"reached, above " + above,
             closedLines(found.reached),
             {brown, 2.4, 4}}
        );
    }
    lines.append(
        {"release above " + above, closedLines(found.release), {red, 2.6, 12}}
    );
    lines.append(
        {"deposit above " + above, closedLines(found.outline), {black, 2.6, 0}}
    );
    return List<mapLines>(std::move(lines));
}


string volumeText(const scalar volume)
{
    return volume >= 1e6 ? threeDigits(1e-6 * volume) + " million m\u00b3"
                         : threeDigits(volume) + " m\u00b3";
}


stringList captionOf(const deposit& result, const findings& found)
{
    const timeRecord& last = result.records.last();
    const depositionFields& fields = result.fields;
    DynamicList<string> lines;
    lines.append(
        "t = " + threeDigits(last.time) + " s, last of "
        + Foam::name(result.records.size()) + " written times from "
        + threeDigits(result.records.first().time) + " s.  "
        + (result.cloud == "grains" ? "Bulk volume " : "Volume ")
        + volumeText(last.total.volume) + ", " + volumeText(last.volumeAbove)
        + " of it above " + threeDigits(result.controls.outlineAbove) + " m on "
        + threeDigits(found.outline.area()) + " m\u00b2."
    );
    lines.append(
        "Largest depth " + threeDigits(last.maxDepth)
        + " m, of all written times " + threeDigits(max(fields.maxDepth))
        + " m.  Largest speed of the " + "depth average "
        + threeDigits(max(fields.maxSpeed)) + " m/s; mean speed now "
        + threeDigits(last.total.meanSpeed) + " m/s."
    );
    forAll (result.paths, p)
    {
        const pathFronts& front = last.fronts[p];
        const auto metres = [](const scalar s)
        { return hasValue(s) ? threeDigits(s) + " m" : string("none"); };
        lines.append(
            "Path " + result.paths[p].name() + ", "
            + (result.paths[p].length() == pathLength::plan
                   ? "plan length"
                   : "length along the surface")
            + ": front " + metres(front[0]) + ", 95 % of the mass "
            + metres(front[1]) + ", 99 % " + metres(front[2]) + "."
        );
    }
    for (const observedScore& score : found.scores)
    {
        lines.append(
            "Observed area " + score.name
            + ": CSI = TP/(TP + FP + FN) = " + threeDigits(score.csi) + "."
        );
    }
    lines.append(
        "Particle spacing " + threeDigits(result.scales.spacing) + " m, cells "
        + threeDigits(result.grid.dx) + " m.  Thickness: kernel-smoothed "
        + volumeName(result.cloud) + " per plan area."
    );
    return stringList(std::move(lines));
}


void writeDepositMap(
    const fileName& file, const deposit& result, const findings& found
)
{
    mapContent map(groundMap(result));
    map.value = result.fields.thicknessVertical;
    map.valueFrom =
        min(result.controls.outlineAbove, 0.5 * result.scales.spacing);
    map.valueTitle = "Thickness, vertical [m]";
    map.colours = result.cloud == "water" ? blues : viridis;
    map.lines = linesOf(result, found);
    map.title = result.controls.title + ": deposit of " + result.cloud
              + " at t = " + threeDigits(result.records.last().time) + " s";
    map.caption = captionOf(result, found);
    writeMap(file, map, result.controls.mapWidth);
}


void writeCurves(const fileName& file, const deposit& result)
{
    const List<timeRecord>& rows = result.records;
    scalarField time(rows.size());
    forAll (rows, k)
    {
        time[k] = rows[k].time;
    }
    const auto curve = [&](const string& name, const auto& value)
    {
        plotCurve c{name, time, scalarField(rows.size())};
        forAll (rows, k)
        {
            c.y[k] = value(rows[k]);
        }
        return c;
    };
    plotPanel fronts, speeds;
    fronts.yTitle = "distance along the path [m]";
    const char* names[] = {"front", "95 % of the mass", "99 % of the mass"};
    forAll (result.paths, p)
    {
        for (label f = 0; f < 3; ++f)
        {
            fronts.curves.append(curve(
                result.paths.size() > 1
                    ? result.paths[p].name() + ": " + names[f]
                    : string(names[f]),
                [p, f](const timeRecord& r) { return r.fronts[p][f]; }
            ));
        }
    }
    speeds.yTitle = "speed [m/s]";
    speeds.curves.append(curve(
        "fastest particle", [](const timeRecord& r) { return r.total.maxSpeed; }
    ));
    speeds.curves.append(curve(
        "mean of the mass",
        [](const timeRecord& r) { return r.total.meanSpeed; }
    ));
    plotContent plot;
    plot.title =
        result.controls.title + ": run-out and speed of " + result.cloud;
    plot.xTitle = "time [s]";
    if (!fronts.curves.empty())
    {
        plot.panels.append(fronts);
    }
    plot.panels.append(speeds);
    plot.noPoint = 0.5 * noValue;
    writePlot(file, plot);
}

} // namespace


void writePictures(
    const fileName& folder, const deposit& result, const findings& found
)
{
    if (result.grid.flat < 0)
    {
        writeDepositMap(folder / "map.png", result, found);
    }
    else
    {
        Info << "Plane strain: no map, see the profiles along the paths" << nl;
    }
    if (result.records.size() > 1)
    {
        writeCurves(folder / "curves.png", result);
    }
    else
    {
        Info << "One time sampled: no curves against time" << nl;
    }
}

} // namespace lpf
} // namespace Foam
