// SPDX-License-Identifier: GPL-3.0-or-later
// What the rest relies on: the sizes that Debian's OpenFOAM has been built
// with, and arithmetic that the compiler does not reorder.

#include <catch2/catch.hpp>

#include "foamVersion.H"
#include "label.H"
#include "scalar.H"

TEST_CASE("build: scalar and label have the sizes of the libraries")
{
    const std::string library = Foam::foamVersion::buildArch;

    REQUIRE(sizeof(Foam::scalar) == 8);
    REQUIRE(sizeof(Foam::scalar) == Foam::foamVersion::scalarByteSize(library));
    REQUIRE(sizeof(Foam::label) == Foam::foamVersion::labelByteSize(library));
}

TEST_CASE("build: sums keep their order and scale by powers of two exactly")
{
    // Known to the compiler as variables only, so that nothing is folded
    volatile double big = 1e16;
    volatile double one = 1;
    volatile double scale = 1024;

    const double sum = (big + one) - big;
    const double scaled = (big * scale + one * scale) - big * scale;

    // 1e16 + 1 is a tie and rounds to even: an associative compiler says 1
    REQUIRE(sum == 0);
    REQUIRE(scaled == scale * sum);
}
