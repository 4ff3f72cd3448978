# SPDX-License-Identifier: GPL-3.0-or-later
"""Collapse of dry columns against experiments: runout, height, time at 99 % of
the runout. One set of parameters and one scheme for all.

Lube, Huppert, Sparks, Hallworth, Freundt: J. Fluid Mech. 508 (2004) 175 (round),
Phys. Rev. E 72 (2005) 041301 (plane). Lajeunesse, Mangeney-Castelnau,
Vilotte, Phys. Fluids 16 (2004) 2371 (round); Lajeunesse, Monnier, Homsy,
Phys. Fluids 17 (2005) 103302 (plane). Where two of them, or two branches of one,
differ, the reference is the band between them.
"""
import math

from planeScene import G, Scene, front, mean, polygon, thickness
from verify import Measured, Verification

H = 0.1
SAND = {"muS": 0.625, "mu2": 0.9, "I0": 0.28, "nu": 0.3}
# as rough as sand that flows: sand gives way before it slips
ZONES = "floor { friction Coulomb; mu %g; } wall { friction none; }" % SAND["mu2"]


def outside(value, low, high):
    """Distance from the band over its nearer end, 0 within"""
    if value < low:
        return value / low - 1
    return value / high - 1 if value > high else 0.0


def arrival(times, fronts, start):
    """When the front has made 99 % of its way"""
    goal = start + 0.99 * (fronts[-1] - start)
    for (s, x), (t, y) in zip(
            zip(times, fronts), zip(times[1:], fronts[1:])):
        if x < goal <= y:
            return s + (t - s) * (goal - x) / (y - x)
    return times[-1]


def spread(ends, c):
    """Mean of one figure, and its range where there are several starts"""
    values = [e[c] for e in ends]
    text = "%.3g" % mean(values)
    return text if len(ends) == 1 else "%s, %.3g to %.3g" % (
        text, min(values), max(values))


class Plane(Verification):
    """The mean of three starts that differ by rounding, as the front of each is
    where its foremost particle came to lie"""

    of = "layers in h0"
    starts = 3
    axes = ("x/d0", "h/d0")
    a, runout, height, unit_time = 1.0, (1.2, 1.2), (1.0, 1.0), 3.3
    bounds = {"runout": 0.15, "height": 0.10, "time": 0.25}

    def measure(self, layers, grains=None, solution=""):
        d0, dx = H / self.a, H / layers
        scene = Scene(
            dx=dx, grains={**SAND, **(grains or {})},
            solution=solution, maxSpeed=1.4, log=200,
            zones=ZONES)
        reach = d0 * (1 + 2 * self.runout[1]) + H
        scene.ground = scene.floor(0, reach) + scene.wall("wall", 0, 1, 2 * H)
        scene.release = scene.box(
            "sand", 0, d0, 0, H, "grains { solidFraction 0.6; }")
        return self.result(scene, d0, layers)

    def front(self, case, time, dx):
        return front(case, time, "grains", dx)

    def shape(self, case, time, dx, far):
        edges = [2 * dx * k for k in range(int(far / dx / 2) + 4)]
        found = thickness(case, time, "grains", edges, dx ** 2)
        return [0.5 * (a + b) for a, b in zip(edges, edges[1:])], found

    def from_axis(self, x):
        return x[0]

    def end(self, scene, d0, name):
        """(runout/d0, height/d0, time at 99 % of the runout, shape) of one run"""
        unit, dx = math.sqrt(H / G), scene.dx
        scene.end, scene.writes = 7 * unit, 70
        case = scene.run(name)
        times = [float(t) / unit for t in case.times()]
        fronts = [self.front(case, t, dx) for t in case.times()]
        last = case.times()[-1]
        # the top of the uppermost particles beside the wall or the axis
        height = max(
            x[2] for x in case.field(last, "positions")
            if self.from_axis(x) < max(0.2 * d0, 2 * dx)) + 0.5 * dx
        x, shape = self.shape(case, last, dx, fronts[-1])
        return ((fronts[-1] - d0) / d0, height / d0, arrival(times, fronts, d0),
                ([v / d0 for v in x], [s / d0 for s in shape]))

    def result(self, scene, d0, layers):
        ends = []
        for k in range(self.starts):
            # as much as rounding: a front is where single particles lie
            scene.gravity = G * (1 + 1e-9 * k)
            ends.append(self.end(scene, d0, "%s%d.%d" % (self.name, layers, k)))
        runout, height, time = (mean(e[c] for e in ends) for c in range(3))
        return Measured(
            {"runout": outside(runout, *self.runout),
             "height": outside(height, *self.height),
             "time": time / self.unit_time - 1},
            {"": ends[0][3],
             "reference height": ([0, 0.2], [self.height[0]] * 2),
             "reference runout": ([1 + self.runout[0]] * 2,
                                  [0, 0.2 * self.height[0]])},
            {"runout": "runout " + spread(ends, 0),
             "height": "height " + spread(ends, 1),
             "time": spread(ends, 2) + " sqrt(h0/g)"})


def plane(a, low, high, heights, bound=0.15):
    class Column(Plane):
        name = "column.plane%g" % a
        reference = (
            "runout/d0 %s, height/d0 %s, 99 %% of the runout at 3.3 sqrt(h0/g): "
            "Lube 2005, Lajeunesse 2005"
            % (" to ".join("%.3g" % v for v in sorted({low, high})),
               " to ".join("%.3g" % v for v in sorted(set(heights)))))
        runout, height = (low, high), heights
        bounds = {**Plane.bounds, "runout": bound}

    Column.a = a
    return Column


PLANE = (
    plane(0.5, 0.6, 0.6, (0.5, 0.5)),
    plane(1, 1.2, 1.2, (1.0, 1.0)),
    # between the branches 1.2 a and 1.9 a^(2/3), 0.65 a^0.4 and a^(1/3)
    plane(2, 2.4, 1.9 * 2 ** (2 / 3), (0.65 * 2 ** 0.4, 2 ** (1 / 3)), 0),
    plane(4, 1.9 * 4 ** (2 / 3), 1.9 * 4 ** (2 / 3),
          (0.65 * 4 ** 0.4, 4 ** (1 / 3))),
)
PLANE[1].negatives = {
    "internal friction of 0.4": ({"grains": {"muS": 0.4, "mu2": 0.4}}, "runout", 20)}


class Round(Plane):
    """A quarter of a round column in a corner of walls without friction"""

    axes = ("r/r0", "h/r0")
    unit_time, starts = 3.0, 1
    findings = {"runout": (
        "less with refinement: the rim is thinner than half a spacing, where the "
        "front is taken.")}

    def measure(self, layers, grains=None, solution=""):
        r0, dx = H / self.a, H / layers
        reach = r0 * (1 + 1.6 * self.runout[1]) + 4 * dx
        scene = Scene(
            dx=dx, width=2 * reach, corner=0, grains={**SAND, **(grains or {})},
            solution=solution, maxSpeed=1.4, log=200,
            zones=ZONES)
        scene.ground = polygon("floor", "floor", (
            (0, 0, 0), (reach, 0, 0), (reach, reach, 0), (0, reach, 0)))
        scene.ground += polygon("wallX", "wall", (
            (0, 0, 0), (0, reach, 0), (0, reach, 2 * H), (0, 0, 2 * H)))
        scene.ground += polygon("wallY", "wall", (
            (0, 0, 0), (0, 0, 2 * H), (reach, 0, 2 * H), (reach, 0, 0)))
        arc = [math.radians(3 * k) for k in range(31)]
        outline = "(0 0 0) " + " ".join(
            "(%.17g %.17g 0)" % (r0 * math.cos(v), r0 * math.sin(v)) for v in arc)
        scene.release = (
            "sand { type tank; box ((0 0 0) (%.17g %.17g %.17g)); level %.17g; "
            "outline (%s); grains { solidFraction 0.6; } }\n"
            % (r0, r0, H, H, outline))
        return self.result(scene, r0, layers)

    def from_axis(self, x):
        return math.hypot(x[0], x[1])

    def shape(self, case, time, dx, far):
        """Thickness in quarter rings of two spacings"""
        volume = [0.0] * (int(far / dx / 2) + 4)
        for x in case.field(time, "positions"):
            k = int(self.from_axis(x) / (2 * dx))
            if k < len(volume):
                volume[k] += dx ** 3
        areas = [math.pi * dx * dx * (2 * k + 1) for k in range(len(volume))]
        return ([dx * (2 * k + 1) for k in range(len(volume))],
                [v / a for v, a in zip(volume, areas)])

    def front(self, case, time, dx):
        far = max(self.from_axis(x) for x in case.field(time, "positions"))
        r, found = self.shape(case, time, dx, far)
        last = max((k for k, t in enumerate(found) if t > 0.5 * dx), default=0)
        here, beyond = found[last], found[last + 1]
        return r[last] + 2 * dx * (here - 0.5 * dx) / (here - beyond)


def round_column(a, reach, heights, resolutions):
    class Column(Round):
        name = "column.round%g" % a
        reference = (
            "runout/r0 %.3g, height/r0 %s, 99 %% of the runout at 3 sqrt(h0/g): "
            "Lube 2004, Lajeunesse 2004"
            % (reach, " to ".join("%.3g" % v for v in sorted(set(heights)))))
        runout, height, layers = (reach, reach), heights, resolutions

    Column.a = a
    return Column


ROUND = (
    round_column(0.55, 1.24 * 0.55, (0.55, 0.55), (9, 14, 24)),
    round_column(0.9, 1.24 * 0.9, (0.74, 0.9), (10, 16, 28)),
    round_column(2.75, 1.6 * 2.75 ** 0.5, (0.74, 0.88 * 2.75 ** (1 / 6)),
                 (20, 30, 45)),
)
CASES = PLANE + ROUND
