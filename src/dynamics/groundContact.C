// SPDX-License-Identifier: GPL-3.0-or-later
#include "groundContact.H"

#include "inputCheck.H"

namespace Foam
{
namespace lpf
{

namespace
{

//- A speed, or 0 for auto
scalar readOmega(const dictionary& dict)
{
    const word key("omega");
    allowOnly(dict, {key});
    if (!dict.found(key))
    {
        return 0;
    }
    const ITstream& given = dict.lookup(key);
    if (given.size() == 1 && given[0].isWord())
    {
        if (given[0].wordToken() != "auto")
        {
            refuse(
                dict,
                key,
                "omega = " + given[0].wordToken()
                    + " is no speed: a number in m/s, or auto for the speed of "
                      "sound of each phase; write omega auto;"
            );
        }
        return 0;
    }
    bounds speed;
    speed.lower = 0;
    speed.lowerOpen = true;
    speed.reason = "it is the speed by which the ground slows what approaches "
                   "it, and with 0 it would not be there; write auto, or the "
                   "speed of sound";
    return readNumber(dict, key, dimVelocity, speed);
}

groundZone readZone(const dictionary& dict)
{
    groundZone zone;
    zone.grains = groundLaw::forGrains(dict);
    zone.water = groundLaw::forWater(dict);

    bounds time;
    time.lower = 0;
    time.reason = "a zone opens at a time of the run";
    zone.opensAt = readNumber(dict, "opensAt", dimTime, time, GREAT);
    return zone;
}

} // namespace

groundContact::groundContact(
    ground& theGround,
    const dictionary& boundaryProperties,
    scalar elementSpacing,
    scalar reach,
    scalar planeThickness,
    const vector& planeNormal
)
    : ground_(theGround), elementSpacing_(elementSpacing), reach_(reach),
      planeThickness_(planeThickness), planeNormal_(planeNormal)
{
    readContact(boundaryProperties);
    readZones(neededDictionary(
        boundaryProperties,
        "zones",
        "write zones { <zone> { friction Coulomb; mu 0.5; } }"
    ));
}

bool groundContact::asksPenalty(const dictionary& boundaryProperties)
{
    return readChoice(
               boundaryProperties,
               "contact",
               {"signedDistance", "penalty"},
               "signedDistance"
           )
        == "penalty";
}

void groundContact::readContact(const dictionary& boundaryProperties)
{
    const word coeffs("penaltyCoeffs");
    allowOnly(
        boundaryProperties,
        {"contact", "zones", "planeStrain", "cyclic"},
        {"penalty"}
    );
    if (!asksPenalty(boundaryProperties))
    {
        return;
    }
    const dictionary* numbers = optionalDictionary(boundaryProperties, coeffs);
    penalty_.reset(new penaltyCoefficients{numbers ? readOmega(*numbers) : 0});
}

void groundContact::readZones(const dictionary& zones)
{
    allowOnly(zones, ground_.zones());
    for (const word& name : ground_.zones())
    {
        if (!zones.found(name))
        {
            FatalIOErrorInFunction(zones)
                << "The ground has a zone " << name
                << " that has no entry here: its friction is unknown. Write "
                << name << " { friction Coulomb; mu 0.5; } or friction none;"
                << " zones of this ground: " << flatOutput(ground_.zones())
                << exit(FatalIOError);
        }
        zones_.push_back(readZone(neededDictionary(
            zones, name, "write " + name + " { friction Coulomb; mu 0.5; }"
        )));
    }
}

scalar groundContact::nextOpening(scalar time) const
{
    scalar next = GREAT;
    for (const groundZone& z : zones_)
    {
        if (z.opensAt > time)
        {
            next = min(next, z.opensAt);
        }
    }
    return next;
}

scalar groundContact::lastOpening() const
{
    scalar last = -1;
    for (const groundZone& z : zones_)
    {
        last = z.opensAt < GREAT ? max(last, z.opensAt) : last;
    }
    return last;
}

void groundContact::update(scalar time, const cellLattice& lattice)
{
    if (time < nextChange_)
    {
        return;
    }
    nextChange_ = nextOpening(time);
    for (std::size_t k = 0; k < zones_.size(); ++k)
    {
        if (zones_[k].opensAt <= time)
        {
            ground_.removeZone(ground_.zones()[static_cast<label>(k)]);
        }
    }

    ++version_;
    takeElements(elements());
    sort(lattice);
}

// A line takes few elements: there they may be so short that a sum over them is
// the integral (to 1e-5 of it, half a spacing from the ground)
surfaceElements groundContact::elements() const
{
    constexpr scalar shorter = 0.25, little = 1e-6;
    if (!(planeThickness_ > 0))
    {
        return ground_.elements(elementSpacing_);
    }
    // the plane may lie along an edge of the ground: cut just within
    const scalar centre = ground_.bounds().centre() & planeNormal_;
    const scalar inward = little * (centre - planeOffset_);
    surfaceElements all = ground_.sections(
        shorter * elementSpacing_, {planeNormal_, planeOffset_ + inward}
    );
    for (point& x : all.x)
    {
        x -= inward * planeNormal_;
    }
    return all;
}

void groundContact::takeElements(const surfaceElements& all)
{
    size_ = all.x.size();
    for (auto* f :
         {&x_[0], &x_[1], &x_[2], &n_[0], &n_[1], &n_[2], &area_, &mu_})
    {
        f->resize(size_);
    }
    for (realArray* area : areasOfLaws())
    {
        area->resize(size_);
    }
    const bool sticks = anyStick(), viscous = anyForViscosity();
    forAll (all.x, q)
    {
        const scalar A = mag(all.nA[q]);
        set(x_, q, all.x[q]);
        set(n_, q, all.nA[q] / A);
        area_[q] = A;
        mu_[q] = effectiveFriction(all.zone[q]);
        const groundLaw& law = *zone(all.zone[q]).water;
        if (sticks)
        {
            stickArea_[q] = law.sticks() ? area_[q] : 0;
        }
        if (viscous)
        {
            viscousArea_[q] = law.standsForViscosity() ? area_[q] : 0;
        }
    }
    takeScreens(ground_.screens(all, elementSpacing_, reach_));
}

std::vector<realArray*> groundContact::areasOfLaws()
{
    std::vector<realArray*> areas;
    if (anyStick())
    {
        areas.push_back(&stickArea_);
    }
    if (anyForViscosity())
    {
        areas.push_back(&viscousArea_);
    }
    return areas;
}

void groundContact::takeScreens(const UList<elementScreen>& screens)
{
    nScreens_ = screens.size();
    if (!nScreens_)
    {
        return;
    }
    resize(screenNormal_, size_);
    screenHeight_.resize(size_);
    for (int q = 0; q < size_; ++q)
    {
        set(screenNormal_, q, vector(Zero));
        screenHeight_[q] = 0;
    }
    for (const elementScreen& s : screens)
    {
        set(screenNormal_, s.element, s.normal);
        screenHeight_[s.element] = s.height;
    }
}

void groundContact::sort(const cellLattice& lattice)
{
    indexArray order;
    order.resize(size_);
    lattice.sort(x_, size_, order, cells_);
    if (!cells_.moved)
    {
        return;
    }
    realArray sorted;
    sorted.resize(size_);
    std::vector<realArray*> all = {
        &x_[0], &x_[1], &x_[2], &n_[0], &n_[1], &n_[2], &area_, &mu_};
    for (realArray* area : areasOfLaws())
    {
        all.push_back(area);
    }
    if (nScreens_)
    {
        for (realArray& f : screenNormal_)
        {
            all.push_back(&f);
        }
        all.push_back(&screenHeight_);
    }
    for (realArray* f : all)
    {
        for (int q = 0; q < size_; ++q)
        {
            sorted[q] = (*f)[order[q]];
        }
        f->swap(sorted);
    }
}

std::size_t groundContact::bytes() const
{
    return 8 * area_.bytes() + stickArea_.bytes() + viscousArea_.bytes()
         + 4 * screenHeight_.bytes() + cells_.start.size() * sizeof(int);
}

// A cyclic direction has no images of the ground: it extends beyond
template<class Pass>
void groundContact::presentElements(Pass& pass) const
{
    pass.elements = cells_.grid;
    for (double& period : pass.elements.period)
    {
        period = 0;
    }
    pass.ex = x_[0].data();
    pass.ey = x_[1].data();
    pass.ez = x_[2].data();
    pass.nx = n_[0].data();
    pass.ny = n_[1].data();
    pass.nz = n_[2].data();
    pass.screens = {};
    if (nScreens_)
    {
        for (direction d = 0; d < 3; ++d)
        {
            pass.screens.n[d] = screenNormal_[d].data();
        }
        pass.screens.height = screenHeight_.data();
    }
}

void groundContact::present(lpfPairs::wallPass& pass) const
{
    presentElements(pass);
    pass.area = area_.data();
    pass.mu = mu_.data();
    pass.version = version_;
}

void groundContact::present(lpfPairs::stickPass& pass) const
{
    presentElements(pass);
    pass.area = stickArea_.data();
}

void groundContact::presentForViscosity(lpfPairs::stickPass& pass) const
{
    presentElements(pass);
    pass.area = viscousArea_.data();
}

void groundContact::present(lpfPairs::penaltyPass& pass) const
{
    presentElements(pass);
    pass.area = area_.data();
}

groundHit groundContact::signedDistance(const point& x, scalar radius) const
{
    groundHit hit = ground_.signedDistance(x, radius);
    if (hit.border && planeThickness_ > 0)
    {
        // the plane may lie along an edge of the ground, which has none there
        const vector off = ground_.bounds().centre() - x;
        hit = ground_.signedDistance(
            x + (off & planeNormal_) * planeNormal_, radius
        );
    }
    hit.found = hit.found && !hit.border;
    return hit;
}

} // namespace lpf
} // namespace Foam
