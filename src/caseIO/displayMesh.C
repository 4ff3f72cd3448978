// SPDX-License-Identifier: GPL-3.0-or-later
/*
Description  constant/polyMesh of two cells, for viewers and converters only.

             cell 0  a box that holds every particle. It has six faces, so that
                     foamToVTK, which tracks each particle from the centre of
                     its cell, is quick and never meets the ground
             cell 1  a box beneath it, which shares the face between them and
                     owns the ground triangles. They do not close a volume
                     with the box: checkMesh says so and goes on
*/

#include "cloudState.H"
#include "foamFile.H"
#include "surfaceDecimation.H"
#include "IOobject.H"
#include "OSspecific.H"

namespace
{

using namespace Foam;

constexpr label maxTriangles = 200000;

// the eight corners of the upper box, then the lower four of the lower one
constexpr label nCorners = 12;

// corners counter-clockwise as seen from outside of the cell that owns the
// face; the first lies between the cells
const label boxFaces[11][4] = {
    {0, 3, 2, 1},
    // cell 0
    {4, 5, 6, 7},
    {0, 1, 5, 4},
    {1, 2, 6, 5},
    {2, 3, 7, 6},
    {3, 0, 4, 7},
    // cell 1
    {8, 11, 10, 9},
    {8, 9, 1, 0},
    {9, 10, 2, 1},
    {10, 11, 3, 2},
    {11, 8, 0, 3}};
constexpr label nInternal = 1;
constexpr label nCell0 = 5;
constexpr label nCell1 = 5;


//- The box, with room for particles at its faces and for scenes of no width
boundBox enclosing(const boundBox& box, const pointField& ground)
{
    boundBox all(box);
    all.add(ground);
    const scalar margin = 0.02 * all.mag() + VSMALL;
    return boundBox(
        all.min() - vector::uniform(margin), all.max() + vector::uniform(margin)
    );
}


pointField corners(const boundBox& b)
{
    const pointField box(b.points());
    const vector down(0, 0, -0.1 * b.mag());

    // boundBox::points(): 0-3 the lower four counter-clockwise, 4-7 above
    pointField points(nCorners);
    for (label i = 0; i < 8; ++i)
    {
        points[i] = box[i];
    }
    for (label i = 0; i < 4; ++i)
    {
        points[8 + i] = box[i] + down;
    }
    return points;
}


//- List of faces in the form of binary files: begins, then corners
void writeFaces(
    const fileName& dir, const faceList& triangles, const IOstreamOption& format
)
{
    const label nBox = nInternal + nCell0 + nCell1;
    labelList begins(nBox + triangles.size() + 1);
    labelList labels(4 * nBox + 3 * triangles.size());
    label n = 0;
    for (label i = 0; i < nBox; ++i)
    {
        begins[i] = n;
        for (const label corner : boxFaces[i])
        {
            labels[n++] = corner;
        }
    }
    forAll (triangles, i)
    {
        begins[nBox + i] = n;
        for (const label corner : triangles[i])
        {
            labels[n++] = nCorners + corner;
        }
    }
    begins.last() = n;

    const fileName file(dir / "faces");
    lpf::outputFile out(file, format);
    lpf::writeFoamHeader(out.stream(), "faceCompactList", file);
    out.stream() << begins << nl << labels;
    IOobject::writeEndDivider(out.stream());
    out.close();
}


void writeOwner(
    const fileName& dir,
    const word& object,
    const labelList& cells,
    const string& note,
    const IOstreamOption& format
)
{
    const fileName file(dir / object);
    lpf::outputFile out(file, format);
    lpf::writeFoamHeader(out.stream(), "labelList", file, note);
    out.stream() << cells;
    IOobject::writeEndDivider(out.stream());
    out.close();
}


void writeBoundary(const fileName& dir, const label nTriangles)
{
    const fileName file(dir / "boundary");
    lpf::outputFile out(file, IOstreamOption());
    Ostream& os = out.stream();
    const label nBox = nInternal + nCell0 + nCell1;
    lpf::writeFoamHeader(os, "polyBoundaryMesh", file);
    os << "2\n(\n"
       << "    bounds\n    {\n        type            patch;\n"
       << "        nFaces          " << nCell0 + nCell1 << ";\n"
       << "        startFace       " << nInternal << ";\n    }\n"
       << "    terrain\n    {\n        type            wall;\n"
       << "        nFaces          " << nTriangles << ";\n"
       << "        startFace       " << nBox << ";\n    }\n)\n";
    IOobject::writeEndDivider(os);
    out.close();
}


//- foamToVTK and checkMesh stop without these, though they use neither
void writeSystemFiles(const fileName& caseDir)
{
    const fileName dir(caseDir / "system");
    mkDir(dir);
    const string unused(
        "// Not read by lpfSolver. OpenFOAM's foamToVTK and checkMesh ask for "
        "this file\n\n"
    );
    const string schemes("ddtSchemes           {}\ngradSchemes          {}\n"
                         "divSchemes           {}\nlaplacianSchemes     {}\n"
                         "interpolationSchemes {}\nsnGradSchemes        {}\n");
    for (const char* name : {"fvSchemes", "fvSolution"})
    {
        const fileName file(dir / name);
        if (!isFile(file))
        {
            lpf::outputFile out(file, IOstreamOption());
            lpf::writeFoamHeader(out.stream(), "dictionary", file);
            out.stream() << unused.c_str();
            if (word("fvSchemes") == name)
            {
                out.stream() << schemes.c_str();
            }
            IOobject::writeEndDivider(out.stream());
            out.close();
        }
    }
}

} // namespace


void Foam::lpf::writeDisplayMesh(
    const fileName& caseDir,
    const boundBox& box,
    const pointField& groundPoints,
    const faceList& groundTriangles
)
{
    pointField ground(groundPoints);
    faceList triangles(groundTriangles);
    decimate(ground, triangles, maxTriangles);

    const fileName dir(caseDir / "constant" / "polyMesh");
    rmDir(dir, true); // zones and addressing of an older mesh, too
    mkDir(dir);
    const IOstreamOption format(IOstreamOption::BINARY);

    pointField points(corners(enclosing(box, ground)));
    points.append(ground);

    labelList owner(nInternal + nCell0 + nCell1 + triangles.size(), 1);
    for (label i = 0; i < nInternal + nCell0; ++i)
    {
        owner[i] = 0;
    }
    const string note(
        "nPoints:" + Foam::name(points.size()) + "  nCells:2  nFaces:"
        + Foam::name(owner.size()) + "  nInternalFaces:1"
    );
    writeList<point>(dir / "points", "vectorField", points, format);
    writeFaces(dir, triangles, format);
    writeOwner(dir, "owner", owner, note, format);
    writeOwner(dir, "neighbour", labelList(nInternal, 1), note, format);
    writeBoundary(dir, triangles.size());
    writeSystemFiles(caseDir);
}
