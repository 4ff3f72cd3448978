// SPDX-License-Identifier: GPL-3.0-or-later
// Passes over pairs of a grain and water. The physics is in couplingTerms.H.

#include "couplingTerms.H"
#include "enginePasses.H"
#include "pairLoops.H"
#include "wendlandC2.H"

namespace lpfPairs
{
namespace
{

//- term(j, x_ij, rSqr) for the others around home particle i
template<class Term>
inline void overOthers(
    const crossPass& p,
    double supportSqr,
    const runs& around,
    int i,
    const Term& term
)
{
    overPairs(
        around, broadcast(p.x, p.y, p.z, i), p.X, p.Y, p.Z, supportSqr, term
    );
}

template<int n>
LPF_ONE_BODY void smoothAtParticle(
    const smoothPass& p, const wendlandC2& W, const runs& around, int i
)
{
    pack total[n] = {};
    overOthers(
        p,
        W.supportSqr(),
        around,
        i,
        [&](int j, const Vec<pack>&, const pack& rSqr)
        {
            const pack w = W.value(rSqr);
            for (int c = 0; c < n; ++c)
            {
                total[c] += load(p.q[c] + j) * w;
            }
        }
    );
    for (int c = 0; c < n; ++c)
    {
        p.out[c][i] = sum(total[c]);
    }
}

LPF_ONE_BODY void momentsOfGrain(
    const waterMomentsPass& p, const wendlandC2& W, const runs& around, int i
)
{
    const Vec<pack> v_i = broadcast(p.u, p.v, p.w, i);
    WaterMoments<pack> total = {};
    overOthers(
        p,
        W.supportSqr(),
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            const pack V = load(p.volume + j);
            addWaterMoments(
                total,
                pack(V * W.value(rSqr)),
                pack(V * W.gradByDistance(rSqr)),
                x_ij,
                v_i - loadVec(p.U, p.V, p.W, j)
            );
        }
    );
    p.share[i] = sum(total.share);
    store(total.offset, p.offset, i);
    store(total.gradient, p.gradient, i);
    store({total.N.xx, total.N.xy, total.N.xz}, p.N, i);
    store({total.N.yy, total.N.yz, total.N.zz}, p.N + 3, i);
    store(total.slip.x, p.slip, i);
    store(total.slip.y, p.slip + 3, i);
    store(total.slip.z, p.slip + 6, i);
}

LPF_ONE_BODY void divergenceOfWater(
    const grainDivergencePass& p, const wendlandC2& W, const runs& around, int i
)
{
    const Vec<pack> v_i = broadcast(p.u, p.v, p.w, i);
    pack total(0.0);
    overOthers(
        p,
        W.supportSqr(),
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            total += grainDivergence(
                W.value(rSqr),
                W.gradByDistance(rSqr),
                x_ij,
                v_i - loadVec(p.U, p.V, p.W, j),
                loadTensor(p.VsC, j),
                load(p.VsQ + j)
            );
        }
    );
    p.divergence[i] = sum(total);
}

LPF_ONE_BODY void pressureOnGrain(
    const waterPressurePass& p, const wendlandC2& W, const runs& around, int i
)
{
    pack total(0.0);
    Vec<pack> grad = {};
    overOthers(
        p,
        W.supportSqr(),
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            const pack VP = load(p.VP + j);
            total += VP * W.value(rSqr);
            grad += pack(VP * W.gradByDistance(rSqr)) * x_ij;
        }
    );
    p.sum[i] = sum(total);
    store(grad, p.grad, i);
}

LPF_ONE_BODY void reactionOnWater(
    const grainReactionPass& p, const wendlandC2& W, const runs& around, int i
)
{
    const pack P_i(p.P[i]);
    Vec<pack> total = {};
    overOthers(
        p,
        W.supportSqr(),
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            addGrainReaction(
                total,
                W.gradByDistance(rSqr),
                x_ij,
                P_i,
                load(p.Pk + j),
                loadTensor(p.VsC, j)
            );
        }
    );
    store(total, p.force, i);
}

template<class Pass, class Task>
void forHome(const Pass& p, const Task& task)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.home,
        p.others,
        [&](const runs& around, int i) { task(p, W, around, i); }
    );
}

} // namespace

void smoothed(const smoothPass& p)
{
    switch (p.count)
    {
    case 2:
        forHome(p, smoothAtParticle<2>);
        break;
    case 3:
        forHome(p, smoothAtParticle<3>);
        break;
    default:
        forHome(p, smoothAtParticle<7>);
    }
}

void waterMoments(const waterMomentsPass& p)
{
    forHome(p, momentsOfGrain);
}

void grainDivergences(const grainDivergencePass& p)
{
    forHome(p, divergenceOfWater);
}

void waterPressureOnGrains(const waterPressurePass& p)
{
    forHome(p, pressureOnGrain);
}

void grainReactions(const grainReactionPass& p)
{
    forHome(p, reactionOnWater);
}

} // namespace lpfPairs
