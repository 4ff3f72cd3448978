// SPDX-License-Identifier: GPL-3.0-or-later
#include "axisTicks.H"

#include <cmath>
#include <cstdio>

namespace Foam
{
namespace lpf
{

scalar roundBelow(const scalar value)
{
    const scalar power = std::pow(10.0, std::floor(std::log10(value)));
    const scalar lead = value / power;
    // 1e-9: what a quotient of two round numbers may lose
    for (const scalar step : {5.0, 2.0})
    {
        if (lead >= step * (1 - 1e-9))
        {
            return step * power;
        }
    }
    return power;
}


scalar roundStep(const scalar range, const label n)
{
    const scalar wanted = range / scalar(n);
    const scalar below = roundBelow(wanted);
    for (const scalar factor : {1.0, 2.0, 2.5, 5.0})
    {
        // 5 x 2.5 and 2 x 5 are not round; the next one is
        const scalar step = factor * below;
        if (step >= wanted * (1 - 1e-9)
            && std::abs(step / roundBelow(step) - 1) < 1e-6)
        {
            return step;
        }
    }
    return 10 * below;
}


scalarField ticks(const scalar lower, const scalar upper, const scalar step)
{
    const label first = label(std::ceil(lower / step - 1e-6));
    const label last = label(std::floor(upper / step + 1e-6));
    scalarField result(max(label(0), last - first + 1));
    forAll (result, k)
    {
        result[k] = step * scalar(first + k);
    }
    return result;
}


string tickLabel(const scalar value, const scalar step)
{
    const int power = int(std::floor(std::log10(step) + 1e-6));
    const bool isPlain = power > -5 && std::abs(value) < 1e8;
    char text[40];
    std::snprintf(
        text,
        sizeof(text),
        isPlain ? "%.*f" : "%.*g",
        isPlain ? std::max(0, -power) : 4,
        value
    );
    return text;
}


string threeDigits(const scalar value)
{
    char text[40];
    const scalar size = std::abs(value);
    if (size >= 1000 && size < 1e6)
    {
        const int power = int(std::floor(std::log10(size))) - 2;
        const scalar unit = std::pow(10.0, power);
        std::snprintf(
            text, sizeof(text), "%.0f", unit * std::round(value / unit)
        );
    }
    else
    {
        std::snprintf(text, sizeof(text), "%.3g", value);
    }
    return text;
}

} // namespace lpf
} // namespace Foam
