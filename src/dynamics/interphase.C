// SPDX-License-Identifier: GPL-3.0-or-later
#include "interphase.H"

#include "fieldTensors.H"
#include "orderedSum.H"

namespace Foam
{
namespace lpf
{

using lpfPairs::forChunks;
using lpfPairs::orderedSum;
using lpfPairs::sumOf;

namespace
{

//- Porosity is not below this
constexpr scalar leastPorosity = 0.05;

//- Densest packing that a drag law is asked for
constexpr scalar densest = 0.74;

//- Share of the open kernel that water fills, from which the gradient of its
//  pressure is corrected, and is corrected in full
constexpr scalar wetFrom = 0.45, wetTo = 0.65;

//- Less water around than this share of the kernel is none
constexpr scalar dryShare = 1e-6;

//- Norm of a correction above which it is not applied, 1.7 where water is all
//  around
constexpr scalar largestCorrection = 6;

//- Share of the kernel that is not ground, as a divisor
scalar openShare(scalar groundShare)
{
    return max(0.3, 1 - groundShare);
}

//- Share of a place that a phase fills, from the sum of its volumes over the
//  open share of the kernel: a bed is full also where the sum of a lattice
//  beside the ground falls short of the integral
scalar filled(scalar share)
{
    constexpr scalar from = 0.75, to = 0.9;
    if (share < from)
    {
        return share;
    }
    if (share > to)
    {
        return 1;
    }
    const scalar t = (share - from) / (to - from);
    return from + (to - from) * t * sqr(1 - t)
         + (1 - from) * sqr(t) * (3 - 2 * t); // Hermite, slopes 1 and 0
}

scalar norm(const Tens& a)
{
    return sqrt(magSqr(a.x) + magSqr(a.y) + magSqr(a.z));
}

//- Inverse of a, where it is not much larger than the unit tensor; else none
bool invert(const Tens& a, Tens& inverse)
{
    const Tens cofactors = {cross(a.y, a.z), cross(a.z, a.x), cross(a.x, a.y)};
    const scalar det = a.x & cofactors.x;
    if (!(mag(det) > VSMALL))
    {
        return false;
    }
    inverse = (1 / det) * transpose(cofactors);
    return norm(inverse) < largestCorrection;
}

//- 0 below from, 1 above to, smooth between
scalar smoothStep(scalar from, scalar to, scalar x)
{
    const scalar t = min(scalar(1), max(scalar(0), (x - from) / (to - from)));
    return sqr(t) * (3 - 2 * t);
}

} // namespace

interphase::interphase(
    const lpfPairs::pairEngine& engine,
    grainDynamics& grains,
    waterDynamics& water,
    const dragLaw& law,
    scalar grainDensity,
    scalar diameter
)
    : engine_(engine), grains_(grains), water_(water), law_(law),
      grainDensity_(grainDensity), diameter_(diameter),
      h_(0.5 * (grains.scene().h + water.scene().h))
{
}

lpfPairs::crossPass interphase::crossed(
    const phaseDynamics& home, const phaseDynamics& others
) const
{
    lpfPairs::crossPass p = {};
    const particleStore &a = home.particles(), &b = others.particles();
    p.home = home.cells();
    p.others = others.cells();
    p.h = h_;
    p.dimensions = home.scene().dimensions;
    p.x = a.x[0].data();
    p.y = a.x[1].data();
    p.z = a.x[2].data();
    p.X = b.x[0].data();
    p.Y = b.x[1].data();
    p.Z = b.x[2].data();
    return p;
}

// theta_a = 1 - xi_a g(S_a/(1 - gam_a))                             (T 6.1)
//     S = sum_k V_k W_ak,  xi = sum_k Vs_k W_ak/S
void interphase::porosity()
{
    const grainStore& grains = grains_.grains;
    waterStore& water = water_.water;
    const int n = grains.size();

    resize(n);
    for (int k = 0; k < n; ++k)
    {
        Vs_[k] =
            grains.mass[k] / (grainDensity_ * grains_.scene().planeThickness);
    }
    Vs_.pad(n, 0);

    lpfPairs::smoothPass p = {crossed(water_, grains_), 2, {}, {}};
    p.q[0] = Vs_.data();
    p.q[1] = grains.V.data();
    p.out[0] = water.theta.data();
    p.out[1] = water.viscous.data(); // free until the forces
    engine_.smooth(p);

    const scalar solid = lpfPairs::largest(
        water.size(),
        [&](int a)
        {
            const scalar S = water.viscous[a];
            const scalar full = filled(S / openShare(water_.groundShare(a)));
            const scalar xi = S > 0 ? water.theta[a] / S * full : 0;
            water.theta[a] = max(leastPorosity, 1 - xi); // (T 6.1)
            return 1 - water.theta[a];
        }
    );
    leastTheta_ = 1 - solid;
}

void interphase::resize(int n)
{
    for (auto* f : {&Vs_, &share_, &Q_, &P_})
    {
        f->resize(n);
    }
    lpf::resize(gradient_, n);
    lpf::resize(C_, n);
    lpf::resize(fromGrains_, n);
    lpf::resize(fromWater_, n);
}

void interphase::moments()
{
    const grainStore& grains = grains_.grains;
    const waterStore& water = water_.water;
    lpfPairs::waterMomentsPass p = {};
    static_cast<lpfPairs::crossPass&>(p) = crossed(grains_, water_);
    p.u = grains.U[0].data();
    p.v = grains.U[1].data();
    p.w = grains.U[2].data();
    p.U = water.U[0].data();
    p.V = water.U[1].data();
    p.W = water.U[2].data();
    p.volume = water.V.data();
    p.share = share_.data();
    for (std::size_t c = 0; c < 3; ++c)
    {
        p.offset[c] = fromGrains_[c].data();
        p.gradient[c] = gradient_[c].data();
    }
    for (std::size_t c = 0; c < 6; ++c)
    {
        p.N[c] = fromWater_[c].data();
    }
    for (std::size_t c = 0; c < 9; ++c)
    {
        p.slip[c] = C_[c].data();
    }
    engine_.waterMoments(p);
}

// With the centroid of the water around, xbar, SW = sum_a V_a W_ka,
//     C = (sum_a V_a gradW (x) (x_a - xbar))^-1
//     Q = sum_a V_a (C gradW).(v_k - v_a)                           (T 6.3)
// exact for a linear pressure also where water lies on one side only. Where it
// fills less than half of the kernel, C = SW/(1 - gam) I, with a smooth change
void interphase::correctionOf(int k)
{
    const scalar SW = share_[k], Vs = Vs_[k];
    const Tens slip = tensorAt(C_, k);
    Tens C = {};
    scalar QbySW = 0;
    if (SW > dryShare)
    {
        const Symm N = symmAt(fromWater_, k);
        const Vec3 offset = (1 / SW) * vecAt(fromGrains_, k);
        const scalar full =
            min(scalar(1), SW / openShare(grains_.groundShare(k)));
        const Tens unit = {{1, 0, 0}, {0, 1, 0}, {0, 0, 1}};
        C = full * unit;
        Tens inverse;
        if (full > wetFrom
            && invert(
                lpfPairs::full(N + grains_.acrossPlane())
                    - outer(vecAt(gradient_, k), offset),
                inverse
            ))
        {
            const scalar w = smoothStep(wetFrom, wetTo, full);
            C = w * inverse + (1 - w) * C;
        }
        QbySW = (C && transpose(slip)) / SW;
    }
    setTensor(C_, k, Vs * C);
    Q_[k] = Vs * QbySW;
}

void interphase::divergence()
{
    const grainStore& grains = grains_.grains;
    waterStore& water = water_.water;
    const int n = grains.size(), nWater = water.size();

    moments();
    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int k = begin; k < end; ++k)
            {
                correctionOf(k);
            }
        }
    );
    padZero(C_, n);
    Q_.pad(n, 0);

    lpfPairs::grainDivergencePass p = {};
    static_cast<lpfPairs::crossPass&>(p) = crossed(water_, grains_);
    p.u = water.U[0].data();
    p.v = water.U[1].data();
    p.w = water.U[2].data();
    p.U = grains.U[0].data();
    p.V = grains.U[1].data();
    p.W = grains.U[2].data();
    for (std::size_t c = 0; c < 9; ++c)
    {
        p.VsC[c] = C_[c].data();
    }
    p.VsQ = Q_.data();
    p.divergence = water.viscous.data(); // free until the forces
    engine_.grainDivergence(p);

    // r = (div v - sum_k Vs_k [g_ka.(v_k - v_a) - W_ka Q_k/SW_k])/theta (T 6.4)
    for (int a = 0; a < nWater; ++a)
    {
        water.rate[a] = (water.rate[a] - water.viscous[a]) / water.theta[a];
    }
}

// F_k = - Vs C sum_a V_a (P_a - P_k) gradW,  P_k = sum V P W/SW      (T 6.5)
void interphase::pressureOnGrains()
{
    grainStore& grains = grains_.grains;
    const waterStore& water = water_.water;
    const int n = grains.size(), nWater = water.size();

    VP_.resize(nWater);
    for (int a = 0; a < nWater; ++a)
    {
        VP_[a] = water.V[a] * water.p[a];
    }
    VP_.pad(nWater, 0);

    lpfPairs::waterPressurePass p = {};
    static_cast<lpfPairs::crossPass&>(p) = crossed(grains_, water_);
    p.VP = VP_.data();
    p.sum = P_.data();
    for (std::size_t c = 0; c < 3; ++c)
    {
        p.grad[c] = fromWater_[c].data();
    }
    engine_.waterPressure(p);

    const scalar thickness = grains_.scene().planeThickness;
    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int k = begin; k < end; ++k)
            {
                P_[k] = share_[k] > dryShare ? P_[k] / share_[k] : 0;
                const Vec3 grad = vecAt(fromWater_, k);
                const Vec3 F =
                    (-thickness)
                    * (tensorAt(C_, k) & (grad - P_[k] * vecAt(gradient_, k)));
                const vector a = toVector(F) / grains.mass[k]; // (T 6.5)
                set(grains.gradPForce, k, a);
                set(grains.a, k, at(grains.a, k) + a);
            }
        }
    );
    P_.pad(n, 0);
}

void interphase::reactionOnWater()
{
    waterStore& water = water_.water;
    const int nWater = water.size();
    lpf::resize(reaction_, nWater);

    lpfPairs::grainReactionPass p = {};
    static_cast<lpfPairs::crossPass&>(p) = crossed(water_, grains_);
    p.P = water.p.data();
    p.Pk = P_.data();
    for (std::size_t c = 0; c < 9; ++c)
    {
        p.VsC[c] = C_[c].data();
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
        p.force[c] = reaction_[c].data();
    }
    engine_.grainReaction(p);

    const scalar thickness = water_.scene().planeThickness;
    forChunks(
        nWater,
        [&](int begin, int end, int)
        {
            for (int a = begin; a < end; ++a)
            {
                const scalar s = thickness * water.V[a] / water.mass[a];
                set(water.a, a, at(water.a, a) + s * at(reaction_, a));
            }
        }
    );
}

void interphase::forces()
{
    pressureOnGrains();
    reactionOnWater();
}

// m, m v and m a of the particles of one phase, smoothed at the grains
void interphase::gather(const phaseDynamics& from, realArrays<7>& at)
{
    const particleStore& particles = from.particles();
    const int n = particles.size();
    const scalar thickness = from.scene().planeThickness;
    lpf::resize(carried_, n);
    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                const scalar m = particles.mass[i] / thickness;
                carried_[0][i] = m;
                for (std::size_t c = 0; c < 3; ++c)
                {
                    carried_[1 + c][i] = m * particles.U[c][i];
                    carried_[4 + c][i] = m * particles.a[c][i];
                }
            }
        }
    );
    padZero(carried_, n);

    lpfPairs::smoothPass p = {crossed(grains_, from), 7, {}, {}};
    for (std::size_t c = 0; c < 7; ++c)
    {
        p.q[c] = carried_[c].data();
        p.out[c] = at[c].data();
    }
    engine_.smooth(p);
}

// The slip s after a kick by da dt relaxes with tau of the slip that it ends
// with,
//     s_end = s E + da (tau (1 - E) - dt E),  E = exp(-dt/tau)       (T 6.7)
// exact for constant tau and da: the terminal slip da tau at any dt/tau
vector interphase::relaxed(
    const dragPoint& at,
    scalar densities,
    const vector& s,
    const vector& da,
    scalar dt
) const
{
    constexpr int tries = 8;
    constexpr scalar close = 1e-6;

    const auto end = [&](scalar u)
    {
        // densities = rb_f rb_p/(rb_f + rb_p), over the wet share
        const scalar tau = densities / max(law_.beta(at, u), VSMALL);
        const scalar E = std::exp(-dt / tau);
        return vector(E * s + (tau * -std::expm1(-dt / tau) - dt * E) * da);
    };
    // |end(u)| falls with u: secant for |end(u)| = u
    scalar u0 = mag(s - dt * da), f0 = mag(end(u0)) - u0;
    scalar u1 = u0 + f0;
    vector last = end(u1);
    for (int k = 0; k < tries; ++k)
    {
        const scalar f1 = mag(last) - u1;
        if (mag(f1) <= close * (u1 + VSMALL) || f1 == f0)
        {
            break;
        }
        const scalar next = max(scalar(0), u1 - f1 * (u1 - u0) / (f1 - f0));
        u0 = u1;
        f0 = f1;
        u1 = next;
        last = end(u1);
    }
    return last - s;
}

// J_k = - m_k rf/(rf + rb) (s_end - s), rf and rb the sums of m W of water and
// grains at grain k                                                 (T 6.8)
vector interphase::dragImpulse(int k, scalar dt) const
{
    const scalar rf = fromWater_[0][k], rb = fromGrains_[0][k];
    if (!(rf > dryShare * water_.state().rho0()))
    {
        return vector(Zero);
    }
    const vector slip =
        vector(fromWater_[1][k], fromWater_[2][k], fromWater_[3][k]) / rf
        - vector(fromGrains_[1][k], fromGrains_[2][k], fromGrains_[3][k]) / rb;
    const vector da =
        vector(fromWater_[4][k], fromWater_[5][k], fromWater_[6][k]) / rf
        - vector(fromGrains_[4][k], fromGrains_[5][k], fromGrains_[6][k]) / rb;

    const scalar open = openShare(grains_.groundShare(k));
    dragPoint at;
    const scalar bulk = grains_.grains.rho[k];
    at.solid = min(densest, bulk / grainDensity_ * filled(rb / (open * bulk)));
    at.fluid = max(leastPorosity, 1 - at.solid);
    at.density = water_.state().rho0();
    at.mu = water_.viscosity().molecular();
    at.diameter = diameter_;
    // where the pores are not full, drag acts in their wet share S only
    const scalar S = filled(rf / (open * at.fluid * at.density));
    const scalar rbFull = at.solid * grainDensity_;
    const scalar rfFull = S * at.fluid * at.density;
    const scalar densities = rfFull * rbFull / ((rfFull + rbFull) * S);

    const vector change = relaxed(at, densities, slip, da, dt);
    return (-grains_.grains.mass[k] * rf / (rf + rb)) * change; // (T 6.8)
}

void interphase::drag(scalar dt)
{
    const int n = grains_.grains.size();
    gather(water_, fromWater_);
    gather(grains_, fromGrains_);

    const scalar thickness = grains_.scene().planeThickness;
    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int k = begin; k < end; ++k)
            {
                const vector J = dragImpulse(k, dt) / thickness;
                const scalar rf = fromWater_[0][k], rb = fromGrains_[0][k];
                for (direction c = 0; c < 3; ++c)
                {
                    fromGrains_[c][k] = J[c] / rb;
                    fromWater_[c][k] = rf > 0 ? J[c] / rf : 0;
                }
            }
        }
    );
    // dv_j = sum_k J_k W_kj/rb_k,  dv_a = - sum_k J_k W_ka/rf_k      (T 6.9)
    distribute(grains_, fromGrains_, 1, grains_.grains.drag, dt);
    distribute(water_, fromWater_, -1, water_.water.drag, dt);
}

// Work of an impulse: on the mean of the velocities before the kick that went
// with it and after both, as the leapfrog does work
void interphase::distribute(
    phaseDynamics& to,
    realArrays<7>& fromGrains,
    scalar sign,
    realArrays<3>& dragForce,
    scalar dt
)
{
    lpfPairs::smoothPass p = {crossed(to, grains_), 3, {}, {}};
    for (std::size_t c = 0; c < 3; ++c)
    {
        fromGrains[c].pad(grains_.grains.size(), 0);
        p.q[c] = fromGrains[c].data();
        p.out[c] = dragForce[c].data();
    }
    engine_.smooth(p);

    particleStore& particles = to.particles();
    to.ledger.drag +=
        orderedSum<sumOf<scalar>>(
            particles.size(),
            [&](int i)
            {
                const vector change = sign * at(dragForce, i);
                const vector U = at(particles.U, i) + change;
                const vector before = U - change - dt * at(particles.a, i);
                set(particles.U, i, U);
                set(dragForce, i, change / dt);
                return sumOf<scalar>{
                    -0.5 * particles.mass[i] * (change & (before + U))};
            }
        ).value;
}

// Sound in the mixture, and short waves that see c0/theta:
//     c^2 = c0^2 (1 + xi_p rho_f/(theta rho_p)) + (K + 4 G/3)/rb_p  (T 6.10)
timeStepLimit interphase::stableDeltaT(scalar CFL, scalar skeleton) const
{
    const scalar c0 = water_.state().c0(), theta = leastTheta_;
    const scalar xi = max(scalar(1e-3), 1 - theta);
    const scalar mixture = sqrt(
        sqr(c0) * (1 + xi * water_.state().rho0() / (theta * grainDensity_))
        + skeleton / (xi * grainDensity_)
    );
    const scalar c = max(mixture, c0 / theta);
    const scalar h = min(grains_.scene().h, water_.scene().h);
    const scalar speed = max(grains_.maxSpeed(), water_.maxSpeed());
    return {CFL * h / (c + speed), "coupled sound"};
}

std::size_t interphase::bytes() const
{
    return Vs_.bytes() + share_.bytes() + lpf::bytes(gradient_) + lpf::bytes(C_)
         + Q_.bytes() + P_.bytes() + VP_.bytes() + lpf::bytes(reaction_)
         + lpf::bytes(fromWater_) + lpf::bytes(fromGrains_)
         + lpf::bytes(carried_);
}

} // namespace lpf
} // namespace Foam
