// SPDX-License-Identifier: GPL-3.0-or-later
#include "lattice.H"
#include "inputCheck.H"

#include <cmath>

namespace Foam
{
namespace lpf
{

namespace
{

// Axes typed with four digits are accepted and then made exact
constexpr scalar axisTolerance = 1e-3;

tensor orthonormal(const List<vector>& axes, const dictionary& dict)
{
    const char* reason =
        "The axes of a cubic lattice are three unit vectors at right angles,"
        " e.g. ((1 0 0) (0 1 0) (0 0 1)).";
    if (axes.size() != 3)
    {
        refuse(dict, "axes", reason);
    }
    for (label k = 0; k < 3; ++k)
    {
        if (mag(mag(axes[k]) - 1) > axisTolerance
            || mag(axes[k] & axes[(k + 1) % 3]) > axisTolerance)
        {
            refuse(dict, "axes", reason);
        }
    }
    // e3 is what the stress and the layers refer to: it is kept
    const vector e3 = axes[2] / mag(axes[2]);
    const vector a = axes[0] - (axes[0] & e3) * e3;
    const vector e1 = a / mag(a);
    const vector across = e3 ^ e1;
    const vector e2 = (across & axes[1]) < 0 ? -across : across;
    return tensor(e1, e2, e3);
}

} // namespace


FixedList<label, 2>
lattice::range(const direction axis, const scalar from, const scalar to) const
{
    if (axis == acrossAxis)
    {
        return {0, 0};
    }
    return {
        label(std::floor(from / spacing - 0.5)) - 1,
        label(std::ceil(to / spacing - 0.5)) + 1};
}


void readLattice(
    const dictionary& dict, const point& localOrigin, lattice& grid
)
{
    const dictionary* own = optionalDictionary(dict, "lattice");
    if (!own)
    {
        return;
    }
    allowOnly(*own, {"axes", "origin"});
    if (own->found("axes"))
    {
        const auto axes = own->get<List<vector>>("axes");
        const tensor exact = orthonormal(axes, *own);
        const tensor given(axes[0], axes[1], axes[2]);
        // what is exact as it is typed stays so
        grid.axes = mag((given & given.T()) - tensor::I) > 0 ? exact : given;
    }
    if (own->found("origin"))
    {
        grid.origin = readVector(*own, "origin", dimLength) - localOrigin;
    }
}


void makePlaneStrain(
    const vector& normal,
    const scalar thickness,
    const dictionary& context,
    lattice& grid
)
{
    for (direction k = 0; k < 2; ++k)
    {
        if (mag(grid.e(k) & normal) > 1 - 1e-9)
        {
            grid.acrossAxis = k;
            grid.thickness = thickness;
            return;
        }
    }
    refuse(
        context,
        "normal",
        "The normal of plane strain must be e1 or e2 of the particle lattice:"
        " the layer is one lattice plane. Set lattice { axes .. } of"
        " terrainToParticlesDict, or the normal, accordingly."
    );
}

} // namespace lpf
} // namespace Foam
