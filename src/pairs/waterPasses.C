// SPDX-License-Identifier: GPL-3.0-or-later
// Passes over pairs of water. The physics is in waterTerms.H.

#include "enginePasses.H"
#include "listLoops.H"
#include "pairTerms.H"
#include "waterTerms.H"

namespace lpfPairs
{
namespace
{

//- Fields of the records of water
enum waterField
{
    volume = 3,
    velocity = 4,
    density = 7,
    pressure = 8,
    mass = 9,
    balsara = 10,
    viscousEta = 11
};

//- Length of the records of the continuity pass, in whole packs: where strain
//  is asked for the velocity of the water follows
constexpr int continuityFields(bool withStrain)
{
    return withStrain ? 12 : 8;
}
constexpr int ownVelocity = 8;

template<class T>
LPF_INLINE auto sumsOf(const Continuity<T>& total, const Filling<T>& filling)
{
    const Vec<T>&curl = total.curl, &gradient = filling.gradient;
    return sums(
        total.divergence,
        total.diffusion,
        curl.x,
        curl.y,
        curl.z,
        filling.fill,
        gradient.x,
        gradient.y,
        gradient.z
    );
}

template<bool withFill, bool withStrain, class Around>
LPF_ONE_BODY void
continuityOfParticle(const waterContinuityPass& p, Around& around, int i)
{
    using Real = typename Around::Real;
    using T = typename Around::T;
    const Vec<T> v_i = around.ownVector(i, velocity);
    // differences of density from what both are near to
    const T rho_i = around.own(i, density), rho0(Real(0));
    const double* H = p.hydrostatic;
    const Vec<T> hydrostatic = own<Real>(H, H + 1, H + 2, 0);
    Continuity<T> total = {};
    Filling<T> filling = {};
    SymmTensor<T> strain = {};
    const T scale = own<Real>(p.scale);
    [[maybe_unused]] Vec<T> U_i = {};
    if constexpr (withStrain)
    {
        U_i = around.ownVector(i, ownVelocity);
    }

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T VF = scale * of[volume] * around.W.gradByDistance(rSqr);
            if constexpr (withFill)
            {
                addFilling(
                    filling, T(of[volume] * around.W.value(rSqr)), VF, x_ij
                );
            }
            addVelocityGradient(total, VF, x_ij, v_i - vectorOf(of + velocity));
            if constexpr (withStrain)
            {
                addStrain(strain, VF, x_ij, U_i - vectorOf(of + ownVelocity));
            }
            // (x_j - x_i).gradW/r^2 = -F
            total.diffusion += densityDiffusion(
                VF, x_ij, rho_i, of[density], rho0, hydrostatic
            );
        }
    );

    const auto all = sumsOf(total, filling);
    p.divergence[i] = all[0];
    p.diffusion[i] = all[1];
    p.curl[i] = squareRoot(magSqr(Vec<double>{all[2], all[3], all[4]}));
    if constexpr (withFill)
    {
        p.fill[i] = all[5];
        for (std::size_t c = 0; c < 3; ++c)
        {
            p.gradFill[c][i] = all[6 + c];
        }
    }
    if constexpr (withStrain)
    {
        store(strain, p.strain, i);
    }
}

template<bool withFill, bool withStrain>
void continuity(const waterContinuityPass& p)
{
    recordFields<continuityFields(withStrain)> fields = {
        {p.x, p.y, p.z, p.V, p.u, p.v, p.w, p.rho},
        p.ago,
        {p.U[0], p.U[1], p.U[2]}};
    if constexpr (withStrain)
    {
        std::copy_n(p.U, 3, fields.of + ownVelocity);
    }
    fields.levelled = density;
    fields.level = p.rho0;
    overPairs(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i)
        { continuityOfParticle<withFill, withStrain>(p, around, i); }
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

//- Power of either kind at i over V_i, twice
template<class T>
struct lostPower
{
    T artificial = constant<T>(0), viscous = constant<T>(0);
};

//- The particle itself in all lanes, made before the loop over its pairs
template<class T>
struct waterHere
{
    T P;
    Vec<T> v;
    T rho, balsara, eta;

    template<class Around>
    waterHere(const Around& around, int i)
        : P(around.own(i, pressure)), v(around.ownVector(i, velocity)),
          rho(around.own(i, density)),
          balsara(around.own(i, lpfPairs::balsara)),
          eta(around.own(i, viscousEta))
    {
    }
};

//- What the pass has for all pairs, in all lanes
template<class Real, class T = packOf<Real>>
struct waterForceFactors
{
    T alphaHC, hSqr, dimensionsPlus2;

    explicit waterForceFactors(const waterForcePass& p)
        : alphaHC(own<Real>(p.alpha * p.h * p.soundSpeed)),
          hSqr(own<Real>(p.h * p.h)),
          dimensionsPlus2(own<Real>(p.dimensions + 2.0))
    {
    }
};

//- What both kinds of friction need of a pair
template<class T>
struct pairOfWater
{
    const T* of; //!< fields of j
    T F, vx;
    T perSoftened, perRhoSoftened; //!< of which either is used
};

//- One quotient for both kinds
template<friction kind, class Real, class T>
LPF_INLINE pairOfWater<T> frictionalPair(
    const waterForceFactors<Real>& by,
    const waterHere<T>& here,
    const T* of,
    const Vec<T>& x_ij,
    const T& rSqr,
    const T& F
)
{
    const Vec<T> v_ij = here.v - vectorOf(of + velocity);
    pairOfWater<T> ij = {of, F, v_ij & x_ij, {}, {}};
    const T away = softened(rSqr, by.hSqr);
    if constexpr (hasArtificial(kind))
    {
        const T rhoMean = constant<T>(0.5) * (here.rho + of[density]);
        ij.perRhoSoftened = T(1) / (rhoMean * away);
        ij.perSoftened = rhoMean * ij.perRhoSoftened;
    }
    else
    {
        ij.perSoftened = T(1) / away;
    }
    return ij;
}

//- Force over V_i along x_ij; perMass: m_i/(V_i thickness^2)
template<class Real, class T>
LPF_INLINE T artificialForce(
    const waterForceFactors<Real>& by,
    const waterHere<T>& here,
    const pairOfWater<T>& ij,
    const T& perMass,
    lostPower<T>& lost
)
{
    const T f = constant<T>(0.5) * (here.balsara + ij.of[balsara]);
    const T Pi =
        artificialViscosity(ij.vx, T(f * by.alphaHC), ij.perRhoSoftened);
    const T force = -ij.of[mass] * Pi * ij.F * perMass;
    lost.artificial += force * ij.vx;
    return force;
}

//- The same of the viscosity
template<class Real, class T>
LPF_INLINE T viscousForce(
    const waterForceFactors<Real>& by,
    const waterHere<T>& here,
    const pairOfWater<T>& ij,
    lostPower<T>& lost
)
{
    const T force = viscousFactor(
        T(ij.of[volume] * ij.F),
        T(here.eta + ij.of[viscousEta]),
        by.dimensionsPlus2,
        ij.vx,
        ij.perSoftened
    );
    lost.viscous += force * ij.vx;
    return force;
}

template<class T>
LPF_INLINE auto
sumsOf(const Vec<T>& a, const Vec<T>& b, const lostPower<T>& lost)
{
    return sums(a.x, a.y, a.z, b.x, b.y, b.z, lost.artificial, lost.viscous);
}

template<friction kind, class Around>
LPF_ONE_BODY void forceOnWater(const waterForcePass& p, Around& around, int i)
{
    using Real = typename Around::Real;
    using T = typename Around::T;
    const waterHere<T> here(around, i);
    const waterForceFactors<Real> by(p);
    const T scale = own<Real>(p.scale);
    const double filled = p.thickness * p.V[i], s = filled / p.m[i];
    [[maybe_unused]] const T perMass = own<Real>(1 / (s * p.thickness));
    Vec<T> pressures = {}, frictions = {};
    lostPower<T> lost;

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T F = around.W.gradByDistance(rSqr);
            const T VF = scale * of[volume] * F;
            addPressureForce(pressures, VF, here.P, of[pressure], x_ij);
            if constexpr (kind != friction::none)
            {
                const pairOfWater<T> ij =
                    frictionalPair<kind, Real>(by, here, of, x_ij, rSqr, F);
                T force = constant<T>(0);
                if constexpr (hasArtificial(kind))
                {
                    force += artificialForce<Real>(by, here, ij, perMass, lost);
                }
                if constexpr (hasViscous(kind))
                {
                    force += viscousForce<Real>(by, here, ij, lost);
                }
                frictions += force * x_ij;
            }
        }
    );

    const auto all = sumsOf(pressures, frictions, lost);
    double* const a[3] = {p.ax + i, p.ay + i, p.az + i};
    for (std::size_t c = 0; c < 3; ++c)
    {
        *a[c] = s * all[c];
    }
    if constexpr (kind != friction::none)
    {
        double* const b[3] = {p.bx + i, p.by + i, p.bz + i};
        for (std::size_t c = 0; c < 3; ++c)
        {
            *b[c] = s * all[3 + c];
        }
        // to either of the pair half of what it loses
        p.artificial[i] = -0.5 * filled * all[6];
        p.viscous[i] = -0.5 * filled * all[7];
    }
}

template<friction kind>
void force(const waterForcePass& p)
{
    const recordFields<12> fields = {
        {p.x, p.y, p.z, p.V, p.u, p.v, p.w, p.rho, p.P, p.m, p.balsara, p.eta}};
    overPairs(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i) { forceOnWater<kind>(p, around, i); }
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
