// SPDX-License-Identifier: GPL-3.0-or-later
// Loops, lanes and threads of the pair sums. The physics is in pairTerms.H.
// Built once an instruction set, each time a library of its own.

#include "pairEngine.H"
#include "enginePasses.H"
#include "pairLoops.H"
#include "pairTerms.H"
#include "wendlandC2.H"

#include <chrono>

#ifndef LPF_ISA
#error "LPF_ISA names the instruction set of this build"
#endif

namespace lpfPairs
{
namespace
{

//- Lanes outside the support have x_ij up to two cells, inside a masked one
//  anything: F = 0 there removes both, as long as x_ij is finite
LPF_ONE_BODY void kinematicsOfParticle(
    const kinematicsPass& p, const wendlandC2& W, const runs& around, int i
)
{
    const Vec<pack> v_i = broadcast(p.u, p.v, p.w, i);
    Kinematics<pack> total = {};

    overNeighbours(
        p,
        W,
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            addKinematics(
                total,
                pack(load(p.V + j) * W.gradByDistance(rSqr)),
                x_ij,
                v_i - loadVec(p.u, p.v, p.w, j)
            );
        }
    );

    store(total.R.x, p.R, i);
    store(total.R.y, p.R + 3, i);
    store(total.R.z, p.R + 6, i);
    store({total.M.xx, total.M.xy, total.M.xz}, p.M, i);
    store({total.M.yy, total.M.yz, total.M.zz}, p.M + 3, i);
}

void kinematics(const kinematicsPass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.cells,
        [&](const runs& around, int i)
        { kinematicsOfParticle(p, W, around, i); }
    );
}

//- What acts between particles besides the stress
enum class viscosity
{
    none,
    artificial, //!< Monaghan's
    noise       //!< noise damping, with Monaghan's where alpha > 0
};

//- Adds the viscous terms of one pack; power is what they take [W/kg]
template<viscosity kind>
void addViscosity(
    const forcePass& p,
    const wendlandC2& W,
    int i,
    int j,
    const Vec<pack>& x_ij,
    const pack& rSqr,
    Vec<pack>& a,
    pack& power
)
{
    const Vec<pack> v_ij =
        broadcast(p.u, p.v, p.w, i) - loadVec(p.u, p.v, p.w, j);
    const pack rhoMean = pack(0.5) * (pack(p.rho[i]) + load(p.rho + j));
    const pack hC(p.h * p.soundSpeed), hSqr(p.h * p.h);

    pack Pi = artificialViscosity(
        x_ij, v_ij, rSqr, pack(p.alpha) * hC, hSqr, rhoMean
    );
    if constexpr (kind == viscosity::noise)
    {
        const Tensor<pack> L_j = loadTensor(p.L, j);
        const Tensor<pack> L_i = {
            broadcast(p.L[0], p.L[1], p.L[2], i),
            broadcast(p.L[3], p.L[4], p.L[5], i),
            broadcast(p.L[6], p.L[7], p.L[8], i)};
        const Vec<pack> w_ij = v_ij - pack(0.5) * ((L_i + L_j) & x_ij);
        Pi += noiseDamping(x_ij, w_ij, rSqr, pack(p.beta) * hC, hSqr, rhoMean);
    }
    const pack mPiF =
        load(p.m + j) * Pi * W.gradByDistance(rSqr) / pack(p.thickness);

    a += Vec<pack>{-mPiF * x_ij.x, -mPiF * x_ij.y, -mPiF * x_ij.z};
    power += pack(0.5) * mPiF * (v_ij & x_ij);
}

template<viscosity kind>
LPF_ONE_BODY void forceOnParticle(
    const forcePass& p, const wendlandC2& W, const runs& around, int i
)
{
    Force<pack> total = {};
    Vec<pack> a = {};
    pack power(0.0);

    overNeighbours(
        p,
        W,
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            addForce(
                total,
                pack(load(p.V + j) * W.gradByDistance(rSqr)),
                x_ij,
                loadTensor(p.A, j)
            );
            if constexpr (kind != viscosity::none)
            {
                addViscosity<kind>(p, W, i, j, x_ij, rSqr, a, power);
            }
        }
    );

    const Vec<double> g = {
        sum(total.gradV, 0), sum(total.gradV, 1), sum(total.gradV, 2)};
    const double s = p.thickness * p.V[i] / p.m[i];
    double* out[3] = {p.ax + i, p.ay + i, p.az + i};
    for (int c = 0; c < 3; ++c)
    {
        const Vec<double> row = {
            p.A[3 * c][i], p.A[3 * c + 1][i], p.A[3 * c + 2][i]};
        *out[c] = s * ((row & g) + sum(total.other, c));
        if constexpr (kind != viscosity::none)
        {
            *out[c] += sum(a, c);
        }
    }
    if constexpr (kind != viscosity::none)
    {
        p.viscousPower[i] = p.m[i] * lpfPairs::sum(power);
    }
}

template<viscosity kind>
void force(const forcePass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.cells,
        [&](const runs& around, int i)
        { forceOnParticle<kind>(p, W, around, i); }
    );
}

void anyForce(const forcePass& p)
{
    if (p.beta > 0)
    {
        force<viscosity::noise>(p);
    }
    else if (p.alpha > 0)
    {
        force<viscosity::artificial>(p);
    }
    else
    {
        force<viscosity::none>(p);
    }
}

//- Nearest element so far in each lane
struct nearestLanes
{
    pack rSqr = pack(farAway), distance = pack(farAway);
    Vec<pack> normal = {};

    void
    see(const pack& r2, const pack& d, const Vec<pack>& n, double outOfSight)
    {
        const packMask nearer = r2 < rSqr && d > pack(-outOfSight);
        stdx::where(nearer, rSqr) = r2;
        stdx::where(nearer, distance) = d;
        stdx::where(nearer, normal.x) = n.x;
        stdx::where(nearer, normal.y) = n.y;
        stdx::where(nearer, normal.z) = n.z;
    }

    void store(wallRecord& to) const
    {
        to.nearestSqr = farAway;
        to.distance = farAway;
        to.normal[0] = to.normal[1] = to.normal[2] = 0;
        for (std::size_t k = 0; k < pack::size(); ++k)
        {
            if (rSqr[k] < to.nearestSqr)
            {
                to.nearestSqr = rSqr[k];
                to.distance = distance[k];
                to.normal[0] = normal.x[k];
                to.normal[1] = normal.y[k];
                to.normal[2] = normal.z[k];
            }
        }
    }
};

void store(const WallSums<pack>& from, wallRecord& to)
{
    const SymmTensor3<pack> N = from.N3;
    const pack N3[10] = {
        N.xxx, N.xxy, N.xxz, N.xyy, N.xyz, N.xzz, N.yyy, N.yyz, N.yzz, N.zzz};
    for (int c = 0; c < 10; ++c)
    {
        to.N3[c] = lpfPairs::sum(N3[c]);
    }
    const SymmTensor<pack> D = from.D2;
    const pack D2[6] = {D.xx, D.xy, D.xz, D.yy, D.yz, D.zz};
    for (int c = 0; c < 6; ++c)
    {
        to.D2[c] = lpfPairs::sum(D2[c]);
    }
    to.area = lpfPairs::sum(from.area);
    to.friction = lpfPairs::sum(from.friction);
    to.share = lpfPairs::sum(from.share);
}

//- What is asked of the ground
enum class wallSums
{
    plain,
    withShare2, //!< and the share of the kernel inside it, in two dimensions
    withShare3  //!< in three
};

template<wallSums kind, int layers>
LPF_ONE_BODY void wallOfParticle(
    const wallPass& p, const wendlandC2& W, const runs& around, int i
)
{
    WallSums<pack> total = {};
    nearestLanes nearest;

    overPairs(
        around,
        broadcast(p.x, p.y, p.z, i),
        p.ex,
        p.ey,
        p.ez,
        W.supportSqr(),
        [&](int q, const Vec<pack>& x_iq, const pack& rSqr)
        {
            const Vec<pack> n = loadVec(p.nx, p.ny, p.nz, q);
            const pack d = x_iq & n;
            pack A = load(p.area + q);
            stdx::where(!(d > pack(-p.behind)), A) = 0;
            const LayerSums<pack> s =
                layerSums<layers>(W, rSqr, d, p.layerDepth);

            addWall(
                total, LayerSums<pack>{A * s.E, A * s.D}, n, load(p.mu + q)
            );
            if constexpr (kind != wallSums::plain)
            {
                constexpr int D = kind == wallSums::withShare3 ? 3 : 2;
                total.share += solidShare<D>(W, rSqr, d, A);
            }
            nearest.see(rSqr, d, n, p.outOfSight);
        }
    );

    wallRecord& out = p.sums[p.slot[i]];
    store(total, out);
    nearest.store(out);
}

template<wallSums kind, int layers>
void wallInLayers(const wallPass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.elements,
        [&](const runs& around, int i)
        {
            if (around.count > 0)
            {
                wallOfParticle<kind, layers>(p, W, around, i);
            }
        }
    );
}

//- Layers that a particle can see over the ground that it may come near to
template<wallSums kind>
void wall(const wallPass& p)
{
    constexpr double rounding = 1 + 1e-9;
    const bool two = rounding * (2.5 * p.layerDepth + p.behind) >= 2 * p.h;
    two ? wallInLayers<kind, 2>(p) : wallInLayers<kind, 3>(p);
}

void anyWall(const wallPass& p)
{
    if (!p.withShare)
    {
        wall<wallSums::plain>(p);
    }
    else if (p.dimensions == 3)
    {
        wall<wallSums::withShare3>(p);
    }
    else
    {
        wall<wallSums::withShare2>(p);
    }
}

int wallSlots(const cellGrid& cells, const cellGrid& elements, int* slot)
{
    // first mark in parallel, then number in the order of the particles
    forCells(
        cells,
        [&](int begin, int end, long cx, long cy, long cz)
        {
            const int near = runsAround(elements, cx, cy, cz).count;
            for (int i = begin; i < end; ++i)
            {
                slot[i] = near > 0 ? 0 : -1;
            }
        }
    );

    const int n =
        cells.start[static_cast<long>(cells.n[0]) * cells.n[1] * cells.n[2]];
    int count = 0;
    for (int i = 0; i < n; ++i)
    {
        if (slot[i] == 0)
        {
            slot[i] = count++;
        }
    }
    return count;
}

//- Independent multiply-adds in registers
double peak()
{
    constexpr int chains = 12, repeats = 4000000;
    pack a[chains];
    for (int k = 0; k < chains; ++k)
    {
        a[k] = pack(1.0 + k);
    }
    const pack b(0.999999), c(1e-6);
    const auto begin = std::chrono::steady_clock::now();
    for (int r = 0; r < repeats; ++r)
    {
        for (int k = 0; k < chains; ++k)
        {
            a[k] = a[k] * b + c;
        }
    }
    const std::chrono::duration<double> t =
        std::chrono::steady_clock::now() - begin;
    double used = 0;
    for (int k = 0; k < chains; ++k)
    {
        used += lpfPairs::sum(a[k]);
    }
    const double count = 1.0 * chains * repeats * nLanes;
    return used > 0 ? count / t.count() : 0;
}

const pairEngine engine = {
    LPF_ISA,
    nLanes,
    kinematics,
    anyForce,
    anyWall,
    waterContinuity,
    waterForce,
    viscousForce,
    stickToGround,
    smoothed,
    wallSlots,
    peak};

} // namespace
} // namespace lpfPairs

extern "C" __attribute__((visibility("default"))) const lpfPairs::pairEngine*
lpfPairEngine()
{
    return &lpfPairs::engine;
}
