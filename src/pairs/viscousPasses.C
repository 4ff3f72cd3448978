// SPDX-License-Identifier: GPL-3.0-or-later
// Viscous forces for any velocity, from pairs and from ground that water sticks
// to. The physics is in waterTerms.H.

#include "enginePasses.H"
#include "listLoops.H"
#include "waterTerms.H"
#include "wendlandC2.H"

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

LPF_ONE_BODY void viscousForceOn(
    const viscousPass& p,
    const wendlandC2& W,
    const neighbourTable& pairs,
    const places<double>& where,
    const double* records,
    int i
)
{
    const Vec<T> u_i = own<double>(p.u[0], p.u[1], p.u[2], i);
    const T eta_i(p.eta[i]), weight(p.weight);
    Vec<T> total = {};

    overList<double, 8>(
        pairs,
        where,
        records,
        i,
        {p.x[i], p.y[i], p.z[i]},
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            addViscousForce(
                total,
                T(weight * of[volume] * W.gradByDistance(rSqr)),
                T(eta_i + of[viscosity]),
                x_ij,
                u_i - vectorOf(of + velocity)
            );
        }
    );
    store(total, p.force, i);
}

//- Fields of the records of elements
enum elementField
{
    normal = 3,
    area = 6
};

template<int layers>
LPF_ONE_BODY void stickOfParticle(
    const stickPass& p,
    const wendlandC2& W,
    const neighbourTable& elements,
    const places<double>& where,
    const double* records,
    int i
)
{
    StickSums<T> total = {};
    const stickShape shape = {p.layerDepth, p.nearest};
    overList<double, 8>(
        elements,
        where,
        records,
        i,
        {p.x[i], p.y[i], p.z[i]},
        [&](const T* of, const Vec<T>& x_iq, const T& rSqr)
        {
            const Vec<T> n = vectorOf(of + normal);
            const T A = onlyIf(
                (x_iq & n) > T(-p.behind) && rSqr < T(W.supportSqr()), of[area]
            );
            addStick<layers>(total, W, x_iq, n, A, shape);
        }
    );

    stickRecord& out = p.sums[p.slot[i]];
    const SymmTensor<T> F = total.force;
    const T force[6] = {F.xx, F.xy, F.xz, F.yy, F.yz, F.zz};
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
    const places<double> where(p.h);
    const pairsOf pairs(p, searchOf(p));
    const double* const fields[8] = {
        p.x, p.y, p.z, p.V, p.eta, p.u[0], p.u[1], p.u[2]};
    const double* records = makeRecords(*pairs, where, fields);

    forListed(
        *pairs, [&](int i) { viscousForceOn(p, W, *pairs, where, records, i); }
    );
}

void stickToGround(const stickPass& p)
{
    constexpr int layers = 3;
    const wendlandC2 W(p.h, p.dimensions);
    const places<double> where(p.h);
    const pairsOf near(
        p, {p.cells, p.elements, p.h, p.x, p.y, p.z, p.ex, p.ey, p.ez}
    );
    const double* const fields[8] = {
        p.ex, p.ey, p.ez, p.nx, p.ny, p.nz, p.area, nullptr};
    const double* records = makeRecords(*near, where, fields);
    (*near).recordsVersion = 0; // those of the pass before are gone

    forListed(
        *near,
        [&](int i)
        {
            if (p.slot[i] >= 0)
            {
                stickOfParticle<layers>(p, W, *near, where, records, i);
            }
        }
    );
}

} // namespace lpfPairs
