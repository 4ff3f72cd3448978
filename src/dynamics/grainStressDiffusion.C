// SPDX-License-Identifier: GPL-3.0-or-later
// Smooths what a linear stress leaves of the differences of neighbours that
// flow. A stress that is linear in x stays as it is, on any slope and at any
// edge.
#include "grainDynamics.H"

#include "fieldTensors.H"
#include "momentInverse.H"
#include "pairTerms.H"

namespace Foam
{
namespace lpf
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

namespace
{

//- A moment with an eigenvalue below this says too little of a gradient
constexpr double leastMoment = 0.2;

//- d c/h times the time that is made up for at once, at least: a checkerboard
//  loses a third of its height then
constexpr double dueAt = 0.05;

constexpr std::size_t parts = lpfPairs::stressParts;

} // namespace

void grainDynamics::gatherGradient()
{
    const int n = grains.size();
    lpf::resize(gradSigma_, n);
    lpf::resize(jumps_, n);
    takesPart_.resize(n);
    lpfPairs::forEach(
        n, [&](int i) { takesPart_[i] = smooths(i) ? grains.V[i] : 0; }
    );

    auto p = overPairs<lpfPairs::stressGradientPass>();
    p.takesPart = takesPart_.data();
    for (std::size_t c = 0; c < parts; ++c)
    {
        p.sigma[c] = grains.sigma[c].data();
        p.M[c] = jumps_[c].data();
    }
    for (std::size_t c = 0; c < 3 * parts; ++c)
    {
        p.Q[c] = gradSigma_[c].data();
    }
    engine_.stressGradient(p);
}

// Grains that are separated carry none: what they took would be made of
// nothing. What stands is in balance by a stress that is not smooth, and would
// creep
bool grainDynamics::smooths(int i) const
{
    return mag(pressureAt(i)) > 0 && rheology_.yields(pointAt(i));
}

//     G = Q M^-1 of each component                                   (T 3.40)
void grainDynamics::takeGradient(int i)
{
    Symm inverse;
    const bool takes =
        takesPart_[i] > 0
        && plainInverse(symmAt(jumps_, i) + acrossPlane_, leastMoment, inverse);
    takesPart_[i] = takes ? takesPart_[i] : 0;
    for (std::size_t c = 0; c < 3 * parts; c += 3)
    {
        Vec3 G = {0, 0, 0}; // finite, where it has no weight
        if (takes)
        {
            G = inverse
              & Vec3{
                  gradSigma_[c][i],
                  gradSigma_[c + 1][i],
                  gradSigma_[c + 2][i]}; // (T 3.40)
        }
        gradSigma_[c][i] = G.x;
        gradSigma_[c + 1][i] = G.y;
        gradSigma_[c + 2][i] = G.z;
    }
}

//     sigma_i += dt 2 d h c sum_j V_j F_ij psi_ij,
//     rho_i   += rhoRef_i dp_i/K                                     (T 3.42)
// over the grains that take part; the energy that it takes out of the store
scalar grainDynamics::addJumps(int i, scalar weight)
{
    if (!(takesPart_[i] > 0))
    {
        return 0;
    }
    const scalar before = storedEnergy(i);
    for (std::size_t c = 0; c < parts; ++c)
    {
        grains.sigma[c][i] += weight * jumps_[c][i]; // (T 3.42)
    }
    const scalar dp =
        -weight * (jumps_[0][i] + jumps_[3][i] + jumps_[5][i]) / 3;
    grains.rho[i] += grains.rhoRef[i] * dp / rheology_.elastic().K();
    return before - storedEnergy(i);
}

// Once in several steps, for all of them
void grainDynamics::diffuseStressWhenDue(scalar dt)
{
    undiffused += dt;
    const scalar perTime =
        scheme_.stressDiffusion * rheology_.elastic().c() / scene_.h;
    if (undiffused * perTime > dueAt)
    {
        diffuseStress(undiffused);
        undiffused = 0;
        ++diffusions_;
    }
}

void grainDynamics::diffuseStress(scalar dt)
{
    const passTimes::timed pass(times, "stress diffusion");
    const int n = grains.size();
    gatherGradient();
    lpfPairs::forEach(n, [&](int i) { takeGradient(i); });

    auto p = overPairs<lpfPairs::stressDiffusionPass>();
    p.V = takesPart_.data();
    for (std::size_t c = 0; c < parts; ++c)
    {
        p.sigma[c] = grains.sigma[c].data();
        p.out[c] = jumps_[c].data();
    }
    for (std::size_t c = 0; c < 3 * parts; ++c)
    {
        p.G[c] = gradSigma_[c].data();
    }
    engine_.stressDiffusion(p);

    const scalar weight =
        dt * scheme_.stressDiffusion * scene_.h * rheology_.elastic().c();
    ledger.diffusion +=
        orderedSum<sumOf<scalar>>(
            n, [&](int i) { return sumOf<scalar>{addJumps(i, weight)}; }
        ).value;
}

} // namespace lpf
} // namespace Foam
