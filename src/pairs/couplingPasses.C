// SPDX-License-Identifier: GPL-3.0-or-later
// Passes from the particles of one phase to places of another

#include "enginePasses.H"
#include "listLoops.H"

namespace lpfPairs
{
namespace
{

//- Length of the records: place and quantities
constexpr int smoothFields(int n)
{
    return (3 + n + 3) / 4 * 4;
}

template<class T, std::size_t... c>
LPF_INLINE void
storeAll(const T* total, double* const* to, int i, std::index_sequence<c...>)
{
    storeSums(to, i, total[c]...);
}

template<int n, class Around>
LPF_ONE_BODY void smoothAtParticle(const smoothPass& p, Around& around, int i)
{
    using T = typename Around::T;
    T total[n] = {};
    around.each(
        i,
        [&](const T* of, const Vec<T>&, const T& rSqr)
        {
            const T w = around.W.value(rSqr);
            for (int c = 0; c < n; ++c)
            {
                total[c] += of[3 + c] * w;
            }
        }
    );
    storeAll(total, p.out, i, std::make_index_sequence<n>{});
}

template<int n>
void smoothAll(const smoothPass& p)
{
    recordFields<smoothFields(n)> fields = {{p.X, p.Y, p.Z}};
    std::copy_n(p.q, n, fields.of + 3);
    overPairs(
        p,
        searchPass{p.home, p.others, p.h, p.x, p.y, p.z, p.X, p.Y, p.Z},
        fields,
        [&](auto& around, int i) { smoothAtParticle<n>(p, around, i); }
    );
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
    case 4:
        smoothAll<4>(p);
        break;
    case 5:
        smoothAll<5>(p);
        break;
    case 7:
        smoothAll<7>(p);
        break;
    default:
        smoothAll<8>(p);
    }
}

} // namespace lpfPairs
