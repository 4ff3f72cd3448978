// SPDX-License-Identifier: GPL-3.0-or-later
#include "gdalScope.H"

#include <cpl_error.h>
#include <gdal_priv.h>
#include <ogrsf_frmts.h>

namespace Foam
{
namespace lpf
{

gdalScope::gdalScope()
{
    std::feholdexcept(&environment_);
    GDALAllRegister();
    CPLPushErrorHandler(CPLQuietErrorHandler);
    CPLErrorReset();
}


gdalScope::~gdalScope()
{
    CPLPopErrorHandler();
    std::fesetenv(&environment_);
}


string gdalScope::lastError()
{
    const string message(CPLGetLastErrorMsg());
    return message.empty() ? string("GDAL gives no reason") : message;
}

} // namespace lpf
} // namespace Foam
