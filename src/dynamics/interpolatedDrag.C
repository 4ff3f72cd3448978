// SPDX-License-Identifier: GPL-3.0-or-later
// The drag of the paper, by what each phase sees of the other at its own
// places. Not exact: the two sides add up to zero where the flow is uniform, no
// more.
#include "interphase.H"

#include "fieldTensors.H"

namespace Foam
{
namespace lpf
{

namespace
{

//- v and a of the other phase: means by mass, of the sums of m, m v, m a
struct otherPhase
{
    vector v, a;

    otherPhase(const realArrays<7>& sums, int i)
        : v(vector(sums[1][i], sums[2][i], sums[3][i]) / sums[0][i]),
          a(vector(sums[4][i], sums[5][i], sums[6][i]) / sums[0][i])
    {
    }
};

} // namespace

void interphase::interpolate()
{
    waterStore& water = water_.water;
    const int nGrains = grains_.grains.size(), nWater = water.size();
    voids_.resize(nGrains);
    carriedVoids_.resize(nWater);
    lpf::resize(atWater_, nWater);

    const scalar thickness = water_.scene().planeThickness;
    lpfPairs::forEach(
        nWater,
        [&](int a)
        { carriedVoids_[a] = water.mass[a] / thickness * water.theta[a]; }
    );
    gather(water_, grains_, fromWater_, {&carriedVoids_, &voids_});
    if (water_.asksGrains())
    {
        gather(grains_, water_, atWater_, {&excesses(), &excess_});
    }
    else
    {
        gather(grains_, water_, atWater_);
    }
}

// At a grain, v_f, a_f and the void fraction those of the water around,
//     f_k = sum_a m_a W_ka f_a/sum_a m_a W_ka,
//     dv_k = - rf/(rf + rb) (s_end - s),  s = v_f - v_k               (T 6.18)
vector interphase::changeOfGrain(int k, scalar dt) const
{
    const grainStore& grains = grains_.grains;
    const scalar sum = fromWater_[0][k];
    if (!(sum > dryShare * water_.state().rho0()))
    {
        return Zero;
    }
    const otherPhase water(fromWater_, k);
    const dragPlace place =
        placeOf(1 - voids_[k] / sum, sum, openShare(grains_.groundShare(k)));
    const vector slip = water.v - at(grains.U, k);
    const vector da = water.a - at(grains.a, k);
    const vector change = relaxed(place.at, place.densities, slip, da, dt);
    return (-place.rf / (place.rf + place.rb)) * change; // (T 6.18)
}

// At the water, v_p and a_p those of the grains around, theta its own,
//     dv_a = rb/(rf + rb) (s_end - s),  s = v_a - v_p                 (T 6.19)
vector interphase::changeOfWater(int a, scalar dt) const
{
    const waterStore& water = water_.water;
    const scalar sum = atWater_[0][a], theta = water.theta[a];
    if (!(sum > dryShare * grainDensity_) || !(theta < 1))
    {
        return Zero;
    }
    const otherPhase grains(atWater_, a);
    const dragPlace place = placeOf(1 - theta, theta * water.rho[a], 1);
    const vector slip = at(water.U, a) - grains.v;
    const vector da = at(water.a, a) - grains.a;
    const vector change = relaxed(place.at, place.densities, slip, da, dt);
    return (place.rb / (place.rf + place.rb)) * change; // (T 6.19)
}

// Both changes by the velocities before either
void interphase::interpolatedDrag(scalar dt)
{
    grainStore& grains = grains_.grains;
    waterStore& water = water_.water;
    interpolate();
    lpfPairs::forEach(
        grains.size(), [&](int k) { set(grains.drag, k, changeOfGrain(k, dt)); }
    );
    lpfPairs::forEach(
        water.size(), [&](int a) { set(water.drag, a, changeOfWater(a, dt)); }
    );
    grains_.takeDrag(grains.drag, 1, dt);
    water_.takeDrag(water.drag, 1, dt);
}

} // namespace lpf
} // namespace Foam
