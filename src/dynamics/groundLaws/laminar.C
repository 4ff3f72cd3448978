// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundLaws::laminar
Description  Viscous flow over ground that it sticks to, of viscosity mu:
             profile depthAveraged;    tau = 3 mu u/H                (T 4.15)
                 u the mean over the depth of a parabolic profile; a uniform
                 flow of depth h on a slope th becomes steady at
                 u = rho g sin th h^2/(3 mu)
             profile wallDistance;     tau = mu u/d,  d >= dx/4      (T 4.16)
                 u of a particle at the distance d: the profile is resolved,
                 by grains or by water of this viscosity
             Gao et al. (2023), eq. 26, is the first with nu for mu.
             W. Nusselt, Z. VDI 60 (1916) 541.
Range        depthAveraged, H of (T 4.9): a plug, as far as what flows is stiff
             enough. wallDistance: five layers and more; the same as noSlip for
             water, by the particle in place of the ground's layers.
Units        viscosity [Pa s]
Usage        bed { friction laminar; viscosity 50; profile depthAveraged; }
             bed { friction none; waterFriction laminar;
                   waterFrictionCoeffs { viscosity 50; profile wallDistance; } }
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

class laminar : public groundLaw
{
    scalar mu_;
    bool depthAveraged_;

    //- Least distance to the ground, as a share of the spacing
    static constexpr scalar nearestShare = 0.25;

public:
    TypeName("laminar");

    laminar(const dictionary& dict, wordList valid)
    {
        valid.append(wordList({"viscosity", "profile"}));
        allowOnly(dict, valid);
        bounds positive;
        positive.lower = 0;
        positive.lowerOpen = true;
        positive.reason = "a viscosity dissipates; mud has 0.1 to 100 Pa s";
        mu_ = readNumber(dict, "viscosity", dimDynamicViscosity, positive);
        depthAveraged_ =
            readChoice(dict, "profile", {"depthAveraged", "wallDistance"})
            == "depthAveraged";
    }

    bool resists() const override { return true; }

    bool standsForViscosity() const override { return !depthAveraged_; }

    groundTraction at(const groundPlace& place) const override
    {
        const scalar nu = mu_ / place.rho;
        const scalar d = max(place.distance, nearestShare * place.spacing);
        return {
            0,
            depthAveraged_ ? 3 * nu / place.depth() // (T 4.15)
                           : nu / d,                // (T 4.16)
            0};
    }
};

defineTypeNameAndDebug(laminar, 0);
addToRunTimeSelectionTable(groundLaw, laminar, grains);
addToRunTimeSelectionTable(groundLaw, laminar, water);

} // namespace groundLaws
} // namespace lpf
} // namespace Foam
