# SPDX-License-Identifier: GPL-3.0-or-later
"""Laws of the ground: slabs between cyclic planes on a slope of 25 degrees come
to a speed at which the law is in balance with their weight. The material is
stiff, so that it moves as the plug that depth-averaged laws mean; the resolved
profile of a film is the one case that is not."""
import math

from planeScene import G, RHO_F, RHO_P, Scene, mean
from verify import Measured, Verification
from verifySlabs import RIGID, STILL

DEGREES, SPEED, SOLID = 25, 0.5, 0.5
TH = math.radians(DEGREES)


class Terminal(Verification):
    """From half the speed; the number of the law is chosen for SPEED at any
    depth, the error is that of the mean over the last tenth of the time against
    the approach to it. Elastic grains that slide begin to dance after about
    0.3 s, over Coulomb friction as well: they have less time than water."""

    layers = (1, 2, 4, 8)
    judged = 2
    bounds = {"speed": 0.01}
    axes = ("layers", "u/u_exact")
    phases, content = "grains", "grains { solidFraction %g; }" % SOLID
    wait = 0.25  # [s]
    power = 2  # of the velocity in the law
    drive = math.sin(TH)  # less what does not go with the velocity, over g
    viscosity = 2e4  # of water that is a plug [Pa s]

    def law(self, h, factor):
        raise NotImplementedError

    def scene(self, layers, factor):
        dx = 0.01
        L = 8 * dx
        scene = Scene(
            dx=dx, phases=self.phases, degrees=DEGREES, width=L, log=10,
            diameter=0.002, mu=self.viscosity, grains=RIGID,
            solution=STILL if self.phases == "grains" else "",
            cyclic="x (0 %g); y (%g %g);" % (L, -L / 2, L / 2),
            zones="floor { %s }" % self.law(layers * dx, factor), end=self.wait)
        scene.ground = scene.floor(-L, 2 * L)
        scene.release = scene.box(
            "slab", 0, L, 0, layers * dx, self.content, 0.5 * SPEED)
        return scene

    def measure(self, layers, factor=1.0):
        case = self.scene(layers, factor).run("%s%d" % (self.name, layers))
        t = case.table()
        u = mean(
            p / m / SPEED / self.approach(s) for s, p, m in zip(
                t["time"], t["momentumX"], t["mass"]) if s > 0.9 * self.wait)
        lost = t["unexplained"][-1] / t["friction"][-1]
        return Measured(
            {"speed": u - 1},
            {"reference": ([1, 8], [1, 1]), "": ([layers, layers + 0.1], [u, u])},
            {"speed": "u/u_exact %.4f, %.4f of the friction unexplained" % (u, lost)})

    def approach(self, t):
        """u/SPEED of du/dt = drive g (1 - (u/SPEED)^power)"""
        rate = self.drive * G / SPEED
        if self.power == 1:
            return 1 - 0.5 * math.exp(-rate * t)
        return math.tanh(rate * t + math.atanh(0.5))


class Voellmy(Terminal):
    name = "ground.voellmy"
    reference = (
        "Voellmy, mu 0.3: u = sqrt(xi h (sin th - mu cos th)), 25 degrees")
    mu = 0.3
    drive = math.sin(TH) - mu * math.cos(TH)
    negatives = {"xi of 1.1 times": ({"factor": 1.1}, "speed", 4)}

    def coefficients(self, h, factor):
        xi = factor * SPEED ** 2 / (h * self.drive)
        return "mu %g; xi %.17g;" % (self.mu, xi)

    def law(self, h, factor):
        return "friction Voellmy; %s" % self.coefficients(h, factor)


class Water(Terminal):
    phases, content = "water", "water {}"
    wait = 0.5

    def coefficients(self, h, factor):
        raise NotImplementedError

    def law(self, h, factor):
        return (
            "friction none; waterFriction %s; waterFrictionCoeffs { %s }"
            % (self.word, self.coefficients(h, factor)))


class VoellmyWater(Water):
    name = "ground.voellmyWater"
    word = "Voellmy"
    reference = Voellmy.reference + ", water of 2e4 Pa s"
    mu, drive = Voellmy.mu, Voellmy.drive
    coefficients = Voellmy.coefficients


class Manning(Water):
    name = "ground.manning"
    word = "Manning"
    reference = "Manning: u = h^(2/3) sqrt(sin th)/n, 25 degrees, water of 2e4 Pa s"
    negatives = {"n of 1.1 times": ({"factor": 1.1}, "speed", 4)}

    def coefficients(self, h, factor):
        n = h ** (2 / 3) * math.sqrt(math.sin(TH)) / SPEED
        return "n %.17g;" % (factor * n)


def viscous(rho, h):
    """Viscosity of the mean speed SPEED"""
    return rho * G * math.sin(TH) * h * h / (3 * SPEED)


class Laminar(Terminal):
    name = "ground.laminar"
    power = 1
    judged = 4  # two layers dance from the beginning
    reference = "laminar, depth-averaged: u = rho g sin th h^2/(3 mu), 25 degrees"
    negatives = {"viscosity of 1.1 times": ({"factor": 1.1}, "speed", 4)}

    def law(self, h, factor):
        return "friction laminar; viscosity %.17g; profile depthAveraged;" % (
            factor * viscous(SOLID * RHO_P, h))


class LaminarWater(Water):
    name = "ground.laminarWater"
    word, power = "laminar", 1
    reference = Laminar.reference + ", water of 2e4 Pa s"

    def coefficients(self, h, factor):
        return "viscosity %.17g; profile depthAveraged;" % (
            factor * viscous(RHO_F, h))


class Film(Water):
    """The viscosity of the water is that of the law"""

    name = "ground.film"
    word = "laminar"
    layers = (4, 8, 16)
    judged = 8
    bounds = {"speed": 0.03}
    reference = (
        "film of the viscosity of the law, profile wallDistance: mean "
        "u = rho g sin th h^2/(3 mu), 25 degrees")
    negatives = {"viscosity of the law 1.5 times": ({"factor": 1.5}, "speed", 8)}
    wait, power = 1.0, 1

    def coefficients(self, h, factor):
        self.viscosity = viscous(RHO_F, h)
        return "viscosity %.17g; profile wallDistance;" % (factor * self.viscosity)

    def scene(self, layers, factor):
        self.coefficients(layers * 0.01, factor)
        scene = super().scene(layers, factor)
        scene.solution = "water { artificialViscosity 0; viscosityIntegration implicit; }"
        return scene


CASES = (Voellmy, VoellmyWater, Manning, Laminar, LaminarWater, Film)
