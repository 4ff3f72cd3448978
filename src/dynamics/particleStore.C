// SPDX-License-Identifier: GPL-3.0-or-later
#include "particleStore.H"

#include "orderedSum.H"

namespace Foam
{
namespace lpf
{

namespace
{

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

void particleStore::permute(realArray& field, const indexArray& order)
{
    gather(field, V, order, size_);
}

void particleStore::permute(indexArray& field, const indexArray& order)
{
    gather(field, spare_, order, size_);
}

void particleStore::resize(int n)
{
    size_ = n;
    for (auto* group : {&x, &U, &a})
    {
        lpf::resize(*group, n);
    }
    for (auto* f : {&mass, &V})
    {
        f->resize(n);
    }
    for (auto* f : {&id, &zone, &spare_})
    {
        f->resize(n);
    }
    if (keepsStart_)
    {
        lpf::resize(UStart, n);
    }
}

std::size_t particleStore::bytes() const
{
    return lpf::bytes(x) + lpf::bytes(U) + lpf::bytes(a) + mass.bytes()
         + V.bytes() + spare_.bytes() + id.bytes() + zone.bytes()
         + lpf::bytes(UStart);
}

void particleStore::permute(const indexArray& order)
{
    permute(x, order);
    permute(U, order);
    permute(mass, order);
    permute(id, order);
    permute(zone, order);
    if (keepsStart_)
    {
        permute(UStart, order);
    }
}

void particleStore::readShared(const cloudState& cloud)
{
    resize(cloud.size());
    for (int i = 0; i < size_; ++i)
    {
        set(x, i, cloud.positions[i]);
        set(U, i, cloud.vectors["U"][i]);
        mass[i] = cloud.scalars["mass"][i];
        id[i] = cloud.labels["id"][i];
        zone[i] = cloud.labels["zone"][i];
    }
}

void particleStore::writeShared(cloudState& cloud, scalar h) const
{
    scalarField m(size_);
    labelField ids(size_), zones(size_);
    for (int i = 0; i < size_; ++i)
    {
        m[i] = mass[i];
        ids[i] = id[i];
        zones[i] = zone[i];
    }
    cloud.positions = toField(x, size_);
    cloud.vectors.set("U", toField(U, size_));
    cloud.scalars.set("mass", m);
    cloud.scalars.set("h", scalarField(size_, h));
    cloud.labels.set("id", ids);
    cloud.labels.set("zone", zones);
}

} // namespace lpf
} // namespace Foam
