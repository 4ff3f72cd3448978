// SPDX-License-Identifier: GPL-3.0-or-later
// The paper's boundary force, from the elements of the ground that a particle
// approaches. The physics is in pairTerms.H.

#include "enginePasses.H"
#include "listLoops.H"
#include "pairTerms.H"

namespace lpfPairs
{
namespace
{

template<bool screened, class Around>
LPF_ONE_BODY void penaltyOfParticle(const penaltyPass& p, Around& around, int i)
{
    using Real = typename Around::Real;
    using T = typename Around::T;
    penaltyRecord& record = p.sums[p.slot[i]];
    const Vec<T> v = {
        own<Real>(record.U[0]), own<Real>(record.U[1]), own<Real>(record.U[2])};
    SymmTensor<T> K = {};

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_iq, const T& rSqr)
        {
            const Vec<T> n = vectorOf(of + normal);
            T A = onlyIf(
                (x_iq & n) > own<Real>(-p.behind) && (v & n) < T(Real(0)),
                of[area]
            );
            if constexpr (screened)
            {
                A = onlyIf(!isScreened(of + screen, x_iq), A);
            }
            addPenalty(K, around.W, rSqr, n, A, p.nearest);
        }
    );

    const T sums[6] = {K.xx, K.xy, K.xz, K.yy, K.yz, K.zz};
    for (int c = 0; c < 6; ++c)
    {
        record.K[c] = sum(sums[c]);
    }
}

template<bool screened>
void penalty(const penaltyPass& p)
{
    const auto fields = elementFields<screened>(p, nullptr);
    overPairs(
        p,
        elementsOf(p),
        fields,
        [&](auto& around, int i)
        {
            if (p.slot[i] >= 0)
            {
                penaltyOfParticle<screened>(p, around, i);
            }
        }
    );
}

} // namespace

void penaltyOfGround(const penaltyPass& p)
{
    p.screens.height ? penalty<true>(p) : penalty<false>(p);
}

} // namespace lpfPairs
