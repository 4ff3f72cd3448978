// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::equationsOfState::Tait
Description  P = max(0, B ((rho/rho0)^gamma - 1)),  B = rho0 c0^2/gamma (T 5.2)
             e = B/rho0 ((rho/rho0)^(gamma-1) - 1)/(gamma - 1)
                 + B/rho0 (rho0/rho - 1)  for rho > rho0, else 0    (T 5.7)
             Gao et al. (2023) eq. 3, with gamma = 7.
Usage        equationOfState Tait;
             TaitCoeffs { gamma 7; soundSpeed auto; }              // [-] [m/s]
*/
#include "equationOfState.H"
#include "inputCheck.H"
#include "orderedSum.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace equationsOfState
{

class Tait : public equationOfState
{
    scalar gamma_, B_;
    scalar perRho0_, perGamma1_; //!< 1/rho0, 1/(gamma - 1)

    //- r^exponent of gamma or gamma - 1. That of water by products: std::pow
    //  takes as long as some twenty of them
    scalar power(scalar r, scalar exponent) const
    {
        if (gamma_ == 7)
        {
            const scalar r3 = r * r * r;
            return exponent == 7 ? r3 * r3 * r : r3 * r3;
        }
        return std::pow(r, exponent);
    }

    static const dictionary& coeffsOf(const dictionary& phase)
    {
        const dictionary* coeffs = optionalDictionary(phase, "TaitCoeffs");
        return coeffs ? *coeffs : dictionary::null;
    }

public:
    TypeName("Tait");

    Tait(const dictionary& phase, const soundSpeedScale& scale)
        : equationOfState(phase, coeffsOf(phase), scale)
    {
        const dictionary& coeffs = coeffsOf(phase);
        allowOnly(coeffs, {"gamma", "soundSpeed"});
        bounds exponent;
        exponent.lower = 1;
        exponent.lowerOpen = true;
        exponent.upper = 20;
        exponent.reason = "water has 7";
        gamma_ = readNumber(coeffs, "gamma", dimless, exponent, 7);
        B_ = rho0_ * sqr(c0_) / gamma_;
        perRho0_ = 1 / rho0_;
        perGamma1_ = 1 / (gamma_ - 1);
    }

    void pressure(int n, const double* rho, double* p) const override
    {
        lpfPairs::forChunks(
            n,
            [&](int begin, int end, int)
            {
                for (int i = begin; i < end; ++i)
                {
                    const scalar r = rho[i] * perRho0_;
                    p[i] = r > 1 ? B_ * (power(r, gamma_) - 1) : 0; // (T 5.2)
                }
            }
        );
    }

    scalar density(scalar p) const override
    {
        return rho0_ * std::pow(1 + max(p, scalar(0)) / B_, 1 / gamma_);
    }

    scalar energy(scalar rho) const override { return released(rho, rho0_); }

    // 1/a - 1/b of what is nearly the same as one quotient: as exact, and half
    // of the time
    scalar released(scalar from, scalar to) const override
    {
        const scalar a = max(scalar(1), from * perRho0_);
        const scalar b = max(scalar(1), to * perRho0_);
        return B_ * perRho0_
             * ((power(a, gamma_ - 1) - power(b, gamma_ - 1)) * perGamma1_
                + (b - a) / (a * b)); // (T 5.7)
    }
};

defineTypeNameAndDebug(Tait, 0);
addToRunTimeSelectionTable(equationOfState, Tait, dictionary);

} // namespace equationsOfState
} // namespace lpf
} // namespace Foam
