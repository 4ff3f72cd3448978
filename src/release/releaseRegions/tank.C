// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::releaseRegions::tank: a space filled up to a level.
Description  Everything within the box and on the free side of the ground, up
             to a level surface. The box is given by two opposite corners, its
             edges run along the axes of the lattice. outline, points whose
             projection along e3 surrounds the body, makes it a prism.
             level is a height against gravity: z when g points along -z.
Usage        release
             {
                 type tank; box ((0 0 0) (1 1 1)); level 0.8;
                 outline ((0 0 0) (1 0 0) (0 1 0)); // optional
             }
Units        m
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

class tank : public vessel
{
    scalar level_;

public:
    TypeName("tank");

    tank(const dictionary& dict, const releaseContext& context)
        : vessel(
            dict, {"box", "level", "outline"}, readBox(dict, context.axes)
        ),
          level_(readNumber(dict, "level", dimLength, {}))
    {
        readOutline(dict);
    }

    void place(const releaseScene& scene) override
    {
        vessel::place(scene);
        hasSurface_ = true;
        surfaceNormal_ = scene.up;
        surfaceHeight_ = level_ - (scene.up & scene.bed.origin());
        if (!((unitUp() & scene.up) > 0))
        {
            refuse(
                dict_,
                "level",
                "The third axis of the lattice, e3, must point upwards for a"
                " level surface. Set lattice { axes .. }."
            );
        }
    }
};

defineTypeNameAndDebug(tank, 0);
addToRunTimeSelectionTable(releaseRegion, tank, dictionary);

} // namespace releaseRegions
} // namespace lpf
} // namespace Foam
