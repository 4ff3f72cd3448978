// SPDX-License-Identifier: GPL-3.0-or-later
#include "products.H"

#include "contours.H"
#include "crs.H"
#include "inputCheck.H"
#include "overlapScore.H"

#include "OSspecific.H"

#include <ctime>

namespace Foam
{
namespace lpf
{

namespace
{

//- Values on the cells as a raster in the coordinates of the input
raster placed(const deposit& result, const scalarField& values)
{
    const planGrid& grid = result.grid;
    raster map;
    map.nx = grid.nx;
    map.ny = grid.ny;
    map.dx = grid.dx;
    map.dy = grid.dy;
    map.x0 = result.bed.origin().x() + grid.x0 + 0.5 * grid.dx;
    map.y0 = result.bed.origin().y() + grid.y0 + 0.5 * grid.dy;
    map.values = values;
    map.missing.resize(values.size());
    forAll (values, c)
    {
        map.missing[c] = !hasValue(values[c]);
    }
    map.crs = result.bed.crs();
    return map;
}


} // namespace


polygonSet areaOf(const deposit& result, const scalarField& thickness)
{
    raster map = placed(result, thickness);
    forAll (thickness, c)
    {
        map.missing[c] =
            thickness[c] <= 0 && !hasValue(result.bedCells.elevation[c]);
    }
    return areasAbove(map, result.controls.outlineAbove);
}


namespace
{

raster readObserved(const deposit& result, const observedControls& observed)
{
    const dictionary& context =
        result.dict.subDict("observed").subDict(observed.name);
    const fileName file = observed.file.isAbsolute()
                            ? observed.file
                            : result.caseDir / observed.file;
    const raster map = readRaster(file, context);
    if (!map.crs.empty() && !result.bed.crs().empty()
        && !sameCrs(map.crs, result.bed.crs()))
    {
        refuse(
            context,
            "file",
            "the observed area has the coordinates " + crsName(map.crs)
                + ", the ground has " + crsName(result.bed.crs())
                + ": they do not lie on each other; reproject it, e.g. with "
                  "gdalwarp -t_srs"
        );
    }
    return map;
}


observedScore scoreOf(
    const deposit& result, const observedControls& controls, const raster& map
)
{
    const scalarField& thickness = controls.compare == "thicknessVertical"
                                     ? result.fields.thicknessVertical
                                     : result.fields.maxThicknessVertical;
    boolList simulated(map.size()), observed(map.size());
    for (label j = 0; j < map.ny; ++j)
    {
        for (label i = 0; i < map.nx; ++i)
        {
            const label c = map.index(i, j);
            const scalar here = interpolate(
                result.grid,
                thickness,
                map.x0 + scalar(i) * map.dx - result.bed.origin().x(),
                map.y0 + scalar(j) * map.dy - result.bed.origin().y()
            );
            // What is missing in the file is not known: count nowhere
            simulated[c] =
                !map.missing[c] && here > result.controls.outlineAbove;
            observed[c] = !map.missing[c] && map.values[c] > controls.above;
        }
    }
    const overlapScore counts = compare(simulated, observed);
    observedScore score{
        controls.name,
        counts.truePositive,
        counts.falsePositive,
        counts.falseNegative,
        map.dx * map.dy,
        counts.csi(),
        false};
    const polygonSet area = areaOf(result, thickness);
    score.isCut =
        !area.polygons.empty() && !map.bounds().contains(area.bounds());
    return score;
}


//- A GeoPackage holds the date of its last change: that of the particles, so
//  that the same particles give the same bytes
void setDate(const fileName& particles)
{
    const std::time_t when = lastModified(particles);
    std::tm parts;
    char text[40];
    std::strftime(
        text, sizeof(text), "%Y-%m-%dT%H:%M:%SZ", ::gmtime_r(&when, &parts)
    );
    setEnv("OGR_CURRENT_DATE", text, true);
}


void writeOutline(
    const fileName& folder, const deposit& result, const polygonSet& outline
)
{
    List<feature> features(outline.polygons.size());
    forAll (features, k)
    {
        const polygon& area = outline.polygons[k];
        features[k].rings = area.rings;
        features[k].attributes =
            List<scalar>({result.records.last().time, area.value, area.area()});
    }
    const word particles = partsOf(result.cloud).last();
    setDate(result.lastDir / "lagrangian" / particles / "positions");
    writeFeatures(
        folder / "outline." + result.controls.outlineFormat,
        featureType::polygons,
        features,
        {"time_s", "above_m", "area_m2"},
        result.bed.crs()
    );
}

} // namespace


findings findingsOf(const deposit& result)
{
    findings found;
    found.outline = areaOf(result, result.fields.thicknessVertical);
    found.release = areaOf(result, result.releaseThickness);
    found.reached = areaOf(result, result.fields.maxThicknessVertical);
    for (const observedControls& controls : result.controls.observed)
    {
        const raster map = readObserved(result, controls);
        found.observed.append(areasAbove(map, controls.above));
        found.scores.append(scoreOf(result, controls, map));
        if (found.scores.last().isCut)
        {
            WarningInFunction
                << "the simulated area leaves the raster " << controls.file
                << ": what lies outside is not in the score " << controls.name
                << endl;
        }
    }
    return found;
}


string volumeName(const word& cloud)
{
    return cloud == "water" ? "volume of the water"
         : cloud == "bulk" ? "volume of the grains with pores, or of solid and "
                             "water where that is more"
                           : "bulk volume";
}


void writeRasters(
    const fileName& folder, const deposit& result, const findings& found
)
{
    const depositionFields& fields = result.fields;
    struct map
    {
        const char *name, *unit, *meaning;
        const scalarField& values;
    };
    const map maps[] = {
        {"thicknessVertical",
         "m",
         "volume per plan area, last time",
         fields.thicknessVertical},
        {"thicknessNormal",
         "m",
         "thicknessVertical x cos(slope of the ground), last time",
         fields.thicknessNormal},
        {"depth", "m", "top surface minus ground, last time", fields.depth},
        {"maxThicknessVertical",
         "m",
         "largest thicknessVertical of the times sampled",
         fields.maxThicknessVertical},
        {"maxDepth",
         "m",
         "largest depth of the times sampled",
         fields.maxDepth},
        {"maxSpeed",
         "m/s",
         "largest speed of the depth average",
         fields.maxSpeed},
        {"maxParticleSpeed",
         "m/s",
         "largest speed of a particle",
         fields.maxParticleSpeed},
        {"arrivalTime",
         "s",
         "first time with thicknessVertical above half a spacing",
         fields.arrivalTime}};
    for (const map& m : maps)
    {
        // the sum of thickness is the volume: all its digits
        const bool exact = &m.values == &fields.thicknessVertical;
        writeRaster(
            folder / word(m.name) + ".tif",
            placed(result, m.values),
            exact ? rasterType::float64 : rasterType::float32,
            string(m.name) + " of " + result.cloud + ": " + m.meaning,
            m.unit
        );
    }
    writeOutline(folder, result, found.outline);
}


void writeProducts(
    const fileName& folder, const deposit& result, const findings& found
)
{
    writeTables(folder, result, found);
    writeRasters(folder, result, found);
    writePictures(folder, result, found);
}

} // namespace lpf
} // namespace Foam
