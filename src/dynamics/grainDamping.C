// SPDX-License-Identifier: GPL-3.0-or-later
// Damping of the elastic waves of grains: stresses that the force takes besides
// sigma, with the same adjoint gradient. `bulkDamping` and `shearDamping` of
// system/lpfSolution.
#include "grainDynamics.H"

#include "fieldTensors.H"
#include "frictionalRheology.H"

namespace Foam
{
namespace lpf
{

using namespace granularRheologies;

// Waves of compression, which grains do not carry far: an addition to the
// pressure, nowhere below zero in sum                                (T 3.15)
//     q = - beta rho c h tr L,  q >= -p where p > 0, else 0
Symm grainDynamics::bulkDampingAt(int i) const
{
    const double p = pressureAt(i);
    const double trL = grains.L[0][i] + grains.L[4][i] + grains.L[8][i];
    const double asked = -scheme_.bulkDamping * grains.rho[i]
                       * rheology_.elastic().c() * scene_.h * trL;
    const double q = p > 0 ? std::max(asked, -p) : 0;
    return {-q, 0, 0, -q, 0, -q};
}

// Q s Q^T, from which the stress of a step goes on
void grainDynamics::keepTurnedShear(const realArrays<6>& sigma, scalar dt)
{
    if (!(scheme_.shearDamping > 0))
    {
        return;
    }
    lpf::resize(shearDamping_, grains.size());
    lpfPairs::forEach(
        grains.size(),
        [&](int i)
        {
            const Symm s = deviator(symmAt(sigma, i));
            setSymm(shearDamping_, i, rotated(s, tensorAt(grains.L, i), dt));
        }
    );
}

// Where no time passes: the rate over a step too short to matter, on copies,
// for which sigmaStart and rhoRefStart are free until keepState()
void grainDynamics::dampShearAtOnce()
{
    if (!(scheme_.shearDamping > 0))
    {
        return;
    }
    const scalar dt = 1e-4 * scene_.h / rheology_.elastic().c();
    grains.sigmaStart = grains.sigma;
    grains.rhoRefStart = grains.rhoRef;
    realArray rho = grains.rho;
    keepTurnedShear(grains.sigmaStart, dt);
    rheology_.correct(arraysOf(grains.sigmaStart, rho, grains.rhoRefStart), dt);
    dampShear(grains.sigmaStart, rho, dt);
}

// Waves of shear, by the rate of the stress itself, which yield has taken its
// part of already: a steady flow is not damped                       (T 3.43)
//     s_d = beta (rho c h/G) (s - Q s Q^T)/dt,  sqrt(J2(s_d)) <= p
void grainDynamics::dampShear(
    const realArrays<6>& sigma, const realArray& rho, scalar dt
)
{
    if (!(scheme_.shearDamping > 0))
    {
        return;
    }
    const elasticity& elastic = rheology_.elastic();
    const scalar perDensity = dt > 0 ? scheme_.shearDamping * elastic.c()
                                           * scene_.h / (elastic.G() * dt)
                                     : 0;
    lpfPairs::forEach(
        grains.size(),
        [&](int i)
        {
            const Symm now = symmAt(sigma, i);
            const Symm change =
                deviator(now) + scaled(-1, symmAt(shearDamping_, i));
            const Symm asked = scaled(perDensity * rho[i], change);
            const scalar most = max(scalar(0), -trace(now) / 3);
            const scalar size = std::sqrt(0.5 * magnitudeSqr(asked));
            setSymm(
                shearDamping_, i, scaled(size > most ? most / size : 1, asked)
            );
        }
    );
}

} // namespace lpf
} // namespace Foam
