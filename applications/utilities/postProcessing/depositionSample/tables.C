// SPDX-License-Identifier: GPL-3.0-or-later
#include "products.H"

#include "OFstream.H"
#include "stringList.H"

#include <cmath>
#include <functional>
#include <vector>

namespace Foam
{
namespace lpf
{

namespace
{

//- A column: name with unit, value of a row
template<class Row>
struct column
{
    string name;
    std::function<scalar(const Row&)> value;
};


//- Ten digits, for coordinates, in a fixed width, so that columns stand
// straight
void writeNumber(Ostream& os, const scalar value)
{
    char text[40];
    if (hasValue(value))
    {
        std::snprintf(text, sizeof(text), "%16.10g", value);
    }
    else
    {
        std::snprintf(text, sizeof(text), "%16s", "nan");
    }
    os << text;
}


template<class Row>
void writeTable(
    const fileName& file,
    const stringList& notes,
    const std::vector<column<Row>>& columns,
    const UList<Row>& rows
)
{
    OFstream os(file);
    for (const string& note : notes)
    {
        os << "# " << note.c_str() << nl;
    }
    // The last line with # holds one word for each column: foamMonitor
    // takes the names from it
    os << '#';
    for (std::size_t k = 0; k < columns.size(); ++k)
    {
        os << (k > 0 ? ", " : " ") << columns[k].name.c_str();
    }
    os << nl;
    for (const Row& row : rows)
    {
        for (std::size_t k = 0; k < columns.size(); ++k)
        {
            os << (k > 0 ? ", " : "");
            writeNumber(os, columns[k].value(row));
        }
        os << nl;
    }
    if (!os.good())
    {
        FatalErrorInFunction << "cannot write " << file << nl
                             << "Is there room on the disk?"
                             << exit(FatalError);
    }
}


//- Name of a column of a path; with one path it needs no further name
string pathColumn(const deposit& result, const label path, const char* name)
{
    return result.paths.size() > 1
             ? string(name) + "_" + result.paths[path].name() + "[m]"
             : string(name) + "[m]";
}


stringList frontNotes(const deposit& result)
{
    DynamicList<string> notes;
    notes.append(
        "cloud " + result.cloud + "; spacing "
        + Foam::name(result.scales.spacing) + " m; cells "
        + Foam::name(result.grid.dx) + " m"
    );
    for (const runoutPath& path : result.paths)
    {
        notes.append(
            "path " + path.name() + ": distances "
            + (path.length() == pathLength::plan ? "in plan"
                                                 : "along the surface")
            + " from its first point"
        );
    }
    notes.append(
        "front: furthest point of the path where thicknessVertical exceeds "
        "0.5 spacing; front95, front99: 95 %, 99 % of the mass are behind"
    );
    notes.append(
        "meanSpeed: mean over mass of the speed of the particles; maxSpeed: "
        "the fastest particle"
    );
    notes.append(
        "volume: "
        + (result.cloud == "grains" ? string("bulk") : volumeName(result.cloud))
        + ", of all particles; areaAbove, volumeAbove: of the cells thicker "
          "than "
        + Foam::name(result.controls.outlineAbove)
        + " m; x, y, z: centre of mass"
    );
    return stringList(std::move(notes));
}


void writeFronts(const fileName& file, const deposit& result)
{
    using row = timeRecord;
    std::vector<column<row>> columns{
        {"time[s]", [](const row& r) { return r.time; }}};
    const char* names[] = {"front", "front95", "front99"};
    forAll (result.paths, p)
    {
        for (label k = 0; k < 3; ++k)
        {
            columns.push_back(
                {pathColumn(result, p, names[k]),
                 [p, k](const row& r) { return r.fronts[p][k]; }}
            );
        }
    }
    const point origin(result.bed.origin());
    const std::vector<column<row>> others{
        {"meanSpeed[m/s]", [](const row& r) { return r.total.meanSpeed; }},
        {"maxSpeed[m/s]", [](const row& r) { return r.total.maxSpeed; }},
        {"maxDepth[m]", [](const row& r) { return r.maxDepth; }},
        {"maxThicknessVertical[m]",
         [](const row& r) { return r.maxThickness; }},
        {"volume[m3]", [](const row& r) { return r.total.volume; }},
        {"areaAbove[m2]", [](const row& r) { return r.areaAbove; }},
        {"volumeAbove[m3]", [](const row& r) { return r.volumeAbove; }},
        {"mass[kg]", [](const row& r) { return r.total.mass; }},
        {"x[m]", [=](const row& r) { return r.total.centre.x() + origin.x(); }},
        {"y[m]", [=](const row& r) { return r.total.centre.y() + origin.y(); }},
        {"z[m]",
         [=](const row& r) { return r.total.centre.z() + origin.z(); }}};
    columns.insert(columns.end(), others.begin(), others.end());
    writeTable(file, frontNotes(result), columns, result.records);
}


//- The ground and what lies on it along a path, at the last time
void writeProfile(
    const fileName& file, const deposit& result, const runoutPath& path
)
{
    const label n =
        max(label(1), label(std::ceil(path.planLength() / result.grid.dx)));
    scalarField stations(n + 1);
    forAll (stations, k)
    {
        stations[k] = path.planLength() * scalar(k) / scalar(n);
    }
    const point origin(result.bed.origin());
    const auto at = [&](const scalarField& field)
    {
        return [&](const scalar& s)
        {
            const point x = path.position(s);
            return interpolate(result.grid, field, x.x(), x.y());
        };
    };
    const depositionFields& fields = result.fields;
    const std::vector<column<scalar>> columns{
        {"distance[m]", [&](const scalar& s) { return path.distance(s); }},
        {"plan[m]", [](const scalar& s) { return s; }},
        {"x[m]",
         [&](const scalar& s) { return path.position(s).x() + origin.x(); }},
        {"y[m]",
         [&](const scalar& s) { return path.position(s).y() + origin.y(); }},
        {"ground[m]",
         [&](const scalar& s) { return path.position(s).z() + origin.z(); }},
        {"thicknessVertical[m]", at(fields.thicknessVertical)},
        {"maxThicknessVertical[m]", at(fields.maxThicknessVertical)},
        {"maxSpeed[m/s]", at(fields.maxSpeed)}};
    writeTable(
        file,
        stringList(
            {"path " + path.name() + " at "
             + Foam::name(result.records.last().time)
             + " s; maxima over the times sampled; maxSpeed of the depth "
               "average"}
        ),
        columns,
        stations
    );
}


//- Lines `name, value, unit`
class summary
{
    OFstream os_;

public:
    explicit summary(const fileName& file) : os_(file)
    {
        os_ << "# quantity, value, unit" << nl;
    }

    void operator()(const string& name, const scalar value, const char* unit)
    {
        os_ << name.c_str() << ", ";
        writeNumber(os_, value);
        os_ << ", " << unit << nl;
    }
};


void summarisePath(summary& line, const deposit& result, const label p)
{
    const runoutPath& path = result.paths[p];
    const string& name = path.name();
    scalar furthest = noValue;
    for (const timeRecord& row : result.records)
    {
        furthest = max(furthest, row.fronts[p][0]);
    }
    const pathFronts& last = result.records.last().fronts[p];
    line("front of path " + name, last[0], "m");
    line("front of path " + name + " furthest of all times", furthest, "m");
    line("95 % of the mass along path " + name, last[1], "m");
    line("99 % of the mass along path " + name, last[2], "m");
    if (hasValue(last[0]))
    {
        const scalar plan = path.planAt(last[0]);
        const scalar drop = path.position(0).z() - path.position(plan).z();
        line("plan length to the front of path " + name, plan, "m");
        line("drop of the ground to the front of path " + name, drop, "m");
        line(
            "drop over plan length of path " + name,
            plan > 0 ? drop / plan : noValue,
            "-"
        );
    }
    if (furthest > path.endDistance() - result.grid.dx)
    {
        WarningInFunction << "the front has reached the end of path " << name
                          << ": it may have gone further; make the path longer"
                          << endl;
    }
}


//- Volume by density over volume by the space that the particles take, on the
//  cells that are covered; 1 where the density is that of the arrangement
scalar thicknessOverDepth(const deposit& result)
{
    const depositionFields& fields = result.fields;
    scalar thickness = 0, depth = 0;
    forAll (fields.depth, c)
    {
        if (hasValue(fields.depth[c]) && fields.depth[c] > 0)
        {
            thickness += fields.thicknessVertical[c];
            depth += fields.depth[c];
        }
    }
    const scalar ratio = depth > 0 ? thickness / depth : noValue;
    if (ratio > 1.1)
    {
        WarningInFunction
            << "the particles stand closer than their density says: vertical "
            << "thickness over depth is " << ratio << " on the covered cells "
            << "at the last time. Thickness and outline rest on the density; "
            << "the depth is that of the particles." << endl;
    }
    return ratio;
}


void summariseScore(summary& line, const observedScore& score)
{
    const string name = "observed " + score.name + ": ";
    line(name + "CSI", score.csi, "-");
    line(name + "in both", score.truePositive * score.cellArea, "m2");
    line(name + "only simulated", score.falsePositive * score.cellArea, "m2");
    line(name + "only observed", score.falseNegative * score.cellArea, "m2");
}


void writeSummary(
    const fileName& file, const deposit& result, const findings& found
)
{
    const timeRecord& last = result.records.last();
    const depositionFields& fields = result.fields;
    const scalar above = result.controls.outlineAbove;
    const string outline = "outline at " + Foam::name(above) + " m: ";

    summary line(file);
    line("time", last.time, "s");
    line("times sampled", scalar(result.records.size()), "-");
    line("spacing", result.scales.spacing, "m");
    line("cell", result.grid.dx, "m");
    line("mass", last.total.mass, "kg");
    const string volume = result.cloud == "grains" ? "bulk volume" : "volume";
    line(volume, last.total.volume, "m3");
    line(
        volume + " at the first time sampled",
        result.records.first().total.volume,
        "m3"
    );
    line(outline + "area", found.outline.area(), "m2");
    line(outline + "parts", scalar(found.outline.polygons.size()), "-");
    line(outline + "volume inside by cells", last.volumeAbove, "m3");
    line(
        outline + "mean thickness inside by cells",
        last.areaAbove > 0 ? last.volumeAbove / last.areaAbove : noValue,
        "m"
    );
    line("release " + outline + "area", found.release.area(), "m2");
    line("reached at any time " + outline + "area", found.reached.area(), "m2");
    line("largest vertical thickness", last.maxThickness, "m");
    line("largest depth", last.maxDepth, "m");
    line(
        "vertical thickness over depth of the covered cells",
        thicknessOverDepth(result),
        "-"
    );
    line("largest depth of all times", max(fields.maxDepth), "m");
    line("largest speed of the depth average", max(fields.maxSpeed), "m/s");
    scalar fastest = 0;
    for (const timeRecord& row : result.records)
    {
        fastest = max(fastest, row.total.maxSpeed);
    }
    line("largest speed of a particle", fastest, "m/s");
    line("mean speed of the mass", last.total.meanSpeed, "m/s");
    forAll (result.paths, p)
    {
        summarisePath(line, result, p);
    }
    for (const observedScore& score : found.scores)
    {
        summariseScore(line, score);
    }
}

} // namespace


void writeTables(
    const fileName& folder, const deposit& result, const findings& found
)
{
    writeFronts(folder / "fronts.csv", result);
    for (const runoutPath& path : result.paths)
    {
        writeProfile(folder / "profile_" + path.name() + ".csv", result, path);
    }
    writeSummary(folder / "summary.csv", result, found);
}

} // namespace lpf
} // namespace Foam
