// SPDX-License-Identifier: GPL-3.0-or-later
#include "waterDynamics.H"

#include "fieldTensors.H"
#include "latticeSums.H"
#include "orderedSum.H"

namespace Foam
{
namespace lpf
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

namespace
{

//- Water this thin counts as so much in its volume, as a share of rho0: the
//  volume of a drop would grow without bound
constexpr scalar thinnest = 0.5;

//- Share of the kernel that the ground leaves open, at least
constexpr scalar leastOpen = 0.2;

//- And its density stays above this
constexpr scalar lowestDensity = 0.01;

//- Reynolds number of a kernel, with a tenth of the speed of sound, up to which
//  viscosity is felt between particles: weights are then worth two passes
constexpr scalar viscousKernel = 100;

vector normalised(const vector& v)
{
    return v / max(mag(v), VSMALL);
}

scalar sumOver(const realArray& a, int n)
{
    return orderedSum<sumOf<scalar>>(
               n, [&](int i) { return sumOf<scalar>{a[i]}; }
    ).value;
}

} // namespace

waterDynamics::waterDynamics(
    const lpfPairs::pairEngine& engine,
    const sceneProperties& scene,
    const waterScheme& scheme,
    const equationOfState& state,
    const viscosityModel& viscosity,
    groundContact& contact,
    bool withGrains
)
    : phaseDynamics(engine, scene, contact, water), scheme_(scheme),
      state_(state), viscosity_(viscosity), withGrains_(withGrains),
      gradientScale_(lpfPairs::latticeFactor(
          lpfPairs::wendlandC2(scene.h, scene.dimensions),
          scene.spacing,
          scene.dimensions
      )),
      largestMu_(viscosity.largest()), surface_(scene.dimensions),
      latticeFill_(lpfPairs::latticeFill(
          lpfPairs::wendlandC2(scene.h, scene.dimensions),
          scene.spacing,
          scene.dimensions
      )),
      wideLatticeFill_(lpfPairs::latticeFill(
          lpfPairs::wendlandC2(scene.h, scene.dimensions),
          scene.spacing * std::pow(2.0, 1.0 / scene.dimensions),
          scene.dimensions
      )),
      perPlaceOfLattice_(1 / std::pow(scene.spacing, scene.dimensions)),
      soundRate_(state.c0() / scene.h),
      lagRate_(
          scheme.groundLag > 0 ? soundRate_ / scheme.groundLag : scalar(0)
      ),
      resistance_(
          groundResistance::forPhase(contact, scene_, &groundZone::water)
      ),
      water(withGrains, scheme.groundLag > 0)
{
    penalty_ = penaltyGround::forPhase(engine, scene_, contact, state.c0());
    images_ = penalty_ ? 0 : images_;
    const scalar mu = viscosity.largest();
    const bool felt =
        state.rho0() * state.c0() * scene.h < 10 * viscousKernel * mu;
    const bool asked = viscosity.needsShearRate() || scheme.implicitViscosity
                    || contact.anyStick();
    if (mu > 0 && (felt || asked))
    {
        viscous_.reset(new waterViscosity(engine, scene_, contact, water));
    }
}

void waterDynamics::densityFromPressure(const scalarField& saturation)
{
    for (int i = 0; i < water.size(); ++i)
    {
        const scalar S = saturation[i];
        water.rho[i] = S < 1 ? S * state_.rho0() : state_.density(water.p[i]);
    }
}

void waterDynamics::arrange(scalar time)
{
    updateGround(time);
    sort();
    seeGround(true);
    renew(near_, walls_.size());
    if (viscous_)
    {
        viscous_->seeGround(
            cells(), pairs_.get(), elementsAround_.get(), slot_, nSlots_
        );
    }
}

// O = m/max(rho_f, rho0/2): the volume of the water in a particle
void waterDynamics::waterVolumes(realArray& O) const
{
    const int n = water.size();
    const scalar least = thinnest * state_.rho0();
    lpfPairs::forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                O[i] = water.mass[i]
                     / (max(water.rho[i], least) * scene_.planeThickness);
            }
        }
    );
    O.pad(n, 0);
}

// V = O/theta: the bulk volume that a particle of water fills, its share of the
// grains included                                                   (T 5.9)
void waterDynamics::volumes()
{
    const int n = water.size();
    waterVolumes(water.V);
    if (withGrains_)
    {
        lpfPairs::forEach(n, [&](int i) { water.V[i] /= water.theta[i]; });
    }
    water.rho.pad(n, state_.rho0());
}

// Velocity of the volume, of water and grains together              (T 6.3)
const realArrays<3>& waterDynamics::volumeFlux() const
{
    return withGrains_ ? water.flux : water.U;
}

void waterDynamics::divergence(scalar dt, stage where)
{
    const passTimes::timed pass(times, "continuity");
    volumes();

    auto p = overPairs<lpfPairs::waterContinuityPass>();
    const realArrays<3>& flux = volumeFlux();
    p.u = flux[0].data();
    p.v = flux[1].data();
    p.w = flux[2].data();
    p.rho = water.rho.data();
    p.ago = where == stage::whole ? 0.5 * dt : 0; // (T 7.4)
    for (std::size_t c = 0; c < 3; ++c)
    {
        p.U[c] = water.U[c].data();
    }
    p.scale = gradientScale_;
    p.rho0 = state_.rho0();
    for (direction d = 0; d < 3; ++d)
    {
        p.hydrostatic[d] = state_.rho0() * scene_.g[d] / sqr(state_.c0());
    }
    if (scheme_.seesPacking())
    {
        takePacking(p);
    }
    p.divergence = water.rate.data();
    p.curl = water.curl.data();
    p.diffusion = water.diffusion.data();
    if (viscous_)
    {
        lpf::resize(strain_, water.size());
        for (std::size_t c = 0; c < 6; ++c)
        {
            p.strain[c] = strain_[c].data();
        }
    }
    engine_.waterContinuity(p);
    addGround(dt, where);
    if (viscous_)
    {
        shearRates();
    }
}

// In the plane of the flow
Symm waterDynamics::withoutTrace(const Symm& D) const
{
    const scalar mean = trace(D) / scene_.dimensions;
    const Symm& e = acrossPlane_;
    return {
        D.xx + mean * (e.xx - 1),
        D.xy + mean * e.xy,
        D.xz + mean * e.xz,
        D.yy + mean * (e.yy - 1),
        D.yz + mean * e.yz,
        D.zz + mean * (e.zz - 1)};
}

// Behind the ground the velocity goes on as its mirror image, where water
// sticks to it linearly through zero:
//     D += 2 sum_q A E (v.n) n n + symm(v_t g),  gamma = sqrt(2 D:D)
//                                                                   (T 5.16)
void waterDynamics::shearRates()
{
    shearRate_.resize(water.size());
    lpfPairs::forChunks(
        water.size(),
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                Symm D = symmAt(strain_, i);
                if (slot_[i] >= 0)
                {
                    const vector v = at(water.U, i);
                    const auto slot = static_cast<std::size_t>(slot_[i]);
                    const vector g = viscous_->groundGradient(i);
                    const scalar square = magSqr(g);
                    const vector along =
                        square > 0 ? vector(v - (v & g) / square * g) : v;
                    D += (thirdMoment(walls_[slot])
                          & toVec(images_ * gradientScale_ * v))
                       + symm(outer(toVec(gradientScale_ * along), toVec(g)));
                }
                shearRate_[i] = rateOfShear(D);
                setSymm(strain_, i, withoutTrace(D));
            }
        }
    );
}

// The velocity goes on behind the ground as its mirror image, so that
//     div v += 2 v.sum_q A E n                                      (T 5.10)
// in the leapfrog the mean of before and after the drift (T 7.4), and of the
// pairs with the volumes that they have halfway, those around as its own:
//     div v <- div v (1 + dt/2 div v)                                (T 7.5)
void waterDynamics::addGround(scalar dt, stage where)
{
    const scalar before = where == stage::whole ? 0.5 : 0;
    const scalar half = before * dt;
    lpfPairs::forEach(
        water.size(),
        [&](int i)
        {
            scalar w = 0;
            if (slot_[i] >= 0)
            {
                const auto slot = static_cast<std::size_t>(slot_[i]);
                nearWall& near = near_[slot];
                near.areaNormal =
                    gradientScale_ * contracted(thirdMoment(walls_[slot]));
                const vector A = toVector(near.areaNormal);
                w = at(volumeFlux(), i) & A;
                near.byGrains = w - ownShare(i) * (at(water.U, i) & A);
            }
            w += before * (water.toGround[i] - w);
            water.toGround[i] = w;
            const scalar byPairs = water.rate[i];
            const scalar all = (byPairs + images_ * w) / ownShare(i);
            water.rate[i] += images_ * w + half * all * byPairs; // (T 7.5)
        }
    );
}

// As they leave, with the velocity that they leave with
void waterDynamics::leaveGround()
{
    lpfPairs::forEach(
        water.size(),
        [&](int i)
        {
            water.toGround[i] = 0;
            if (slot_[i] >= 0)
            {
                const nearWall& near =
                    near_[static_cast<std::size_t>(slot_[i])];
                const vector A = toVector(near.areaNormal);
                water.toGround[i] =
                    near.byGrains + ownShare(i) * (at(water.U, i) & A);
            }
        }
    );
}

void waterDynamics::drift(scalar dt, scalar time)
{
    leaveGround();
    phaseDynamics::drift(dt, time);
}

void waterDynamics::driftOn(scalar dt, scalar time)
{
    leaveGround();
    phaseDynamics::driftOn(dt, time);
}

namespace
{

//- What exceeds the play of e: a bed that consolidates drifts by less, and is
//  to have its volume to a permille
scalar cameToStay(scalar e)
{
    constexpr scalar play = 0.002;
    return e - std::clamp(e, -play, play);
}

} // namespace

// Relative rate at which the density is brought back to the packing [1/s]
scalar waterDynamics::slowRate(int i)
{
    const scalar atGround =
        keepsLag() ? lagRate_ * cameToStay(water.lag[i]) : 0;
    return atGround + (scheme_.densityRelaxation > 0 ? drawnBack(i) : 0);
}

// The image of the ground doubles what the ground does to the density. That is
// right for what comes and goes; of what has come to stay half is taken back:
//     de/dt = w - e'/tau,  w = q.sum_q A E n/theta,
//     e' = e less a play of 0.002,  tau = N h/c0,
//     rho <- rho (1 + dt e'/tau)                                    (T 5.24)
void waterDynamics::advanceLag(scalar dt)
{
    const scalar half = 0.5 * dt * lagRate_;
    lpfPairs::forEach(
        water.size(),
        [&](int i)
        {
            const scalar w = water.toGround[i] / ownShare(i);
            const scalar e =
                water.lag[i] + dt * w - half * cameToStay(water.lag[i]);
            water.lag[i] = e - half / (1 + half) * cameToStay(e);
        }
    );
}

// rho <- rho (1 - dt r/2)/(1 + dt r/2) + dt delta h c0 diffusion    (T 5.11)
waterDynamics::densities waterDynamics::densityAfter(int i, scalar dt)
{
    const scalar diffusivity =
        scheme_.densityDiffusion * scene_.h * state_.c0();
    const scalar lowest = lowestDensity * state_.rho0();
    const scalar half = 0.5 * dt * water.rate[i];
    const scalar rho = max(lowest, water.rho[i] * (1 - half) / (1 + half));
    const scalar relaxed = rho * (1 + dt * slowRate(i));
    return {rho, max(lowest, relaxed + dt * diffusivity * water.diffusion[i])};
}

// By which it falls, of all three; rhoStart is free until keepState()
void waterDynamics::keepDensityRate()
{
    const scalar diffusivity =
        scheme_.densityDiffusion * scene_.h * state_.c0();
    lpfPairs::forEach(
        water.size(),
        [&](int i)
        {
            water.rhoStart[i] = water.rate[i] - slowRate(i)
                              - diffusivity * water.diffusion[i] / water.rho[i];
        }
    );
}

// In the middle of a step on from its start twice, over dt, which is booked,
// and over half of it, for the forces
void waterDynamics::correct(scalar dt, stage where)
{
    const passTimes::timed pass(times, "density, pressure");
    const int n = water.size();
    if (withGrains_)
    {
        // the volume that water leaves is compressed by all of it   (T 6.4)
        lpfPairs::forEach(n, [&](int i) { water.rate[i] /= water.theta[i]; });
    }
    if (asksGrains())
    {
        byGrains_.resize(n);
        seePassage(dt);
    }
    if (where == stage::start)
    {
        keepDensityRate();
    }
    if (where == stage::middle)
    {
        std::swap(water.rho, water.rhoStart);
        lpfPairs::forEach(
            n, [&](int i) { water.rhoStart[i] = densityAfter(i, 0.5 * dt).end; }
        );
    }
    advanceDensity(dt);
    if (keepsLag())
    {
        advanceLag(dt);
    }
    if (where == stage::middle)
    {
        std::swap(water.rho, water.rhoStart);
    }
    water.rho.pad(n, state_.rho0());
    water.curl.pad(n, 0);
    state_.pressure(n, water.rho.data(), water.p.data());
    water.p.pad(n, 0);
    volumes(); // for the forces
}

// What changes the density besides the flow is booked half before and half
// after it, as the forces before and after see it. And Balsara's switch from
// div and curl, not of water that has parted,
//     f = |div|/(|div| + |curl| + 1e-4 c0/h),  1 where rho < rho0   (T 5.8)
void waterDynamics::advanceDensity(scalar dt)
{
    const scalar quiet = 1e-4 * soundRate_;
    ledger.diffusion +=
        orderedSum<sumOf<scalar>>(
            water.size(),
            [&](int i)
            {
                const scalar div = mag(water.rate[i]);
                const scalar before = water.rho[i];
                const densities rho = densityAfter(i, dt);
                const scalar flow = rho.moved / before;
                const scalar half = before + 0.5 * (rho.end - rho.moved);
                water.rho[i] = rho.end;
                water.curl[i] = rho.end < state_.rho0()
                                  ? 1
                                  : div / (div + water.curl[i] + quiet);
                return sumOf<scalar>{
                    water.mass[i]
                    * (state_.released(before, half)
                       + state_.released(half * flow, rho.end))};
            }
        ).value;
}

void waterDynamics::viscosityOfMixture()
{
    const int n = water.size();
    eta_.resize(n);
    const bool byRate = viscosity_.needsShearRate();
    viscosity_.mu(n, byRate ? shearRate_.data() : nullptr, eta_.data());
    if (byRate)
    {
        largestMu_ = lpfPairs::largest(n, [&](int i) { return eta_[i]; });
    }
    if (withGrains_)
    {
        lpfPairs::forEach(n, [&](int i) { eta_[i] *= water.theta[i]; });
    }
    if (viscous_)
    {
        viscous_->adapt(strain_, eta_);
    }
    eta_.pad(n, 0);
}

lpfPairs::waterForcePass waterDynamics::forcePass()
{
    auto p = overPairs<lpfPairs::waterForcePass>();
    p.thickness = scene_.planeThickness;
    p.scale = gradientScale_;
    p.m = water.mass.data();
    p.P = water.p.data();
    p.ax = water.a[0].data();
    p.ay = water.a[1].data();
    p.az = water.a[2].data();
    p.alpha = scheme_.artificialViscosity;
    p.soundSpeed = state_.c0();
    p.u = water.U[0].data();
    p.v = water.U[1].data();
    p.w = water.U[2].data();
    p.rho = water.rho.data();
    p.balsara = water.curl.data();
    p.bx = water.friction[0].data();
    p.by = water.friction[1].data();
    p.bz = water.friction[2].data();
    p.artificial = water.artificialPower().data();
    p.viscous = water.viscousPower().data();
    if (viscosity_.largest() > 0)
    {
        viscosityOfMixture();
        p.eta = viscous_ ? nullptr : eta_.data();
    }
    return p;
}

// The ground carries the pressure of the water before it, adjoint to (T 5.10),
// and what the water behind a lattice of its images would add: the rise of
// pressure with depth, and along the ground the pressure of the missing part of
// the kernel. A is the acceleration by the pairs.
//     f = 2 V P sum_q A E n                                         (T 5.12)
//       - V rho (sum_q A D n n).g
//       + m (1/max(1/5, 1 - gam) - 1) (I - n n) A
void waterDynamics::pressureOfGround(int i, nearWall& near) const
{
    const auto slot = static_cast<std::size_t>(slot_[i]);
    const lpfPairs::wallRecord& wall = walls_[slot];
    const scalar V = water.V[i] * scene_.planeThickness;
    const vector nA = toVector(near.areaNormal);
    const scalar magnitude = mag(nA);
    const vector n = magnitude > 0 ? vector(nA / magnitude) : vector(0, 0, 1);

    const vector A = at(water.a, i);
    const scalar share = 1 / max(leastOpen, 1 - wall.share) - 1;
    const vector along = water.mass[i] * share * (A - (A & n) * n);
    const vector deeper = (-gradientScale_ * V * water.rho[i])
                        * toVector(secondMoment(wall) & toVec(scene_.g));

    const vector adjoint = (2 * V * water.p[i]) * nA;
    near.force = adjoint + deeper; // (T 5.12)
    const bool carried = (near.force & n) > 0;
    near.force = carried ? vector(near.force + along) : vector(Zero);
}

void waterDynamics::addForcesOfGround()
{
    if (penalty_)
    {
        addForcesWith([](int, nearWall& near) { near.force = Zero; });
        return;
    }
    addForcesWith([&](int i, nearWall& near) { pressureOfGround(i, near); });
}

//- ground(i, near): what it does to a particle near it
template<class Ground>
void waterDynamics::addForcesWith(const Ground& ground)
{
    lpfPairs::forChunks(
        water.size(),
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                vector a = at(water.a, i);
                if (slot_[i] >= 0)
                {
                    nearWall& near = near_[static_cast<std::size_t>(slot_[i])];
                    ground(i, near);
                    a += near.force / water.mass[i];
                }
                if (withGrains_)
                {
                    a *= water.theta[i]; // the grains take the rest (T 6.5)
                    set(water.gradPForce, i, water.mass[i] * a);
                }
                set(water.a, i, a + at(water.friction, i) + scene_.g);
            }
        }
    );
}

void waterDynamics::accelerations()
{
    const passTimes::timed timing(times, "force");
    const lpfPairs::waterForcePass pass = forcePass();
    engine_.waterForce(pass);
    artificialPower_ = viscousPower_ = 0;
    if (pass.alpha > 0 || pass.eta)
    {
        artificialPower_ = sumOver(water.artificialPower(), water.size());
        viscousPower_ = sumOver(water.viscousPower(), water.size());
    }
    else
    {
        for (realArray& component : water.friction)
        {
            std::fill_n(component.data(), water.size(), 0.0);
        }
    }
    if (viscous_)
    {
        viscous_->setEta(eta_);
        if (!scheme_.implicitViscosity)
        {
            explicitViscosity(pass.alpha > 0);
        }
    }
    addForcesOfGround();
    if (resistance_)
    {
        resistOfGround();
    }
}

void waterDynamics::resistOfGround()
{
    const passTimes::timed pass(times, "friction of the ground");
    resistance_->update(
        {water.x, slot_, walls_, water.size()},
        [&](int i, const vector&) { return water.p[i]; },
        water.rho.data()
    );
}

void waterDynamics::explicitViscosity(bool add)
{
    const waterViscosity::totals sums = viscous_->accelerate(add);
    viscousPower_ = sums.power;
    stickForce_ = sums.ground;
}

namespace
{

//- What implicit viscosity adds to the ledger
struct viscousSums
{
    vector impulse = Zero;
    scalar work = 0;

    void operator+=(const viscousSums& b)
    {
        impulse += b.impulse;
        work += b.work;
    }
};

} // namespace

void waterDynamics::relaxViscosity(scalar dt)
{
    if (!viscous_ || !scheme_.implicitViscosity)
    {
        return;
    }
    viscous_->relax(dt);
    const viscousSums sums = orderedSum<viscousSums>(
        water.size(),
        [&](int i)
        {
            const vector dU = viscous_->added(i);
            const vector start = at(water.U, i) - dt * at(water.a, i);
            const vector artificial = dt * at(water.friction, i);
            return viscousSums{
                water.mass[i] * dU, lossBy(i, dU, start, artificial)};
        }
    );
    ledger.viscous += sums.work;
    if (viscous_->sticks())
    {
        // pairs add nothing to the sum: all of it is the ground's
        ledger.frictionImpulse += sums.impulse;
    }
}

void waterDynamics::rates(scalar dt, scalar time, stage where)
{
    arrange(time);
    divergence(dt, where);
    correct(dt, where);
    accelerations();
}

// The density of the middle gives the volumes there
void waterDynamics::keepState(scalar dt)
{
    phaseDynamics::keepState(dt);
    lpfPairs::forEach(
        water.size(),
        [&](int i)
        {
            const scalar quarter = 0.25 * dt * water.rhoStart[i];
            const scalar rho = water.rho[i];
            water.rhoStart[i] = rho;
            water.rho[i] = rho * (1 - quarter) / (1 + quarter);
        }
    );
}

void waterDynamics::goToEnd()
{
    phaseDynamics::goToEnd();
    std::swap(water.rho, water.rhoStart);
    if (withGrains_)
    {
        // of the velocity before the kick, as kicks take it
        lpfPairs::forEach(
            water.size(),
            [&](int i)
            {
                const vector back = at(water.U, i) - at(water.UStart, i);
                set(water.flux, i, at(water.flux, i) + water.theta[i] * back);
            }
        );
    }
}

namespace
{

//- What one kick adds to the ledger
struct kickSums
{
    vector gravity = Zero, wall = Zero, friction = Zero;
    scalar wallNormal = 0, correction = 0, frictionEnergy = 0, heat = 0;

    void operator+=(const kickSums& b)
    {
        gravity += b.gravity;
        wall += b.wall;
        friction += b.friction;
        wallNormal += b.wallNormal;
        correction += b.correction;
        frictionEnergy += b.frictionEnergy;
        heat += b.heat;
    }
};

} // namespace

// Flux of the volume over a kick, the part of the grains as before it
vector
waterDynamics::meanFlux(int i, const vector& before, const vector& after) const
{
    const vector half = 0.5 * (after - before);
    return withGrains_ ? vector(at(water.flux, i) + ownShare(i) * half)
                       : vector(before + half);
}

vector waterDynamics::correction(int i, const nearWall& near) const
{
    const scalar V = water.V[i] * scene_.planeThickness;
    return near.force - (images_ * V * water.p[i]) * toVector(near.areaNormal);
}

void waterDynamics::kick(scalar dt)
{
    const passTimes::timed pass(times, "kick");
    if (resistance_)
    {
        kickWith(
            dt,
            [&](int i, const vector& U, const nearWall& near)
            {
                const vector along = toVector(near.areaNormal);
                const vector n =
                    normalised(magSqr(near.force) > 0 ? near.force : along);
                const scalar dv = mag(near.force) * dt / water.mass[i];
                return resistance_->after(slot_[i], U, n, 0, dv, dt);
            }
        );
        return;
    }
    kickWith(dt, [](int, const vector& U, const nearWall&) { return U; });
}

void waterDynamics::pushOffGround(scalar dt)
{
    if (!penalty_)
    {
        return;
    }
    if (resistance_)
    {
        pushWith(
            dt,
            [&](int i, const vector& U, const vector& n, scalar dv)
            { return resistance_->after(slot_[i], U, n, 0, dv, 0); }
        );
        return;
    }
    pushWith(dt, [](int, const vector& U, const vector&, scalar) { return U; });
}

//- friction(i, U, near): the velocity that the ground leaves
template<class Friction>
void waterDynamics::kickWith(scalar dt, const Friction& friction)
{
    const kickSums sums = orderedSum<kickSums>(
        water.size(),
        [&](int i)
        {
            kickSums s;
            const vector before = at(water.U, i);
            vector U = before + at(water.a, i) * dt;
            s.gravity = water.mass[i] * dt * scene_.g;
            if (slot_[i] >= 0)
            {
                const nearWall& near =
                    near_[static_cast<std::size_t>(slot_[i])];
                s.wall = near.force * dt;
                s.wallNormal = mag(near.force) * dt;
                const vector dropped = dt * correction(i, near);
                s.correction = -(dropped & meanFlux(i, before, U));
                const vector sliding = U;
                U = friction(i, sliding, near);
                s.friction = water.mass[i] * (U - sliding);
                // at the mean velocity of the kick, as for grains
                s.frictionEnergy = -0.5 * (s.friction & (before + U));
                lost(
                    i,
                    (s.friction + ownShare(i) * dropped) / water.mass[i]
                        + dt * at(water.friction, i)
                );
            }
            set(water.U, i, U);
            // viscous and artificial force together, at that velocity, too
            s.heat = (-0.5 * dt * water.mass[i])
                   * (at(water.friction, i) & (before + U));
            return s;
        }
    );
    ledger.gravityImpulse += sums.gravity;
    ledger.wallImpulse += sums.wall;
    ledger.wallNormalImpulse += sums.wallNormal;
    ledger.wallTension += sums.correction;
    const scalar power = artificialPower_ + viscousPower_;
    const scalar share = power > 0 ? artificialPower_ / power : 0;
    ledger.artificial += share * sums.heat;
    ledger.viscous += (1 - share) * sums.heat;
    ledger.frictionImpulse += dt * stickForce_ + sums.friction;
    ledger.friction += sums.frictionEnergy;
}

void waterDynamics::takeDrag(realArrays<3>& dU, scalar sign, scalar dt)
{
    if (viscous_ && scheme_.implicitViscosity)
    {
        takeDragWith(
            dU,
            sign,
            dt,
            [&](int i)
            { return at(water.friction, i) + viscous_->added(i) / dt; }
        );
        return;
    }
    takeDragWith(dU, sign, dt, [&](int i) { return at(water.friction, i); });
}

timeStepLimit waterDynamics::stableDeltaT() const
{
    timeStepLimit limit = waveLimit(scheme_.CFL, state_.c0(), "sound");
    if (largestMu_ > 0 && !scheme_.implicitViscosity)
    {
        scalar viscous = 0.125 * sqr(scene_.h) * state_.rho0() / largestMu_;
        if (viscous_ && viscous_->sticks())
        {
            viscous /= 1 + 0.5 * viscous * viscous_->stiffest();
        }
        limit.take({viscous, "viscosity"});
    }
    return limit;
}

vector waterDynamics::wallForceSum() const
{
    if (penalty_)
    {
        return penaltyForce();
    }
    vector total = Zero;
    for (const nearWall& near : near_)
    {
        total += near.force;
    }
    return total;
}

scalar waterDynamics::storedEnergy(int i) const
{
    return water.mass[i] * state_.energy(water.rho[i]);
}

std::size_t waterDynamics::bytes() const
{
    return phaseDynamics::bytes() + near_.capacity() * sizeof(nearWall)
         + eta_.bytes() + fill_.bytes() + byGrains_.bytes() + passage_.bytes()
         + lpf::bytes(gradFill_) + lpf::bytes(strain_) + shearRate_.bytes()
         + (viscous_ ? viscous_->bytes() : 0)
         + (resistance_ ? resistance_->bytes() : 0);
}

} // namespace lpf
} // namespace Foam
