// SPDX-License-Identifier: GPL-3.0-or-later
#include "depositionControls.H"

#include "inputCheck.H"
#include "point2D.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// More cells than this do not fit on a screen, on paper or in a report
constexpr scalar mostCells = 5e7;

// Of the series; more panels than this make a picture that nothing shows whole
constexpr label mostTimes = 12;


bounds above(const scalar lower, const char* reason)
{
    bounds allowed;
    allowed.lower = lower;
    allowed.lowerOpen = true;
    allowed.reason = reason;
    return allowed;
}


pathControls readPath(const dictionary& dict, const word& name)
{
    allowOnly(dict, {"points", "file", "where", "pathLength"});
    pathControls path;
    path.name = name;
    path.length = readChoice(dict, "pathLength", {"plan", "surface"}) == "plan"
                    ? pathLength::plan
                    : pathLength::surface;
    if (dict.found("points") == dict.found("file"))
    {
        refuse(
            dict,
            "points",
            "path " + name + " needs either points or a file with one line; "
                + "write points ((x y) (x y)); or file \"...\";"
        );
    }
    if (dict.found("file"))
    {
        path.file = dict.get<fileName>("file");
        path.where = dict.getOrDefault<string>("where", "");
        return path;
    }
    const List<point2D> points(dict.get<List<point2D>>("points"));
    if (points.size() < 2)
    {
        refuse(dict, "points", "path " + name + " needs at least two points");
    }
    path.points.resize(points.size());
    forAll (points, k)
    {
        path.points[k] = point(points[k].x(), points[k].y(), 0);
    }
    return path;
}


observedControls readObserved(const dictionary& dict, const word& name)
{
    allowOnly(dict, {"file", "above", "compare"});
    observedControls observed;
    observed.name = name;
    observed.file = dict.get<fileName>("file");
    bounds any;
    any.reason = "an area is observed where the raster exceeds it";
    observed.above = readNumber(dict, "above", dimless, any, 0);
    observed.compare = readChoice(
        dict, "compare", {"thicknessVertical", "maxThicknessVertical"}
    );
    return observed;
}


//- A sub-dictionary that is empty when it is not there
const dictionary& subOrEmpty(const dictionary& dict, const word& key)
{
    const dictionary* sub = optionalDictionary(dict, key);
    return sub ? *sub : dictionary::null;
}


void readExtent(const dictionary& dict, depositionControls& controls)
{
    const List<point2D> corners(dict.get<List<point2D>>("extent"));
    if (corners.size() != 2 || !(corners[0].x() < corners[1].x())
        || !(corners[0].y() < corners[1].y()))
    {
        refuse(
            dict,
            "extent",
            "extent must be the south-west and the north-east corner; write "
            "extent ((xMin yMin) (xMax yMax));"
        );
    }
    controls.hasExtent = true;
    controls.extent = boundBox(
        point(corners[0].x(), corners[0].y(), 0),
        point(corners[1].x(), corners[1].y(), 0)
    );
}


void readOutline(const dictionary& dict, depositionControls& controls)
{
    allowOnly(dict, {"above", "format"});
    controls.outlineAbove = readNumber(
        dict,
        "above",
        dimLength,
        above(
            0, "the outline is a line of equal thickness; at 0 there is none"
        ),
        0.5
    );
    controls.outlineFormat =
        readChoice(dict, "format", {"gpkg", "geojson", "shp"}, "gpkg");
}


void readMap(
    const dictionary& dict, const word& caseName, depositionControls& controls
)
{
    allowOnly(dict, {"title", "width"});
    controls.title = dict.getOrDefault<string>("title", caseName);
    controls.mapWidth = readInteger(
        dict,
        "width",
        1000,
        8000,
        "it is the width of the picture in pixels, with its legend",
        1800
    );
}


void readSeries(const dictionary& dict, depositionControls& controls)
{
    allowOnly(dict, {"times"});
    scalarList times(readNumbers(
        dict, "times", "write written times [s], as in times (0.5 1 2);"
    ));
    if (times.empty() || times.size() > mostTimes)
    {
        refuse(
            dict,
            "times",
            "times has " + Foam::name(times.size())
                + " times; each is a panel of series.png: write 1 to "
                + Foam::name(mostTimes) + " of them"
        );
    }
    for (label k = 1; k < times.size(); ++k)
    {
        if (!(times[k] > times[k - 1]))
        {
            refuse(
                dict,
                "times",
                "times: " + Foam::name(times[k]) + " s stands after "
                    + Foam::name(times[k - 1])
                    + " s; write each time once, from early to late"
            );
        }
    }
    controls.seriesTimes.transfer(times);
}


void readLines(const dictionary& dict, depositionControls& controls)
{
    const dictionary& paths = subOrEmpty(dict, "paths");
    for (const word& name : paths.toc())
    {
        controls.paths.append(readPath(
            neededDictionary(
                paths, name, "write " + name + " { points ((x y) (x y)); }"
            ),
            name
        ));
    }
    const dictionary& observed = subOrEmpty(dict, "observed");
    for (const word& name : observed.toc())
    {
        controls.observed.append(readObserved(
            neededDictionary(
                observed,
                name,
                "write " + name + " { file \"...\"; compare ...; }"
            ),
            name
        ));
    }
}

} // namespace


depositionControls readDepositionControls(
    const dictionary& dict, const releaseScales& scales, const word& caseName
)
{
    allowOnly(
        dict,
        {"clouds",
         "cellSize",
         "extent",
         "margin",
         "outline",
         "paths",
         "observed",
         "map",
         "series"}
    );
    depositionControls controls;
    if (dict.found("clouds"))
    {
        controls.clouds =
            readWords(dict, "clouds", "write clouds (grains water bulk);");
    }
    controls.cellSize = readNumber(
        dict,
        "cellSize",
        dimLength,
        above(0, "it is the side of a cell of the maps"),
        scales.spacing
    );
    if (dict.found("margin"))
    {
        bounds margin = above(0, "it is the room around the particles");
        margin.lowerOpen = false;
        controls.margin = readNumber(dict, "margin", dimLength, margin);
    }
    if (dict.found("extent"))
    {
        readExtent(dict, controls);
    }
    readOutline(subOrEmpty(dict, "outline"), controls);
    readMap(subOrEmpty(dict, "map"), caseName, controls);

    if (const dictionary* series = optionalDictionary(dict, "series"))
    {
        readSeries(*series, controls);
    }
    readLines(dict, controls);
    return controls;
}


namespace
{

//- FatalIOError for cells that show nothing: larger than the map, or far finer
//  than the kernel that spreads a particle
void checkCellSize(
    const dictionary& dict,
    const depositionControls& controls,
    const releaseScales& scales,
    const boundBox& particles
)
{
    constexpr scalar finest = 0.1;
    const scalar cell = controls.cellSize;
    const vector room(
        vector::one
        * (controls.margin >= 0 ? controls.margin : 2 * scales.smoothingLength)
    );
    vector span = controls.hasExtent ? controls.extent.span()
                                     : particles.span() + 2 * room;
    span.z() = 0;
    if (scales.flat >= 0)
    {
        span[direction(scales.flat)] = 0;
    }
    if (cell > cmptMax(span))
    {
        refuse(
            dict,
            "cellSize",
            "cellSize = " + Foam::name(cell) + " m is more than the whole map, "
                + Foam::name(cmptMax(span))
                + " m: there would be one cell. Write a fair part of it, e.g. "
                  "the spacing of the particles, "
                + Foam::name(scales.spacing) + " m, or leave it out"
        );
    }
    if (cell < finest * (1 - 1e-6) * scales.spacing)
    {
        refuse(
            dict,
            "cellSize",
            "cellSize = " + Foam::name(cell)
                + " m is less than a tenth of the spacing of the particles, "
                + Foam::name(scales.spacing)
                + " m: thickness is smooth over twice the smoothing length, "
                + Foam::name(2 * scales.smoothingLength)
                + " m, finer cells show nothing and take hours. Write "
                + Foam::name(finest * scales.spacing)
                + " or more; gdalwarp makes finer rasters of it"
        );
    }
}


//- Margin given; else beyond 2 h, where no particle is felt any more, and a
//  twentieth of each side so that the map shows where the deposit lies
vector roomAround(
    const depositionControls& controls,
    const releaseScales& scales,
    const boundBox& particles
)
{
    if (controls.margin >= 0)
    {
        return vector(controls.margin, controls.margin, 0);
    }
    const scalar least = 2 * scales.smoothingLength + controls.cellSize;
    const vector part = 0.05 * particles.span();
    return vector(max(least, part.x()), max(least, part.y()), 0);
}

} // namespace


planGrid sampleGrid(
    const dictionary& dict,
    const depositionControls& controls,
    const releaseScales& scales,
    const boundBox& particles,
    const point& origin
)
{
    checkCellSize(dict, controls, scales, particles);
    const vector room(roomAround(controls, scales, particles));
    const point low = controls.hasExtent ? controls.extent.min() - origin
                                         : particles.min() - room;
    const point high = controls.hasExtent ? controls.extent.max() - origin
                                          : particles.max() + room;
    const scalar cell = controls.cellSize;
    const scalar wanted =
        (high.x() - low.x()) / cell * (high.y() - low.y()) / cell;
    if (!(wanted < mostCells))
    {
        refuse(
            dict,
            "cellSize",
            "the map would need " + Foam::name(wanted) + " cells of "
                + Foam::name(cell) + " m from " + planText(low + origin)
                + " to " + planText(high + origin) + ", more than "
                + Foam::name(mostCells)
                + ": did single grains run far away? Write an extent, or a "
                  "larger cellSize"
        );
    }
    const auto start = [cell](const scalar x)
    { return cell * std::floor(x / cell); };

    planGrid grid;
    grid.flat = scales.flat;
    grid.x0 = start(low.x());
    grid.y0 = start(low.y());
    grid.dx = grid.dy = cell;
    grid.nx = max(label(1), label(std::ceil((high.x() - grid.x0) / cell)));
    grid.ny = max(label(1), label(std::ceil((high.y() - grid.y0) / cell)));
    const point middle = 0.5 * (particles.min() + particles.max());
    if (grid.flat == 0)
    {
        grid.nx = 1;
        grid.dx = scales.planeThickness;
        grid.x0 = middle.x() - 0.5 * grid.dx;
    }
    else if (grid.flat == 1)
    {
        grid.ny = 1;
        grid.dy = scales.planeThickness;
        grid.y0 = middle.y() - 0.5 * grid.dy;
    }
    return grid;
}

} // namespace lpf
} // namespace Foam
