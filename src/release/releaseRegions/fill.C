// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::releaseRegions::fill: a given volume in a space.
Description  Fills the box, as in tank, from the ground up; finds the height of
             the surface that gives the volume. The surface is level (normal to
             gravity) or parallel to e1 and e2 of the lattice, as on a chute.
Usage        release
             {
                 type fill; box ((0 0 0) (1 1 1)); volume 0.0769;
                 surface level;             // or parallel
                 outline ((0 0 0) ...);     // optional
             }
Units        m, m3
*/
#include "vessel.H"
#include "inputCheck.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace releaseRegions
{

class fill : public vessel
{
    scalar volume_;
    bool level_;

    void findSurface();

public:
    TypeName("fill");

    fill(const dictionary& dict, const releaseContext& context)
        : vessel(
            dict,
            {"box", "volume", "surface", "outline"},
            readBox(dict, context.axes)
        ),
          volume_(readNumber(
              dict, "volume", dimVolume, {0, GREAT, true, false, "bulk volume"}
          )),
          level_(readChoice(dict, "surface", {"level", "parallel"}) == "level")
    {
        readOutline(dict);
    }

    void place(const releaseScene& scene) override
    {
        vessel::place(scene);
        hasSurface_ = true;
        surfaceNormal_ = level_ ? scene.up : scene.grid.e(2);
        if (!((unitUp() & surfaceNormal_) > 0))
        {
            refuse(
                dict_,
                "surface",
                "The third axis of the lattice, e3, must point upwards to fill"
                " from below. Set lattice { axes .. }."
            );
        }
        findSurface();
    }

    scalar volume() const override { return volume_; }
};

defineTypeNameAndDebug(fill, 0);
addToRunTimeSelectionTable(releaseRegion, fill, dictionary);


void fill::findSurface()
{
    scalar room = 0;
    if (!fillTo(volume_, room))
    {
        refuse(
            dict_,
            "volume",
            "The box holds only " + Foam::name(room)
                + " m3 on the free side of the ground. Enlarge the box or"
                  " reduce the volume; is the box on the free side?"
        );
    }
}

} // namespace releaseRegions
} // namespace lpf
} // namespace Foam
