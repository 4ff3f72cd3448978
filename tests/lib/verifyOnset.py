# SPDX-License-Identifier: GPL-3.0-or-later
"""The angle at which a layer on rough ground starts to slide: dry, under water,
and with water that seeps down along the slope. By bisection over runs, each at
its own angle."""
import math

from planeScene import G, RHO_F, RHO_P, Scene, mean
from verify import Measured, Verification
from verifySlabs import RIGID, STILL

XI = 0.5
BULK = XI * RHO_P + (1 - XI) * RHO_F


class Onset(Verification):
    bounds, units = {"angle": 1.0}, {"angle": "deg"}
    layers = (1, 2, 4, 8)
    judged = 4
    axes = ("angle [degrees]", "speed at the end [m/s]")
    phases, content = "grains", "grains { solidFraction %g; }" % XI
    mu, share = 0.4, 1.0
    end = 0.25
    # bisection: below and above the exact angle, which no run hits; and runs
    below, above, runs = 4.3, 3.1, 6

    def exact(self):
        return math.degrees(math.atan(self.mu * self.share))

    def scene(self, layers, degrees, friction):
        dx = 0.01
        L = 8 * dx
        scene = self.of_grains(dx, degrees, friction)
        scene.cyclic = "x (0 %.17g);" % L
        scene.ground = scene.floor(-L, 2 * L)
        scene.release = scene.box("slab", 0, L, 0, layers * dx, self.content)
        return scene

    def of_grains(self, dx, degrees, friction):
        return Scene(
            dx=dx, phases=self.phases, degrees=degrees, log=20, diameter=0.002,
            mu=1e-3, grains=RIGID, solution=STILL, end=self.end,
            zones="floor { friction Coulomb; mu %g; } wall { friction none; }"
            % friction)

    def speed(self, layers, degrees, friction):
        """Down the slope, mean of the grains at the end"""
        scene = self.scene(layers, degrees, friction)
        if "zone wall;" not in scene.ground:
            scene.zones = scene.zones.split("wall")[0]
        case = scene.prepared("%s%d" % (self.name, layers))
        self.balance(case, math.radians(degrees))
        case.run("lpfSolver", "-threads", "1")
        return mean(u[0] for u in case.field(case.times()[-1], "U"))

    def balance(self, case, th):
        """Put into the state at the start what terrainToParticles does not know"""

    def least(self):
        """Speed above which a layer slides: of a block 0.1 degrees over its
        angle"""
        return G * math.radians(0.1) * self.end

    def measure(self, layers, friction=None):
        low, high = self.exact() - self.below, self.exact() + self.above
        points = []
        for _ in range(self.runs):
            angle = 0.5 * (low + high)
            points.append((angle, self.speed(layers, angle, friction or self.mu)))
            if points[-1][1] > self.least():
                high = angle
            else:
                low = angle
        found = 0.5 * (low + high)
        points.sort()
        return Measured(
            {"angle": found - self.exact()},
            {"reference": ([self.exact()] * 2, [0, max(p[1] for p in points)]),
             "": ([p[0] for p in points], [p[1] for p in points])},
            {"angle": "%.2f degrees" % found})


class Dry(Onset):
    name = "onset.dry"
    reference = (
        "tan th = mu, 0.4: %.2f degrees; angle known to 0.06"
        % math.degrees(math.atan(0.4)))
    negatives = {"friction of 0.44": ({"friction": 0.44}, "angle", 4)}


class Seepage(Onset):
    name = "onset.seepage"
    phases = "grains water"
    content = Onset.content + " water { saturation 1; }"
    mu, share = 0.6, 1 - RHO_F / BULK
    reference = (
        "water seeps along the slope through the whole layer: tan th = "
        "(1 - rho_f/rho_m) mu, mu 0.6, rho_m %g: %.2f degrees; "
        "angle known to 0.06" % (
            BULK, math.degrees(math.atan(0.6 * (1 - RHO_F / BULK)))))
    negatives = {"friction of 0.66": ({"friction": 0.66}, "angle", 4)}


class Submerged(Onset):
    """A block of grains on the inclined floor of a tank of water at rest, whose
    surface is level. It starts with the shear stress that holds it there. Without,
    it drops along the slope by what its shear modulus gives, and at 8 layers its
    lowest layer swings on at 0.002 m/s: grains that swing back are pushed on by
    friction, and the block creeps at 21 degrees already"""

    name = "onset.submerged"
    reference = (
        "a block under water at rest: tan th = mu, 0.4: %.2f degrees; angle known "
        "to 0.06" % math.degrees(math.atan(0.4)))
    of, layers = "layers of the block", (2, 4, 8)
    phases = "grains water"
    negatives = {"friction of 0.44": ({"friction": 0.44}, "angle", 4)}
    long, high, tank = 0.08, 0.04, 0.2
    end = 0.3

    def least(self):
        """The weight under water sets it in motion"""
        return super().least() * (1 - RHO_F / BULK)

    def balance(self, case, th):
        weight = XI * (RHO_P - RHO_F) * G * math.sin(th)
        case.change("sigma", lambda s, x: (
            *s[:2], weight * max(0.0, self.high - x[2]), *s[3:]))

    def scene(self, layers, degrees, friction):
        dx = self.high / layers
        scene = self.of_grains(dx, degrees, friction)
        deep = 0.05 + self.tank * math.tan(math.radians(degrees))
        scene.ground = (
            scene.floor(0, self.tank) + scene.wall("upper", 0, 1, 1.5 * deep)
            + scene.wall("lower", self.tank, -1, 1.5 * deep))
        th = math.radians(degrees)
        # height against gravity of the surface, which meets the upper wall
        # 0.05 m over the floor
        level = 0.05 * math.cos(th)
        y = scene.half
        scene.release = (
            "lake { type tank; box ((0 %.17g 0) (%.17g %.17g %.17g)); "
            "level %.17g; water {} }\n" % (-y, self.tank, y, 1.4 * deep, level)
            + scene.box("block", 0.06, 0.06 + self.long, 0, self.high,
                        self.content + " water { saturation 1; }"))
        return scene


CASES = (Dry, Submerged, Seepage)
