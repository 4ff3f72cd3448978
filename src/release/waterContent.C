// SPDX-License-Identifier: GPL-3.0-or-later
#include "waterContent.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

namespace
{

// Rounding of typed numbers, over the pore volume
constexpr scalar typed = 1e-6;


//- Volume of water by a measure other than mass
scalar volumeBy(const word& measure, const scalar value, const bedVolumes& bed)
{
    return measure == "saturation"   ? value * bed.pores()
         : measure == "trueFraction" ? value / (1 - value) * bed.solid
                                     : value * bed.bulk;
}


//- The measures and what the same number means in each of them
string differences(const bedVolumes& bed, const scalar rho)
{
    constexpr scalar example = 0.3;
    const auto mass = [&](const word& measure)
    { return Foam::name(rho * volumeBy(measure, example, bed)) + " kg"; };
    return "Write exactly one of\n"
           "    saturation S;       water volume over pore volume\n"
           "    trueFraction f;     water over solid and water\n"
           "    dryBulkFraction b;  water over the bulk volume of the dry bed\n"
           "    mass M;             [kg]\n"
           "They are different: 0.3 of this bed, with a solid fraction of "
         + Foam::name(bed.solid / bed.bulk) + ", are " + mass("saturation")
         + ", " + mass("trueFraction") + " and " + mass("dryBulkFraction")
         + " of water";
}


word chosenMeasure(
    const dictionary& water, const bedVolumes& bed, const scalar rho
)
{
    wordList given;
    for (const word& measure : waterMeasures())
    {
        if (water.found(measure))
        {
            given.append(measure);
        }
    }
    if (given.size() != 1)
    {
        string text(
            given.empty() ? "How much water the bed holds is missing"
                          : "How much water the bed holds is said "
                                + Foam::name(given.size()) + " times:"
        );
        for (const word& measure : given)
        {
            text += " " + measure;
        }
        // the line of the second, where there are several
        refuse(
            water,
            given.empty() ? word() : given.last(),
            text + ". " + differences(bed, rho)
        );
    }
    return given.first();
}


scalar readMass(const dictionary& water)
{
    return readNumber(
        water,
        "mass",
        dimMass,
        {0, GREAT, true, false, "total mass of the water"}
    );
}


//- Mass of water by what the dictionary says
scalar
readMassInBed(const dictionary& water, const bedVolumes& bed, const scalar rho)
{
    const word measure = chosenMeasure(water, bed, rho);
    if (measure == "mass")
    {
        return readMass(water);
    }
    const bool isTrue = measure == "trueFraction";
    const scalar value = readNumber(
        water,
        measure,
        dimless,
        {0,
         isTrue ? 1 : GREAT,
         true,
         isTrue,
         isTrue ? "water volume over the volume of solid and water; leave"
                  " `water` out of a dry bed"
                : "a share of the pores (saturation) or of the dry bulk"
                  " (dryBulkFraction); leave `water` out of a dry bed"}
    );
    return rho * volumeBy(measure, value, bed);
}

} // namespace


wordList waterMeasures()
{
    return {"saturation", "trueFraction", "dryBulkFraction", "mass"};
}


waterContent readWaterInBed(
    const dictionary& water,
    const bedVolumes& bed,
    const scalar rho,
    const word& release
)
{
    if (!(bed.pores() > 0))
    {
        refuse(
            water,
            word(),
            "The solid of release " + release + ", " + Foam::name(bed.solid)
                + " m3, leaves no pores in " + Foam::name(bed.bulk)
                + " m3 of bulk: correct the mass of the grains or the body"
        );
    }
    wordList valid(waterMeasures());
    valid.append("excess");
    valid.append("spacingRatio");
    allowOnly(water, valid);

    waterContent content;
    content.mass = readMassInBed(water, bed, rho);
    const scalar volume = content.mass / rho;
    const word excess =
        readChoice(water, "excess", {"refuse", "onTop"}, "refuse");
    if (volume <= bed.pores() * (1 + typed))
    {
        return content;
    }
    content.excess = content.mass - rho * bed.pores();
    if (excess == "refuse")
    {
        refuse(
            water,
            chosenMeasure(water, bed, rho),
            "Release " + release + " is to hold " + Foam::name(volume)
                + " m3 of water, its pores only " + Foam::name(bed.pores())
                + " m3: a saturation of " + Foam::name(volume / bed.pores())
                + ", a true fraction of "
                + Foam::name(volume / (volume + bed.solid)) + ". The excess is "
                + Foam::name(content.excess / rho) + " m3 or "
                + Foam::name(content.excess)
                + " kg.\nPut it on top of the bed: `excess onTop;`, or a second"
                  " release of water alone, and saturation 1 here; or is"
                  " another of the measures meant? "
                + differences(bed, rho)
        );
    }
    return content;
}


scalar
readFreeWater(const dictionary& water, const scalar room, const scalar rho)
{
    for (const char* key :
         {"saturation", "trueFraction", "dryBulkFraction", "excess"})
    {
        if (water.found(key))
        {
            refuse(
                water,
                key,
                "This release has no grains: its water fills it, and "
                    + string(key)
                    + " would have nothing to be a share of. Write water {}"
                      " or water { mass M; }, or add grains { solidFraction"
                      " ..; } for a wet bed"
            );
        }
    }
    allowOnly(water, {"mass", "spacingRatio"});
    return water.found("mass") ? readMass(water) : rho * room;
}

} // namespace lpf
} // namespace Foam
