// SPDX-License-Identifier: GPL-3.0-or-later
#include "polyline.H"
#include "crs.H"
#include "gdalScope.H"

#include <cstring>
#include <memory>
#include <ogrsf_frmts.h>

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


void refuseFile(
    const fileName& file, const dictionary& context, const string& why
)
{
    FatalIOErrorInFunction(context)
        << "Line of " << file << ": " << why << exit(FatalIOError);
}


//- Add the lines of a geometry of any kind
void collect(const OGRGeometry& shape, DynamicList<List<point2D>>& into)
{
    const OGRwkbGeometryType type = wkbFlatten(shape.getGeometryType());
    if (type == wkbLineString)
    {
        const OGRLineString& line = *shape.toLineString();
        List<point2D> points(line.getNumPoints());
        forAll (points, k)
        {
            points[k] = point2D(line.getX(k), line.getY(k));
        }
        into.append(points);
    }
    else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection))
    {
        for (const OGRGeometry* part : *shape.toGeometryCollection())
        {
            collect(*part, into);
        }
    }
}


string wktOf(OGRLayer& layer)
{
    const OGRSpatialReference* crs = layer.GetSpatialRef();
    const char* name = crs ? crs->GetName() : nullptr;
    char* wkt = nullptr;
    // GeoPackage names it when there is none
    if (name && std::strncmp(name, "Undefined", 9) != 0)
    {
        crs->exportToWkt(&wkt);
    }
    const string result(wkt ? wkt : "");
    CPLFree(wkt);
    return result;
}

//- A file with exactly one layer, or no return
datasetPtr openFile(const fileName& file, const dictionary& context)
{
    datasetPtr data(static_cast<GDALDataset*>(GDALOpenEx(
        file.c_str(),
        GDAL_OF_VECTOR | GDAL_OF_READONLY,
        nullptr,
        nullptr,
        nullptr
    )));
    if (!data)
    {
        refuseFile(
            file,
            context,
            "cannot be read: " + gdalScope::lastError()
                + ".\nGive a file that ogrinfo reads; paths are relative to "
                  "the case."
        );
    }
    if (data->GetLayerCount() != 1)
    {
        refuseFile(
            file,
            context,
            "there is not exactly one layer.\nWrite the layer with the line "
            "to a file of its own."
        );
    }
    return data;
}


DynamicList<List<point2D>> linesOf(OGRLayer& layer)
{
    DynamicList<List<point2D>> lines;
    for (const auto& item : layer)
    {
        if (const OGRGeometry* shape = item->GetGeometryRef())
        {
            const std::unique_ptr<OGRGeometry> linear(shape->getLinearGeometry()
            );
            collect(*linear, lines);
        }
    }
    return lines;
}

} // namespace


polyline readPolyline(
    const fileName& file, const string& where, const dictionary& context
)
{
    polyline result;
    {
        const gdalScope scope;
        const datasetPtr data(openFile(file, context));
        OGRLayer& layer = *data->GetLayer(0);
        if (!where.empty()
            && layer.SetAttributeFilter(where.c_str()) != OGRERR_NONE)
        {
            refuseFile(
                file,
                context,
                "where \"" + where + "\": " + gdalScope::lastError()
            );
        }
        result.crs = wktOf(layer);
        const DynamicList<List<point2D>> lines(linesOf(layer));
        if (lines.size() != 1)
        {
            refuseFile(
                file,
                context,
                std::to_string(lines.size())
                    + " lines are found where one is needed.\nChoose one by "
                      "`where`, with an SQL condition on its attributes."
            );
        }
        result.points = lines[0];
    }
    requireMetres(result.crs, file, context);
    return result;
}

} // namespace lpf
} // namespace Foam
