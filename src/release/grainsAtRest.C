// SPDX-License-Identifier: GPL-3.0-or-later
#include "grainsAtRest.H"

namespace Foam
{
namespace lpf
{

namespace
{

symmTensor
stressAtRest(const releaseBody& body, const vector& g, const scalar depth)
{
    const vector e3 = body.axes.row(2);
    const scalar bulkDensity =
        max(body.mass / body.volume - body.buoyancy, scalar(0));
    const scalar vertical = -bulkDensity * (-(g & e3)) * depth;
    return vertical
         * (body.K0 * symmTensor(symmTensor::I) + (1 - body.K0) * sqr(e3));
}

} // namespace


cloudState grainsAtRest(
    const UList<releaseBody>& bodies,
    const grainMaterial& material,
    const vector& g,
    const scalar spacing
)
{
    label n = 0;
    for (const releaseBody& body : bodies)
    {
        n += body.seeds.size();
    }
    cloudState cloud;
    cloud.positions.resize(n);
    labelField id(n), zone(n);
    scalarField mass(n), alpha(n), p(n);
    vectorField U(n);
    symmTensorField sigma(n, Zero);
    label i = 0;
    for (const releaseBody& body : bodies)
    {
        for (const seed& s : body.seeds)
        {
            cloud.positions[i] = s.x;
            id[i] = i;
            zone[i] = body.release;
            mass[i] = body.mass / body.seeds.size();
            alpha[i] = body.solidFraction;
            U[i] = body.velocity;
            if (material.geostatic)
            {
                sigma[i] = stressAtRest(body, g, s.depth);
            }
            p[i] = -tr(sigma[i]) / 3;
            ++i;
        }
    }
    cloud.labels.set("id", id);
    cloud.labels.set("zone", zone);
    cloud.scalars.set("mass", mass);
    cloud.scalars.set("alpha", alpha);
    cloud.scalars.set("h", scalarField(n, smoothingRatio * spacing));
    cloud.scalars.set("p", p);
    cloud.scalars.set("I", scalarField(n, Zero));
    cloud.vectors.set("U", U);
    cloud.symmTensors.set("sigma", sigma);
    return cloud;
}

} // namespace lpf
} // namespace Foam
