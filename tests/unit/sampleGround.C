// SPDX-License-Identifier: GPL-3.0-or-later

#include "sampleGround.H"

#include "StringStream.H"

Foam::dictionary Foam::lpf::dictOf(const std::string& text)
{
    return dictionary(IStringStream(text)());
}


Foam::autoPtr<Foam::lpf::ground> Foam::lpf::groundOf(const List<corners>& all)
{
    PtrList<groundPart> parts;
    parts.append(
        autoPtr<groundPart>(new triangles(all, labelList(all.size(), label(0))))
    );
    return autoPtr<ground>::New(
        std::move(parts), wordList({"floor"}), Zero, ""
    );
}


Foam::autoPtr<Foam::lpf::ground> Foam::lpf::groundFarAway()
{
    return groundOf(List<corners>(
        1, corners{point(500, 0, 0), point(501, 0, 0), point(501, 1, 0)}
    ));
}
