// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::viscosityModels::Bingham
Description  Yield stress and a plastic viscosity, regularised by a bound:
                 mu = min(muMax, muP + tau0/gamma)                   (T 5.17)
             so that tau = tau0 + muP gamma exactly from gamma_c =
             tau0/(muMax - muP) on, and what does not yield creeps as a liquid
             of muMax, at less than gamma_c.
             E. C. Bingham, Fluidity and Plasticity (1922); the two-viscosity
             form: E. J. O'Donovan, R. I. Tanner, J. Non-Newtonian Fluid Mech.
             15 (1984) 75.
Range        any gamma; the yield surface is sharp where gamma_c is small
             against the rates of the flow
Units        tau0 [Pa], muP, muMax [Pa s]; no density in them
Limits       tau0 = 0: Newtonian, muP. gamma = 0: muMax
Usage        viscosity Bingham;
             BinghamCoeffs
             {
                 muP   [1 -1 -1 0 0 0 0] 0.5;       // [Pa s]; drag uses it
                 tau0  [1 -1 -2 0 0 0 0] 50;        // [Pa]
                 muMax [1 -1 -1 0 0 0 0] 1000;      // [Pa s]
             }
*/
#include "inputCheck.H"
#include "viscosityModel.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace viscosityModels
{

class Bingham : public shearRateViscosity<Bingham>
{
    scalar muP_, tau0_, muMax_;

public:
    TypeName("Bingham");

    explicit Bingham(const dictionary& phase)
    {
        const dictionary& coeffs =
            viscosityCoeffs(phase, "Bingham", "muP 0.5; tau0 50; muMax 1000;");
        allowOnly(coeffs, {"muP", "tau0", "muMax"});
        muP_ = notNegative(
            coeffs,
            "muP",
            dimDynamicViscosity,
            "a viscosity dissipates; write the slope of stress over rate"
        );
        tau0_ = notNegative(
            coeffs, "tau0", dimPressure, "it is a strength in shear, in Pa"
        );
        muMax_ = readMuMax(coeffs, "muP", muP_);
    }

    scalar largest() const override { return tau0_ > 0 ? muMax_ : muP_; }
    scalar molecular() const override { return muP_; }

    scalar muAt(scalar gamma) const
    {
        return min(muMax_, muP_ + tau0_ / max(gamma, SMALL)); // (T 5.17)
    }
};

defineTypeNameAndDebug(Bingham, 0);
addToRunTimeSelectionTable(viscosityModel, Bingham, dictionary);

} // namespace viscosityModels
} // namespace lpf
} // namespace Foam
