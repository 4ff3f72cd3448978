// SPDX-License-Identifier: GPL-3.0-or-later
// What the packing of the particles says of the density of water, and of where
// they should go.
#include "waterDynamics.H"

#include "fieldTensors.H"
#include "latticeSums.H"
#include "orderedSum.H"

#include <algorithm>

namespace Foam
{
namespace lpf
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

void waterDynamics::takePacking(lpfPairs::waterContinuityPass& pass)
{
    if (keepsPacking())
    {
        fill_.resize(water.size());
        lpf::resize(gradFill_, water.size());
    }
    realArrays<3>& gradient = keepsPacking() ? gradFill_ : water.friction;
    pass.fill = (keepsPacking() ? fill_ : water.a[0]).data();
    for (std::size_t c = 0; c < 3; ++c)
    {
        pass.gradFill[c] = gradient[c].data();
    }
}

//     S = sum V W + l(gam) + l(gam')                                (T 5.13)
// gam' beyond the free surface
waterDynamics::packing waterDynamics::packingAt(int i) const
{
    packing s = {0, 0, at(gradFill(), i)};
    scalar gam = 0;
    if (slot_[i] >= 0)
    {
        const auto slot = static_cast<std::size_t>(slot_[i]);
        s.gradient -= toVector(near_[slot].areaNormal);
        gam = max(scalar(0), walls_[slot].share);
    }
    const scalar ratio =
        scene_.h * mag(s.gradient) / max(fill()[i] + gam, SMALL);
    s.beyond = surface_.beyond(ratio);
    s.S = fill()[i] + lpfPairs::latticeShare(gam)
        + lpfPairs::latticeShare(s.beyond); // (T 5.13)
    return s;
}

// The density of particles that moved far drifts from how they are packed. It
// goes back to that slowly, faster where the flow deforms: a rate [1/s] of
//     kappa (c0/h + 100 (|div| + |curl|)) g(S) (S/S_lattice - 1),
// g from 0 at S = 0.6 to 1 at 0.8                                    (T 5.14)
scalar waterDynamics::excess(int i, const packing& s) const
{
    constexpr scalar from = 0.6, to = 0.8;
    constexpr scalar slope = 1 / (to - from);
    const scalar g = std::clamp((s.S - from) * slope, 0.0, 1.0);
    return g * (s.S / fillOfLattice(i) - 1);
}

scalar waterDynamics::relaxation(int i) const
{
    constexpr scalar byDeformation = 100;
    const scalar rate = soundRate_ + byDeformation * deformation(i);
    return scheme_.densityRelaxation * rate;
}

// That of a lattice whose particles fill V each, linear in V          (T 5.13)
scalar waterDynamics::fillOfLattice(int i) const
{
    return latticeFill_
         + (water.V[i] * perPlaceOfLattice_ - 1)
               * (wideLatticeFill_ - latticeFill_);
}

scalar waterDynamics::deformation(int i) const
{
    return mag(water.rate[i]) + water.curl[i];
}

// Among grains the grains tell (T 6.17): their part in what is said
scalar waterDynamics::shareOfGrains(int i) const
{
    constexpr scalar few = 0.1;
    return min(scalar(1), (1 / water.theta[i] - 1) / few);
}

scalar waterDynamics::drawnBack(int i)
{
    const packing s = packingAt(i);
    if (!withGrains_)
    {
        return relaxation(i) * excess(i, s);
    }
    const scalar b = shareOfGrains(i) * inTheDepth(s);
    byGrains_[i] = deformation(i) * b;
    return ((1 - b) * relaxation(i) + passage_[i]) * excess(i, s);
}

// Where grains come or go, the shares of their volume (T 6.1) and the flux of
// it (T 6.3) do not change a place alike. What that leaves goes as it is made:
//     rho <- rho (1 + N |dm/theta| a g(S) (S/S_lattice - 1))         (T 6.22)
//     dm = dt |v_p - v|/(4 h) (theta - m),  v_p - v = (q - v)/(1 - theta)
// m the mean of theta over the grains that passed by, from pore to pore the
// same; slower than sound: a density that is tied to the packing makes energy;
// a = 1 - 10 gam, not beside ground, where layers are no lattice
void waterDynamics::seePassage(scalar dt)
{
    constexpr scalar byPassage = 10, ofSound = 0.1, few = 0.01;
    const int n = water.size();
    passage_.resize(n);
    if (!(dt > 0))
    {
        std::fill_n(passage_.data(), n, 0.0);
        return;
    }
    const scalar fastest = ofSound * soundRate_;
    const scalar across = 4 * scene_.h;
    lpfPairs::forEach(
        n,
        [&](int i)
        {
            const scalar theta = water.theta[i];
            scalar& mean = water.meanTheta[i];
            mean = mean > 0 ? mean : theta; // 0: the first step of all
            const scalar slip =
                mag(at(water.flux, i) - at(water.U, i)) / max(1 - theta, few);
            const scalar change =
                min(scalar(1), dt * slip / across) * (theta - mean);
            mean += change;
            const scalar rate = byPassage / dt * mag(change) / theta;
            const scalar away = 1 - std::clamp(10 * groundShare(i), 0.0, 1.0);
            passage_[i] = away * min(fastest, rate);
        }
    );
}

// rho <- rho (1 + dt rate e_a)                                      (T 6.17)
void waterDynamics::relaxByGrains(const realArray& excess, scalar dt)
{
    ledger.diffusion +=
        orderedSum<sumOf<scalar>>(
            water.size(),
            [&](int i)
            {
                const scalar before = water.rho[i];
                water.rho[i] *= 1 + dt * byGrains_[i] * excess[i];
                return sumOf<scalar>{
                    water.mass[i] * state_.released(before, water.rho[i])};
            }
        ).value;
}

// 1 - 10 gam', within 0 and 1
scalar waterDynamics::inTheDepth(const packing& s)
{
    constexpr scalar surfaceShare = 0.1;
    return std::clamp(1 - s.beyond / surfaceShare, 0.0, 1.0);
}

// Towards where there are fewer particles, in the depth of the water:
//     v_s = - A (c0/10) h gradS (1 - 10 gam') (P/(rho0 |g| h) - 1),
// both brackets within 0 and 1                                       (T 5.23)
vector waterDynamics::shiftVelocity(int i) const
{
    constexpr scalar shallow = 1, Mach = 0.1;
    const scalar head = water.p[i] / (state_.rho0() * mag(scene_.g) * scene_.h);
    if (head <= shallow)
    {
        return Zero;
    }
    const packing s = packingAt(i);
    const scalar fade = inTheDepth(s) * std::clamp(head - shallow, 0.0, 1.0);
    return (-scheme_.shifting * Mach * state_.c0() * scene_.h * fade)
         * s.gradient;
}

// x <- x + dt v_s,  rho <- rho + rho0 g.(dt v_s)/c0^2: the pressure of the new
// depth. What that does to the energy is booked.
void waterDynamics::shift(scalar dt)
{
    if (!(scheme_.shifting > 0))
    {
        return;
    }
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

} // namespace lpf
} // namespace Foam
