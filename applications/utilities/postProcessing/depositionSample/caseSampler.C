// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseSampler.H"

#include "bulkColumns.H"
#include "crs.H"
#include "inputCheck.H"
#include "polyline.H"
#include "releaseCheck.H"

#include "DynamicList.H"
#include "OSspecific.H"

namespace Foam
{
namespace lpf
{

wordList partsOf(const word& cloud)
{
    return cloud == "bulk" ? wordList{"grains", "water"} : wordList{cloud};
}


caseSampler::caseSampler(
    const fileName& caseDir,
    const dictionary& dict,
    const instantList& all,
    const instantList& selected
)
    : caseDir_(caseDir), dict_(dict), scales_(readReleaseScales(caseDir)),
      controls_(readDepositionControls(dict, scales_, caseDir.name())),
      bed_(ground::read(caseDir))
{
    findTimes(all, selected);
    findSeries();
    findClouds();
    grid_ =
        sampleGrid(dict_, controls_, scales_, particleBox(), bed_->origin());
    bedCells_ = sampleGround(*bed_, grid_);
    readPaths();

    Info << "Cells: " << grid_.nx << " x " << grid_.ny << " of " << grid_.dx;
    if (grid_.dx != grid_.dy)
    {
        Info << " x " << grid_.dy;
    }
    Info << " m; times: " << times_.size() << " from " << times_.first().name()
         << " to " << times_.last().name() << " s" << nl << endl;
    if (controls_.outlineAbove < present("grains"))
    {
        Info << "Note: the outline at " << controls_.outlineAbove
             << " m is thinner than half a particle (spacing "
             << scales_.spacing << " m): it runs around the outermost "
             << "particles, its place is certain to 2 h = "
             << 2 * scales_.smoothingLength << " m" << nl << endl;
    }
}


void caseSampler::findTimes(const instantList& all, const instantList& selected)
{
    const auto hasClouds = [&](const instant& t)
    { return isDir(caseDir_ / t.name() / "lagrangian"); };

    const auto withClouds = [&](const instantList& list)
    {
        DynamicList<instant> found;
        for (const instant& t : list)
        {
            if (hasClouds(t))
            {
                found.append(t);
            }
        }
        return instantList(std::move(found));
    };
    times_ = withClouds(selected);
    written_ = withClouds(all);
    if (times_.empty())
    {
        FatalErrorInFunction
            << "no time folder selected in " << caseDir_
            << " holds a cloud (<time>/lagrangian)." << nl
            << "Run terrainToParticles and lpfSolver first, or select other "
            << "times." << exit(FatalError);
    }
    releaseDir_ = caseDir_ / written_.first().name();
    instantList read(times_);
    read.append(written_.first());
    checkReleaseOf(caseDir_, read);
}


namespace
{

// What a number loses between text and binary
scalar roundingOf(const scalar time)
{
    return 1e-9 * max(scalar(1), mag(time));
}

} // namespace


scalar caseSampler::lastWritten() const
{
    const scalar last = written_.last().value();
    return last + roundingOf(last);
}


const instant& caseSampler::writtenAt(const scalar time) const
{
    const scalar same = roundingOf(time);
    label next = 0;
    while (next < written_.size() && written_[next].value() < time - same)
    {
        ++next;
    }
    if (next < written_.size() && written_[next].value() <= time + same)
    {
        return written_[next];
    }
    string nearest;
    if (next > 0)
    {
        nearest = written_[next - 1].name();
    }
    if (next < written_.size())
    {
        nearest += (next > 0 ? " and " : "") + written_[next].name();
    }
    refuse(
        dict_.subDict("series"),
        "times",
        "times: " + Foam::name(time)
            + " s is no written time; written next to it: " + nearest
            + " s. Write one that is there, or change writeInterval in "
              "system/controlDict and run again"
    );
}


void caseSampler::findSeries()
{
    DynamicList<instant> found;
    string others, later;
    for (const scalar time : controls_.seriesTimes)
    {
        // a run that goes on, or that ends early, has a series so far
        if (time > lastWritten() && controls_.seriesTimes[0] <= lastWritten())
        {
            later += " " + Foam::name(time);
            continue;
        }
        const instant& t = writtenAt(time);
        if (times_.found(t))
        {
            found.append(t);
        }
        else
        {
            others += " " + t.name();
        }
    }
    series_.transfer(found);
    if (!later.empty())
    {
        Info << "The last written time is " << written_.last().name()
             << " s, left out of the series:" << later.c_str() << " s" << nl;
    }
    if (!others.empty())
    {
        Info << "Not selected, left out of the series:" << others.c_str()
             << " s" << nl;
    }
}


void caseSampler::findClouds()
{
    wordList there(cloudNames(caseDir_ / times_.last().name()));
    if (there.found("grains") && there.found("water"))
    {
        there.append("bulk");
    }
    clouds_ = controls_.clouds.empty() ? there : controls_.clouds;
    string names;
    for (const word& cloud : there)
    {
        names += " " + cloud;
    }
    for (const word& cloud : clouds_)
    {
        if (!there.found(cloud))
        {
            refuse(
                dict_,
                "clouds",
                "there is no cloud " + cloud + " in time folder "
                    + times_.last().name() + "; there are:" + names
            );
        }
    }
}


boundBox caseSampler::particleBox() const
{
    boundBox box(boundBox::invertedBox);
    const auto add = [&](const fileName& timeDir)
    {
        for (const word& cloud : clouds_)
        {
            for (const word& part : partsOf(cloud))
            {
                box.add(readCloud(timeDir, part).positions);
            }
        }
    };
    // The extent given is enough, unless the axis of plane strain is needed
    if (controls_.hasExtent)
    {
        add(releaseDir_);
        return box;
    }
    add(releaseDir_);
    for (const instant& t : times_)
    {
        add(caseDir_ / t.name());
    }
    if (!box.valid())
    {
        FatalErrorInFunction << "the clouds hold no particle"
                             << exit(FatalError);
    }
    return box;
}


pointField caseSampler::pathVertices(const pathControls& path) const
{
    pointField vertices(path.points);
    if (!path.file.empty())
    {
        const dictionary& context = dict_.subDict("paths").subDict(path.name);
        const fileName file =
            path.file.isAbsolute() ? path.file : caseDir_ / path.file;
        const polyline line = readPolyline(file, path.where, context);
        if (!line.crs.empty() && !bed_->crs().empty()
            && !sameCrs(line.crs, bed_->crs()))
        {
            refuse(
                context,
                "file",
                "path " + path.name + " has the coordinates "
                    + crsName(line.crs) + ", the ground has "
                    + crsName(bed_->crs())
                    + ": they do not lie on each other; reproject the path, "
                      "e.g. with ogr2ogr -t_srs"
            );
        }
        vertices.resize(line.points.size());
        forAll (vertices, k)
        {
            vertices[k] = point(line.points[k].x(), line.points[k].y(), 0);
        }
    }
    const point origin(bed_->origin().x(), bed_->origin().y(), 0);
    return pointField(vertices - origin);
}


void caseSampler::readPaths()
{
    paths_.resize(controls_.paths.size());
    forAll (controls_.paths, k)
    {
        const pathControls& path = controls_.paths[k];
        const pathLine line{
            path.name, pathVertices(path), path.length, scales_.spacing};
        paths_.set(
            k,
            new runoutPath(
                line, *bed_, dict_.subDict("paths").subDict(path.name)
            )
        );
    }
}


cloudSample caseSampler::read(const fileName& timeDir, const word& cloud) const
{
    return sampleOf(
        readCloud(timeDir, cloud),
        cloud,
        readPhaseDensity(caseDir_, cloud),
        scales_.of(cloud)
    );
}


columnSample
caseSampler::columns(const cloudSample& particles, const scalar present) const
{
    return sampleColumns(
        grid_, bedCells_, particles, heightsAbove(*bed_, particles.x), present
    );
}


caseSampler::state
caseSampler::stateOf(const fileName& timeDir, const word& cloud) const
{
    if (cloud == "bulk")
    {
        return bulkOf(timeDir);
    }
    state now;
    now.particles = read(timeDir, cloud);
    now.columns = columns(now.particles, present(cloud));
    now.total = totals(now.particles);
    return now;
}


caseSampler::state caseSampler::bulkOf(const fileName& timeDir) const
{
    const cloudSample grains(read(timeDir, "grains"));
    const cloudSample water(read(timeDir, "water"));
    const columnSample grainColumns(columns(grains, 0));
    const columnSample waterColumns(columns(water, 0));
    state now;
    now.particles = joined(grains, water);
    now.columns = bulkColumns(
        grid_,
        {grainColumns, readPhaseDensity(caseDir_, "grains"), present("grains")},
        {waterColumns, readPhaseDensity(caseDir_, "water"), present("water")},
        present("bulk")
    );
    now.total = totals(now.particles);
    // not the sum of the two: water in the pores takes no more room
    now.total.volume = now.columns.volumeInside + now.columns.volumeOutside;
    return now;
}


timeRecord caseSampler::record(
    const scalar time, const state& at, const scalar present
) const
{
    const cloudSample& particles = at.particles;
    const columnSample& now = at.columns;
    timeRecord row{time, at.total, 0, 0, 0, 0, {}};
    row.maxThickness = max(max(now.thicknessVertical), scalar(0));
    forAll (now.thicknessVertical, c)
    {
        row.maxDepth = hasValue(bedCells_.elevation[c])
                         ? max(row.maxDepth, now.depth[c])
                         : row.maxDepth;
        if (now.thicknessVertical[c] > controls_.outlineAbove)
        {
            row.areaAbove += grid_.cellArea();
            row.volumeAbove += now.thicknessVertical[c] * grid_.cellArea();
        }
    }
    const scalarField shares(scalarList({0.95, 0.99}));
    for (const runoutPath& path : paths_)
    {
        const scalarField fronts(
            path.massFronts(particles.x, particles.mass, shares)
        );
        pathFronts all;
        all[0] = path.front(grid_, now.thicknessVertical, present);
        all[1] = fronts[0];
        all[2] = fronts[1];
        row.fronts.append(all);
    }
    return row;
}


deposit caseSampler::sample(const word& cloud) const
{
    deposit result{
        cloud,
        caseDir_,
        caseDir_ / times_.last().name(),
        controls_,
        scales_.of(cloud),
        dict_,
        *bed_,
        grid_,
        bedCells_,
        paths_,
        depositionFields(grid_.size()),
        scalarField(),
        {}};
    scalar outside = 0;
    for (const instant& t : times_)
    {
        const fileName timeDir = caseDir_ / t.name();
        const state now(stateOf(timeDir, cloud));
        result.fields.add(t.value(), now.columns, bedCells_, present(cloud));
        result.records.append(record(t.value(), now, present(cloud)));
        if (series_.found(t))
        {
            result.series.append(
                {t, now.columns.thicknessVertical, now.columns.depth}
            );
        }
        if (timeDir == releaseDir_)
        {
            result.releaseThickness = now.columns.thicknessVertical;
        }
        outside = max(outside, now.columns.volumeOutside);
    }
    if (outside > 1e-9 * result.records.last().total.volume)
    {
        WarningInFunction << "up to " << outside << " m3 of cloud " << cloud
                          << " lie outside of the extent; no map shows them"
                          << endl;
    }
    if (result.releaseThickness.empty())
    {
        result.releaseThickness =
            stateOf(releaseDir_, cloud).columns.thicknessVertical;
    }
    return result;
}

} // namespace lpf
} // namespace Foam
