// SPDX-License-Identifier: GPL-3.0-or-later
#include "grainStore.H"

#include "orderedSum.H"

#include "IOstreams.H"

namespace Foam
{
namespace lpf
{

namespace
{

//- The arrays that a sort keeps, with one function for all
template<class Store, class Task>
void forState(Store& s, const Task& task)
{
    for (auto* group : {&s.x, &s.U})
    {
        for (auto& component : *group)
        {
            task(component);
        }
    }
    for (auto& component : s.sigma)
    {
        task(component);
    }
    for (auto* field : {&s.mass, &s.rho, &s.rhoRef, &s.I})
    {
        task(*field);
    }
}

template<class Array>
void gather(Array& field, Array& spare, const indexArray& order, int n)
{
    lpfPairs::forChunks(
        n,
        [&](int begin, int end, int)
        {
            for (int i = begin; i < end; ++i)
            {
                spare[i] = field[order[i]];
            }
        }
    );
    field.swap(spare);
}

} // namespace

void grainStore::resize(int n)
{
    size_ = n;
    forState(*this, [n](realArray& f) { f.resize(n); });
    for (auto& f : L)
    {
        f.resize(n);
    }
    for (auto& f : B)
    {
        f.resize(n);
    }
    for (auto& f : a)
    {
        f.resize(n);
    }
    for (auto* f : {&V, &spare_})
    {
        f->resize(n);
    }
    for (auto* f : {&id, &zone, &spareIndex_})
    {
        f->resize(n);
    }
}

std::size_t grainStore::bytes() const
{
    std::size_t total = V.bytes() + spare_.bytes() + spareIndex_.bytes()
                      + id.bytes() + zone.bytes();
    forState(*this, [&](const realArray& f) { total += f.bytes(); });
    for (const auto& f : a)
    {
        total += f.bytes();
    }
    for (const auto& f : L)
    {
        total += f.bytes();
    }
    for (const auto& f : B)
    {
        total += f.bytes();
    }
    return total;
}

void grainStore::permute(const indexArray& order)
{
    forState(*this, [&](realArray& f) { gather(f, spare_, order, size_); });
    gather(id, spareIndex_, order, size_);
    gather(zone, spareIndex_, order, size_);
}

void grainStore::truncate(int n)
{
    size_ = n;
}

void grainStore::fromCloud(const cloudState& cloud, scalar grainDensity)
{
    resize(cloud.size());

    const scalarField& alpha = cloud.scalars["alpha"];
    const bool continued = cloud.scalars.found("rhoRef");

    for (int i = 0; i < size_; ++i)
    {
        set(x, i, cloud.positions[i]);
        set(U, i, cloud.vectors["U"][i]);
        for (direction c = 0; c < 6; ++c)
        {
            sigma[c][i] = cloud.symmTensors["sigma"][i][c];
        }
        mass[i] = cloud.scalars["mass"][i];
        rhoRef[i] =
            continued ? cloud.scalars["rhoRef"][i] : alpha[i] * grainDensity;
        rho[i] = continued ? cloud.scalars["rho"][i] : rhoRef[i];
        I[i] = continued ? cloud.scalars["I"][i] : 0;
        id[i] = cloud.labels["id"][i];
        zone[i] = cloud.labels["zone"][i];
    }
}

cloudState grainStore::toCloud(scalar grainDensity, scalar h) const
{
    cloudState cloud;
    cloud.positions.resize(size_);
    vectorField velocity(size_);
    symmTensorField stress(size_);
    scalarField m(size_), density(size_), reference(size_), alpha(size_);
    scalarField p(size_), inertial(size_);
    labelField ids(size_), zones(size_);

    for (int i = 0; i < size_; ++i)
    {
        cloud.positions[i] = at(x, i);
        velocity[i] = at(U, i);
        for (direction c = 0; c < 6; ++c)
        {
            stress[i][c] = sigma[c][i];
        }
        p[i] = -tr(stress[i]) / 3;
        m[i] = mass[i];
        density[i] = rho[i];
        reference[i] = rhoRef[i];
        alpha[i] = rho[i] / grainDensity;
        inertial[i] = I[i];
        ids[i] = id[i];
        zones[i] = zone[i];
    }

    cloud.vectors.set("U", velocity);
    cloud.symmTensors.set("sigma", stress);
    cloud.scalars.set("mass", m);
    cloud.scalars.set("rho", density);
    cloud.scalars.set("rhoRef", reference);
    cloud.scalars.set("alpha", alpha);
    cloud.scalars.set("h", scalarField(size_, h));
    cloud.scalars.set("p", p);
    cloud.scalars.set("I", inertial);
    cloud.labels.set("id", ids);
    cloud.labels.set("zone", zones);
    return cloud;
}

} // namespace lpf
} // namespace Foam
