// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundResistance.H"

#include "latticeSums.H"
#include "phaseDynamics.H"

namespace Foam
{
namespace lpf
{

namespace
{

//- Part of g into the ground, at least, as a share of g
constexpr scalar leastInto = 0.1;

} // namespace

groundResistance::groundResistance(
    const groundContact& contact, const sceneProperties& scene, lawOf phase
)
    : contact_(contact), scene_(scene), phase_(phase),
      lambda_(lpfPairs::latticeFactor(
          lpfPairs::wendlandC2(scene.h, scene.dimensions),
          scene.spacing,
          scene.dimensions
      )),
      withDry_(phase == &groundZone::water),
      below_(phase == &groundZone::water ? 0 : 0.5 * scene.spacing)
{
}

std::unique_ptr<groundResistance> groundResistance::forPhase(
    const groundContact& contact, const sceneProperties& scene, lawOf phase
)
{
    return contact.anyResistance(phase)
             ? std::make_unique<groundResistance>(contact, scene, phase)
             : nullptr;
}

groundHit groundResistance::nearest(const point& x) const
{
    // beyond the support of the kernel an element may reach by half its size
    return contact_.signedDistance(x, 2 * scene_.h + scene_.spacing);
}

groundResistance::terms groundResistance::termsAt(
    const groundHit& hit, scalar area, scalar normalStress, scalar rho
) const
{
    const scalar g = mag(scene_.g);
    const groundPlace place = {
        hit.distance,
        normalStress,
        max(scalar(0), hit.distance - below_),
        rho,
        g,
        max(leastInto * g, -(scene_.g & hit.normal)),
        scene_.spacing};
    const groundLaw& law = *(contact_.zone(hit.zone).*phase_);
    const groundTraction t = law.at(place);
    const scalar areaOverVolume = 2 * lambda_ * area; // (T 4.10)
    return {
        t.dry + (withDry_ ? law.mu() : 0),
        areaOverVolume * t.linear,
        areaOverVolume * t.quadratic};
}

vector groundResistance::after(
    int slot,
    const vector& U,
    const vector& n,
    scalar mostDry,
    scalar normalChange,
    scalar dt
) const
{
    const terms& t = terms_[static_cast<std::size_t>(slot)];
    const vector slip = U - (U & n) * n;
    const scalar speed = mag(slip);
    const scalar dry = mostDry + t.dry * normalChange;
    if (!(speed > dry))
    {
        return U - slip;
    }
    const scalar left =
        slowed(speed - dry, 1 + dt * t.linear, dt * t.quadratic); // (T 4.11)
    return U - slip * (1 - left / speed);
}

} // namespace lpf
} // namespace Foam
