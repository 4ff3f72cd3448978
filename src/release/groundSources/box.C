// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundSources::box: faces of a box along x y z.
Description  side inside: a tank, the free side is within; outside: a block.
             omit lists faces that are not there.
Usage        <part>
             { type box; min (0 0 0); max (1 1 1); side inside; omit (zMax); }
Units        m
*/
#include "groundSource.H"
#include "inputCheck.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundSources
{

namespace
{

const wordList faceNames{"xMin", "xMax", "yMin", "yMax", "zMin", "zMax"};

// Corners of a face, counter-clockwise seen from outside of the box
List<point> faceOf(const point& low, const point& high, const label f)
{
    const label axis = f / 2;
    const bool isMax = f % 2;
    const direction n = direction(axis), a = direction((axis + 1) % 3),
                    b = direction((axis + 2) % 3);
    List<point> x(4, isMax ? high : low);
    for (label k = 0; k < 4; ++k)
    {
        x[k][n] = isMax ? high[n] : low[n];
        x[k][a] = (k == 1 || k == 2) ? high[a] : low[a];
        x[k][b] = k >= 2 ? high[b] : low[b];
    }
    if (!isMax)
    {
        Swap(x[1], x[3]);
    }
    return x;
}

} // namespace


class box : public groundSource
{
    point min_, max_;
    bool inside_;
    wordList omit_;

public:
    TypeName("box");

    box(const dictionary& dict, const word& name)
        : groundSource(dict, name, {"min", "max", "side", "omit"}),
          min_(readVector(dict, "min", dimLength)),
          max_(readVector(dict, "max", dimLength)),
          inside_(readChoice(dict, "side", {"inside", "outside"}) == "inside"),
          omit_(dict.getOrDefault<wordList>("omit", wordList()))
    {
        for (direction k = 0; k < 3; ++k)
        {
            if (!(min_[k] < max_[k]))
            {
                refuse(dict, "max", "max must exceed min along x, y and z.");
            }
        }
        for (const word& face : omit_)
        {
            if (!faceNames.found(face))
            {
                refuse(
                    dict,
                    "omit",
                    face
                        + " is no face of a box. Faces: xMin xMax yMin yMax"
                          " zMin zMax."
                );
            }
        }
    }

    void add(const groundContext&, groundPieces& pieces) const override
    {
        forAll (faceNames, f)
        {
            if (!omit_.found(faceNames[f]))
            {
                List<point> x = faceOf(min_, max_, f);
                if (inside_)
                {
                    Swap(x[1], x[3]);
                }
                pieces.addPolygon(x, pieces.zoneLabel(zone()));
            }
        }
    }
};

defineTypeNameAndDebug(box, 0);
addToRunTimeSelectionTable(groundSource, box, dictionary);

} // namespace groundSources
} // namespace lpf
} // namespace Foam
