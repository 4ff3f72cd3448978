// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenePreparation.H"
#include "inputCheck.H"
#include "waterContent.H"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

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
    const wordList given(readWords(dict, "phases", valid));
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
        if (frame_.planeThickness > 0)
        {
            makePlaneStrain(
                frame_.planeNormal,
                frame_.planeThickness,
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
    }
    checkMemory();
    forAll (regions_, i)
    {
        regions_[i].place(scenes_[i]);
        if (regionDicts_[i]->found("grains"))
        {
            bodies_.append(fillGrains(i));
        }
    }
    checkApart();
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


namespace
{

//- What the cyclic planes leave of a release, share, is said; of a given mass
//  nobody knows which part it is
void checkCut(const dictionary& grains, const word& name, const scalar share)
{
    if (share < 1)
    {
        if (grains.found("mass"))
        {
            refuse(
                grains,
                "mass",
                "The cyclic planes cut " + Foam::name(100 * (1 - share))
                    + " % off release " + name
                    + ": which share of this mass lies between them? Let the"
                      " release end at the planes, or leave mass out: it is"
                      " then density x solidFraction x the volume between them"
            );
        }
        Info << "Release " << name << ": the cyclic planes cut "
             << 100 * (1 - share) << " % of its volume off" << nl << nl;
    }
}

} // namespace


releaseBody scenePreparation::fillGrains(const label i)
{
    const dictionary& dict = *regionDicts_[i];
    const releaseScene& scene = scenes_[i];
    const dictionary& grains =
        neededDictionary(dict, "grains", "write grains { solidFraction 0.6; }");
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
    scalar share = 1;
    body.seeds = seedsOf(regions_[i], share);
    body.volume = share * regions_[i].volume();
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
    checkCut(grains, body.name, share);
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


List<seed>
scenePreparation::seedsOf(const releaseRegion& region, scalar& share) const
{
    DynamicList<seed> seeds;
    region.fill(seeds);
    const scalar all = seeds.size();
    keepInCyclicBox(seeds);
    share = all > 0 ? seeds.size() / all : 1;
    return List<seed>(std::move(seeds));
}


waterBody scenePreparation::waterOf(const label i, const releaseRegion& region)
{
    waterBody body;
    body.release = i;
    body.region = &region;
    body.velocity = velocityOf(i);
    body.axes = waterScenes_[i].grid.axes;
    scalar share = 1;
    body.seeds = seedsOf(region, share);
    body.room = share * region.volume();
    const dictionary& water = regionDicts_[i]->subDict("water");
    if (share < 1 && water.found("mass"))
    {
        refuse(
            water,
            "mass",
            "The cyclic planes cut " + Foam::name(100 * (1 - share))
                + " % off the water of release " + names_[i]
                + ": which share of this mass lies between them? Let the"
                  " release end at the planes, or give the water by volume"
        );
    }
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
        fillLayer(i, content.excess, bed.volume / regions_[i].volume());
    }
}


void scenePreparation::fillLayer(
    const label i, const scalar mass, const scalar share
)
{
    // over the whole bed; what the cyclic planes cut off goes with its share
    layers_.append(regions_[i].above(mass / waterDensity_ / share).ptr());
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


namespace
{

using cellKey = std::array<label, 3>;

cellKey cellOf(const point& x, const scalar side)
{
    return {
        label(std::floor(x.x() / side)),
        label(std::floor(x.y() / side)),
        label(std::floor(x.z() / side))};
}

//- Seeds of `others` with one of `body` nearer than a distance
label countNear(
    const releaseBody& body, const releaseBody& others, const scalar distance
)
{
    using placed = std::pair<cellKey, label>;
    std::vector<placed> cells;
    cells.reserve(std::size_t(body.seeds.size()));
    forAll (body.seeds, i)
    {
        cells.push_back({cellOf(body.seeds[i].x, distance), i});
    }
    std::sort(cells.begin(), cells.end());
    const auto anyNear = [&](const point& x)
    {
        const cellKey at = cellOf(x, distance);
        for (label k = 0; k < 9; ++k)
        {
            // three cells along z follow each other
            const cellKey first = {
                at[0] + k % 3 - 1, at[1] + k / 3 - 1, at[2] - 1};
            const cellKey last = {first[0], first[1], at[2] + 2};
            for (auto c = std::lower_bound(
                     cells.begin(), cells.end(), placed(first, -1)
                 );
                 c != cells.end() && c->first < last;
                 ++c)
            {
                if (magSqr(body.seeds[c->second].x - x) < sqr(distance))
                {
                    return true;
                }
            }
        }
        return false;
    };
    boundBox box(boundBox::invertedBox);
    for (const seed& s : body.seeds)
    {
        box.add(s.x);
    }
    label near = 0;
    for (const seed& s : others.seeds)
    {
        near += box.overlaps(s.x, sqr(distance)) && anyNear(s.x);
    }
    return near;
}

} // namespace


// Grains in the same place twice: their mass would be doubled, and the first
// step throw them apart
void scenePreparation::checkApart() const
{
    const scalar least = 0.5 * grid_.spacing;
    forAll (bodies_, a)
    {
        for (label b = a + 1; b < bodies_.size(); ++b)
        {
            const label near = countNear(bodies_[a], bodies_[b], least);
            if (near > 0)
            {
                FatalIOErrorInFunction(*regionDicts_[bodies_[b].release])
                    << "Releases " << bodies_[a].name << " and "
                    << bodies_[b].name << " overlap: " << near
                    << " particles of " << bodies_[b].name
                    << " stand nearer than half a spacing, " << least
                    << " m, to one of " << bodies_[a].name
                    << ". The mass there would be counted twice." << nl
                    << "Move them apart, cut one of them, or give releases"
                    << " that touch the same lattice." << exit(FatalIOError);
            }
        }
    }
}


// With coarse columns, for those of a spacing much too fine would take hours
scalar scenePreparation::roughVolume(const label i) const
{
    constexpr scalar columns = 1e4;
    const vector span = regions_[i].plan().span();
    const scalar coarse = sqrt(span.x() * span.y() / columns);
    const scalar box = span.x() * span.y();
    if (coarse <= grid_.spacing || frame_.isPlane() || !(box > 0))
    {
        return 0;
    }
    lattice own(scenes_[i].grid);
    own.spacing = coarse;
    const releaseScene rough{*ground_, own, scenes_[i].up};
    autoPtr<releaseRegion> probe =
        releaseRegion::New(*regionDicts_[i], {caseDir_, own.axes});
    probe->place(rough);
    return probe->volume();
}


void scenePreparation::checkMemory() const
{
    scalar grains = 0, water = 0;
    forAll (regions_, i)
    {
        const scalar volume = roughVolume(i);
        if (regionDicts_[i]->found("grains"))
        {
            grains += volume / scenes_[i].grid.particleVolume();
        }
        if (hasWater(i))
        {
            water += volume / waterScenes_[i].grid.particleVolume();
        }
    }
    refuseMemory(grains, water);
}


void scenePreparation::refuseMemory(const scalar grains, const scalar water)
    const
{
    constexpr scalar share = 0.8, GiB = 1073741824;
    if (!(max(grains, water) > 0))
    {
        return;
    }
    const scalar need = memoryOf(grains, water), have = machineMemory();
    const scalar most = min(share * have / need, labelMax / max(grains, water));
    if (most < 1)
    {
        const dictionary& where =
            dict_.found("spacing") ? dict_ : dict_.subDict("release");
        // two digits, rounded up
        const scalar fits = grid_.spacing * std::cbrt(1 / most);
        const scalar digit = std::pow(10, std::floor(std::log10(fits)) - 1);
        refuse(
            where,
            "spacing",
            "A spacing of " + Foam::name(grid_.spacing) + " m gives "
                + Foam::name(grains + water) + " particles, which need "
                + Foam::name(need / GiB) + " GiB; this machine has "
                + Foam::name(have / GiB) + " GiB. Write spacing "
                + Foam::name(digit * std::ceil(fits / digit))
                + "; or more, if the spacing is meant in metres"
        );
    }
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
