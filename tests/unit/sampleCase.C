// SPDX-License-Identifier: GPL-3.0-or-later

#include "sampleCase.H"
#include "uniformTime.H"

#include <fstream>
#include <random>

Foam::lpf::cloudState Foam::lpf::sampleCloud(const label n)
{
    std::mt19937 bits(1);
    std::uniform_real_distribution<scalar> uniform(0, 1);
    cloudState s;
    labelField id(n);
    scalarField mass(n);
    vectorField U(n);
    symmTensorField sigma(n);
    s.positions.setSize(n);
    forAll (s.positions, i)
    {
        id[i] = n - 1 - i;
        mass[i] = uniform(bits);
        U[i] = vector(uniform(bits), -uniform(bits), 0);
        s.positions[i] = vector(uniform(bits), uniform(bits), uniform(bits));
        sigma[i] = -symmTensor(1, 2, 3, 4, 5, 6) * uniform(bits);
    }
    s.labels.insert("id", id);
    s.labels.insert("zone", labelField(n, label(1)));
    s.scalars.insert("mass", mass);
    s.vectors.insert("U", U);
    s.symmTensors.insert("sigma", sigma);
    return s;
}


void Foam::lpf::sampleGround(pointField& points, faceList& triangles)
{
    points = pointField(6);
    points[0] = point(0, 0, 0.5);
    points[1] = point(1, 0, 0);
    points[2] = point(2, 0, -0.25);
    points[3] = point(0, 1, 0.5);
    points[4] = point(1, 1, 0);
    points[5] = point(2, 1, -0.25);
    triangles = {face{0, 1, 4}, face{0, 4, 3}, face{1, 2, 5}, face{1, 5, 4}};
}


void Foam::lpf::writeSampleCase(
    const fileName& caseDir, const label n, const IOstreamOption& format
)
{
    mkDir(caseDir / "system");
    std::ofstream(caseDir / "system" / "controlDict")
        << "FoamFile { version 2.0; format ascii; class dictionary; "
           "object controlDict; }\n"
           "application lpfSolver; startFrom startTime; startTime 0;\n"
           "stopAt endTime; endTime 1; deltaT 0.01; writeControl runTime;\n"
           "writeInterval 0.5;\n";
    cloudState state = sampleCloud(n);
    for (const label half : {0, 1})
    {
        const word name(half ? "0.5" : "0");
        timeFolder folder(caseDir, name);
        writeCloud(folder.path(), "grains", state, format);
        writeUniformTime(
            folder.path(), {0.5 * half, name, 50 * half, 0.01, 0.01}
        );
        folder.commit();
        state.positions += vector(0, 0, 0.125);
    }
    pointField points;
    faceList triangles;
    sampleGround(points, triangles);
    writeDisplayMesh(
        caseDir, boundBox(point(0, 0, 0), point(1, 1, 2)), points, triangles
    );
}
