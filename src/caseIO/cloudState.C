// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloudState.H"
#include "foamFile.H"
#include "DynamicList.H"
#include "IOobject.H"
#include "OSspecific.H"

namespace
{

using namespace Foam;

fileName cloudDir(const fileName& timeDir, const word& cloud)
{
    return timeDir / "lagrangian" / cloud;
}


template<class T>
void writeFields(
    const fileName& dir,
    const word& className,
    const HashTable<Field<T>>& fields,
    const label size,
    const IOstreamOption& format
)
{
    for (const word& name : fields.sortedToc())
    {
        if (fields[name].size() != size)
        {
            FatalErrorInFunction << "Field " << name << " has "
                                 << fields[name].size() << " values for "
                                 << size << " particles of " << dir
                                 << abort(FatalError);
        }
        lpf::writeList(dir / name, className, fields[name], format);
    }
}


template<class T>
void readField(
    const lpf::inputFile& file,
    const word& name,
    const label size,
    HashTable<Field<T>>& fields
)
{
    Field<T> values(lpf::readList<T>(file));
    if (values.size() != size)
    {
        file.damaged(
            "it has " + Foam::name(values.size())
                + " values but positions "
                  "beside it has "
                + Foam::name(size),
            nullptr
        );
    }
    fields.set(name, std::move(values));
}


//- What Cloud<passiveParticle> of 1912 needs to look for `positions`
//  instead of `coordinates`
void writeCloudProperties(
    const fileName& timeDir, const word& cloud, const label size
)
{
    const fileName dir(timeDir / "uniform" / "lagrangian" / cloud);
    mkDir(dir);
    const fileName file(dir / "cloudProperties");
    lpf::outputFile out(file, IOstreamOption());
    lpf::writeFoamHeader(out.stream(), "dictionary", file);
    out.stream() << "geometry        positions;\n\n"
                 << "processor0\n{\n    particleCount   " << size << ";\n}\n";
    IOobject::writeEndDivider(out.stream());
    out.close();
}

} // namespace


Foam::wordList Foam::lpf::cloudNames(const fileName& timeDir)
{
    DynamicList<word> names;
    for (const fileName& dir :
         readDir(timeDir / "lagrangian", fileName::DIRECTORY))
    {
        // true: positions.gz counts, too
        if (isFile(timeDir / "lagrangian" / dir / "positions", true))
        {
            names.append(word(dir));
        }
    }
    wordList result(std::move(names));
    Foam::sort(result);
    return result;
}


Foam::lpf::cloudState
Foam::lpf::readCloud(const fileName& timeDir, const word& cloud)
{
    const fileName dir = cloudDir(timeDir, cloud);
    if (!isFile(dir / "positions", true))
    {
        FatalIOError("", "", 0, dir / "positions", -1, -1)
            << "There is no cloud '" << cloud << "' in " << timeDir << nl
            << "Run terrainToParticles, or choose another time"
            << exit(FatalIOError);
    }
    cloudState state;
    state.positions = readPositions(inputFile(dir / "positions"));

    for (const fileName& found : readDir(dir, fileName::FILE))
    {
        const word name(found.hasExt("gz") ? found.lessExt() : found);
        if (name == "positions" || name == "coordinates")
        {
            continue;
        }
        const inputFile file(dir / name);
        const label n = state.size();
        if (file.className == "labelField")
        {
            readField(file, name, n, state.labels);
        }
        else if (file.className == "scalarField")
        {
            readField(file, name, n, state.scalars);
        }
        else if (file.className == "vectorField")
        {
            readField(file, name, n, state.vectors);
        }
        else if (file.className == "symmTensorField")
        {
            readField(file, name, n, state.symmTensors);
        }
        else
        {
            WarningInFunction << "Passing over " << file.name << ": class "
                              << file.className << " is none of ours" << endl;
        }
    }
    return state;
}


void Foam::lpf::writeCloud(
    const fileName& timeDir,
    const word& cloud,
    const cloudState& state,
    const IOstreamOption& format
)
{
    const fileName dir = cloudDir(timeDir, cloud);
    mkDir(dir);
    writePositions(dir / "positions", state.positions, format);
    const label n = state.size();
    writeFields(dir, "labelField", state.labels, n, format);
    writeFields(dir, "scalarField", state.scalars, n, format);
    writeFields(dir, "vectorField", state.vectors, n, format);
    writeFields(dir, "symmTensorField", state.symmTensors, n, format);
    writeCloudProperties(timeDir, cloud, n);
}
