// SPDX-License-Identifier: GPL-3.0-or-later
#include "ground.H"
#include "foamFile.H"
#include "inputCheck.H"
#include "OSspecific.H"
#include "SHA1.H"

#include <fstream>
#include <limits>
#include <sstream>

namespace Foam
{
namespace lpf
{

defineTypeNameAndDebug(groundPart, 0);
defineRunTimeSelectionTable(groundPart, dictionary);


namespace
{

// A file of its own: OpenFOAM reads strings of at most 1024 characters, a
// compound CRS is longer; and GIS programs read it as it is
const fileName crsFile("crs.wkt");


string readText(const fileName& name)
{
    std::ifstream is(name);
    string text;
    std::getline(is, text, '\0');
    if (!is.eof() || text.empty())
    {
        FatalErrorInFunction << "Cannot read " << name << exit(FatalError);
    }
    return text;
}


void writeText(const fileName& name, const string& text)
{
    std::ofstream os(name);
    os << text << std::flush;
    if (!os)
    {
        FatalErrorInFunction << "Cannot write " << name << exit(FatalError);
    }
}

} // namespace


autoPtr<groundPart>
groundPart::New(const dictionary& dict, const fileName& directory)
{
    const word type = dict.get<word>("type");
    const auto constructor = dictionaryConstructorTablePtr_->cfind(type);
    if (!constructor.found())
    {
        FatalIOErrorInLookup(
            dict, "groundPart", type, *dictionaryConstructorTablePtr_
        ) << exit(FatalIOError);
    }
    return autoPtr<groundPart>(constructor()(dict, directory));
}


ground::ground(
    PtrList<groundPart>&& parts,
    const wordList& zones,
    const point& origin,
    const string& crs
)
    : parts_(std::move(parts)), zones_(zones), origin_(origin), crs_(crs)
{
}


autoPtr<ground> ground::read(const fileName& caseDir)
{
    const fileName directory = caseDir / "constant" / "terrain";
    const fileName file = directory / "terrainProperties";
    if (!isFile(file))
    {
        FatalErrorInFunction
            << "There is no " << file << ", the ground of the case." << nl
            << "Run terrainToParticles first." << exit(FatalError);
    }
    const dictionary dict = readDictionary(file);
    const dictionary& parts = dict.subDict("parts");
    PtrList<groundPart> list(parts.size());
    label i = 0;
    for (const entry& part : parts)
    {
        list.set(i++, groundPart::New(part.dict(), directory));
    }
    return autoPtr<ground>::New(
        std::move(list),
        dict.get<wordList>("zones"),
        dict.get<point>("origin"),
        dict.found("crs") ? readText(directory / dict.get<fileName>("crs")) : ""
    );
}


word ground::fingerprint(const fileName& caseDir)
{
    const fileName directory = caseDir / "constant" / "terrain";
    fileNameList files(readDir(directory, fileName::FILE, false));
    Foam::sort(files);
    SHA1 sum;
    for (const fileName& file : files)
    {
        std::ifstream is(directory / file, std::ios::binary);
        std::ostringstream content;
        content << is.rdbuf();
        sum.append(content.str());
    }
    // a letter first: digits would be read as a number
    return word("g" + sum.str().substr(0, 16));
}


void ground::write(const fileName& caseDir) const
{
    const fileName directory = caseDir / "constant" / "terrain";
    mkDir(directory);
    dictionary parts;
    forAll (parts_, i)
    {
        const word name = "part" + Foam::name(i);
        parts.add(name, parts_[i].write(directory, name));
    }
    outputFile file(directory / "terrainProperties", IOstreamOption());
    OFstream& os = file.stream();
    // enough digits to read the same double back
    os.precision(std::numeric_limits<scalar>::max_digits10);
    writeFoamHeader(os, "dictionary", "constant/terrain/terrainProperties");
    os << "// input coordinates = local coordinates + origin [m]" << nl;
    os.writeEntry("origin", origin_);
    if (!crs_.empty())
    {
        writeText(directory / crsFile, crs_);
        os.writeEntry("crs", crsFile);
    }
    os.writeEntry("zones", zones_);
    os << nl << "parts" << parts;
    file.close();
}


boundBox ground::bounds() const
{
    boundBox all = boundBox(boundBox::invertedBox);
    forAll (parts_, i)
    {
        if (parts_[i].nTriangles())
        {
            const boundBox part = parts_[i].bounds();
            all.min() = min(all.min(), part.min());
            all.max() = max(all.max(), part.max());
        }
    }
    return all;
}


label ground::nTriangles() const
{
    label n = 0;
    forAll (parts_, i)
    {
        n += parts_[i].nTriangles();
    }
    return n;
}


groundHit
ground::signedDistance(const point& x, const scalar searchRadius) const
{
    groundHit hit;
    forAll (parts_, i)
    {
        parts_[i].nearest(x, searchRadius, hit);
    }
    if (hit.border && hit.distance < 0)
    {
        hit.found = false;
    }
    return hit;
}


surfaceElements ground::elements(const scalar spacing) const
{
    return elements(spacing, boundBox::greatBox);
}


surfaceElements
ground::elements(const scalar spacing, const boundBox& within) const
{
    surfaceElements all;
    forAll (parts_, i)
    {
        parts_[i].elements(spacing, within, all);
        all.ends.append(all.x.size());
    }
    return all;
}


surfaceElements
ground::sections(const scalar spacing, const sectionPlane& plane) const
{
    surfaceElements all;
    forAll (parts_, i)
    {
        parts_[i].sections(spacing, plane, all);
        all.ends.append(all.x.size());
    }
    return all;
}


groundMesh ground::triangles(const label most) const
{
    groundMesh mesh;
    forAll (parts_, i)
    {
        parts_[i].surface(max(most - mesh.faces.size(), 2), mesh);
    }
    return mesh;
}


void ground::triangles(pointField& points, faceList& faces, labelList& zone)
    const
{
    groundMesh mesh = triangles(labelMax);
    points.transfer(mesh.points);
    faces.transfer(mesh.faces);
    zone.transfer(mesh.zone);
}


groundHit ground::elevation(const scalar x, const scalar y) const
{
    groundHit hit;
    forAll (parts_, i)
    {
        parts_[i].elevation(x, y, hit);
    }
    return hit;
}


void ground::removeZone(const word& zone)
{
    const label i = zones_.find(zone);
    forAll (parts_, k)
    {
        parts_[k].removeZone(i);
    }
}

} // namespace lpf
} // namespace Foam
