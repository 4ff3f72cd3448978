// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::timeIntegrations::predictorCorrector
Description  Two evaluations of the forces a step, all of the state at one time.
             With y = (sigma, rho) and its rate f:
                 a^n = F(x^n, U^n, y^n)                 the synchronous time
                 U* = U^n + dt/2 a^n,  x* = x^n + dt/2 U*
                 y* = y^n + dt/2 f(x*, U*),  a* = F(x*, U*, y*)
                 U^(n+1) = U^n + dt a*,  x^(n+1) = x* + dt/2 U*,
                 y^(n+1) = y^n + dt f(x*, U*)                       (T 7.2)
             The explicit midpoint rule; for a linear elastic wave it is the
             velocity form of Verlet, as stable as the leapfrog, and makes or
             takes no energy. Second order also in what goes with the velocity
             and in positions and volumes. Contact with the ground at the end
             of a step, implicit viscosity and drag once over dt after the kick.
             What the prediction books is taken back.
Source       A. Verlet step of two evaluations; as predictor and corrector in
             SPH: J. J. Monaghan, J. Comput. Phys. 82 (1989) 1.
Limits       those of the leapfrog
Costs        twice a step of the leapfrog; per particle 11 numbers of grains
             (3 U, 6 sigma, 2 rho) and 4 of water
Usage        timeIntegration predictorCorrector;
*/
#include "timeIntegration.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace timeIntegrations
{

class predictorCorrector : public timeIntegration
{
public:
    TypeName("predictorCorrector");

    void prepare(flow& all) const override
    {
        for (phaseDynamics* phase : all.phases())
        {
            phase->particles().keepStart();
        }
    }

    void begin(flow& all, scalar, scalar time) const override
    {
        all.rates(0, time, stage::start);
    }

    void finish(flow& all, scalar, scalar dt, scalar time) const override
    {
        predict(all, dt);
        all.rates(dt, time + 0.5 * dt, stage::middle);
        for (phaseDynamics* phase : all.phases())
        {
            phase->goToEnd();
        }
        all.kick(dt);
        all.relax(dt);
        for (phaseDynamics* phase : all.phases())
        {
            phase->driftOn(dt, time);
        }
    }

    int evaluations() const override { return 2; }

private:
    //- x, U, rho of the middle; the ledger as before, but for cyclic planes
    static void predict(flow& all, scalar dt)
    {
        std::vector<balance> before;
        for (phaseDynamics* phase : all.phases())
        {
            phase->keepState(dt);
            before.push_back(phase->ledger);
        }
        all.kick(0.5 * dt);
        all.relax(0.5 * dt);
        std::size_t k = 0;
        for (phaseDynamics* phase : all.phases())
        {
            phase->ledger = before[k++];
            phase->driftFreely(0.5 * dt);
        }
    }
};

defineTypeNameAndDebug(predictorCorrector, 0);
addToRunTimeSelectionTable(timeIntegration, predictorCorrector, dictionary);

} // namespace timeIntegrations
} // namespace lpf
} // namespace Foam
