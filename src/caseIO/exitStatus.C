// SPDX-License-Identifier: GPL-3.0-or-later
#include "exitStatus.H"
#include "IOstreams.H"

#include <cstdlib>

namespace
{

template<class Error>
[[noreturn]] void printAndExit(const Error& e)
{
    Foam::Perr << Foam::nl << e << Foam::nl << "\nFOAM exiting\n" << Foam::endl;
    // not by a return: the destructor of argList ends with status 0
    std::exit(1);
}

} // namespace


int Foam::lpf::exitStatus(const std::function<int()>& task)
{
    FatalError.throwExceptions();
    FatalIOError.throwExceptions();
    try
    {
        return task();
    }
    catch (const IOerror& e)
    {
        printAndExit(e);
    }
    catch (const error& e)
    {
        printAndExit(e);
    }
}
