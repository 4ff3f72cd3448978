// SPDX-License-Identifier: GPL-3.0-or-later
#include "scenePreparation.H"
#include "inputCheck.H"
#include "OSspecific.H"
#include "waveSpeeds.H"

#include <algorithm>
#include <map>
#include <utility>

namespace Foam
{
namespace lpf
{

namespace
{

// Volume of the lattice and of the geometry differ by more: too coarse
constexpr scalar volumeTolerance = 0.02;

// Fewer particles through the thickness: the profile of velocity is lost
constexpr scalar fewLayers = 3;

struct layers
{
    label least = labelMax, most = 0;
    scalar mean = 0;
};

// Particles over each other in the columns of the lattice
layers countLayers(const UList<seed>& seeds)
{
    std::map<std::pair<label, label>, label> columns;
    for (const seed& s : seeds)
    {
        ++columns[{s.column[0], s.column[1]}];
    }
    layers result;
    for (const auto& column : columns)
    {
        result.least = min(result.least, column.second);
        result.most = max(result.most, column.second);
    }
    result.mean = scalar(seeds.size()) / scalar(columns.size());
    return result;
}


void printDuration(const scalar seconds)
{
    if (seconds < 120)
    {
        Info << seconds << " s";
    }
    else if (seconds < 7200)
    {
        Info << seconds / 60 << " min";
    }
    else
    {
        Info << seconds / 3600 << " h";
    }
}

} // namespace


void scenePreparation::reportGrains(const releaseBody& body) const
{
    const layers n = countLayers(body.seeds);
    const scalar difference = body.latticeVolume / body.volume - 1;
    Info << "    particles       " << body.seeds.size() << nl
         << "    mass            " << body.mass << " kg, "
         << body.mass / body.seeds.size() << " kg a particle" << nl
         << "    bulk volume     " << body.volume << " m3, bulk density "
         << body.mass / body.volume << " kg/m3, solid fraction "
         << body.solidFraction << nl << "    lattice volume  "
         << body.latticeVolume << " m3, " << 100 * difference << " %" << nl
         << "    layers          " << n.least << " to " << n.most << ", mean "
         << n.mean << nl;
    const scalar solid = body.solidFraction * material_.rho * body.volume;
    if (mag(body.mass / solid - 1) > volumeTolerance)
    {
        WarningInFunction
            << "Release " << body.name << ": mass " << body.mass
            << " kg, but density of the grain x solidFraction x volume is "
            << solid << " kg. The bulk density follows the mass; correct"
            << " solidFraction or volume if this is not meant." << endl;
    }
    if (mag(difference) > volumeTolerance)
    {
        WarningInFunction
            << "Release " << body.name << ": the lattice has "
            << 100 * mag(difference) << " % of volume "
            << (difference > 0 ? "more" : "less") << " than the geometry."
            << " Masses are exact all the same, but each particle stands for"
            << " a volume that its place does not have. A smaller spacing"
            << " helps, or one that divides the thickness." << endl;
    }
    if (n.mean < fewLayers)
    {
        WarningInFunction
            << "Release " << body.name << " is only " << n.mean
            << " particles thick on average; the velocity over the depth is"
            << " not resolved. Five need a spacing of "
            << grid_.spacing * n.mean / 5 << " m and "
            << std::pow(5 / n.mean, 3) << " times the particles." << endl;
    }
}


void scenePreparation::reportWater(const waterBody& body) const
{
    const layers n = countLayers(body.seeds);
    const scalar difference = body.latticeVolume / body.room - 1;
    const scalar full =
        waterDensity_ * body.saturation * body.porosity * body.room;
    const word& name = names_[body.release];
    Info << (body.porosity < 1 ? "  water in the pores" : "  free water") << nl
         << "    particles       " << body.seeds.size() << ", spacing "
         << waterSpacing_ << " m" << nl << "    mass            " << body.mass
         << " kg, " << body.mass / body.seeds.size() << " kg a particle" << nl
         << "    volume          " << body.mass / waterDensity_ << " m3 in "
         << body.room << " m3" << nl << "    lattice volume  "
         << body.latticeVolume << " m3, " << 100 * difference << " %" << nl
         << "    layers          " << n.least << " to " << n.most << ", mean "
         << n.mean << nl;
    if (mag(body.mass / full - 1) > volumeTolerance)
    {
        WarningInFunction
            << "Release " << name << ": mass " << body.mass
            << " kg of water, but its density x volume is " << full
            << " kg. The water starts compressed or expanded: correct mass or"
            << " geometry if this is not meant." << endl;
    }
    if (mag(difference) > volumeTolerance)
    {
        WarningInFunction
            << "Release " << name << ": the lattice of the water has "
            << 100 * mag(difference) << " % of volume "
            << (difference > 0 ? "more" : "less") << " than its geometry."
            << " Masses are exact all the same. A smaller spacing helps, or one"
            << " that divides the height." << endl;
    }
    // the grains of a bed speak for its water, and for that on top
    if (n.mean < fewLayers && !regionDicts_[body.release]->found("grains"))
    {
        WarningInFunction << "Release " << name << ": its water is only "
                          << n.mean << " particles thick on average; five need"
                          << " a water spacing of "
                          << waterSpacing_ * n.mean / 5 << " m." << endl;
    }
}


void scenePreparation::reportMixture(
    const releaseBody& bed, const scalar waterMass
) const
{
    const scalar solid = bed.mass / material_.rho;
    const scalar water = waterMass / waterDensity_;
    Info << "  wet bed" << nl << "    solid fraction  " << solid / bed.volume
         << "  solid over bulk volume" << nl << "    dryBulkFraction "
         << water / bed.volume << "  water over bulk volume" << nl
         << "    trueFraction    " << water / (solid + water)
         << "  water over solid and water" << nl << "    saturation      "
         << water / (bed.volume - solid) << "  water over pores" << nl
         << "    mass            " << bed.mass << " kg of grains, " << waterMass
         << " kg of water" << nl;
}


void scenePreparation::reportRelease(const label i) const
{
    Info << "Release " << names_[i] << nl;
    scalar water = 0;
    for (const releaseBody& body : bodies_)
    {
        if (body.release == i)
        {
            reportGrains(body);
        }
    }
    for (const waterBody& body : waters_)
    {
        if (body.release == i)
        {
            reportWater(body);
            water += body.mass;
        }
    }
    for (const releaseBody& body : bodies_)
    {
        if (body.release == i && water > 0)
        {
            reportMixture(body, water);
        }
    }
    Info << nl;
}


scalar scenePreparation::drop() const
{
    const vector up = -g_ / mag(g_);
    scalar top = -GREAT, low = GREAT;
    const pointField all = positions();
    for (const point& x : all)
    {
        top = max(top, up & x);
    }
    const tmp<pointField> ends = ground_->bounds().points();
    for (const point& x : ends())
    {
        low = min(low, up & x);
    }
    return top + 0.5 * grid_.spacing - low;
}


scalar scenePreparation::maxSpeed() const
{
    const scalar given = readNumber(
        dict_,
        "maxSpeed",
        dimVelocity,
        {0,
         GREAT,
         true,
         false,
         "it sets the stiffness of the grains; leave it out for free fall over"
         " the relief"},
        0
    );
    return given > 0 ? given
                     : Foam::sqrt(
                         sqr(largestVelocity())
                         + 2 * mag(g_) * max(drop(), releaseHeight_)
                     );
}


scalar scenePreparation::solidFraction() const
{
    scalar volume = 0, solid = 0;
    for (const releaseBody& body : bodies_)
    {
        volume += body.volume;
        solid += body.volume * body.solidFraction;
    }
    return solid / volume;
}


// That of the solver, in a bed as it is released
scalar scenePreparation::waveSpeed() const
{
    const dictionary phases(
        readDictionary(caseDir_ / "constant" / "phaseProperties")
    );
    stiffnessScale scale = {};
    scale.gH = mag(g_) * releaseHeight_;
    scale.maxSpeed = maxSpeed();
    autoPtr<elasticity> skeleton;
    if (has("grains"))
    {
        const dictionary& grains = phases.subDict("grains");
        scale.rhoBulk = material_.rho * solidFraction();
        skeleton.reset(new elasticity(
            grains.subDict(grains.get<word>("rheology") + "Coeffs"), scale
        ));
    }
    if (!has("water"))
    {
        return skeleton->c();
    }
    const autoPtr<equationOfState> water = equationOfState::New(
        phases.subDict("water"),
        soundScale(scale, skeleton.get(), material_.rho)
    );
    if (!has("grains"))
    {
        return water->c0();
    }
    return coupledSound(
        *water, 1 - solidFraction(), material_.rho, skeleton->c()
    );
}


runEstimate scenePreparation::estimate() const
{
    return estimateRun(
        {grains_.size(),
         water_.size(),
         smoothingRatio * min(grid_.spacing, waterSpacing_),
         releaseHeight_,
         waveSpeed(),
         endTime_}
    );
}


scalar scenePreparation::largestVelocity() const
{
    scalar largest = 0;
    for (const releaseBody& body : bodies_)
    {
        largest = max(largest, mag(body.velocity));
    }
    for (const waterBody& body : waters_)
    {
        largest = max(largest, mag(body.velocity));
    }
    return largest;
}


void scenePreparation::warnOfOldTimes() const
{
    const fileNameList folders = readDir(caseDir_, fileName::DIRECTORY);
    word found;
    for (const fileName& folder : folders)
    {
        scalar time = 0;
        if (readScalar(folder, time) && time > 0)
        {
            found = folder;
        }
    }
    if (!found.empty())
    {
        WarningInFunction
            << "Time folders of an earlier run stand in the case, e.g. "
            << found << ". startFrom latestTime would go on from them, with"
            << " other particles than those written now: remove them." << endl;
    }
}


void scenePreparation::report() const
{
    forAll (names_, i)
    {
        reportRelease(i);
    }
    const runEstimate run = estimate();
    const scalar fastest = maxSpeed();
    Info << "Expected" << nl;
    if (has("water"))
    {
        Info << "    particles       " << grains_.size() << " of grains, "
             << water_.size() << " of water" << nl;
    }
    Info << "    memory          " << run.memory / 1048576 << " MiB" << nl
         << "    largest speed   " << fastest
         << (dict_.found("maxSpeed") ? " m/s, given"
             : largestVelocity() > 0
                 ? " m/s, free fall over the relief from the velocity given"
                 : " m/s, free fall over the relief")
         << nl << "    wave speed      " << waveSpeed() << " m/s" << nl
         << "    time step       " << run.timeStep << " s" << nl;
    if (endTime_ > 0)
    {
        Info << "    steps           " << run.steps << " to endTime "
             << endTime_ << " s" << nl << "    wall time       ";
        const solverSpeed solver = measureSolver(run.stepOverPass);
        printDuration(
            run.steps * (grains_.size() + water_.size())
            / solver.particleStepsPerSecond
        );
        Info << " with " << solver.threads << " threads at "
             << solver.particleStepsPerSecond
             << " particle-steps/s, measured now on this machine" << nl;
    }
    Info << nl;
    if (fastest < largestVelocity())
    {
        WarningInFunction << "maxSpeed " << fastest
                          << " m/s is below the velocity of a"
                          << " release, " << largestVelocity()
                          << " m/s: the stiffness that"
                          << " follows from it is too low. Write at least that."
                          << endl;
    }
    warnOfOldTimes();
}

} // namespace lpf
} // namespace Foam
