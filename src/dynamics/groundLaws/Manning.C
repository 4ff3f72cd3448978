// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundLaws::Manning
Description  tau = rho g n^2 u^2/H^(1/3)                             (T 4.14)
             Turbulent water over rough ground. A uniform flow of depth h on a
             slope th, wide against its depth, becomes steady at
                 u = h^(2/3) sqrt(sin th)/n.
             R. Manning, Trans. Inst. Civ. Eng. Ireland 20 (1891) 161;
             V. T. Chow, Open-Channel Hydraulics, McGraw-Hill (1959), tables of
n. Range        n 0.01 (glass) to 0.15 (forest); H, here (T 4.9), above the
height of the roughness, (n/0.04)^6 m. Velocity     u is the mean over the
depth, here that of the particles at the ground: water needs a viscosity, of its
eddies, to be a plug. Units        n [s/m^(1/3)] Usage        bed { friction
none; waterFriction Manning; waterFrictionCoeffs { n 0.03; } }
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

class Manning : public groundLaw
{
    scalar n_;

public:
    TypeName("Manning");

    Manning(const dictionary& dict, wordList valid)
    {
        valid.append("n");
        allowOnly(dict, valid);
        bounds range;
        range.lower = 0;
        range.lowerOpen = true;
        range.upper = 1;
        range.reason =
            "Manning's n is 0.01 of glass, 0.03 of a stream, 0.15 of "
            "forest, in s/m^(1/3)";
        const dimensionSet dims(0, -1.0 / 3, 1, 0, 0);
        n_ = readNumber(dict, "n", dims, range);
    }

    bool resists() const override { return true; }

    groundTraction at(const groundPlace& place) const override
    {
        return {0, 0, place.g * sqr(n_) / cbrt(place.depth())}; // (T 4.14)
    }
};

defineTypeNameAndDebug(Manning, 0);
addToRunTimeSelectionTable(groundLaw, Manning, water);

} // namespace groundLaws
} // namespace lpf
} // namespace Foam
