// SPDX-License-Identifier: GPL-3.0-or-later
#include "raster.H"
#include "crs.H"
#include "gdalScope.H"

#include <cmath>
#include <gdal_priv.h>
#include <limits>
#include <memory>
#include <vector>

namespace Foam
{
namespace lpf
{

namespace
{

struct closeDataset
{
    void operator()(GDALDataset* data) const { GDALClose(data); }
};

using datasetPtr = std::unique_ptr<GDALDataset, closeDataset>;


datasetPtr openRaster(const fileName& file, const dictionary& context)
{
    datasetPtr data(static_cast<GDALDataset*>(GDALOpenEx(
        file.c_str(),
        GDAL_OF_RASTER | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
        nullptr,
        nullptr,
        nullptr
    )));
    if (!data)
    {
        FatalIOErrorInFunction(context)
            << "Raster " << file
            << " cannot be read: " << gdalScope::lastError().c_str() << '.'
            << nl
            << "Give a file that gdalinfo reads; paths are relative to the"
            << " case." << exit(FatalIOError);
    }
    if (data->GetRasterCount() < 1)
    {
        FatalIOErrorInFunction(context)
            << file << " holds no raster band." << exit(FatalIOError);
    }
    return data;
}


// Cells of the file along x and y that are read, rows counted from the north
struct cellRange
{
    int i0 = 0, i1 = 0, row0 = 0, row1 = 0; //!< end is not included
};

// Place of the grid: geotransform of the file
struct placement
{
    double x, y;   //!< corner of cell (0, row 0)
    double dx, dy; //!< dy < 0 when row 0 is north
};


placement readPlacement(
    GDALDataset& data, const fileName& file, const dictionary& context
)
{
    double t[6];
    if (data.GetGeoTransform(t) != CE_None)
    {
        FatalIOErrorInFunction(context)
            << file << " does not say where it lies (no geotransform)." << nl
            << "Give it one, e.g. gdal_translate -a_ullr <west north east"
            << " south>." << exit(FatalIOError);
    }
    if (std::abs(t[2]) > 0 || std::abs(t[4]) > 0)
    {
        FatalIOErrorInFunction(context)
            << file << " is rotated against north: one cell to the east goes "
            << t[4] << " m to the north." << nl
            << "Rows must run west to east. Warp it to a north-up grid:"
            << " gdalwarp " << file << " northUp.tif" << exit(FatalIOError);
    }
    if (!(t[1] > 0) || !(std::abs(t[5]) > 0))
    {
        FatalIOErrorInFunction(context)
            << file << " has cells of " << t[1] << " x " << t[5] << " m." << nl
            << "Both lengths must be above 0: give it a corner and a"
            << " size, gdal_edit.py -a_ullr west north east south " << file
            << exit(FatalIOError);
    }
    return {t[0], t[3], t[1], t[5]};
}


// First and last + 1 of n cells along an axis whose centre is in [from, to],
// one more on each side
void clip(
    const double start,
    const double step,
    const int n,
    const double from,
    const double to,
    int& first,
    int& last
)
{
    const double a = (from - start) / step - 0.5;
    const double b = (to - start) / step - 0.5;
    const auto limited = [n](const double s)
    { return int(std::min(std::max(s, 0.0), double(n))); };
    first = limited(std::ceil(std::min(a, b)) - 1);
    last = limited(std::floor(std::max(a, b)) + 2);
    last = std::max(first, last);
}


// Values as they stand in the file, and where they are missing
void readBand(
    GDALRasterBand& band,
    const cellRange& cells,
    raster& result,
    const fileName& file,
    const dictionary& context
)
{
    const int nx = cells.i1 - cells.i0, ny = cells.row1 - cells.row0;
    std::vector<double> row(std::size_t(std::max(nx, 1)));
    int hasNodata = 0, hasScale = 0, hasOffset = 0;
    const double nodata = band.GetNoDataValue(&hasNodata);
    const double scale = band.GetScale(&hasScale);
    const double offset = band.GetOffset(&hasOffset);
    // Float32 data keep their nodata value in single precision
    const double asRead = band.GetRasterDataType() == GDT_Float32
                            ? double(float(nodata))
                            : nodata;
    const auto same = [](const double a, const double b)
    { return !(a < b) && !(a > b); };
    for (int r = 0; r < ny; ++r)
    {
        const CPLErr status = band.RasterIO(
            GF_Read,
            cells.i0,
            cells.row0 + r,
            nx,
            1,
            row.data(),
            nx,
            1,
            GDT_Float64,
            0,
            0,
            nullptr
        );
        if (status != CE_None)
        {
            FatalIOErrorInFunction(context)
                << "Raster " << file << " is damaged in row "
                << cells.row0 + r + 1 << ": " << gdalScope::lastError().c_str()
                << '.' << nl << "Fetch the file again, or make it anew."
                << exit(FatalIOError);
        }
        for (int i = 0; i < nx; ++i)
        {
            const double v = row[std::size_t(i)];
            const label k = result.index(i, r);
            result.missing[k] =
                !std::isfinite(v)
                || (hasNodata && (same(v, nodata) || same(v, asRead)));
            result.values[k] =
                result.missing[k]
                    ? 0
                    : (hasScale ? scale : 1) * v + (hasOffset ? offset : 0);
        }
    }
}


// The file's row 0 is north in most files: turn the rows around
void flip(raster& r)
{
    for (label j = 0; j < r.ny / 2; ++j)
    {
        for (label i = 0; i < r.nx; ++i)
        {
            const label a = r.index(i, j), b = r.index(i, r.ny - 1 - j);
            std::swap(r.values[a], r.values[b]);
            const bool missing = r.missing[a];
            r.missing[a] = bool(r.missing[b]);
            r.missing[b] = missing;
        }
    }
}


string wktOf(GDALDataset& data)
{
    const char* wkt = data.GetProjectionRef();
    return wkt ? string(wkt) : string();
}

} // namespace


label raster::nMissing() const
{
    label n = 0;
    for (const bool m : missing)
    {
        n += m;
    }
    return n;
}


boundBox raster::bounds() const
{
    return boundBox(
        point(x0, y0, 0), point(x0 + (nx - 1) * dx, y0 + (ny - 1) * dy, 0)
    );
}


bool raster::bilinear(const scalar x, const scalar y, scalar& value) const
{
    const scalar s = (x - x0) / dx, t = (y - y0) / dy;
    if (nx < 2 || ny < 2 || !(s >= 0) || !(t >= 0) || s > nx - 1 || t > ny - 1)
    {
        return false;
    }
    const label i = min(label(s), nx - 2), j = min(label(t), ny - 2);
    const scalar a = s - i, b = t - j;
    const label k = index(i, j);
    if (missing[k] || missing[k + 1] || missing[k + nx] || missing[k + nx + 1])
    {
        return false;
    }
    value = (1 - b) * ((1 - a) * values[k] + a * values[k + 1])
          + b * ((1 - a) * values[k + nx] + a * values[k + nx + 1]);
    return true;
}


raster readRaster(
    const fileName& file, const dictionary& context, const boundBox& part
)
{
    raster result;
    {
        const gdalScope scope;
        const datasetPtr data = openRaster(file, context);
        const placement place = readPlacement(*data, file, context);
        cellRange cells;
        clip(
            place.x,
            place.dx,
            data->GetRasterXSize(),
            part.min().x(),
            part.max().x(),
            cells.i0,
            cells.i1
        );
        clip(
            place.y,
            place.dy,
            data->GetRasterYSize(),
            part.min().y(),
            part.max().y(),
            cells.row0,
            cells.row1
        );
        result.nx = cells.i1 - cells.i0;
        result.ny = cells.row1 - cells.row0;
        if (double(result.nx) * result.ny > 0.5 * labelMax)
        {
            FatalIOErrorInFunction(context)
                << file << " has " << result.nx << " x " << result.ny
                << " cells, more than can be numbered." << nl
                << "Cut it with a window." << exit(FatalIOError);
        }
        result.values.resize(result.size());
        result.missing.resize(result.size());
        result.dx = place.dx;
        result.dy = std::abs(place.dy);
        result.x0 = place.x + (cells.i0 + 0.5) * place.dx;
        result.y0 =
            place.y
            + ((place.dy < 0 ? cells.row1 - 1 : cells.row0) + 0.5) * place.dy;
        result.crs = wktOf(*data);
        readBand(*data->GetRasterBand(1), cells, result, file, context);
        if (place.dy < 0)
        {
            flip(result);
        }
    }
    requireMetres(result.crs, file, context);
    return result;
}


namespace
{

constexpr double writtenNodata = -9999;


datasetPtr
createRaster(const fileName& file, const raster& data, const rasterType type)
{
    GDALDriver* driver = GetGDALDriverManager()->GetDriverByName("GTiff");
    const char* options[] = {
        "COMPRESS=DEFLATE", "PREDICTOR=3", "TILED=YES", nullptr};
    datasetPtr out(driver->Create(
        file.c_str(),
        data.nx,
        data.ny,
        1,
        type == rasterType::float64 ? GDT_Float64 : GDT_Float32,
        const_cast<char**>(options)
    ));
    double t[6] = {
        data.x0 - 0.5 * data.dx,
        data.dx,
        0,
        data.y0 + (data.ny - 0.5) * data.dy,
        0,
        -data.dy};
    const bool good =
        out && out->SetGeoTransform(t) == CE_None
        && out->GetRasterBand(1)->SetNoDataValue(writtenNodata) == CE_None
        && (data.crs.empty() || out->SetProjection(data.crs.c_str()) == CE_None
        );
    return good ? std::move(out) : datasetPtr();
}


bool writeValues(GDALRasterBand& band, const raster& data)
{
    std::vector<double> row(std::size_t(data.nx));
    bool good = true;
    for (label j = 0; good && j < data.ny; ++j)
    {
        for (label i = 0; i < data.nx; ++i)
        {
            const label k = data.index(i, data.ny - 1 - j);
            row[std::size_t(i)] =
                data.missing[k] ? writtenNodata : data.values[k];
        }
        const CPLErr status = band.RasterIO(
            GF_Write,
            0,
            j,
            data.nx,
            1,
            row.data(),
            data.nx,
            1,
            GDT_Float64,
            0,
            0,
            nullptr
        );
        good = status == CE_None;
    }
    return good;
}

} // namespace


void writeRaster(
    const fileName& file,
    const raster& data,
    const rasterType type,
    const string& name,
    const string& unit
)
{
    const gdalScope scope;
    const datasetPtr out = createRaster(file, data, type);
    if (out)
    {
        out->GetRasterBand(1)->SetDescription(name.c_str());
        out->GetRasterBand(1)->SetUnitType(unit.c_str());
    }
    const bool good = out && writeValues(*out->GetRasterBand(1), data);
    if (good)
    {
        // a full disk shows at the latest here
        out->FlushCache();
    }
    if (!good || CPLGetLastErrorType() >= CE_Failure)
    {
        FatalErrorInFunction
            << "Raster " << file
            << " cannot be written: " << gdalScope::lastError().c_str() << '.'
            << nl << "Is there room on the disk, and may you write there?"
            << exit(FatalError);
    }
}

} // namespace lpf
} // namespace Foam
