# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscous decay of a shear wave in water."""
import math

from planeScene import G, RHO_F, Scene
from verify import Measured, Verification


class ShearWave(Verification):
    """u_x = U sin(2 pi y/L) between cyclic planes in a layer of depth L/2, three
    dimensions: slip floor and free surface have no part in it. Under a tenth of
    gravity: rows of particles that pass each other under pressure resist,
    too, and under all of gravity the wave decays 2 % too fast at 24"""

    name = "shearWave"
    reference = "u_x = U sin(k y) exp(-nu k^2 t), from 0.2 to 1 in nu k^2 t; g/10"
    of = "particles in a wave length"
    bounds = {"rate of decay": 0.02}
    axes = ("nu k^2 t", "amplitude/U")
    layers, judged = (12, 24, 36), 24
    converges = True
    negatives = {
        "viscosity 20 % smaller": ({"factor": 0.8}, "rate of decay", 24)}
    L, speed = 0.2, 0.5

    def measure(self, layers, factor=1.0):
        dx, k = self.L / layers, 2 * math.pi / self.L
        depth = self.L / 2
        # long enough for some sweeps of sound over the depth
        end = 12 * math.sqrt(depth / G)
        nu = 1 / (k * k * end)
        scene = Scene(
            dx=dx, phases="water", width=self.L, log=20, maxSpeed=0.1,
            gravity=G / 10, water="TaitCoeffs { soundSpeed 20; }",
            mu=factor * nu * RHO_F,
            cyclic="x (0 %.17g); y (%.17g %.17g);" % (6 * dx, -self.L / 2, self.L / 2))
        scene.ground = scene.floor(-8 * dx, 16 * dx)
        scene.release = "".join(
            self.strip(scene, n, layers, k, depth) for n in range(layers))
        scene.end, scene.writes = end, 10
        case = scene.run("%s%d" % (self.name, layers))
        return self.decay(case, k, 1 / end)

    def strip(self, scene, n, layers, k, depth):
        """One row of particles with its own speed"""
        y = -0.5 * self.L + n * scene.dx
        return (
            "strip%d { type box; corner (0 %.17g 0); edges ((%.17g 0 0) "
            "(0 %.17g 0) (0 0 %.17g)); velocity (%.17g 0 0); water {} }\n"
            % (n, y, 6 * scene.dx, scene.dx, depth,
               self.speed * math.sin(k * (y + 0.5 * scene.dx))))

    def decay(self, case, k, rate):
        times, amplitude = [], []
        for time in case.times():
            x = case.field(time, "positions", "water")
            u = case.field(time, "U", "water")
            sines = [math.sin(k * p[1]) for p in x]
            fit = sum(v[0] * s for v, s in zip(u, sines)) / sum(
                s * s for s in sines)
            times.append(rate * float(time))
            amplitude.append(fit / self.speed)
        first = next(i for i, t in enumerate(times) if t > 0.19)
        found = math.log(amplitude[first] / amplitude[-1]) / (
            times[-1] - times[first])
        exact = [k / 20 for k in range(21)]
        return Measured(
            {"rate of decay": found - 1},
            {"reference": (exact, [math.exp(-t) for t in exact]),
             "": (times, amplitude)})


CASES = (ShearWave,)
