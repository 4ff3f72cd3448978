// SPDX-License-Identifier: GPL-3.0-or-later
// What the packing of the particles says of the density of grains, and of where
// they should go, where the flow shears, which vanish at rest; and where their
// free surface is, for drag.
#include "grainDynamics.H"

#include "fieldTensors.H"
#include "latticeSums.H"
#include "momentInverse.H"

#include <algorithm>

namespace Foam
{
namespace lpf
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

namespace
{

//- gdot = sqrt(2 dev D:dev D)
scalar shearRate(const Tens& L)
{
    const Symm D = symm(L);
    const double mean = (D.xx + D.yy + D.zz) / 3;
    return rateOfShear({D.xx - mean, D.xy, D.xz, D.yy - mean, D.yz, D.zz - mean}
    );
}

} // namespace

//     S = (sum m W + l(gam) rho)/Sc,  e = S - rho                     (T 3.16)
// e < 0 counts where neighbours are all around
scalar grainDynamics::looseness(int i, bool surrounded) const
{
    const scalar gam = max(scalar(0), groundShare(i));
    const scalar rho = grains.rho[i];
    const scalar S =
        (fill_[i] + lpfPairs::latticeShare(gam) * rho) / latticeFill_;
    const scalar e = S - rho;
    return e > 0 || surrounded ? e : 0;
}

//     rho <- rho + dt k gdot e                                        (T 3.17)
//     v_s = - A gdot h^2 grad S, in the depth and where p > 0         (T 3.18)
void grainDynamics::followPacking(scalar dt)
{
    const passTimes::timed pass(times, "packing");
    constexpr scalar nearlyAll = 0.9, inTheDepth = 0.85;
    const scalar hSqr = sqr(scene_.h);
    ledger.diffusion +=
        orderedSum<sumOf<scalar>>(
            grains.size(),
            [&](int i)
            {
                const Symm B = symmAt(grains.B, i);
                const scalar gdot = shearRate(tensorAt(grains.L, i));
                const scalar before = storedEnergy(i);
                const scalar e = looseness(i, allBelow(B, 1 / nearlyAll));
                grains.rho[i] += dt * scheme_.densityRelaxation * gdot * e;

                vector gradS = at(gradFill_, i);
                if (slot_[i] >= 0)
                {
                    gradS -= toVector(contracted(
                        thirdMoment(walls_[static_cast<std::size_t>(slot_[i])])
                    ));
                }
                const bool held =
                    pressureAt(i) > 0 && allBelow(B, 1 / inTheDepth);
                set(gradFill_,
                    i,
                    held ? vector(-scheme_.shifting * gdot * hSqr * gradS)
                         : vector(Zero));
                return sumOf<scalar>{before - storedEnergy(i)};
            }
        ).value;
}

// Grains that fill s of their place up to a plane surface, and behind the
// ground:
//     h |sum V gradW - s sum A E n|/(sum m W/rho + s gam) = h p/(1 - gam'),
//     s = sum m W/rho/(1 - gam - gam') <= 1                           (T 6.20)
// p and gam' those at one depth below the surface. Where s is low the grains
// are spread out, and a gradient is their disorder
scalar grainDynamics::beyondSurface(int i) const
{
    constexpr int tries = 3; // the last changes gam' by 0.003 at most
    constexpr scalar least = 0.2, spread = 0.6, bed = 0.8;
    const scalar fill = fill_[i] / grains.rho[i];
    scalar gam = 0;
    vector ground(Zero);
    if (slot_[i] >= 0)
    {
        gam = max(scalar(0), groundShare(i));
        ground = toVector(
            contracted(thirdMoment(walls_[static_cast<std::size_t>(slot_[i])]))
        );
    }
    scalar beyond = 0, s = 0;
    for (int k = 0; k < (slot_[i] < 0 ? 1 : tries); ++k)
    {
        s = min(scalar(1), fill / max(least, 1 - gam - beyond));
        const vector gradient = at(gradFill_, i) - s * ground;
        beyond = surface_->beyond(
            scene_.h * mag(gradient) / (fill + s * gam) // (T 6.20)
        );
    }
    s = fill / max(least, 1 - gam - beyond);
    return std::clamp((s - spread) / (bed - spread), 0.0, 1.0) * beyond;
}

void grainDynamics::seeSurface()
{
    const passTimes::timed pass(times, "surface");
    beneath_.resize(grains.size());
    lpfPairs::forEach(
        grains.size(),
        [&](int i) { beneath_[i] = surface_->depth(beyondSurface(i)); }
    );
}

scalar grainDynamics::surfaceShare(int i, scalar h) const
{
    return surface_->atDepth(beneath_[i] * scene_.h / h);
}

// x <- x + dt v_s; what that does to the energy is booked
void grainDynamics::shift(scalar dt)
{
    if (!(scheme_.shifting > 0))
    {
        return;
    }
    ledger.shifting +=
        orderedSum<sumOf<scalar>>(
            grains.size(),
            [&](int i)
            {
                const vector d = dt * at(gradFill_, i);
                set(grains.x, i, at(grains.x, i) + d);
                return sumOf<scalar>{grains.mass[i] * (scene_.g & d)};
            }
        ).value;
}

} // namespace lpf
} // namespace Foam
