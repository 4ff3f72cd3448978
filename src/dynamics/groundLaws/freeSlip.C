// SPDX-License-Identifier: GPL-3.0-or-later
/*
Class        Foam::lpf::groundLaws::freeSlip, also by the word none
Description  tau = 0: ground that only carries.
Usage        wall { friction freeSlip; waterFriction freeSlip; }
             wall { friction none; }
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

class freeSlip : public groundLaw
{
public:
    TypeName("freeSlip");

    freeSlip(const dictionary& dict, const wordList& valid)
    {
        allowOnly(dict, valid);
    }
};

defineTypeNameAndDebug(freeSlip, 0);
addToRunTimeSelectionTable(groundLaw, freeSlip, grains);
addToRunTimeSelectionTable(groundLaw, freeSlip, water);
addNamedToRunTimeSelectionTable(groundLaw, freeSlip, grains, none);
addNamedToRunTimeSelectionTable(groundLaw, freeSlip, water, none);

} // namespace groundLaws
} // namespace lpf
} // namespace Foam
