// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundSources::polygon: a plane polygon.
Description  Corners counter-clockwise seen from the free side.
Usage        <part> { type polygon; points ((0 0 0) (1 0 0) (1 1 0)); }
Units        m
*/
#include "groundSource.H"
#include "inputCheck.H"
#include "polygonTriangles.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundSources
{

class polygon : public groundSource
{
    List<point> points_;

public:
    TypeName("polygon");

    polygon(const dictionary& dict, const word& name)
        : groundSource(dict, name, {"points"}),
          points_(dict.get<List<point>>("points"))
    {
        // a corner off the plane would tilt triangles against each other
        constexpr scalar flat = 1e-4;
        if (points_.size() < 3 || unevenness(points_) > flat)
        {
            refuse(
                dict,
                "points",
                "A polygon has at least three points in one plane. Split it"
                " into plane parts."
            );
        }
        if (triangulate(points_).empty())
        {
            refuse(
                dict,
                "points",
                "The polygon crosses itself or has no area; its free side is"
                " not defined. List the corners in order, counter-clockwise"
                " seen from the free side."
            );
        }
    }

    void add(const groundContext&, groundPieces& pieces) const override
    {
        pieces.addPolygon(points_, pieces.zoneLabel(zone()));
    }
};

defineTypeNameAndDebug(polygon, 0);
addToRunTimeSelectionTable(groundSource, polygon, dictionary);

} // namespace groundSources
} // namespace lpf
} // namespace Foam
