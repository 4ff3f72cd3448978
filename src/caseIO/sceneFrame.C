// SPDX-License-Identifier: GPL-3.0-or-later
#include "sceneFrame.H"

#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

namespace
{

const char* const again = ". Run terrainToParticles again, or take the change "
                          "back";

//- The same number, as it is written with 17 digits and read back
bool same(const scalar a, const scalar b)
{
    return mag(a - b) <= 1e-9 * max(mag(a), mag(b));
}

string shown(const cyclicPair& pair)
{
    return pair.name() + " (" + Foam::name(pair.from) + " "
         + Foam::name(pair.to) + ")";
}

string shown(const vector& v)
{
    return "(" + Foam::name(v.x()) + " " + Foam::name(v.y()) + " "
         + Foam::name(v.z()) + ")";
}

void checkPlane(
    const dictionary& boundary, const sceneFrame& now, const sceneFrame& laid
)
{
    if (now.isPlane() == laid.isPlane()
        && (!now.isPlane()
            || (mag(now.planeNormal - laid.planeNormal) < 1e-9
                && same(now.planeThickness, laid.planeThickness))))
    {
        return;
    }
    const auto words = [](const sceneFrame& frame)
    {
        return frame.isPlane() ? "plane strain, normal "
                                     + shown(frame.planeNormal) + ", thickness "
                                     + Foam::name(frame.planeThickness) + " m"
                               : std::string("three dimensions");
    };
    refuse(
        boundary,
        "planeStrain",
        "planeStrain: this says " + words(now)
            + ", but the particles are laid for " + words(laid) + again
    );
}

void checkCyclic(
    const dictionary& boundary, const sceneFrame& now, const sceneFrame& laid
)
{
    const auto pairOf = [](const sceneFrame& frame, const direction axis)
    {
        for (const cyclicPair& pair : frame.cyclic)
        {
            if (pair.axis == axis)
            {
                return pair;
            }
        }
        return cyclicPair{axis, 0, 0};
    };
    for (direction axis = 0; axis < 2; ++axis)
    {
        const cyclicPair here = pairOf(now, axis), there = pairOf(laid, axis);
        if (same(here.from, there.from) && same(here.to, there.to))
        {
            continue;
        }
        const auto words = [](const cyclicPair& pair)
        {
            return pair.to > pair.from ? "the pair " + shown(pair)
                                       : "no pair " + pair.name();
        };
        const dictionary* cyclic = optionalDictionary(boundary, "cyclic");
        refuse(
            cyclic ? *cyclic : boundary,
            cyclic ? here.name() : word("cyclic"),
            "cyclic: this says " + words(here)
                + ", but the particles are laid with " + words(there) + again
        );
    }
}

} // namespace


sceneFrame readSceneFrame(const dictionary& boundary)
{
    sceneFrame frame;
    if (const dictionary* plane = optionalDictionary(boundary, "planeStrain"))
    {
        allowOnly(*plane, {"normal", "thickness"});
        frame.planeNormal = readVector(*plane, "normal", dimless);
        if (!(mag(frame.planeNormal) > 0))
        {
            refuse(
                *plane,
                "normal",
                "The normal of plane strain has no direction; write normal "
                "(0 1 0);"
            );
        }
        frame.planeNormal /= mag(frame.planeNormal);
        bounds positive;
        positive.lower = 0;
        positive.lowerOpen = true;
        positive.reason =
            "masses and forces are those of a slice that thick, e.g. 1 m";
        frame.planeThickness =
            readNumber(*plane, "thickness", dimLength, positive);
    }
    const dictionary* pairs = optionalDictionary(boundary, "cyclic");
    if (!pairs)
    {
        return frame;
    }
    allowOnly(*pairs, {"x", "y"});
    for (const word& key : {word("x"), word("y")})
    {
        if (pairs->found(key))
        {
            const Pair<scalar> ends = readInterval(*pairs, key);
            frame.cyclic.append(cyclicPair{
                direction(key == "x" ? 0 : 1), ends.first(), ends.second()});
        }
    }
    return frame;
}


void checkSceneFrame(const dictionary& boundary, const dictionary& release)
{
    const sceneFrame now = readSceneFrame(boundary);
    sceneFrame laid;
    if (release.getOrDefault<label>("dimensions", 3) == 2)
    {
        laid.planeNormal = readVector(release, "planeNormal", dimless);
        laid.planeThickness =
            readNumber(release, "planeThickness", dimLength, bounds());
    }
    if (const dictionary* cyclic = optionalDictionary(release, "cyclic"))
    {
        for (const word& key : cyclic->toc())
        {
            const Pair<scalar> ends = readInterval(*cyclic, key);
            laid.cyclic.append(cyclicPair{
                direction(key == "x" ? 0 : 1), ends.first(), ends.second()});
        }
    }
    checkPlane(boundary, now, laid);
    checkCyclic(boundary, now, laid);
}

} // namespace lpf
} // namespace Foam
