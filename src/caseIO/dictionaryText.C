// SPDX-License-Identifier: GPL-3.0-or-later

#include "dictionaryText.H"
#include "error.H"
#include "IFstream.H"
#include "OSspecific.H"
#include "SHA1.H"
#include "stringOps.H"

#include <algorithm>
#include <cctype>
#include <cmath>
#include <cstdlib>
#include <sstream>
#include <vector>

namespace
{

std::string textOf(const Foam::fileName& file)
{
    Foam::IFstream is(file); // unpacks file.gz, too
    std::ostringstream text;
    if (is.good())
    {
        text << is.stdStream().rdbuf();
    }
    return text.str();
}


//- Walks over the text and knows where comments and strings are
class scanner
{
    const std::string& text_;
    std::size_t at_ = 0;
    enum class state
    {
        plain,
        lineComment,
        blockComment,
        string,
        verbatim
    } state_ = state::plain;

    bool sees(const char* two) const { return text_.compare(at_, 2, two) == 0; }

    //- Characters that belong to the step from plain text into `to`
    std::size_t enter(state to, std::size_t width)
    {
        state_ = to;
        return width;
    }

public:
    explicit scanner(const std::string& text) : text_(text) {}

    bool end() const { return at_ >= text_.size(); }
    std::size_t at() const { return at_; }
    bool inComment() const
    {
        return state_ == state::lineComment || state_ == state::blockComment;
    }
    bool inString() const
    {
        return state_ == state::string || state_ == state::verbatim;
    }

    //- Width of the piece at at(), all of one state
    std::size_t piece()
    {
        switch (state_)
        {
        case state::plain:
            return sees("//")        ? enter(state::lineComment, 2)
                 : sees("/*")        ? enter(state::blockComment, 2)
                 : sees("#{")        ? enter(state::verbatim, 2)
                 : text_[at_] == '"' ? enter(state::string, 1)
                                     : 1;
        case state::string:
            return text_[at_] == '\\' ? 2 : 1;
        default:
            return sees("*/") || sees("#}") ? 2 : 1;
        }
    }

    //- Go past a piece
    void pass(std::size_t width, bool opened)
    {
        const bool closed =
            !opened
            && ((state_ == state::lineComment && text_[at_] == '\n')
                || (state_ == state::blockComment && sees("*/"))
                || (state_ == state::verbatim && sees("#}"))
                || (state_ == state::string && text_[at_] == '"'));
        if (closed)
        {
            state_ = state::plain;
        }
        at_ += width;
    }
};


struct openBracket
{
    char closing;
    Foam::label line;
};

} // namespace


std::string
Foam::lpf::withoutComments(const std::string& text, const quoted strings)
{
    std::string result(text);
    scanner scan(text);
    while (!scan.end())
    {
        const bool wasPlain = !scan.inComment() && !scan.inString();
        const std::size_t width = scan.piece();
        const bool blank =
            scan.inComment() || (scan.inString() && strings == quoted::blank);
        for (std::size_t i = 0; blank && i < width; ++i)
        {
            char& c = result[std::min(scan.at() + i, text.size() - 1)];
            c = c == '\n' ? '\n' : ' ';
        }
        scan.pass(width, wasPlain);
    }
    return result;
}


namespace
{

[[noreturn]] void
stop(const Foam::fileName& file, const Foam::label line, const std::string& why)
{
    Foam::FatalIOError("", "", 0, file, line, -1)
        << why.c_str() << Foam::exit(Foam::FatalIOError);
    std::exit(1); // not reached; exit() above is not declared noreturn
}


//- OpenFOAM takes the rest of the file for the comment and says nothing
void checkCommentsEnd(const Foam::fileName& file, const std::string& text)
{
    scanner scan(text);
    std::size_t begin = 0;
    while (!scan.end())
    {
        const bool wasPlain = !scan.inComment() && !scan.inString();
        const std::size_t width = scan.piece();
        begin = wasPlain ? scan.at() : begin;
        scan.pass(width, wasPlain);
    }
    if (scan.inString() || (scan.inComment() && text[begin + 1] == '*'))
    {
        const auto lines = std::count(text.data(), text.data() + begin, '\n');
        stop(
            file,
            static_cast<Foam::label>(1 + lines),
            scan.inString() ? "the text that begins here does not end: write "
                              "the missing quote, or #}"
                            : "the comment that begins here does not end: "
                              "write the missing */"
        );
    }
}


//- A number that no double holds: OpenFOAM would stop with a floating point
//  exception
bool isTooLarge(const std::string& text)
{
    const bool isNumber =
        text.find_first_of("0123456789") != std::string::npos
        && text.find_first_not_of("+-.0123456789eE") == std::string::npos;
    char* end = nullptr;
    const double x = isNumber ? std::strtod(text.c_str(), &end) : 0;
    return isNumber && *end == 0 && std::isinf(x);
}


void checkNumbers(const Foam::fileName& file, const std::string& text)
{
    const char* const apart = " \t\n\r;(){}[],";
    Foam::label line = 1;
    std::size_t at = 0;
    while (at < text.size())
    {
        const auto end = std::min(text.find_first_of(apart, at), text.size());
        const std::string piece = text.substr(at, end - at);
        if (isTooLarge(piece))
        {
            stop(
                file,
                line,
                piece
                    + " is too large for a number: nothing of a scene is as "
                      "large in SI units"
            );
        }
        line += end < text.size() && text[end] == '\n';
        at = end + 1;
    }
}


//- The bracket c of a line closes the last of those open
void close(
    std::vector<openBracket>& open,
    const char c,
    const Foam::fileName& file,
    const Foam::label line
)
{
    if (open.empty())
    {
        stop(
            file,
            line,
            std::string("'") + c
                + "' closes nothing: remove it, or write the bracket that it "
                  "is to close"
        );
    }
    const openBracket& last = open.back();
    if (last.closing != c)
    {
        stop(
            file,
            line,
            std::string("'") + c + "' found where '" + last.closing
                + "' must close the bracket of line "
                + std::to_string(last.line) + ": write the missing '"
                + last.closing + "'"
        );
    }
    open.pop_back();
}

} // namespace


void Foam::lpf::checkText(const fileName& file)
{
    const std::string whole = textOf(file);
    checkCommentsEnd(file, whole);
    const std::string text = withoutComments(whole, quoted::blank);
    checkNumbers(file, text);
    std::vector<openBracket> open;
    label line = 1;
    for (const char c : text)
    {
        line += c == '\n';
        // ${name} closes with a brace of its own and so needs no exception
        if (c == '{' || c == '(' || c == '[')
        {
            open.push_back({c == '{' ? '}' : c == '(' ? ')' : ']', line});
        }
        else if (c == '}' || c == ')' || c == ']')
        {
            close(open, c, file, line);
        }
    }
    if (!open.empty())
    {
        stop(
            file,
            open.back().line,
            std::string("the bracket opened here is never closed: write the "
                        "missing '")
                + open.back().closing + "'"
        );
    }
}


namespace
{

bool belongsToName(const char c)
{
    return std::isalnum(static_cast<unsigned char>(c)) || c == '_';
}


void addMacros(const std::string& text, Foam::wordHashSet& names)
{
    for (auto at = text.find('$'); at != std::string::npos;
         at = text.find('$', at + 1))
    {
        // a path such as $:grains.rho or ${..rho}: each part counts as used
        std::string name;
        for (std::size_t i = at + 1; i <= text.size(); ++i)
        {
            const char c = i < text.size() ? text[i] : ' ';
            if (belongsToName(c))
            {
                name += c;
                continue;
            }
            names.insert(Foam::word(name, false));
            name.clear();
            if (std::string("{.:/^").find(c) == std::string::npos)
            {
                break;
            }
        }
    }
}


struct namedText
{
    Foam::fileName file;
    std::string text; //!< without comments
};


//- The file and those that it includes, in order
void addFiles(
    const Foam::fileName& file,
    std::vector<namedText>& files,
    const int depth = 0
)
{
    using namespace Foam;

    const std::string text =
        lpf::withoutComments(textOf(file), lpf::quoted::keep);
    files.push_back({file, text});
    for (auto at = text.find("#include"); depth < 10 && at != std::string::npos;
         at = text.find("#include", at + 1))
    {
        const auto begin = text.find('"', at);
        const auto end = text.find('"', begin + 1);
        if (end == std::string::npos || begin > text.find('\n', at))
        {
            continue;
        }
        fileName included(text.substr(begin + 1, end - begin - 1), false);
        stringOps::inplaceExpand(included);
        addFiles(
            included.isAbsolute() ? included : file.path() / included,
            files,
            depth + 1
        );
    }
}


//- Number, from 1, of the first line with the word; of `only` if that is > 0.
//  0: none
Foam::label
lineWith(const std::string& text, const std::string& word, Foam::label only)
{
    for (auto at = text.find(word); at != std::string::npos;
         at = text.find(word, at + 1))
    {
        const auto end = at + word.size();
        const auto newLines = std::count(text.data(), text.data() + at, '\n');
        const auto line = static_cast<Foam::label>(1 + newLines);
        const bool whole = (at == 0 || !belongsToName(text[at - 1]))
                        && (end == text.size() || !belongsToName(text[end]));
        if (whole && (only <= 0 || line == only))
        {
            return line;
        }
    }
    return 0;
}

} // namespace


Foam::lpf::filePlace
Foam::lpf::placeOf(const fileName& file, const word& key, const label line)
{
    std::vector<namedText> files;
    addFiles(file, files);
    for (const namedText& f : files)
    {
        const label found = lineWith(f.text, key, line);
        if (found)
        {
            return {f.file, found};
        }
    }
    return {file, line};
}


Foam::word Foam::lpf::digestOf(const fileName& file)
{
    std::vector<namedText> files;
    addFiles(file, files);
    SHA1 sum;
    for (const namedText& f : files)
    {
        std::istringstream words(f.text);
        std::string before;
        for (std::string each; words >> each; before = each)
        {
            // a blank says nothing beside brackets
            const std::string marks = "{}();";
            const bool apart = !before.empty()
                            && marks.find(before.back()) == std::string::npos
                            && marks.find(each.front()) == std::string::npos;
            sum.append((apart ? " " : "") + each);
        }
    }
    // a letter first: digits would be read as a number
    return word("d" + sum.str().substr(0, 16));
}


Foam::wordHashSet Foam::lpf::macrosUsed(const fileName& file)
{
    std::vector<namedText> files;
    addFiles(file, files);
    wordHashSet names;
    for (const namedText& f : files)
    {
        addMacros(f.text, names);
    }
    names.erase(word());
    return names;
}
