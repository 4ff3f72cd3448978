// SPDX-License-Identifier: GPL-3.0-or-later
#include "phaseDynamics.H"

#include "coulomb.H"

namespace Foam
{
namespace lpf
{

using lpfPairs::orderedSum;
using lpfPairs::sumOf;

phaseDynamics::phaseDynamics(
    const lpfPairs::pairEngine& engine,
    const sceneProperties& scene,
    groundContact& contact,
    particleStore& particles
)
    : particles_(particles), engine_(engine), scene_(scene), contact_(contact),
      lattice_(scene.largestH, scene.cyclic), acrossPlane_{}, pairs_(engine),
      elementsAround_(engine)
{
    if (scene_.dimensions == 2)
    {
        const vector& e = scene_.planeNormal;
        acrossPlane_ = dyad(1.0, lpfPairs::Vec<double>{e.x(), e.y(), e.z()});
    }
}

// At the start and when a gate opens
void phaseDynamics::updateGround(scalar time)
{
    const passTimes::timed pass(times, "elements of the ground");
    contact_.update(time, lattice_);
}

void phaseDynamics::sort()
{
    {
        const passTimes::timed pass(times, "sort");
        const int n = particles_.size();
        order_.resize(n);
        lattice_.sort(particles_.x, n, order_, cells_);
        if (cells_.moved)
        {
            particles_.permute(order_);
        }
    }
    const passTimes::timed pass(times, "search");
    const double* const x = particles_.x[0].data();
    const double* const y = particles_.x[1].data();
    const double* const z = particles_.x[2].data();
    pairs_.search({cells_.grid, cells_.grid, scene_.h, x, y, z, x, y, z});
}

void phaseDynamics::seeGround(bool withShare)
{
    const passTimes::timed pass(times, "ground");
    const int n = particles_.size();
    slot_.resize(n);

    lpfPairs::wallPass p = {};
    p.cells = cells_.grid;
    contact_.present(p);
    p.h = scene_.h;
    p.dimensions = scene_.dimensions;
    p.withShare = withShare;
    p.layerDepth = scene_.spacing;
    p.behind = contactShare * scene_.spacing;
    p.outOfSight = scene_.spacing;
    p.x = particles_.x[0].data();
    p.y = particles_.x[1].data();
    p.z = particles_.x[2].data();
    elementsAround_.search(
        {p.cells, p.elements, p.h, p.x, p.y, p.z, p.ex, p.ey, p.ez}
    );
    nSlots_ = elementsAround_.number(slot_.data());
    renew(walls_, static_cast<std::size_t>(nSlots_));
    p.pairs = elementsAround_.get();
    p.single = scene_.single;
    p.slot = slot_.data();
    p.sums = walls_.data();
    engine_.wall(p);
    markStart();
}

void phaseDynamics::markStart()
{
    renew(startAndLost_, static_cast<std::size_t>(nSlots_));
    lpfPairs::forEach(
        particles_.size(),
        [&](int i)
        {
            if (slot_[i] >= 0)
            {
                startAndLost(i) = at(particles_.U, i);
            }
        }
    );
}

namespace
{

//- Shift that brings x back into the cyclic box
vector wrapShift(const vector& x, const cyclicBox& box)
{
    vector shift(Zero);
    for (direction d = 0; d < 3; ++d)
    {
        if (box.period[d] > 0)
        {
            if (x[d] < box.lower[d])
            {
                shift[d] = box.period[d];
            }
            else if (x[d] >= box.lower[d] + box.period[d])
            {
                shift[d] = -box.period[d];
            }
        }
    }
    return shift;
}

} // namespace

void phaseDynamics::wrapCyclic()
{
    ledger.wrapped +=
        orderedSum<sumOf<scalar>>(
            particles_.size(),
            [&](int i)
            {
                const point x = at(particles_.x, i);
                const vector shift = wrapShift(x, scene_.cyclic);
                set(particles_.x, i, x + shift);
                return sumOf<scalar>{-particles_.mass[i] * (scene_.g & shift)};
            }
        ).value;
}

bool phaseDynamics::mayTouchGround(int i, const vector& step) const
{
    if (slot_[i] < 0)
    {
        return false;
    }
    const lpfPairs::wallRecord& wall =
        walls_[static_cast<std::size_t>(slot_[i])];
    const vector n(wall.normal[0], wall.normal[1], wall.normal[2]);
    return wall.distance + (n & step) < contactShare * scene_.spacing;
}

// A particle that would come nearer to the ground than a tenth of the spacing
// is set back and loses its approach, with friction on that impulse  (T 4.7).
// It was moved by dt of the velocity before
bool phaseDynamics::setBack(
    int i, scalar dt, vector& x, vector& U, driftSums& s
)
{
    const scalar closest = contactShare * scene_.spacing;
    const groundHit hit = contact_.signedDistance(x, scene_.spacing);
    if (!hit.found || hit.distance >= closest)
    {
        return false;
    }
    const scalar m = particles_.mass[i];
    const vector before = U;
    const vector move = (closest - hit.distance) * hit.normal;
    const scalar approach = max(scalar(0), -(U & hit.normal));
    const vector stopped = U + approach * hit.normal;
    x += move;
    U = afterFriction(stopped, hit.normal, groundFriction(hit.zone) * approach);
    s.impulse += m * approach * hit.normal;
    s.normal += m * approach;
    s.friction += m * (U - stopped);
    s.energy += nearLoss(i, stopped - before, stopped)
              + m * (scene_.g & (move - dt * (stopped - before)));
    s.frictionEnergy +=
        nearLoss(i, U - stopped, U) - dt * m * (scene_.g & (U - stopped));
    return true;
}

// What the penalty leaves of the approach goes no further than (T 4.7) would
// set it back to                                                     (T 4.21)
vector phaseDynamics::stopped(int i, const vector& U, scalar dt) const
{
    if (!mayTouchGround(i, U * dt))
    {
        return U;
    }
    const groundHit hit =
        contact_.signedDistance(at(particles_.x, i), scene_.spacing);
    if (!hit.found)
    {
        return U;
    }
    const scalar room =
        max(scalar(0), hit.distance - contactShare * scene_.spacing);
    return U + max(scalar(0), -(U & hit.normal) - room / dt) * hit.normal;
}

penaltyGround::neighbourhood phaseDynamics::aroundGround() const
{
    return {
        cells_.grid,
        elementsAround_.get(),
        particles_.x,
        slot_,
        particles_.size(),
        nSlots_};
}

void phaseDynamics::drift(scalar dt, scalar time)
{
    shift(dt);
    move(particles_.U, dt, time + dt);
}

void phaseDynamics::keepState(scalar)
{
    particles_.UStart = particles_.U;
}

void phaseDynamics::driftFreely(scalar dt)
{
    const passTimes::timed pass(times, "drift");
    lpfPairs::forEach(
        particles_.size(),
        [&](int i)
        {
            const vector step = at(particles_.U, i) * dt;
            set(particles_.x, i, at(particles_.x, i) + step);
        }
    );
    if (cmptMax(scene_.cyclic.period) > 0)
    {
        wrapCyclic();
    }
}

void phaseDynamics::goToEnd()
{
    particles_.U.swap(particles_.UStart);
    markStart();
}

void phaseDynamics::driftOn(scalar dt, scalar time)
{
    shift(dt);
    move(particles_.UStart, 0.5 * dt, time + dt);
}

void phaseDynamics::move(const realArrays<3>& velocity, scalar dt, scalar end)
{
    const passTimes::timed pass(times, "drift");
    constexpr int corners = 4; // a corner of three planes needs three

    const driftSums sums = orderedSum<driftSums>(
        particles_.size(),
        [&](int i)
        {
            driftSums s;
            vector U = at(particles_.U, i);
            const vector step = at(velocity, i) * dt;
            vector x = at(particles_.x, i) + step;

            bool touches = mayTouchGround(i, step);
            for (int k = 0; touches && k < corners; ++k)
            {
                touches = setBack(i, dt, x, U, s);
            }

            set(particles_.x, i, x);
            set(particles_.U, i, U);
            return s;
        }
    );

    ledger.projectionImpulse += sums.impulse;
    ledger.projectionNormalImpulse += sums.normal;
    ledger.projection += sums.energy;
    ledger.frictionImpulse += sums.friction;
    ledger.friction += sums.frictionEnergy;

    if (cmptMax(scene_.cyclic.period) > 0)
    {
        wrapCyclic();
    }
    removeLeavers(end);
}

void phaseDynamics::removeLeavers(scalar time)
{
    const int n = particles_.size();
    const int outside = orderedSum<sumOf<int>>(
                            n,
                            [&](int i)
                            {
                                const point x = at(particles_.x, i);
                                return sumOf<int>{!scene_.domain.contains(x)};
                            }
    ).value;
    if (outside == 0)
    {
        return;
    }
    int kept = 0;
    indexArray order;

    for (int i = 0; i < n; ++i)
    {
        const point x = at(particles_.x, i);
        if (scene_.domain.contains(x))
        {
            if (kept < i)
            {
                order[kept] = i;
            }
            ++kept;
            continue;
        }
        if (kept == i)
        {
            order.resize(n);
            for (int k = 0; k < i; ++k)
            {
                order[k] = k;
            }
        }
        const scalar m = particles_.mass[i];
        const vector U = at(particles_.U, i);
        ledger.leavers.push_back({time, particles_.id[i], x, U, m});
        ledger.leftMass.add(m);
        ledger.leftMomentum += m * U;
        ledger.left +=
            0.5 * m * magSqr(U) - m * (scene_.g & x) + storedEnergy(i);
    }
    if (kept < n)
    {
        for (int k = kept; k < n; ++k)
        {
            order[k] = kept > 0 ? order[kept - 1] : 0;
        }
        particles_.permute(order);
        particles_.truncate(kept);
    }
}

energyState phaseDynamics::energy() const
{
    return orderedSum<energyState>(
        particles_.size(),
        [&](int i)
        {
            const scalar m = particles_.mass[i];
            const vector U = at(particles_.U, i);
            energyState e;
            e.kinetic = 0.5 * m * magSqr(U);
            e.potential = -m * (scene_.g & at(particles_.x, i));
            e.elastic = storedEnergy(i);
            e.momentum = m * U;
            return e;
        }
    );
}

lpfPairs::exactSum phaseDynamics::mass() const
{
    lpfPairs::exactSum total;
    for (int i = 0; i < particles_.size(); ++i)
    {
        total.add(particles_.mass[i]);
    }
    return total;
}

bool phaseDynamics::massCloses() const
{
    lpfPairs::exactSum accounted = mass();
    accounted += ledger.leftMass;
    return accounted == ledger.initialMass;
}

scalar phaseDynamics::massMean(const realArrays<3>& a) const
{
    const scalar sum =
        orderedSum<sumOf<scalar>>(
            particles_.size(),
            [&](int i)
            { return sumOf<scalar>{particles_.mass[i] * mag(at(a, i))}; }
        ).value;
    return sum / max(mass().value(), VSMALL);
}

scalar phaseDynamics::maxSpeed() const
{
    return sqrt(lpfPairs::largest(
        particles_.size(), [&](int i) { return magSqr(at(particles_.U, i)); }
    ));
}

scalar phaseDynamics::movingMass(scalar threshold) const
{
    return orderedSum<sumOf<scalar>>(
               particles_.size(),
               [&](int i)
               {
                   const bool moves =
                       magSqr(at(particles_.U, i)) > sqr(threshold);
                   return sumOf<scalar>{moves ? particles_.mass[i] : 0};
               }
    ).value;
}

timeStepLimit
phaseDynamics::waveLimit(scalar CFL, scalar c, const char* rule) const
{
    const scalar acceleration = sqrt(lpfPairs::largest(
        particles_.size(), [&](int i) { return magSqr(at(particles_.a, i)); }
    ));
    timeStepLimit limit = {CFL * scene_.h / (c + maxSpeed()), rule};
    if (acceleration > 0)
    {
        limit.take({0.25 * sqrt(scene_.h / acceleration), "force"});
    }
    return limit;
}

// Without the records of the elements, which are memory of the ground
std::size_t phaseDynamics::bytes() const
{
    return particles_.bytes() + order_.bytes() + slot_.bytes() + pairs_.bytes()
         + elementsAround_.size().neighbours
         + walls_.capacity() * sizeof(lpfPairs::wallRecord)
         + startAndLost_.capacity() * sizeof(vector)
         + cells_.start.capacity() * sizeof(int)
         + (penalty_ ? penalty_->bytes() : 0);
}

} // namespace lpf
} // namespace Foam
