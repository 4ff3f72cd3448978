// SPDX-License-Identifier: GPL-3.0-or-later
#include "waterStore.H"

#include <algorithm>

namespace Foam
{
namespace lpf
{

void waterStore::resize(int n)
{
    particleStore::resize(n);
    for (auto* f : {&rho, &p, &rate, &curl, &diffusion, &toGround})
    {
        f->resize(n);
    }
    std::fill_n(toGround.data(), n, 0.0);
    lpf::resize(friction, n);
    if (withLag_)
    {
        lag.resize(n);
    }
    if (withGrains_)
    {
        theta.resize(n);
        meanTheta.resize(n);
        std::fill_n(meanTheta.data(), n, 0.0);
        lpf::resize(flux, n);
        lpf::resize(gradPForce, n);
        lpf::resize(drag, n);
    }
    if (keepsStart_)
    {
        rhoStart.resize(n);
    }
}

std::size_t waterStore::bytes() const
{
    return particleStore::bytes() + 6 * rho.bytes() + lpf::bytes(friction)
         + 2 * theta.bytes() + lpf::bytes(flux) + lpf::bytes(gradPForce)
         + lpf::bytes(drag) + rhoStart.bytes() + lag.bytes();
}

void waterStore::permute(const indexArray& order)
{
    particleStore::permute(order);
    permute(rho, order);
    permute(p, order);
    permute(toGround, order);
    if (withLag_)
    {
        permute(lag, order);
    }
    if (withGrains_)
    {
        permute(theta, order);
        permute(meanTheta, order);
        permute(drag, order);
    }
    if (keepsStart_)
    {
        permute(rhoStart, order);
    }
}

void waterStore::fromCloud(const cloudState& cloud)
{
    readShared(cloud);
    // what a start does not have is 0
    const auto read = [&](realArray& to, const word& field)
    {
        const auto from = cloud.scalars.cfind(field);
        if (from.found())
        {
            std::copy_n(from.val().cdata(), size_, to.data());
        }
        else
        {
            std::fill_n(to.data(), size_, 0.0);
        }
    };
    read(p, "p");
    read(rho, "rho");
    read(toGround, "toGround");
    if (withLag_)
    {
        read(lag, "lag");
    }
    if (withGrains_)
    {
        read(meanTheta, "meanTheta");
    }
}

cloudState waterStore::toCloud(scalar rho0, scalar h) const
{
    cloudState cloud;
    writeShared(cloud, h);
    scalarField density(size_), pressure(size_), S(size_);
    scalarField alpha(size_);

    for (int i = 0; i < size_; ++i)
    {
        density[i] = rho[i];
        pressure[i] = p[i];
        S[i] = min(scalar(1), rho[i] / rho0);
        alpha[i] = S[i];
    }
    cloud.scalars.set("rho", density);
    cloud.scalars.set("p", pressure);
    cloud.scalars.set("S", S);
    cloud.scalars.set("toGround", toField(toGround, size_));
    if (withLag_)
    {
        cloud.scalars.set("lag", toField(lag, size_));
    }
    if (withGrains_)
    {
        for (int i = 0; i < size_; ++i)
        {
            alpha[i] *= theta[i];
        }
        cloud.scalars.set("meanTheta", toField(meanTheta, size_));
        cloud.vectors.set("drag", toField(drag, size_));
    }
    cloud.scalars.set("alpha", alpha);
    return cloud;
}

} // namespace lpf
} // namespace Foam
