// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseRun.H"

#include "dictionaryText.H"
#include "engineLoader.H"
#include "inputCheck.H"
#include "releaseCheck.H"
#include "sceneFrame.H"
#include "uniformTime.H"
#include "waveSpeeds.H"

#include <omp.h>

#include <stdexcept>

namespace Foam
{
namespace lpf
{

namespace
{

//- Grains that leave this far above the ground are taken out, times the extent
constexpr scalar headroom = 0.5;

cyclicBox
readCyclic(const dictionary& dict, const point& origin, const scalar h)
{
    cyclicBox box;
    for (const cyclicPair& pair : readSceneFrame(dict).cyclic)
    {
        const direction d = pair.axis;
        box.lower[d] = pair.from - origin[d];
        box.period[d] = pair.to - pair.from;
        if (box.period[d] < 2 * h)
        {
            refuse(
                dict.subDict("cyclic"),
                pair.name(),
                "The period of " + Foam::name(box.period[d])
                    + " m is shorter than the support of the kernel, "
                    + Foam::name(2 * h)
                    + " m: a grain would be its own neighbour. Write a "
                      "longer period or take a smaller spacing"
            );
        }
    }
    return box;
}

//- FatalIOError where particles stand outside the cyclic planes: they would
//  jump by a period in the first step, into others
void checkInside(
    const pointField& particles,
    const cyclicBox& box,
    const scalar spacing,
    const dictionary& boundary
)
{
    const scalar little = 1e-5 * spacing;
    for (direction d = 0; d < 3; ++d)
    {
        label outside = 0;
        for (const point& x : particles)
        {
            const scalar s = x[d] - box.lower[d];
            outside += box.period[d] > 0
                    && (s < -little || s > box.period[d] + little);
        }
        if (outside > 0)
        {
            refuse(
                boundary.subDict("cyclic"),
                d == 0 ? "x" : "y",
                Foam::name(outside) + " of " + Foam::name(particles.size())
                    + " particles stand outside these cyclic planes. Run "
                      "terrainToParticles again, or move the planes"
            );
        }
    }
}

//- A number that terrainToParticles wrote
scalar
prepared(const dictionary& release, const word& key, const dimensionSet& dims)
{
    bounds limits;
    limits.lower = 0;
    limits.lowerOpen = key != "maxSpeed" && key != "releaseHeight";
    limits.reason = "terrainToParticles writes it; run it again";
    return readNumber(release, key, dims, limits);
}

const lpfPairs::pairEngine& engineNamed(const word& instructionSet)
{
    try
    {
        return lpfPairs::loadPairEngine(instructionSet);
    }
    catch (const std::runtime_error& e)
    {
        FatalErrorInFunction << e.what() << exit(FatalError);
        throw;
    }
}

const char* const remedyOfOldTimes =
    "Remove the old times (foamListTimes -rm), or write startFrom startTime; "
    "startTime 0;";

string listed(const wordList& words)
{
    string all;
    for (const word& w : words)
    {
        all += (all.empty() ? "(" : " ") + w;
    }
    return all + ")";
}

//- Stop with what is wrong with a file of the state
[[noreturn]] void refuseFile(const fileName& file, const string& message)
{
    FatalIOError("", "", 0, file, -1, -1)
        << message.c_str() << exit(FatalIOError);
    throw;
}

//- Range that a scalar of the state has in any run
struct stateRange
{
    word field;
    scalar lower, upper;
    bool lowerOpen;
    const char *unit, *rule;
};

const std::vector<stateRange>& stateRanges()
{
    static const char* const massive =
        "a density is greater than 0 and at most 20000 kg/m3";
    static const std::vector<stateRange> all = {
        {"mass", 0, GREAT, true, " kg", "it would not move"},
        {"rho", 0, 2e4, true, " kg/m3", massive},
        {"rhoRef", 0, 2e4, true, " kg/m3", massive},
        // 0: not seen yet, in the first step of all
        {"meanTheta",
         0,
         1,
         false,
         "",
         "it is the share of the volume around it that is not grains, from 0 "
         "to 1"},
        {"lag",
         -2,
         2,
         false,
         "",
         "compression beside the ground is a share of the density, within -2 "
         "and 2"}};
    return all;
}

//- FatalIOError where a field of the state is out of its range, or a particle
//  faster than anything that slides; directory: of the fields
void checkRanges(
    const cloudState& cloud, const fileName& directory, const string& remedy
)
{
    const auto refuse =
        [&](label i, const word& field, scalar value, const string& rule)
    {
        refuseFile(
            directory / field,
            "Particle " + Foam::name(i) + " has a " + field + " of "
                + Foam::name(value) + rule + ". " + remedy
        );
    };
    for (const stateRange& range : stateRanges())
    {
        const auto values = cloud.scalars.cfind(range.field);
        for (label i = 0; values.found() && i < values.val().size(); ++i)
        {
            const scalar a = values.val()[i];
            const bool low =
                range.lowerOpen ? !(a > range.lower) : !(a >= range.lower);
            if (low || !(a <= range.upper))
            {
                refuse(
                    i, range.field, a, range.unit + (": " + string(range.rule))
                );
            }
        }
    }
    const vectorField& U = cloud.vectors["U"];
    forAll (U, i)
    {
        if (!(mag(U[i]) <= fastestSlide))
        {
            refuse(
                i,
                "U",
                mag(U[i]),
                " m/s: nothing that slides is faster than 10000 m/s"
            );
        }
    }
}

//- FatalIOError where a run has written a time, but its state is gone: it would
//  start anew, with another density and an empty ledger
void checkStart(const cloudState& cloud, const fileName& stateFile)
{
    for (const word& name : {word("rho"), word("rhoRef")})
    {
        if (cloud.scalars.found(name))
        {
            refuseFile(
                stateFile,
                "The file does not exist, but the particles beside it have a "
                    + name
                    + ", as a run writes it: it cannot go on without its "
                      "ledger "
                      "and its time step\nGo on from an earlier time"
            );
        }
    }
}

string remedyOf(const bool continued, const wordList& missing)
{
    if (!continued)
    {
        return "Run terrainToParticles again";
    }
    string remedy("Go on from an earlier time");
    if (missing.found("toGround") || missing.found("meanTheta"))
    {
        remedy += ", or, where no time of the run has it, from 0: an older "
                  "version wrote them";
    }
    if (missing.found("lag"))
    {
        remedy += ", or write groundLag 0; in water of system/lpfSolution, "
                  "where the run so far had none";
    }
    if (missing.found("traction"))
    {
        remedy += ", or write frictionAt grains; in grains of "
                  "system/lpfSolution, where the run so far had that";
    }
    return remedy;
}

//- Fields without which there is no state; from a run, also those that it has
//  made
void checkFields(
    const cloudState& cloud,
    const fileName& dir,
    const word& phase,
    const bool continued,
    const madeFields& made
)
{
    wordList missing;
    const auto need = [&](const auto& fields, const wordList& names)
    {
        for (const word& name : names)
        {
            if (!fields.found(name))
            {
                missing.append(name);
            }
        }
    };
    need(cloud.labels, {"id", "zone"});
    need(cloud.vectors, {"U"});
    need(cloud.scalars, {"mass", "alpha", "h"});
    if (phase == "grains")
    {
        need(cloud.symmTensors, {"sigma"});
    }
    else
    {
        need(cloud.scalars, {"p", "S"});
    }
    if (continued)
    {
        need(cloud.scalars, made.scalars);
        need(cloud.vectors, made.vectors);
    }
    const fileName file(dir / "lagrangian" / phase);
    const string remedy(remedyOf(continued, missing));
    if (missing.size())
    {
        refuseFile(file / missing[0], "The file does not exist\n" + remedy);
    }
    checkRanges(cloud, file, remedy);
}

//- FatalIOError where the particles are not those of the present release
void checkSmoothing(
    const cloudState& cloud,
    const fileName& dir,
    const word& phase,
    const scalar smoothingLength
)
{
    // a time written as text has six digits
    constexpr scalar rounding = 1e-5;
    for (const scalar h : cloud.scalars["h"])
    {
        if (mag(h - smoothingLength) > rounding * smoothingLength)
        {
            refuseFile(
                dir / "lagrangian" / phase / "h",
                "The smoothing length of these particles is " + Foam::name(h)
                    + " m, that of constant/releaseProperties "
                    + Foam::name(smoothingLength)
                    + " m: this time is of another spacing. " + remedyOfOldTimes
            );
        }
    }
}

//- Particles outside are taken out: what lies over the ground and a headroom
boundBox domainOf(
    const boundBox& groundBox,
    const pointField& particles,
    const sceneProperties& scene
)
{
    boundBox domain(groundBox);
    domain.add(particles);
    const scalar g = mag(scene.g);
    const vector up = g > 0 ? vector(-scene.g / g) : vector(0, 0, 1);
    const scalar margin = 4 * scene.largestH;
    const vector above = headroom * domain.mag() * up;
    const boundBox low(domain);
    domain.add(boundBox(low.min() + above, low.max() + above));
    return boundBox(
        domain.min() - vector::uniform(margin),
        domain.max() + vector::uniform(margin)
    );
}

} // namespace

caseRun::caseRun(const fileName& caseDir)
    : caseDir_(caseDir), control_(caseDir),
      boundary_(readDictionary(caseDir / "constant" / "boundaryProperties")),
      phases_(readDictionary(caseDir / "constant" / "phaseProperties")),
      release_(readDictionary(
          caseDir / "constant" / "releaseProperties",
          "terrainToParticles writes it: run that first"
      ))
{
    warnOfEditedRelease();
    noteSettings("boundaryProperties");
    noteSettings("phaseProperties");
    readPhases();
    const word isa = readSolution();
    checkDensities();
    ground_ = ground::read(caseDir);
    groundFingerprint_ = ground::fingerprint(caseDir);
    readScene();
    makeContact();
    const lpfPairs::pairEngine& engine = engineNamed(isa);
    if (has("grains"))
    {
        makeGrains(engine);
    }
    if (has("water"))
    {
        makeWater(engine);
    }
    if (has("grains") && has("water"))
    {
        makeCoupling(engine);
    }
    printSetup(engine);
    integration_->prepare(flow_);
    readState();
    removeUnfinishedTimes(caseDir);
    if (running())
    {
        openSeries();
    }
    runControl::catchSignals();
    began_ = lastLog_ = wallClock::now();
    lastIndex_ = control_.index;
}

void caseRun::warnOfAbsent(const dictionary& dict) const
{
    for (const word& name : {word("grains"), word("water")})
    {
        if (!has(name) && dict.found(name))
        {
            WarningInFunction
                << "The dictionary of " << name << " in " << dict.name()
                << " is not used: phases does not list it" << endl;
        }
    }
}

void caseRun::readPhases()
{
    allowOnly(phases_, {"phases", "grains", "water"});
    const wordList known({"grains", "water"});
    if (!phases_.found("phases"))
    {
        refuse(
            phases_,
            "phases",
            "What moves is not named; write phases (grains); or (water); or "
            "(grains water);"
        );
    }
    names_ = readWords(
        phases_,
        "phases",
        "write phases (grains); or (water); or (grains water);"
    );
    for (const word& name : names_)
    {
        if (!known.found(name))
        {
            refuse(
                phases_,
                "phases",
                name
                    + " is not a phase; write phases (grains); or (water); "
                      "or (grains water);"
            );
        }
    }
    if (names_.empty() || (names_.size() == 2 && names_[0] == names_[1])
        || names_.size() > 2)
    {
        refuse(
            phases_,
            "phases",
            "Each phase once; write phases (grains); or (water); or (grains "
            "water);"
        );
    }
    warnOfAbsent(phases_);
    readMaterials();
}

namespace
{

// 2.6 for 2.6 g/cm3
void warnOfLight(const word& phase, const scalar rho)
{
    constexpr scalar lightest = 50;
    if (rho < lightest)
    {
        WarningInFunction << "rho " << rho << " kg/m3 of " << phase
                          << " is that of a gas; 1 g/cm3 is rho 1000" << endl;
    }
}

} // namespace

void caseRun::readMaterials()
{
    if (has("grains"))
    {
        const dictionary& grains = neededDictionary(
            phases_,
            "grains",
            "write grains { rho 2600; diameter 0.005; rheology muI; "
            "muICoeffs {} }"
        );
        allowOnly(
            grains, {"rho", "diameter", "rheology"}, granularRheology::names()
        );
        bounds positive;
        positive.lower = 0;
        positive.lowerOpen = true;
        positive.upper = 2e4;
        positive.reason = "the density of the grain material, e.g. 2600 kg/m3";
        grainDensity_ = readNumber(grains, "rho", dimDensity, positive);
        warnOfLight("grains", grainDensity_);
    }
    if (has("water"))
    {
        allowOnly(
            neededDictionary(
                phases_,
                "water",
                "write water { rho 1000; NewtonianCoeffs { mu 1e-3; } }"
            ),
            {"rho", "equationOfState", "TaitCoeffs", "viscosity"},
            viscosityModel::names(),
            viscosityModel::usual
        );
    }
}

void caseRun::readScene()
{
    scene_.spacing = prepared(release_, "spacing", dimLength);
    scene_.h = prepared(release_, "smoothingLength", dimLength);
    scene_.dimensions = label(prepared(release_, "dimensions", dimless));
    scene_.planeThickness = release_.getOrDefault<scalar>("planeThickness", 1);
    scene_.planeNormal =
        release_.getOrDefault<vector>("planeNormal", vector(0, 1, 0));
    scene_.g = readGravity(caseDir_);
    if (scene_.dimensions == 2)
    {
        checkGravityInPlane(caseDir_, scene_.planeNormal);
    }

    waterScene_ = scene_;
    if (names_.size() > 1)
    {
        waterScene_.spacing = prepared(release_, "waterSpacing", dimLength);
        waterScene_.h = prepared(release_, "waterSmoothingLength", dimLength);
    }
    scene_.largestH = max(scene_.h, waterScene_.h);
    scene_.cyclic = readCyclic(boundary_, ground_->origin(), scene_.largestH);
    waterScene_.largestH = scene_.largestH;
    waterScene_.cyclic = scene_.cyclic;
    checkSceneFrame(boundary_, release_);

    releaseHeight_ = prepared(release_, "releaseHeight", dimLength);
    maxSpeed_ = prepared(release_, "maxSpeed", dimVelocity);
    if (stop_.speed <= 0)
    {
        stop_.speed = 0.1 * sqrt(mag(scene_.g) * scene_.spacing);
    }
    if (stop_.after <= 0)
    {
        stop_.after = timeToMove();
    }
}

scalar caseRun::timeToMove() const
{
    return 2 * sqrt(releaseHeight_ / mag(scene_.g));
}

// What terrainToParticles made masses and stress with
void caseRun::checkDensities() const
{
    for (const word& name : names_)
    {
        const dictionary* made = release_.findDict(name);
        const dictionary& given = phases_.subDict(name);
        if (!made || !made->found("rho"))
        {
            continue;
        }
        bounds any;
        const scalar before = readNumber(*made, "rho", dimDensity, any);
        const scalar now = readNumber(given, "rho", dimDensity, any);
        if (mag(now - before) > 1e-9 * mag(before))
        {
            refuse(
                given,
                "rho",
                "rho = " + Foam::name(now)
                    + " kg/m3, but the particles are made with "
                    + Foam::name(before)
                    + " kg/m3: their masses do not fit. Run "
                      "terrainToParticles again, or take the change back"
            );
        }
    }
}

// At rest behind a gate is no end: not before the last zone has opened and
// what it held had the time to move
void caseRun::waitForOpenings()
{
    const scalar last = contact_->lastOpening();
    if (stop_.criterion != "none" && stop_.after <= last)
    {
        stop_.after = last + timeToMove();
    }
}

namespace
{

//- Of grains, unless a case asks for another: the scheme of the verification
schemeProperties standardScheme()
{
    schemeProperties scheme;
    scheme.bulkDamping = 0.1;
    scheme.shearDamping = 0.1;
    scheme.densityRelaxation = 0.1;
    scheme.shifting = 1;
    scheme.stressDiffusion = 0.02;
    return scheme;
}

const schemeProperties standard = standardScheme();

} // namespace

void caseRun::readDamping(const dictionary& dict)
{
    bounds alpha;
    alpha.lower = 0;
    alpha.upper = 1;
    alpha.reason = "it is Monaghan's alpha; above 0.1 the answer is the "
                   "scheme's, not the material's; write 0 or 0.01";
    scheme_.artificialViscosity =
        readNumber(dict, "artificialViscosity", dimless, alpha, 0);

    bounds beta;
    beta.lower = 0;
    beta.upper = 2;
    beta.reason = "it damps what is not smooth between neighbours; above 2 "
                  "the step is not stable; write 0 to 0.5";
    scheme_.noiseDamping = readNumber(dict, "noiseDamping", dimless, beta, 0);

    beta.upper = 1;
    beta.reason = "it damps waves of compression; above 1 the step is not "
                  "stable; write 0 to 0.5";
    scheme_.bulkDamping =
        readNumber(dict, "bulkDamping", dimless, beta, standard.bulkDamping);
    beta.reason = "it damps waves of shear; above 1 the step is not stable; "
                  "write 0 to 0.3";
    scheme_.shearDamping =
        readNumber(dict, "shearDamping", dimless, beta, standard.shearDamping);
}

word caseRun::readSolution()
{
    const dictionary dict(readDictionary(caseDir_ / "system" / "lpfSolution"));
    allowOnly(
        dict,
        {"CFL",
         "artificialViscosity",
         "noiseDamping",
         "bulkDamping",
         "shearDamping",
         "grains",
         "water",
         "instructionSet",
         "precision",
         "timeIntegration",
         "logInterval",
         "stop"}
    );
    integration_ = timeIntegration::New(dict);

    bounds CFL;
    CFL.lower = 0;
    CFL.lowerOpen = true;
    CFL.upper = 1;
    CFL.reason = "above 1 a wave passes a smoothing length in one step and "
                 "the run blows up; write 0.45";
    scheme_.CFL = readNumber(dict, "CFL", dimless, CFL, standard.CFL);

    readDamping(dict);
    logInterval_ =
        readInteger(dict, "logInterval", 1, labelMax, "a number of steps", 100);

    scene_.single = waterScene_.single =
        readChoice(dict, "precision", {"double", "single"}, "double")
        == "single";

    warnOfAbsent(dict);
    const dictionary* grains = optionalDictionary(dict, "grains");
    readGrainScheme(grains ? *grains : dictionary::null);
    if (const dictionary* water = optionalDictionary(dict, "water"))
    {
        readWaterScheme(*water);
    }
    waterScheme_.CFL = scheme_.CFL;
    if (const dictionary* stop = optionalDictionary(dict, "stop"))
    {
        readStop(*stop);
    }
    return readChoice(
        dict,
        "instructionSet",
        {"auto", "x86-64-v2", "x86-64-v3", "x86-64-v4"},
        "auto"
    );
}

void caseRun::readGrainScheme(const dictionary& dict)
{
    allowOnly(
        dict, {"densityRelaxation", "shifting", "stressDiffusion", "frictionAt"}
    );
    frictionAt_ =
        readChoice(dict, "frictionAt", {"auto", "grains", "ground"}, "auto");
    bounds d;
    d.lower = 0;
    d.upper = 0.2;
    d.reason = "it smooths the stress of neighbours beyond a linear one; above "
               "0.2 a step of a large CFL overshoots; write 0 to 0.1";
    scheme_.stressDiffusion = readNumber(
        dict, "stressDiffusion", dimless, d, standard.stressDiffusion
    );
    bounds k;
    k.lower = 0;
    k.upper = 1;
    k.reason = "it draws the density to what the packing of the particles "
               "says where they shear; above 1 it makes noise; write 0 or 1";
    scheme_.densityRelaxation = readNumber(
        dict, "densityRelaxation", dimless, k, standard.densityRelaxation
    );
    k.reason = "it moves particles apart where they are crowded and shear; "
               "above 1 a step takes them too far; write 0 or 1";
    scheme_.shifting =
        readNumber(dict, "shifting", dimless, k, standard.shifting);
}

void caseRun::readWaterScheme(const dictionary& dict)
{
    allowOnly(
        dict,
        {"artificialViscosity",
         "densityDiffusion",
         "densityRelaxation",
         "shifting",
         "groundLag",
         "viscosityIntegration"}
    );
    viscosityIntegration_ = readChoice(
        dict, "viscosityIntegration", {"auto", "explicit", "implicit"}, "auto"
    );
    bounds alpha;
    alpha.lower = 0;
    alpha.upper = 1;
    alpha.reason = "it is Monaghan's alpha; above 0.1 the answer is the "
                   "scheme's, not the material's; write 0 to 0.05";
    waterScheme_.artificialViscosity = readNumber(
        dict,
        "artificialViscosity",
        dimless,
        alpha,
        waterScheme_.artificialViscosity
    );
    bounds delta;
    delta.lower = 0;
    delta.upper = 0.5;
    delta.reason = "it smooths the density of the water; above 0.5 the step "
                   "is not stable; write 0.1";
    waterScheme_.densityDiffusion = readNumber(
        dict, "densityDiffusion", dimless, delta, waterScheme_.densityDiffusion
    );
    bounds kappa;
    kappa.lower = 0;
    kappa.upper = 0.01;
    kappa.reason = "it draws the density to what the packing of the particles "
                   "says; above 0.01 it makes noise; write 0.0003";
    waterScheme_.densityRelaxation = readNumber(
        dict,
        "densityRelaxation",
        dimless,
        kappa,
        waterScheme_.densityRelaxation
    );
    bounds shift;
    shift.lower = 0;
    shift.upper = 10;
    shift.reason = "it moves particles of water apart where they are crowded; "
                   "above 10 a step takes them too far; write 0 or 3";
    waterScheme_.shifting =
        readNumber(dict, "shifting", dimless, shift, waterScheme_.shifting);
    readGroundLag(dict);
}

void caseRun::readGroundLag(const dictionary& dict)
{
    bounds lag;
    lag.lower = 0;
    lag.upper = 1000;
    lag.reason = "times h/c0 after which the density of water that came to the "
                 "ground follows its packing; above 1000 it hardly does; write "
                 "10, or 0 for never";
    groundLagIsGiven_ = dict.found("groundLag");
    // particles that are shifted leave their packing behind anyway
    waterScheme_.groundLag = readNumber(
        dict,
        "groundLag",
        dimless,
        lag,
        waterScheme_.shifting > 0 ? 0 : waterScheme_.groundLag
    );
    if (waterScheme_.shifting > 0 && waterScheme_.groundLag > 0)
    {
        WarningInFunction
            << "shifting " << waterScheme_.shifting << " and groundLag "
            << waterScheme_.groundLag << " together are worse than either: "
            << "what is shifted and flows back changes the density each time. "
            << "Leave groundLag out, which is then 0" << endl;
    }
    if (dict.found("groundLag") && waterScheme_.groundLag > 0
        && groundContact::asksPenalty(boundary_))
    {
        refuse(
            dict,
            "groundLag",
            "groundLag = " + Foam::name(waterScheme_.groundLag)
                + " takes back what the images of water behind the ground do "
                  "to its density, and contact penalty of "
                  "constant/boundaryProperties has no images; leave it out, or "
                  "write contact signedDistance"
        );
    }
}

void caseRun::readStop(const dictionary& stop)
{
    allowOnly(stop, {"criterion", "share", "speed", "after"});
    stop_.criterion = readChoice(
        stop, "criterion", {"movingMass", "kineticEnergy", "none"}, "none"
    );
    bounds share;
    share.lower = 0;
    share.upper = 1;
    share.reason = "a share of the mass or of the peak energy, e.g. 0.01";
    stop_.share = readNumber(stop, "share", dimless, share, 0.01);
    bounds notNegative;
    notNegative.lower = 0;
    notNegative.reason = "it cannot be negative";
    stop_.speed = readNumber(stop, "speed", dimVelocity, notNegative, 0);
    stop_.after = readNumber(stop, "after", dimTime, notNegative, 0);
}

stiffnessScale caseRun::scale() const
{
    stiffnessScale s = {};
    if (has("grains"))
    {
        s.rhoBulk = grainDensity_
                  * prepared(
                        neededDictionary(
                            release_, "grains", "run terrainToParticles again"
                        ),
                        "solidFraction",
                        dimless
                  );
    }
    s.gH = mag(scene_.g) * releaseHeight_;
    s.maxSpeed = maxSpeed_;
    return s;
}

void caseRun::makeContact()
{
    contact_.reset(new groundContact(
        *ground_,
        boundary_,
        min(scene_.spacing, waterScene_.spacing),
        2 * scene_.largestH + scene_.spacing,
        scene_.dimensions == 2 ? scene_.planeThickness : 0,
        scene_.planeNormal
    ));
    waitForOpenings();
    chooseFrictionAt();
    if (contact_->penalty())
    {
        waterScheme_.groundLag = 0; // there are no images
        printPenalty();
    }
}

// Where friction can act at the ground it does, unless asked for
void caseRun::chooseFrictionAt()
{
    if (frictionAt_ == "ground")
    {
        checkFrictionAtGround();
    }
    scheme_.frictionAtGround =
        frictionAt_ == "ground"
        || (frictionAt_ == "auto" && !contact_->penalty()
            && !contact_->anyResistance(&groundZone::grains));
}

// A traction that goes with the speed acts on the grains, and what a penalty
// pushes back has friction on that impulse
void caseRun::checkFrictionAtGround() const
{
    if (!has("grains"))
    {
        return;
    }
    const string given("frictionAt ground; in grains of system/lpfSolution ");
    if (contact_->penalty())
    {
        refuse(
            boundary_,
            "contact",
            "contact = penalty: " + given
                + "leads the velocity of grains on to the ground that mirrors "
                  "them, and a penalty does not. Write contact signedDistance, "
                  "or frictionAt grains"
        );
    }
    const wordList& zones = ground_->zones();
    forAll (zones, k)
    {
        if (contact_->zone(k).grains->resists())
        {
            refuse(
                boundary_.subDict("zones"),
                zones[k],
                "zone " + zones[k]
                    + " has friction that goes with the speed or holds the "
                      "grains: "
                    + given
                    + "is made for Coulomb and none. Write one of these, or "
                      "frictionAt grains"
            );
        }
    }
}

void caseRun::printPenalty() const
{
    const scalar omega = contact_->penalty()->omega;
    Info << nl << "contact penalty: the paper's eq. 24, omega "
         << (omega > 0 ? Foam::name(omega) + " m/s"
                       : string("the speed of sound of each phase"))
                .c_str()
         << ". It resists approach alone, so that what rests sinks until it is "
         << "stopped at " << contactShare << " of a spacing: look at contact "
         << "loss and contact impulse in the ledger. There is nothing behind "
            "the ground, so that stress "
         << "and pressure of the lowest layers are not to be used. contact "
         << "signedDistance has neither fault" << nl << endl;
}

void caseRun::makeGrains(const lpfPairs::pairEngine& engine)
{
    const dictionary& phase = phases_.subDict("grains");
    const word coeffs(granularRheology::nameOf(phase) + "Coeffs");
    const dictionary& numbers = neededDictionary(
        phase,
        coeffs,
        "write the numbers of the rheology into it, tutorials show how"
    );
    // terrainToParticles makes the state at the start with it
    readChoice(numbers, "initialStress", {"geostatic", "zero"}, "geostatic");
    const elasticity elastic(numbers, scale());
    checkWaveSpeed(numbers, elastic);
    flow_.rheology.reset(granularRheology::New(phase, elastic).ptr());
    flow_.grains.reset(new grainDynamics(
        engine, scene_, scheme_, *flow_.rheology, *contact_, has("water")
    ));
}

// Compression of a skeleton that is too soft: 4/C^2 of the modulus under the
// dynamic pressure of the flow, C the ratio of the speeds
void caseRun::checkWaveSpeed(const dictionary& coeffs, const elasticity& e)
    const
{
    constexpr scalar good = 5;
    const scalar speed = max(maxSpeed_ / 2, sqrt(scale().gH));
    const scalar C = e.c() / speed;
    if (C >= good * (1 - 1e-9))
    {
        return;
    }
    const string text =
        "E = " + Foam::name(e.E()) + " Pa: the wave speed of the grains, "
        + Foam::name(e.c()) + " m/s, is " + Foam::name(C)
        + " times the larger of half the expected speed and sqrt(g H), "
        + Foam::name(speed) + " m/s";
    const string remedy = "Write E auto; or at least "
                        + Foam::name(e.E() * sqr(good / C)) + " Pa";
    if (C < 1)
    {
        refuse(
            coeffs,
            "E",
            text + ": the flow would outrun its own pressure. " + remedy
        );
    }
    WarningInFunction << text.c_str()
                      << ": grains as soft as that are compressed "
                      << "by their own flow. " << remedy.c_str() << endl;
}

void caseRun::makeWater(const lpfPairs::pairEngine& engine)
{
    const dictionary& phase = phases_.subDict("water");
    const elasticity* skeleton =
        has("grains") ? &flow_.rheology->elastic() : nullptr;
    const soundSpeedScale sound = soundScale(scale(), skeleton, grainDensity_);
    flow_.state.reset(equationOfState::New(phase, sound).ptr());
    warnOfLight("water", flow_.state->rho0());
    flow_.viscosity.reset(viscosityModel::New(phase).ptr());
    chooseViscosityIntegration();
    chooseGroundLag();
    checkStick();
    flow_.water.reset(new waterDynamics(
        engine,
        waterScene_,
        waterScheme_,
        *flow_.state,
        *flow_.viscosity,
        *contact_,
        has("grains")
    ));
}

// What shear does to the pore pressure is a matter of a few per cent of the
// pores, and (T 5.24) takes as much from water that spreads over ground that
// was wet all along
void caseRun::chooseGroundLag()
{
    if (!has("grains") || !flow_.rheology->changesPacking())
    {
        return;
    }
    if (!groundLagIsGiven_)
    {
        waterScheme_.groundLag = 0;
    }
    else if (waterScheme_.groundLag > 0)
    {
        WarningInFunction
            << "groundLag " << waterScheme_.groundLag << " with dilatancy: "
            << "what it takes of the density beside ground is as much as "
            << "shear makes, and loose grains may be sucked together where "
            << "they should liquefy. Leave groundLag out, which is then 0"
            << endl;
    }
}

// auto: implicit where the explicit step would be shorter than that of sound
void caseRun::chooseViscosityIntegration()
{
    const scalar mu = flow_.viscosity->largest();
    const scalar c = flow_.state->c0() + maxSpeed_;
    const scalar soundStep = waterScheme_.CFL * waterScene_.h / c;
    const scalar viscousStep =
        0.125 * sqr(waterScene_.h) * flow_.state->rho0() / max(mu, VSMALL);
    waterScheme_.implicitViscosity =
        mu > 0
        && (viscosityIntegration_ == "implicit"
            || (viscosityIntegration_ == "auto" && viscousStep < soundStep));
}

void caseRun::checkStick() const
{
    if (contact_->anyStick() && !(flow_.viscosity->largest() > 0))
    {
        refuse(
            boundary_,
            "zones",
            "Water sticks to a zone (waterFriction noSlip), but its viscosity "
            "is 0: it would feel nothing of it. Write a viscosity in "
            "constant/phaseProperties, or waterFriction none"
        );
    }
}

namespace
{

dragOperator readDragOperator(const dictionary& dict)
{
    const word name = readChoice(
        dict, "dragOperator", {"adjoint", "interpolated"}, "adjoint"
    );
    if (name == "adjoint")
    {
        return dragOperator::adjoint;
    }
    Info
        << "dragOperator interpolated: the drag of the paper. What grains take "
        << "and what water gives add up to zero in uniform flow only, and "
        << "kinetic energy may rise: look at momentum unexplained and at drag "
        << "in the ledger. adjoint is exact in both" << nl << endl;
    return dragOperator::interpolated;
}

} // namespace

scalar caseRun::grainDiameter() const
{
    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "drag needs the size of the grains, e.g. 0.005 m";
    const scalar diameter =
        readNumber(phases_.subDict("grains"), "diameter", dimLength, positive);
    if (diameter > scene_.spacing)
    {
        WarningInFunction
            << "diameter " << diameter << " m of the grains is above the "
            << "spacing, " << scene_.spacing << " m: a particle stands for "
            << "many grains, and drag is that of grains so large. Is it in m?"
            << endl;
    }
    return diameter;
}

void caseRun::makeCoupling(const lpfPairs::pairEngine& engine)
{
    const dictionary dict(
        readDictionary(caseDir_ / "constant" / "interphaseProperties")
    );
    allowOnly(
        dict, {"drag", "dragOperator", "pressureCoupling", "skeletonModulus"}
    );
    noteSettings("interphaseProperties");
    const dragOperator howDragActs = readDragOperator(dict);
    // difference is the word of older cases
    if (readChoice(
            dict, "pressureCoupling", {"adjoint", "difference"}, "adjoint"
        )
        == "difference")
    {
        Info << "pressureCoupling difference: computed as adjoint, which has "
             << "replaced it and holds grains in water at rest exactly" << nl
             << endl;
    }
    flow_.law.reset(dragLaw::New(dict).ptr());

    const scalar diameter = grainDiameter();
    if (!(flow_.viscosity->molecular() > 0))
    {
        const word model(flow_.viscosity->type());
        refuse(
            phases_.subDict("water").subOrEmptyDict(model + "Coeffs"),
            "mu",
            "The viscosity of the liquid around a grain is 0, but drag needs "
            "one; water has 1e-3 Pa s. Write mu (Newtonian), muP (Bingham), "
            "muInf (Casson) or muDrag (HerschelBulkleyPapanastasiou)"
        );
    }
    flow_.coupling.reset(new interphase(
        engine,
        *flow_.grains,
        *flow_.water,
        *flow_.law,
        grainDensity_,
        diameter,
        howDragActs
    ));
    flow_.CFL = scheme_.CFL;
    checkStiffness(dict);
    if (contact_->anyPorePressure())
    {
        WarningInFunction
            << "Zones have r_u > 0 and water is resolved: pore pressure is "
            << "counted twice, once by r_u on the friction of the ground and "
            << "once by the pressure gradient on the grains. For resolved "
            << "pressure write ru 0; keep r_u only for pore pressure that "
            << "this water does not have" << endl;
    }
}

// Of a load that comes at once the water carries B = Kf/(Kf + M),
//     Kf = rho0 c0^2/theta,  M = K + 4 G/3;                       (T 6.11)
// consolidation takes a time that goes with 1/M
void caseRun::checkStiffness(const dictionary& interphaseDict)
{
    constexpr scalar least = 0.5, good = 0.85;
    const elasticity& e = flow_.rheology->elastic();
    const scalar M = e.K() + 4 * e.G() / 3;
    const scalar theta = 1 - scale().rhoBulk / grainDensity_;
    const scalar Kf = flow_.state->rho0() * sqr(flow_.state->c0()) / theta;
    const scalar B = Kf / (Kf + M); // (T 6.11)

    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "the true modulus of the skeleton of grains in one-"
                      "dimensional compression; loose gravel has 3e7 Pa";
    const scalar trueM = readNumber(
        interphaseDict, "skeletonModulus", dimPressure, positive, 3e7
    );
    Info << nl << "Undrained share of pore pressure B = " << B
         << ": what the water carries of a load that comes at once" << nl
         << "Skeleton " << M << " Pa, true " << trueM
         << " Pa: true over computed time of consolidation " << M / trueM
         << endl;
    const scalar needed_c0 = sqrt(9 * theta * M / flow_.state->rho0());
    if (B < least)
    {
        refuse(
            phases_.subDict("water").subOrEmptyDict("TaitCoeffs"),
            "soundSpeed",
            "With this soundSpeed the water is softer than the skeleton of the "
            "grains: it would carry only "
                + Foam::name(B)
                + " of a sudden load, and saturated grains could not lose "
                  "their strength. Write soundSpeed auto; or at least "
                + Foam::name(needed_c0) + " m/s, or a softer skeleton"
        );
    }
    if (B < good)
    {
        WarningInFunction << "B = " << B << " is below 0.9: write soundSpeed "
                          << needed_c0 << " or more" << endl;
    }
}

void caseRun::printSetup(const lpfPairs::pairEngine& engine) const
{
    Info << nl << "Pair engine " << engine.instructionSet << ", "
         << (scene_.single ? engine.singleLanes : engine.lanes) << " lanes, "
         << (scene_.single ? "single" : "double") << "; threads "
         << omp_get_max_threads() << nl;
    if (flow_.grains)
    {
        const elasticity& e = flow_.rheology->elastic();
        Info << "Grains: " << flow_.rheology->type() << ", E " << e.E()
             << " Pa, nu " << e.nu() << ", wave speed " << e.c() << " m/s" << nl
             << "Spacing " << scene_.spacing << " m, smoothing length "
             << scene_.h << " m, " << scene_.dimensions << " dimensions" << nl
             << "Artificial viscosity " << scheme_.artificialViscosity
             << ", noise damping " << scheme_.noiseDamping << ", bulk damping "
             << scheme_.bulkDamping << ", shear damping "
             << scheme_.shearDamping << ", density relaxation "
             << scheme_.densityRelaxation << ", shifting " << scheme_.shifting
             << ", stress diffusion " << scheme_.stressDiffusion
             << ", friction at the "
             << (scheme_.frictionAtGround ? "ground" : "grains") << ", CFL "
             << scheme_.CFL << nl;
    }
    if (flow_.water)
    {
        Info << "Water: " << flow_.state->type() << ", c0 " << flow_.state->c0()
             << " m/s; " << flow_.viscosity->type() << ", mu "
             << (flow_.viscosity->needsShearRate() ? "at most " : "")
             << flow_.viscosity->largest() << " Pa s"
             << (waterScheme_.implicitViscosity ? ", implicit" : "") << nl
             << "Spacing " << waterScene_.spacing << " m, smoothing length "
             << waterScene_.h << " m, " << waterScene_.dimensions
             << " dimensions" << nl << "Artificial viscosity "
             << waterScheme_.artificialViscosity << ", density diffusion "
             << waterScheme_.densityDiffusion << ", density relaxation "
             << waterScheme_.densityRelaxation << ", shifting "
             << waterScheme_.shifting << ", ground lag "
             << waterScheme_.groundLag << ", CFL " << waterScheme_.CFL << nl;
    }
    if (flow_.coupling)
    {
        Info << "Between them: " << flow_.law->type()
             << " drag, where pores are not full in their wet share" << nl;
    }
    Info << "Time integration " << integration_->type() << ": forces "
         << (integration_->evaluations() > 1 ? "twice" : "once") << " a step"
         << nl << "Stop: endTime " << control_.endTime() << " s or "
         << stop_.criterion;
    if (stop_.criterion == "movingMass")
    {
        Info << " (share below " << stop_.share << " faster than "
             << stop_.speed << " m/s, after " << stop_.after << " s)";
    }
    else if (stop_.criterion == "kineticEnergy")
    {
        Info << " (below " << stop_.share << " of its peak, after "
             << stop_.after << " s)";
    }
    Info << nl << endl;
}

void caseRun::readGrains(const cloudState& cloud)
{
    grainDynamics& d = *flow_.grains;
    d.grains.fromCloud(cloud, grainDensity_);
    if (!continued_)
    {
        d.densityFromPressure();
    }
}

void caseRun::readWater(const cloudState& cloud)
{
    waterDynamics& d = *flow_.water;
    d.water.fromCloud(cloud);
    if (!continued_)
    {
        d.densityFromPressure(cloud.scalars["S"]);
    }
}

void caseRun::checkPhases(const dictionary& state) const
{
    const wordList now(flow_.names());
    const wordList before(state.getOrDefault<wordList>("phases", now));
    if (now != before)
    {
        refuse(
            state,
            "phases",
            "The run up to this time had the phases " + listed(before)
                + ", constant/phaseProperties has " + listed(now)
                + ": a state has all of its phases or none. Take the change "
                  "back, or start from time 0: startFrom startTime; startTime "
                  "0;"
        );
    }
}

namespace
{

//- Where stress and density are another state of a stiffer or softer material
void warnOfStiffness(
    const dictionary& state, const word& wave, scalar now, const char* from
)
{
    constexpr scalar rounding = 1e-9;
    const scalar before = state.getOrDefault<scalar>(wave, now);
    if (mag(now - before) > rounding * before)
    {
        WarningInFunction
            << from << " give waves of " << now << " m/s, in the run up to "
            << "this time they had " << before << " m/s: pressure and stress "
            << "jump, and with them the stored energy, which the ledger shows "
            << "as unexplained" << endl;
    }
}

} // namespace

void caseRun::noteSettings(const word& file)
{
    settings_.set(file, digestOf(caseDir_ / "constant" / file));
}

// Ground and particles are those of the last terrainToParticles
void caseRun::warnOfEditedRelease() const
{
    const fileName file(caseDir_ / "system" / "terrainToParticlesDict");
    if (release_.found("dictionary") && isFile(file)
        && release_.get<word>("dictionary") != digestOf(file))
    {
        WarningInFunction
            << "system/terrainToParticlesDict has been changed since "
            << "terrainToParticles ran: ground and particles are those of "
            << "before. Run it again, or take the change back" << endl;
    }
}

// What may be meant, but is another scene than the one the run began with
void caseRun::warnOfChanges(const dictionary& state) const
{
    if (flow_.grains)
    {
        warnOfStiffness(
            state,
            "elasticWave",
            flow_.rheology->elastic().c(),
            "E, nu and stiffness of the grains"
        );
    }
    if (flow_.water)
    {
        warnOfStiffness(
            state, "soundSpeed", flow_.state->c0(), "soundSpeed of the water"
        );
    }
    const vector g = state.getOrDefault<vector>("g", scene_.g);
    if (g != scene_.g)
    {
        WarningInFunction
            << "constant/g is " << scene_.g << " m/s2, in the run up to this "
            << "time it was " << g << ": the run goes on with the new one. The "
            << "potential energy jumps by that, which the ledger shows as "
            << "unexplained" << endl;
    }
    const dictionary before = state.subOrEmptyDict("settings");
    for (const word& file : settings_.toc())
    {
        const word now = settings_.get<word>(file);
        if (before.getOrDefault<word>(file, now) != now)
        {
            WarningInFunction
                << "constant/" << file << " is not that of the run up to this "
                << "time: the run goes on with the new one. If that is not "
                << "meant, take the change back or start from time 0" << endl;
        }
    }
    if (state.getOrDefault<word>("ground", groundFingerprint_)
        != groundFingerprint_)
    {
        WarningInFunction
            << "constant/terrain is not the ground of the run up to this time: "
            << "the run goes on over the new one, which sets back what stands "
            << "behind it. If that is not meant, start from time 0" << endl;
    }
}

madeFields caseRun::madeByRun(const word& phase) const
{
    if (phase == "grains")
    {
        return {
            wordList({"rho", "rhoRef", "I"}),
            scheme_.frictionAtGround ? wordList({"traction"}) : wordList()};
    }
    wordList made({"rho", "toGround"});
    if (has("grains"))
    {
        made.append("meanTheta");
    }
    if (waterScheme_.groundLag > 0)
    {
        made.append("lag");
    }
    return {made, {}};
}

// State of the run so far that this one has no use for
void caseRun::warnOfDropped(const cloudState& cloud) const
{
    const auto warn = [](const char* field, const char* keep)
    {
        WarningInFunction
            << "The run up to this time had a field " << field
            << " that it goes on without: what it holds is dropped. Where that "
            << "is not meant, write " << keep << " of system/lpfSolution"
            << endl;
    };
    if (cloud.vectors.found("traction") && !scheme_.frictionAtGround)
    {
        warn("traction", "frictionAt ground; in grains");
    }
    if (cloud.scalars.found("lag") && !(waterScheme_.groundLag > 0))
    {
        warn("lag", "groundLag 10; in water");
    }
}

// Rounded masses do not close, rounded positions are another flow
void caseRun::checkDigits(const dictionary& state)
{
    constexpr label all = runControl::allDigits;
    const label digits = state.getOrDefault<label>("digits", all);
    if (digits < all)
    {
        refuse(
            state,
            "digits",
            "This time was written as ascii with writePrecision "
                + Foam::name(digits)
                + ": a state needs all 17 digits of a number, a run from "
                  "rounded ones is another one and its mass does not close. "
                  "Write writeFormat binary; or writePrecision 17; in "
                  "system/controlDict and start again from time 0 or from a "
                  "time that has all digits (startFrom startTime;)"
        );
    }
}

void caseRun::readState()
{
    const fileName dir = control_.path(control_.startTime());
    const fileName stateFile(dir / "uniform" / "lpfState");
    const dictionary state =
        isFile(stateFile) ? readDictionary(stateFile) : dictionary();
    continued_ = !state.empty();

    // the same spacing is not the same release
    checkFingerprint(state, release_, remedyOfOldTimes);
    checkDigits(state);
    checkPhases(state);
    warnOfChanges(state);

    pointField all;
    for (const word& name : names_)
    {
        const cloudState cloud(readCloud(dir, name));
        if (!continued_)
        {
            checkStart(cloud, stateFile);
        }
        checkFields(cloud, dir, name, continued_, madeByRun(name));
        warnOfDropped(cloud);
        checkSmoothing(
            cloud, dir, name, name == "grains" ? scene_.h : waterScene_.h
        );
        all.append(cloud.positions);
        name == "grains" ? readGrains(cloud) : readWater(cloud);
    }
    checkInside(all, scene_.cyclic, scene_.spacing, boundary_);
    if (scene_.dimensions == 2 && all.size() > 0)
    {
        contact_->setPlane(all[0] & scene_.planeNormal);
    }

    const boundBox domain = continued_
                              ? continueFrom(dir, state)
                              : domainOf(ground_->bounds(), all, scene_);
    openLedgers(domain, state);
    startSize_ = flow_.size();
    printStart();
}

//- Time and step of a run that goes on; its domain
boundBox caseRun::continueFrom(const fileName& dir, const dictionary& state)
{
    const fileName file(dir / "uniform" / "time");
    if (!isFile(file))
    {
        refuseFile(
            file,
            "The file does not exist: the run cannot go on from here without "
            "its time and time step\nGo on from an earlier time"
        );
    }
    const uniformTime t = readUniformTime(dir);
    control_.time = t.value;
    control_.index = t.index;
    control_.deltaT = t.deltaT;
    control_.unrestricted = state.get<scalar>("unrestrictedDeltaT");
    if (flow_.grains)
    {
        // times of before it was kept made up for it in each step
        flow_.grains->undiffused = state.getOrDefault<scalar>("undiffused", 0);
    }
    return boundBox(
        state.get<point>("domainMin"), state.get<point>("domainMax")
    );
}

void caseRun::openLedgers(const boundBox& domain, const dictionary& state)
{
    const wordList names(flow_.names());
    const std::vector<phaseDynamics*> phases = flow_.phases();
    forAll (names, k)
    {
        phaseDynamics& phase = *phases[static_cast<std::size_t>(k)];
        phase.setDomain(domain);
        if (continued_)
        {
            phase.ledger.restore(neededDictionary(
                state, balanceName(names[k]), "go on from an earlier time"
            ));
        }
        else
        {
            phase.ledger.initialMass = phase.mass();
        }
    }
}

void caseRun::printStart() const
{
    const wordList names(flow_.names());
    const std::vector<phaseDynamics*> phases = flow_.phases();
    Info << "Start from " << control_.timeName(control_.startTime())
         << (continued_ ? " (continued)" : "") << ":";
    forAll (names, k)
    {
        const phaseDynamics& phase = *phases[static_cast<std::size_t>(k)];
        Info << (k > 0 ? "; " : " ") << phase.particles().size()
             << " particles of " << names[k] << ", " << phase.mass().value()
             << " kg";
    }
    Info << nl << endl;
}

} // namespace lpf
} // namespace Foam
