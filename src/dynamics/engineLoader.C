// SPDX-License-Identifier: GPL-3.0-or-later
#include "engineLoader.H"

#include "error.H"
#include "wordList.H"

#include <dlfcn.h>

namespace Foam
{
namespace lpf
{

namespace
{

bool runsHere(const word& isa)
{
    if (isa == "x86-64-v4")
    {
        return __builtin_cpu_supports("avx512f")
            && __builtin_cpu_supports("avx512bw")
            && __builtin_cpu_supports("avx512cd")
            && __builtin_cpu_supports("avx512dq")
            && __builtin_cpu_supports("avx512vl");
    }
    if (isa == "x86-64-v3")
    {
        return __builtin_cpu_supports("avx2") && __builtin_cpu_supports("fma")
            && __builtin_cpu_supports("bmi2");
    }
    return __builtin_cpu_supports("sse4.2");
}

word best(const wordList& all)
{
    for (const word& isa : all)
    {
        if (runsHere(isa))
        {
            return isa;
        }
    }
    FatalErrorInFunction << "This processor has none of the instruction sets "
                         << all << exit(FatalError);
    return word();
}

} // namespace

const lpfPairs::pairEngine& loadPairEngine(const word& instructionSet)
{
    const wordList all({"x86-64-v4", "x86-64-v3", "x86-64-v2"});
    const word isa = instructionSet == "auto" ? best(all) : instructionSet;

    if (!runsHere(isa))
    {
        FatalErrorInFunction << "instructionSet " << isa
                             << " is not supported by this "
                             << "processor; write auto" << exit(FatalError);
    }

    const std::string library = "libLpfPairs_" + isa + ".so";
    void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle)
    {
        FatalErrorInFunction << "cannot load " << library << ": " << dlerror()
                             << ". Build it with ./Allwmake"
                             << exit(FatalError);
    }
    const auto entry = reinterpret_cast<lpfPairs::pairEngineEntry>(
        dlsym(handle, "lpfPairEngine")
    );
    return *entry();
}

} // namespace lpf
} // namespace Foam
