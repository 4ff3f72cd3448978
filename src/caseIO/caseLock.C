// SPDX-License-Identifier: GPL-3.0-or-later
#include "caseLock.H"

#include "error.H"
#include "messageStream.H"

#include <cerrno>
#include <cstring>
#include <fcntl.h>
#include <sys/file.h>
#include <unistd.h>

namespace Foam
{
namespace lpf
{

caseLock::caseLock(const fileName& caseDir)
    : folder_(::open(caseDir.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC))
{
    if (folder_ < 0)
    {
        return; // what reads the case says that it cannot
    }
    if (::flock(folder_, LOCK_EX | LOCK_NB) == 0)
    {
        return;
    }
    if (errno == EWOULDBLOCK)
    {
        FatalErrorInFunction
            << "Another lpfSolver or terrainToParticles runs in " << caseDir
            << ": both would write the same times. Wait for it, stop it, or"
            << " copy the case" << exit(FatalError);
    }
    WarningInFunction << "The file system of " << caseDir << " has no locks ("
                      << std::strerror(errno) << "): do not start a second"
                      << " program in this case" << endl;
}

caseLock::~caseLock()
{
    if (folder_ >= 0)
    {
        ::close(folder_);
    }
}

} // namespace lpf
} // namespace Foam
