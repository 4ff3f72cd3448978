# SPDX-License-Identifier: GPL-3.0-or-later
"""Viscous layers that start to flow over ground to which water sticks: down an
incline with a free surface, and between two plates. The ground is level and
gravity turned, so that pressure rises with depth and the flow has none of its
own along x."""
import math
import random

from planeScene import G, RHO_F, Scene, mean, rms
from verify import Measured, Verification

H, DEGREES, NU = 0.1, 30.0, 0.3
DRIVE = G * math.sin(math.radians(DEGREES))
# [m/s]: three times that of soundSpeed auto. The answers are of a liquid that does
# not give way; water that is denser by P/(rho c^2), 0.2 % at 20 m/s, flows as much
# too fast
SOUND = 60
# of the writes, nu t/H^2: the start, on the way, nearly steady
TIMES = (0.1, 0.3, 1.0)


def incline(z, t, nu):
    """Speed at the height z: steady, and the modes that die away, of the layer
    with u = 0 at the ground and du/dz = 0 at the surface"""
    u = z / H - 0.5 * (z / H) ** 2
    for n in range(60):
        k = (n + 0.5) * math.pi
        u -= 2 / k ** 3 * math.sin(k * z / H) * math.exp(-k * k * nu * t / H ** 2)
    return DRIVE * H * H / nu * u


def plates(z, t, nu):
    """As incline(), with u = 0 at z = H, too"""
    u = 0.5 * z / H * (1 - z / H)
    for n in range(60):
        k = (2 * n + 1) * math.pi
        u -= 4 / k ** 3 * math.sin(k * z / H) * math.exp(-k * k * nu * t / H ** 2)
    return DRIVE * H * H / nu * u


class Viscous(Verification):
    bounds = {"velocity": 0.02, "flux": 0.02}
    judged = 20
    orders = {"velocity": 1.8, "flux": 1.8}
    own_limit = ("flux",)
    axes = ("u/u_max", "z/H")
    exact = staticmethod(incline)
    nu = NU
    integration = "explicit"
    disorder = 0.0  # largest displacement of a particle over the spacing
    ceiling = False
    packs = ""

    def width(self, dx):
        return 8 * dx

    @property
    def unit(self):
        """Of time"""
        return H * H / self.nu

    @property
    def fastest(self):
        return self.exact(H / (1 + self.ceiling), 1e9, self.nu)

    def scene(self, layers, factor):
        dx = H / layers
        L = self.width(dx)
        scene = Scene(
            dx=dx, phases="water", degrees=DEGREES, maxSpeed=self.fastest,
            mu=factor * self.nu * RHO_F, log=500,
            water="TaitCoeffs { soundSpeed %g; }" % SOUND, cyclic="x (0 %.17g);" % L,
            zones=" ".join(
                "%s { friction none; waterFriction noSlip; }" % zone
                for zone in ("floor", "ceiling")[:1 + self.ceiling]),
            solution="water { artificialViscosity 0; %sviscosityIntegration %s; }"
            % (self.packs, self.integration))
        scene.ground = scene.floor(-8 * dx, L + 8 * dx)
        if self.ceiling:
            scene.ground += scene.ceiling(-8 * dx, L + 8 * dx, H)
        scene.release = scene.box("layer", 0, L, 0, H, "water {}")
        scene.end, scene.writes = TIMES[-1] * self.unit, 10
        return scene

    def measure(self, layers, factor=1.0):
        scene = self.scene(layers, factor)
        case = scene.prepared("%s%d" % (self.name, layers))
        if self.disorder:
            self.disturb(case, scene.dx)
        if self.ceiling:
            # water has no suction: without it the ceiling lets go of it
            case.change("p", lambda p, _: p + 0.5 * RHO_F * G * H, "water")
        case.run("lpfSolver", "-threads", "1")
        return self.compared(case, layers == self.layers[-1])

    def disturb(self, case, dx):
        generator, a = random.Random(1), self.disorder * dx
        case.change("positions", lambda x, _: (
            x[0] + generator.uniform(-a, a), x[1],
            x[2] + generator.uniform(-a, a)), "water")

    def compared(self, case, shown):
        off, curves, notes = [], {}, []
        heights = [k * H / 40 for k in range(41)]
        for share in TIMES:
            time = min(case.times(),
                       key=lambda t: abs(float(t) - share * self.unit))
            x = case.field(time, "positions", "water")
            u = case.field(time, "U", "water")
            t = case.time_of_velocity(time)
            here = [(b[0] - self.exact(min(a[2], H), t, self.nu)) / self.fastest
                    for a, b in zip(x, u)]
            off += here
            notes.append("%.3g %%" % (100 * rms(here)))
            word = "%g H2/nu" % share
            curves["reference " + word] = (
                [self.exact(z, t, self.nu) / self.fastest for z in heights],
                [z / H for z in heights])
            points = sorted((a[2] / H, b[0] / self.fastest) for a, b in zip(x, u))
            curves[word] = ([v for _, v in points], [z for z, _ in points])
        return Measured(
            {"velocity": rms(off), "flux": mean(off)}, curves if shown else {},
            {"velocity": "%s in time" % ", ".join(notes),
             "flux": "%+.3f %%" % (100 * mean(off))})


def described(case, what):
    return (
        "series of the flow that starts %s; nu t/H^2 = 0.1, 0.3, 1; L2 over the "
        "largest speed of steady flow; flux: mean over depth and times%s; Re %.2g"
        % (what, ", its order that of three resolutions to their own limit"
           if case.own_limit else "", case().fastest * H / case.nu))


DOWN = "down 30 degrees, no slip below, free surface"


class Incline(Viscous):
    name = "viscous.incline"
    negatives = {"viscosity 10 % smaller": ({"factor": 0.9}, "velocity", 20)}


class Implicit(Viscous):
    name = "viscous.implicit"
    integration = "implicit"


class Disordered(Viscous):
    """The same piece of the layer at each resolution: the finer its disorder the
    more of it is averaged. What disorder does to the density (theory 9: the layer
    swells by 0.2 spacings) is left out, it is not of the viscosity. With shifting,
    which is there for water that has lost its order; without it the order is 0"""

    name = "viscous.disordered"
    disorder = 0.2
    orders = {"velocity": 1.0}
    own_limit = ()
    packs = "densityRelaxation 0; shifting 1; "

    def width(self, dx):
        return 0.8 * H


class Sheared(Viscous):
    """The layers pass each other by many spacings: no lattice any more"""

    name = "viscous.sheared"
    nu = 0.03
    orders, own_limit = {}, ()


class Poiseuille(Viscous):
    name = "viscous.poiseuille"
    ceiling = True
    exact = staticmethod(plates)
    negatives = {"viscosity 10 % smaller": ({"factor": 0.9}, "velocity", 20)}


Incline.reference = described(Incline, DOWN)
Implicit.reference = described(Implicit, DOWN) + "; viscosityIntegration implicit"
Disordered.reference = described(Disordered, DOWN) + (
    "; particles displaced by up to 0.2 spacings at the start, a piece 0.8 H long, "
    "densityRelaxation 0, shifting 1 (without it 0.69, 0.70 and 0.68 %)")
Sheared.reference = described(Sheared, DOWN) + (
    "; rows of particles pass each other by up to %.0f times the spacing of 20 "
    "layers" % (20 * Sheared().fastest * Sheared().unit / H * 0.5))
Poiseuille.reference = described(Poiseuille, "between two plates, no slip at both")

CASES = (Incline, Implicit, Disordered, Sheared, Poiseuille)
