// SPDX-License-Identifier: GPL-3.0-or-later
#include "seriesPictures.H"

#include "axisTicks.H"
#include "pictureParts.H"
#include "plotImage.H"

#include <algorithm>
#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

const lineStyle groundStyle{{0.25, 0.2, 0.15}, 2.2, 0};


//- Plan lengths of a path between two, both included
scalarField stationsOf(const deposit& result, scalar from, scalar to)
{
    const scalar step = 0.5 * min(result.grid.dx, result.grid.dy);
    const label n = max(label(1), label(std::ceil((to - from) / step)));
    scalarField stations(n + 1);
    forAll (stations, k)
    {
        stations[k] = from + (to - from) * scalar(k) / scalar(n);
    }
    return stations;
}


//- Elevation of the ground, noValue where there is none
scalarField groundAlong(
    const deposit& result, const runoutPath& path, const scalarField& stations
)
{
    scalarField z(stations.size(), noValue);
    forAll (stations, k)
    {
        const point x = path.position(stations[k]);
        const groundHit hit = result.bed.elevation(x.x(), x.y());
        z[k] = hit.found ? hit.nearest.z() + result.bed.origin().z() : noValue;
    }
    return z;
}


//- Depth along a path, zero where nothing lies
scalarField depthAlong(
    const deposit& result,
    const runoutPath& path,
    const scalarField& stations,
    const scalarField& depth
)
{
    // Cells without ground have no value, which must not be interpolated
    const scalarField known(max(depth, scalar(0)));
    scalarField along(stations.size());
    forAll (stations, k)
    {
        const point x = path.position(stations[k]);
        along[k] = interpolate(result.grid, known, x.x(), x.y());
    }
    return along;
}


//- A layer to draw: of a phase, at a time
struct layer
{
    string name;
    const deposit& phase;
    const scalarField& depth;
    lineStyle style;
};


//- Times from pale and thin to full, the last one thick
std::vector<layer> layersOf(const phaseDeposits& phases)
{
    std::vector<layer> layers;
    for (const deposit* phase : phases)
    {
        const colour ink = phaseColour(phase->cloud);
        const bool isDashed = phase->cloud == "water";
        const scalar last = phase->records.last().time;
        forAll (phase->series, k)
        {
            const seriesState& state = phase->series[k];
            if (state.at.value() >= last)
            {
                continue;
            }
            const scalar part = scalar(k) / scalar(phase->series.size());
            const scalar pale = 0.62 * (1 - part);
            const auto mixed = [=](const scalar c)
            { return c + pale * (1 - c); };
            layers.push_back(
                {phase->cloud + ", " + state.at.name() + " s",
                 *phase,
                 state.depth,
                 {{mixed(ink.r), mixed(ink.g), mixed(ink.b)},
                  1.5 + part,
                  isDashed ? 6.0 : 0.0}}
            );
        }
        layers.push_back(
            {phase->cloud + ", " + Foam::name(last) + " s",
             *phase,
             phase->fields.depth,
             {ink, 3.6, isDashed ? 9.0 : 0.0}}
        );
    }
    return layers;
}


//- From where to where something lies on a path, in plan: behind its start too,
//  where the path goes on straight. From > to: nowhere
std::pair<scalar, scalar>
coveredPart(const runoutPath& path, const std::vector<layer>& layers)
{
    const deposit& first = layers.front().phase;
    const planGrid& grid = first.grid;
    const scalar across =
        std::hypot(scalar(grid.nx) * grid.dx, scalar(grid.ny) * grid.dy);
    const scalarField stations(stationsOf(first, -across, path.planLength()));
    std::pair<scalar, scalar> part(VGREAT, -VGREAT);
    for (const layer& one : layers)
    {
        const scalarField depth(depthAlong(first, path, stations, one.depth));
        forAll (depth, k)
        {
            if (depth[k] > 0)
            {
                part.first = min(part.first, stations[k]);
                part.second = max(part.second, stations[k]);
            }
        }
    }
    return part;
}


//- Top of a layer, down to the ground at its ends
scalarField topOf(const scalarField& ground, const scalarField& depth)
{
    scalarField top(ground.size(), noValue);
    const label last = ground.size() - 1;
    forAll (ground, k)
    {
        const bool isCovered = depth[k] > 0 || depth[max(k - 1, label(0))] > 0
                            || depth[min(k + 1, last)] > 0;
        top[k] =
            isCovered && hasValue(ground[k]) ? ground[k] + depth[k] : noValue;
    }
    return top;
}


plotPanel profileOf(const runoutPath& path, const std::vector<layer>& layers)
{
    const deposit& first = layers.front().phase;
    plotPanel panel;
    panel.isSection = true;
    panel.yTitle = "elevation [m]";
    panel.xTitle = "plan length along path " + path.name() + " [m]";
    const auto [from, to] = coveredPart(path, layers);
    if (from > to)
    {
        return panel;
    }
    const scalar room = 0.05 * (to - from);
    const scalarField stations(
        stationsOf(first, from - room, min(to + room, path.planLength()))
    );
    const scalarField ground(groundAlong(first, path, stations));
    for (const layer& one : layers)
    {
        const scalarField depth(depthAlong(first, path, stations, one.depth));
        panel.curves.append(
            {one.name, stations, topOf(ground, depth), one.style}
        );
    }
    panel.curves.append({"ground", stations, ground, groundStyle});
    return panel;
}


//- Particles near a path in the vertical plane along it
struct section
{
    pointField at;     //!< plan length, elevation
    labelList member;  //!< which particle of the cloud
    vectorField along; //!< unit vector of the path at each of them
};


section
sectionOf(const deposit& result, const runoutPath& path, const vectorField& x)
{
    DynamicList<point> at;
    DynamicList<label> member;
    DynamicList<vector> along;
    const scalar step = 0.5 * result.scales.spacing;
    forAll (x, i)
    {
        const scalar s = path.project(x[i]);
        const point on = path.position(s);
        if (std::hypot(x[i].x() - on.x(), x[i].y() - on.y())
            > result.scales.spacing)
        {
            continue;
        }
        vector t = path.position(s + step) - path.position(s - step);
        t.z() = 0;
        at.append(point(s, x[i].z() + result.bed.origin().z(), 0));
        member.append(i);
        along.append(t / mag(t));
    }
    return {
        pointField(std::move(at)),
        labelList(std::move(member)),
        vectorField(std::move(along))};
}


plotPanel vectorPanel(
    const deposit& result,
    const runoutPath& path,
    const section& plane,
    const vectorField& field,
    const string& name
)
{
    plotPanel panel;
    panel.isSection = true;
    panel.yTitle = "elevation [m]";
    panel.title = name;
    vectorField vectors(plane.at.size());
    forAll (vectors, k)
    {
        const vector& v = field[plane.member[k]];
        vectors[k] = vector(v & plane.along[k], v.z(), 0);
    }
    panel.vectors.append(
        {result.cloud, "acceleration", "m/s\u00b2", plane.at, vectors}
    );
    const scalarField s(plane.at.component(vector::X));
    const scalar room = 2 * result.scales.spacing;
    const scalarField stations(stationsOf(result, min(s) - room, max(s) + room)
    );
    panel.curves.append(
        {"ground", stations, groundAlong(result, path, stations), groundStyle}
    );
    return panel;
}


void writeVectorsAt(
    const fileName& file, const deposit& grains, const instant& at
)
{
    const cloudState state = readCloud(grains.caseDir / at.name(), "grains");
    const runoutPath& path = grains.paths.first();
    const section plane(sectionOf(grains, path, state.positions));
    plotContent plot;
    plot.title = grains.controls.title + ": forces of the water on the grains, "
               + "t = " + at.name() + " s";
    plot.xTitle = "plan length along path " + path.name() + " [m]";
    plot.noPoint = 0.5 * noValue;
    const std::pair<word, string> fields[] = {
        {"drag", "Drag"}, {"gradPForce", "Pressure gradient of the water"}};
    for (const auto& [field, name] : fields)
    {
        if (state.vectors.found(field) && !plane.at.empty())
        {
            plot.panels.append(
                vectorPanel(grains, path, plane, state.vectors[field], name)
            );
        }
    }
    if (plot.panels.empty())
    {
        Info << "Grains at " << at.name().c_str() << " s: "
             << (plane.at.empty() ? "none near the first path"
                                  : "no field drag or gradPForce")
             << ", no " << file.name() << nl;
        return;
    }
    plot.caption.append(
        "Grains within one spacing, " + threeDigits(grains.scales.spacing)
        + " m, of the path, on its vertical plane; true to scale."
    );
    writePlot(file, plot, 1800);
}

} // namespace


void writeProfiles(const fileName& file, const phaseDeposits& phases)
{
    const deposit& first = *phases.front();
    const std::vector<layer> layers(layersOf(phases));
    plotContent plot;
    plot.title = first.controls.title + ": profiles along the paths";
    plot.noPoint = 0.5 * noValue;
    for (const runoutPath& path : first.paths)
    {
        const plotPanel panel(profileOf(path, layers));
        if (panel.curves.empty())
        {
            Info << "Nothing lies on path " << path.name()
                 << ": not in profiles.png" << nl;
            continue;
        }
        plot.panels.append(panel);
    }
    if (plot.panels.empty())
    {
        return;
    }
    plot.caption.append(
        "Top: ground and depth, where vertical thickness exceeds half a "
        "spacing."
    );
    writePlot(file, plot);
}


void writeVectors(const fileName& folder, const deposit& grains)
{
    for (const seriesState& state : grains.series)
    {
        writeVectorsAt(
            folder / "vectors_" + state.at.name() + ".png", grains, state.at
        );
    }
}

} // namespace lpf
} // namespace Foam
