// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundSources::arc: a part of a cylinder.
Description  Strips between lines on the cylinder: the surface lies within
             radius (1 - cos(half the angle of a strip)) of it, 2e-4 radius
             at 1 degree a strip... on the inner side of the circle.
             Angles are turned about axis, from direction, right-handed.
             side inside: a trough, the axis is on the free side.
Usage        <part>
             {
                 type arc; centre (0 0 2); axis (0 -1 0);
                 direction (0 0 -1); radius 2; from -60; to 60;
                 width 1; segments 240; side inside;
             }
Units        m, degrees
*/
#include "groundSource.H"
#include "inputCheck.H"
#include "mathematicalConstants.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundSources
{

class arc : public groundSource
{
    point centre_;
    vector axis_, zero_;
    scalar radius_, from_, to_, width_;
    label segments_;
    bool inside_;

    //- Point of the circle; t from 0 to 1 along the arc
    point circle(const scalar t) const
    {
        const scalar angle =
            (from_ + t * (to_ - from_)) * constant::mathematical::pi / 180;
        return centre_
             + radius_
                   * (Foam::cos(angle) * zero_
                      + Foam::sin(angle) * (axis_ ^ zero_));
    }

public:
    TypeName("arc");

    arc(const dictionary& dict, const word& name)
        : groundSource(
            dict,
            name,
            {"centre",
             "axis",
             "direction",
             "radius",
             "from",
             "to",
             "width",
             "segments",
             "side"}
        ),
          centre_(readVector(dict, "centre", dimLength)),
          axis_(readVector(dict, "axis", dimless)),
          zero_(readVector(dict, "direction", dimless)),
          radius_(readNumber(
              dict, "radius", dimLength, {0, GREAT, true, false, "a length"}
          )),
          from_(dict.get<scalar>("from")), to_(dict.get<scalar>("to")),
          width_(readNumber(
              dict, "width", dimLength, {0, GREAT, true, false, "a length"}
          )),
          segments_(dict.get<label>("segments")),
          inside_(readChoice(dict, "side", {"inside", "outside"}) == "inside")
    {
        axis_ /= max(mag(axis_), VSMALL);
        const scalar length = mag(zero_);
        zero_ -= (zero_ & axis_) * axis_;
        if (!(mag(zero_) > 1e-6 * length))
        {
            refuse(
                dict,
                "direction",
                "direction is where the angle is 0; it must not be parallel"
                " to the axis."
            );
        }
        zero_ /= mag(zero_);
        if (!(from_ < to_) || to_ - from_ > 360 || segments_ < 1)
        {
            refuse(
                dict,
                "segments",
                "An arc goes from a smaller to a larger angle, at most 360"
                " degrees, in at least one segment."
            );
        }
    }

    void add(const groundContext&, groundPieces& pieces) const override
    {
        const label label0 = pieces.zoneLabel(zone());
        const vector half = 0.5 * width_ * axis_;
        for (label k = 0; k < segments_; ++k)
        {
            const point a = circle(scalar(k) / segments_);
            const point b = circle(scalar(k + 1) / segments_);
            List<point> strip{a - half, b - half, b + half, a + half};
            if (inside_)
            {
                Swap(strip[1], strip[3]);
            }
            pieces.addPolygon(strip, label0);
        }
    }
};

defineTypeNameAndDebug(arc, 0);
addToRunTimeSelectionTable(groundSource, arc, dictionary);

} // namespace groundSources
} // namespace lpf
} // namespace Foam
