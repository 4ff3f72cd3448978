// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundLaws::Coulomb
Description  tau = mu (1 - r_u) sigma_n, on the actual normal force   (T 4.6)
             C. A. de Coulomb (1776); Gao et al. (2023), eq. 25.
Range        mu 0 to 10, r_u 0 to 1. Exact for one layer of particles.
Units        mu, r_u [-]
Usage        chute { friction Coulomb; mu 0.5; ru 0; }
*/
#include "groundLaw.H"
#include "inputCheck.H"

#include "addToRunTimeSelectionTable.H"

namespace Foam
{
namespace lpf
{
namespace groundLaws
{

class Coulomb : public groundLaw
{
    dryFriction dry_;

public:
    TypeName("Coulomb");

    Coulomb(const dictionary& dict, wordList valid)
    {
        valid.append(wordList({"mu", "ru"}));
        allowOnly(dict, valid);
        dry_ = dryFriction::read(dict);
    }

    scalar mu() const override { return dry_.effective(); } // (T 4.6)
    scalar ru() const override { return dry_.ru; }
};

defineTypeNameAndDebug(Coulomb, 0);
addToRunTimeSelectionTable(groundLaw, Coulomb, grains);

} // namespace groundLaws
} // namespace lpf
} // namespace Foam
