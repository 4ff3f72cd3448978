// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundSources::surface: a surface file, STL or OBJ.
Description  Read by OpenFOAM's surface library (stl, stlb, obj, ftr, ...).
             Patches become zones, unless zone is given. Normals must point to
             the free side; flip yes turns them round.
             STL is read in single precision: coordinates far from 0 are
             refused, for they lose the surface. OBJ keeps all digits.
Usage        <part>
             {
                 type surface; file "constant/triSurface/chute.obj";
                 scale 0.001; translate (0 0 0); flip no;
             }
Units        m after scale
*/
#include "groundSource.H"
#include "inputCheck.H"
#include "OSspecific.H"
#include "Switch.H"
#include "triSurface.H"
#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundSources
{

class surface : public groundSource
{
    const dictionary& dict_;
    fileName file_;
    scalar scale_;
    vector translate_;
    bool flip_;

    //- One in 1e4 of the size of the surface is lost at this ratio of
    //  distance from 0 and size (single precision has 24 bits)
    void checkPrecision(const triSurface& mesh, const fileName& path) const
    {
        const boundBox box(mesh.points(), false);
        const scalar far = max(mag(box.min()), mag(box.max()));
        const word extension = path.ext();
        if ((extension == "stl" || extension == "stlb")
            && far > 1000 * box.mag())
        {
            refuse(
                dict_,
                "file",
                path + " lies " + Foam::name(far) + " m from 0 and is only "
                    + Foam::name(box.mag())
                    + " m large: STL keeps 7 digits and the surface is lost"
                      " in rounding. Use OBJ, or move the surface near 0."
            );
        }
    }

public:
    TypeName("surface");

    surface(const dictionary& dict, const word& name)
        : groundSource(dict, name, {"file", "scale", "translate", "flip"}),
          dict_(dict), file_(dict.get<fileName>("file")),
          scale_(readNumber(
              dict,
              "scale",
              dimless,
              {0, GREAT, true, false, "metres per unit of the file"},
              1
          )),
          translate_(
              dict.found("translate") ? readVector(dict, "translate", dimLength)
                                      : vector(Zero)
          ),
          flip_(dict.getOrDefault<Switch>("flip", false))
    {
    }

    void add(const groundContext& context, groundPieces& pieces) const override
    {
        const fileName path =
            file_.isAbsolute() ? file_ : context.caseDir / file_;
        if (!isFile(path, false))
        {
            refuse(
                dict_,
                "file",
                "There is no file " + path
                    + ". Paths are relative to the"
                      " case."
            );
        }
        const triSurface mesh(path);
        checkPrecision(mesh, path);
        const bool oneZone = dict_.found("zone") || mesh.patches().empty();
        for (const labelledTri& t : mesh)
        {
            const label zoneName = pieces.zoneLabel(
                oneZone ? zone() : mesh.patches()[t.region()].name()
            );
            corners c;
            forAll (c, k)
            {
                const label v = t[flip_ ? 2 - k : k];
                c[k] = scale_ * mesh.points()[v] + translate_;
            }
            pieces.triangles.append(c);
            pieces.triangleZone.append(zoneName);
        }
    }
};

defineTypeNameAndDebug(surface, 0);
addToRunTimeSelectionTable(groundSource, surface, dictionary);

} // namespace groundSources
} // namespace lpf
} // namespace Foam
