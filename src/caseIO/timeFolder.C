// SPDX-License-Identifier: GPL-3.0-or-later

#include "cloudState.H"
#include "error.H"
#include "OSspecific.H"

#include <cerrno>
#include <cstdio>
#include <cstring>
#include <fcntl.h>
#include <unistd.h>

namespace
{

using namespace Foam;

const char hiddenPrefix[] = ".lpfWriting.";


//- Names are on disk only when their folder is: a file alone is not enough
void toDisk(const fileName& path)
{
    const int descriptor = ::open(path.c_str(), O_RDONLY | O_CLOEXEC);
    if (descriptor < 0)
    {
        return; // unreadable for us, but it was written
    }
    const bool good = ::fsync(descriptor) == 0 || errno == EINVAL;
    const int reason = errno;
    ::close(descriptor);
    if (!good)
    {
        FatalErrorInFunction << "Cannot bring " << path
                             << " to disk: " << std::strerror(reason)
                             << exit(FatalError);
    }
}


void treeToDisk(const fileName& dir)
{
    for (const fileName& file : readDir(dir, fileName::FILE, false))
    {
        toDisk(dir / file);
    }
    for (const fileName& sub : readDir(dir, fileName::DIRECTORY, false))
    {
        treeToDisk(dir / sub);
    }
    toDisk(dir);
}


//- Rename so that at no moment there is neither the old nor the new folder
void replace(const fileName& from, const fileName& to)
{
    int status = ::rename(from.c_str(), to.c_str());
    if (status && (errno == ENOTEMPTY || errno == EEXIST))
    {
        // afterwards the older folder has the hidden name
        status = ::renameat2(
            AT_FDCWD, from.c_str(), AT_FDCWD, to.c_str(), RENAME_EXCHANGE
        );
        if (status && (errno == EINVAL || errno == ENOSYS))
        {
            // file systems that cannot exchange, such as NFS
            const fileName old(to.path() / ".lpfReplaced." + to.name());
            rmDir(old, true);
            status = ::rename(to.c_str(), old.c_str())
                  || ::rename(from.c_str(), to.c_str());
            rmDir(old, true);
        }
        rmDir(from, true);
    }
    if (status)
    {
        FatalErrorInFunction << "Cannot rename " << from << " to " << to << ": "
                             << std::strerror(errno) << exit(FatalError);
    }
}

} // namespace


Foam::lpf::timeFolder::timeFolder(const fileName& caseDir, const word& timeName)
    : final_(caseDir / timeName), path_(caseDir / hiddenPrefix + timeName)
{
    if (isDir(path_))
    {
        rmDir(path_, true); // left behind by a run that was killed
    }
    if (!mkDir(path_))
    {
        FatalErrorInFunction << "Cannot make the folder " << path_ << nl
                             << "Check permissions and free space"
                             << exit(FatalError);
    }
}


Foam::lpf::timeFolder::~timeFolder()
{
    if (!committed_)
    {
        rmDir(path_, true);
    }
}


void Foam::lpf::timeFolder::commit()
{
    treeToDisk(path_);
    replace(path_, final_);
    toDisk(final_.path());
    committed_ = true;
}


void Foam::lpf::removeUnfinishedTimes(const fileName& caseDir)
{
    const word prefix(hiddenPrefix);
    for (const fileName& dir : readDir(caseDir, fileName::DIRECTORY))
    {
        if (dir.startsWith(prefix))
        {
            rmDir(caseDir / dir, true);
        }
    }
}
