// SPDX-License-Identifier: GPL-3.0-or-later
#include "grainStore.H"

namespace Foam
{
namespace lpf
{

void grainStore::resize(int n)
{
    particleStore::resize(n);
    lpf::resize(sigma, n);
    lpf::resize(L, n);
    lpf::resize(B, n);
    for (auto* f : {&rho, &rhoRef, &I})
    {
        f->resize(n);
    }
    if (wet_)
    {
        lpf::resize(drag, n);
        lpf::resize(gradPForce, n);
    }
}

std::size_t grainStore::bytes() const
{
    return particleStore::bytes() + lpf::bytes(sigma) + lpf::bytes(L)
         + lpf::bytes(B) + rho.bytes() + rhoRef.bytes() + I.bytes()
         + lpf::bytes(drag) + lpf::bytes(gradPForce);
}

void grainStore::permute(const indexArray& order)
{
    particleStore::permute(order);
    permute(sigma, order);
    permute(rho, order);
    permute(rhoRef, order);
    permute(I, order);
    if (wet_)
    {
        permute(drag, order);
        permute(gradPForce, order);
    }
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
    symmTensorField stress(size_);
    scalarField m(size_), density(size_), reference(size_), alpha(size_);
    scalarField p(size_), inertial(size_);
    labelField ids(size_), zones(size_);

    for (int i = 0; i < size_; ++i)
    {
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

    cloud.positions = toField(x, size_);
    cloud.vectors.set("U", toField(U, size_));
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
    if (wet_)
    {
        cloud.vectors.set("drag", toField(drag, size_));
        cloud.vectors.set("gradPForce", toField(gradPForce, size_));
    }
    return cloud;
}

} // namespace lpf
} // namespace Foam
