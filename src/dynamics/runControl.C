// SPDX-License-Identifier: GPL-3.0-or-later
#include "runControl.H"

#include "inputCheck.H"

#include "OSspecific.H"
#include "Time.H"

#include <charconv>
#include <csignal>

namespace Foam
{
namespace lpf
{

namespace
{

// No time or step is shorter [s]
constexpr scalar shortest = 1e-12;

// set by a signal handler, which may do no more
volatile std::sig_atomic_t signalled = 0;

void onSignal(int number)
{
    signalled = number;
}

} // namespace

void runControl::catchSignals()
{
    for (const int number : {SIGTERM, SIGUSR1, SIGUSR2})
    {
        std::signal(number, onSignal);
    }
}

bool runControl::asked() const
{
    return asked_ || stopAt_ == "writeNow";
}

runControl::runControl(const fileName& caseDir) : caseDir_(caseDir)
{
    const fileName file(caseDir / "system" / "controlDict");
    const dictionary dict(readDictionary(file));
    if (dict.found("logInterval"))
    {
        refuse(
            dict,
            "logInterval",
            "logInterval stands in system/lpfSolution: move it there"
        );
    }
    allowOnly(dict, controlDictKeywords());
    warnOfUnused(dict);
    stamp_ = Foam::highResLastModified(file);
    readTimes(dict);
    readFormat(dict);
    timePrecision_ = readInteger(
        dict, "timePrecision", 1, allDigits, "a double has at most 17 digits", 6
    );
    purgeWrite_ = readInteger(
        dict,
        "purgeWrite",
        0,
        labelMax,
        "the number of times to keep, 0: all",
        0
    );
    modifiable_ = dict.getOrDefault<Switch>("runTimeModifiable", true);
    if (!dict.getOrDefault<Switch>("adjustTimeStep", true))
    {
        refuse(
            dict,
            "adjustTimeStep",
            "adjustTimeStep no: the step follows the stability limits, a fixed "
            "one would "
            "blow up or waste time; write yes, and maxDeltaT for an upper "
            "bound"
        );
    }
    bounds step;
    step.lower = shortest;
    step.reason = "a time step in s";
    maxDeltaT = readNumber(dict, "maxDeltaT", dimTime, step, GREAT);
    firstDeltaT_ = readNumber(dict, "deltaT", dimTime, step, GREAT);
    chooseStart(dict);
    warnOfTimes();
}

// Words of OpenFOAM that nothing here follows
void runControl::warnOfUnused(const dictionary& dict) const
{
    wordList unused;
    for (const word& key :
         {word("maxCo"),
          word("functions"),
          word("libs"),
          word("timeFormat"),
          word("graphFormat"),
          word("beginTime"),
          word("regionNames"),
          word("writeVersion"),
          word("printExecutionFormat")})
    {
        const bool asEver = key == "timeFormat" && dict.found(key)
                         && dict.lookup(key).size() == 1
                         && dict.lookup(key)[0].isWord()
                         && dict.lookup(key)[0].wordToken() == "general";
        if (dict.found(key) && !asEver)
        {
            unused.append(key);
        }
    }
    for (const word& key : unused)
    {
        WarningInFunction
            << "lpfSolver does not use " << key << " of system/controlDict"
            << (key == "maxCo" ? ": the step follows CFL of system/lpfSolution"
                : key == "functions" || key == "libs"
                    ? ": depositionSample and lpfToVTK evaluate the times that "
                      "are written"
                    : "")
            << endl;
    }
}

void runControl::warnOfTimes() const
{
    constexpr scalar many = 1e5;
    const scalar times = (endTime_ - startTime_) / writeInterval_;
    if (writeControl_ == "timeStep" || startTime_ >= endTime_)
    {
        return;
    }
    if (times > many && purgeWrite_ <= 0)
    {
        WarningInFunction
            << "writeInterval " << writeInterval_ << " s to endTime "
            << endTime_ << " s will write " << times
            << " time folders: is that meant? Write a longer writeInterval, or "
            << "purgeWrite with the number of times to keep" << endl;
    }
    if (mag(times - round(times)) > 1e-6 && times < many)
    {
        Info << "endTime " << endTime_ << " s is no multiple of writeInterval "
             << writeInterval_ << " s: the last step is cut to end there, so "
             << "that a run that goes on from it differs in rounding from one "
             << "in a whole" << nl;
    }
}

void runControl::readFormat(const dictionary& dict)
{
    format_.format(IOstream::formatEnum(
        readChoice(dict, "writeFormat", {"ascii", "binary"}, "binary")
    ));
    format_.compression(
        dict.getOrDefault<Switch>("writeCompression", false)
            ? IOstreamOption::COMPRESSED
            : IOstreamOption::UNCOMPRESSED
    );
    const label digits = readInteger(
        dict,
        "writePrecision",
        1,
        allDigits,
        "a double has at most 17 digits",
        6
    );
    if (format_.format() != IOstream::ASCII)
    {
        return;
    }
    digits_ = digits;
    IOstream::defaultPrecision(unsigned(digits));
    if (digits < allDigits)
    {
        WarningInFunction
            << "writeFormat ascii keeps " << digits
            << " digits of a number: no run can go on from the times that are "
            << "written. Write writeFormat binary; or writePrecision 17; for "
            << "that" << endl;
    }
}

void runControl::readTimes(const dictionary& dict)
{
    bounds positive;
    positive.lower = 0;
    positive.lowerOpen = true;
    positive.reason = "a run needs an end and an interval above zero, in s";

    stopAt_ = readChoice(
        dict,
        "stopAt",
        {"endTime", "writeNow", "noWriteNow", "nextWrite"},
        "endTime"
    );
    endTime_ = readNumber(dict, "endTime", dimTime, positive);
    writeControl_ = readChoice(
        dict, "writeControl", {"adjustableRunTime", "runTime", "timeStep"}
    );
    if (writeControl_ == "timeStep" && dict.found("writeInterval"))
    {
        writeInterval_ = readInteger(
            dict,
            "writeInterval",
            1,
            labelMax,
            "with writeControl timeStep it is a number of steps; write "
            "adjustableRunTime for an interval in s",
            1
        );
        return;
    }
    positive.lower = shortest;
    positive.lowerOpen = false;
    writeInterval_ = readNumber(dict, "writeInterval", dimTime, positive);
}

void runControl::chooseStart(const dictionary& dict)
{
    const word from = readChoice(
        dict,
        "startFrom",
        {"startTime", "firstTime", "latestTime"},
        "latestTime"
    );
    const instantList times(Time::findTimes(caseDir_));
    instantList present;
    for (const instant& t : times)
    {
        if (t.name() != "constant" && isDir(caseDir_ / t.name() / "lagrangian"))
        {
            present.append(t);
        }
    }
    if (present.empty())
    {
        FatalIOErrorInFunction(dict)
            << "There is no time with particles in " << caseDir_
            << ". Run terrainToParticles first" << exit(FatalIOError);
    }

    if (from == "latestTime")
    {
        startTime_ = present.last().value();
    }
    else if (from == "firstTime")
    {
        startTime_ = present.first().value();
    }
    else
    {
        bounds any;
        startTime_ = readNumber(dict, "startTime", dimTime, any, 0);
        const label nearest = Time::findClosestTimeIndex(present, startTime_);
        if (mag(present[nearest].value() - startTime_)
            > 1e-6 * max(mag(startTime_), scalar(1)))
        {
            refuse(
                dict,
                "startTime",
                "There are no particles at this time; the nearest is "
                    + present[nearest].name() + ". Write startTime "
                    + present[nearest].name() + "; or startFrom latestTime;"
            );
        }
    }
    time = startTime_;
    warnOfLaterTimes(present);
}

// A run that goes back in time writes over the same times only
void runControl::warnOfLaterTimes(const instantList& present) const
{
    wordList later;
    for (const instant& t : present)
    {
        if (t.value() > startTime_)
        {
            later.append(t.name());
        }
    }
    if (!later.empty())
    {
        WarningInFunction
            << "Times after the start are there, of an earlier run: "
            << later.size() << ", the first " << later.first() << ", the last "
            << later.last() << ". This run writes over those that it comes to; "
            << "depositionSample and lpfToVTK take what is there. If they are "
            << "not to be mixed, remove them first: foamListTimes -rm -time '"
            << later.first() << ":'" << endl;
    }
}

word runControl::timeName(scalar t) const
{
    for (label digits = timePrecision_; digits < 17; ++digits)
    {
        const word name(Time::timeName(t, int(digits)));
        if (mag(std::stod(name) - t) <= 1e-3 * deltaT)
        {
            return name;
        }
    }
    return Time::timeName(t, 17);
}

bool runControl::running() const
{
    if (asked() || stopAt_ == "noWriteNow"
        || (stopAt_ == "nextWrite" && atWriteTime_))
    {
        return false;
    }
    return time < endTime_;
}

string runControl::reasonToEnd() const
{
    const string now = "time " + timeName(time);
    if (time >= endTime_)
    {
        return now + " is at endTime; write a larger endTime to go on";
    }
    return "stopAt " + stopAt_ + " stands in system/controlDict at " + now
         + "; write stopAt endTime; to go on";
}

void runControl::readIfModified()
{
    const fileName file(caseDir_ / "system" / "controlDict");
    const double now = Foam::highResLastModified(file);
    if (!modifiable_ || now == stamp_)
    {
        return;
    }
    stamp_ = now;

    // a slip in the file, or half of it, must not end a run of days
    const runControl before(*this);
    const bool throwing = FatalIOError.throwExceptions();
    try
    {
        readTimes(readDictionary(file));
        Info << "controlDict changed: stopAt " << stopAt_ << ", endTime "
             << endTime_ << ", writeInterval " << writeInterval_ << nl;
    }
    catch (const IOerror& e)
    {
        *this = before;
        Info << "controlDict changed, but is not taken: " << e.message().c_str()
             << nl << "The run goes on as before" << nl;
    }
    FatalIOError.throwExceptions(throwing);
}

// Time of the n-th write, the number that its decimal says: an endTime of 0.3
// is that, 3*0.1 is 0.30000000000000004
scalar runControl::multiple(scalar n) const
{
    constexpr int digits = 15; // all that a double keeps of any decimal
    const scalar product = n * writeInterval_;
    scalar decimal = product;
    char text[40];
    const auto written = std::to_chars(
        text, text + sizeof(text), product, std::chars_format::general, digits
    );
    std::from_chars(text, written.ptr, decimal);
    return decimal;
}

scalar runControl::step(scalar stable)
{
    scalar dt = min(stable, maxDeltaT);
    dt = min(dt, unrestricted > 0 ? 1.1 * unrestricted : firstDeltaT_);
    unrestricted = dt;

    // the next time to meet exactly; the last steps before it are made equal
    scalar next = endTime_;
    if (writeControl_ == "adjustableRunTime")
    {
        next = min(next, multiple(floor(time / writeInterval_ + 1e-9) + 1));
    }
    const scalar steps = ceil((next - time) / dt - 1e-9);
    deltaT = steps <= 3 ? (next - time) / steps : dt;
    return deltaT;
}

bool runControl::writesAfterStep() const
{
    runControl after(*this);
    after.advance();
    return after.writeNow();
}

void runControl::advance()
{
    // once a step: a signal between the write and the next step waits
    asked_ = signalled != 0;
    const scalar before = time;
    time += deltaT;
    ++index;

    // no rounding may pile up: a time that was aimed at is met to the bit
    const scalar nearest = multiple(round(time / writeInterval_));
    if (writeControl_ == "timeStep")
    {
        atWriteTime_ = index % label(writeInterval_) == 0;
    }
    else
    {
        if (mag(time - nearest) < 1e-6 * deltaT)
        {
            time = nearest;
        }
        atWriteTime_ = floor(time / writeInterval_ + 1e-9)
                     > floor(before / writeInterval_ + 1e-9);
    }
    if (mag(time - endTime_) < 1e-6 * deltaT)
    {
        time = endTime_;
    }
}

bool runControl::writeNow() const
{
    return atWriteTime_ || asked() || time >= endTime_;
}

void runControl::purge() const
{
    if (purgeWrite_ <= 0)
    {
        return;
    }
    const instantList times(Time::findTimes(caseDir_));
    label kept = 0;
    for (label k = times.size() - 1; k >= 0; --k)
    {
        // later ones are of an earlier run
        const scalar at = times[k].value();
        if (times[k].name() != "constant" && at > 0 && at <= time + 0.5 * deltaT
            && ++kept > purgeWrite_)
        {
            rmDir(caseDir_ / times[k].name());
        }
    }
}

} // namespace lpf
} // namespace Foam
