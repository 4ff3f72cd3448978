// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::viscosityModels::Newtonian
Description  tau = mu (grad v + grad v^T - 2/3 div v I), mu constant.
             Gao et al. (2023) eqs 4 and 5.
Usage        viscosity Newtonian;
             NewtonianCoeffs { mu [1 -1 -1 0 0 0 0] 1e-3; }        // [Pa s]
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

class Newtonian : public viscosityModel
{
    scalar mu_;

public:
    TypeName("Newtonian");

    explicit Newtonian(const dictionary& phase)
    {
        const dictionary* coeffs = optionalDictionary(phase, "NewtonianCoeffs");
        if (!coeffs)
        {
            refuse(
                phase,
                "NewtonianCoeffs",
                "The viscosity is missing; write NewtonianCoeffs { mu 1e-3; } "
                "in Pa s"
            );
        }
        allowOnly(*coeffs, {"mu"});
        bounds notNegative;
        notNegative.lower = 0;
        notNegative.reason = "a viscosity dissipates; water has 1e-3 Pa s";
        mu_ = readNumber(*coeffs, "mu", dimDynamicViscosity, notNegative);
    }

    scalar largest() const override { return mu_; }
    scalar molecular() const override { return mu_; }

    void mu(int n, const double*, double* mu) const override
    {
        std::fill_n(mu, n, mu_);
    }
};

defineTypeNameAndDebug(Newtonian, 0);
addToRunTimeSelectionTable(viscosityModel, Newtonian, dictionary);

} // namespace viscosityModels
} // namespace lpf
} // namespace Foam
