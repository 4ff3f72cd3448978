// SPDX-License-Identifier: GPL-3.0-or-later
#include "planGrid.H"

#include <cmath>
#include <cstdio>

Foam::string Foam::lpf::planText(const point& x)
{
    char text[80];
    std::snprintf(text, sizeof(text), "(%.10g %.10g)", x.x(), x.y());
    return text;
}


Foam::scalar Foam::lpf::interpolate(
    const planGrid& grid,
    const scalarField& field,
    const scalar x,
    const scalar y
)
{
    const auto value = [&](const label i, const label j)
    {
        const bool inside = i >= 0 && i < grid.nx && j >= 0 && j < grid.ny;
        return inside ? field[grid.index(i, j)] : scalar(0);
    };

    // Position in units of cells between centres; along the flat axis there
    // is one row of cells that stands for every position
    const scalar p = grid.flat == 0 ? 0 : (x - grid.x0) / grid.dx - 0.5;
    const scalar q = grid.flat == 1 ? 0 : (y - grid.y0) / grid.dy - 0.5;
    if (!(p > -2 && p < grid.nx + 1 && q > -2 && q < grid.ny + 1))
    {
        return 0;
    }
    const label i = label(std::floor(p));
    const label j = label(std::floor(q));
    const scalar a = p - scalar(i);
    const scalar b = q - scalar(j);

    return (1 - b) * ((1 - a) * value(i, j) + a * value(i + 1, j))
         + b * ((1 - a) * value(i, j + 1) + a * value(i + 1, j + 1));
}
