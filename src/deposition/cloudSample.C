// SPDX-License-Identifier: GPL-3.0-or-later
#include "cloudSample.H"

#include "error.H"
#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

namespace
{

// Of water in a particle; less would be a slip, and its space without bound
constexpr scalar leastFraction = 0.01;


//- Axis of a unit vector; plan maps need one that is horizontal
int horizontalAxis(const dictionary& dict, const vector& normal)
{
    for (direction axis = 0; axis < 2; ++axis)
    {
        if (mag(normal[axis]) > 1 - 1e-9)
        {
            return axis;
        }
    }
    refuse(
        dict,
        "planeNormal",
        "planeNormal is neither the x nor the y axis: a plan map needs cells "
        "that stand along the plane; lay the plane of the scene along x or y"
    );
}

template<class Type>
const Field<Type>& needed(
    const HashTable<Field<Type>>& fields,
    const word& cloud,
    const word& field,
    const char* purpose
)
{
    const auto found = fields.cfind(field);
    if (!found.found())
    {
        FatalErrorInFunction << "cloud " << cloud << " has no field " << field
                             << nl << "It is needed for the " << purpose
                             << " of the particles;"
                             << " terrainToParticles and lpfSolver write it."
                             << exit(FatalError);
    }
    return found.val();
}

const scalarField&
needed(const cloudState& state, const word& cloud, const word& field)
{
    return needed(state.scalars, cloud, field, "volume");
}

scalarField bulkVolume(
    const cloudState& state, const word& cloud, const scalar phaseDensity
)
{
    const scalarField& mass = needed(state, cloud, "mass");
    if (state.scalars.found("rho"))
    {
        return scalarField(mass / state.scalars["rho"]);
    }
    return scalarField(mass / (phaseDensity * needed(state, cloud, "alpha")));
}

//- Space of water particles: one with hardly any water in its pores takes as
//  much as one that is full
scalarField
spaceOf(const cloudState& state, const word& cloud, const scalar phaseDensity)
{
    return scalarField(
        needed(state, cloud, "mass")
        / (phaseDensity * max(needed(state, cloud, "alpha"), leastFraction))
    );
}

} // namespace


releaseScales releaseScales::of(const word& cloud) const
{
    releaseScales own(*this);
    if (cloud == "water")
    {
        own.spacing = waterSpacing;
        own.smoothingLength = waterSmoothingLength;
    }
    return own;
}


releaseScales readReleaseScales(const fileName& caseDir)
{
    const dictionary dict = readDictionary(
        caseDir / "constant" / "releaseProperties",
        "terrainToParticles writes it: run that first"
    );
    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "it is a length that terrainToParticles writes";

    releaseScales scales{0, 0, -1, 0};
    scales.spacing = readNumber(dict, "spacing", dimLength, positive);
    scales.smoothingLength =
        readNumber(dict, "smoothingLength", dimLength, positive);
    scales.waterSpacing =
        readNumber(dict, "waterSpacing", dimLength, positive, scales.spacing);
    scales.waterSmoothingLength = readNumber(
        dict,
        "waterSmoothingLength",
        dimLength,
        positive,
        scales.smoothingLength
    );
    if (dict.getOrDefault<label>("dimensions", 3) == 2)
    {
        scales.flat =
            horizontalAxis(dict, readVector(dict, "planeNormal", dimless));
        scales.planeThickness =
            readNumber(dict, "planeThickness", dimLength, positive);
    }
    return scales;
}


scalar readPhaseDensity(const fileName& caseDir, const word& cloud)
{
    const dictionary dict =
        readDictionary(caseDir / "constant" / "phaseProperties");
    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "it is the density of the phase itself, as 2600 of rock";
    return readNumber(
        neededDictionary(dict, cloud, "write " + cloud + " { rho ..; }"),
        "rho",
        dimDensity,
        positive
    );
}


cloudSample sampleOf(
    const cloudState& state,
    const word& cloud,
    const scalar phaseDensity,
    const releaseScales& scales
)
{
    cloudSample sample;
    sample.x = state.positions;
    sample.mass = needed(state, cloud, "mass");
    if (cloud == "water")
    {
        sample.volume = sample.mass / phaseDensity;
        sample.space = spaceOf(state, cloud, phaseDensity);
    }
    else
    {
        sample.volume = bulkVolume(state, cloud, phaseDensity);
    }
    sample.U = needed(state.vectors, cloud, "U", "speed");
    const auto h = state.scalars.cfind("h");
    sample.h =
        h.found() ? h.val() : scalarField(state.size(), scales.smoothingLength);

    forAll (sample.volume, i)
    {
        if (!(sample.volume[i] > 0 && sample.h[i] > 0))
        {
            FatalErrorInFunction
                << "particle " << i << " of cloud " << cloud << " at "
                << sample.x[i] << " has volume " << sample.volume[i]
                << " m3 and smoothing length " << sample.h[i]
                << " m; both must be above 0" << exit(FatalError);
        }
    }
    return sample;
}


cloudTotals totals(const cloudSample& sample)
{
    cloudTotals sum{0, 0, 0, 0, point::zero};
    forAll (sample.x, i)
    {
        const scalar speed = mag(sample.U[i]);
        sum.mass += sample.mass[i];
        sum.volume += sample.volume[i];
        sum.meanSpeed += sample.mass[i] * speed;
        sum.maxSpeed = max(sum.maxSpeed, speed);
        sum.centre += sample.mass[i] * sample.x[i];
    }
    if (sum.mass > 0)
    {
        sum.meanSpeed /= sum.mass;
        sum.centre /= sum.mass;
    }
    return sum;
}

} // namespace lpf
} // namespace Foam
