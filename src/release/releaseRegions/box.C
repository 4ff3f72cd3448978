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
};

defineTypeNameAndDebug(box, 0);
addToRunTimeSelectionTable(releaseRegion, box, dictionary);

} // namespace releaseRegions
} // namespace lpf
} // namespace Foam
