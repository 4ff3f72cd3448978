// SPDX-License-Identifier: GPL-3.0-or-later
#include "grainRun.H"

#include "engineLoader.H"
#include "inputCheck.H"
#include "uniformTime.H"

#include "OSspecific.H"

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
    const dictionary* pairs = optionalDictionary(dict, "cyclic");
    if (!pairs)
    {
        return box;
    }
    const dictionary& cyclic = *pairs;
    allowOnly(cyclic, {"x", "y", "z"});
    const word axes[3] = {"x", "y", "z"};
    for (direction d = 0; d < 3; ++d)
    {
        if (cyclic.found(axes[d]))
        {
            const Pair<scalar> ends = readInterval(cyclic, axes[d]);
            box.lower[d] = ends.first() - origin[d];
            box.period[d] = ends.second() - ends.first();
            if (box.period[d] < 2 * h)
            {
                refuse(
                    cyclic,
                    axes[d],
                    "The period of " + Foam::name(box.period[d])
                        + " m is shorter than the support of the kernel, "
                        + Foam::name(2 * h)
                        + " m: a grain would be its own neighbour. Write a "
                          "longer period or take a smaller spacing"
                );
            }
        }
    }
    return box;
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

//- A sub-dictionary that must be there
const dictionary&
needed(const dictionary& dict, const word& key, const string& remedy)
{
    const dictionary* sub = dict.findDict(key);
    if (!sub)
    {
        refuse(dict, key, "There is no dictionary " + key + "; " + remedy);
    }
    return *sub;
}

//- Fields without which there is no state; from a run, all that it wrote
void checkFields(
    const cloudState& cloud, const fileName& dir, const bool continued
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
    need(cloud.symmTensors, {"sigma"});
    need(cloud.scalars, {"mass", "alpha"});
    if (continued || cloud.scalars.found("rhoRef"))
    {
        need(cloud.scalars, {"rho", "rhoRef", "I"});
    }
    const fileName file(dir / "lagrangian" / "grains");
    if (missing.size())
    {
        FatalIOError("", "", 0, file / missing[0], -1, -1)
            << "The file does not exist" << nl
            << (continued ? "Go on from an earlier time"
                          : "Run terrainToParticles again")
            << exit(FatalIOError);
    }
    const scalarField& mass = cloud.scalars["mass"];
    forAll (mass, i)
    {
        if (!(mass[i] > 0))
        {
            FatalIOError("", "", 0, file / "mass", -1, -1)
                << "Grain " << i << " has a mass of " << mass[i]
                << " kg: it would not move. Run terrainToParticles again, or "
                << "go on from an earlier time" << exit(FatalIOError);
        }
    }
}

} // namespace

grainRun::grainRun(const fileName& caseDir)
    : caseDir_(caseDir), control_(caseDir)
{
    const dictionary boundary(
        readDictionary(caseDir / "constant" / "boundaryProperties")
    );
    const word isa = readSolution();
    const dictionary phases(
        readDictionary(caseDir / "constant" / "phaseProperties")
    );
    allowOnly(phases, {"phases", "grains", "water"});
    if (!phases.found("phases")
        || phases.get<wordList>("phases") != wordList({"grains"}))
    {
        refuse(
            phases,
            "phases",
            "This version moves grains alone; write phases (grains);"
        );
    }
    if (phases.found("water"))
    {
        WarningInFunction
            << "The dictionary of water is not used: phases names grains alone"
            << endl;
    }
    phase_ = needed(
        phases,
        "grains",
        "write grains { rho 2600; diameter 0.005; rheology muI; muICoeffs {} }"
    );
    allowOnly(phase_, {"rho", "diameter", "rheology", "muICoeffs"});

    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "the density of the grain material, e.g. 2600 kg/m3";
    grainDensity_ = readNumber(phase_, "rho", dimDensity, positive);

    ground_ = ground::read(caseDir);
    readScene(boundary);
    makeModels(boundary, isa);
    readState();
    removeUnfinishedTimes(caseDir);
    openSeries();
    runControl::catchSignals();
    began_ = lastLog_ = wallClock::now();
    lastIndex_ = control_.index;
}

void grainRun::readScene(const dictionary& boundaryProperties)
{
    const dictionary release(
        readDictionary(caseDir_ / "constant" / "releaseProperties")
    );
    scene_.spacing = prepared(release, "spacing", dimLength);
    scene_.h = prepared(release, "smoothingLength", dimLength);
    scene_.dimensions = label(prepared(release, "dimensions", dimless));
    scene_.planeThickness = release.getOrDefault<scalar>("planeThickness", 1);
    scene_.planeNormal =
        release.getOrDefault<vector>("planeNormal", vector(0, 1, 0));
    scene_.g = readGravity(caseDir_);
    scene_.cyclic = readCyclic(boundaryProperties, ground_->origin(), scene_.h);

    if (stop_.speed <= 0)
    {
        stop_.speed = 0.1 * sqrt(mag(scene_.g) * scene_.spacing);
    }
    if (stop_.after <= 0 && mag(scene_.g) > 0)
    {
        stop_.after =
            2
            * sqrt(
                prepared(release, "releaseHeight", dimLength) / mag(scene_.g)
            );
    }
}

word grainRun::readSolution()
{
    const dictionary dict(readDictionary(caseDir_ / "system" / "lpfSolution"));
    allowOnly(
        dict,
        {"CFL",
         "artificialViscosity",
         "noiseDamping",
         "bulkDamping",
         "instructionSet",
         "logInterval",
         "stop"}
    );

    bounds CFL;
    CFL.lower = 0;
    CFL.lowerOpen = true;
    CFL.upper = 1;
    CFL.reason = "above 1 a wave passes a smoothing length in one step and "
                 "the run blows up; write 0.3";
    scheme_.CFL = readNumber(dict, "CFL", dimless, CFL, 0.3);

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
    scheme_.bulkDamping = readNumber(dict, "bulkDamping", dimless, beta, 0);

    bounds count;
    count.lower = 1;
    count.reason = "a number of steps";
    logInterval_ = label(readNumber(dict, "logInterval", dimless, count, 100));

    readStop(dict.subOrEmptyDict("stop"));
    return readChoice(
        dict,
        "instructionSet",
        {"auto", "x86-64-v2", "x86-64-v3", "x86-64-v4"},
        "auto"
    );
}

void grainRun::readStop(const dictionary& stop)
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

void grainRun::makeModels(const dictionary& boundaryProperties, const word& isa)
{
    const dictionary release(
        readDictionary(caseDir_ / "constant" / "releaseProperties")
    );
    stiffnessScale scale;
    scale.rhoBulk =
        grainDensity_
        * prepared(
            needed(release, "grains", "run terrainToParticles again"),
            "solidFraction",
            dimless
        );
    scale.gH = mag(scene_.g) * prepared(release, "releaseHeight", dimLength);
    scale.maxSpeed = prepared(release, "maxSpeed", dimVelocity);

    const word coeffs(granularRheology::nameOf(phase_) + "Coeffs");
    const elasticity elastic(
        needed(
            phase_,
            coeffs,
            "write the numbers of the rheology into it, tutorials show how"
        ),
        scale
    );
    rheology_ = granularRheology::New(phase_, elastic);
    contact_.reset(new groundContact(
        *ground_,
        boundaryProperties,
        scene_.spacing,
        scene_.dimensions == 2 ? scene_.planeThickness : 0,
        scene_.planeNormal
    ));
    const lpfPairs::pairEngine& engine = engineNamed(isa);
    dynamics_.reset(
        new grainDynamics(engine, scene_, scheme_, *rheology_, *contact_)
    );
    printSetup(engine);
}

void grainRun::printSetup(const lpfPairs::pairEngine& engine) const
{
    const elasticity& e = rheology_->elastic();
    Info << nl << "Pair engine " << engine.instructionSet << ", "
         << engine.lanes << " lanes, double; threads " << omp_get_max_threads()
         << nl << "Grains: " << rheology_->type() << ", E " << e.E()
         << " Pa, nu " << e.nu() << ", wave speed " << e.c() << " m/s" << nl
         << "Spacing " << scene_.spacing << " m, smoothing length " << scene_.h
         << " m, " << scene_.dimensions << " dimensions" << nl
         << "Artificial viscosity " << scheme_.artificialViscosity
         << ", noise damping " << scheme_.noiseDamping << ", bulk damping "
         << scheme_.bulkDamping << ", CFL " << scheme_.CFL << nl
         << "Stop: endTime " << control_.endTime() << " s or "
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

void grainRun::readState()
{
    const fileName dir = control_.path(control_.startTime());
    grainDynamics& d = *dynamics_;
    const cloudState cloud(readCloud(dir, "grains"));
    checkFields(cloud, dir, isFile(dir / "uniform" / "lpfState"));
    d.grains.fromCloud(cloud, grainDensity_);
    if (scene_.dimensions == 2 && cloud.size() > 0)
    {
        contact_->setPlane(cloud.positions[0] & scene_.planeNormal);
    }

    boundBox domain = ground_->bounds();
    const dictionary state = isFile(dir / "uniform" / "lpfState")
                               ? readDictionary(dir / "uniform" / "lpfState")
                               : dictionary();
    continued_ = !state.empty();

    if (continued_)
    {
        const uniformTime t = readUniformTime(dir);
        control_.time = t.value;
        control_.index = t.index;
        control_.deltaT = t.deltaT;
        control_.unrestricted = state.get<scalar>("unrestrictedDeltaT");
        domain = boundBox(
            state.get<point>("domainMin"), state.get<point>("domainMax")
        );
        d.ledger.restore(needed(state, "balance", "go on from an earlier time")
        );
    }
    else
    {
        d.densityFromPressure();
        d.ledger.initialMass = d.mass();
        domain.add(cloud.positions);
        const vector up = mag(scene_.g) > 0 ? vector(-scene_.g / mag(scene_.g))
                                            : vector(0, 0, 1);
        const scalar margin = 4 * scene_.h;
        const boundBox low(domain);
        const vector above = headroom * low.mag() * up;
        domain.add(boundBox(low.min() + above, low.max() + above));
        domain = boundBox(
            domain.min() - vector::uniform(margin),
            domain.max() + vector::uniform(margin)
        );
    }
    d.setDomain(domain);

    Info << "Start from " << control_.timeName(control_.startTime())
         << (continued_ ? " (continued)" : "") << ": " << cloud.size()
         << " grains, "
         << d.ledger.initialMass.value() - d.ledger.leftMass.value()
         << " kg; expected memory " << label(600.0 * cloud.size() / 1048576 + 1)
         << " MiB" << nl << endl;
}

void grainRun::openSeries()
{
    const fileName dir = caseDir_ / "postProcessing" / "lpfSolver"
                       / control_.timeName(control_.startTime());
    balanceFile_.reset(new seriesFile(
        dir,
        "balance.dat",
        "time[s] mass[kg] left[kg] kinetic[J] potential[J] elastic[J] "
        "plastic[J] separation[J] friction[J] viscous[J] projection[J] "
        "wallTension[J] leftEnergy[J] unexplained[J] momentumX[Ns] "
        "momentumY[Ns] momentumZ[Ns] unexplainedMomentum[Ns] maxSpeed[m/s] "
        "movingMass[-] wallForceX[N] wallForceY[N] wallForceZ[N] "
        "wallImpulse[Ns] contactImpulse[Ns]"
    ));
    leaversFile_.reset(new seriesFile(
        dir,
        "left.dat",
        "time[s] id x[m] y[m] z[m] Ux[m/s] Uy[m/s] Uz[m/s] mass[kg]"
    ));
}

bool grainRun::running() const
{
    return control_.running() && !atRest_ && massCloses_
        && dynamics_->grains.size() > 0;
}

void grainRun::step()
{
    grainDynamics& d = *dynamics_;
    const bool first = control_.index == 0;
    const bool report = control_.index % logInterval_ == 0;

    d.rates(control_.deltaT, control_.time);
    d.kick(0.5 * control_.deltaT);

    // synchronous time: velocities, positions and stress belong together
    if (first)
    {
        d.ledger.initial = d.energy();
    }
    limit_ = d.stableDeltaT();
    if (!(limit_.deltaT > 0) || !std::isfinite(limit_.deltaT))
    {
        FatalErrorInFunction
            << "The time step limit " << limit_.rule << " gives "
            << limit_.deltaT << " s at time " << control_.time << " s, step "
            << control_.index
            << ": the solution is not finite. Restart from the last time "
            << "with a smaller CFL, or with artificialViscosity 0.01"
            << exit(FatalError);
    }
    const scalar dt = control_.step(limit_.deltaT);
    if (report || control_.writesAfterStep())
    {
        now_ = d.energy();
        if (report)
        {
            // at fixed steps, whatever a signal adds: part of the state
            d.ledger.peakKinetic = max(d.ledger.peakKinetic, now_.kinetic);
        }
        booked_ = d.ledger;
        bookedAt_ = control_.time;
    }
    if (report)
    {
        control_.readIfModified();
        checkStop();
        logStep();
        bookBalance();
    }

    d.kick(0.5 * dt);
    d.drift(dt, control_.time);
    control_.advance();

    if (control_.writeNow() || atRest_)
    {
        write();
    }
}

void grainRun::checkStop()
{
    if (control_.time < stop_.after)
    {
        return;
    }
    const grainDynamics& d = *dynamics_;
    if (stop_.criterion == "movingMass")
    {
        atRest_ = d.movingMassShare(stop_.speed) < stop_.share;
    }
    else if (stop_.criterion == "kineticEnergy")
    {
        atRest_ = now_.kinetic < stop_.share * d.ledger.peakKinetic;
    }
}

void grainRun::logStep()
{
    const grainDynamics& d = *dynamics_;
    const auto now = wallClock::now();
    const std::chrono::duration<scalar> since = now - lastLog_;
    const std::chrono::duration<scalar> total = now - began_;
    const label steps = control_.index - lastIndex_;
    const scalar rate =
        since.count() > 0 ? steps * scalar(d.grains.size()) / since.count() : 0;
    const scalar secondsLeft =
        steps > 0 ? since.count() / steps * (control_.endTime() - control_.time)
                        / control_.deltaT
                  : 0;
    lastLog_ = now;
    lastIndex_ = control_.index;

    Info << "Time = " << control_.timeName(control_.time) << nl << nl
         << "deltaT = " << control_.deltaT << " ruled by " << limit_.rule << nl
         << "done " << 100 * control_.time / control_.endTime() << " %, "
         << rate << " particle-steps/s, at most " << secondsLeft << " s left"
         << nl << "max speed " << d.maxSpeed() << " m/s, moving mass "
         << 100 * d.movingMassShare(stop_.speed) << " %, kinetic energy "
         << now_.kinetic << " J" << nl << "ExecutionTime = " << total.count()
         << " s  ClockTime = " << total.count() << " s" << nl << endl;
}

void grainRun::bookBalance()
{
    grainDynamics& d = *dynamics_;
    const balance& b = booked_;
    const vector wall = d.wallForceSum();
    const vector error = b.unexplainedMomentum(now_);

    balanceFile_->row(
        {bookedAt_,
         d.mass().value(),
         b.leftMass.value(),
         now_.kinetic,
         now_.potential,
         now_.elastic,
         b.plastic,
         b.separation,
         b.friction,
         b.viscous,
         b.projection,
         b.wallTension,
         b.left,
         b.unexplained(now_),
         now_.momentum.x(),
         now_.momentum.y(),
         now_.momentum.z(),
         mag(error),
         d.maxSpeed(),
         d.movingMassShare(stop_.speed),
         wall.x(),
         wall.y(),
         wall.z(),
         b.wallNormalImpulse,
         b.projectionNormalImpulse}
    );
    const point& origin = ground_->origin();
    for (const leaver& l : d.ledger.leavers)
    {
        const point at = l.at + origin;
        leaversFile_->row(
            {l.time,
             scalar(l.id),
             at.x(),
             at.y(),
             at.z(),
             l.U.x(),
             l.U.y(),
             l.U.z(),
             l.mass}
        );
    }
    d.ledger.leavers.clear();

    lpfPairs::exactSum accounted = d.mass();
    accounted += d.ledger.leftMass;
    massCloses_ = accounted == d.ledger.initialMass;
}

void grainRun::write()
{
    grainDynamics& d = *dynamics_;
    const word name = control_.timeName(control_.time);
    timeFolder folder(caseDir_, name);

    writeCloud(
        folder.path(),
        "grains",
        d.grains.toCloud(grainDensity_, scene_.h),
        control_.format()
    );
    writeUniformTime(
        folder.path(),
        {control_.time,
         name,
         control_.index,
         control_.deltaT,
         control_.unrestricted}
    );

    dictionary state;
    setExact(state, "unrestrictedDeltaT", control_.unrestricted);
    setExact(state, "domainMin", d.domain().min());
    setExact(state, "domainMax", d.domain().max());
    state.set("balance", d.ledger.state());
    {
        OFstream os(folder.path() / "uniform" / "lpfState");
        os.precision(17);
        os << "FoamFile" << nl << "{" << nl << "    version 2.0;" << nl
           << "    format ascii;" << nl << "    class dictionary;" << nl
           << "    location \"" << name.c_str() << "/uniform\";" << nl
           << "    object lpfState;" << nl << "}" << nl << nl;
        state.write(os, false);
    }
    folder.commit();
    control_.purge();
    bookBalance();
    Info << "Written " << name << nl << endl;
}

int grainRun::finish()
{
    grainDynamics& d = *dynamics_;
    const balance& b = booked_;
    const scalar released = b.released(now_);
    const auto share = [&](scalar energy)
    { return released != 0 ? 100 * energy / mag(released) : 0; };

    if (atRest_)
    {
        Info << "At rest by " << stop_.criterion << " at time " << control_.time
             << " s" << nl;
    }
    else if (control_.asked())
    {
        Info << "Stopped as asked at time " << control_.time << " s" << nl;
    }
    Info << nl << "Ledger at " << bookedAt_ << " s" << nl
         << "    mass        initial " << b.initialMass.value()
         << " kg, present " << d.mass().value() << " kg, left "
         << d.ledger.leftMass.value()
         << " kg: " << (massCloses_ ? "closes exactly" : "DOES NOT CLOSE") << nl
         << "    energy      released " << released << " J, of it" << nl
         << "        kinetic now     " << now_.kinetic << " J" << nl
         << "        plastic         " << b.plastic << " J ("
         << share(b.plastic) << " %)" << nl << "        basal friction  "
         << b.friction << " J (" << share(b.friction) << " %)" << nl
         << "        separation      " << b.separation << " J ("
         << share(b.separation) << " %)" << nl << "        viscous         "
         << b.viscous << " J (" << share(b.viscous) << " %)" << nl
         << "        contact         " << b.projection << " J ("
         << share(b.projection) << " %)" << nl << "        wall tension    "
         << b.wallTension << " J" << nl << "        with leavers    " << b.left
         << " J" << nl << "        unexplained     " << b.unexplained(now_)
         << " J (" << share(b.unexplained(now_)) << " %)" << nl
         << "    momentum    unexplained " << mag(b.unexplainedMomentum(now_))
         << " N s of " << mag(b.gravityImpulse) << " N s of gravity" << nl
         << "    contact     "
         << (b.wallNormalImpulse > 0
                 ? 100 * b.projectionNormalImpulse / b.wallNormalImpulse
                 : 0)
         << " % of the wall impulse" << nl << "Memory "
         << scalar(d.bytes()) / 1048576 << " MiB, "
         << scalar(d.bytes()) / max(d.grains.size(), 1) << " bytes a grain; "
         << grainDynamics::pairPasses << " pair passes and 1 ground pass a step"
         << nl;

    if (!massCloses_)
    {
        Info << "Mass was lost: this result must not be used" << endl;
        return 1;
    }
    Info << nl << "End" << nl << endl;
    return 0;
}

} // namespace lpf
} // namespace Foam
