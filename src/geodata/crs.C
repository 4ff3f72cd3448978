// SPDX-License-Identifier: GPL-3.0-or-later
#include "crs.H"
#include "gdalScope.H"

#include <cmath>
#include <memory>
#include <ogr_spatialref.h>

namespace Foam
{
namespace lpf
{

namespace
{

OGRSpatialReference fromWkt(const string& wkt)
{
    OGRSpatialReference crs;
    crs.SetFromUserInput(wkt.c_str());
    crs.SetAxisMappingStrategy(OAMS_TRADITIONAL_GIS_ORDER);
    return crs;
}

} // namespace


string crsFromText(const string& text, const dictionary& context)
{
    const gdalScope scope;
    OGRSpatialReference crs;
    if (crs.SetFromUserInput(text.c_str()) != OGRERR_NONE)
    {
        FatalIOErrorInFunction(context)
            << "crs " << text << " is not a coordinate reference system: "
            << gdalScope::lastError().c_str() << '.' << nl
            << "Write a code such as \"EPSG:2193\", WKT, or a PROJ string."
            << exit(FatalIOError);
    }
    char* wkt = nullptr;
    crs.exportToWkt(&wkt);
    string result(wkt ? wkt : "");
    CPLFree(wkt);
    return result;
}


string crsName(const string& wkt)
{
    if (wkt.empty())
    {
        return "not stated";
    }
    const gdalScope scope;
    const OGRSpatialReference crs = fromWkt(wkt);
    const char* name = crs.GetName();
    const char* authority = crs.GetAuthorityName(nullptr);
    const char* code = crs.GetAuthorityCode(nullptr);
    string result(name ? name : "without a name");
    if (authority && code)
    {
        result += string(" (") + authority + ":" + code + ")";
    }
    return result;
}


bool sameCrs(const string& a, const string& b)
{
    if (a == b)
    {
        return true;
    }
    const gdalScope scope;
    const OGRSpatialReference crsA = fromWkt(a), crsB = fromWkt(b);
    const char* options[] = {
        "IGNORE_DATA_AXIS_TO_SRS_AXIS_MAPPING=YES",
        "CRITERION=EQUIVALENT_EXCEPT_AXIS_ORDER_GEOGCRS",
        nullptr};
    return crsA.IsSame(&crsB, options);
}


void requireMetres(
    const string& wkt, const fileName& file, const dictionary& context
)
{
    if (wkt.empty())
    {
        return;
    }
    string unit;
    {
        const gdalScope scope;
        const OGRSpatialReference crs = fromWkt(wkt);
        const char* name = nullptr;
        if (crs.IsGeographic())
        {
            unit = "degrees";
        }
        else if (std::abs(crs.GetLinearUnits(&name) - 1) > 1e-9)
        {
            unit = name ? name : "unknown";
        }
    }
    if (!unit.empty())
    {
        FatalIOErrorInFunction(context)
            << file << " has coordinates in " << unit.c_str() << " ("
            << crsName(wkt).c_str() << ")." << nl
            << "The equations are in metres along all three axes." << nl
            << "Project it first, e.g. gdalwarp or ogr2ogr"
            << " -t_srs EPSG:<code of a metric system>." << exit(FatalIOError);
    }
}


string verticalDatum(const string& wkt)
{
    if (wkt.empty())
    {
        return "";
    }
    const gdalScope scope;
    const OGRSpatialReference crs = fromWkt(wkt);
    const char* datum = crs.GetAttrValue("VERT_DATUM");
    return datum ? string(datum) : string();
}

} // namespace lpf
} // namespace Foam
