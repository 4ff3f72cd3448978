// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::timeIntegrations::leapfrog
Description  One evaluation of the forces a step, velocities half a step from
             positions and stress:
                 rates(dt)    L at x^n with U^(n-1/2), sigma^n, a^n
                 kick(dt/2)   U^n, the synchronous time
                 kick(dt'/2)  U^(n+1/2), dt' the new time step
                 relax, drift(dt')                                  (T 7.1)
             Second order in what is elastic and in the places and volumes
             of water (T 7.4, T 7.5), first order in what goes with the
             velocity: viscosity, noise damping, and, of grains, the change of
             positions and volumes within a step.
Limits       CFL of the fastest wave below about 1
Usage        timeIntegration leapfrog;
*/
#include "timeIntegration.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace timeIntegrations
{

class leapfrog : public timeIntegration
{
public:
    TypeName("leapfrog");

    void begin(flow& all, scalar dtBefore, scalar time) const override
    {
        all.rates(dtBefore, time);
        all.kick(0.5 * dtBefore);
    }

    void
    finish(flow& all, scalar dtBefore, scalar dt, scalar time) const override
    {
        all.kick(0.5 * dt);
        all.relax(0.5 * (dtBefore + dt));
        all.drift(dt, time);
    }

    int evaluations() const override { return 1; }
};

defineTypeNameAndDebug(leapfrog, 0);
addToRunTimeSelectionTable(timeIntegration, leapfrog, dictionary);

} // namespace timeIntegrations
} // namespace lpf
} // namespace Foam
