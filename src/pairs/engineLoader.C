// SPDX-License-Identifier: GPL-3.0-or-later
#include "engineLoader.H"

#include <dlfcn.h>

#include <stdexcept>

namespace lpfPairs
{
namespace
{

bool runsHere(const std::string& isa)
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
    return isa == "x86-64-v2" && __builtin_cpu_supports("sse4.2");
}

std::string best()
{
    for (const char* isa : {"x86-64-v4", "x86-64-v3", "x86-64-v2"})
    {
        if (runsHere(isa))
        {
            return isa;
        }
    }
    throw std::runtime_error(
        "This processor has none of the instruction sets x86-64-v2, v3, v4"
    );
}

} // namespace

const pairEngine& loadPairEngine(const std::string& instructionSet)
{
    const std::string isa = instructionSet == "auto" ? best() : instructionSet;
    if (!runsHere(isa))
    {
        throw std::runtime_error(
            "instructionSet " + isa
            + " is not supported by this processor; write auto"
        );
    }

    const std::string library = "libLpfPairs_" + isa + ".so";
    void* handle = dlopen(library.c_str(), RTLD_NOW | RTLD_LOCAL);
    if (!handle)
    {
        throw std::runtime_error(
            "cannot load " + library + ": " + dlerror()
            + ". Build it with ./Allwmake"
        );
    }
    const auto entry =
        reinterpret_cast<pairEngineEntry>(dlsym(handle, "lpfPairEngine"));
    return *entry();
}

} // namespace lpfPairs
