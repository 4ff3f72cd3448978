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
    if (keepsTraction_)
    {
        lpf::resize(traction, n);
    }
    if (wet_)
    {
        lpf::resize(drag, n);
        lpf::resize(gradPForce, n);
    }
    if (keepsStart_)
    {
        lpf::resize(sigmaStart, n);
        rhoStart.resize(n);
        rhoRefStart.resize(n);
    }
}

std::size_t grainStore::bytes() const
{
    return particleStore::bytes() + lpf::bytes(sigma) + lpf::bytes(L)
         + lpf::bytes(B) + rho.bytes() + rhoRef.bytes() + I.bytes()
         + lpf::bytes(traction) + lpf::bytes(drag) + lpf::bytes(gradPForce)
         + lpf::bytes(sigmaStart) + rhoStart.bytes() + rhoRefStart.bytes();
}

void grainStore::permute(const indexArray& order)
{
    particleStore::permute(order);
    permute(sigma, order);
    permute(rho, order);
    permute(rhoRef, order);
    permute(I, order);
    if (keepsTraction_)
    {
        permute(traction, order);
    }
    if (wet_)
    {
        permute(drag, order);
        permute(gradPForce, order);
    }
    if (keepsStart_)
    {
        permute(sigmaStart, order);
        permute(rhoStart, order);
        permute(rhoRefStart, order);
    }
}

void grainStore::fromCloud(const cloudState& cloud, scalar grainDensity)
{
    readShared(cloud);

    const scalarField& alpha = cloud.scalars["alpha"];
    const bool continued = cloud.scalars.found("rhoRef");

    for (int i = 0; i < size_; ++i)
    {
        for (direction c = 0; c < 6; ++c)
        {
            sigma[c][i] = cloud.symmTensors["sigma"][i][c];
        }
        rhoRef[i] =
            continued ? cloud.scalars["rhoRef"][i] : alpha[i] * grainDensity;
        rho[i] = continued ? cloud.scalars["rho"][i] : rhoRef[i];
        I[i] = continued ? cloud.scalars["I"][i] : 0;
        if (keepsTraction_)
        {
            set(traction,
                i,
                continued ? cloud.vectors["traction"][i] : vector(Zero));
        }
    }
}

cloudState grainStore::toCloud(scalar grainDensity, scalar h) const
{
    cloudState cloud;
    writeShared(cloud, h);
    symmTensorField stress(size_);
    scalarField density(size_), reference(size_), alpha(size_);
    scalarField p(size_), inertial(size_);

    for (int i = 0; i < size_; ++i)
    {
        for (direction c = 0; c < 6; ++c)
        {
            stress[i][c] = sigma[c][i];
        }
        p[i] = -tr(stress[i]) / 3;
        density[i] = rho[i];
        reference[i] = rhoRef[i];
        alpha[i] = rho[i] / grainDensity;
        inertial[i] = I[i];
    }

    cloud.symmTensors.set("sigma", stress);
    cloud.scalars.set("rho", density);
    cloud.scalars.set("rhoRef", reference);
    cloud.scalars.set("alpha", alpha);
    cloud.scalars.set("p", p);
    cloud.scalars.set("I", inertial);
    if (keepsTraction_)
    {
        cloud.vectors.set("traction", toField(traction, size_));
    }
    if (wet_)
    {
        cloud.vectors.set("drag", toField(drag, size_));
        cloud.vectors.set("gradPForce", toField(gradPForce, size_));
    }
    return cloud;
}

} // namespace lpf
} // namespace Foam
