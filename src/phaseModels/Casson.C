// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::viscosityModels::Casson
Description  Roots of the stresses add up, sqrt(tau) = sqrt(tau0)
             + sqrt(muInf gamma), regularised by a bound:
                 mu = min(muMax, (sqrt(muInf) + sqrt(tau0/gamma))^2) (T 5.19)
             N. Casson, in Rheology of Disperse Systems, ed. C. C. Mill (1959)
             84.
Range        any gamma; exact where mu < muMax
Units        tau0 [Pa], muInf, muMax [Pa s]; no density in them
Limits       gamma -> infinity: muInf. tau0 = 0: Newtonian. gamma = 0: muMax
Usage        viscosity Casson;
             CassonCoeffs
             {
                 muInf [1 -1 -1 0 0 0 0] 0.1;       // [Pa s]; drag uses it
                 tau0  [1 -1 -2 0 0 0 0] 10;        // [Pa]
                 muMax [1 -1 -1 0 0 0 0] 500;       // [Pa s]
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

class Casson : public shearRateViscosity<Casson>
{
    scalar muInf_, tau0_, muMax_;

public:
    TypeName("Casson");

    explicit Casson(const dictionary& phase)
    {
        const dictionary& coeffs =
            viscosityCoeffs(phase, "Casson", "muInf 0.1; tau0 10; muMax 500;");
        allowOnly(coeffs, {"muInf", "tau0", "muMax"});
        muInf_ = notNegative(
            coeffs,
            "muInf",
            dimDynamicViscosity,
            "a viscosity dissipates; write that at large rates"
        );
        tau0_ = notNegative(
            coeffs, "tau0", dimPressure, "it is a strength in shear, in Pa"
        );
        muMax_ = readMuMax(coeffs, "muInf", muInf_);
    }

    scalar largest() const override { return tau0_ > 0 ? muMax_ : muInf_; }
    scalar molecular() const override { return muInf_; }

    scalar muAt(scalar gamma) const
    {
        const scalar root =
            std::sqrt(muInf_) + std::sqrt(tau0_ / max(gamma, SMALL));
        return min(muMax_, sqr(root)); // (T 5.19)
    }
};

defineTypeNameAndDebug(Casson, 0);
addToRunTimeSelectionTable(viscosityModel, Casson, dictionary);

} // namespace viscosityModels
} // namespace lpf
} // namespace Foam
