// SPDX-License-Identifier: GPL-3.0-or-later
// Gradient and diffusion of the stress of grains. The physics is in
// pairTerms.H.

#include "enginePasses.H"
#include "listLoops.H"
#include "pairTerms.H"

namespace lpfPairs
{
namespace
{

//- Fields of the records after the position
enum stressField
{
    volume = 3,
    stress = 4,
    gradient = 10 //!< three a component, of the diffusion
};

//- Fields of the particle itself, in all lanes
template<class Real, int n>
LPF_INLINE void
ownFields(const double* const (&from)[n], int i, packOf<Real>* to)
{
    for (int c = 0; c < n; ++c)
    {
        to[c] = own<Real>(from[c][i]);
    }
}

template<class Around>
LPF_ONE_BODY void
gradientAtParticle(const stressGradientPass& p, Around& around, int i)
{
    using T = typename Around::T;
    T sigma_i[stressParts];
    ownFields<typename Around::Real>(p.sigma, i, sigma_i);
    StressGradient<T> total = {};

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T VF = of[volume] * around.W.gradByDistance(rSqr);
            addStressGradient(total, VF, x_ij, sigma_i, of + stress);
        }
    );

    for (int c = 0; c < stressParts; ++c)
    {
        store(total.Q[c], p.Q + 3 * c, i);
    }
    store(total.M, p.M, i);
}

template<class Around>
LPF_ONE_BODY void
diffusionAtParticle(const stressDiffusionPass& p, Around& around, int i)
{
    using T = typename Around::T;
    T sigma_i[stressParts], G_i[3 * stressParts];
    ownFields<typename Around::Real>(p.sigma, i, sigma_i);
    ownFields<typename Around::Real>(p.G, i, G_i);
    T total[stressParts] = {};

    around.each(
        i,
        [&](const T* of, const Vec<T>& x_ij, const T& rSqr)
        {
            const T VF = of[volume] * around.W.gradByDistance(rSqr);
            for (int c = 0; c < stressParts; ++c)
            {
                total[c] += (VF + VF)
                          * stressJump(
                                sigma_i[c],
                                of[stress + c],
                                vectorOf(G_i + 3 * c),
                                vectorOf(of + gradient + 3 * c),
                                x_ij
                          );
            }
        }
    );
    storeSums(
        p.out, i, total[0], total[1], total[2], total[3], total[4], total[5]
    );
}

} // namespace

void stressGradient(const stressGradientPass& p)
{
    recordFields<12> fields = {{p.x, p.y, p.z, p.V}};
    std::copy_n(p.sigma, stressParts, fields.of + stress);
    overPairs(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i)
        {
            if (p.takesPart[i] > 0)
            {
                gradientAtParticle(p, around, i);
            }
        }
    );
}

void stressDiffusion(const stressDiffusionPass& p)
{
    recordFields<28> fields = {{p.x, p.y, p.z, p.V}};
    std::copy_n(p.sigma, stressParts, fields.of + stress);
    std::copy_n(p.G, 3 * stressParts, fields.of + gradient);
    overPairs(
        p,
        searchOf(p),
        fields,
        [&](auto& around, int i)
        {
            if (p.V[i] > 0)
            {
                diffusionAtParticle(p, around, i);
            }
        }
    );
}

} // namespace lpfPairs
