// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::releaseRegions::polygon: thickness within polygons.
Description  Polygons of a vector file on top of the ground, with holes.
             thickness is vertical, or normal to the slope (vertical thickness
             = normal / cos slope); a number, or the name of an attribute.
Usage        release
             {
                 type polygon; file "constant/gisdata/release.gpkg";
                 thickness vertical 10;  // normal 10, vertical <attribute>
                 where "id = 1"; layer release;    // optional
                 position onGround;                // or inGround
             }
Units        m
*/
#include "sheet.H"
#include "crs.H"
#include "inputCheck.H"
#include "polygons.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace releaseRegions
{

class polygon : public sheet
{
    polygonSet areas_; //!< input coordinates, value: the thickness

    //- The entry `thickness`; returns the attribute or "" and a number
    word readThickness(scalar& number);

public:
    TypeName("polygon");

    polygon(const dictionary& dict, const releaseContext& context);

    boundBox plan() const override { return areas_.bounds(); }

    string crs() const override { return areas_.crs; }

    scalar volume() const override;

protected:
    scalar thicknessAt(const scalar x, const scalar y) const override
    {
        const label i = areas_.find(point2D(x, y));
        return i < 0 ? 0 : areas_.polygons[i].value;
    }
};

defineTypeNameAndDebug(polygon, 0);
addToRunTimeSelectionTable(releaseRegion, polygon, dictionary);


word polygon::readThickness(scalar& number)
{
    ITstream& is = dict_.lookup("thickness");
    const bool named =
        is.size() == 2 && is[0].isWord()
        && (is[0].wordToken() == "vertical" || is[0].wordToken() == "normal");
    if (!named || !(is[1].isNumber() || is[1].isWord() || is[1].isString())
        || (is[1].isNumber() && !(is[1].number() > 0)))
    {
        refuse(
            dict_,
            "thickness",
            "thickness says how it is measured and how much [m]:"
            " `thickness vertical 10;` or `thickness normal 10;`, or the name"
            " of an attribute in place of the number."
        );
    }
    normal_ = is[0].wordToken() == "normal";
    if (is[1].isNumber())
    {
        number = is[1].number();
        return "";
    }
    return is[1].isWord() ? is[1].wordToken() : word(is[1].stringToken());
}


polygon::polygon(const dictionary& dict, const releaseContext& context)
    : sheet(dict, {"file", "where", "layer", "thickness", "crs"})
{
    const auto file = dict.get<fileName>("file");
    scalar number = 0;
    polygonQuery query;
    query.file = file.isAbsolute() ? file : context.caseDir / file;
    query.where = dict.getOrDefault<string>("where", "");
    query.layer = dict.getOrDefault<word>("layer", "");
    query.value = readThickness(number);
    if (normal_ && below_)
    {
        refuse(
            dict,
            "position",
            "A release in the ground lowers the heights of the elevation model"
            " by its thickness, which is then vertical: thickness vertical .."
        );
    }
    areas_ = readPolygons(query, dict);
    for (lpf::polygon& p : areas_.polygons)
    {
        p.value = query.value.empty() ? number : p.value;
        if (!(p.value > 0))
        {
            refuse(
                dict,
                "thickness",
                "The attribute " + query.value + " of a polygon is "
                    + Foam::name(p.value)
                    + "; a thickness is positive. Correct the file or choose"
                      " by `where`."
            );
        }
    }
    if (dict.found("crs"))
    {
        areas_.crs = crsFromText(dict.get<string>("crs"), dict);
    }
    Info << "    polygons " << file << ": " << areas_.polygons.size()
         << " with " << areas_.nHoles() << " holes, " << areas_.area()
         << " m2, CRS " << crsName(areas_.crs).c_str() << nl;
}


scalar polygon::volume() const
{
    if (normal_ || scene_->grid.acrossAxis >= 0)
    {
        return columnVolume();
    }
    scalar sum = 0;
    for (const lpf::polygon& p : areas_.polygons)
    {
        sum += p.area() * p.value;
    }
    return sum;
}

} // namespace releaseRegions
} // namespace lpf
} // namespace Foam
