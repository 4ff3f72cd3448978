// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::releaseRegions::raster: thickness by a raster.
Description  Vertical thickness on top of the ground; cells without data, at 0
             or below are outside. Between cell centres bilinear, falling to 0
             over one cell at the rim: the volume is exactly the sum over
             cells. scale multiplies the values, e.g. -1 for depths.
Usage        release { type raster; file "constant/gisdata/hrelease.asc";
                 scale 1; crs "EPSG:2193"; position onGround; }
Units        m
*/
#include "sheet.H"
#include "crs.H"
#include "inputCheck.H"
#include "raster.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace releaseRegions
{

class raster : public sheet
{
    lpf::raster thickness_; //!< input coordinates, 0 outside, one cell wider
    boundBox plan_;
    scalar sum_ = 0; //!< volume [m3]

    //- Thickness from the file; returns how many cells have some
    label readThickness(const releaseContext& context);

public:
    TypeName("raster");

    raster(const dictionary& dict, const releaseContext& context);

    boundBox plan() const override { return plan_; }

    string crs() const override { return thickness_.crs; }

    scalar volume() const override
    {
        return scene_->grid.acrossAxis < 0 ? sum_ : columnVolume();
    }

protected:
    scalar thicknessAt(const scalar x, const scalar y) const override
    {
        scalar t = 0;
        thickness_.bilinear(x, y, t);
        return t;
    }
};

defineTypeNameAndDebug(raster, 0);
addToRunTimeSelectionTable(releaseRegion, raster, dictionary);


label raster::readThickness(const releaseContext& context)
{
    const auto file = dict_.get<fileName>("file");
    const scalar scale = readNumber(dict_, "scale", dimless, {}, 1);
    const lpf::raster given =
        readRaster(file.isAbsolute() ? file : context.caseDir / file, dict_);
    thickness_ = given;
    thickness_.nx += 2;
    thickness_.ny += 2;
    thickness_.x0 -= given.dx;
    thickness_.y0 -= given.dy;
    thickness_.values = scalarField(thickness_.size(), Zero);
    thickness_.missing.resize(thickness_.size());
    thickness_.missing = false;
    label n = 0;
    forAll (given.values, k)
    {
        const label j = k / given.nx, i = k - j * given.nx;
        const scalar t = given.missing[k] ? 0 : scale * given.values[k];
        if (t > 0)
        {
            thickness_.values[thickness_.index(i + 1, j + 1)] = t;
            sum_ += t * given.dx * given.dy;
            const point c(given.x0 + i * given.dx, given.y0 + j * given.dy, 0);
            const vector cell(given.dx, given.dy, 0);
            plan_.add(c - cell);
            plan_.add(c + cell);
            ++n;
        }
    }
    return n;
}


raster::raster(const dictionary& dict, const releaseContext& context)
    : sheet(dict, {"file", "scale", "crs"}), plan_(boundBox::invertedBox)
{
    const label n = readThickness(context);
    const auto file = dict.get<fileName>("file");
    if (!n)
    {
        refuse(
            dict,
            "file",
            "No cell of " + file
                + " is positive: there is no release. Depths"
                  " below the surface need `scale -1`."
        );
    }
    if (dict.found("crs"))
    {
        const string given = crsFromText(dict.get<string>("crs"), dict);
        if (!thickness_.crs.empty() && !sameCrs(given, thickness_.crs))
        {
            refuse(
                dict,
                "crs",
                "The file says " + crsName(thickness_.crs) + ", the dictionary "
                    + crsName(given) + '.'
            );
        }
        thickness_.crs = given;
    }
    Info << "    raster " << file << ": " << n << " cells of " << thickness_.dx
         << " x " << thickness_.dy << " m with a thickness, " << sum_
         << " m3, CRS " << crsName(thickness_.crs).c_str() << nl;
}

} // namespace releaseRegions
} // namespace lpf
} // namespace Foam
