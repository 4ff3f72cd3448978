// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::viscosityModels::HerschelBulkleyPapanastasiou
Description  Yield stress and a power of the rate, regularised by
Papanastasiou's exponential: mu = min(muMax, k gamma^(n-1)
                                 + tau0 (1 - exp(-m gamma))/gamma)   (T 5.18)
             W. H. Herschel, R. Bulkley, Kolloid-Z. 39 (1926) 291;
             T. C. Papanastasiou, J. Rheology 31 (1987) 385, eq. 10 with a
             power. The bound is needed for n < 1, where the power has no limit
             at gamma = 0, and for n > 1, where it has none at large gamma.
Range        any gamma; stress within tau0 exp(-m gamma) of the law
Units        k [Pa s^n], tau0 [Pa], m [s], muMax, muDrag [Pa s]; no density
Limits       m gamma -> 0: the term of tau0 is m tau0, without a division by 0.
             n = 1, tau0 = 0: Newtonian, k. n = 1: Bingham
Usage        viscosity HerschelBulkleyPapanastasiou;
             HerschelBulkleyPapanastasiouCoeffs
             {
                 k     [1 -1 -1.5 0 0 0 0] 2;       // [Pa s^n]
                 n     0.5;                         // [-]
                 tau0  [1 -1 -2 0 0 0 0] 30;        // [Pa]
                 m     [0 0 1 0 0 0 0] 100;         // [s]
                 muMax [1 -1 -1 0 0 0 0] 3000;      // [Pa s]
                 muDrag [1 -1 -1 0 0 0 0] 1e-3;     // with grains: of the
liquid
                                                    // around them [Pa s]
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

class HerschelBulkleyPapanastasiou
    : public shearRateViscosity<HerschelBulkleyPapanastasiou>
{
    scalar k_, n_, tau0_, m_, muMax_, muDrag_;

public:
    TypeName("HerschelBulkleyPapanastasiou");

    explicit HerschelBulkleyPapanastasiou(const dictionary& phase)
    {
        const dictionary& coeffs = viscosityCoeffs(
            phase,
            "HerschelBulkleyPapanastasiou",
            "k 2; n 0.5; tau0 30; m 100; muMax 3000;"
        );
        allowOnly(coeffs, {"k", "n", "tau0", "m", "muMax", "muDrag"});
        bounds power;
        power.lower = 0;
        power.lowerOpen = true;
        power.upper = 3;
        power.reason = "it is the power of the rate: below 1 thinning, above 1 "
                       "thickening; slurries have 0.3 to 1.2";
        n_ = readNumber(coeffs, "n", dimless, power);
        k_ = notNegative(
            coeffs,
            "k",
            dimensionSet(1, -1, n_ - 2, 0, 0),
            "it is the consistency, in Pa s^n"
        );
        tau0_ = notNegative(
            coeffs, "tau0", dimPressure, "it is a strength in shear, in Pa"
        );
        bounds time;
        time.lower = 0;
        time.lowerOpen = true;
        time.reason = "the stress rises to tau0 over rates of 1/m; write 10 to "
                      "1000 over the rates of the flow";
        m_ = readNumber(coeffs, "m", dimTime, time);
        muMax_ = readMuMax(coeffs, "k", n_ == 1 ? k_ : 0);
        bounds liquid;
        liquid.lower = 0;
        liquid.reason = "it is the viscosity of the liquid around a grain; "
                        "water has 1e-3 Pa s";
        muDrag_ = readNumber(coeffs, "muDrag", dimDynamicViscosity, liquid, 0);
    }

    scalar largest() const override
    {
        return n_ == 1 ? min(muMax_, k_ + m_ * tau0_) : muMax_;
    }
    scalar molecular() const override { return muDrag_; }

    scalar muAt(scalar gamma) const
    {
        constexpr scalar still = 1e-12; // [1/s]: the power stays finite
        const scalar rate = max(gamma, still);
        const scalar yield = -std::expm1(-m_ * rate) / rate;
        return min(
            muMax_, k_ * std::pow(rate, n_ - 1) + tau0_ * yield
        ); // (T 5.18)
    }
};

defineTypeNameAndDebug(HerschelBulkleyPapanastasiou, 0);
addToRunTimeSelectionTable(
    viscosityModel, HerschelBulkleyPapanastasiou, dictionary
);

} // namespace viscosityModels
} // namespace lpf
} // namespace Foam
