// SPDX-License-Identifier: GPL-3.0-or-later
#include "contours.H"
#include "gdalScope.H"

#include <gdal_alg.h>
#include <memory>
#include <ogrsf_frmts.h>

namespace Foam
{
namespace lpf
{

namespace
{

// Says `nothing here` to GDAL; no thickness or depth is as low
constexpr double nodata = -1e30;

struct closeDataset
{
    void operator()(GDALDataset* data) const { GDALClose(data); }
};

using datasetPtr = std::unique_ptr<GDALDataset, closeDataset>;


void failed(const string& what)
{
    FatalErrorInFunction << what << ": " << gdalScope::lastError()
                         << exit(FatalError);
}


//- The raster in memory, north row first as GDAL counts
datasetPtr inMemory(const raster& data)
{
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("MEM");
    datasetPtr copy(
        driver->Create("", data.nx, data.ny, 1, GDT_Float64, nullptr)
    );
    if (!copy)
    {
        failed("no memory for a raster to draw contours of");
    }
    double t[6] = {
        data.x0 - 0.5 * data.dx,
        data.dx,
        0,
        data.y0 + (data.ny - 0.5) * data.dy,
        0,
        -data.dy};
    copy->SetGeoTransform(t);
    GDALRasterBand& band = *copy->GetRasterBand(1);
    band.SetNoDataValue(nodata);
    scalarField row(data.nx);
    for (label j = 0; j < data.ny; ++j)
    {
        for (label i = 0; i < data.nx; ++i)
        {
            const label k = data.index(i, data.ny - 1 - j);
            row[i] = data.missing[k] ? nodata : data.values[k];
        }
        if (band.RasterIO(
                GF_Write,
                0,
                j,
                data.nx,
                1,
                row.begin(),
                data.nx,
                1,
                GDT_Float64,
                0,
                0,
                nullptr
            )
            != CE_None)
        {
            failed("a raster cannot be copied to draw contours of it");
        }
    }
    return copy;
}


//- Without the last point, which repeats the first
ring toRing(const OGRLinearRing& line)
{
    ring result(max(line.getNumPoints() - 1, 0));
    forAll (result, i)
    {
        result[i] = point2D(line.getX(i), line.getY(i));
    }
    return result;
}


void collect(OGRLayer& layer, const scalar level, DynamicList<polygon>& into)
{
    // Areas come as two ranges: up to the level, and from it to a large number
    const int upper = layer.GetLayerDefn()->GetFieldIndex("upper");
    for (const auto& item : layer)
    {
        const OGRGeometry* shape = item->GetGeometryRef();
        if (!shape || item->GetFieldAsDouble(upper) <= level)
        {
            continue;
        }
        for (const OGRPolygon* part : *shape->toMultiPolygon())
        {
            polygon area;
            area.value = level;
            area.rings.resize(1 + part->getNumInteriorRings());
            area.rings[0] = toRing(*part->getExteriorRing());
            for (int k = 0; k < part->getNumInteriorRings(); ++k)
            {
                area.rings[k + 1] = toRing(*part->getInteriorRing(k));
            }
            into.append(area);
        }
    }
}


scalar largest(const raster& data)
{
    scalar value = -GREAT;
    forAll (data.values, k)
    {
        value = data.missing[k] ? value : max(value, data.values[k]);
    }
    return value;
}

} // namespace


polygonSet areasAbove(const raster& data, const scalar level)
{
    polygonSet result;
    result.crs = data.crs;
    if (data.size() == 0 || largest(data) <= level)
    {
        return result;
    }
    const gdalScope scope;
    const datasetPtr cells = inMemory(data);
    const datasetPtr areas(
        GetGDALDriverManager()->GetDriverByName("Memory")->Create(
            "", 0, 0, 0, GDT_Unknown, nullptr
        )
    );
    OGRLayer* layer =
        areas->CreateLayer("areas", nullptr, wkbMultiPolygon, nullptr);
    OGRFieldDefn lower("lower", OFTReal), upper("upper", OFTReal);
    layer->CreateField(&lower);
    layer->CreateField(&upper);

    char text[64];
    snprintf(text, sizeof(text), "FIXED_LEVELS=%.17g", level);
    const char* options[] = {
        text,
        "POLYGONIZE=YES",
        "ELEV_FIELD_MIN=0",
        "ELEV_FIELD_MAX=1",
        "NODATA=-1e30",
        nullptr};
    if (GDALContourGenerateEx(
            cells->GetRasterBand(1),
            layer,
            const_cast<char**>(options),
            nullptr,
            nullptr
        )
        != CE_None)
    {
        failed("contours cannot be drawn");
    }
    DynamicList<polygon> found;
    collect(*layer, level, found);
    result.polygons.transfer(found);
    return result;
}

} // namespace lpf
} // namespace Foam
