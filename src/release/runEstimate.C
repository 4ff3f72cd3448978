// SPDX-License-Identifier: GPL-3.0-or-later
#include "runEstimate.H"

#include "engineLoader.H"

#include <omp.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <vector>

namespace Foam
{
namespace lpf
{

namespace
{

// Time step over h/c, as CFL is by default
constexpr scalar courant = 0.45;

// Memory of a particle [byte]: arrays, records of the largest pass, a bit for
// each of some 480 candidates for a neighbour
// (tests/cases/benchmark/estimate compares with what the solver took)
constexpr scalar bytesPerGrain = 600 + 224 + 64;
constexpr scalar bytesPerWater = 180 + 96 + 64;

// More where both are there: porosity, drag, the neighbours of the other kind;
// the records then are the same memory
constexpr scalar bytesPerGrainInWater = 48 + 128 + 64;
constexpr scalar bytesPerWaterInGrains = 80 + 64 + 64 - 96;

// More near the ground: sums over it, and bits of its elements
constexpr scalar bytesNearGround = 350;

// A flow spreads to this share of the largest thickness it had
constexpr scalar spread = 0.1;

// Time of a whole step over that of finding the pairs and the kinematics pass
// in a bed: far from the ground, as much again near it, and more for both
// phases (tests/cases/benchmark/estimate measures it)
constexpr scalar stepInBed = 4.5, mixtureOverAlone = 1.65;

//- Grains on a lattice, in the order of their cells
struct probe
{
    static constexpr int cells = 12, perEdge = 3;
    std::vector<int> start;
    std::array<std::vector<double>, 7> in; // x y z u v w V
    std::array<std::vector<double>, 15> out;

    probe()
    {
        start.push_back(0);
        for (int c = 0; c < cells * cells * cells; ++c)
        {
            fill(c % cells, c / cells % cells, c / (cells * cells));
            start.push_back(int(in[0].size()));
        }
        for (auto& a : in)
        {
            a.resize(a.size() + lpfPairs::padding, 0.0);
        }
        for (auto& a : out)
        {
            a.resize(in[0].size());
        }
    }

    // 18 points a cell of edge 2h = 2.6 dx, as in a bed
    void fill(int x, int y, int z)
    {
        for (int k = 0; k < perEdge * perEdge * (perEdge - 1); ++k)
        {
            const int layer = k / (perEdge * perEdge);
            const double at[7] = {
                x + (k % perEdge + 0.5) / perEdge,
                y + (k / perEdge % perEdge + 0.5) / perEdge,
                z + (layer + 0.5) / (perEdge - 1),
                0.01 * y,
                0.01 * z,
                0.01 * x,
                1.0 / (perEdge * perEdge * (perEdge - 1))};
            for (std::size_t c = 0; c < 7; ++c)
            {
                in[c].push_back(at[c]);
            }
        }
    }

    lpfPairs::kinematicsPass pass()
    {
        lpfPairs::kinematicsPass p = {};
        p.cells = {
            {1, 1, 1},
            {0, 0, 0},
            {0, 0, 0},
            {0, 0, 0},
            {cells, cells, cells},
            start.data()};
        p.h = 0.5;
        p.dimensions = 3;
        const double** arrays[7] = {&p.x, &p.y, &p.z, &p.u, &p.v, &p.w, &p.V};
        for (std::size_t c = 0; c < 7; ++c)
        {
            *arrays[c] = in[c].data();
        }
        for (std::size_t c = 0; c < 9; ++c)
        {
            p.R[c] = out[c].data();
        }
        for (std::size_t c = 0; c < 6; ++c)
        {
            p.M[c] = out[9 + c].data();
        }
        return p;
    }
};

} // namespace


scalar
memoryOf(const scalar grains, const scalar water, const scalar nearGround)
{
    const scalar alone = grains * bytesPerGrain + water * bytesPerWater
                       + (grains + water) * nearGround * bytesNearGround;
    return grains > 0 && water > 0 ? alone + grains * bytesPerGrainInWater
                                         + water * bytesPerWaterInGrains
                                   : alone;
}


scalar machineMemory()
{
    const scalar pages = scalar(sysconf(_SC_PHYS_PAGES));
    const scalar size = scalar(sysconf(_SC_PAGESIZE));
    return pages > 0 && size > 0 ? pages * size : GREAT;
}


runEstimate estimateRun(const runSize& size)
{
    runEstimate run;
    run.timeStep = courant * size.smoothingLength / size.waveSpeed;
    run.steps = size.endTime / run.timeStep;
    const scalar nearGround =
        min(scalar(1),
            2 * size.smoothingLength / max(spread * size.releaseHeight, VSMALL)
        );
    run.memory = memoryOf(size.grains, size.water, nearGround);
    run.stepOverPass =
        stepInBed * (1 + nearGround)
        * (size.grains > 0 && size.water > 0 ? mixtureOverAlone : 1);
    return run;
}

solverSpeed measureSolver(const scalar stepOverPass)
{
    using clock = std::chrono::steady_clock;
    constexpr int repeats = 5;
    const lpfPairs::pairEngine& engine = lpfPairs::loadPairEngine("auto");
    probe sample;
    const lpfPairs::kinematicsPass pass = sample.pass();

    double best = GREAT;
    for (int k = 0; k < repeats; ++k)
    {
        const auto began = clock::now();
        engine.kinematics(pass);
        const std::chrono::duration<double> t = clock::now() - began;
        best = std::min(best, t.count());
    }
    return {
        scalar(sample.start.back()) / (best * stepOverPass),
        label(omp_get_max_threads())};
}

} // namespace lpf
} // namespace Foam
