// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenePreparation.H"
#include "foamFile.H"
#include "OSspecific.H"
#include "SHA1.H"

#include <limits>

namespace Foam
{
namespace lpf
{

namespace
{

// A folder beside the results, removed whatever happens
class staging
{
    fileName path_;

public:
    explicit staging(const fileName& caseDir)
        : path_(caseDir / ".terrainToParticles")
    {
        rmDir(path_, true);
        if (!mkDir(path_))
        {
            FatalErrorInFunction << "Cannot make " << path_
                                 << ": may you write into the case?"
                                 << exit(FatalError);
        }
    }

    ~staging() { rmDir(path_, true); }

    const fileName& path() const { return path_; }
};


// Put a file or folder in the place of an older one
void replace(const fileName& from, const fileName& to)
{
    mkDir(to.path());
    const fileName old = from + ".old";
    if ((isFile(to, false) || isDir(to)) && !mv(to, old))
    {
        FatalErrorInFunction << "Cannot replace " << to << exit(FatalError);
    }
    if (!mv(from, to))
    {
        mv(old, to);
        FatalErrorInFunction << "Cannot write " << to << exit(FatalError);
    }
}

} // namespace


void scenePreparation::writePhases(Ostream& os) const
{
    if (has("grains"))
    {
        scalar mass = 0, volume = 0;
        for (const releaseBody& body : bodies_)
        {
            mass += body.mass;
            volume += body.volume;
        }
        os.beginBlock("grains");
        os.writeEntry("count", grains_.size());
        os.writeEntry("mass", mass);
        os.writeEntry("volume", volume);
        os.writeEntry("solidFraction", solidFraction());
        os.writeEntry("rho", material_.rho);
        os.endBlock();
    }
    if (has("water"))
    {
        scalar mass = 0;
        for (const waterBody& body : waters_)
        {
            mass += body.mass;
        }
        os.beginBlock("water");
        os.writeEntry("count", water_.size());
        os.writeEntry("mass", mass);
        os.writeEntry("volume", mass / waterDensity_);
        os.writeEntry("rho", waterDensity_);
        os.endBlock();
    }
}


// By which lpfSolver knows whether a time is of these particles
word scenePreparation::fingerprint() const
{
    SHA1 sum;
    const auto add = [&](const auto& field) {
        sum.append(
            reinterpret_cast<const char*>(field.cdata()), field.byteSize()
        );
    };
    for (const cloudState* cloud : {&grains_, &water_})
    {
        if (cloud->size())
        {
            add(cloud->positions);
            add(cloud->scalars["mass"]);
            add(cloud->vectors["U"]);
        }
    }
    // a letter first: digits would be read as a number
    return word("r" + sum.str().substr(0, 16));
}


void scenePreparation::writeReleaseProperties(const fileName& file) const
{
    outputFile out(file, IOstreamOption());
    OFstream& os = out.stream();
    // enough digits to read the same double back
    os.precision(std::numeric_limits<scalar>::max_digits10);
    writeFoamHeader(os, "dictionary", "constant/releaseProperties");
    os << "// written by terrainToParticles; SI units" << nl;
    os.writeEntry("phases", phases_);
    os.writeEntry("spacing", grid_.spacing);
    os.writeEntry("smoothingLength", smoothingRatio * grid_.spacing);
    if (has("water"))
    {
        os.writeEntry("waterSpacing", waterSpacing_);
        os.writeEntry("waterSmoothingLength", smoothingRatio * waterSpacing_);
    }
    os.writeEntry("dimensions", frame_.planeThickness > 0 ? 2 : 3);
    if (frame_.planeThickness > 0)
    {
        os.writeEntry("planeNormal", frame_.planeNormal);
        os.writeEntry("planeThickness", frame_.planeThickness);
    }
    if (frame_.cyclic.size())
    {
        os.beginBlock("cyclic");
        for (const cyclicPair& pair : frame_.cyclic)
        {
            os.writeKeyword(pair.name())
                << token::BEGIN_LIST << pair.from << token::SPACE << pair.to
                << token::END_LIST << token::END_STATEMENT << nl;
        }
        os.endBlock();
    }
    os.writeEntry("releaseHeight", releaseHeight_);
    os.writeEntry("maxSpeed", maxSpeed());
    os.writeEntry("zones", names_);
    os.writeEntry("fingerprint", fingerprint());
    if (!dictDigest_.empty())
    {
        os.writeEntry("dictionary", dictDigest_);
    }
    writePhases(os);
    out.close();
}


void scenePreparation::write() const
{
    const staging stage(caseDir_);
    const fileName& from = stage.path();
    mkDir(from / "constant");
    ground_->write(from);
    writeReleaseProperties(from / "constant" / "releaseProperties");
    const IOstreamOption binary(IOstream::BINARY);
    string clouds;
    for (const word& phase : phases_)
    {
        writeCloud(
            from / "0", phase, phase == "grains" ? grains_ : water_, binary
        );
        clouds += "0/lagrangian/" + phase + " ";
    }

    pointField points;
    faceList faces;
    labelList zone;
    ground_->triangles(points, faces, zone);
    boundBox box = ground_->bounds();
    box.add(positions());
    writeDisplayMesh(from, box, points, faces);

    for (const fileName& part :
         {fileName("constant/terrain"),
          fileName("constant/polyMesh"),
          fileName("constant/releaseProperties"),
          fileName("0/uniform"),
          fileName("0/lagrangian")})
    {
        replace(from / part, caseDir_ / part);
    }
    // foamToVTK and checkMesh ask for these; the user's own ones stay
    for (const fileName& part :
         {fileName("system/fvSchemes"), fileName("system/fvSolution")})
    {
        if (!isFile(caseDir_ / part))
        {
            replace(from / part, caseDir_ / part);
        }
    }
    // ParaView's reader opens a case by an empty file of this kind
    OFstream(caseDir_ / caseDir_.name() + ".foam");
    Info << "Written: constant/terrain constant/polyMesh"
         << " constant/releaseProperties " << clouds.c_str() << caseDir_.name()
         << ".foam" << nl << endl;
}

} // namespace lpf
} // namespace Foam
