// SPDX-License-Identifier: GPL-3.0-or-later
/*
Application  terrainToParticles
Description  Makes a case that lpfSolver starts from: ground, particles with
             exact masses, initial stress and pressure, mesh for display. Says
             before the run what it will take. Writes everything or nothing.
Usage        terrainToParticles [-case <dir>] [-dict <file>]
             Reads  system/terrainToParticlesDict, constant/g,
                    constant/phaseProperties, constant/boundaryProperties
             Writes constant/terrain, constant/polyMesh,
                    constant/releaseProperties, 0/lagrangian/<phase>
             Manual etc/caseDicts/annotated/terrainToParticlesDict
*/
#include "argList.H"
#include "caseLock.H"
#include "exitStatus.H"
#include "scenePreparation.H"

using namespace Foam;

int main(int argc, char* argv[])
{
    argList::addNote("Ground, particles and initial state of a case");
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption(
        "dict", "file", "Read another file than system/terrainToParticlesDict"
    );
    const argList args(argc, argv);
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }
    const fileName caseDir = args.path();
    fileName dict = args.getOrDefault<fileName>(
        "dict", caseDir / "system" / "terrainToParticlesDict"
    );
    if (!dict.isAbsolute())
    {
        dict = cwd() / dict;
    }
    return lpf::exitStatus(
        [&]
        {
            const lpf::caseLock lock(caseDir);
            const lpf::scenePreparation scene(caseDir, dict);
            scene.report();
            scene.write();
            Info << "End" << nl << endl;
            return 0;
        }
    );
}
