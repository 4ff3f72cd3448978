// SPDX-License-Identifier: GPL-3.0-or-later
#include "momentInverse.H"

#include <Eigen/Eigenvalues>

namespace Foam
{
namespace lpf
{

namespace
{

using Moment = lpfPairs::SymmTensor<double>;

//- The last leading minor; the others by reference
double minors(const Moment& M, double& first, double& second)
{
    first = M.xx;
    second = M.xx * M.yy - M.xy * M.xy;
    return M.xx * (M.yy * M.zz - M.yz * M.yz)
         - M.xy * (M.xy * M.zz - M.yz * M.xz)
         + M.xz * (M.xy * M.yz - M.yy * M.xz);
}

//- All eigenvalues above s?
bool above(const Moment& M, double s)
{
    double first, second;
    const Moment shifted = {M.xx - s, M.xy, M.xz, M.yy - s, M.yz, M.zz - s};
    const double third = minors(shifted, first, second);
    return first > 0 && second > 0 && third > 0;
}

double smallestEigenvalue(const Moment& M)
{
    Eigen::Matrix3d m;
    m << M.xx, M.xy, M.xz, M.xy, M.yy, M.yz, M.xz, M.yz, M.zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> solver(
        m, Eigen::EigenvaluesOnly
    );
    return solver.eigenvalues()[0];
}

Moment inverse(const Moment& M)
{
    double first, second;
    const double det = 1 / minors(M, first, second);
    return {
        det * (M.yy * M.zz - M.yz * M.yz),
        det * (M.xz * M.yz - M.xy * M.zz),
        det * (M.xy * M.yz - M.xz * M.yy),
        det * (M.xx * M.zz - M.xz * M.xz),
        det * (M.xy * M.xz - M.xx * M.yz),
        det * second};
}

} // namespace

bool plainInverse(const Moment& M, double least, Moment& B)
{
    if (!above(M, least))
    {
        return false;
    }
    B = inverse(M);
    return true;
}

bool allBelow(const Moment& M, double s)
{
    return above({-M.xx, -M.xy, -M.xz, -M.yy, -M.yz, -M.zz}, -s);
}

Moment momentInverse(Moment M)
{
    if (!above(M, 0.5))
    {
        const double shift = 0.5 - smallestEigenvalue(M); // (T 3.11)
        if (shift > 0)
        {
            M.xx += shift;
            M.yy += shift;
            M.zz += shift;
        }
    }

    return inverse(M);
}

} // namespace lpf
} // namespace Foam
