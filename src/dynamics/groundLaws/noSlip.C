// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundLaws::noSlip
Description  Grains: those that press on the ground from within a spacing have
             no velocity along it (T 4.17): a bed so rough that flow shears
             inside itself alone. Impulses are at most those that stop.
             Water sticks by its viscosity, (T 5.21).
Range        grains: as Coulomb friction above the internal friction, but it
             holds at any shear stress over pressure, cohesive grains as well.
Usage        bed { friction noSlip; waterFriction noSlip; }
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

class noSlip : public groundLaw
{
public:
    TypeName("noSlip");

    noSlip(const dictionary& dict, const wordList& valid)
    {
        allowOnly(dict, valid);
    }

    bool resists() const override { return true; }

    groundTraction at(const groundPlace& place) const override
    {
        return {place.distance < place.spacing ? GREAT : 0, 0, 0}; // (T 4.17)
    }
};

//- Water: waterViscosity does it
class stickingWater : public groundLaw
{
public:
    TypeName("noSlip");

    stickingWater(const dictionary& dict, const wordList& valid)
    {
        allowOnly(dict, valid);
    }

    bool sticks() const override { return true; }
};

defineTypeNameAndDebug(noSlip, 0);
addToRunTimeSelectionTable(groundLaw, noSlip, grains);
defineTypeNameAndDebug(stickingWater, 0);
addNamedToRunTimeSelectionTable(groundLaw, stickingWater, water, noSlip);

} // namespace groundLaws
} // namespace lpf
} // namespace Foam
