// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenePreparation.H"
#include "inputCheck.H"
#include "waterContent.H"

namespace Foam
{
namespace lpf
{

namespace
{

// As in readMassInBed: rounding of typed numbers
constexpr scalar typed = 1e-6;


const dictionary& phaseDict(const dictionary& phases, const word& phase)
{
    const dictionary* dict = optionalDictionary(phases, phase);
    if (!dict)
    {
        refuse(
            phases,
            "phases",
            "phases names " + phase + ", but there is no dictionary " + phase
                + ": write " + phase + " { rho ..; } or take it out of phases"
        );
    }
    return *dict;
}

} // namespace


void scenePreparation::readPhases()
{
    const dictionary dict =
        readDictionary(caseDir_ / "constant" / "phaseProperties");
    const char* valid =
        "phases names what moves; write phases (grains);, phases (water); or"
        " phases (grains water);";
    if (!dict.found("phases"))
    {
        refuse(dict, "phases", valid);
    }
    const auto given = dict.get<wordList>("phases");
    for (const word& phase : {word("grains"), word("water")})
    {
        if (given.found(phase))
        {
            phases_.append(phase);
        }
    }
    if (phases_.empty() || phases_.size() != given.size())
    {
        refuse(dict, "phases", valid);
    }
    if (has("grains"))
    {
        readGrains(phaseDict(dict, "grains"));
    }
    if (has("water"))
    {
        waterDensity_ = readNumber(
            phaseDict(dict, "water"),
            "rho",
            dimDensity,
            {0, GREAT, true, false, "density of the water, e.g. 1000 kg/m3"}
        );
    }
}


bool scenePreparation::hasWater(const label release) const
{
    return regionDicts_[release]->found("water");
}


waterScene scenePreparation::sceneOfWater() const
{
    return {waterDensity_, waterSpacing_, g_};
}


void scenePreparation::checkPhases(const dictionary& release) const
{
    bool any = false;
    for (const word& phase : {word("grains"), word("water")})
    {
        const bool there = optionalDictionary(release, phase);
        any = any || there;
        if (there && !has(phase))
        {
            refuse(
                release,
                phase,
                "This release holds " + phase
                    + ", but phases of constant/phaseProperties does not list "
                    + phase + ". Write phases (grains water); and the"
                    + " dictionary " + phase + " there, or take " + phase
                    + " out of the release"
            );
        }
    }
    if (!any)
    {
        refuse(
            release,
            word(),
            "This release holds neither grains nor water; write grains {"
            " solidFraction 0.6; }, water {}, or both for a wet bed"
        );
    }
}


void scenePreparation::checkPhasesUsed() const
{
    for (const word& phase : phases_)
    {
        bool used = false;
        for (const dictionary* release : regionDicts_)
        {
            used = used || release->found(phase);
        }
        if (!used)
        {
            FatalIOErrorInFunction(dict_.subDict("release"))
                << "phases of constant/phaseProperties lists " << phase
                << ", but no release holds any." << nl << "Write phases ("
                << (phase == "water" ? "grains" : "water")
                << "); there, or add " << phase << " to a release."
                << exit(FatalIOError);
        }
    }
}


void scenePreparation::readSpacingRatio()
{
    List<const dictionary*> places(regionDicts_);
    places.append(&dict_);
    const dictionary* first = nullptr;
    scalar ratio = 1;
    for (const dictionary* place : places)
    {
        const dictionary* water = optionalDictionary(*place, "water");
        if (place == &dict_ && water)
        {
            allowOnly(*water, {"spacingRatio"});
        }
        if (!water || !water->found("spacingRatio"))
        {
            continue;
        }
        const scalar given = readNumber(
            *water,
            "spacingRatio",
            dimless,
            {0.5,
             4,
             false,
             false,
             "spacing of the grains over that of the water, 2 for water twice"
             " as fine; drag joins the two, so they are not far apart"}
        );
        if (phases_.size() < 2)
        {
            refuse(
                *water,
                "spacingRatio",
                "It is the spacing of the grains over that of the water, and"
                " this case has only one of them: change spacing instead"
            );
        }
        if (first && mag(given - ratio) > 0)
        {
            refuse(
                *water,
                "spacingRatio",
                "It is " + Foam::name(given) + " here and " + Foam::name(ratio)
                    + " elsewhere, but all water of a case has one spacing."
                      " Write it once, water { spacingRatio ..; } at the top of"
                      " the dictionary"
            );
        }
        first = water;
        ratio = given;
    }
    waterSpacing_ = grid_.spacing / ratio;
}


void scenePreparation::layOut()
{
    const vector up = -g_ / mag(g_);
    forAll (regions_, i)
    {
        lattice own(grid_);
        own.origin = Zero;
        readLattice(dict_, ground_->origin(), own);
        readLattice(*regionDicts_[i], ground_->origin(), own);
        if (planeThickness_ > 0)
        {
            makePlaneStrain(
                planeNormal_,
                planeThickness_,
                boundaries_.subDict("planeStrain"),
                own
            );
        }
        scenes_.append(new releaseScene{*ground_, own, up});
        own.spacing = waterSpacing_;
        waterScenes_.append(new releaseScene{*ground_, own, up});
    }
}


void scenePreparation::fillReleases()
{
    checkCyclic();
    layOut();
    forAll (regions_, i)
    {
        checkSize(i);
        regions_[i].place(scenes_[i]);
        if (regionDicts_[i]->found("grains"))
        {
            bodies_.append(fillGrains(i));
        }
    }
    // beds first: free water gives way to them
    for (releaseBody& bed : bodies_)
    {
        if (hasWater(bed.release))
        {
            fillPores(bed);
        }
    }
    forAll (regions_, i)
    {
        if (!regionDicts_[i]->found("grains"))
        {
            fillFree(i);
        }
    }
    findReleaseHeight();
}


releaseBody scenePreparation::fillGrains(const label i)
{
    const dictionary& dict = *regionDicts_[i];
    const releaseScene& scene = scenes_[i];
    const dictionary& grains = dict.subDict("grains");
    allowOnly(grains, {"solidFraction", "mass"});
    releaseBody body;
    body.name = names_[i];
    body.release = i;
    body.axes = scene.grid.axes;
    body.solidFraction = readNumber(
        grains,
        "solidFraction",
        dimless,
        {0,
         0.74,
         true,
         false,
         "share of solid in the bulk volume; equal spheres reach 0.74"}
    );
    body.K0 = material_.K0;
    body.velocity = velocityOf(i);
    body.volume = regions_[i].volume();
    body.seeds = seedsOf(regions_[i]);
    body.latticeVolume = body.seeds.size() * scene.grid.particleVolume();
    if (body.seeds.empty())
    {
        FatalIOErrorInFunction(dict)
            << "Release " << body.name << " holds no particle: its volume is "
            << body.volume << " m3, that of a particle "
            << scene.grid.particleVolume() << " m3." << nl
            << "Is it on the free side of the ground (normals), and is the"
            << " spacing of " << grid_.spacing << " m smaller than it?"
            << exit(FatalIOError);
    }
    body.mass = readNumber(
        grains,
        "mass",
        dimMass,
        {0, GREAT, true, false, "total mass of the grains"},
        material_.rho * body.solidFraction * body.volume
    );
    return body;
}


vector scenePreparation::velocityOf(const label i) const
{
    const dictionary& dict = *regionDicts_[i];
    return dict.found("velocity") ? readVector(dict, "velocity", dimVelocity)
                                  : vector(Zero);
}


List<seed> scenePreparation::seedsOf(const releaseRegion& region) const
{
    DynamicList<seed> seeds;
    region.fill(seeds);
    keepInCyclicBox(seeds);
    return List<seed>(std::move(seeds));
}


waterBody scenePreparation::waterOf(const label i, const releaseRegion& region)
{
    waterBody body;
    body.release = i;
    body.region = &region;
    body.room = region.volume();
    body.velocity = velocityOf(i);
    body.axes = waterScenes_[i].grid.axes;
    body.seeds = seedsOf(region);
    body.latticeVolume =
        body.seeds.size() * waterScenes_[i].grid.particleVolume();
    return body;
}


void scenePreparation::checkHasWater(const waterBody& body) const
{
    if (body.seeds.empty())
    {
        const label i = body.release;
        refuse(
            *regionDicts_[i],
            "water",
            "Water of release " + names_[i]
                + " has no particle: there is room for " + Foam::name(body.room)
                + " m3 of it, a particle has "
                + Foam::name(waterScenes_[i].grid.particleVolume())
                + " m3.\nIs the release on the free side of the ground"
                  " (normals) and not within a bed of grains, and is the"
                  " spacing of the water, "
                + Foam::name(waterSpacing_)
                + " m, less than twice the thickness of the water?"
        );
    }
}


void scenePreparation::fillPores(releaseBody& bed)
{
    const label i = bed.release;
    const bedVolumes volumes{bed.volume, bed.mass / material_.rho};
    const waterContent content = readWaterInBed(
        regionDicts_[i]->subDict("water"), volumes, waterDensity_, bed.name
    );
    regions_[i].useLattice(waterScenes_[i]);
    waterBody body = waterOf(i, regions_[i]);
    checkHasWater(body);
    body.porosity = volumes.pores() / volumes.bulk;
    body.mass = content.mass - content.excess;
    const scalar S = body.mass / (waterDensity_ * volumes.pores());
    body.saturation = S < 1 - typed ? S : 1;
    if (body.isFull())
    {
        bed.buoyancy = waterDensity_ * volumes.solid / volumes.bulk;
    }
    waters_.append(std::move(body));
    if (content.excess > 0)
    {
        fillLayer(i, content.excess);
    }
}


void scenePreparation::fillLayer(const label i, const scalar mass)
{
    layers_.append(regions_[i].above(mass / waterDensity_).ptr());
    waterBody layer = waterOf(i, layers_.last());
    checkHasWater(layer);
    layer.mass = mass;
    waters_.append(std::move(layer));
}


void scenePreparation::fillFree(const label i)
{
    regions_[i].useLattice(waterScenes_[i]);
    waterBody body = waterOf(i, regions_[i]);
    checkHasWater(body);
    leaveOut(body);
    checkHasWater(body);
    body.mass = readFreeWater(
        regionDicts_[i]->subDict("water"), body.room, waterDensity_
    );
    waters_.append(std::move(body));
}


void scenePreparation::leaveOut(waterBody& body) const
{
    const auto within = [](const releaseRegion& region, const seed& s)
    { return region.depthAt(s.x) >= 0; };
    DynamicList<seed> kept;
    labelHashSet dry;
    for (const seed& s : body.seeds)
    {
        bool taken = false;
        for (const releaseBody& bed : bodies_)
        {
            if (within(regions_[bed.release], s))
            {
                taken = true;
                if (!hasWater(bed.release))
                {
                    dry.insert(bed.release);
                }
            }
        }
        for (const waterBody& water : waters_)
        {
            taken = taken || within(*water.region, s);
        }
        if (!taken)
        {
            kept.append(s);
        }
    }
    const scalar n = body.seeds.size();
    if (kept.size() < body.seeds.size())
    {
        Info << "Water of release " << names_[body.release]
             << " gives way to other releases: " << n - kept.size() << " of "
             << n << " particles and " << (1 - kept.size() / n) * body.room
             << " m3 are left out" << nl << nl;
    }
    for (const label bed : dry.sortedToc())
    {
        WarningInFunction
            << "Release " << names_[bed] << " stands in the water of release "
            << names_[body.release] << ", but its own pores are dry. Write"
            << " water { saturation 1; } into it if that is not meant." << endl;
    }
    body.room *= kept.size() / n;
    body.latticeVolume *= kept.size() / n;
    body.seeds.transfer(kept);
}


void scenePreparation::findReleaseHeight()
{
    // from the ground under the first layer up to the top
    for (const releaseBody& body : bodies_)
    {
        for (const seed& s : body.seeds)
        {
            releaseHeight_ = max(releaseHeight_, s.depth + 0.5 * grid_.spacing);
        }
    }
    forAll (waters_, b)
    {
        for (const seed& s : waters_[b].seeds)
        {
            releaseHeight_ =
                max(releaseHeight_,
                    waterOver(waters_, b, s, sceneOfWater()).height
                        + 0.5 * waterSpacing_);
        }
    }
}


pointField scenePreparation::positions() const
{
    pointField all(grains_.positions);
    all.append(water_.positions);
    return all;
}

} // namespace lpf
} // namespace Foam
