// SPDX-License-Identifier: GPL-3.0-or-later
// Rasters and polygons of files made here, so that place and value are known.

#include <catch2/catch.hpp>

#include "crs.H"
#include "polygons.H"
#include "raster.H"
#include "sampleCase.H"

#include <cmath>
#include <fstream>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

//- A folder with files, and what reading says about them
class geoFolder
{
    temporaryFolder folder_;
    dictionary context_;

public:
    geoFolder() { context_.name() = "terrainToParticlesDict"; }

    const dictionary& context() const { return context_; }

    fileName file(const word& name, const std::string& text) const
    {
        const fileName path = folder_.path() / name;
        std::ofstream(path) << text;
        return path;
    }

    fileName path(const word& name) const { return folder_.path() / name; }

    raster read(const fileName& name) const
    {
        return readRaster(name, context_);
    }

    std::string rasterError(const fileName& name) const
    {
        return errorOf([&] { readRaster(name, context_); });
    }

    polygonSet polygonsOf(const polygonQuery& query) const
    {
        return readPolygons(query, context_);
    }

    std::string polygonError(const polygonQuery& query) const
    {
        return errorOf([&] { readPolygons(query, context_); });
    }
};

bool contains(const std::string& text, const std::string& part)
{
    return text.find(part) != std::string::npos;
}

const std::string header = "ncols 3\nnrows 2\n";
const std::string body = "cellsize 10\nNODATA_value -9999\n"
                         "1 2 3\n4 -9999 6\n";

std::string
geoJson(const std::string& features, const std::string& code = "2193")
{
    return R"({"type":"FeatureCollection","name":"area","crs":{"type":"name",)"
           R"("properties":{"name":"urn:ogc:def:crs:EPSG::)"
         + code + R"("}},"features":[)" + features + "]}";
}

std::string
feature1(const std::string& rings, const std::string& properties = "{}")
{
    return R"({"type":"Feature","properties":)" + properties
         + R"(,"geometry":{"type":"Polygon","coordinates":[)" + rings + "]}}";
}

// a square of 10 x 10 with a hole of 4 x 4 that turns the same way
const std::string square = "[[0,0],[10,0],[10,10],[0,10],[0,0]]";
const std::string hole = "[[3,3],[7,3],[7,7],[3,7],[3,3]]";

} // namespace


TEST_CASE("corner and centre of an ASCII grid are not mixed up", "[geodata]")
{
    const geoFolder folder;
    const raster centre = folder.read(folder.file(
        "centre.asc", header + "xllcenter 100\nyllcenter 200\n" + body
    ));
    CHECK(centre.x0 == 100);
    CHECK(centre.y0 == 200);
    const raster corner = folder.read(folder.file(
        "corner.asc", header + "xllcorner 100\nyllcorner 200\n" + body
    ));
    CHECK(corner.x0 == 105);
    CHECK(corner.y0 == 205);
    CHECK(corner.dx == 10);
    CHECK(corner.dy == 10);
}

TEST_CASE("rows run from the south and nodata is missing", "[geodata]")
{
    const geoFolder folder;
    const raster r = folder.read(
        folder.file("a.asc", header + "xllcorner 0\nyllcorner 0\n" + body)
    );
    CHECK(r.nx == 3);
    CHECK(r.ny == 2);
    CHECK(r.values[r.index(0, 0)] == 4);
    CHECK(r.values[r.index(2, 1)] == 3);
    CHECK(r.nMissing() == 1);
    CHECK(r.missing[r.index(1, 0)]);
    CHECK(r.crs.empty());
}

TEST_CASE("between centres bilinear, not over a hole", "[geodata]")
{
    const geoFolder folder;
    const raster r = folder.read(folder.file(
        "a.asc",
        header + "xllcenter 0\nyllcenter 0\ncellsize 10\n1 2 3\n4 5 6\n"
    ));
    scalar v = 0;
    CHECK(r.bilinear(5, 5, v));
    CHECK(v == Approx(3));
    CHECK(r.bilinear(20, 10, v));
    CHECK(v == Approx(3));
    CHECK_FALSE(r.bilinear(20.1, 5, v));
    CHECK_FALSE(r.bilinear(5, -0.1, v));
    const raster h = folder.read(
        folder.file("b.asc", header + "xllcenter 0\nyllcenter 0\n" + body)
    );
    CHECK_FALSE(h.bilinear(5, 5, v));
}

TEST_CASE("a window reads the cells in it and one around", "[geodata]")
{
    const geoFolder folder;
    std::string text = "ncols 10\nnrows 10\nxllcenter 0\nyllcenter 0\n"
                       "cellsize 1\n";
    for (label row = 0; row < 10; ++row)
    {
        for (label i = 0; i < 10; ++i)
        {
            text += std::to_string(10 * (9 - row) + i) + ' ';
        }
        text += '\n';
    }
    const raster r = readRaster(
        folder.file("a.asc", text),
        folder.context(),
        boundBox(point(2.5, 3.5, 0), point(4.5, 7.5, 0))
    );
    CHECK(r.x0 == 2);
    CHECK(r.y0 == 3);
    CHECK(r.nx == 4);
    CHECK(r.ny == 6);
    CHECK(r.values[0] == 32);
    const raster none = readRaster(
        folder.path("a.asc"),
        folder.context(),
        boundBox(point(100, 100, 0), point(200, 200, 0))
    );
    CHECK(none.size() == 0);
}

TEST_CASE("a GeoTIFF keeps values, holes, place and CRS", "[geodata]")
{
    const geoFolder folder;
    raster r;
    r.nx = 7;
    r.ny = 5;
    r.x0 = 1489200.5;
    r.y0 = 5201200.25;
    r.dx = 2;
    r.dy = 3;
    r.values.resize(35);
    r.missing.resize(35);
    r.missing = false;
    forAll (r.values, k)
    {
        r.values[k] = 1. / (k + 1);
    }
    r.missing[3] = true;
    r.crs = crsFromText("EPSG:2193", folder.context());
    const fileName file = folder.path("a.tif");
    writeRaster(file, r, rasterType::float64);
    const raster back = folder.read(file);
    CHECK(back.nx == r.nx);
    CHECK(back.ny == r.ny);
    CHECK(back.x0 == r.x0);
    CHECK(back.y0 == r.y0);
    CHECK(back.missing == r.missing);
    CHECK(sameCrs(back.crs, r.crs));
    forAll (r.values, k)
    {
        CHECK((r.missing[k] || back.values[k] == r.values[k]));
    }
    writeRaster(file, r);
    CHECK(folder.read(file).values[8] == scalar(float(r.values[8])));
}

TEST_CASE("rasters that cannot be used are refused", "[geodata]")
{
    const geoFolder folder;
    CHECK(contains(folder.rasterError("none.tif"), "cannot be read"));
    const fileName asc =
        folder.file("a.asc", header + "xllcorner 0\nyllcorner 0\n" + body);
    const auto virtualRaster = [&](const std::string& place)
    {
        return folder.file(
            "a.vrt",
            R"(<VRTDataset rasterXSize="3" rasterYSize="2">)" + place
                + R"(<VRTRasterBand dataType="Float32" band="1"><SimpleSource>)"
                  R"(<SourceFilename relativeToVRT="1">a.asc</SourceFilename>)"
                  R"(<SourceBand>1</SourceBand></SimpleSource>)"
                  R"(</VRTRasterBand></VRTDataset>)"
        );
    };
    CHECK(contains(
        folder.rasterError(
            virtualRaster("<GeoTransform>0, 10, 1, 20, 1, -10</GeoTransform>")
        ),
        "rotated"
    ));
    CHECK(contains(folder.rasterError(virtualRaster("")), "where it lies"));
    CHECK(contains(
        folder.rasterError(
            virtualRaster("<SRS>EPSG:4326</SRS>"
                          "<GeoTransform>0, 10, 0, 20, 0, -10</GeoTransform>")
        ),
        "degrees"
    ));
    CHECK(contains(
        folder.rasterError(
            virtualRaster("<SRS>EPSG:2286</SRS>"
                          "<GeoTransform>0, 10, 0, 20, 0, -10</GeoTransform>")
        ),
        "foot"
    ));
}

TEST_CASE("coordinate systems are known by name and compared", "[geodata]")
{
    const dictionary context;
    const string nz = crsFromText("EPSG:2193", context);
    const string utm = crsFromText("EPSG:32633", context);
    CHECK(contains(crsName(nz), "EPSG:2193"));
    CHECK(crsName("") == "not stated");
    CHECK(sameCrs(nz, nz));
    CHECK_FALSE(sameCrs(nz, utm));
    CHECK(contains(
        errorOf([&] { crsFromText("EPSG:rubbish", context); }),
        "not a coordinate reference system"
    ));
}

TEST_CASE("holes of polygons are respected", "[geodata]")
{
    const geoFolder folder;
    polygonQuery query;
    query.file =
        folder.file("a.geojson", geoJson(feature1(square + "," + hole)));
    const polygonSet set = folder.polygonsOf(query);
    REQUIRE(set.polygons.size() == 1);
    CHECK(set.area() == Approx(84));
    CHECK(set.nHoles() == 1);
    CHECK(set.find(point2D(1, 1)) == 0);
    CHECK(set.find(point2D(5, 5)) == -1);
    CHECK(set.find(point2D(11, 5)) == -1);
    CHECK(contains(crsName(set.crs), "2193"));
}

TEST_CASE("attributes choose polygons and give values", "[geodata]")
{
    const geoFolder folder;
    polygonQuery query;
    query.file = folder.file(
        "a.geojson",
        geoJson(
            feature1(square, R"({"id":1,"depth":2.5})") + ","
            + feature1(
                "[[20,0],[22,0],[22,2],[20,2],[20,0]]", R"({"id":2,"depth":4})"
            )
        )
    );
    query.value = "depth";
    CHECK(folder.polygonsOf(query).polygons.size() == 2);
    query.where = "id = 2";
    const polygonSet set = folder.polygonsOf(query);
    REQUIRE(set.polygons.size() == 1);
    CHECK(set.area() == Approx(4));
    CHECK(set.polygons[0].value == 4);
    query.value = "height";
    CHECK(contains(folder.polygonError(query), "Attributes: id depth"));
    query.value = "";
    query.where = "id = 3";
    CHECK(contains(folder.polygonError(query), "no polygon"));
}

TEST_CASE("polygons whose inside is not defined are refused", "[geodata]")
{
    const geoFolder folder;
    polygonQuery query;
    query.file = folder.file(
        "bow.geojson", geoJson(feature1("[[0,0],[10,10],[10,0],[0,10],[0,0]]"))
    );
    CHECK(contains(folder.polygonError(query), "not a valid polygon"));
    query.file = folder.file(
        "two.geojson",
        geoJson(
            feature1(square) + ","
            + feature1("[[5,5],[15,5],[15,15],[5,15],[5,5]]")
        )
    );
    CHECK(contains(folder.polygonError(query), "overlap"));
    query.file =
        folder.file("degrees.geojson", geoJson(feature1(square), "4326"));
    CHECK(contains(folder.polygonError(query), "degrees"));
}

TEST_CASE("features are read back as they were written", "[geodata]")
{
    const geoFolder folder;
    const string crs = crsFromText("EPSG:2193", folder.context());
    const ring outer{
        point2D(0, 0), point2D(10, 0), point2D(10, 10), point2D(0, 10)};
    const ring inner{point2D(3, 3), point2D(3, 7), point2D(7, 7)};
    const List<feature> features{feature{{outer, inner}, {0.5}}};
    for (const word& name : {word("a.gpkg"), word("a.geojson")})
    {
        polygonQuery query;
        query.file = folder.path(name);
        query.value = "threshold";
        writeFeatures(
            query.file, featureType::polygons, features, {"threshold"}, crs
        );
        const polygonSet set = folder.polygonsOf(query);
        CHECK(set.area() == Approx(92));
        CHECK(set.polygons[0].value == 0.5);
        CHECK(sameCrs(set.crs, crs));
    }
}
