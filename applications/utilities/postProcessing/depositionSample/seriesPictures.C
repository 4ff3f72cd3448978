// SPDX-License-Identifier: GPL-3.0-or-later
#include "seriesPictures.H"

#include "axisTicks.H"
#include "pictureParts.H"
#include "plotImage.H"

namespace Foam
{
namespace lpf
{

namespace
{

//- "grains and water"
string namesOf(const phaseDeposits& phases)
{
    string names;
    for (const deposit* phase : phases)
    {
        names += (names.empty() ? "" : " and ") + phase->cloud;
    }
    return names;
}


//- Solid and dashed, which grey tells apart too
lineStyle phaseStyle(const word& cloud, const scalar width)
{
    return {phaseColour(cloud), width, cloud == "water" ? 9.0 : 0.0};
}


void writeOutlines(const fileName& file, const phaseDeposits& phases)
{
    const deposit& first = *phases.front();
    const string above = threeDigits(first.controls.outlineAbove) + " m";
    mapContent map(groundMap(first));
    map.value.resize(map.ground.size());
    map.title = first.controls.title + ": outlines of " + namesOf(phases);
    for (const runoutPath& path : first.paths)
    {
        map.lines.append(pathLines(first, path));
    }
    List<mapPanel> panels(first.series.size());
    forAll (panels, k)
    {
        panels[k].title = "t = " + first.series[k].at.name() + " s";
        for (const deposit* phase : phases)
        {
            const polygonSet area =
                areaOf(*phase, phase->series[k].thicknessVertical);
            // Thin upon thick: both are seen where they fall together
            const bool isThin = phase->cloud == "water";
            panels[k].lines.append(
                {phase->cloud + " above " + above,
                 closedLines(area),
                 {phaseColour(phase->cloud), isThin ? 2.0 : 4.6, 0},
                 false}
            );
        }
    }
    string spacings;
    for (const deposit* phase : phases)
    {
        spacings += (spacings.empty() ? "" : ", ") + phase->cloud + " "
                  + threeDigits(phase->scales.spacing) + " m";
    }
    map.caption = stringList(
        {"Outline: vertical thickness " + above + ", of "
             + (phases.size() > 1
                    ? string("the bulk volume of the grains and of the volume "
                             "of the water")
                    : volumeName(first.cloud))
             + " per plan area.",
         "Particle spacing: " + spacings + "; cells "
             + threeDigits(first.grid.dx) + " m."}
    );
    writeMapSeries(file, map, panels, first.controls.mapWidth);
}


//- A curve for each phase, of a value of its rows
template<class Value>
plotPanel
rowsPanel(const phaseDeposits& phases, const string& title, const Value& value)
{
    plotPanel panel;
    panel.yTitle = title;
    for (const deposit* phase : phases)
    {
        const List<timeRecord>& rows = phase->records;
        plotCurve curve{
            phase->cloud,
            scalarField(rows.size()),
            scalarField(rows.size()),
            phaseStyle(phase->cloud, 3)};
        forAll (rows, k)
        {
            curve.x[k] = rows[k].time;
            curve.y[k] = value(rows[k]);
        }
        panel.curves.append(curve);
    }
    return panel;
}


//- Mean drag on a unit of mass as lpfSolver has written it; without curves
//  where it has not, or where there is none
plotPanel dragPanel(const phaseDeposits& phases, const seriesTable& table)
{
    const deposit& first = *phases.front();
    plotPanel panel;
    panel.yTitle = "mean drag [m/s\u00b2]";
    if (table.empty())
    {
        Info << "No postProcessing/lpfSolver/<time>/phases.dat: phases.png "
             << "without drag" << nl;
        return panel;
    }
    const scalarField time(table.time());
    const scalar from = first.records.first().time;
    const scalar to = first.records.last().time;
    scalar largest = 0;
    for (const deposit* phase : phases)
    {
        const string column = phase->cloud + "MeanDrag[m/s2]";
        if (!table.has(column))
        {
            continue;
        }
        const scalarField drag(table.column(column));
        DynamicList<scalar> x, y;
        forAll (time, k)
        {
            if (time[k] >= from && time[k] <= to)
            {
                x.append(time[k]);
                y.append(drag[k]);
                largest = max(largest, drag[k]);
            }
        }
        panel.curves.append(
            {phase->cloud,
             scalarField(std::move(x)),
             scalarField(std::move(y)),
             phaseStyle(phase->cloud, 3)}
        );
    }
    if (largest <= 0)
    {
        Info << "No drag in phases.dat: phases.png without it" << nl;
        panel.curves.clear();
    }
    return panel;
}


void writePhaseCurves(
    const fileName& file, const phaseDeposits& phases, const seriesTable& table
)
{
    const deposit& first = *phases.front();
    plotContent plot;
    plot.title = first.controls.title + ": " + namesOf(phases);
    plot.xTitle = "time [s]";
    plot.noPoint = 0.5 * noValue;
    if (!first.paths.empty())
    {
        plot.panels.append(rowsPanel(
            phases,
            "front, path " + first.paths.first().name() + " [m]",
            [](const timeRecord& r) { return r.fronts[0][0]; }
        ));
        plot.caption.append(
            string("Front: furthest point of the path, ")
            + (first.paths.first().length() == pathLength::plan
                   ? "plan length"
                   : "length along the surface")
            + ", with more than half a spacing of vertical thickness;"
        );
        plot.caption.append("thinner films and single drops do not count.");
    }
    plot.panels.append(rowsPanel(
        phases,
        "mean speed [m/s]",
        [](const timeRecord& r) { return r.total.meanSpeed; }
    ));
    const plotPanel drag(dragPanel(phases, table));
    if (!drag.curves.empty())
    {
        plot.panels.append(drag);
    }
    plot.caption.append(
        string("Means over the mass of a phase, of the magnitude")
        + (drag.curves.empty() ? "." : "; drag: force per mass of the phase.")
    );
    writePlot(file, plot);
}

} // namespace


void writeSeries(
    const fileName& folder,
    const std::vector<deposit>& results,
    const seriesTable& table
)
{
    phaseDeposits phases;
    for (const deposit& result : results)
    {
        if (result.cloud != "bulk")
        {
            phases.push_back(&result);
        }
    }
    if (phases.empty())
    {
        Info << "clouds has neither grains nor water: no pictures of the "
             << "series" << nl;
        return;
    }
    const deposit& first = *phases.front();
    if (first.grid.flat < 0)
    {
        writeOutlines(folder / "series.png", phases);
    }
    else
    {
        Info << "Plane strain: no series.png" << nl;
    }
    if (first.records.size() > 1)
    {
        writePhaseCurves(folder / "phases.png", phases, table);
    }
    else
    {
        Info << "One time sampled: no phases.png" << nl;
    }
    if (first.paths.empty())
    {
        Info << "No path: phases.png without fronts, no profiles.png, no "
             << "vectors_<time>.png" << nl;
        return;
    }
    writeProfiles(folder / "profiles.png", phases);
    if (first.cloud == "grains")
    {
        writeVectors(folder, first);
    }
}

} // namespace lpf
} // namespace Foam
