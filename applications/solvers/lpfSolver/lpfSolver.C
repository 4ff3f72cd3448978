// SPDX-License-Identifier: GPL-3.0-or-later
/*
Application  lpfSolver
Description  Moves the particles of a case over its ground.
Usage        lpfSolver [-case <dir>] [-threads <N>]
             Reads  system/controlDict, system/lpfSolution, constant/g,
                    constant/phaseProperties, constant/boundaryProperties,
                    what terrainToParticles wrote, and the start time
             Writes <time>/lagrangian, <time>/uniform,
                    postProcessing/lpfSolver/<startTime>
             SIGTERM, SIGUSR1, SIGUSR2 and `stopAt writeNow` write and end.
             Status 0: done; 1: refused input, or mass that does not close.
*/
#include "argList.H"
#include "caseLock.H"
#include "caseRun.H"
#include "exitStatus.H"

#include <cstdlib>
#include <omp.h>

using namespace Foam;

int main(int argc, char* argv[])
{
    for (int k = 1; k < argc; ++k)
    {
        if (std::string(argv[k]) == "-parallel")
        {
            FatalErrorIn("lpfSolver")
                << "-parallel: this version runs on the threads of one "
                << "machine and does not decompose the domain. "
                << "Use -threads N" << exit(FatalError);
        }
    }

    argList::addNote("Moves the particles of a case over its ground");
    argList::noParallel();
    argList::noFunctionObjects();
    argList::addOption(
        "threads", "N", "Number of threads (default: all cores)"
    );
    const argList args(argc, argv);
    if (!args.checkRootCase())
    {
        FatalError.exit();
    }
    if (args.found("threads"))
    {
        label threads = 0;
        if (!readLabel(args["threads"], threads) || threads < 1
            || threads > 1024)
        {
            FatalErrorInFunction << "-threads " << args["threads"].c_str()
                                 << ": write 1 to the number of cores, here "
                                 << omp_get_num_procs() << exit(FatalError);
        }
        omp_set_num_threads(threads);
    }

    const int status = lpf::exitStatus(
        [&]
        {
            const lpf::caseLock lock(args.path());
            lpf::caseRun run(args.path());
            while (run.running())
            {
                run.step();
            }
            return run.finish();
        }
    );
    if (status)
    {
        // the destructor of args ends the program with status 0
        std::exit(status);
    }
    return 0;
}
