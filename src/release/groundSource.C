// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundSource.H"
#include "heightField.H"
#include "inputCheck.H"
#include "Switch.H"
#include "polygonTriangles.H"
#include "triangles.H"

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(groundSource, 0);
defineRunTimeSelectionTable(groundSource, dictionary);


label groundPieces::zoneLabel(const word& zone)
{
    label i = zones.find(zone);
    if (i < 0)
    {
        i = zones.size();
        zones.append(zone);
    }
    return i;
}


bool groundPieces::addPolygon(const UList<point>& outline, const label zone)
{
    const List<corners> parts = triangulate(outline);
    for (const corners& t : parts)
    {
        triangles.append(t);
        triangleZone.append(zone);
    }
    return parts.size();
}


boundBox groundPieces::bounds() const
{
    boundBox box = boundBox(boundBox::invertedBox);
    for (const corners& t : triangles)
    {
        for (const point& p : t)
        {
            box.add(p);
        }
    }
    for (const rasterPiece& piece : rasters)
    {
        const raster& r = piece.heights;
        forAll (r.values, k)
        {
            if (!r.missing[k])
            {
                const label j = k / r.nx, i = k - j * r.nx;
                box.add(point(r.x0 + i * r.dx, r.y0 + j * r.dy, r.values[k]));
            }
        }
    }
    return box;
}


autoPtr<ground> groundPieces::build(const point& origin) const
{
    PtrList<groundPart> parts;
    for (const rasterPiece& piece : rasters)
    {
        const raster& r = piece.heights;
        scalarField z(r.size(), heightField::hole());
        forAll (z, k)
        {
            if (!r.missing[k])
            {
                z[k] = r.values[k] - origin.z();
            }
        }
        const heightGrid grid{
            r.nx, r.ny, r.x0 - origin.x(), r.y0 - origin.y(), r.dx, r.dy};
        parts.append(
            autoPtr<groundPart>(new heightField(grid, std::move(z), piece.zone))
        );
    }
    if (triangles.size())
    {
        List<corners> local(triangles);
        for (corners& t : local)
        {
            for (point& p : t)
            {
                p -= origin;
            }
        }
        parts.append(autoPtr<groundPart>(new lpf::triangles(local, triangleZone)
        ));
    }
    return autoPtr<ground>::New(std::move(parts), wordList(zones), origin, crs);
}


autoPtr<groundSource>
groundSource::New(const dictionary& dict, const word& name)
{
    const word type =
        readChoice(dict, "type", dictionaryConstructorTablePtr_->sortedToc());
    return dictionaryConstructorTablePtr_->cfind(type)()(dict, name);
}


groundSource::groundSource(
    const dictionary& dict, const word& name, const wordList& keywords
)
    : zone_(dict.getOrDefault<word>("zone", name))
{
    wordList valid(keywords);
    valid.append(wordList{"type", "zone", "active"});
    allowOnly(dict, valid);
}


groundPieces readGround(const dictionary& dict, const groundContext& context)
{
    groundPieces pieces;
    const auto add = [&](const dictionary& part, const word& name)
    {
        const autoPtr<groundSource> source = groundSource::New(part, name);
        if (part.getOrDefault<Switch>("active", true))
        {
            source->add(context, pieces);
        }
        else
        {
            Info << "    part " << name << " of the ground is not active" << nl;
        }
    };
    if (dict.found("type"))
    {
        add(dict, "terrain");
    }
    else
    {
        for (const entry& part : dict)
        {
            if (!part.isDict())
            {
                refuse(
                    dict,
                    part.keyword(),
                    "ground is either one part with a type, or several"
                    " sub-dictionaries, each with a type."
                );
            }
            add(part.dict(), part.keyword());
        }
    }
    if (pieces.triangles.empty() && pieces.rasters.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There is no ground: no part is given or active."
            << exit(FatalIOError);
    }
    return pieces;
}

} // namespace lpf
} // namespace Foam
