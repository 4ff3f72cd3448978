// SPDX-License-Identifier: GPL-3.0-or-later
#include "waterStore.H"

namespace Foam
{
namespace lpf
{

void waterStore::resize(int n)
{
    particleStore::resize(n);
    for (auto* f : {&rho, &p, &rate, &curl, &diffusion, &artificial, &viscous})
    {
        f->resize(n);
    }
    lpf::resize(friction, n);
    if (withGrains_)
    {
        theta.resize(n);
        lpf::resize(drag, n);
    }
}

std::size_t waterStore::bytes() const
{
    return particleStore::bytes() + 7 * rho.bytes() + lpf::bytes(friction)
         + theta.bytes() + lpf::bytes(drag);
}

void waterStore::permute(const indexArray& order)
{
    particleStore::permute(order);
    permute(rho, order);
    permute(p, order);
    if (withGrains_)
    {
        permute(theta, order);
        permute(drag, order);
    }
}

void waterStore::fromCloud(const cloudState& cloud)
{
    resize(cloud.size());
    const bool continued = cloud.scalars.found("rho");
    for (int i = 0; i < size_; ++i)
    {
        set(x, i, cloud.positions[i]);
        set(U, i, cloud.vectors["U"][i]);
        mass[i] = cloud.scalars["mass"][i];
        p[i] = cloud.scalars["p"][i];
        rho[i] = continued ? cloud.scalars["rho"][i] : 0;
        id[i] = cloud.labels["id"][i];
        zone[i] = cloud.labels["zone"][i];
    }
}

cloudState waterStore::toCloud(scalar rho0, scalar h) const
{
    cloudState cloud;
    cloud.positions = toField(x, size_);
    scalarField m(size_), density(size_), pressure(size_), S(size_);
    scalarField alpha(size_);
    labelField ids(size_), zones(size_);

    for (int i = 0; i < size_; ++i)
    {
        m[i] = mass[i];
        density[i] = rho[i];
        pressure[i] = p[i];
        S[i] = min(scalar(1), rho[i] / rho0);
        alpha[i] = S[i] * (withGrains_ ? theta[i] : 1);
        ids[i] = id[i];
        zones[i] = zone[i];
    }
    cloud.vectors.set("U", toField(U, size_));
    cloud.scalars.set("mass", m);
    cloud.scalars.set("rho", density);
    cloud.scalars.set("p", pressure);
    cloud.scalars.set("S", S);
    cloud.scalars.set("alpha", alpha);
    cloud.scalars.set("h", scalarField(size_, h));
    cloud.labels.set("id", ids);
    cloud.labels.set("zone", zones);
    if (withGrains_)
    {
        cloud.vectors.set("drag", toField(drag, size_));
    }
    return cloud;
}

} // namespace lpf
} // namespace Foam
