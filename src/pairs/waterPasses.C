// SPDX-License-Identifier: GPL-3.0-or-later
// Passes over pairs of water. The physics is in waterTerms.H.

#include "enginePasses.H"
#include "pairLoops.H"
#include "pairTerms.H"
#include "waterTerms.H"
#include "wendlandC2.H"

namespace lpfPairs
{
namespace
{

//- By value, as store()
inline void
storeFilling(const waterContinuityPass& p, Filling<pack> filling, int i)
{
    p.fill[i] = sum(filling.fill);
    for (int c = 0; c < 3; ++c)
    {
        p.gradFill[c][i] = sum(filling.gradient, c);
    }
}

template<bool withFill, bool withStrain>
LPF_ONE_BODY void continuityOfParticle(
    const waterContinuityPass& p, const wendlandC2& W, const runs& around, int i
)
{
    const Vec<pack> v_i = broadcast(p.u, p.v, p.w, i);
    const pack rho_i(p.rho[i]), rho0(p.rho0);
    const double* H = p.hydrostatic;
    const Vec<pack> hydrostatic = {pack(H[0]), pack(H[1]), pack(H[2])};
    Continuity<pack> total = {};
    Filling<pack> filling = {};
    SymmTensor<pack> strain = {};
    [[maybe_unused]] Vec<pack> U_i = {};
    if constexpr (withStrain)
    {
        U_i = broadcast(p.U[0], p.U[1], p.U[2], i);
    }

    overNeighbours(
        p,
        W,
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            const pack VF =
                pack(p.scale) * load(p.V + j) * W.gradByDistance(rSqr);
            if constexpr (withFill)
            {
                addFilling(
                    filling, pack(load(p.V + j) * W.value(rSqr)), VF, x_ij
                );
            }
            addVelocityGradient(
                total, VF, x_ij, v_i - loadVec(p.u, p.v, p.w, j)
            );
            if constexpr (withStrain)
            {
                addStrain(
                    strain, VF, x_ij, U_i - loadVec(p.U[0], p.U[1], p.U[2], j)
                );
            }
            // (x_j - x_i).gradW/r^2 = -F
            total.diffusion += densityDiffusion(
                VF, x_ij, rho_i, load(p.rho + j), rho0, hydrostatic
            );
        }
    );

    p.divergence[i] = sum(total.divergence);
    const Vec<double> curl = {
        sum(total.curl, 0), sum(total.curl, 1), sum(total.curl, 2)};
    p.curl[i] = squareRoot(magSqr(curl));
    p.diffusion[i] = sum(total.diffusion);
    if constexpr (withFill)
    {
        storeFilling(p, filling, i);
    }
    if constexpr (withStrain)
    {
        store({strain.xx, strain.xy, strain.xz}, p.strain, i);
        store({strain.yy, strain.yz, strain.zz}, p.strain + 3, i);
    }
}

template<bool withFill, bool withStrain>
void continuity(const waterContinuityPass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.cells,
        [&](const runs& around, int i)
        { continuityOfParticle<withFill, withStrain>(p, W, around, i); }
    );
}

enum class friction
{
    none,
    artificial, //!< Monaghan's with Balsara's switch
    viscous,    //!< eta
    both
};

constexpr bool hasArtificial(friction kind)
{
    return kind == friction::artificial || kind == friction::both;
}

constexpr bool hasViscous(friction kind)
{
    return kind == friction::viscous || kind == friction::both;
}

//- Powers lost at i per unit volume and mass
struct lostPower
{
    pack artificial = pack(0.0), viscous = pack(0.0);
};

//- What both kinds of friction need of a pair
struct pairOfWater
{
    int i, j;
    Vec<pack> x, v; //!< differences
    pack rSqr, F;
};

void addArtificial(
    const waterForcePass& p,
    const pairOfWater& ij,
    Vec<pack>& perMass,
    lostPower& lost
)
{
    const pack half(0.5);
    const pack rhoMean = half * (pack(p.rho[ij.i]) + load(p.rho + ij.j));
    const pack f = half * (pack(p.balsara[ij.i]) + load(p.balsara + ij.j));
    const pack Pi = artificialViscosity(
        ij.x,
        ij.v,
        ij.rSqr,
        f * pack(p.alpha * p.h * p.soundSpeed),
        pack(p.h * p.h),
        rhoMean
    );
    const pack mPiF = load(p.m + ij.j) * Pi * ij.F / pack(p.thickness);
    perMass += -mPiF * ij.x;
    lost.artificial += half * mPiF * (ij.v & ij.x);
}

void addViscous(
    const waterForcePass& p,
    const pairOfWater& ij,
    Vec<pack>& perVolume,
    lostPower& lost
)
{
    const pack factor = viscousFactor(
        pack(load(p.V + ij.j) * ij.F),
        pack(pack(p.eta[ij.i]) + load(p.eta + ij.j)),
        pack(p.dimensions + 2.0),
        ij.x,
        ij.v,
        ij.rSqr,
        pack(p.h * p.h)
    );
    perVolume += factor * ij.x;
    lost.viscous += pack(-0.5) * factor * (ij.v & ij.x);
}

template<friction kind>
LPF_ONE_BODY void forceOnWater(
    const waterForcePass& p, const wendlandC2& W, const runs& around, int i
)
{
    const pack P_i(p.P[i]);
    const Vec<pack> v_i = broadcast(p.u, p.v, p.w, i);
    Vec<pack> total = {}, perMass = {}, perVolume = {};
    lostPower lost;

    overNeighbours(
        p,
        W,
        around,
        i,
        [&](int j, const Vec<pack>& x_ij, const pack& rSqr)
        {
            const pack VF =
                pack(p.scale) * load(p.V + j) * W.gradByDistance(rSqr);
            addPressureForce(total, VF, P_i, load(p.P + j), x_ij);
            if constexpr (kind != friction::none)
            {
                const pairOfWater ij = {
                    i,
                    j,
                    x_ij,
                    v_i - loadVec(p.u, p.v, p.w, j),
                    rSqr,
                    W.gradByDistance(rSqr)};
                if constexpr (hasArtificial(kind))
                {
                    addArtificial(p, ij, perMass, lost);
                }
                if constexpr (hasViscous(kind))
                {
                    addViscous(p, ij, perVolume, lost);
                }
            }
        }
    );

    const double volume = p.thickness * p.V[i], s = volume / p.m[i];
    double* const a[3] = {p.ax + i, p.ay + i, p.az + i};
    for (int c = 0; c < 3; ++c)
    {
        *a[c] = s * sum(total, c);
    }
    if constexpr (kind != friction::none)
    {
        double* const b[3] = {p.bx + i, p.by + i, p.bz + i};
        for (int c = 0; c < 3; ++c)
        {
            *b[c] = s * sum(perVolume, c) + sum(perMass, c);
        }
        p.artificial[i] = p.m[i] * sum(lost.artificial);
        p.viscous[i] = volume * sum(lost.viscous);
    }
}

template<friction kind>
void force(const waterForcePass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.cells,
        p.cells,
        [&](const runs& around, int i) { forceOnWater<kind>(p, W, around, i); }
    );
}

} // namespace

void waterContinuity(const waterContinuityPass& p)
{
    if (p.strain[0])
    {
        p.fill ? continuity<true, true>(p) : continuity<false, true>(p);
    }
    else
    {
        p.fill ? continuity<true, false>(p) : continuity<false, false>(p);
    }
}

void waterForce(const waterForcePass& p)
{
    if (p.alpha > 0)
    {
        p.eta ? force<friction::both>(p) : force<friction::artificial>(p);
    }
    else
    {
        p.eta ? force<friction::viscous>(p) : force<friction::none>(p);
    }
}

} // namespace lpfPairs
