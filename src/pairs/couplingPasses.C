// SPDX-License-Identifier: GPL-3.0-or-later
// Passes from the particles of one phase to places of another

#include "enginePasses.H"
#include "listLoops.H"
#include "wendlandC2.H"

namespace lpfPairs
{
namespace
{

//- Length of the records: place and quantities
constexpr int smoothFields(int n)
{
    return (3 + n + 3) / 4 * 4;
}

template<int n, class Real>
LPF_ONE_BODY void smoothAtParticle(
    const smoothPass& p,
    const wendlandC2& W,
    const neighbourTable& pairs,
    const places<Real>& where,
    const Real* records,
    int i
)
{
    using T = packOf<Real>;
    T total[n] = {};
    overList<Real, smoothFields(n)>(
        pairs,
        where,
        records,
        i,
        {where.stored(p.x[i]), where.stored(p.y[i]), where.stored(p.z[i])},
        [&](const T* of, const Vec<T>&, const T& rSqr)
        {
            const T w = W.value(rSqr);
            for (int c = 0; c < n; ++c)
            {
                total[c] += of[3 + c] * w;
            }
        }
    );
    for (int c = 0; c < n; ++c)
    {
        p.out[c][i] = sum(total[c]);
    }
}

template<int n, class Real>
void smoothIn(const smoothPass& p)
{
    const wendlandC2 W(p.h, p.dimensions);
    const places<Real> where(p.h);
    const pairsOf pairs(
        p, {p.home, p.others, p.h, p.x, p.y, p.z, p.X, p.Y, p.Z}
    );
    const double* fields[smoothFields(n)] = {p.X, p.Y, p.Z};
    std::copy_n(p.q, n, fields + 3);
    const Real* records = makeRecords(*pairs, where, fields);

    forListed(
        *pairs,
        [&](int i)
        { smoothAtParticle<n, Real>(p, W, *pairs, where, records, i); }
    );
}

template<int n>
void smoothAll(const smoothPass& p)
{
    p.single ? smoothIn<n, float>(p) : smoothIn<n, double>(p);
}

} // namespace

void smoothed(const smoothPass& p)
{
    switch (p.count)
    {
    case 1:
        smoothAll<1>(p);
        break;
    case 3:
        smoothAll<3>(p);
        break;
    case 5:
        smoothAll<5>(p);
        break;
    default:
        smoothAll<7>(p);
    }
}

} // namespace lpfPairs
