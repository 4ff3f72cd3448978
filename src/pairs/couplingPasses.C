// SPDX-License-Identifier: GPL-3.0-or-later
// Passes from the particles of one phase to places of another

#include "enginePasses.H"
#include "pairLoops.H"
#include "wendlandC2.H"

namespace lpfPairs
{
namespace
{

template<int n>
LPF_ONE_BODY void smoothAtParticle(
    const smoothPass& p, const wendlandC2& W, const runs& around, int i
)
{
    pack total[n] = {};
    overPairs(
        around,
        broadcast(p.x, p.y, p.z, i),
        p.X,
        p.Y,
        p.Z,
        W.supportSqr(),
        [&](int j, const Vec<pack>&, const pack& rSqr)
        {
            const pack w = W.value(rSqr);
            for (int c = 0; c < n; ++c)
            {
                total[c] += load(p.q[c] + j) * w;
            }
        }
    );
    for (int c = 0; c < n; ++c)
    {
        p.out[c][i] = sum(total[c]);
    }
}

template<int n>
void smoothAll(const smoothPass& p)
{
    const wendlandC2 W(p.h, p.dimensions);

    forParticles(
        p.home,
        p.others,
        [&](const runs& around, int i) { smoothAtParticle<n>(p, W, around, i); }
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
    case 5:
        smoothAll<5>(p);
        break;
    default:
        smoothAll<7>(p);
    }
}

} // namespace lpfPairs
