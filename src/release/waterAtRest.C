// SPDX-License-Identifier: GPL-3.0-or-later
#include "waterAtRest.H"
#include "grainsAtRest.H"

namespace Foam
{
namespace lpf
{

namespace
{

// How far over the top of a body another one on it is looked for, over the
// spacing: less than half a spacing, the least body that has particles
constexpr scalar contactGap = 0.25;


//- Add the bodies that stand on top of each other, from the point up
void addOnTop(
    const UList<waterBody>& bodies,
    const point& top,
    labelHashSet& counted,
    const waterScene& scene,
    waterColumn& column
)
{
    const vector up = -scene.g / mag(scene.g);
    const scalar gap = contactGap * scene.spacing;
    const point x = top + gap * up;
    forAll (bodies, o)
    {
        const waterBody& other = bodies[o];
        const scalar depth =
            counted.found(o) || !other.isFull() ? -1 : other.region->depthAt(x);
        if (depth >= 0)
        {
            const vector e3 = other.axes.row(2);
            counted.insert(o);
            column.height += gap + depth;
            column.pressure +=
                scene.rho * (mag(scene.g) * gap - (scene.g & e3) * depth);
            addOnTop(bodies, x + depth * e3, counted, scene, column);
            return;
        }
    }
}

} // namespace


waterColumn waterOver(
    const UList<waterBody>& bodies,
    const label b,
    const seed& s,
    const waterScene& scene
)
{
    const waterBody& body = bodies[b];
    waterColumn column;
    column.height = s.depth;
    if (body.isFull())
    {
        const vector e3 = body.axes.row(2);
        labelHashSet counted;
        counted.insert(b);
        column.pressure = -scene.rho * (scene.g & e3) * s.depth;
        addOnTop(bodies, s.x + s.depth * e3, counted, scene, column);
    }
    return column;
}


cloudState waterAtRest(const UList<waterBody>& bodies, const waterScene& scene)
{
    label n = 0;
    for (const waterBody& body : bodies)
    {
        n += body.seeds.size();
    }
    cloudState cloud;
    cloud.positions.resize(n);
    labelField id(n), zone(n);
    scalarField mass(n), alpha(n), p(n), S(n);
    vectorField U(n);
    label i = 0;
    forAll (bodies, b)
    {
        const waterBody& body = bodies[b];
        for (const seed& s : body.seeds)
        {
            cloud.positions[i] = s.x;
            id[i] = i;
            zone[i] = body.release;
            mass[i] = body.mass / body.seeds.size();
            alpha[i] = body.saturation * body.porosity;
            S[i] = body.saturation;
            p[i] = waterOver(bodies, b, s, scene).pressure;
            U[i] = body.velocity;
            ++i;
        }
    }
    cloud.labels.set("id", id);
    cloud.labels.set("zone", zone);
    cloud.scalars.set("mass", mass);
    cloud.scalars.set("alpha", alpha);
    cloud.scalars.set("h", scalarField(n, smoothingRatio * scene.spacing));
    cloud.scalars.set("p", p);
    cloud.scalars.set("S", S);
    cloud.vectors.set("U", U);
    return cloud;
}

} // namespace lpf
} // namespace Foam
