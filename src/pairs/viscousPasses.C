// SPDX-License-Identifier: GPL-3.0-or-later
// Viscous forces for any velocity, from pairs and from ground that water sticks
// to. The physics is in waterTerms.H.

#include "enginePasses.H"
#include "pairLoops.H"
#include "waterTerms.H"
#include "wendlandC2.H"

namespace lpfPairs
{
namespace
{

LPF_ONE_BODY void viscousForceOn(
    const viscousPass& p, const wendlandC2& W, const runs& around, int i
)
{
    const Vec<pack> u_i = broadcast(p.u[0], p.u[1], p.u[2], i);
    const pack eta_i(p.eta[i]), weight(p.weight);
    Vec<pack> total = {};

    overNeighbours(
        p,
        W,
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            addViscousForce(
                total,
                pack(weight * load(p.V + j) * W.gradByDistance(rSqr)),
                pack(eta_i + load(p.eta + j)),
                x_ij,
                u_i - loadVec(p.u[0], p.u[1], p.u[2], j)
            );
        }
    );
    store(total, p.force, i);
}

template<int layers>
LPF_ONE_BODY void stickOfParticle(
    const stickPass& p, const wendlandC2& W, const runs& around, int i
)
{
    StickSums<pack> total = {};
    const stickShape shape = {p.layerDepth, p.nearest};
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
            pack A = load(p.area + q);
            // lanes past the end of a run are marked by a distance
            stdx::where(
                !((x_iq & n) > pack(-p.behind) && rSqr < pack(W.supportSqr())),
                A
            ) = 0;
            addStick<layers>(total, W, x_iq, n, A, shape);
        }
    );

    stickRecord& out = p.sums[p.slot[i]];
    const SymmTensor<pack> T = total.force;
    const pack force[6] = {T.xx, T.xy, T.xz, T.yy, T.yz, T.zz};
    for (int c = 0; c < 6; ++c)
    {
        out.force[c] = sum(force[c]);
    }
    for (int c = 0; c < 3; ++c)
    {
        out.gradient[c] = sum(total.gradient, c);
    }
}

} // namespace

void viscousForce(const viscousPass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.cells,
        [&](const runs& around, int i) { viscousForceOn(p, W, around, i); }
    );
}

void stickToGround(const stickPass& p)
{
    constexpr int layers = 3;
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.elements,
        [&](const runs& around, int i)
        {
            if (around.count > 0)
            {
                stickOfParticle<layers>(p, W, around, i);
            }
        }
    );
}

} // namespace lpfPairs
