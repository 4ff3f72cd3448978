// SPDX-License-Identifier: GPL-3.0-or-later
#include "penaltyGround.H"

#include "fieldTensors.H"
#include "orderedSum.H"
#include "phaseDynamics.H"

#include <Eigen/Eigenvalues>

namespace Foam
{
namespace lpf
{

namespace
{

//- Any set of elements takes energy, so that it may end anywhere
constexpr int mostRounds = 4;

//- (1 + rate K)^-1 U by the axes of K: what lies along the ground keeps its
//  digits at any rate                                               (T 4.20)
vector slowedBy(const Symm& K, scalar rate, const vector& U)
{
    Eigen::Matrix3d m;
    m << K.xx, K.xy, K.xz, K.xy, K.yy, K.yz, K.xz, K.yz, K.zz;
    const Eigen::SelfAdjointEigenSolver<Eigen::Matrix3d> axes(m);
    vector left = U;
    for (int c = 0; c < 3; ++c)
    {
        const auto e = axes.eigenvectors().col(c);
        const vector axis(e[0], e[1], e[2]);
        const scalar k = rate * max(scalar(0), axes.eigenvalues()[c]);
        left -= k / (1 + k) * (U & axis) * axis;
    }
    return left;
}

Symm tensorOf(const lpfPairs::penaltyRecord& r)
{
    return {r.K[0], r.K[1], r.K[2], r.K[3], r.K[4], r.K[5]};
}

vector velocityOf(const lpfPairs::penaltyRecord& r)
{
    return vector(r.U[0], r.U[1], r.U[2]);
}

void setVelocity(lpfPairs::penaltyRecord& r, const vector& U)
{
    for (direction d = 0; d < 3; ++d)
    {
        r.U[d] = U[d];
    }
}

bool same(const lpfPairs::penaltyRecord& a, const lpfPairs::penaltyRecord& b)
{
    return std::equal(a.K, a.K + 6, b.K);
}

void takeHalf(lpfPairs::penaltyRecord& to, const lpfPairs::penaltyRecord& of)
{
    for (int c = 0; c < 6; ++c)
    {
        to.K[c] = 0.5 * (to.K[c] + of.K[c]);
    }
}

} // namespace

penaltyGround::penaltyGround(
    const lpfPairs::pairEngine& engine,
    const sceneProperties& scene,
    const groundContact& contact,
    scalar omega
)
    : engine_(engine), scene_(scene), contact_(contact), omega_(omega)
{
}

std::unique_ptr<penaltyGround> penaltyGround::forPhase(
    const lpfPairs::pairEngine& engine,
    const sceneProperties& scene,
    const groundContact& contact,
    scalar soundSpeed
)
{
    const penaltyCoefficients* numbers = contact.penalty();
    return numbers ? std::make_unique<penaltyGround>(
               engine,
               scene,
               contact,
               numbers->omega > 0 ? numbers->omega : soundSpeed
           )
                   : nullptr;
}

void penaltyGround::take(const neighbourhood& at, const realArrays<3>& U)
{
    sums_.resize(static_cast<std::size_t>(at.nSlots));
    open_.resize(at.n);
    lpfPairs::forEach(
        at.n,
        [&](int i)
        {
            open_[i] = at.slot[i];
            if (open_[i] >= 0)
            {
                auto& record = sums_[static_cast<std::size_t>(open_[i])];
                setVelocity(record, lpf::at(U, i));
            }
        }
    );
    gather(at);
}

void penaltyGround::gather(const neighbourhood& at)
{
    lpfPairs::penaltyPass p = {};
    p.pairs = at.elements;
    p.single = scene_.single;
    p.cells = at.cells;
    contact_.present(p);
    p.h = scene_.h;
    p.dimensions = scene_.dimensions;
    p.behind = p.nearest = contactShare * scene_.spacing;
    p.x = at.x[0].data();
    p.y = at.x[1].data();
    p.z = at.x[2].data();
    p.slot = open_.data();
    p.sums = sums_.data();
    engine_.penalty(p);
}

void penaltyGround::push(
    const neighbourhood& at, const realArrays<3>& U, scalar dt
)
{
    take(at, U);
    last_.assign(sums_.size(), {});
    int round = 1;
    while (slow(at.n, U, dt, round) && round < mostRounds)
    {
        ++round;
        gather(at);
    }
}

// A particle whose elements are those of the round before is done, and one that
// approaches none any more; where rounds would go to and fro, half of each
bool penaltyGround::slow(int n, const realArrays<3>& U, scalar dt, int round)
{
    const scalar rate = 2 * scene_.h * omega_ * dt;
    const lpfPairs::penaltyRecord none = {};
    return lpfPairs::largest(
               n,
               [&](int i) -> scalar
               {
                   if (open_[i] < 0)
                   {
                       return 0;
                   }
                   const auto slot = static_cast<std::size_t>(open_[i]);
                   auto& record = sums_[slot];
                   if (same(record, last_[slot]) || same(record, none))
                   {
                       open_[i] = -1;
                       return 0;
                   }
                   if (round == mostRounds)
                   {
                       takeHalf(record, last_[slot]);
                   }
                   setVelocity(
                       record, slowedBy(tensorOf(record), rate, at(U, i))
                   );
                   last_[slot] = record;
                   return 1;
               }
           )
         > 0;
}

vector penaltyGround::velocity(int slot) const
{
    return velocityOf(sums_[static_cast<std::size_t>(slot)]);
}

std::size_t penaltyGround::bytes() const
{
    return (sums_.capacity() + last_.capacity())
             * sizeof(lpfPairs::penaltyRecord)
         + open_.bytes();
}

} // namespace lpf
} // namespace Foam
