// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundSources::plane: a rectangle on a plane.
Description  point is its middle, normal points to the free side; the first
             size is along direction, the second across.
Usage        <part>
             {
                 type plane; point (0 0 0); normal (0 0 1);
                 direction (1 0 0); size (10 2);
             }
Units        m
*/
#include "groundSource.H"
#include "inputCheck.H"
#include "point2D.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundSources
{

class plane : public groundSource
{
    point middle_;
    vector along_, across_; //!< half sizes

public:
    TypeName("plane");

    plane(const dictionary& dict, const word& name)
        : groundSource(dict, name, {"point", "normal", "direction", "size"}),
          middle_(readVector(dict, "point", dimLength))
    {
        const vector normal = readVector(dict, "normal", dimless);
        const vector direction = readVector(dict, "direction", dimless);
        const auto size = dict.get<vector2D>("size");
        const vector n = normal / max(mag(normal), VSMALL);
        const vector inPlane = direction - (direction & n) * n;
        if (!(mag(normal) > 0) || !(mag(inPlane) > 1e-6 * mag(direction)))
        {
            refuse(
                dict,
                "direction",
                "direction must lie along the plane: it and the normal are two"
                " vectors that are not parallel."
            );
        }
        if (!(size.x() > 0) || !(size.y() > 0))
        {
            refuse(dict, "size", "Both sizes of a plane must be positive [m].");
        }
        along_ = 0.5 * size.x() * inPlane / mag(inPlane);
        across_ = 0.5 * size.y() * (n ^ (inPlane / mag(inPlane)));
    }

    void add(const groundContext&, groundPieces& pieces) const override
    {
        const List<point> outline{
            middle_ - along_ - across_,
            middle_ + along_ - across_,
            middle_ + along_ + across_,
            middle_ - along_ + across_};
        pieces.addPolygon(outline, pieces.zoneLabel(zone()));
    }
};

defineTypeNameAndDebug(plane, 0);
addToRunTimeSelectionTable(groundSource, plane, dictionary);

} // namespace groundSources
} // namespace lpf
} // namespace Foam
