// SPDX-License-Identifier: GPL-3.0-or-later
// What the packing of the particles says of the density of water, and of where
// they should go.
#include "waterDynamics.H"

#include "fieldTensors.H"
#include "orderedSum.H"

namespace Foam
{
namespace lpf
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

namespace
{

//- Share of a kernel that a lattice behind a plane would fill, from that of the
//  solid, to 0.4 %
scalar latticeShare(scalar gam)
{
    constexpr scalar excess = 0.02;
    return gam - excess * gam / (gam + excess);
}

scalar between0and1(scalar a)
{
    return min(scalar(1), max(scalar(0), a));
}

} // namespace

//     S = sum V W + l(gam) + l(gam')                                (T 5.13)
// gam' beyond the free surface
waterDynamics::packing waterDynamics::packingAt(int i) const
{
    packing s = {0, 0, at(gradFill_, i)};
    scalar gam = 0;
    if (slot_[i] >= 0)
    {
        const auto slot = static_cast<std::size_t>(slot_[i]);
        s.gradient -= toVector(near_[slot].areaNormal);
        gam = max(scalar(0), walls_[slot].share);
    }
    const scalar ratio =
        scene_.h * mag(s.gradient) / max(fill_[i] + gam, SMALL);
    s.beyond = surface_.beyond(ratio);
    s.S = fill_[i] + latticeShare(gam) + latticeShare(s.beyond); // (T 5.13)
    return s;
}

// The density of particles that moved far drifts from how they are packed. It
// goes back to that slowly, faster where the flow deforms: a rate [1/s] of
//     kappa (c0/h + 100 (|div| + |curl|)) g(S) (S/S_lattice - 1),
// g from 0 at S = 0.6 to 1 at 0.8                                    (T 5.14)
scalar waterDynamics::relaxation(int i) const
{
    constexpr scalar from = 0.6, to = 0.8, byDeformation = 100;
    const scalar S = packingAt(i).S;
    const scalar g = between0and1((S - from) / (to - from));
    const scalar rate = state_.c0() / scene_.h
                      + byDeformation * (mag(water.rate[i]) + water.curl[i]);
    return scheme_.densityRelaxation * rate * g * (S / latticeFill_ - 1);
}

// Towards where there are fewer particles, in the depth of the water:
//     v_s = - A (c0/10) h gradS (1 - 10 gam') (P/(rho0 |g| h) - 1),
// both brackets within 0 and 1                                       (T 5.23)
vector waterDynamics::shiftVelocity(int i) const
{
    constexpr scalar surfaceShare = 0.1, shallow = 1, Mach = 0.1;
    const scalar head = water.p[i] / (state_.rho0() * mag(scene_.g) * scene_.h);
    if (head <= shallow)
    {
        return Zero;
    }
    const packing s = packingAt(i);
    const scalar fade = between0and1(1 - s.beyond / surfaceShare)
                      * between0and1(head - shallow);
    return (-scheme_.shifting * Mach * state_.c0() * scene_.h * fade)
         * s.gradient;
}

// x <- x + dt v_s,  rho <- rho + rho0 g.(dt v_s)/c0^2: the pressure of the new
// depth. What that does to the energy is booked.
void waterDynamics::shift(scalar dt)
{
    const vector perLength = (state_.rho0() / sqr(state_.c0())) * scene_.g;
    ledger.shifting +=
        orderedSum<sumOf<scalar>>(
            water.size(),
            [&](int i)
            {
                const vector d = dt * shiftVelocity(i);
                const scalar before = storedEnergy(i);
                set(water.x, i, at(water.x, i) + d);
                water.rho[i] += perLength & d;
                return sumOf<scalar>{
                    water.mass[i] * (scene_.g & d) + before - storedEnergy(i)};
            }
        ).value;
}

void waterDynamics::drift(scalar dt, scalar time)
{
    if (scheme_.shifting > 0)
    {
        shift(dt);
    }
    phaseDynamics::drift(dt, time);
}

} // namespace lpf
} // namespace Foam
