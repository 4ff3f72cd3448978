// SPDX-License-Identifier: GPL-3.0-or-later
// Viscous forces for any velocity, from pairs and from ground that water sticks
// to. The physics is in waterTerms.H.

#include "enginePasses.H"
#include "listLoops.H"
#include "pairTerms.H"
#include "waterTerms.H"

namespace lpfPairs
{
namespace
{

using T = packOf<double>;

//- Fields of the records after the position
enum viscousField
{
    volume = 3,
    viscosity = 4,
    velocity = 5
};

template<class Around>
LPF_ONE_BODY void viscousForceOn(const viscousPass& p, Around& around, int i)
{
    const Vec<T> u_i = around.ownVector(i, velocity);
    const T eta_i = around.own(i, viscosity), weight(p.weight);
    Vec<T> total = {};

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            addViscousForce(
                total,
                T(weight * of[volume] * around.W.gradByDistance(rSqr)),
                T(eta_i + of[viscosity]),
                x_ij,
                u_i - vectorOf(of + velocity)
            );
        }
    );
    store(total, p.force, i);
}

template<class Around>
LPF_ONE_BODY void shearMomentOf(const shearMomentPass& p, Around& around, int i)
{
    const SymmTensor<T> D = {
        T(p.D[0][i]),
        T(p.D[1][i]),
        T(p.D[2][i]),
        T(p.D[3][i]),
        T(p.D[4][i]),
        T(p.D[5][i])};
    T total(0);
    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T VF = of[volume] * around.W.gradByDistance(rSqr);
            addShearMoment(total, VF, x_ij, D);
        }
    );
    p.Q[i] = sum(total);
}

template<int layers, bool screened, class Around>
LPF_ONE_BODY void stickOfParticle(const stickPass& p, Around& around, int i)
{
    StickSums<T> total = {};
    const stickShape shape = {p.layerDepth, p.nearest};
    around.each(
        i,
        [&](const T* of, const Vec<T>& x_iq, const T& rSqr)
        {
            const Vec<T> n = vectorOf(of + normal);
            T A = onlyIf(
                (x_iq & n) > T(-p.behind) && rSqr < T(around.W.supportSqr()),
                of[area]
            );
            if constexpr (screened)
            {
                A = onlyIf(!isScreened(of + screen, x_iq), A);
            }
            addStick<layers>(total, around.W, x_iq, n, A, shape);
        }
    );

    stickRecord& out = p.sums[p.slot[i]];
    const SymmTensor<T>& F = total.force;
    const Vec<T>& g = total.gradient;
    const auto all = sums(F.xx, F.xy, F.xz, F.yy, F.yz, F.zz, g.x, g.y, g.z);
    std::copy_n(all.begin(), 6, out.force);
    std::copy_n(all.begin() + 6, 3, out.gradient);
    for (int c = 0; c < 21; ++c)
    {
        out.moment[c] = sum(total.moment[c]);
    }
}

} // namespace

void viscousForce(const viscousPass& p)
{
    const recordFields<8> fields = {
        {p.x, p.y, p.z, p.V, p.eta, p.u[0], p.u[1], p.u[2]}};
    overPairsIn<double>(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i) { viscousForceOn(p, around, i); }
    );
}

void shearMoments(const shearMomentPass& p)
{
    const recordFields<4> fields = {{p.x, p.y, p.z, p.V}};
    overPairsIn<double>(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i) { shearMomentOf(p, around, i); }
    );
}

namespace
{

template<bool screened>
void stick(const stickPass& p)
{
    constexpr int layers = 3;
    const auto fields = elementFields<screened>(p, nullptr);
    overPairsIn<double>(
        p,
        elementsOf(p),
        fields,
        [&](auto& around, int i)
        {
            if (p.slot[i] >= 0)
            {
                stickOfParticle<layers, screened>(p, around, i);
            }
        }
    );
}

} // namespace

void stickToGround(const stickPass& p)
{
    p.screens.height ? stick<true>(p) : stick<false>(p);
}

} // namespace lpfPairs
