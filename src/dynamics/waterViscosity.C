// SPDX-License-Identifier: GPL-3.0-or-later
#include "waterViscosity.H"

#include "fieldTensors.H"
#include "latticeSums.H"
#include "orderedSum.H"
#include "waterTerms.H"

#include "messageStream.H"

namespace Foam
{
namespace lpf
{

using lpfPairs::forChunks;
using lpfPairs::forEach;
using lpfPairs::orderedSum;
using lpfPairs::sumOf;

namespace
{

//- Residual at which a solution is good enough, as a share of its start and of
//  the motion
constexpr scalar closeEnough = 1e-7;

//- More iterations than any scene has needed; momentum is exact all the same
constexpr int mostIterations = 20000;

//- Least distance to the ground in the slope of the velocity behind it, as a
//  share of the spacing: a particle at rest has half a spacing
constexpr scalar nearestShare = 0.25;

//- Before a plane free surface half a kernel does the work of a whole one;
//  what has less left is spray
constexpr scalar mostWeight = 2;

//- Of the stages of (T 5.22): a root of 1 - 4 g + 2 g^2, with which what is
//  stiff dies away in a step, above 1/4, below which energy could rise
const scalar stageShare = 1 - std::sqrt(0.5);

} // namespace

waterViscosity::waterViscosity(
    const lpfPairs::pairEngine& engine,
    const sceneProperties& scene,
    const groundContact& contact,
    waterStore& water
)
    : engine_(engine), scene_(scene), contact_(contact), water_(water),
      sticks_(contact.anyStick()),
      standsForViscosity_(contact.anyForViscosity()),
      weight_(
          (scene.dimensions + 2)
          * lpfPairs::viscousWeight(
              lpfPairs::wendlandC2(scene.h, scene.dimensions),
              scene.spacing,
              scene.dimensions
          )
      )
{
}

void waterViscosity::seeGround(
    const lpfPairs::cellGrid& cells,
    const lpfPairs::neighbourTable* pairs,
    const lpfPairs::neighbourTable* elements,
    const indexArray& slot,
    int nSlots
)
{
    cells_ = cells;
    pairs_ = pairs;
    slot_ = &slot;
    if (sticks_)
    {
        lpfPairs::stickPass p = stickPass(elements, nSlots, stick_);
        contact_.present(p);
        engine_.stick(p);
    }
    if (standsForViscosity_)
    {
        lpfPairs::stickPass p = stickPass(elements, nSlots, law_);
        contact_.presentForViscosity(p);
        engine_.stick(p);
    }
}

lpfPairs::stickPass waterViscosity::stickPass(
    const lpfPairs::neighbourTable* elements,
    int nSlots,
    std::vector<lpfPairs::stickRecord>& sums
) const
{
    sums.resize(static_cast<std::size_t>(nSlots));
    lpfPairs::stickPass p = {};
    p.pairs = elements;
    p.cells = cells_;
    p.h = scene_.h;
    p.dimensions = scene_.dimensions;
    p.layerDepth = scene_.spacing;
    p.behind = contactShare * scene_.spacing;
    p.nearest = nearestShare * scene_.spacing;
    p.x = water_.x[0].data();
    p.y = water_.x[1].data();
    p.z = water_.x[2].data();
    p.slot = slot_->data();
    p.sums = sums.data();
    return p;
}

vector waterViscosity::groundGradient(int i) const
{
    const int slot = (*slot_)[i];
    if (!sticks_ || slot < 0)
    {
        return Zero;
    }
    const double* g = stick_[static_cast<std::size_t>(slot)].gradient;
    return vector(g[0], g[1], g[2]);
}

//- What the ground does of Q, by itself or by a law that stands for it
scalar waterViscosity::shearMomentOfGround(int i, const Symm& D) const
{
    const int slot = (*slot_)[i];
    scalar Q = 0;
    for (const auto* ground : {&stick_, &law_})
    {
        if (slot >= 0 && !ground->empty())
        {
            const auto& sums = (*ground)[static_cast<std::size_t>(slot)];
            Q += lpfPairs::shearMoment(sums.moment, D);
        }
    }
    return Q;
}

// The pairs and the ground take of the shear at i
//     P_i = V_i eta_i (D + 2) w Q_i,  2 V_i eta_i D:D is right, so that
//     eta <- c eta,  c = 2 D:D/((D + 2) w Q), within 1/2 and 2       (T 5.25)
void waterViscosity::adapt(const realArrays<6>& D, realArray& eta)
{
    const int n = water_.size();
    moment_.resize(n);
    lpfPairs::shearMomentPass p = {};
    p.pairs = pairs_;
    p.cells = cells_;
    p.h = scene_.h;
    p.dimensions = scene_.dimensions;
    p.x = water_.x[0].data();
    p.y = water_.x[1].data();
    p.z = water_.x[2].data();
    p.V = water_.V.data();
    for (std::size_t c = 0; c < 6; ++c)
    {
        p.D[c] = D[c].data();
    }
    p.Q = moment_.data();
    engine_.shearMoment(p);
    lpfPairs::forEach(
        n,
        [&](int i)
        {
            const Symm shear = symmAt(D, i);
            const scalar wanted = sqr(rateOfShear(shear));
            const scalar made =
                weight_ * (moment_[i] + shearMomentOfGround(i, shear));
            const bool known = wanted > VSMALL && made > VSMALL;
            eta[i] *= known
                        ? std::clamp(wanted / made, 1 / mostWeight, mostWeight)
                        : 1;
        }
    );
}

//- f = - 2 (D + 2) w V eta T u                                      (T 5.21)
vector waterViscosity::stickForce(int i, const vector& u) const
{
    const int slot = (*slot_)[i];
    if (!sticks_ || slot < 0)
    {
        return Zero;
    }
    const double* t = stick_[static_cast<std::size_t>(slot)].force;
    const Symm T = {t[0], t[1], t[2], t[3], t[4], t[5]};
    const scalar V = water_.V[i] * scene_.planeThickness;
    return (-2 * weight_ * V * (*eta_)[i]) * toVector(T & toVec(u));
}

void waterViscosity::apply(realArrays<3>& u)
{
    const int n = water_.size();
    lpf::resize(force_, n);
    lpfPairs::viscousPass p = {};
    p.pairs = pairs_;
    p.cells = cells_;
    p.h = scene_.h;
    p.dimensions = scene_.dimensions;
    p.weight = weight_;
    p.x = water_.x[0].data();
    p.y = water_.x[1].data();
    p.z = water_.x[2].data();
    p.V = water_.V.data();
    p.eta = eta_->data();
    for (std::size_t c = 0; c < 3; ++c)
    {
        p.u[c] = u[c].data();
        p.force[c] = force_[c].data();
    }
    engine_.viscous(p);
    forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                const scalar V = water_.V[i] * scene_.planeThickness;
                set(force_, i, V * at(force_, i) + stickForce(i, at(u, i))
                ); // (T 5.20)
            }
        }
    );
}

waterViscosity::totals waterViscosity::accelerate(bool add)
{
    apply(water_.U);
    return orderedSum<totals>(
        water_.size(),
        [&](int i)
        {
            const vector U = at(water_.U, i), f = at(force_, i);
            const vector before = add ? at(water_.friction, i) : vector(Zero);
            set(water_.friction, i, before + f / water_.mass[i]);
            return totals{stickForce(i, U), -(f & U)};
        }
    );
}

scalar waterViscosity::stiffest() const
{
    if (!sticks_)
    {
        return 0;
    }
    return lpfPairs::largest(
        water_.size(),
        [&](int i)
        {
            scalar rate = 0;
            for (direction c = 0; c < 3; ++c)
            {
                vector e(Zero);
                e[c] = 1;
                rate -= stickForce(i, e)[c] / water_.mass[i];
            }
            return rate;
        }
    );
}

//- sum m |u - from|^2
scalar waterViscosity::motion(const realArrays<3>& u, const vector& from) const
{
    return orderedSum<sumOf<scalar>>(
               water_.size(),
               [&](int i) {
                   return sumOf<scalar>{
                       water_.mass[i] * magSqr(at(u, i) - from)};
               }
    ).value;
}

//- Mean velocity by mass; zero where the ground is what motion is against
vector waterViscosity::reference(const realArrays<3>& u) const
{
    struct sums
    {
        scalar mass = 0;
        vector momentum = Zero;

        void operator+=(const sums& b)
        {
            mass += b.mass;
            momentum += b.momentum;
        }
    };
    if (sticks_)
    {
        return Zero;
    }
    const sums s = orderedSum<sums>(
        water_.size(),
        [&](int i) {
            return sums{water_.mass[i], water_.mass[i] * at(u, i)};
        }
    );
    return s.momentum / max(s.mass, VSMALL);
}

scalar waterViscosity::advance(realArrays<3>& u, scalar alpha, scalar dt)
{
    return orderedSum<sumOf<scalar>>(
               water_.size(),
               [&](int i)
               {
                   const scalar m = water_.mass[i];
                   const vector p = at(direction_, i);
                   set(u, i, at(u, i) + alpha * p);
                   const vector r =
                       at(residual_, i) - alpha * (m * p - dt * at(force_, i));
                   set(residual_, i, r);
                   return sumOf<scalar>{magSqr(r) / m};
               }
    ).value;
}

// Residual and direction at u*; returns r.r/m
scalar waterViscosity::begin(realArrays<3>& u, scalar dt)
{
    const int n = water_.size();
    lpf::resize(residual_, n);
    lpf::resize(direction_, n);
    padZero(direction_, n);
    apply(u);
    return orderedSum<sumOf<scalar>>(
               n,
               [&](int i)
               {
                   const vector r = dt * at(force_, i);
                   set(residual_, i, r);
                   set(direction_, i, r / water_.mass[i]);
                   return sumOf<scalar>{magSqr(r) / water_.mass[i]};
               }
    ).value;
}

//- p.(m - dt L) p of the direction
scalar waterViscosity::curvature(scalar dt)
{
    apply(direction_);
    return orderedSum<sumOf<scalar>>(
               water_.size(),
               [&](int i)
               {
                   const vector p = at(direction_, i);
                   return sumOf<scalar>{
                       p & (water_.mass[i] * p - dt * at(force_, i))};
               }
    ).value;
}

// Conjugate gradients for (m - dt L) u = m u* from u = u*
int waterViscosity::solve(scalar dt)
{
    realArrays<3>& u = water_.U;
    const scalar moving = motion(u, reference(u));
    // below the rounding of u itself there is nothing to gain
    const scalar rounding = sqr(SMALL) * motion(u, Zero);
    const scalar start = begin(u, dt);
    const scalar enough = max(rounding, sqr(closeEnough) * min(start, moving));
    scalar left = start;
    int k = 0;
    while (left > enough && k < mostIterations)
    {
        ++k;
        const scalar before = left;
        left = advance(u, before / curvature(dt), dt);
        const scalar beta = left / before;
        forChunks(
            water_.size(),
            [&](int from, int end, int)
            {
                for (int i = from; i < end; ++i)
                {
                    set(direction_,
                        i,
                        at(residual_, i) / water_.mass[i]
                            + beta * at(direction_, i));
                }
            }
        );
    }
    if (k == mostIterations && !warned_)
    {
        warned_ = true;
        WarningInFunction << "The implicit viscosity has not converged in " << k
                          << " iterations: " << sqrt(left / start)
                          << " of the residual is left. Write a smaller "
                          << "viscosity or a smaller CFL" << endl;
    }
    return k;
}

// du/dt = a + L u over dt from u_0, what the kick by a dt began with, with two
// stages that are implicit, g = 1 - 1/sqrt(2):                      (T 5.22)
//     u_1 = u_0 + dt g k_1,                 k = a + L u/m of the stage
//     u_2 = u_0 + dt ((1 - 2 g) k_1 + g k_2)
//     u   = u_0 + dt (k_1 + k_2)/2
void waterViscosity::advanceStages(scalar dt)
{
    const int n = water_.size();
    constexpr scalar half = 0.5;
    const scalar g = stageShare;
    const auto start = [&](int i)
    { return at(kicked_, i) - dt * at(water_.a, i); };
    const auto given = [&](int i)
    { return start(i) + (1 - 2 * g) * at(first_, i); };

    lpf::resize(first_, n);
    forEach(
        n, [&](int i) { set(water_.U, i, start(i) + g * dt * at(water_.a, i)); }
    );
    iterations = solve(g * dt);
    forEach(
        n,
        [&](int i)
        {
            set(first_, i, (at(water_.U, i) - start(i)) / g);
            set(water_.U, i, given(i) + g * dt * at(water_.a, i));
        }
    );
    iterations += solve(g * dt);
    forEach(
        n,
        [&](int i)
        {
            const vector second = (at(water_.U, i) - given(i)) / g;
            set(water_.U, i, start(i) + half * (at(first_, i) + second));
        }
    );
}

void waterViscosity::relax(scalar dt)
{
    const int n = water_.size();
    lpf::resize(kicked_, n);
    for (std::size_t c = 0; c < 3; ++c)
    {
        for (int i = 0; i < n; ++i)
        {
            kicked_[c][i] = water_.U[c][i];
        }
    }
    advanceStages(dt);
    forEach(
        n,
        [&](int i)
        {
            const vector dU = at(water_.U, i) - at(kicked_, i);
            set(water_.a, i, at(water_.a, i) + dU / dt);
            set(kicked_, i, dU);
        }
    );
}

std::size_t waterViscosity::bytes() const
{
    return (stick_.capacity() + law_.capacity()) * sizeof(lpfPairs::stickRecord)
         + lpf::bytes(force_) + moment_.bytes() + lpf::bytes(residual_)
         + lpf::bytes(direction_) + lpf::bytes(kicked_)
         + stick_.capacity() * sizeof(lpfPairs::stickRecord);
}

} // namespace lpf
} // namespace Foam
