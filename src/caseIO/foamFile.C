// SPDX-License-Identifier: GPL-3.0-or-later

#include "foamFile.H"
#include "dictionary.H"
#include "foamVersion.H"
#include "IFstream.H"
#include "IOobject.H"
#include "OSspecific.H"

#include <charconv>
#include <cmath>
#include <cstring>
#include <iterator>

namespace
{

using namespace Foam;

// ------------------------------------------------------------------ writing

template<class T>
struct component
{
    using type = scalar;
    static constexpr int n = T::nComponents;
};
template<>
struct component<label>
{
    using type = label;
    static constexpr int n = 1;
};
template<>
struct component<scalar>
{
    using type = scalar;
    static constexpr int n = 1;
};


//- Text in large pieces: formatting by std::to_chars is several times faster
//  than by streams and gives the same digits
class textWriter
{
    std::ostream& os_;
    std::string text_;
    const int precision_;

    void add(const scalar x)
    {
        char digits[40];
        // from 17 digits on, the shortest text that reads back to the same
        // bits says the same as all 17
        const auto end = precision_ >= 17
                           ? std::to_chars(digits, std::end(digits), x)
                           : std::to_chars(
                               digits,
                               std::end(digits),
                               x,
                               std::chars_format::general,
                               precision_
                           );
        text_.append(digits, end.ptr);
    }
    void add(const label i)
    {
        char digits[24];
        const auto end = std::to_chars(digits, std::end(digits), i);
        text_.append(digits, end.ptr);
    }

public:
    explicit textWriter(OFstream& os)
        : os_(os.stdStream()), precision_(os.precision())
    {
    }
    ~textWriter()
    {
        os_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
    }

    template<class T>
    void value(const T& v)
    {
        using C = typename component<T>::type;
        constexpr int n = component<T>::n;

        const C* c = reinterpret_cast<const C*>(&v);
        text_ += n > 1 ? "(" : "";
        for (int i = 0; i < n; ++i)
        {
            text_ += i ? " " : "";
            add(c[i]);
        }
        text_ += n > 1 ? ")" : "";
    }

    void mark(const char* text)
    {
        text_ += text;
        if (text_.size() > (1u << 20))
        {
            os_.write(text_.data(), static_cast<std::streamsize>(text_.size()));
            text_.clear();
        }
    }
};


//- The folder of a file relative to its case, under the name that its time
//  folder has once it is complete
fileName location(const fileName& file)
{
    for (const char* folder :
         {"/lagrangian/", "/uniform/", "/constant/", "/system/"})
    {
        const auto at = file.rfind(folder);
        if (at != std::string::npos && at > 0)
        {
            // the first two stand in a time folder, the others in the case
            const bool inTime = folder[1] == 'l' || folder[1] == 'u';
            const auto begin = inTime ? file.rfind('/', at - 1) + 1 : at + 1;
            std::string path(file, begin);
            const std::string hidden(".lpfWriting.");
            path.erase(
                0, path.compare(0, hidden.size(), hidden) ? 0 : hidden.size()
            );
            return fileName(path, false).path();
        }
    }
    return file.path().name();
}

} // namespace


void Foam::lpf::writeFoamHeader(
    Ostream& os, const word& className, const fileName& file, const string& note
)
{
    IOobject::writeBanner(os) << "FoamFile\n{\n"
                              << "    version     " << os.version() << ";\n"
                              << "    format      " << os.format() << ";\n"
                              << "    class       " << className << ";\n";
    // also in ascii: readers take the width of labels from it
    os << "    arch        " << foamVersion::buildArch << ";\n";
    if (!note.empty())
    {
        os << "    note        " << note << ";\n";
    }
    os << "    location    " << location(file) << ";\n"
       << "    object      " << word(file.name()) << ";\n"
       << "}" << nl;
    IOobject::writeDivider(os) << nl;
}


Foam::lpf::outputFile::outputFile(
    const fileName& name, const IOstreamOption& format
)
    : name_(name), os_(name,
                       format.format(),
                       IOstreamOption::currentVersion,
                       format.format() == IOstreamOption::BINARY
                           ? IOstreamOption::UNCOMPRESSED
                           : format.compression())
{
    if (!os_.good())
    {
        FatalErrorInFunction << "Cannot write " << name << nl
                             << "Check permissions and free space"
                             << exit(FatalError);
    }
}


void Foam::lpf::outputFile::close()
{
    os_.stdStream().flush();
    if (!os_.stdStream().good())
    {
        FatalErrorInFunction
            << "Writing " << name_ << " failed: is the disk full?" << nl
            << "What was written before is unharmed" << exit(FatalError);
    }
}


template<class T>
void Foam::lpf::writeList(
    const fileName& file,
    const word& className,
    const UList<T>& values,
    const IOstreamOption& format
)
{
    outputFile out(file, format);
    OFstream& os = out.stream();
    writeFoamHeader(os, className, file);
    os << values.size() << nl;
    if (os.format() == IOstreamOption::BINARY)
    {
        // an empty binary list has no brackets: List<T> reads it so
        if (!values.empty())
        {
            os.write(
                reinterpret_cast<const char*>(values.cdata()),
                static_cast<std::streamsize>(sizeof(T)) * values.size()
            );
        }
    }
    else
    {
        textWriter text(os);
        text.mark("(\n");
        for (const T& v : values)
        {
            text.value(v);
            text.mark("\n");
        }
        text.mark(")");
    }
    IOobject::writeEndDivider(os);
    out.close();
}


void Foam::lpf::writePositions(
    const fileName& file,
    const UList<vector>& positions,
    const IOstreamOption& format
)
{
    outputFile out(file, format);
    OFstream& os = out.stream();
    writeFoamHeader(os, "Cloud<passiveParticle>", file);
    os << positions.size() << nl << token::BEGIN_LIST << nl;
    if (os.format() == IOstreamOption::BINARY)
    {
        // as particle::writePosition does, without its overhead
        constexpr std::size_t width = sizeof(vector) + sizeof(label) + 3;
        const label celli = 0;
        std::string text;
        for (const vector& x : positions)
        {
            char record[width];
            record[0] = token::BEGIN_LIST;
            std::memcpy(record + 1, &x, sizeof(vector));
            std::memcpy(record + 1 + sizeof(vector), &celli, sizeof(label));
            record[width - 2] = token::END_LIST;
            record[width - 1] = '\n';
            os.stdStream().write(record, width);
        }
    }
    else
    {
        textWriter text(os);
        for (const vector& x : positions)
        {
            text.value(x);
            text.mark(" 0\n");
        }
    }
    os << token::END_LIST << nl;
    IOobject::writeEndDivider(os);
    out.close();
}


// ------------------------------------------------------------------ reading

namespace
{

//- Walks over the data of a file; every step is checked against its end
class textReader
{
    const lpf::inputFile& file_;
    const char* at_;
    const char* const end_;

public:
    explicit textReader(const lpf::inputFile& file)
        : file_(file), at_(file.data.data()),
          end_(file.data.data() + file.data.size())
    {
    }

    [[noreturn]] void damaged(const string& why) const
    {
        file_.damaged(why, at_);
    }

    std::size_t left() const { return static_cast<std::size_t>(end_ - at_); }

    //- Past white space and comments
    void passSpace()
    {
        while (at_ < end_)
        {
            if (*at_ == '/' && left() > 1 && at_[1] == '/')
            {
                at_ = std::find(at_, end_, '\n');
            }
            else if (std::isspace(static_cast<unsigned char>(*at_)))
            {
                ++at_;
            }
            else
            {
                return;
            }
        }
    }

    bool sees(const char c)
    {
        passSpace();
        return at_ < end_ && *at_ == c;
    }

    void need(const char c)
    {
        if (!sees(c))
        {
            damaged(
                left() ? string("'") + c + "' expected, found '" + *at_ + "'"
                       : string("it ends where '") + c + "' is expected"
            );
        }
        ++at_;
    }

    template<class C>
    C number()
    {
        passSpace();
        C x;
        const auto result = std::from_chars(at_, end_, x);
        if (result.ec != std::errc())
        {
            damaged(left() ? "a number is expected here" : "it ends too early");
        }
        at_ = result.ptr;
        return x;
    }

    //- Length of the list, that cannot need more than the file still has
    label length(const std::size_t bytesEach)
    {
        const label n = number<label>();
        if (n < 0 || static_cast<std::size_t>(n) > left() / bytesEach)
        {
            damaged(
                "it says " + Foam::name(n)
                + " values but is too short for "
                  "them: was it truncated?"
            );
        }
        return n;
    }

    void raw(void* to, const std::size_t bytes)
    {
        if (bytes > left())
        {
            damaged("it ends too early");
        }
        std::memcpy(to, at_, bytes);
        at_ += bytes;
    }

    template<class T>
    void value(T& v)
    {
        using C = typename component<T>::type;
        constexpr int n = component<T>::n;

        C* c = reinterpret_cast<C*>(&v);
        if (n > 1)
        {
            need('(');
        }
        for (int i = 0; i < n; ++i)
        {
            c[i] = number<C>();
        }
        if (n > 1)
        {
            need(')');
        }
    }

    template<class T>
    void checkFinite(const T& v, const label i) const
    {
        using C = typename component<T>::type;
        const C* c = reinterpret_cast<const C*>(&v);
        for (int k = 0; k < component<T>::n; ++k)
        {
            if (!std::isfinite(static_cast<scalar>(c[k])))
            {
                file_.damaged(
                    "value " + Foam::name(i)
                        + " (counted from 0) is not a "
                          "finite number: the run had gone wrong before it "
                          "wrote",
                    nullptr
                );
            }
        }
    }

    void needEnd()
    {
        passSpace();
        if (left())
        {
            damaged("it goes on behind its last value");
        }
    }
};

} // namespace


Foam::lpf::inputFile::inputFile(const fileName& file) : name(file)
{
    IFstream is(file);
    token first;
    if (!is.good() || !is.read(first).good() || !first.isWord()
        || first.wordToken() != "FoamFile")
    {
        damaged("it has no FoamFile header", nullptr);
    }
    const dictionary header(is);
    headerLines = is.lineNumber();
    className = header.getOrDefault<word>("class", "");
    const word format(header.getOrDefault<word>("format", ""));
    if (className.empty() || (format != "ascii" && format != "binary"))
    {
        damaged("its header has no class or no known format", nullptr);
    }
    binary = format == "binary";

    const string arch(header.getOrDefault<string>("arch", ""));
    const unsigned labels = foamVersion::labelByteSize(arch);
    const unsigned scalars = foamVersion::scalarByteSize(arch);
    if (binary
        && ((labels && labels != sizeof(label))
            || (scalars && scalars != sizeof(scalar))
            || arch.find("MSB") != std::string::npos))
    {
        damaged(
            "it was written in binary with " + arch + " but this build has "
                + foamVersion::buildArch + ": write it in ascii there",
            nullptr
        );
    }
    using iterator = std::istreambuf_iterator<char>;
    data.assign(iterator(is.stdStream()), iterator());
}


void Foam::lpf::inputFile::damaged(const string& why, const char* at) const
{
    string where;
    label line = -1;
    if (at && binary)
    {
        where = " (byte " + std::to_string(at - data.data())
              + " behind the header)";
    }
    else if (at)
    {
        const auto lines = std::count(data.data(), at, '\n');
        line = headerLines + static_cast<label>(lines);
    }
    FatalIOError("", "", 0, name, line, -1)
        << "The file is damaged: " << why.c_str() << where.c_str() << nl
        << "Go on from an earlier time, or write the file anew"
        << exit(FatalIOError);
    std::exit(1); // not reached; exit() above is not declared noreturn
}


template<class T>
Foam::List<T> Foam::lpf::readList(const inputFile& file)
{
    textReader in(file);
    const bool raw = file.binary;
    const bool uniform = !raw && file.data.find('{') != std::string::npos;
    const label n =
        uniform ? in.number<label>() : in.length(raw ? sizeof(T) : 2);
    List<T> values(max(n, label(0)));
    if (uniform) // 1000{0.5}
    {
        T v;
        in.need('{');
        in.value(v);
        in.need('}');
        values = v;
    }
    else if (!raw || n || in.sees('('))
    {
        in.need('(');
        if (raw)
        {
            in.raw(values.data(), sizeof(T) * static_cast<std::size_t>(n));
        }
        for (label i = 0; i < n && !raw; ++i)
        {
            in.value(values[i]);
        }
        in.need(')');
    }
    forAll (values, i)
    {
        in.checkFinite(values[i], i);
    }
    in.needEnd();
    return values;
}


Foam::List<Foam::vector> Foam::lpf::readPositions(const inputFile& file)
{
    textReader in(file);
    const std::size_t width = sizeof(vector) + sizeof(label) + 2;
    List<vector> positions(in.length(file.binary ? width : 8));
    in.need('(');
    forAll (positions, i)
    {
        label celli = 0;
        if (file.binary)
        {
            in.need('(');
            in.raw(&positions[i], sizeof(vector));
            in.raw(&celli, sizeof(label));
            in.need(')');
        }
        else
        {
            in.value(positions[i]);
            celli = in.number<label>();
        }
        in.checkFinite(positions[i], i);
    }
    in.need(')');
    in.needEnd();
    return positions;
}


#define makeLists(T)                                                                     \
    template void Foam::lpf::                                                            \
        writeList(const fileName&, const word&, const UList<T>&, const IOstreamOption&); \
    template Foam::List<T> Foam::lpf::readList(const inputFile&);

makeLists(Foam::label) makeLists(Foam::scalar) makeLists(Foam::vector)
    makeLists(Foam::symmTensor)
