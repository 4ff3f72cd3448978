// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundSources::raster: an elevation model.
Description  Any raster that GDAL reads, heights in metres. Cells without data
             are holes of the ground. window keeps a part: all, so many metres
             around the releases, or a rectangle.
             crs is for files that do not state theirs.
Usage        <part>
             {
                 type raster; file "constant/gisdata/dem.tif";
                 window release+2000; // or all, or ((x0 y0) (x1 y1))
                 crs "EPSG:2193";
             }
Units        m
*/
#include "groundSource.H"
#include "crs.H"
#include "inputCheck.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundSources
{

class raster : public groundSource
{
    const dictionary& dict_;
    fileName file_;
    bool aroundRelease_ = false;
    scalar margin_ = 0;
    boundBox window_ = boundBox::greatBox;

    void readWindow();
    string crsOf(const lpf::raster& heights) const;
    void report(const lpf::raster& heights, const string& crs) const;

public:
    TypeName("raster");

    raster(const dictionary& dict, const word& name)
        : groundSource(dict, name, {"file", "window", "crs"}), dict_(dict),
          file_(dict.get<fileName>("file"))
    {
        readWindow();
    }

    void add(const groundContext& context, groundPieces& pieces) const override;
};

defineTypeNameAndDebug(raster, 0);
addToRunTimeSelectionTable(groundSource, raster, dictionary);


void raster::readWindow()
{
    const char* form = "window is `all`, `release+2000` (metres around the"
                       " releases, no blanks), or ((x0 y0) (x1 y1)).";
    if (!dict_.found("window"))
    {
        return;
    }
    ITstream& is = dict_.lookup("window");
    if (is.size() && is[0].isWord())
    {
        const word text = is[0].wordToken();
        const std::string prefix = "release+";
        if (text == "all")
        {
            return;
        }
        if (text.compare(0, prefix.size(), prefix) != 0
            || !readScalar(text.substr(prefix.size()), margin_) || margin_ < 0)
        {
            refuse(dict_, "window", form);
        }
        aroundRelease_ = true;
        return;
    }
    const auto ends = dict_.get<List<vector2D>>("window");
    if (ends.size() != 2 || !(ends[0].x() < ends[1].x())
        || !(ends[0].y() < ends[1].y()))
    {
        refuse(dict_, "window", form);
    }
    window_ = boundBox(
        point(ends[0].x(), ends[0].y(), -GREAT),
        point(ends[1].x(), ends[1].y(), GREAT)
    );
}


string raster::crsOf(const lpf::raster& heights) const
{
    if (!dict_.found("crs"))
    {
        return heights.crs;
    }
    string given = crsFromText(dict_.get<string>("crs"), dict_);
    if (!heights.crs.empty() && !sameCrs(given, heights.crs))
    {
        refuse(
            dict_,
            "crs",
            "The file says " + crsName(heights.crs) + ", the dictionary "
                + crsName(given)
                + ". Remove the entry crs, or reproject the file with"
                  " gdalwarp."
        );
    }
    requireMetres(given, file_, dict_);
    return given;
}


void raster::report(const lpf::raster& heights, const string& crs) const
{
    const string datum = verticalDatum(crs);
    Info << "    raster " << file_ << ": " << heights.nx << " x " << heights.ny
         << " cells of " << heights.dx << " x " << heights.dy << " m" << nl
         << "        CRS " << crsName(crs).c_str() << nl
         << "        vertical datum "
         << (datum.empty() ? "not stated; heights are taken as metres"
                           : datum.c_str())
         << nl << "        nodata " << heights.nMissing() << " cells"
         << (heights.nMissing() ? ", holes of the ground" : "") << nl;
}


void raster::add(const groundContext& context, groundPieces& pieces) const
{
    const fileName path = file_.isAbsolute() ? file_ : context.caseDir / file_;
    boundBox part = window_;
    if (aroundRelease_)
    {
        const vector margin(margin_, margin_, 0);
        part = boundBox(
            context.release.min() - margin, context.release.max() + margin
        );
    }
    rasterPiece piece{readRaster(path, dict_, part), 0, file_};
    const lpf::raster& heights = piece.heights;
    if (heights.nx < 2 || heights.ny < 2
        || heights.nMissing() == heights.size())
    {
        refuse(
            dict_,
            dict_.found("window") ? "window" : "file",
            "No cells of " + file_
                + " with data lie in the window. Do window,"
                  " release and raster use the same coordinates?"
        );
    }
    const string crs = crsOf(heights);
    if (pieces.rasters.size() && !crs.empty() && !pieces.crs.empty()
        && !sameCrs(crs, pieces.crs))
    {
        refuse(
            dict_,
            "file",
            file_ + " is in " + crsName(crs)
                + ", another part of the ground"
                  " in "
                + crsName(pieces.crs)
                + ". Reproject one of them with"
                  " gdalwarp."
        );
    }
    pieces.crs = crs.empty() ? pieces.crs : crs;
    report(heights, crs);
    piece.zone = pieces.zoneLabel(zone());
    pieces.rasters.push_back(std::move(piece));
}

} // namespace groundSources
} // namespace lpf
} // namespace Foam
