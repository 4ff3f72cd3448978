// SPDX-License-Identifier: GPL-3.0-or-later
// Files of clouds: nothing is lost, nothing damaged is taken for good, a time
// folder is there whole or not at all.

#include <catch2/catch.hpp>

#include "foamFile.H"
#include "sampleCase.H"
#include "surfaceDecimation.H"
#include "uniformTime.H"

#include <cmath>
#include <cstring>
#include <fstream>
#include <iterator>
#include <limits>
#include <sstream>
#include <sys/wait.h>
#include <unistd.h>

using namespace Foam;
using namespace Foam::lpf;

namespace
{

const IOstreamOption binary(IOstreamOption::BINARY);
const IOstreamOption ascii(IOstreamOption::ASCII);

using limits = std::numeric_limits<scalar>;


//- Numbers that a careless writer changes
scalarField awkward()
{
    scalarField x(9);
    x[0] = -0.0;
    x[1] = limits::denorm_min();
    x[2] = -limits::denorm_min() * 12345;
    x[3] = limits::min();
    x[4] = limits::max();
    x[5] = limits::lowest();
    x[6] = 1 + limits::epsilon();
    x[7] = 1.0 / 3;
    x[8] = 3e6 + 1.0 / 3;
    return x;
}


template<class T>
bool sameBits(const UList<T>& a, const UList<T>& b)
{
    return a.size() == b.size()
        && !std::memcmp(
               a.cdata(), b.cdata(), sizeof(T) * std::size_t(a.size())
        );
}


cloudState awkwardCloud()
{
    const scalarField x(awkward());
    cloudState s;
    labelField id(x.size());
    vectorField U(x.size());
    symmTensorField sigma(x.size());
    s.positions.setSize(x.size());
    forAll (x, i)
    {
        const scalar y = x[x.size() - 1 - i];
        id[i] = i % 2 ? labelMin + i : labelMax - i;
        s.positions[i] = vector(x[i], y, -x[i]);
        U[i] = vector(y, x[i], y);
        sigma[i] = symmTensor(x[i], y, x[i], -y, y, x[i]);
    }
    s.labels.insert("id", id);
    s.scalars.insert("mass", x);
    s.vectors.insert("U", U);
    s.symmTensors.insert("sigma", sigma);
    return s;
}


std::string contents(const fileName& file)
{
    std::ifstream is(file, std::ios::binary);
    return std::string(std::istreambuf_iterator<char>(is), {});
}


void putContents(const fileName& file, const std::string& text)
{
    std::ofstream(file, std::ios::binary) << text;
}


//- The error of reading the sample cloud after `damage` to one of its files
template<class F>
std::string
afterDamage(const IOstreamOption& format, const word& file, const F& damage)
{
    const temporaryFolder folder;
    writeCloud(folder.path(), "grains", sampleCloud(10), format);
    const fileName path = folder.path() / "lagrangian" / "grains" / file;
    std::string text = contents(path);
    damage(text);
    putContents(path, text);
    std::string message = errorOf([&] { readCloud(folder.path(), "grains"); });
    INFO(message);
    CHECK((message.empty() || message.find(path) != std::string::npos));
    return message;
}


bool says(const std::string& message, const std::string& what)
{
    INFO(message);
    return message.find(what) != std::string::npos;
}

} // namespace


TEST_CASE("cloudState: a binary write keeps every bit and the order")
{
    const temporaryFolder folder;
    const cloudState s = awkwardCloud();
    writeCloud(folder.path(), "grains", s, binary);
    const cloudState r = readCloud(folder.path(), "grains");

    CHECK(sameBits<vector>(s.positions, r.positions));
    CHECK(sameBits<label>(s.labels["id"], r.labels["id"]));
    CHECK(sameBits<scalar>(s.scalars["mass"], r.scalars["mass"]));
    CHECK(sameBits<vector>(s.vectors["U"], r.vectors["U"]));
    CHECK(sameBits<symmTensor>(s.symmTensors["sigma"], r.symmTensors["sigma"]));
}


TEST_CASE("cloudState: ascii of 17 digits keeps every bit, compressed too")
{
    const unsigned before = IOstream::defaultPrecision(17);
    const auto compression =
        GENERATE(IOstreamOption::UNCOMPRESSED, IOstreamOption::COMPRESSED);
    const temporaryFolder folder;
    const cloudState s = awkwardCloud();
    writeCloud(
        folder.path(),
        "grains",
        s,
        IOstreamOption(IOstreamOption::ASCII, compression)
    );
    IOstream::defaultPrecision(before);
    const cloudState r = readCloud(folder.path(), "grains");

    CHECK(sameBits<vector>(s.positions, r.positions));
    CHECK(sameBits<scalar>(s.scalars["mass"], r.scalars["mass"]));
    CHECK(sameBits<symmTensor>(s.symmTensors["sigma"], r.symmTensors["sigma"]));
    CHECK(cloudNames(folder.path()) == wordList{"grains"});
}


TEST_CASE("cloudState: ascii rounds to writePrecision as OpenFOAM does")
{
    const unsigned before = IOstream::defaultPrecision(6);
    const temporaryFolder folder;
    writeList<scalar>(folder.path() / "x", "scalarField", awkward(), ascii);
    IOstream::defaultPrecision(before);
    std::ostringstream expected;
    expected.precision(6);
    for (const scalar x : awkward())
    {
        expected << x << '\n';
    }
    const std::string text = contents(folder.path() / "x");
    CHECK(says(text, "\n9\n(\n" + expected.str() + ")"));
}


TEST_CASE("cloudState: an empty cloud is a cloud")
{
    const auto format = GENERATE(IOstreamOption::ASCII, IOstreamOption::BINARY);
    const temporaryFolder folder;
    writeCloud(folder.path(), "grains", sampleCloud(0), IOstreamOption(format));
    const cloudState r = readCloud(folder.path(), "grains");
    CHECK(r.size() == 0);
    CHECK(r.vectors.found("U"));
}


TEST_CASE("cloudState: fields written by hand are read")
{
    const temporaryFolder folder;
    writeCloud(folder.path(), "grains", sampleCloud(3), ascii);
    const std::string header(
        "FoamFile { version 2.0; format ascii; class scalarField; "
        "object mass; }\n"
    );
    const fileName dir = folder.path() / "lagrangian" / "grains";
    putContents(dir / "mass", header + "3{0.5}\n");
    putContents(dir / "h", header + "// spacing\n3(1 2.5 +1e-3)");
    // OpenFOAM takes no sign + either
    CHECK(says(
        errorOf([&] { readCloud(folder.path(), "grains"); }),
        "a number is expected here\nGo on from an earlier time, or write the "
        "file anew|"
            + dir + "/h:3"
    ));
    putContents(dir / "h", header + "// spacing\n3(1 2.5 1e-3)");
    const cloudState r = readCloud(folder.path(), "grains");
    CHECK(r.scalars["mass"] == scalarField(3, 0.5));
    CHECK(r.scalars["h"][2] == 1e-3);
}


TEST_CASE("cloudState: a truncated file is damaged wherever it ends")
{
    const auto format = GENERATE(IOstreamOption::ASCII, IOstreamOption::BINARY);
    const auto file = GENERATE(as<std::string>(), "positions", "U", "id");
    const auto share = GENERATE(0.0, 0.1, 0.3, 0.6, 0.8, 0.9);
    const std::string message = afterDamage(
        IOstreamOption(format),
        word(file),
        [&](std::string& text)
        {
            // without the end of line comments, that may go
            text.resize(text.rfind(')') + 1);
            text.resize(std::size_t(share * scalar(text.size())));
        }
    );
    CHECK_FALSE(message.empty());
}


TEST_CASE("cloudState: damage is named with the file")
{
    CHECK(says(
        afterDamage(
            binary,
            "mass",
            [](std::string& text)
            { text.replace(text.find("\n10\n"), 4, "\n9\n"); }
        ),
        "')' expected"
    ));
    CHECK(says(
        afterDamage(
            ascii,
            "mass",
            [](std::string& text)
            { text.replace(text.find("\n10\n"), 4, "\n999999999\n"); }
        ),
        "was it truncated?"
    ));
    CHECK(says(
        afterDamage(
            ascii,
            "mass",
            [](std::string& text) { text.insert(text.rfind("\n)"), "\nnan"); }
        ),
        "')' expected"
    ));
    CHECK(says(
        afterDamage(
            ascii,
            "mass",
            [](std::string& text)
            {
                const auto at = text.find("(\n") + 2;
                text.replace(at, text.find('\n', at) - at, "nan");
            }
        ),
        "value 0 (counted from 0) is not a finite number"
    ));
    CHECK(says(
        afterDamage(
            binary,
            "U",
            [](std::string& text)
            {
                const scalar nan = limits::quiet_NaN();
                std::memcpy(
                    &text[text.find("\n10\n(") + 5 + 3 * 24], &nan, sizeof(nan)
                );
            }
        ),
        "value 3 (counted from 0) is not a finite number"
    ));
    CHECK(says(
        afterDamage(binary, "U", [](std::string& text) { text = "hello"; }),
        "no FoamFile header"
    ));
    CHECK(says(
        afterDamage(
            binary,
            "id",
            [](std::string& text)
            { text.replace(text.find("label=32"), 8, "label=64"); }
        ),
        "but this build has"
    ));
}


TEST_CASE("cloudState: fields of another length are refused")
{
    const temporaryFolder folder;
    writeCloud(folder.path(), "grains", sampleCloud(5), binary);
    const fileName file = folder.path() / "lagrangian" / "grains" / "mass";
    writeList<scalar>(file, "scalarField", scalarField(4, 1.0), binary);
    CHECK(says(
        errorOf([&] { readCloud(folder.path(), "grains"); }),
        "it has 4 values but positions beside it has 5"
    ));
    CHECK(says(
        errorOf([&] { readCloud(folder.path(), "water"); }),
        "There is no cloud 'water'"
    ));
}


TEST_CASE("timeFolder: nothing to see before commit, all after it")
{
    const temporaryFolder folder;
    const fileName final(folder.path() / "0.5");
    {
        timeFolder time(folder.path(), "0.5");
        writeCloud(time.path(), "grains", sampleCloud(5), binary);
        CHECK_FALSE(isDir(final));
    }
    CHECK(readDir(folder.path(), fileName::DIRECTORY).empty());
    {
        timeFolder time(folder.path(), "0.5");
        writeCloud(time.path(), "grains", sampleCloud(5), binary);
        time.commit();
    }
    CHECK(readDir(folder.path(), fileName::DIRECTORY).size() == 1);
    CHECK(readCloud(final, "grains").size() == 5);
    // the header names the folder that the file ends up in
    CHECK(says(
        contents(final / "lagrangian" / "grains" / "U"),
        "location    \"0.5/lagrangian/grains\""
    ));
}


TEST_CASE("timeFolder: an older folder is replaced whole, or stays whole")
{
    const temporaryFolder folder;
    const fileName final(folder.path() / "2");
    const auto write = [&](const label n, const bool commit)
    {
        timeFolder time(folder.path(), "2");
        writeCloud(time.path(), "grains", sampleCloud(n), binary);
        if (commit)
        {
            time.commit();
        }
    };
    write(5, true);
    putContents(final / "note", "of the older folder");
    write(6, false);
    CHECK(readCloud(final, "grains").size() == 5);
    write(7, true);
    CHECK(readCloud(final, "grains").size() == 7);
    CHECK_FALSE(isFile(final / "note"));
    CHECK(readDir(folder.path(), fileName::DIRECTORY).size() == 1);
}


TEST_CASE("timeFolder: a process killed while it writes leaves the old state")
{
    const temporaryFolder folder;
    {
        timeFolder time(folder.path(), "1");
        writeCloud(time.path(), "grains", sampleCloud(5), binary);
        time.commit();
    }
    const pid_t child = ::fork();
    if (!child)
    {
        timeFolder time(folder.path(), "1");
        writeCloud(time.path(), "grains", sampleCloud(6), binary);
        ::_exit(0); // no destructor runs
    }
    ::waitpid(child, nullptr, 0);
    CHECK(readCloud(folder.path() / "1", "grains").size() == 5);
    {
        timeFolder time(folder.path(), "1");
        CHECK_FALSE(isDir(time.path() / "lagrangian"));
        writeCloud(time.path(), "grains", sampleCloud(7), binary);
        time.commit();
    }
    CHECK(readCloud(folder.path() / "1", "grains").size() == 7);
    CHECK(readDir(folder.path(), fileName::DIRECTORY).size() == 1);
}


TEST_CASE("uniformTime: read back with the same bits")
{
    const temporaryFolder folder;
    const fileName dir(folder.path() / "0.333333");
    const uniformTime t{1.0 / 3, "0.333333", 1234567, 1e-5 / 3, 1e-5 / 7};
    mkDir(dir);
    writeUniformTime(dir, t);
    const uniformTime r = readUniformTime(dir);
    CHECK(r.value == t.value);
    CHECK(r.name == t.name);
    CHECK(r.index == t.index);
    CHECK(r.deltaT == t.deltaT);
    CHECK(r.deltaT0 == t.deltaT0);
    CHECK(readUniformTime(folder.path() / "2.5").value == 2.5);
}


TEST_CASE("surfaceDecimation: fewer triangles of the same surface")
{
    // a wave on a plane: area and height range are known
    const label n = 60;
    pointField points((n + 1) * (n + 1));
    faceList triangles(2 * n * n);
    forAll (points, i)
    {
        const label row = i / (n + 1);
        const scalar x = scalar(i - row * (n + 1)) / n;
        points[i] = point(x, scalar(row) / n, 0.1 * std::sin(6 * x));
    }
    label k = 0;
    for (label j = 0; j < n; ++j)
    {
        for (label i = 0; i < n; ++i)
        {
            const label a = j * (n + 1) + i;
            triangles[k++] = face{a, a + 1, a + n + 2};
            triangles[k++] = face{a, a + n + 2, a + n + 1};
        }
    }
    const pointField before(points);
    decimate(points, triangles, 1000);

    CHECK(triangles.size() <= 1000);
    CHECK(triangles.size() > 500);
    scalar planArea = 0;
    for (const face& f : triangles)
    {
        const vector normal = f.areaNormal(points);
        CHECK(normal.z() > 0);
        planArea += normal.z();
    }
    // a rim of up to a grid cell may be lost
    CHECK(planArea == Approx(1).margin(0.15));
    for (const point& p : points)
    {
        CHECK(std::abs(p.z() - 0.1 * std::sin(6 * p.x())) < 1e-15);
    }
}
