// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundLaws::Voellmy
Description  tau = mu (1 - r_u) sigma_n + rho g u^2/xi               (T 4.13)
             A uniform flow of depth h on a slope th becomes steady at
                 u = sqrt(xi h (sin th - mu cos th)).
             A. Voellmy, Schweiz. Bauzeitung 73 (1955) 159, 212, 246, 280;
             B. Salm, Ann. Glaciol. 18 (1993) 221.
Range        snow avalanches mu 0.15 to 0.5, xi 400 to 3000; debris flows mu
             0.05 to 0.4, xi 100 to 1000. No depth enters. For water: one that
             stands for a whole flowing mixture.
Velocity     u is the mean over the depth, here that of the particles at the
             ground: a plug.
Units        mu, r_u [-], xi [m/s2]
Usage        chute { friction Voellmy; mu 0.2; ru 0; xi 500; }
             chute { friction none; waterFriction Voellmy;
                     waterFrictionCoeffs { mu 0.1; xi 500; } }
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

class Voellmy : public groundLaw
{
    dryFriction dry_;
    scalar xi_;

public:
    TypeName("Voellmy");

    Voellmy(const dictionary& dict, wordList valid)
    {
        valid.append(wordList({"mu", "ru", "xi"}));
        allowOnly(dict, valid);
        dry_ = dryFriction::read(dict);
        bounds positive;
        positive.lower = 0;
        positive.lowerOpen = true;
        positive.reason = "it is the square of Chezy's coefficient; write "
                          "100 to 3000";
        xi_ = readNumber(dict, "xi", dimAcceleration, positive);
    }

    scalar mu() const override { return dry_.effective(); }
    scalar ru() const override { return dry_.ru; }

    bool resists() const override { return true; }

    groundTraction at(const groundPlace& place) const override
    {
        return {0, 0, place.g / xi_}; // (T 4.13)
    }
};

defineTypeNameAndDebug(Voellmy, 0);
addToRunTimeSelectionTable(groundLaw, Voellmy, grains);
addToRunTimeSelectionTable(groundLaw, Voellmy, water);

} // namespace groundLaws
} // namespace lpf
} // namespace Foam
