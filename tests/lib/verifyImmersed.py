# SPDX-License-Identifier: GPL-3.0-or-later
"""Columns of glass beads that collapse in a viscous liquid, loose and dense, at the
size of the experiment, so that all numbers without dimension are its own.

L. Rondon, O. Pouliquen, P. Aussillous, Phys. Fluids 23 (2011) 073301; front and
pressure against time as read off its figures in the tutorial 2DCollapse of sedFoam.
Beads: M. Pailha, O. Pouliquen, J. Fluid Mech. 633 (2009) 115, measured on slopes:
friction 0.415 + 90.5 J, phi_eq = 0.582 - 25 J, rate 4.09. Nothing is fitted here.
"""
from planeScene import G, Scene, front, mean
from verify import Measured, Verification

# Beads of 225 micrometres in a liquid of 12 mPa s
GLASS, LIQUID, MU, DIAMETER = 2500.0, 1010.0, 0.012, 2.25e-4
# (mu2 - muS)/J0 is the 90.5 of small J
FRICTION = {"muS": 0.415, "mu2": 0.765, "J0": 0.0039, "fluidViscosity": MU,
            "nu": 0.36, "stiffness": 10}
DILATANCY = "linear; linearCoeffs { phiC 0.582; slope 25; rate 4.09; }"
LENGTH, DEEP = 0.06, 0.07

REFERENCE = (
    "Rondon 2011: beads of 225 micrometres, solid fraction %s, in a liquid of 12 mPa s "
    "0.07 m deep; front, largest error at the times it was read off; excess pressure "
    "0.02 m from the wall, mean of %s s, and the share of the time from 0.1 to 1 s "
    "in which its sign is wrong: the column falls, before the first reading. Friction "
    "and dilatancy of Pailha and Pouliquen 2009")


def between(points, t):
    """Linear in t"""
    for (s, a), (u, b) in zip(points, points[1:]):
        if s <= t <= u:
            return a + (b - a) * (t - s) / (u - s)
    raise ValueError("no figure at %g s" % t)


class Immersed(Verification):
    of = "layers"
    bounds = {"wrong sign": 0.1, "pressure": 0.5, "front": 0.2}
    axes = ("t [s]", "x/L; excess pressure [100 Pa]")
    phi, high, tank, end = 0.55, 0.048, 0.25, 2.0
    fronts, pressures = (), ()  # (t [s], x [m]), (t [s], P [Pa])
    findings = {"pressure": (
        "it falls off with the speed of the grains: the law changes their packing "
        "where they shear and nowhere else, so that loose grains bear as soon as "
        "they stop. In the experiment they go on to settle and keep the pressure for "
        "ten seconds. While the column falls it is 100 to 200 Pa, loose, and -100 to "
        "-170 Pa, dense, of which nothing was read off. Without dilatancy it is negative in "
        "both (-20 Pa): taking its side away unloads the column, so that the sign of "
        "the loose one tells.")}
    # whose mean is compared [s]
    window = (1.15, 2.0)

    def scene(self, layers, dilatancy):
        dx = self.high / layers
        long = round(LENGTH / dx) * dx
        wide, deep = round(self.tank / dx) * dx, round(DEEP / dx) * dx
        scene = Scene(
            dx=dx, phases="grains water", mu=MU, diameter=DIAMETER,
            rhoWater=LIQUID, rhoGrains=GLASS, rheology="muJ", maxSpeed=0.3,
            grains={**FRICTION, "dilatancy": dilatancy}, end=self.end, writes=40,
            log=2000,
            # as where there is a dilatancy, so that the control differs by that
            solution="bulkDamping 0.1; water { viscosityIntegration implicit; "
            "groundLag 0; }",
            zones="floor { friction Coulomb; mu 0.415; waterFriction noSlip; } "
            "wall { friction none; }")
        scene.ground = (
            scene.floor(0, wide) + scene.wall("left", 0, 1, 1.5 * deep)
            + scene.wall("right", wide, -1, 1.5 * deep))
        wet = "grains { solidFraction %g; } water { saturation 1; }" % self.phi
        scene.release = (
            scene.box("column", 0, long, 0, self.high, wet)
            + scene.box("above", 0, long, self.high, deep, "water {}")
            + scene.box("lake", long, wide, 0, deep, "water {}"))
        return scene

    def excess(self, case, time):
        """Under the column, 0.02 m from the wall, over that of the far liquid"""
        there, far = [], []
        for x, p in zip(case.field(time, "positions", "water"),
                        case.field(time, "p", "water")):
            if x[2] < 0.015 and 0.01 < x[0] < 0.03:
                there.append(p + LIQUID * G * x[2])
            elif x[0] > self.tank - 0.03 and x[2] < 0.04:
                far.append(p + LIQUID * G * x[2])
        return mean(there) - mean(far)

    def measure(self, layers, dilatancy=DILATANCY):
        scene = self.scene(layers, dilatancy)
        case = scene.run("%s%d" % (self.name, layers))
        times = [float(t) for t in case.times()]
        x = [front(case, t, "grains", scene.dx) for t in case.times()]
        P = [self.excess(case, t) for t in case.times()]
        found = list(zip(times, x))
        off = [between(found, t) / r - 1 for t, r in self.fronts]
        during = [k for k, t in enumerate(times)
                  if self.window[0] <= t <= self.window[1]]
        pressure = mean(P[k] for k in during)
        published = mean(between(self.pressures, times[k]) for k in during)
        wrong = mean(
            p * published < 0 for t, p in zip(times, P) if 0.099 < t < 1.001)
        return Measured(
            {"wrong sign": wrong, "pressure": pressure / published - 1,
             "front": max(off, key=abs)},
            {"reference x": ([t for t, _ in self.fronts],
                             [r / LENGTH for _, r in self.fronts]),
             "reference P": ([t for t, _ in self.pressures],
                             [p / 100 for _, p in self.pressures]),
             "x": (times, [v / LENGTH for v in x]),
             "P": (times, [p / 100 for p in P])},
            {"pressure": "%.0f Pa, published %.0f" % (pressure, published),
             "front": "%.3f m at the end" % x[-1]})


class Loose(Immersed):
    name = "immersed.loose"
    layers = (8, 12, 16)
    negatives = {"no dilatancy": ({"dilatancy": "none"}, "wrong sign", 8)}
    fronts = ((0.636, 0.1627), (1.314, 0.1972), (1.907, 0.2030))
    pressures = ((1.127, 133.3), (1.972, 144.1), (3.38, 126.5))
    reference = REFERENCE % ("0.55 in a column of 0.06 x 0.048 m", "1.15 to 2")


class Dense(Immersed):
    name = "immersed.dense"
    phi, high, tank = 0.60, 0.042, 0.17
    layers = (5, 7, 10)
    fronts = ((0.551, 0.0877), (1.229, 0.0836), (1.907, 0.0928), (2.542, 0.0952))
    pressures = ((1.127, -126.0), (1.972, -63.9), (3.38, -52.3))
    end = 2.6
    window = (1.15, 2.6)
    reference = REFERENCE % ("0.60 in a column of 0.06 x 0.042 m", "1.15 to 2.6")


CASES = (Loose, Dense)
