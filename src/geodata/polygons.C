// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.H"
#include "crs.H"
#include "gdalScope.H"

#include <cmath>
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


scalar ringArea(const ring& r)
{
    // relative to the first point: map coordinates are large
    scalar twice = 0;
    forAll (r, i)
    {
        const vector2D a = r[i] - r[0], b = r[r.fcIndex(i)] - r[0];
        twice += a.x() * b.y() - a.y() * b.x();
    }
    return 0.5 * mag(twice);
}


ring toRing(const OGRLinearRing& line)
{
    const int n = line.getNumPoints();
    ring result(max(n - 1, 0));
    forAll (result, i)
    {
        result[i] = point2D(line.getX(i), line.getY(i));
    }
    return result;
}


polygon toPolygon(const OGRPolygon& shape, const scalar value)
{
    polygon result;
    result.value = value;
    result.rings.resize(1 + shape.getNumInteriorRings());
    result.rings[0] = toRing(*shape.getExteriorRing());
    for (int k = 0; k < shape.getNumInteriorRings(); ++k)
    {
        result.rings[k + 1] = toRing(*shape.getInteriorRing(k));
    }
    return result;
}


void refuseFile(
    const polygonQuery& query, const dictionary& context, const string& why
)
{
    FatalIOErrorInFunction(context) << "Polygons of " << query.file << ": "
                                    << why.c_str() << exit(FatalIOError);
}


OGRLayer& openLayer(
    GDALDataset* data, const polygonQuery& query, const dictionary& context
)
{
    if (!data)
    {
        refuseFile(
            query,
            context,
            "cannot be read: " + gdalScope::lastError()
                + ".\nGive a file that ogrinfo reads; paths are relative to"
                  " the case."
        );
    }
    string names;
    for (int k = 0; k < data->GetLayerCount(); ++k)
    {
        names += string(" ") + data->GetLayer(k)->GetName();
    }
    OGRLayer* layer = query.layer.empty()
                        ? data->GetLayer(0)
                        : data->GetLayerByName(query.layer.c_str());
    if (!layer)
    {
        refuseFile(
            query,
            context,
            "there is no layer " + query.layer + ". Layers:" + names
        );
    }
    if (query.layer.empty() && data->GetLayerCount() > 1)
    {
        refuseFile(
            query,
            context,
            "there are several layers. Name one: layer <one of>" + names
        );
    }
    return *layer;
}


int attributeIndex(
    OGRLayer& layer, const polygonQuery& query, const dictionary& context
)
{
    if (query.value.empty())
    {
        return -1;
    }
    OGRFeatureDefn& table = *layer.GetLayerDefn();
    const int index = table.GetFieldIndex(query.value.c_str());
    if (index < 0)
    {
        string names;
        for (int k = 0; k < table.GetFieldCount(); ++k)
        {
            names += string(" ") + table.GetFieldDefn(k)->GetNameRef();
        }
        refuseFile(
            query,
            context,
            "there is no attribute " + query.value + ". Attributes:" + names
        );
    }
    return index;
}


// All polygons of a geometry of any kind
void collect(
    const OGRGeometry& shape,
    const scalar value,
    DynamicList<polygon>& into,
    OGRMultiPolygon& together
)
{
    const OGRwkbGeometryType type = wkbFlatten(shape.getGeometryType());
    if (type == wkbPolygon)
    {
        const OGRPolygon& p = *shape.toPolygon();
        if (!p.IsEmpty())
        {
            into.append(toPolygon(p, value));
            together.addGeometry(&p);
        }
    }
    else if (OGR_GT_IsSubClassOf(type, wkbGeometryCollection))
    {
        for (const OGRGeometry* part : *shape.toGeometryCollection())
        {
            collect(*part, value, into, together);
        }
    }
}


void collectFeature(
    const OGRFeature& item,
    const scalar value,
    const polygonQuery& query,
    const dictionary& context,
    DynamicList<polygon>& into,
    OGRMultiPolygon& together
)
{
    const OGRGeometry* shape = item.GetGeometryRef();
    if (!shape)
    {
        return;
    }
    // arcs of curve polygons become short lines
    const std::unique_ptr<OGRGeometry> linear(shape->getLinearGeometry());
    if (!linear->IsValid())
    {
        refuseFile(
            query,
            context,
            "feature " + std::to_string(item.GetFID())
                + " is not a valid polygon: " + gdalScope::lastError()
                + ".\nIts inside is not defined. Repair it, e.g. with"
                  " ogr2ogr -makevalid."
        );
    }
    collect(*linear, value, into, together);
}


void refuseOverlap(
    const OGRMultiPolygon& together,
    const polygonQuery& query,
    const dictionary& context
)
{
    // above the rounding of areas far from the origin of the map
    constexpr scalar overlapping = 1e-6;
    const std::unique_ptr<OGRGeometry> all(together.UnionCascaded());
    const scalar sum = together.get_Area();
    if (all
        && OGR_G_Area(OGRGeometry::ToHandle(all.get()))
               < sum * (1 - overlapping))
    {
        refuseFile(
            query,
            context,
            "polygons overlap; the thickness there would be ambiguous."
            "\nMerge or cut them, or choose some by `where`."
        );
    }
}


string wktOf(OGRLayer& layer)
{
    string result;
    const OGRSpatialReference* crs = layer.GetSpatialRef();
    const char* name = crs ? crs->GetName() : nullptr;
    // GeoPackage names it when there is none
    if (name && std::strncmp(name, "Undefined", 9) != 0)
    {
        char* wkt = nullptr;
        crs->exportToWkt(&wkt);
        result = wkt ? wkt : "";
        CPLFree(wkt);
    }
    return result;
}

} // namespace


bool polygon::contains(const point2D& x) const
{
    bool inside = false;
    for (const ring& r : rings)
    {
        forAll (r, i)
        {
            const point2D &a = r[i], &b = r[r.fcIndex(i)];
            if ((a.y() > x.y()) != (b.y() > x.y()))
            {
                const scalar side = (b.x() - a.x()) * (x.y() - a.y())
                                  - (x.x() - a.x()) * (b.y() - a.y());
                if ((side > 0) == (b.y() > a.y()))
                {
                    inside = !inside;
                }
            }
        }
    }
    return inside;
}


scalar polygon::area() const
{
    scalar sum = 0;
    forAll (rings, k)
    {
        sum += (k ? -1 : 1) * ringArea(rings[k]);
    }
    return sum;
}


scalar polygonSet::area() const
{
    scalar sum = 0;
    for (const polygon& p : polygons)
    {
        sum += p.area();
    }
    return sum;
}


label polygonSet::nHoles() const
{
    label n = 0;
    for (const polygon& p : polygons)
    {
        n += p.rings.size() - 1;
    }
    return n;
}


boundBox polygonSet::bounds() const
{
    boundBox box = boundBox(boundBox::invertedBox);
    for (const polygon& p : polygons)
    {
        for (const point2D& x : p.rings[0])
        {
            box.add(point(x.x(), x.y(), 0));
        }
    }
    return box;
}


label polygonSet::find(const point2D& x) const
{
    forAll (polygons, i)
    {
        if (polygons[i].contains(x))
        {
            return i;
        }
    }
    return -1;
}


void polygonSet::translate(const vector2D& by)
{
    for (polygon& p : polygons)
    {
        for (ring& r : p.rings)
        {
            for (point2D& x : r)
            {
                x += by;
            }
        }
    }
}


polygonSet readPolygons(const polygonQuery& query, const dictionary& context)
{
    polygonSet result;
    {
        const gdalScope scope;
        const datasetPtr data(static_cast<GDALDataset*>(GDALOpenEx(
            query.file.c_str(),
            GDAL_OF_VECTOR | GDAL_OF_READONLY | GDAL_OF_VERBOSE_ERROR,
            nullptr,
            nullptr,
            nullptr
        )));
        OGRLayer& layer = openLayer(data.get(), query, context);
        const int attribute = attributeIndex(layer, query, context);
        if (!query.where.empty()
            && layer.SetAttributeFilter(query.where.c_str()) != OGRERR_NONE)
        {
            refuseFile(
                query,
                context,
                "where \"" + query.where + "\": " + gdalScope::lastError()
            );
        }
        result.crs = wktOf(layer);
        DynamicList<polygon> found;
        OGRMultiPolygon together;
        for (const auto& item : layer)
        {
            const scalar value =
                attribute < 0 ? 0 : item->GetFieldAsDouble(attribute);
            collectFeature(*item, value, query, context, found, together);
        }
        result.polygons.transfer(found);
        if (result.polygons.empty())
        {
            refuseFile(
                query,
                context,
                "no polygon is found"
                    + (query.where.empty() ? string() : " where " + query.where)
            );
        }
        refuseOverlap(together, query, context);
    }
    requireMetres(result.crs, query.file, context);
    return result;
}


namespace
{

std::unique_ptr<OGRGeometry>
toGeometry(const feature& item, const featureType type)
{
    if (type == featureType::lines)
    {
        auto lines = std::make_unique<OGRMultiLineString>();
        for (const ring& r : item.rings)
        {
            OGRLineString line;
            for (const point2D& x : r)
            {
                line.addPoint(x.x(), x.y());
            }
            lines->addGeometry(&line);
        }
        return lines;
    }
    auto shape = std::make_unique<OGRPolygon>();
    for (const ring& r : item.rings)
    {
        OGRLinearRing line;
        for (const point2D& x : r)
        {
            line.addPoint(x.x(), x.y());
        }
        line.closeRings();
        shape->addRing(&line);
    }
    auto multi = std::make_unique<OGRMultiPolygon>();
    multi->addGeometryDirectly(shape.release());
    return multi;
}


const char* driverName(const fileName& file)
{
    const word extension = file.ext();
    return extension == "gpkg" ? "GPKG"
         : extension == "shp"  ? "ESRI Shapefile"
                               : "GeoJSON";
}


bool writeLayer(
    OGRLayer& layer,
    const featureType type,
    const UList<feature>& features,
    const wordList& attributeNames
)
{
    bool good = true;
    for (const word& name : attributeNames)
    {
        OGRFieldDefn field(name.c_str(), OFTReal);
        good = good && layer.CreateField(&field) == OGRERR_NONE;
    }
    for (const feature& item : features)
    {
        const std::unique_ptr<OGRFeature> row(
            OGRFeature::CreateFeature(layer.GetLayerDefn())
        );
        forAll (item.attributes, k)
        {
            row->SetField(k, item.attributes[k]);
        }
        row->SetGeometryDirectly(toGeometry(item, type).release());
        good = good && layer.CreateFeature(row.get()) == OGRERR_NONE;
    }
    return good;
}

} // namespace


void writeFeatures(
    const fileName& file,
    const featureType type,
    const UList<feature>& features,
    const wordList& attributeNames,
    const string& crs
)
{
    const gdalScope scope;
    GDALDriver* driver =
        GetGDALDriverManager()->GetDriverByName(driverName(file));
    datasetPtr out(driver->Create(file.c_str(), 0, 0, 0, GDT_Unknown, nullptr));
    bool good = bool(out);
    if (good)
    {
        OGRSpatialReference reference;
        if (!crs.empty())
        {
            reference.SetFromUserInput(crs.c_str());
            reference.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
        }
        else
        {
            // the name by which a GeoPackage knows metres without a place,
            // srs_id -1; without it they would count as degrees, srs_id 0
            reference.SetLocalCS("Undefined Cartesian SRS");
        }
        OGRLayer* layer = out->CreateLayer(
            file.nameLessExt().c_str(),
            crs.empty() && file.ext() != "gpkg" ? nullptr : &reference,
            type == featureType::lines ? wkbMultiLineString : wkbMultiPolygon,
            nullptr
        );
        good = layer && writeLayer(*layer, type, features, attributeNames);
        out->FlushCache();
    }
    if (!good || CPLGetLastErrorType() >= CE_Failure)
    {
        FatalErrorInFunction
            << "Vector file " << file
            << " cannot be written: " << gdalScope::lastError().c_str() << '.'
            << nl << "Is there room on the disk, and may you write there?"
            << exit(FatalError);
    }
}

} // namespace lpf
} // namespace Foam
