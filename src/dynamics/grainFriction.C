// SPDX-License-Identifier: GPL-3.0-or-later
// Friction of the ground on the velocity that the grains have at it, and its
// adjoint: `grains { frictionAt ground; }` of system/lpfSolution.
#include "grainDynamics.H"

#include "fieldTensors.H"

namespace Foam
{
namespace lpf
{

using Vec3 = lpfPairs::Vec<double>;

// The stress whose divergence leads the traction on into the grains
lpfPairs::Tensor<double> grainDynamics::ledOn(int i) const
{
    const auto slot = static_cast<std::size_t>(slot_[i]);
    const atGround& here = atGround_[slot];
    const double V = grains.V[i] * scene_.planeThickness;
    return (here.depth / V) * outer(here.t, near_[slot].n); // (T 4.24)
}

// Along the ground, led on to it over the distance d of the grain,
//     u_0 = (I - n n)(v - d P R B_p n)                               (T 4.22)
Vec3 grainDynamics::velocityAtGround(int i) const
{
    const auto slot = static_cast<std::size_t>(slot_[i]);
    const atGround& here = atGround_[slot];
    const Vec3& n = near_[slot].n;
    const Vec3 u = vecAt(grains.U, i) - here.depth * here.shear;
    return u - (u & n) * n;
}

// Of a layer of grains one smoothing length thick
//     k = m (c/h)^2                                                  (T 4.23)
scalar grainDynamics::stiffnessOfGround(int i) const
{
    return grains.mass[i] * sqr(rheology_.elastic().c() / scene_.h);
}

scalar grainDynamics::energyOfTraction(int i) const
{
    return 0.5 * magSqr(at(grains.traction, i)) / stiffnessOfGround(i);
}

// The second half of the last kick had it still
scalar grainDynamics::letGo(int i, scalar dt, stage where)
{
    const vector t = at(grains.traction, i);
    const scalar half = where == stage::whole ? 0.5 * dt : 0;
    const scalar lost = energyOfTraction(i) - half * (t & at(grains.U, i));
    set(grains.traction, i, vector(Zero));
    return lost;
}

// The traction follows the slip as a spring does, as far as friction goes,
//     t <- t - dt k u_0,  |t| <= mu (1 - r_u) N                      (T 4.23)
// In the middle of a step the forces have that of the middle. The loss is the
// work of the mean traction of the step, as the leapfrog does it, that the
// spring does not keep
scalar grainDynamics::holdAtGround(int i, scalar dt, stage where)
{
    if (slot_[i] < 0)
    {
        return letGo(i, dt, where);
    }
    const auto slot = static_cast<std::size_t>(slot_[i]);
    const nearWall& near = near_[slot];
    Vec3& acting = atGround_[slot].t;
    acting = {0, 0, 0};
    if (!near.carried)
    {
        return letGo(i, dt, where);
    }
    const scalar most = near.friction * std::sqrt(magSqr(near.f));
    const Vec3 u = velocityAtGround(i);
    const Vec3 before = vecAt(grains.traction, i);
    const auto after = [&](scalar time)
    {
        Vec3 t = before - (time * stiffnessOfGround(i)) * u;
        t = t - (t & near.n) * near.n;
        const scalar size = std::sqrt(magSqr(t));
        return size > most ? (most / size) * t : t;
    };
    const scalar stored = energyOfTraction(i);
    const Vec3 end = after(dt);
    const bool middle = where == stage::middle;
    acting = middle ? after(0.5 * dt) : end;
    set(grains.traction, i, toVector(end));
    const Vec3 mean = middle ? acting : 0.5 * (before + end);
    return -dt * (mean & u) - (energyOfTraction(i) - stored);
}

} // namespace lpf
} // namespace Foam
