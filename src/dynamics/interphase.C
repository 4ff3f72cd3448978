// SPDX-License-Identifier: GPL-3.0-or-later
#include "interphase.H"

#include "fieldTensors.H"
#include "orderedSum.H"
#include "waveSpeeds.H"

#include <algorithm>

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

//- Grains with less water around than this share of what their pores could
//  hold stand out of it in part
constexpr scalar immersed = 0.5;

//- Bulk volume of grains over the place they are in, from which they overlap
constexpr scalar crowded = 1.1;

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

} // namespace

interphase::interphase(
    const lpfPairs::pairEngine& engine,
    grainDynamics& grains,
    waterDynamics& water,
    const dragLaw& law,
    scalar grainDensity,
    scalar diameter,
    dragOperator howDragActs
)
    : engine_(engine), grains_(grains), water_(water), law_(law),
      grainDensity_(grainDensity), diameter_(diameter), operator_(howDragActs),
      h_(0.5 * (grains.scene().h + water.scene().h)), waterAtGrains_(engine),
      grainsAtWater_(engine), grainsAtGrains_(engine)
{
    water.borrow(grains);
    for (auto* t : {&waterAtGrains_, &grainsAtWater_, &grainsAtGrains_})
    {
        t->borrow(grains.pairs());
    }
}

const lpfPairs::pairTable&
interphase::table(const phaseDynamics& home, const phaseDynamics& others) const
{
    if (&home == &water_)
    {
        return grainsAtWater_;
    }
    if (&others == &water_)
    {
        return waterAtGrains_;
    }
    return h_ == grains_.scene().h ? grains_.pairs() : grainsAtGrains_;
}

// Positions stay as they are until the drift
void interphase::search()
{
    const passTimes::timed pass(times, "search");
    const auto find = [&](const phaseDynamics& home,
                          const phaseDynamics& others,
                          lpfPairs::pairTable& into)
    {
        const lpfPairs::crossPass p = crossed(home, others);
        into.search({p.home, p.others, h_, p.x, p.y, p.z, p.X, p.Y, p.Z});
    };
    find(grains_, water_, waterAtGrains_);
    find(water_, grains_, grainsAtWater_);
    if (h_ != grains_.scene().h && operator_ == dragOperator::adjoint)
    {
        find(grains_, grains_, grainsAtGrains_);
    }
}

lpfPairs::crossPass interphase::crossed(
    const phaseDynamics& home, const phaseDynamics& others
) const
{
    lpfPairs::crossPass p = {};
    p.pairs = table(home, others).get();
    p.single = home.scene().single;
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

void interphase::resize(int n)
{
    Vs_.resize(n);
    around_.resize(n);
    lpf::resize(fromGrains_, n);
    lpf::resize(fromWater_, n);
}

// Each grain shares its volume out to the water around it, by volume of water:
//     w_ka = O_a W_ka/SO_k,  O = m/max(rho_f, rho0/2),
//     SO_k = max(sum_a O_a W_ka, (1 - gam) (1 - phi_k)/2)         (T 6.2)
void interphase::seeWater()
{
    const grainStore& grains = grains_.grains;
    waterStore& water = water_.water;
    const int n = grains.size();

    resize(n);
    water_.waterVolumes(water.V);
    lpfPairs::smoothPass p = {crossed(grains_, water_), 1, {}, {}};
    p.q[0] = water.V.data();
    p.out[0] = around_.data();
    engine_.smooth(p);

    lpfPairs::forEach(
        n,
        [&](int k)
        {
            Vs_[k] = grains.mass[k]
                   / (grainDensity_ * grains_.scene().planeThickness);
            const scalar pores =
                max(leastPorosity, 1 - grains.rho[k] / grainDensity_);
            const scalar open = openShare(grains_.groundShare(k));
            around_[k] = Vs_[k] / max(around_[k], immersed * open * pores);
        }
    );
}

// theta_a = 1/(1 + chi_a),  chi_a = s_a sum_k Vs_k W_ka/SO_k        (T 6.1)
// q_a = theta_a (v_a + s_a sum_k Vs_k W_ka v_k/SO_k)                (T 6.3)
// s_a = min(1, 1.1/sum_k V_k W_ka): grains that overlap displace less
scalar interphase::takeShares(int a)
{
    waterStore& water = water_.water;
    const scalar s = min(scalar(1), crowded / max(crowding_[a], SMALL));
    const scalar theta = 1 / (1 + s * water.theta[a]); // (T 6.1)
    crowding_[a] = s;
    water.theta[a] = theta;
    set(water.flux, a, theta * (at(water.U, a) + s * at(water.flux, a)));
    return theta;
}

void interphase::porosity()
{
    const grainStore& grains = grains_.grains;
    waterStore& water = water_.water;
    const int n = grains.size();
    search();
    const passTimes::timed pass(times, "porosity");

    seeWater();
    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int k = begin; k < end; ++k)
            {
                fromGrains_[0][k] = around_[k];
                for (std::size_t c = 0; c < 3; ++c)
                {
                    fromGrains_[1 + c][k] = around_[k] * grains.U[c][k];
                }
            }
        }
    );
    lpfPairs::smoothPass p = {crossed(water_, grains_), 5, {}, {}};
    for (std::size_t c = 0; c < 4; ++c)
    {
        fromGrains_[c].pad(n, 0);
        p.q[c] = fromGrains_[c].data();
        p.out[c] = c == 0 ? water.theta.data() : water.flux[c - 1].data();
    }
    crowding_.resize(water.size());
    p.q[4] = grains.V.data();
    p.out[4] = crowding_.data();
    engine_.smooth(p);

    leastTheta_ = 1
                - lpfPairs::largest(
                      water.size(), [&](int a) { return 1 - takeShares(a); }
                );
}

// The grains feel the pressure force that the water around them feels:
//     F_k = Vs_k sum_a w_ka G_a,  G_a = f_a/V_a                     (T 6.5)
void interphase::forces()
{
    grainStore& grains = grains_.grains;
    waterStore& water = water_.water;
    const int n = grains.size();
    const passTimes::timed pass(times, "pressure on grains");

    const bool asks = water_.asksGrains();
    lpfPairs::smoothPass p = {crossed(grains_, water_), asks ? 4 : 3, {}, {}};
    if (asks)
    {
        packed_.resize(n);
        p.q[3] = water.V.data();
        p.out[3] = packed_.data();
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
        lpfPairs::forEach(
            water.size(), [&](int i) { water.gradPForce[c][i] *= crowding_[i]; }
        );
        water.gradPForce[c].pad(water.size(), 0);
        p.q[c] = water.gradPForce[c].data();
        p.out[c] = grains.gradPForce[c].data();
    }
    engine_.smooth(p);

    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int k = begin; k < end; ++k)
            {
                const vector a =
                    around_[k] / grains.mass[k] * at(grains.gradPForce, k);
                set(grains.gradPForce, k, a);
                set(grains.a, k, at(grains.a, k) + a);
            }
        }
    );
}

// forces() left s_a theta_a f_a in its place                        (T 6.5)
scalar interphase::meanGradPForceOfWater() const
{
    const waterStore& water = water_.water;
    const scalar sum = orderedSum<sumOf<scalar>>(
                           water.size(),
                           [&](int i) {
                               return sumOf<scalar>{
                                   mag(at(water.gradPForce, i)) / crowding_[i]};
                           }
    ).value;
    return sum / max(water_.mass().value(), VSMALL);
}

// m, m v and m a of the particles of one phase, smoothed at those of another
// or its own
void interphase::gather(
    const phaseDynamics& from,
    const phaseDynamics& home,
    realArrays<7>& at,
    oneMore more
)
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

    lpfPairs::smoothPass p = {crossed(home, from), more.q ? 8 : 7, {}, {}};
    for (std::size_t c = 0; c < 7; ++c)
    {
        p.q[c] = carried_[c].data();
        p.out[c] = at[c].data();
    }
    if (more.q)
    {
        more.q->pad(n, 0);
        p.q[7] = more.q->data();
        p.out[7] = more.out->data();
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

    // of the kernel, what is neither ground nor beyond the surface  (T 6.21)
    const scalar open =
        openShare(grains_.groundShare(k) + grains_.surfaceShare(k, h_));
    const scalar bulk = grains_.grains.rho[k];
    const dragPlace place =
        placeOf(bulk / grainDensity_ * filled(rb / (open * bulk)), rf, open);
    const vector change = relaxed(place.at, place.densities, slip, da, dt);
    return (-grains_.grains.mass[k] * rf / (rf + rb)) * change; // (T 6.8)
}

// solid: share of grains; rf: sum of m W of the water, in the open share of the
// kernel
interphase::dragPlace
interphase::placeOf(scalar solid, scalar rf, scalar open) const
{
    dragPlace place;
    dragPoint& at = place.at;
    at.solid = min(densest, solid);
    at.fluid = max(leastPorosity, 1 - at.solid);
    at.density = water_.state().rho0();
    at.mu = water_.viscosity().molecular();
    at.diameter = diameter_;
    // where the pores are not full, drag acts in their wet share S only
    const scalar S = filled(rf / (open * at.fluid * at.density));
    place.rb = at.solid * grainDensity_;
    place.rf = S * at.fluid * at.density;
    place.densities = place.rf * place.rb / ((place.rf + place.rb) * S);
    return place;
}

void interphase::drag(scalar dt)
{
    const passTimes::timed pass(times, "drag");
    operator_ == dragOperator::adjoint ? adjointDrag(dt) : interpolatedDrag(dt);
    if (water_.asksGrains())
    {
        relaxWater(dt);
    }
}

void interphase::adjointDrag(scalar dt)
{
    const int n = grains_.grains.size();
    gather(water_, grains_, fromWater_);
    gather(grains_, grains_, fromGrains_);

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

// What the water around a grain fills of its place beyond what there is,
//     e_k = g(S_k) (S_k - 1),  S_k = sum_a V_a W_ka + gam,             (T 6.16)
// g from 0 at S = 0.7 to 1 at 0.85. A grain stands where it does whatever the
// water does: there the sum has no bias, which it has at the water itself.
// Beside ground it has one, for water stands in layers along it: where the
// density is right there (T 5.24), the part of these grains is 1 - 10 gam,
// steepness 10; else it is 0.
scalar interphase::excess(int k, scalar steepness) const
{
    constexpr scalar from = 0.7, to = 0.85;
    const scalar gam = grains_.groundShare(k);
    const scalar S = packed_[k] + gam; // (T 6.16)
    const scalar away = max(scalar(0), 1 - steepness * gam);
    return away * std::clamp((S - from) / (to - from), 0.0, 1.0) * (S - 1);
}

// e_a = sum_k Vs_k W_ka/SO_k e_k/sum_k Vs_k W_ka/SO_k,  the water of (T 6.17)
void interphase::relaxWater(scalar dt)
{
    const waterStore& water = water_.water;
    lpfPairs::forEach(
        water.size(),
        [&](int a)
        {
            const scalar chi = (1 / water.theta[a] - 1) / crowding_[a];
            excess_[a] = chi > SMALL ? excess_[a] / chi : 0;
        }
    );
    water_.relaxByGrains(excess_, dt);
}

//- w_ka e_k of (T 6.17) at the grains, over W_ka; room for its sum at the water
realArray& interphase::excesses()
{
    const int n = grains_.grains.size();
    realArray& q = fromGrains_[3];
    const scalar steepness = water_.keepsLag() ? 10 : 0;
    lpfPairs::forEach(
        n, [&](int k) { q[k] = around_[k] * excess(k, steepness); }
    );
    q.pad(n, 0);
    excess_.resize(water_.water.size());
    return q;
}

void interphase::distribute(
    phaseDynamics& to,
    realArrays<7>& fromGrains,
    scalar sign,
    realArrays<3>& dragForce,
    scalar dt
)
{
    const bool asks = &to == &water_ && water_.asksGrains();
    lpfPairs::smoothPass p = {crossed(to, grains_), asks ? 4 : 3, {}, {}};
    if (asks)
    {
        p.q[3] = excesses().data();
        p.out[3] = excess_.data();
    }
    for (std::size_t c = 0; c < 3; ++c)
    {
        fromGrains[c].pad(grains_.grains.size(), 0);
        p.q[c] = fromGrains[c].data();
        p.out[c] = dragForce[c].data();
    }
    engine_.smooth(p);
    to.takeDrag(dragForce, sign, dt);
}

// (T 6.10)
timeStepLimit interphase::stableDeltaT(scalar CFL, scalar skeletonSpeed) const
{
    const scalar c =
        coupledSound(water_.state(), leastTheta_, grainDensity_, skeletonSpeed);
    const scalar h = min(grains_.scene().h, water_.scene().h);
    const scalar speed = max(grains_.maxSpeed(), water_.maxSpeed());
    return {CFL * h / (c + speed), "coupled sound"};
}

std::size_t interphase::bytes() const
{
    return waterAtGrains_.bytes() + grainsAtWater_.bytes()
         + grainsAtGrains_.bytes() + Vs_.bytes() + around_.bytes()
         + crowding_.bytes() + packed_.bytes() + excess_.bytes()
         + lpf::bytes(fromWater_) + lpf::bytes(fromGrains_)
         + lpf::bytes(carried_) + voids_.bytes() + carriedVoids_.bytes()
         + lpf::bytes(atWater_);
}

} // namespace lpf
} // namespace Foam
