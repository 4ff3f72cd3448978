// SPDX-License-Identifier: GPL-3.0-or-later
// The sum that closes a mass balance: no rounding, whatever the order.

#include <catch2/catch.hpp>

#include "exactSum.H"

#include <algorithm>
#include <limits>
#include <random>
#include <vector>

using lpfPairs::exactSum;

namespace
{

exactSum sumOf(const std::vector<double>& terms)
{
    exactSum total;
    for (const double t : terms)
    {
        REQUIRE(total.add(t));
    }
    return total;
}


//- Magnitudes from 2^-100 to 2^100, both signs
std::vector<double> wildTerms(const std::size_t n)
{
    std::mt19937_64 bits(7);
    std::uniform_real_distribution<double> mantissa(-1, 1);
    std::uniform_int_distribution<int> exponent(-100, 100);
    std::vector<double> terms(n);
    for (double& t : terms)
    {
        t = std::ldexp(mantissa(bits), exponent(bits));
    }
    return terms;
}

} // namespace


TEST_CASE("exactSum: the same bits in any order")
{
    std::vector<double> terms = wildTerms(3000);
    const exactSum first = sumOf(terms);
    std::mt19937_64 bits(8);
    for (int k = 0; k < 5; ++k)
    {
        std::shuffle(terms.begin(), terms.end(), bits);
        CHECK(sumOf(terms) == first);
    }
    // in two halves, as two threads would
    const auto half = terms.begin() + 1234;
    exactSum both = sumOf({terms.begin(), half});
    both += sumOf({half, terms.end()});
    CHECK(both == first);
}


TEST_CASE("exactSum: what a sum of doubles loses is there")
{
    CHECK(sumOf({1e16, 1, -1e16}).value() == 1);
    CHECK(
        sumOf({1, std::ldexp(1.0, -190), -1}).value() == std::ldexp(1.0, -190)
    );
    CHECK(sumOf({std::ldexp(1.0, 190), 3, -std::ldexp(1.0, 190)}).value() == 3);
    CHECK(sumOf({0.1, 0.2, -0.3}).value() == std::ldexp(1.0, -55));
    CHECK(sumOf({0.1, 0.2, 0.3}).value() == Approx(0.6).epsilon(1e-15));
}


TEST_CASE("exactSum: negative sums")
{
    CHECK(sumOf({-2.5}).value() == -2.5);
    CHECK(sumOf({1, -3}).value() == -2);
    CHECK(sumOf({-std::ldexp(1.0, -190)}).value() == -std::ldexp(1.0, -190));
    std::vector<double> terms = wildTerms(500);
    const double value = sumOf(terms).value();
    for (double& t : terms)
    {
        t = -t;
    }
    CHECK(sumOf(terms).value() == -value);
}


TEST_CASE("exactSum: closes when all that came has left")
{
    std::vector<double> masses = wildTerms(2000);
    for (double& m : masses)
    {
        m = std::abs(m);
    }
    const exactSum initial = sumOf(masses);
    std::mt19937_64 bits(9);
    std::shuffle(masses.begin(), masses.end(), bits);

    // the ledger: present + left = initial, at any moment
    exactSum left;
    for (std::size_t gone : {1, 700, 1999, 2000})
    {
        left =
            sumOf({masses.begin(), masses.begin() + static_cast<long>(gone)});
        exactSum accounted =
            sumOf({masses.begin() + static_cast<long>(gone), masses.end()});
        accounted += left;
        CHECK(accounted == initial);
    }
    CHECK(left == initial);

    exactSum rest = initial;
    for (const double m : masses)
    {
        rest.add(-m);
    }
    CHECK(rest == exactSum());
    CHECK(rest.value() == 0);

    // one grain less, however light, is seen
    const auto lightest = std::min_element(masses.begin(), masses.end());
    exactSum without = initial;
    without.add(-*lightest);
    CHECK_FALSE(without == initial);
}


TEST_CASE("exactSum: value is the sum to the last digit but one")
{
    // as far as 128 bits of mantissa reach
    std::mt19937_64 bits(10);
    std::uniform_real_distribution<double> uniform(-1, 1);
    for (int k = 0; k < 100; ++k)
    {
        exactSum total;
        long double reference = 0;
        for (int i = 0; i < 50; ++i)
        {
            // 40 bits: exact in a long double
            const double t = std::ldexp(std::round(1e12 * uniform(bits)), -40);
            total.add(t);
            reference += static_cast<long double>(t);
        }
        CHECK(
            total.value()
            == Approx(static_cast<double>(reference)).epsilon(3e-16)
        );
    }
}


TEST_CASE("exactSum: text keeps every bit")
{
    for (const double sign : {1.0, -1.0})
    {
        exactSum total = sumOf(wildTerms(100));
        total.add(sign * std::ldexp(1.0, 150));
        exactSum back;
        back.fromText(total.text());
        CHECK(back == total);
    }
}


TEST_CASE("exactSum: what it cannot hold is refused and not added")
{
    exactSum total;
    total.add(1);
    const exactSum before = total;
    CHECK_FALSE(total.add(std::numeric_limits<double>::quiet_NaN()));
    CHECK_FALSE(total.add(std::numeric_limits<double>::infinity()));
    CHECK_FALSE(total.add(-std::numeric_limits<double>::infinity()));
    CHECK_FALSE(total.add(std::ldexp(1.0, 260)));
    CHECK_FALSE(total.add(std::ldexp(1.0, -260)));
    CHECK(total == before);
    CHECK(total.add(0));
    CHECK(total == before);
}
