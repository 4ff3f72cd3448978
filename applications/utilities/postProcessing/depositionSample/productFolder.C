// SPDX-License-Identifier: GPL-3.0-or-later
#include "productFolder.H"

#include "error.H"
#include "OSspecific.H"

namespace Foam
{
namespace lpf
{

productFolder::productFolder(const fileName& parent, const word& name)
    : final_(parent / name), draft_(parent / ("." + name + ".new"))
{
    rmDir(draft_, true);
    if (!mkDir(draft_))
    {
        FatalErrorInFunction << "cannot make " << draft_ << nl
                             << "May you write there, is there room?"
                             << exit(FatalError);
    }
}


productFolder::~productFolder()
{
    if (isDir(draft_))
    {
        rmDir(draft_, true);
    }
}


fileName productFolder::path(const word& cloud, const wordList& clouds) const
{
    const fileName folder = clouds.size() > 1 ? draft_ / cloud : draft_;
    mkDir(folder);
    return folder;
}


void productFolder::commit()
{
    if (isDir(final_))
    {
        rmDir(final_);
    }
    if (!mv(draft_, final_))
    {
        FatalErrorInFunction << "cannot rename " << draft_ << " to " << final_
                             << exit(FatalError);
    }
}

} // namespace lpf
} // namespace Foam
