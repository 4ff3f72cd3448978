// SPDX-License-Identifier: GPL-3.0-or-later
#include "grainDynamics.H"

#include "coulomb.H"
#include "fieldTensors.H"
#include "frictionalRheology.H"
#include "latticeSums.H"
#include "momentInverse.H"
#include "pairTerms.H"

namespace Foam
{
namespace lpf
{

namespace
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

//- planarity (I - n n)
Tens tangential(double planarity, const Vec3& n)
{
    const Symm nn = dyad(-planarity, n);
    return {
        {planarity + nn.xx, nn.xy, nn.xz},
        {nn.xy, planarity + nn.yy, nn.yz},
        {nn.xz, nn.yz, planarity + nn.zz}};
}

} // namespace

grainDynamics::grainDynamics(
    const lpfPairs::pairEngine& engine,
    const sceneProperties& scene,
    const schemeProperties& scheme,
    const granularRheology& rheology,
    groundContact& contact,
    bool wet
)
    : phaseDynamics(engine, scene, contact, grains), scheme_(scheme),
      rheology_(rheology), wet_(wet),
      resistance_(
          groundResistance::forPhase(contact, scene_, &groundZone::grains)
      ),
      latticeFill_(lpfPairs::latticeFill(
          lpfPairs::wendlandC2(scene.h, scene.dimensions),
          scene.spacing,
          scene.dimensions
      )),
      surface_(wet ? new lpfPairs::surfaceShare(scene.dimensions) : nullptr),
      grains(wet, scheme.frictionAtGround)
{
    penalty_ = penaltyGround::forPhase(
        engine, scene_, contact, rheology.elastic().c()
    );
}

void grainDynamics::densityFromPressure()
{
    for (int i = 0; i < grains.size(); ++i)
    {
        grains.rho[i] =
            grains.rhoRef[i]
            * (1 + pressureAt(i) / rheology_.elastic().K()); // (T 3.4)
    }
}

void grainDynamics::volumes()
{
    const int n = grains.size();
    lpfPairs::forEach(
        n,
        [&](int i) {
            grains.V[i] =
                grains.mass[i] / (grains.rho[i] * scene_.planeThickness);
        }
    );
    grains.V.pad(n, 0);
    grains.rho.pad(n, 1);
}

lpfPairs::kinematicsPass grainDynamics::kinematicsPass() const
{
    auto p = overPairs<lpfPairs::kinematicsPass>();
    p.u = grains.U[0].data();
    p.v = grains.U[1].data();
    p.w = grains.U[2].data();
    return p;
}

lpfPairs::forcePass grainDynamics::forcePass()
{
    auto p = overPairs<lpfPairs::forcePass>();
    p.thickness = scene_.planeThickness;
    p.m = grains.mass.data();
    for (std::size_t c = 0; c < 9; ++c)
    {
        p.A[c] = grains.L[c].data();
    }
    p.ax = grains.a[0].data();
    p.ay = grains.a[1].data();
    p.az = grains.a[2].data();

    p.alpha = scheme_.artificialViscosity;
    p.beta = scheme_.noiseDamping;
    if (scheme_.viscous())
    {
        viscousPower_.resize(grains.size());
        p.soundSpeed = rheology_.elastic().c();
        p.u = grains.U[0].data();
        p.v = grains.U[1].data();
        p.w = grains.U[2].data();
        p.rho = grains.rho.data();
        p.viscousPower = viscousPower_.data();
    }
    for (std::size_t c = 0; p.beta > 0 && c < 9; ++c)
    {
        p.L[c] = flow_[c].data();
    }
    return p;
}

// Near the ground the velocity field is continued behind each surface element
// q by its mirror image, v - 2 (v.n_q) n_q, at the places of a lattice:
//     L = (R + 2 sum_q A E (v.n) n n) B,  B^-1 = M + sum_q A D n n     (T 4.3)
// A uniform stress then gives no force beside a plane.
// Along a plane the tangential rows are taken from the grains alone,
//     L_t = (I - n n) R B_p,  B_p^-1 = M,                              (T 4.4)
// for the mirror would halve the shear of a layer that slides.
void grainDynamics::gradient()
{
    const passTimes::timed pass(times, "velocity gradient");
    if (penalty_)
    {
        gradientWith([&](int i, const Tens& R, const Symm& M)
                     { gradientOfGrainsAlone(i, R, M); });
        return;
    }
    byFriction(
        [&](auto held)
        {
            gradientWith([&](int i, const Tens& R, const Symm& M)
                         { gradientNearGround<held()>(i, R, M); });
        }
    );
}

//- nearGround(i, R, M) for the grains that are
template<class NearGround>
void grainDynamics::gradientWith(const NearGround& nearGround)
{
    lpfPairs::forChunks(
        grains.size(),
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                const Tens R = tensorAt(grains.L, i);
                Symm M = symmAt(grains.B, i);
                M += acrossPlane_;
                if (slot_[i] >= 0)
                {
                    nearGround(i, R, M);
                }
                else
                {
                    setGradient(i, momentInverse(M), R);
                }
            }
        }
    );
}

void grainDynamics::setGradient(int i, const Symm& B, const Tens& R)
{
    setSymm(grains.B, i, B);
    setTensor(grains.L, i, R & full(B));
}

grainDynamics::nearWall& grainDynamics::lookAtGround(int i, const Symm& M)
{
    const auto slot = static_cast<std::size_t>(slot_[i]);
    const lpfPairs::wallRecord& wall = walls_[slot];
    nearWall& near = near_[slot];
    const Vec3 nA = contracted(thirdMoment(wall));
    const double magnitude = std::sqrt(magSqr(nA));
    near.n = magnitude > 0 ? (1 / magnitude) * nA : Vec3{0, 0, 1};
    near.planarity =
        wall.area > 0 ? std::max(0.0, 10 * magnitude / wall.area - 9) : 0;
    near.friction = wall.area > 0 ? wall.friction / wall.area : 0;
    near.Bp = momentInverse(M);
    return near;
}

// Behind a penalty there is no material
void grainDynamics::gradientOfGrainsAlone(int i, const Tens& R, const Symm& M)
{
    nearWall& near = lookAtGround(i, M);
    near.closed = false;
    setGradient(i, near.Bp, R);
}

template<bool frictionAtGround>
void grainDynamics::gradientNearGround(int i, const Tens& R, const Symm& M)
{
    nearWall& near = lookAtGround(i, M);
    const lpfPairs::wallRecord& wall =
        walls_[static_cast<std::size_t>(slot_[i])];
    const Vec3 v = vecAt(grains.U, i);
    const auto N3 = thirdMoment(wall);

    // the ground neither holds a grain back nor stretches it: in tension it
    // is not there for a grain that moves away
    const Tens sigma = full(symmAt(grains.sigma, i));
    const bool tension = ((N3 && sigma) & near.n) > 0;
    near.closed = !(tension && (v & near.n) > 0);
    if (!near.closed)
    {
        setGradient(i, near.Bp, R);
        return;
    }

    const Symm B = momentInverse(M + secondMoment(wall));
    const Symm Nv = N3 & v;
    const Tens mirrored = (R + full(Nv + Nv)) & full(B); // (T 4.3)
    const Tens P = tangential(near.planarity, near.n);
    const Tens own = R & full(near.Bp);
    if constexpr (frictionAtGround)
    {
        const double d = std::clamp(wall.distance, 0.0, 2 * scene_.h);
        atGround_[static_cast<std::size_t>(slot_[i])] = {
            {0, 0, 0}, P & (own & near.n), d};
    }
    setSymm(grains.B, i, B);
    setTensor(grains.L, i, mirrored + (P & (own - mirrored))); // (T 4.4)
}

double grainDynamics::pressureAt(int i) const
{
    return -(grains.sigma[0][i] + grains.sigma[3][i] + grains.sigma[5][i]) / 3;
}

namespace
{

//- Powers [W] and losses [J] of stressMoment()
struct momentSums
{
    scalar damping = 0, friction = 0;

    void operator+=(const momentSums& b)
    {
        damping += b.damping;
        friction += b.friction;
    }
};

} // namespace

// The adjoint of gradient():
//     A = (I - P) sigma B + P sigma B_p                              (T 3.12)
//     f_ground = - 2 V sum_q A E (n.(I - P) sigma B.n) n             (T 4.5)
void grainDynamics::stressMoment(scalar dt, stage where)
{
    const passTimes::timed pass(times, "stress moment");
    byFriction(
        [&](auto held)
        {
            if (scheme_.shearDamping > 0)
            {
                stressMomentWith<held()>(
                    dt,
                    where,
                    [&](int i)
                    { return bulkDampingAt(i) + symmAt(shearDamping_, i); }
                );
                return;
            }
            stressMomentWith<held()>(
                dt, where, [&](int i) { return bulkDampingAt(i); }
            );
        }
    );
    padZero(grains.L, grains.size());
}

//- damping(i): the stress that damps waves
template<bool frictionAtGround, class Damping>
void grainDynamics::stressMomentWith(
    scalar dt, stage where, const Damping& damping
)
{
    const momentSums sums = orderedSum<momentSums>(
        grains.size(),
        [&](int i)
        {
            const Symm damped = damping(i);
            const Symm sigma = symmAt(grains.sigma, i) + damped;
            momentSums s;
            s.damping =
                granularRheologies::inner(damped, symm(tensorAt(grains.L, i)))
                * grains.V[i] * scene_.planeThickness;
            forceOfGround(i, full(sigma));
            if constexpr (frictionAtGround)
            {
                s.friction = holdAtGround(i, dt, where);
            }
            stressMomentOf<frictionAtGround>(i, full(sigma));
            return s;
        }
    );
    dampingPower_ = sums.damping;
    ledger.friction += sums.friction;
}

void grainDynamics::forceOfGround(int i, const Tens& sigma)
{
    if (slot_[i] < 0)
    {
        return;
    }
    const auto slot = static_cast<std::size_t>(slot_[i]);
    nearWall& near = near_[slot];
    near.f = {0, 0, 0};
    near.carried = false;
    if (near.closed)
    {
        const Tens P = tangential(near.planarity, near.n);
        const Tens sigmaB = sigma & full(symmAt(grains.B, i));
        near.f = (-2 * grains.V[i] * scene_.planeThickness)
               * (thirdMoment(walls_[slot]) && (sigmaB - (P & sigmaB)));
        near.carried = (near.f & near.n) > 0; // (T 4.5)
    }
}

template<bool frictionAtGround>
void grainDynamics::stressMomentOf(int i, const Tens& sigma)
{
    const Tens sigmaB = sigma & full(symmAt(grains.B, i));
    if (slot_[i] < 0)
    {
        setTensor(grains.L, i, sigmaB);
        return;
    }
    const auto slot = static_cast<std::size_t>(slot_[i]);
    const nearWall& near = near_[slot];
    if (!near.closed)
    {
        setTensor(grains.L, i, sigmaB);
        return;
    }
    const Tens P = tangential(near.planarity, near.n);
    Tens led = sigma;
    if constexpr (frictionAtGround)
    {
        led = led + ledOn(i);
    }
    setTensor(
        grains.L,
        i,
        sigmaB - (P & sigmaB) + (P & led & full(near.Bp)) // (T 3.12)
    );
}

// stressMoment() puts A in the place of L
void grainDynamics::keepFlow()
{
    const int n = grains.size();
    lpf::resize(flow_, n);
    lpfPairs::forEach(
        n, [&](int i) { setTensor(flow_, i, tensorAt(grains.L, i)); }
    );
}

template<bool frictionAtGround>
void grainDynamics::addGroundAndGravity()
{
    lpfPairs::forEach(
        grains.size(),
        [&](int i)
        {
            vector a = at(grains.a, i) + scene_.g;
            const auto slot =
                static_cast<std::size_t>(slot_[i] >= 0 ? slot_[i] : 0);
            if (slot_[i] >= 0 && near_[slot].carried)
            {
                Vec3 f = near_[slot].f;
                if constexpr (frictionAtGround)
                {
                    f = f + atGround_[slot].t;
                }
                a += toVector(f) / grains.mass[i];
            }
            set(grains.a, i, a);
        }
    );
}

void grainDynamics::rates(scalar dt, scalar time, stage where)
{
    ++evaluations_;
    updateGround(time);
    sort();
    volumes();

    kinematics();
    seeGround(seesPacking());
    renew(near_, walls_.size());
    renew(atGround_, scheme_.frictionAtGround ? walls_.size() : 0);
    gradient();
    if (wet_)
    {
        seeSurface();
    }
    advanceStress(dt, where);
    if (resistance_)
    {
        resistOfGround();
    }

    if (scheme_.noiseDamping > 0)
    {
        keepFlow();
    }
    stressMoment(dt, where);
    forces();
}

bool grainDynamics::smoothsState() const
{
    return scheme_.seesPacking() || scheme_.stressDiffusion > 0;
}

//- What changes density and stress besides the flow
void grainDynamics::smoothState(scalar dt)
{
    if (scheme_.seesPacking())
    {
        followPacking(dt);
    }
    if (scheme_.stressDiffusion > 0)
    {
        diffuseStressWhenDue(dt);
    }
}

// In the middle of a step stress and density go on twice from the start, over
// dt, which is booked, and over half of it, for the forces; both by the L of
// the middle. keepState() has both at the start
void grainDynamics::advanceStress(scalar dt, stage where)
{
    if (where == stage::start)
    {
        keepDensityRate();
        dampShearAtOnce();
        smoothState(dt);
        stress(dt);
        return;
    }
    if (where == stage::whole)
    {
        smoothState(dt);
        keepTurnedShear(grains.sigma, dt);
        stress(dt);
        dampShear(grains.sigma, grains.rho, dt);
        return;
    }
    std::swap(grains.rho, grains.rhoStart);
    grains.rhoStart = grains.rho;
    smoothState(dt);
    if (smoothsState())
    {
        const auto halfway = [](realArray& start, const realArray& end, int i)
        { start[i] = 0.5 * (start[i] + end[i]); };
        lpfPairs::forEach(
            grains.size(),
            [&](int i)
            {
                halfway(grains.rhoStart, grains.rho, i);
                for (std::size_t c = 0; c < 6; ++c)
                {
                    halfway(grains.sigmaStart[c], grains.sigma[c], i);
                }
            }
        );
    }
    keepTurnedShear(grains.sigmaStart, 0.5 * dt);
    rheology_.correct(
        arraysOf(grains.sigmaStart, grains.rhoStart, grains.rhoRefStart),
        0.5 * dt
    );
    dampShear(grains.sigmaStart, grains.rhoStart, 0.5 * dt);
    turnStrainRate(0.5 * dt);
    stress(dt);
    turnStrainRate(-0.5 * dt);
    swapState();
    grains.rho.pad(grains.size(), 1);
}

// L <- skew L + Q (symm L) Q^T, Q the rotation of (T 3.6) over dt: what is
// strained in a step turns with the grains for half of it, on average, which
// (T 3.6) alone has at first order only                              (T 7.3)
void grainDynamics::turnStrainRate(scalar dt)
{
    lpfPairs::forEach(
        grains.size(),
        [&](int i)
        {
            const Tens L = tensorAt(grains.L, i);
            const Symm D = symm(L);
            setTensor(
                grains.L,
                i,
                L + full(granularRheologies::rotated(D, L, dt)) - full(D)
            ); // (T 7.3)
        }
    );
}

// rhoStart is free until keepState()
void grainDynamics::keepDensityRate()
{
    lpfPairs::forEach(
        grains.size(),
        [&](int i) {
            grains.rhoStart[i] =
                grains.L[0][i] + grains.L[4][i] + grains.L[8][i];
        }
    );
}

// The density of the middle gives the volumes there
void grainDynamics::keepState(scalar dt)
{
    phaseDynamics::keepState(dt);
    grains.sigmaStart = grains.sigma;
    grains.rhoRefStart = grains.rhoRef;
    lpfPairs::forEach(
        grains.size(),
        [&](int i)
        {
            const scalar quarter = 0.25 * dt * grains.rhoStart[i];
            const scalar rho = grains.rho[i];
            grains.rhoStart[i] = rho;
            grains.rho[i] = rho * (1 - quarter) / (1 + quarter);
        }
    );
}

void grainDynamics::swapState()
{
    std::swap(grains.sigma, grains.sigmaStart);
    std::swap(grains.rho, grains.rhoStart);
    std::swap(grains.rhoRef, grains.rhoRefStart);
}

void grainDynamics::driftOn(scalar dt, scalar time)
{
    swapState();
    phaseDynamics::driftOn(dt, time);
}

void grainDynamics::kinematics()
{
    const passTimes::timed pass(times, "kinematics");
    lpfPairs::kinematicsPass k = kinematicsPass();
    for (std::size_t c = 0; c < 9; ++c)
    {
        k.R[c] = grains.L[c].data();
    }
    for (std::size_t c = 0; c < 6; ++c)
    {
        k.M[c] = grains.B[c].data();
    }
    if (seesPacking())
    {
        fill_.resize(grains.size());
        lpf::resize(gradFill_, grains.size());
        k.m = grains.mass.data();
        k.fill = fill_.data();
        for (std::size_t c = 0; c < 3; ++c)
        {
            k.gradFill[c] = gradFill_[c].data();
        }
        k.thickness = scene_.planeThickness;
    }
    engine_.kinematics(k);
}

grainArrays
grainDynamics::arraysOf(realArrays<6>& sigma, realArray& rho, realArray& rhoRef)
{
    grainArrays arrays = {};
    arrays.n = grains.size();
    for (std::size_t c = 0; c < 9; ++c)
    {
        arrays.L[c] = grains.L[c].data();
    }
    for (std::size_t c = 0; c < 6; ++c)
    {
        arrays.sigma[c] = sigma[c].data();
    }
    arrays.rho = rho.data();
    arrays.rhoRef = rhoRef.data();
    arrays.mass = grains.mass.data();
    arrays.inertialNumber = grains.I.data();
    return arrays;
}

void grainDynamics::stress(scalar dt)
{
    const passTimes::timed pass(times, "stress");
    rates_ = rheology_.correct(
        arraysOf(grains.sigma, grains.rho, grains.rhoRef), dt
    );
    ledger.plastic += rates_.plastic;
    ledger.separation += rates_.separation;
}

void grainDynamics::forces()
{
    const passTimes::timed pass(times, "force");
    engine_.force(forcePass());
    if (scheme_.viscous())
    {
        viscousPowerSum_ =
            orderedSum<sumOf<double>>(
                grains.size(),
                [&](int i) { return sumOf<double>{viscousPower_[i]}; }
            ).value;
    }
    byFriction([&](auto held) { addGroundAndGravity<held()>(); });
}

namespace
{

//- What one kick adds to the ledger
struct kickSums
{
    vector gravity = Zero, wall = Zero, friction = Zero;
    scalar wallNormal = 0, frictionEnergy = 0, tension = 0;

    void operator+=(const kickSums& b)
    {
        gravity += b.gravity;
        wall += b.wall;
        friction += b.friction;
        wallNormal += b.wallNormal;
        frictionEnergy += b.frictionEnergy;
        tension += b.tension;
    }
};

} // namespace

void grainDynamics::resistOfGround()
{
    const passTimes::timed pass(times, "friction of the ground");
    resistance_->update(
        {grains.x, slot_, walls_, grains.size()},
        [&](int i, const vector& n)
        {
            const Vec3 m = toVec(n);
            return max(scalar(0), -(m & (full(symmAt(grains.sigma, i)) & m)));
        },
        grains.rho.data()
    );
}

void grainDynamics::kick(scalar dt)
{
    const passTimes::timed pass(times, "kick");
    byFriction(
        [&](auto held)
        {
            if (resistance_)
            {
                kickWith<held()>(
                    dt,
                    [&](int i,
                        const vector& U,
                        const vector& n,
                        scalar dry,
                        scalar dv)
                    { return resistance_->after(slot_[i], U, n, dry, dv, dt); }
                );
                return;
            }
            kickWith<held()>(
                dt,
                [](int, const vector& U, const vector& n, scalar dry, scalar)
                { return afterFriction(U, n, dry); }
            );
        }
    );
}

//- friction(i, U, n, mu N dt/m, N dt/m): the velocity that it leaves
template<bool frictionAtGround, class Friction>
void grainDynamics::kickWith(scalar dt, const Friction& friction)
{
    const kickSums sums = orderedSum<kickSums>(
        grains.size(),
        [&](int i)
        {
            kickSums s;
            const scalar m = grains.mass[i];
            const vector before = at(grains.U, i);
            vector U = before + at(grains.a, i) * dt;
            s.gravity = m * dt * scene_.g;

            if (slot_[i] >= 0)
            {
                const auto slot = static_cast<std::size_t>(slot_[i]);
                const nearWall& near = near_[slot];
                const vector f = toVector(near.f);
                const vector sliding = U;
                if (near.carried)
                {
                    const scalar N = mag(f);
                    const scalar mu = frictionAtGround ? 0 : near.friction;
                    U = friction(
                        i, sliding, f / N, mu * N * dt / m, N * dt / m
                    );
                    s.wall = f * dt;
                    s.wallNormal = N * dt;
                }
                else
                {
                    U = friction(i, sliding, toVector(near.n), 0, 0);
                    s.tension = 0.5 * dt * (f & (before + sliding));
                }
                s.friction = m * (U - sliding);
                // at the mean velocity of the kick: none where it sticks
                s.frictionEnergy = -0.5 * (s.friction & (before + U));
                const vector tension = near.carried ? Zero : dt * f;
                lost(i, (s.friction - tension) / m);
                if constexpr (frictionAtGround)
                {
                    s.friction +=
                        dt * toVector(atGround_[slot].t); // its loss is booked
                }
            }
            set(grains.U, i, U);
            return s;
        }
    );

    ledger.gravityImpulse += sums.gravity;
    ledger.wallImpulse += sums.wall;
    ledger.wallNormalImpulse += sums.wallNormal;
    ledger.frictionImpulse += sums.friction;
    ledger.friction += sums.frictionEnergy;
    ledger.wallTension += sums.tension;
    ledger.artificial += (viscousPowerSum_ + dampingPower_) * dt;
}

void grainDynamics::takeDrag(realArrays<3>& dU, scalar sign, scalar dt)
{
    takeDragWith(dU, sign, dt, [](int) { return vector(Zero); });
}

grainPoint grainDynamics::pointAt(int i) const
{
    return {
        tensorAt(grains.L, i),
        symmAt(grains.sigma, i),
        grains.rho[i],
        grains.rhoRef[i],
        grains.mass[i],
        grains.I[i]};
}

timeStepLimit grainDynamics::stableDeltaT() const
{
    timeStepLimit limit =
        waveLimit(scheme_.CFL, rheology_.elastic().c(), "elastic");
    if (rates_.maxStrainRate > 0)
    {
        limit.take({0.2 / rates_.maxStrainRate, "strain"});
    }
    // explicit, as viscosity
    const scalar damping =
        scheme_.noiseDamping + scheme_.bulkDamping + 2 * scheme_.shearDamping;
    if (damping > 0)
    {
        const scalar perWave = scene_.h / rheology_.elastic().c();
        limit.take({0.6 * perWave / damping, "damping"}); // (T 7.6)
    }
    return limit;
}

// Coulomb friction by the mean over the elements, as of (T 4.6); terms that go
// with the speed act in the kick, as they do beside any ground
void grainDynamics::pushOffGround(scalar dt)
{
    if (!penalty_)
    {
        return;
    }
    const auto dry = [&](int i, scalar dv)
    { return near_[static_cast<std::size_t>(slot_[i])].friction * dv; };
    if (resistance_)
    {
        pushWith(
            dt,
            [&](int i, const vector& U, const vector& n, scalar dv)
            { return resistance_->after(slot_[i], U, n, dry(i, dv), dv, 0); }
        );
        return;
    }
    pushWith(
        dt,
        [&](int i, const vector& U, const vector& n, scalar dv)
        { return afterFriction(U, n, dry(i, dv)); }
    );
}

vector grainDynamics::wallForceSum() const
{
    if (penalty_)
    {
        return penaltyForce();
    }
    vector total = Zero;
    for (const nearWall& near : near_)
    {
        if (near.carried)
        {
            total += toVector(near.f);
        }
    }
    return total;
}

scalar grainDynamics::groundFriction(label zone) const
{
    return contact_.effectiveFriction(zone);
}

scalar grainDynamics::storedEnergy(int i) const
{
    return rheology_.storedEnergy(pointAt(i))
         + (scheme_.frictionAtGround ? energyOfTraction(i) : 0);
}

std::size_t grainDynamics::bytes() const
{
    return phaseDynamics::bytes() + near_.capacity() * sizeof(nearWall)
         + atGround_.capacity() * sizeof(atGround) + viscousPower_.bytes()
         + lpf::bytes(flow_) + lpf::bytes(shearDamping_) + fill_.bytes()
         + lpf::bytes(gradFill_) + lpf::bytes(gradSigma_) + lpf::bytes(jumps_)
         + takesPart_.bytes() + beneath_.bytes()
         + (resistance_ ? resistance_->bytes() : 0);
}

} // namespace lpf
} // namespace Foam
