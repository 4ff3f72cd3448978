// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::releaseRegions::box: a block, also an inclined one.
Description  A parallelepiped by a corner and three edges; the third goes from
             the foot to the top. What lies behind the ground is left out.
Usage        release
             {
                 type box; corner (0 0 0);
                 edges ((0.4 0 0) (0 0.4 0) (0 0 0.2));
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

namespace
{

frame readFrame(const dictionary& dict)
{
    const auto edges = dict.get<List<vector>>("edges");
    frame result{readVector(dict, "corner", dimLength), {Zero, Zero, Zero}};
    if (edges.size() == 3)
    {
        result.edges = {edges[0], edges[1], edges[2]};
    }
    if (!(result.volume() > 0))
    {
        refuse(
            dict,
            "edges",
            "edges are three vectors that span a volume [m], the third one"
            " upwards."
        );
    }
    return result;
}

} // namespace


class box : public vessel
{
public:
    TypeName("box");

    box(const dictionary& dict, const releaseContext&)
        : vessel(dict, {"corner", "edges"}, readFrame(dict))
    {
    }

    autoPtr<releaseRegion> above(const scalar volume) const override;
};

defineTypeNameAndDebug(box, 0);
addToRunTimeSelectionTable(releaseRegion, box, dictionary);


//- Vertical walls on the rim of the top face
autoPtr<releaseRegion> box::above(const scalar volume) const
{
    const vector& up = scene_->up;
    const FixedList<vector, 3>& edges = frame_.edges;
    const scalar area = mag((edges[0] ^ edges[1]) & up);
    if (!((edges[2] & up) > 0) || area < 1e-3 * mag(edges[0]) * mag(edges[1]))
    {
        refuse(
            dict_.subDict("water"),
            "excess",
            "The top face of the box, over its first two edges, does not look"
            " upwards: nothing can stand on it. Give the edges of the box in"
            " another order, the third one upwards"
        );
    }
    const scalar width = mag(edges[0] & up) + mag(edges[1] & up);
    scalar height = width + 2 * volume / area;
    autoPtr<box> layer(new box(*this));
    layer->frame_.corner += edges[2];
    // higher where the ground, or plane strain, leaves less than the plan
    scalar room = 0;
    bool filled = false;
    for (label k = 0; k < 12 && !filled; ++k)
    {
        layer->frame_.edges[2] = height * up;
        filled = layer->fillLevel(volume, room);
        height *= 2;
    }
    if (!filled)
    {
        refuseExcess(volume, room);
    }
    return autoPtr<releaseRegion>(layer.release());
}

} // namespace releaseRegions
} // namespace lpf
} // namespace Foam
