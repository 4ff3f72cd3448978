// SPDX-License-Identifier: GPL-3.0-or-later
// Loops, lanes and threads of the pair sums. The physics is in pairTerms.H.
// Built once an instruction set, each time a library of its own.

#include "pairEngine.H"
#include "enginePasses.H"
#include "listLoops.H"
#include "pairTerms.H"

#include <chrono>

#ifndef LPF_ISA
#error "LPF_ISA names the instruction set of this build"
#endif

namespace lpfPairs
{
namespace
{

//- Fields of the records of grains
enum grainField
{
    volume = 3,
    velocity = 4,
    filled = 7, //!< mass, of the kinematics pass
    moment = 4, //!< of the force pass, nine
    flow = 13,  //!< velocity there, with viscosity
    density = 16,
    mass = 17,
    gradientL = 18 //!< nine, with noise damping
};

//- Outside the support F = 0, and in the record of nobody V = 0: both remove
//  what is there, as it is finite. One body with the filling and without: R and
//  M have the same bits then, which compilers do not promise of two
template<class Around>
LPF_ONE_BODY void
kinematicsOfParticle(const kinematicsPass& p, Around& around, int i)
{
    using T = typename Around::T;
    const Vec<T> v_i = around.ownVector(i, velocity);
    Kinematics<T> total = {};
    Filling<T> filling = {};

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T VF = of[volume] * around.W.gradByDistance(rSqr);
            addKinematics(total, VF, x_ij, v_i - vectorOf(of + velocity));
            addFilling(filling, T(of[filled] * around.W.value(rSqr)), VF, x_ij);
        }
    );

    const Tensor<T>& R = total.R;
    storeSums(
        p.R, i, R.x.x, R.x.y, R.x.z, R.y.x, R.y.y, R.y.z, R.z.x, R.z.y, R.z.z
    );
    store(total.M, p.M, i);
    if (p.fill)
    {
        const Vec<T>& g = filling.gradient;
        const auto all = sums(filling.fill, g.x, g.y, g.z);
        p.fill[i] = all[0] / p.thickness;
        for (std::size_t c = 0; c < 3; ++c)
        {
            p.gradFill[c][i] = all[c + 1];
        }
    }
}

void kinematics(const kinematicsPass& p)
{
    const recordFields<8> fields = {{p.x, p.y, p.z, p.V, p.u, p.v, p.w, p.m}};
    overPairs(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i) { kinematicsOfParticle(p, around, i); }
    );
}

//- What acts between particles besides the stress
enum class viscosity
{
    none,
    artificial, //!< Monaghan's
    noise       //!< noise damping, with Monaghan's where alpha > 0
};

//- Length of the records of the force pass
constexpr int forceFields(viscosity kind)
{
    return kind == viscosity::none       ? 16
         : kind == viscosity::artificial ? 20
                                         : 28;
}

template<class T>
LPF_INLINE Tensor<T> tensorOf(const T* fields)
{
    return {vectorOf(fields), vectorOf(fields + 3), vectorOf(fields + 6)};
}

//- What the pass has for all pairs, in all lanes
template<class Real, class T = packOf<Real>>
struct viscosityFactors
{
    T alphaHC, betaHC, hSqr, perThickness;

    explicit viscosityFactors(const forcePass& p)
        : alphaHC(own<Real>(p.alpha * p.h * p.soundSpeed)),
          betaHC(own<Real>(p.beta * p.h * p.soundSpeed)),
          hSqr(own<Real>(p.h * p.h)), perThickness(own<Real>(1 / p.thickness))
    {
    }
};

//- The particle itself in all lanes, made before the loop over its pairs
template<viscosity kind, class T>
struct grainHere
{
    Vec<T> v = {};
    T rho = {};
    Tensor<T> L = {};

    template<class Around>
    grainHere(const Around& around, int i)
    {
        if constexpr (kind != viscosity::none)
        {
            v = around.ownVector(i, flow);
            rho = around.own(i, density);
        }
        if constexpr (kind == viscosity::noise)
        {
            L = {
                around.ownVector(i, gradientL),
                around.ownVector(i, gradientL + 3),
                around.ownVector(i, gradientL + 6)};
        }
    }
};

//- Adds the viscous terms of one pack; power is what they take [W/kg]
template<viscosity kind, class Real, class T = packOf<Real>>
LPF_INLINE void addViscosity(
    const viscosityFactors<Real>& by,
    const grainHere<kind, T>& here,
    const T* of,
    const Vec<T>& x_ij,
    const T& rSqr,
    const T& F,
    Vec<T>& a,
    T& power
)
{
    const T half = constant<T>(0.5);
    const Vec<T> v_ij = here.v - vectorOf(of + flow);
    const T rhoMean = half * (here.rho + of[density]);

    T Pi = artificialViscosity(x_ij, v_ij, rSqr, by.alphaHC, by.hSqr, rhoMean);
    if constexpr (kind == viscosity::noise)
    {
        const Vec<T> w_ij =
            v_ij - half * ((here.L + tensorOf(of + gradientL)) & x_ij);
        Pi += noiseDamping(x_ij, w_ij, rSqr, by.betaHC, by.hSqr, rhoMean);
    }
    const T mPiF = of[mass] * Pi * F * by.perThickness;

    a += Vec<T>{-mPiF * x_ij.x, -mPiF * x_ij.y, -mPiF * x_ij.z};
    power += half * mPiF * (v_ij & x_ij);
}

template<viscosity kind, class Around>
LPF_ONE_BODY void forceOnParticle(const forcePass& p, Around& around, int i)
{
    using Real = typename Around::Real;
    using T = typename Around::T;
    const viscosityFactors<Real> by(p);
    const grainHere<kind, T> here(around, i);
    Force<T> total = {};
    Vec<T> a = {};
    T power = constant<T>(0);

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T F = around.W.gradByDistance(rSqr);
            addForce(total, T(of[volume] * F), x_ij, tensorOf(of + moment));
            if constexpr (kind != viscosity::none)
            {
                addViscosity<kind, Real>(by, here, of, x_ij, rSqr, F, a, power);
            }
        }
    );

    const Vec<T>&gradV = total.gradV, &other = total.other;
    const auto all = sums(gradV.x, gradV.y, gradV.z, other.x, other.y, other.z);
    const Vec<double> g = {all[0], all[1], all[2]};
    const double s = p.thickness * p.V[i] / p.m[i];
    double* out[3] = {p.ax + i, p.ay + i, p.az + i};
    for (std::size_t c = 0; c < 3; ++c)
    {
        const Vec<double> row = {
            p.A[3 * c][i], p.A[3 * c + 1][i], p.A[3 * c + 2][i]};
        *out[c] = s * ((row & g) + all[3 + c]);
    }
    if constexpr (kind != viscosity::none)
    {
        const auto viscous = sums(a.x, a.y, a.z, power);
        for (std::size_t c = 0; c < 3; ++c)
        {
            *out[c] += viscous[c];
        }
        p.viscousPower[i] = p.m[i] * viscous[3];
    }
}

template<viscosity kind>
void force(const forcePass& p)
{
    recordFields<forceFields(kind)> fields = {{p.x, p.y, p.z, p.V}};
    std::copy_n(p.A, 9, fields.of + moment);
    if constexpr (kind != viscosity::none)
    {
        const double* const more[] = {p.u, p.v, p.w, p.rho, p.m};
        std::copy_n(more, 5, fields.of + flow);
    }
    if constexpr (kind == viscosity::noise)
    {
        std::copy_n(p.L, 9, fields.of + gradientL);
    }
    overPairs(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i) { forceOnParticle<kind>(p, around, i); }
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

//- The value in a lane
template<class T>
LPF_INLINE auto lane(const T& a, int k)
{
    alignas(64) typename T::value_type values[T::size()];
    a.copy_to(values, stdx::vector_aligned);
    return values[k];
}

//- A squared distance that nobody sees; above itself when rounded to float
constexpr double farAway = 1e30;

//- Nearest element so far in each lane
template<class T>
struct nearestLanes
{
    T rSqr = constant<T>(farAway), distance = constant<T>(farAway);
    Vec<T> normal = {};

    LPF_INLINE void
    see(const typename T::mask_type& there,
        const T& r2,
        const T& d,
        const Vec<T>& n)
    {
        const auto nearer = there && r2 < rSqr;
        stdx::where(nearer, rSqr) = r2;
        stdx::where(nearer, distance) = d;
        stdx::where(nearer, normal.x) = n.x;
        stdx::where(nearer, normal.y) = n.y;
        stdx::where(nearer, normal.z) = n.z;
    }

    LPF_INLINE void store(wallRecord& to) const
    {
        to.nearestSqr = farAway;
        to.distance = farAway;
        to.normal[0] = to.normal[1] = to.normal[2] = 0;
        const auto least = stdx::hmin(rSqr);
        if (least < farAway)
        {
            // the first lane of several
            const int k = stdx::find_first_set(rSqr == T(least));
            to.nearestSqr = least;
            to.distance = lane(distance, k);
            to.normal[0] = lane(normal.x, k);
            to.normal[1] = lane(normal.y, k);
            to.normal[2] = lane(normal.z, k);
        }
    }
};

template<class T>
void store(const WallSums<T>& from, wallRecord& to)
{
    const SymmTensor3<T> N = from.N3;
    const SymmTensor<T> D = from.D2;
    const auto all = sums(
        N.xxx,
        N.xxy,
        N.xxz,
        N.xyy,
        N.xyz,
        N.xzz,
        N.yyy,
        N.yyz,
        N.yzz,
        N.zzz,
        D.xx,
        D.xy,
        D.xz,
        D.yy,
        D.yz,
        D.zz,
        from.area,
        from.friction,
        from.share
    );
    std::copy_n(all.begin(), 10, to.N3);
    std::copy_n(all.begin() + 10, 6, to.D2);
    to.area = all[16];
    to.friction = all[17];
    to.share = all[18];
}

//- What is asked of the ground
enum class wallSums
{
    plain,
    withShare2, //!< and the share of the kernel inside it, in two dimensions
    withShare3  //!< in three
};

template<wallSums kind, int layers, bool screened, class Around>
LPF_ONE_BODY void wallOfParticle(const wallPass& p, Around& around, int i)
{
    using Real = typename Around::Real;
    using T = typename Around::T;
    WallSums<T> total = {};
    nearestLanes<T> nearest;

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_iq, const T& rSqr)
        {
            const Vec<T> n = vectorOf(of + normal);
            const T d = x_iq & n;
            T area_q = of[area];
            if constexpr (screened)
            {
                area_q = onlyIf(!isScreened(of + screen, x_iq), area_q);
            }
            const auto there =
                area_q > T(Real(0)) && d > own<Real>(-p.outOfSight);
            const T A = onlyIf(d > own<Real>(-p.behind), area_q);
            const LayerSums<T> s =
                layerSums<layers>(around.W, rSqr, d, p.layerDepth);

            addWall(total, LayerSums<T>{A * s.E, A * s.D}, n, of[friction]);
            if constexpr (kind != wallSums::plain)
            {
                constexpr int D = kind == wallSums::withShare3 ? 3 : 2;
                total.share += solidShare<D>(around.W, rSqr, d, A);
            }
            nearest.see(there, rSqr, d, n);
        }
    );

    wallRecord& out = p.sums[p.slot[i]];
    store(total, out);
    nearest.store(out);
}

template<wallSums kind, int layers, bool screened>
void wallOf(const wallPass& p)
{
    auto fields = elementFields<screened>(p, p.mu);
    fields.version = p.version; // most steps find the elements as they were
    overPairs(
        p,
        elementsOf(p),
        fields,
        [&](auto& around, int i)
        {
            if (p.slot[i] >= 0)
            {
                wallOfParticle<kind, layers, screened>(p, around, i);
            }
        }
    );
}

template<wallSums kind, int layers>
void wallInLayers(const wallPass& p)
{
    p.screens.height ? wallOf<kind, layers, true>(p)
                     : wallOf<kind, layers, false>(p);
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
    LPF_ISA,         nLanes,       lanesOf<float>, newTable,
    deleteTable,     borrowMemory, searchPairs,    sizeOfTable,
    kinematics,      anyForce,     anyWall,        waterContinuity,
    waterForce,      viscousForce, shearMoments,   stickToGround,
    penaltyOfGround, smoothed,     stressGradient, stressDiffusion,
    numberListed,    peak};

} // namespace
} // namespace lpfPairs

extern "C" __attribute__((visibility("default"))) const lpfPairs::pairEngine*
lpfPairEngine()
{
    return &lpfPairs::engine;
}
