// SPDX-License-Identifier: GPL-3.0-or-later

#include "uniformTime.H"
#include "foamFile.H"
#include "inputCheck.H"
#include "IOobject.H"
#include "OSspecific.H"

#include <charconv>

namespace
{

//- The shortest text that reads back to the same bits
Foam::string exact(const Foam::scalar x)
{
    char digits[40];
    return Foam::string(
        std::string(digits, std::to_chars(digits, digits + 40, x).ptr)
    );
}

} // namespace


void Foam::lpf::writeUniformTime(
    const fileName& timeDir, const uniformTime& time
)
{
    mkDir(timeDir / "uniform");
    const fileName file(timeDir / "uniform" / "time");
    outputFile out(file, IOstreamOption());
    Ostream& os = out.stream();
    writeFoamHeader(os, "dictionary", file);
    os << "value           " << exact(time.value).c_str() << ";\n\n"
       << "name            \"" << time.name << "\";\n\n"
       << "index           " << time.index << ";\n\n"
       << "deltaT          " << exact(time.deltaT).c_str() << ";\n\n"
       << "deltaT0         " << exact(time.deltaT0).c_str() << ";\n";
    IOobject::writeEndDivider(os);
    out.close();
}


Foam::lpf::uniformTime Foam::lpf::readUniformTime(const fileName& timeDir)
{
    const fileName file(timeDir / "uniform" / "time");
    uniformTime time{0, timeDir.name(), 0, 0, 0};
    if (!isFile(file))
    {
        if (!readScalar(timeDir.name(), time.value))
        {
            FatalIOError("", "", 0, timeDir, -1, -1)
                << "The name of the folder is not a time and it has no "
                << "uniform/time" << exit(FatalIOError);
        }
        return time;
    }
    const dictionary dict = readDictionary(file);
    time.value = readNumber(dict, "value", dimless, bounds());
    time.name = word(dict.getOrDefault<string>("name", timeDir.name()));
    time.index = static_cast<label>(
        readNumber(dict, "index", dimless, bounds{0, labelMax})
    );
    time.deltaT = readNumber(dict, "deltaT", dimless, bounds{0});
    time.deltaT0 = readNumber(dict, "deltaT0", dimless, bounds{0});
    return time;
}
