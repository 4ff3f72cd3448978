// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseRun.H"

#include "uniformTime.H"

#include "OSspecific.H"

namespace Foam
{
namespace lpf
{

word caseRun::balanceName(const word& phase)
{
    return phase == "grains" ? "balance" : phase + "Balance";
}

void caseRun::openSeries()
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
        "wallImpulse[Ns] contactImpulse[Ns] artificial[J] diffusion[J] "
        "drag[J] shifting[J]"
    ));
    const string leaverColumns =
        "time[s] id x[m] y[m] z[m] Ux[m/s] Uy[m/s] Uz[m/s] mass[kg]";
    string phaseColumns = "time[s]";
    for (const word& name : flow_.names())
    {
        leaversFiles_.append(new seriesFile(
            dir, name == "grains" ? "left.dat" : "leftWater.dat", leaverColumns
        ));
        for (const char* column :
             {"Mass[kg]",
              "Left[kg]",
              "MeanSpeed[m/s]",
              "MaxSpeed[m/s]",
              "Kinetic[J]",
              "MeanDrag[m/s2]",
              "MeanGradPForce[m/s2]"})
        {
            phaseColumns += " " + name + column;
        }
    }
    phasesFile_.reset(new seriesFile(dir, "phases.dat", phaseColumns));
}

bool caseRun::running() const
{
    return control_.running() && !atRest_ && massCloses_ && flow_.size() > 0;
}

void caseRun::checkLimit() const
{
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
}

void caseRun::step()
{
    const auto began = wallClock::now();
    const scalar processorBefore = passTimes::processorTime();
    particleSteps_ += flow_.size();
    ++steps_;
    takeStep();
    processorOfSteps_ += passTimes::processorTime() - processorBefore;
    wallOfSteps_ +=
        std::chrono::duration<scalar>(wallClock::now() - began).count();
}

void caseRun::takeStep()
{
    const bool first = control_.index == 0;
    const bool report = control_.index % logInterval_ == 0;
    const scalar dtBefore = control_.deltaT;

    integration_->begin(flow_, dtBefore, control_.time);
    if (report || !stepped_)
    {
        mostBytes_ = max(mostBytes_, flow_.bytes());
    }
    stepped_ = true;
    if (first)
    {
        for (phaseDynamics* phase : flow_.phases())
        {
            phase->ledger.initial = phase->energy();
        }
    }
    limit_ = flow_.stableDeltaT();
    checkLimit();
    const scalar dt = control_.step(limit_.deltaT);
    if (report || control_.writesAfterStep())
    {
        book(report);
    }

    integration_->finish(flow_, dtBefore, dt, control_.time);
    control_.advance();

    if (flow_.size() == 0)
    {
        bookEmpty();
    }
    else if (control_.writeNow() || atRest_)
    {
        write();
    }
}

void caseRun::book(bool report)
{
    const passTimes::timed pass(times_, "ledger, log");
    now_ = flow_.energy();
    if (report)
    {
        // at fixed steps, whatever a signal adds: part of the state
        scalar& peak = flow_.phases().front()->ledger.peakKinetic;
        peak = max(peak, now_.kinetic);
    }
    booked_ = flow_.ledger();
    bookedAt_ = control_.time;
    if (report)
    {
        control_.readIfModified();
        checkStop();
        checkSpeed();
        logStep();
        bookBalance();
    }
}

// A time without particles is no time that other programs could read
void caseRun::bookEmpty()
{
    now_ = flow_.energy();
    booked_ = flow_.ledger();
    bookedAt_ = control_.time;
    bookBalance();
}

// Above the speed that E auto and soundSpeed auto are made for, or any there is
void caseRun::checkSpeed()
{
    constexpr scalar most = 1.2, Mach = 0.1;
    // water that falls is faster at its front, which its sound allows for
    const scalar expected =
        has("grains") ? maxSpeed_ : max(maxSpeed_, Mach * flow_.state->c0());
    const scalar speed = flow_.maxSpeed();
    if (speed > fastestSlide)
    {
        FatalErrorInFunction
            << "The largest speed at time " << control_.time << " s, step "
            << control_.index << ", is " << speed << " m/s, above "
            << fastestSlide
            << " m/s: the solution diverges. Restart from the last time with a "
            << "smaller CFL, or with artificialViscosity 0.01"
            << exit(FatalError);
    }
    if (!tooFast_ && speed > most * expected && maxSpeed_ > 0)
    {
        tooFast_ = true;
        WarningInFunction
            << "The largest speed, " << speed << " m/s at time "
            << control_.time << " s, is above the " << expected
            << " m/s that were expected: what E auto and soundSpeed auto make "
            << "of it is too soft. If it is not a single particle that falls, "
            << "write maxSpeed " << speed << "; or more in "
            << "system/terrainToParticlesDict and run terrainToParticles again"
            << endl;
    }
}

void caseRun::checkStop()
{
    if (control_.time < stop_.after)
    {
        return;
    }
    if (stop_.criterion == "movingMass")
    {
        atRest_ = flow_.movingMassShare(stop_.speed) < stop_.share;
    }
    else if (stop_.criterion == "kineticEnergy")
    {
        atRest_ = now_.kinetic
                < stop_.share * flow_.phases().front()->ledger.peakKinetic;
    }
}

void caseRun::logStep()
{
    const auto now = wallClock::now();
    const std::chrono::duration<scalar> since = now - lastLog_;
    const std::chrono::duration<scalar> total = now - began_;
    const label steps = control_.index - lastIndex_;
    const scalar rate =
        since.count() > 0 ? steps * scalar(flow_.size()) / since.count() : 0;
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
         << nl << "max speed " << flow_.maxSpeed() << " m/s, moving mass "
         << 100 * flow_.movingMassShare(stop_.speed) << " %, kinetic energy "
         << now_.kinetic << " J" << nl;
    if (flow_.water && flow_.water->implicitViscosity())
    {
        Info << "implicit viscosity: " << flow_.water->iterations()
             << " iterations" << nl;
    }
    Info << "ExecutionTime = " << total.count()
         << " s  ClockTime = " << total.count() << " s" << nl << endl;
}

void caseRun::bookBalance()
{
    const balance& b = booked_;
    const vector wall = flow_.wallForceSum();
    const vector error = b.unexplainedMomentum(now_);

    balanceFile_->row(
        {bookedAt_,
         flow_.mass(),
         flow_.leftMass(),
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
         flow_.maxSpeed(),
         flow_.movingMassShare(stop_.speed),
         wall.x(),
         wall.y(),
         wall.z(),
         b.wallNormalImpulse,
         b.projectionNormalImpulse,
         b.artificial,
         b.diffusion,
         b.drag,
         b.shifting}
    );
    bookPhases();
    bookLeavers();
    massCloses_ = flow_.massCloses();
}

void caseRun::bookPhases()
{
    std::vector<scalar> row = {bookedAt_};
    for (const phaseDynamics* phase : flow_.phases())
    {
        const scalar mass = phase->mass().value();
        row.insert(
            row.end(),
            {mass,
             phase->ledger.leftMass.value(),
             phase->meanSpeed(),
             phase->maxSpeed(),
             phase->energy().kinetic,
             flow_.meanDrag(*phase),
             flow_.meanGradPForce(*phase)}
        );
    }
    phasesFile_->row(row);
}

void caseRun::bookLeavers()
{
    const point& origin = ground_->origin();
    const std::vector<phaseDynamics*> phases = flow_.phases();
    forAll (leaversFiles_, k)
    {
        balance& ledger = phases[static_cast<std::size_t>(k)]->ledger;
        for (const leaver& l : ledger.leavers)
        {
            const point at = l.at + origin;
            leaversFiles_[k].row(
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
        ledger.leavers.clear();
    }
}

void caseRun::write()
{
    const passTimes::timed pass(outputTimes_, "output");
    const word name = control_.timeName(control_.time);
    timeFolder folder(caseDir_, name);

    if (flow_.grains)
    {
        writeCloud(
            folder.path(),
            "grains",
            flow_.grains->grains.toCloud(grainDensity_, scene_.h),
            control_.format()
        );
    }
    if (flow_.water)
    {
        writeCloud(
            folder.path(),
            "water",
            flow_.water->water.toCloud(flow_.state->rho0(), waterScene_.h),
            control_.format()
        );
    }
    writeUniformTime(
        folder.path(),
        {control_.time,
         name,
         control_.index,
         control_.deltaT,
         control_.unrestricted}
    );
    writeState(folder.path(), name);
    folder.commit();
    lastWritten_ = name;
    control_.purge();
    bookBalance();
    Info << "Written " << name << nl << endl;
}

void caseRun::writeState(const fileName& dir, const word& time) const
{
    dictionary state;
    const std::vector<phaseDynamics*> phases = flow_.phases();
    if (release_.found("fingerprint"))
    {
        state.set("release", release_.get<word>("fingerprint"));
    }
    setExact(state, "unrestrictedDeltaT", control_.unrestricted);
    setExact(state, "domainMin", phases.front()->domain().min());
    setExact(state, "domainMax", phases.front()->domain().max());
    const wordList names(flow_.names());
    forAll (names, k)
    {
        state.set(
            balanceName(names[k]),
            phases[static_cast<std::size_t>(k)]->ledger.state()
        );
    }
    state.set("digits", control_.digits());
    state.set("phases", names);
    setExact(state, "g", scene_.g);
    state.set("ground", groundFingerprint_);
    state.set("settings", settings_);
    if (flow_.grains)
    {
        setExact(state, "elasticWave", flow_.rheology->elastic().c());
        setExact(state, "undiffused", flow_.grains->undiffused);
    }
    if (flow_.water)
    {
        setExact(state, "soundSpeed", flow_.state->c0());
    }
    OFstream os(dir / "uniform" / "lpfState");
    os.precision(17);
    os << "FoamFile" << nl << "{" << nl << "    version 2.0;" << nl
       << "    format ascii;" << nl << "    class dictionary;" << nl
       << "    location \"" << time.c_str() << "/uniform\";" << nl
       << "    object lpfState;" << nl << "}" << nl << nl;
    state.write(os, false);
}

// What shares of energy are shares of: what was released, and the motion that
// the run began with. A heap at rest releases next to nothing, of which
// everything would be much
scalar caseRun::energyScale(word& name) const
{
    constexpr scalar least = 0.01;
    const scalar released =
        mag(booked_.released(now_)) + booked_.initial.kinetic;
    scalar weight = 0;
    for (const phaseDynamics* phase : flow_.phases())
    {
        weight += mag(scene_.g) * phase->ledger.initialMass.value();
    }
    const scalar stored = weight * releaseHeight_;
    name = released >= least * stored ? "released" : "mgH";
    return max(released >= least * stored ? released : stored, VSMALL);
}

void caseRun::printMasses() const
{
    Info << nl << "Ledger at " << bookedAt_ << " s" << nl;
    const wordList names(flow_.names());
    const std::vector<phaseDynamics*> phases = flow_.phases();
    forAll (names, k)
    {
        const phaseDynamics& phase = *phases[static_cast<std::size_t>(k)];
        Info << "    mass        " << names[k].c_str() << ": initial "
             << phase.ledger.initialMass.value() << " kg, present "
             << phase.mass().value() << " kg, left "
             << phase.ledger.leftMass.value() << " kg: "
             << (phase.massCloses() ? "closes exactly" : "DOES NOT CLOSE")
             << nl;
    }
}

void caseRun::printLedger() const
{
    const balance& b = booked_;
    const scalar released = b.released(now_);
    word scaleName;
    const scalar all = energyScale(scaleName);
    const auto line = [&](const char* name, scalar energy)
    {
        Info << "        " << name << energy << " J (" << 100 * energy / all
             << " %)" << nl;
    };
    printMasses();
    Info << "    energy      released " << released << " J";
    if (b.initial.kinetic > 0)
    {
        Info << " and " << b.initial.kinetic << " J of motion at the start";
    }
    Info << ", of it"
         << (scaleName == "released"
                 ? std::string()
                 : " (% of m g releaseHeight, " + Foam::name(all)
                       + " J: little was released)")
                .c_str()
         << nl << "        kinetic now     " << now_.kinetic << " J" << nl;
    if (flow_.grains)
    {
        line("plastic         ", b.plastic);
        line("basal friction  ", b.friction);
        line("separation      ", b.separation);
    }
    if (flow_.coupling)
    {
        line("drag            ", b.drag);
    }
    if (flow_.water)
    {
        line("viscous         ", b.viscous);
        line("diffusion       ", b.diffusion);
        line("shifting        ", b.shifting);
    }
    line("artificial      ", b.artificial);
    line("contact loss    ", b.projection);
    line("wall terms      ", b.wallTension);
    line("with leavers    ", b.left);
    line("unexplained     ", b.unexplained(now_));
    Info << "    momentum    unexplained " << mag(b.unexplainedMomentum(now_))
         << " N s of " << mag(b.gravityImpulse) << " N s of gravity" << nl
         << "                contact impulse "
         << (b.wallNormalImpulse > 0
                 ? 100 * b.projectionNormalImpulse / b.wallNormalImpulse
                 : 0)
         << " % of the wall impulse" << nl;
}

void caseRun::warnOfUnexplained() const
{
    constexpr scalar most = 0.05;
    const scalar unexplained = booked_.unexplained(now_);
    word scaleName;
    if (mag(unexplained) > most * energyScale(scaleName))
    {
        WarningInFunction
            << "Energy of " << unexplained << " J is explained by no loss,"
            << " more than 5 % of what this run is about: do not trust it. "
            << "Lower CFL of system/lpfSolution, write "
            << "timeIntegration predictorCorrector; there, "
            << "or take a smaller spacing" << endl;
    }
}

// What the scheme takes beside the laws of the materials
void caseRun::printArtificialShare() const
{
    constexpr scalar most = 0.05, least = 0.01;
    const balance& b = booked_;
    // diffusion and shifting may make energy: that is the scheme's, too
    const scalar artificial =
        b.artificial + mag(b.diffusion) + b.projection + mag(b.shifting);
    const scalar all =
        b.plastic + b.friction + b.viscous + b.drag + b.separation + artificial;
    if (!(all > 0))
    {
        return;
    }
    // at rest nothing is released that could be lost: the scheme gives and
    // takes
    word scaleName;
    const scalar scale = energyScale(scaleName);
    const bool matters = scaleName == "released" && all >= least * scale;
    Info << "Artificial viscosity, diffusion, shifting and contact: "
         << 100 * artificial / all << " % of all dissipation"
         << (matters ? ""
                     : ", which does not matter: less than 1 % of m g "
                       "releaseHeight was released, or of that dissipated")
         << nl;
    if (matters && artificial > most * all)
    {
        WarningInFunction
            << "More than 5 % of the dissipation is the scheme's, not the "
            << "material's: lower artificialViscosity, noiseDamping, "
            << "bulkDamping or shearDamping of system/lpfSolution, or take a "
               "smaller spacing"
            << endl;
    }
}

// Where the time of the steps of this run went; what no pass names is the
// limits of the time step. Writing times is no part of a step
void caseRun::printTimes() const
{
    const scalar simulated = control_.time - control_.startTime();
    const passTimes::entry output = outputTimes_.sum();
    const scalar wall = max(wallOfSteps_ - output.seconds, VSMALL);
    const scalar processor = processorOfSteps_ - output.processor;
    Info << "Wall time of " << steps_ << " steps " << wall << " s, "
         << particleSteps_ / wall << " particle-steps/s; c dt/h "
         << flow_.waveSpeed() * simulated / (steps_ * scene_.h) << ", "
         << wall / max(simulated, VSMALL) << " s a simulated second; "
         << "of the times written " << output.seconds << " s" << nl
         << "Time of the processors " << processor << " s, "
         << particleSteps_ / max(processor, VSMALL)
         << " particle-steps in a second of one" << nl
         << "Pairs of a particle within the support " << flow_.pairsOfParticle()
         << nl << nl << "    share %  ns a particle-step"
         << "  of processors  calls  pass" << nl;
    passTimes::entry rest = {"", wall, processor, static_cast<long>(steps_)};
    const auto line = [&](const passTimes::entry& e, const std::string& name)
    {
        char text[120];
        std::snprintf(
            text,
            sizeof(text),
            "    %7.2f  %18.1f  %13.1f  %5ld  %s",
            100 * e.seconds / wall,
            1e9 * e.seconds / particleSteps_,
            1e9 * e.processor / particleSteps_,
            e.calls,
            name.c_str()
        );
        Info << text << nl;
    };
    const auto lines = [&](const passTimes& times, const std::string& of)
    {
        rest.seconds -= times.sum().seconds;
        rest.processor -= times.sum().processor;
        for (const passTimes::entry& e : times.all())
        {
            line(e, of + e.name);
        }
    };
    for (const auto& phase : flow_.times())
    {
        lines(phase.second, phase.first + ": ");
    }
    lines(times_, "");
    line(rest, "limits");
}

int caseRun::finish()
{
    if (!stepped_)
    {
        const string why = flow_.size() > 0
                             ? control_.reasonToEnd()
                             : "there are no particles at time "
                                   + control_.timeName(control_.time);
        Info << "Nothing to do: " << why.c_str() << nl << nl << "End" << nl
             << endl;
        return 0;
    }
    if (flow_.size() == 0)
    {
        Info << "All particles have left, the last one before time "
             << control_.time << " s; the last time folder "
             << (lastWritten_.empty() ? control_.timeName(control_.startTime())
                                      : lastWritten_)
             << " shows those that were there then" << nl;
    }
    else if (atRest_)
    {
        Info << "At rest by " << stop_.criterion << " at time " << control_.time
             << " s" << nl;
    }
    else if (control_.asked())
    {
        Info << "Stopped as asked at time " << control_.time << " s" << nl;
    }
    printLedger();
    warnOfUnexplained();
    printArtificialShare();
    mostBytes_ = max(mostBytes_, flow_.bytes());
    const int evaluations = integration_->evaluations();
    const int groundPasses = evaluations * flow_.groundPasses();
    // some are not made in each step
    const scalar pairPasses =
        std::round(100 * evaluations * flow_.pairPasses()) / 100;
    Info << "Memory " << scalar(mostBytes_) / 1048576 << " MiB, "
         << scalar(mostBytes_) / max(startSize_, 1) << " bytes a particle; "
         << pairPasses << " pair passes and " << groundPasses << " ground pass"
         << (groundPasses > 1 ? "es" : "") << " a step" << nl;
    printTimes();

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
