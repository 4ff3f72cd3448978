// SPDX-License-Identifier: GPL-3.0-or-later

#include "inputCheck.H"
#include "dictionaryText.H"
#include "IFstream.H"
#include "dimensionSets.H"
#include "ListOps.H"
#include "OSspecific.H"
#include "OStringStream.H"
#include "sigFpe.H"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <numeric>
#include <vector>

namespace
{

using namespace Foam;

//- dict.name() without the names of sub-dictionaries
fileName topFile(const dictionary& dict)
{
    fileName file(dict.name());
    while (!isFile(file))
    {
        const auto dot = file.rfind('.');
        if (dot == std::string::npos || dot == 0)
        {
            return dict.name();
        }
        file.resize(dot);
    }
    return file;
}


string listed(const wordList& words)
{
    string text;
    for (const word& w : words)
    {
        text += (text.empty() ? "" : " ") + w;
    }
    return text;
}


//- What an entry says, as far as it fits on a line
string written(const entry& e)
{
    if (e.isDict())
    {
        return "a sub-dictionary";
    }
    OStringStream os;
    forAll (e.stream(), i)
    {
        os << (i ? " " : "") << e.stream()[i];
    }
    string text(os.str());
    return text.size() < 50 ? text : string(text.substr(0, 47) + "...");
}


string shown(const scalar x)
{
    OStringStream os;
    os.precision(10);
    os << x;
    return os.str();
}


string shown(const dimensionSet& dims)
{
    OStringStream os;
    os << dims;
    return os.str();
}


//- Number of edits, letter case ignored, that lead from a to b
label distance(const word& a, const word& b)
{
    std::vector<label> row(b.size() + 1);
    std::iota(row.begin(), row.end(), 0);
    for (std::size_t i = 1; i <= a.size(); ++i)
    {
        label diagonal = row[0];
        row[0] = static_cast<label>(i);
        for (std::size_t j = 1; j <= b.size(); ++j)
        {
            const label above = row[j];
            const bool same = std::tolower(a[i - 1]) == std::tolower(b[j - 1]);
            row[j] = std::min({above + 1, row[j - 1] + 1, diagonal + !same});
            diagonal = above;
        }
    }
    return row.back();
}


string rule(const lpf::bounds& b)
{
    const string low =
        (b.lowerOpen ? "greater than " : "at least ") + shown(b.lower);
    const string high =
        (b.upperOpen ? "less than " : "at most ") + shown(b.upper);
    return b.lower <= -GREAT ? high
         : b.upper >= GREAT  ? low
                             : string(low + " and " + high);
}


//- No quantity of a scene is larger; products of such numbers stay finite
bool isAbsurd(const scalar x)
{
    return !(mag(x) <= GREAT);
}


bool inside(const lpf::bounds& b, const scalar x)
{
    return (b.lowerOpen ? x > b.lower : x >= b.lower)
        && (b.upperOpen ? x < b.upper : x <= b.upper);
}


//- The tokens of an entry in their order: [name] [dimensions] value
class valueTokens
{
    const dictionary& dict_;
    const entry& entry_;
    const ITstream& tokens_;
    label at_ = 0;

public:
    valueTokens(const dictionary& dict, const entry& e)
        : dict_(dict), entry_(e), tokens_(e.stream())
    {
    }

    [[noreturn]] void refuse(const string& why) const
    {
        lpf::refuse(dict_, entry_.keyword(), why);
    }

    bool end() const { return at_ >= tokens_.size(); }

    //- Old form `key key [dims] value`: the name carries no information
    void passName()
    {
        if (at_ + 1 < tokens_.size() && tokens_[at_].isWord())
        {
            ++at_;
        }
    }

    void checkDimensions(const dimensionSet& expected, const string& example);

    //- A finite number
    scalar number(const string& expected)
    {
        if (end() || !tokens_[at_].isNumber())
        {
            refuse(
                entry_.keyword() + " = " + written(entry_) + " is not "
                + expected
            );
        }
        const scalar x = tokens_[at_++].number();
        if (isAbsurd(x))
        {
            refuse(
                entry_.keyword() + " = " + written(entry_)
                + " is beyond 1e15, larger than anything of a scene in SI "
                  "units: it must be "
                + expected
            );
        }
        return x;
    }

    bool passes(const token::punctuationToken p)
    {
        const bool is = !end() && tokens_[at_] == p;
        at_ += is;
        return is;
    }

    void checkEnd() const
    {
        if (!end())
        {
            refuse(
                entry_.keyword() + " = " + written(entry_)
                + " goes on after "
                  "its value; is a ';' missing at the end of its line?"
            );
        }
    }
};


void valueTokens::checkDimensions(
    const dimensionSet& expected, const string& example
)
{
    if (end() || tokens_[at_] != token::BEGIN_SQR)
    {
        return;
    }
    scalar exponents[7] = {0, 0, 0, 0, 0, 0, 0};
    label n = 0;
    bool good = true;
    for (++at_; !end() && tokens_[at_] != token::END_SQR; ++at_)
    {
        good = good && n < 7 && tokens_[at_].isNumber();
        if (good)
        {
            exponents[n++] = tokens_[at_].number();
        }
    }
    if (!good || end() || (n != 5 && n != 7))
    {
        refuse(
            entry_.keyword() + " = " + written(entry_)
            + ": units are written "
              "as seven exponents of kg m s K mol A cd; write "
            + example
        );
    }
    ++at_;
    dimensionSet given(dimless);
    for (label i = 0; i < 7; ++i)
    {
        given[static_cast<dimensionSet::dimensionType>(i)] = exponents[i];
    }
    if (given != expected)
    {
        refuse(
            entry_.keyword() + " = " + written(entry_) + " has units "
            + shown(given) + " but " + shown(expected) + " are needed; write "
            + example + " with the value in SI units"
        );
    }
}


const entry&
found(const dictionary& dict, const word& key, const string& example)
{
    // no patterns, no parents: an entry counts only where it is written
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    if (!e)
    {
        const word near = lpf::nearestWord(key, dict.toc());
        lpf::refuse(
            dict,
            key,
            key + " is missing; write " + example
                + (near.empty() ? "" : ". Is '" + near + "' meant to be it?")
        );
    }
    if (e->isDict())
    {
        lpf::refuse(
            dict,
            key,
            key + " is a sub-dictionary but must be a value; write " + example
        );
    }
    return *e;
}


bool selected(const dictionary& dict, const word& model)
{
    for (const entry& e : dict)
    {
        if (!e.isDict() && e.stream().size() && e.stream()[0].isWord()
            && e.stream()[0].wordToken() == model)
        {
            return true;
        }
    }
    return false;
}


bool noneSelected(const dictionary& dict, const wordList& models)
{
    return std::none_of(
        models.begin(),
        models.end(),
        [&](const word& model) { return selected(dict, model); }
    );
}


//- Whether an entry is <Model>Coeffs of a valid model
bool isCoeffs(
    const dictionary& dict,
    const word& keyword,
    const wordList& coeffsOf,
    const word& usual
)
{
    for (const word& model : coeffsOf)
    {
        if (keyword == model + "Coeffs")
        {
            if (!selected(dict, model)
                && !(model == usual && noneSelected(dict, coeffsOf)))
            {
                Info << keyword << " in " << dict.name()
                     << " is not used: " << model << " is not selected" << endl;
            }
            return true;
        }
    }
    return false;
}


//- While OpenFOAM parses: its errors come here, since some know neither file
//  nor line and some end with abort
class throwingErrors
{
    const bool io_ = FatalIOError.throwExceptions();
    const bool plain_ = FatalError.throwExceptions();

public:
    throwingErrors() = default;
    throwingErrors(const throwingErrors&) = delete;
    throwingErrors& operator=(const throwingErrors&) = delete;
    ~throwingErrors() { restore(); }

    void restore() const
    {
        FatalIOError.throwExceptions(io_);
        FatalError.throwExceptions(plain_);
    }
};


//- What to do about an error that OpenFOAM found
const char* remedyFor(const std::string& message)
{
    const auto says = [&](const char* text)
    { return message.find(text) != std::string::npos; };

    return says("ill defined primitiveEntry")
             ? "\nIs a ';' missing at the end of the value, or a number too "
               "large?"
         : says("Illegal dictionary entry or environment")
             ? "\nDefine the macro above the line that uses it"
         : says("Syntax error in expression")
             ? "\nA macro that #eval does not know counts as nothing: is one "
               "misspelt?"
         : says("should not be executed")
             ? "\nWrite #eval{ } in place of #calc: it needs no compiler"
             : "";
}


[[noreturn]] void
refuseParsed(const std::string& message, const fileName& file, const label line)
{
    FatalIOError("", "", 0, file, line, -1)
        << message.c_str() << remedyFor(message) << exit(FatalIOError);
    std::exit(1); // not reached; exit() above is not declared noreturn
}


//- The tokens between the brackets of a list, all of which are isGood
List<token> listTokens(
    const dictionary& dict,
    const word& key,
    const char* what,
    const string& remedy,
    bool (token::*isGood)() const
)
{
    const entry& e = found(dict, key, "it as a list: " + remedy);
    const ITstream& is = e.stream();
    List<token> tokens(max(label(0), is.size() - 2));
    bool good = is.size() > 1 && is[0] == token::BEGIN_LIST
             && is[is.size() - 1] == token::END_LIST;
    forAll (tokens, k)
    {
        tokens[k] = is[k + 1];
        good = good && (tokens[k].*isGood)();
    }
    if (!good)
    {
        lpf::refuse(
            dict,
            key,
            key + " = " + written(e) + " is no list of " + what + " in (); "
                + remedy
        );
    }
    return tokens;
}

} // namespace


void Foam::lpf::refuse(
    const dictionary& dict, const word& key, const string& message
)
{
    // The dictionary itself when it has no such entry. An #include may have
    // brought the entry
    const entry* e = dict.findEntry(key, keyType::LITERAL);
    const fileName top = topFile(dict);
    const filePlace place =
        e ? placeOf(top, key, e->startLineNumber())
        : (dict.empty() && dict.name() != top)
            ? placeOf(top, dict.dictName(), -1)
            : filePlace{top, max(label(1), dict.startLineNumber())};

    // no function name and line of our sources: the user's file is the matter
    FatalIOError(
        "",
        "",
        0,
        place.file == top ? dict.name() : place.file,
        place.line,
        e ? -1 : dict.endLineNumber()
    ) << message.c_str()
      << exit(FatalIOError);
    std::exit(1); // not reached; exit() above is not declared noreturn
}


Foam::word Foam::lpf::nearestWord(const word& given, const wordList& valid)
{
    word nearest;
    // in short names each letter counts: mu2 is no misspelt muS
    label least =
        given.size() < 4 ? 0 : static_cast<label>((given.size() + 1) / 3);
    for (const word& w : valid)
    {
        const label d = distance(given, w);
        if (d < least || (d == least && nearest.empty()))
        {
            nearest = w;
            least = d;
        }
    }
    return nearest;
}


Foam::dictionary
Foam::lpf::readDictionary(const fileName& file, const char* remedy)
{
    if (!isFile(file))
    {
        FatalIOError("", "", 0, file, -1, -1)
            << "the file does not exist; "
            << (isDir(file.path())
                    ? remedy
                    : "its folder neither: is this the case directory?")
            << exit(FatalIOError);
    }
    // a number too large, or #eval{ 1/0 }: what reads the value refuses it
    const sigFpe::ignore noTrap;
    checkText(file);
    IFstream is(file);
    if (!is.good())
    {
        FatalIOError("", "", 0, file, -1, -1)
            << "the file cannot be opened: check its permissions"
            << exit(FatalIOError);
    }
    const throwingErrors guard;
    try
    {
        return dictionary(is); // unnamed: must not move, see the header
    }
    catch (const IOerror& e)
    {
        // an included file; a dictionary knows only where it begins
        const fileName other(e.ioFileName());
        const bool placed = other != file && isFile(other);
        guard.restore();
        refuseParsed(
            e.message(),
            placed ? other : file,
            placed ? e.ioStartLineNumber() : is.lineNumber()
        );
    }
    catch (const error& e)
    {
        guard.restore();
        refuseParsed(e.message(), file, is.lineNumber());
    }
}


void Foam::lpf::allowOnly(
    const dictionary& dict,
    const wordList& valid,
    const wordList& coeffsOf,
    const word& usual
)
{
    for (const entry& e : dict)
    {
        const keyType& key = e.keyword();
        bool known = key == "FoamFile" || valid.found(key)
                  || isCoeffs(dict, key, coeffsOf, usual);
        for (const word& w : valid)
        {
            known = known || (key.isPattern() && key.match(w));
        }
        if (known || macrosUsed(topFile(dict)).found(key))
        {
            continue;
        }
        wordList all(valid);
        for (const word& model : coeffsOf)
        {
            all.append(model + "Coeffs");
        }
        const word near = nearestWord(key, all);
        refuse(
            dict,
            key,
            "unknown keyword '" + key + "'"
                + (near.empty() ? "" : ", do you mean '" + near + "'?")
                + "\nValid here: " + listed(all)
        );
    }
}


Foam::wordList Foam::lpf::controlDictKeywords()
{
    return {
        "application",
        "solver",
        "startFrom",
        "startTime",
        "stopAt",
        "endTime",
        "deltaT",
        "writeControl",
        "writeInterval",
        "purgeWrite",
        "writeFormat",
        "writePrecision",
        "writeCompression",
        "timeFormat",
        "timePrecision",
        "runTimeModifiable",
        "adjustTimeStep",
        "maxCo",
        "maxDeltaT",
        "functions",
        "libs",
        "graphFormat",
        "beginTime",
        "regionNames",
        "DebugSwitches",
        "InfoSwitches",
        "OptimisationSwitches",
        "DimensionedConstants",
        "writeVersion",
        "printExecutionFormat"};
}


Foam::scalar Foam::lpf::readNumber(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims,
    const bounds& allowed
)
{
    const bool bounded = allowed.lower > -GREAT || allowed.upper < GREAT;
    const bool hasUnits = !dims.dimensionless();
    const string example =
        "'" + key + (hasUnits ? " " + shown(dims) : string()) + " <number>;'";
    const string reason = *allowed.reason ? string(": ") + allowed.reason : "";

    const entry& e = found(
        dict,
        key,
        example + (bounded ? ", " + rule(allowed) : string()) + reason
    );
    valueTokens tokens(dict, e);
    tokens.passName();
    tokens.checkDimensions(dims, example);
    const scalar x = tokens.number("a finite number; write " + example);
    tokens.checkEnd();
    if (!inside(allowed, x))
    {
        refuse(
            dict,
            key,
            key + " = " + shown(x) + " must be " + rule(allowed) + reason
        );
    }
    return x;
}


Foam::scalar Foam::lpf::readNumber(
    const dictionary& dict,
    const word& key,
    const dimensionSet& dims,
    const bounds& allowed,
    const scalar deflt
)
{
    return dict.found(key, keyType::LITERAL)
             ? readNumber(dict, key, dims, allowed)
             : deflt;
}


Foam::Pair<Foam::scalar>
Foam::lpf::readInterval(const dictionary& dict, const word& key)
{
    const ITstream& is =
        found(dict, key, "'" + key + " (<lower> <upper>);' in m").stream();
    if (is.size() != 4 || is[0] != token::BEGIN_LIST || !is[1].isNumber()
        || !is[2].isNumber() || is[3] != token::END_LIST
        || isAbsurd(is[1].number()) || isAbsurd(is[2].number())
        || !(is[1].number() < is[2].number()))
    {
        lpf::refuse(
            dict,
            key,
            key + " is not an interval: two coordinates, the smaller one first;"
                + " write " + key + " (<lower> <upper>); in m"
        );
    }
    return {is[1].number(), is[2].number()};
}


const Foam::dictionary*
Foam::lpf::optionalDictionary(const dictionary& dict, const word& key)
{
    const entry* found = dict.findEntry(key, keyType::LITERAL);
    if (found && !found->isDict())
    {
        lpf::refuse(
            dict,
            key,
            key + " = " + written(*found) + ": " + key
                + " is a dictionary; write " + key + " {}"
        );
    }
    return found ? &found->dict() : nullptr;
}


const Foam::dictionary& Foam::lpf::neededDictionary(
    const dictionary& dict, const word& key, const string& remedy
)
{
    const entry* found = dict.findEntry(key, keyType::LITERAL);
    if (!found)
    {
        const word near = nearestWord(key, dict.toc());
        lpf::refuse(
            dict,
            key,
            "There is no dictionary " + key + "; " + remedy
                + (near.empty() ? "" : ". Is '" + near + "' meant to be it?")
        );
    }
    if (!found->isDict())
    {
        lpf::refuse(
            dict,
            key,
            key + " = " + written(*found) + ": " + key + " is a dictionary; "
                + remedy
        );
    }
    return found->dict();
}


Foam::wordList Foam::lpf::readWords(
    const dictionary& dict, const word& key, const string& remedy
)
{
    wordList words;
    for (const token& t :
         listTokens(dict, key, "words", remedy, &token::isWord))
    {
        words.append(t.wordToken());
    }
    return words;
}


Foam::List<Foam::scalar> Foam::lpf::readNumbers(
    const dictionary& dict, const word& key, const string& remedy
)
{
    List<scalar> numbers;
    for (const token& t :
         listTokens(dict, key, "numbers", remedy, &token::isNumber))
    {
        numbers.append(t.number());
    }
    return numbers;
}


Foam::label Foam::lpf::readInteger(
    const dictionary& dict,
    const word& key,
    const label lower,
    const label upper,
    const char* reason,
    const label deflt
)
{
    if (!dict.found(key, keyType::LITERAL))
    {
        return deflt;
    }
    const string wanted =
        "a whole number "
        + (upper < labelMax
               ? "from " + Foam::name(lower) + " to " + Foam::name(upper)
               : "of at least " + Foam::name(lower));
    valueTokens tokens(dict, found(dict, key, "'" + key + " <number>;'"));
    tokens.passName();
    tokens.checkDimensions(dimless, "'" + key + " <number>;'");
    const scalar x = tokens.number(wanted + ": " + reason);
    tokens.checkEnd();
    if (x < lower || x > upper || x > std::floor(x))
    {
        refuse(
            dict,
            key,
            key + " = " + shown(x) + " must be " + wanted
                + (x > labelMax ? ", and at most " + Foam::name(labelMax)
                                : std::string())
                + ": " + reason
        );
    }
    return label(x);
}


Foam::vector Foam::lpf::readVector(
    const dictionary& dict, const word& key, const dimensionSet& dims
)
{
    const bool hasUnits = !dims.dimensionless();
    const string example = "'" + key + (hasUnits ? " " + shown(dims) : string())
                         + " (<x> <y> <z>);'";
    valueTokens tokens(dict, found(dict, key, example));
    tokens.passName();
    tokens.checkDimensions(dims, example);

    const string expected("three finite numbers in (); write " + example);
    const auto need = [&](const token::punctuationToken p)
    {
        if (!tokens.passes(p))
        {
            tokens.refuse(
                key + " = " + written(*dict.findEntry(key, keyType::LITERAL))
                + " is not " + expected
            );
        }
    };
    need(token::BEGIN_LIST);
    vector v;
    for (scalar& component : v)
    {
        component = tokens.number(expected);
    }
    need(token::END_LIST);
    tokens.checkEnd();
    return v;
}


Foam::word Foam::lpf::readChoice(
    const dictionary& dict, const word& key, const wordList& choices
)
{
    const entry& e =
        found(dict, key, key + " followed by one of: " + listed(choices) + ";");
    const ITstream& tokens = e.stream();
    const bool isWord = tokens.size() && tokens[0].isWord();
    if (!isWord || !choices.found(tokens[0].wordToken()))
    {
        const word near =
            isWord ? nearestWord(tokens[0].wordToken(), choices) : word();
        refuse(
            dict,
            key,
            key + " = " + written(e) + " is not a valid choice"
                + (near.empty() ? "" : ", do you mean '" + near + "'?")
                + "\nValid choices: " + listed(choices)
        );
    }
    if (tokens.size() > 1)
    {
        refuse(
            dict,
            key,
            key + " = " + written(e)
                + " goes on after its value; "
                  "is a ';' missing at the end of its line?"
        );
    }
    return tokens[0].wordToken();
}


Foam::word Foam::lpf::readChoice(
    const dictionary& dict,
    const word& key,
    const wordList& choices,
    const word& deflt
)
{
    return dict.found(key, keyType::LITERAL) ? readChoice(dict, key, choices)
                                             : deflt;
}


Foam::vector Foam::lpf::readGravity(const fileName& caseDir)
{
    const dictionary dict = readDictionary(caseDir / "constant" / "g");
    allowOnly(dict, {"dimensions", "value"});

    // `dimensions [0 1 -2 0 0 0 0];` is a value of its own in this file
    const entry* e = dict.findEntry("dimensions", keyType::LITERAL);
    if (!e || e->isDict() || !e->stream().size()
        || e->stream()[0] != token::BEGIN_SQR)
    {
        refuse(
            dict,
            "dimensions",
            "dimensions is missing or no units; write "
            "dimensions "
                + shown(dimAcceleration) + ";"
        );
    }
    valueTokens(dict, *e).checkDimensions(
        dimAcceleration, "'dimensions " + shown(dimAcceleration) + ";'"
    );
    const vector g = readVector(dict, "value", dimAcceleration);
    if (!(mag(g) > 0))
    {
        refuse(
            dict,
            "value",
            "Gravity is zero: nothing would move, and there is no upwards; "
            "write value (0 0 -9.81);"
        );
    }
    constexpr scalar most = 1e5; // a centrifuge of 10 000 g
    if (mag(g) > most)
    {
        refuse(
            dict,
            "value",
            "Gravity is " + shown(mag(g)) + " m/s2, above " + shown(most)
                + " is taken for a slip; write value (0 0 -9.81);"
        );
    }
    return g;
}


void Foam::lpf::checkGravityInPlane(
    const fileName& caseDir, const vector& normal
)
{
    constexpr scalar rounding = 1e-9;
    const vector g = readGravity(caseDir);
    if (mag(g & normal) > rounding * mag(g))
    {
        refuse(
            readDictionary(caseDir / "constant" / "g"),
            "value",
            "Gravity (" + shown(g.x()) + " " + shown(g.y()) + " " + shown(g.z())
                + ") has a part of " + shown(g & normal)
                + " m/s2 along the normal of the plane strain: the slice would "
                  "fly out of its plane. Write a gravity in the plane, or "
                  "another normal in planeStrain of "
                  "constant/boundaryProperties"
        );
    }
}
