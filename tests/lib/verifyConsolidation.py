# SPDX-License-Identifier: GPL-3.0-or-later
"""Saturated grains that carry nothing at the start: the water carries them.
On a floor it flows out while the load goes over to the grains (Terzaghi); without
one the bed falls through it, which is a bed at the onset of fluidisation."""
import math
import re

from planeScene import G, RHO_F, RHO_P, Scene, mean, rms
from verify import Measured, Verification

H, XI, MU = 0.2, 0.5, 1e-3
DIAMETER = 2e-4
BULK = XI * RHO_P + (1 - XI) * RHO_F


def beta(xi, diameter, mu=MU):
    """Drag coefficient of Gidaspow's law without inertia, blended as in the
    paper; 4.5 permille of it is Wen and Yu at xi = 0.5"""
    e = 1 - xi
    ergun = 150 * xi * xi * mu / (e * diameter ** 2)
    wenYu = 18 * xi * mu / diameter ** 2 * e ** -2.65
    share = math.atan(150 * 1.75 * (0.2 - xi)) / math.pi + 0.5
    return (1 - share) * ergun + share * wenYu


def mobility(xi, diameter):
    """Darcy: k/mu, of the flux through the whole area. The water loses
    dp/dx = beta u/e where its own speed is u over that of the grains"""
    return (1 - xi) ** 2 / beta(xi, diameter)


def fluidising(xi, diameter, rho=RHO_P, mu=MU):
    """Superficial speed at which Ergun's loss of pressure carries a bed"""
    e = 1 - xi
    a = 1.75 * xi * RHO_F / (e ** 3 * diameter)
    b = 150 * xi * xi * mu / (e ** 3 * diameter ** 2)
    weight = xi * (rho - RHO_F) * G
    return (math.sqrt(b * b + 4 * a * weight) - b) / (2 * a)


def excess(z, T):
    """Over that of the start at the base, which falls linearly to the drained
    top; the base at z = 0 is closed. T = c_v t/H^2"""
    total = 0.0
    for n in range(80):
        k = (n + 0.5) * math.pi
        total += 2 / k ** 2 * math.cos(k * z / H) * math.exp(-k * k * T)
    return total


def settled(T):
    """Settlement over its final value"""
    return 1 - 2 * sum(
        2 * (-1) ** n / k ** 3 * math.exp(-k * k * T)
        for n, k in ((n, (n + 0.5) * math.pi) for n in range(80)))


class Terzaghi(Verification):
    """Damped: without noiseDamping neighbouring columns of grains part by 6 % of
    a spacing at 40 layers, and the top settles by 3.2 % of the final settlement
    too much, in place of 2.4 %"""

    name = "terzaghi"
    reference = (
        "Terzaghi with its own weight as the load: excess pore pressure "
        "xi (rho_p - rho_f) g (H - z) at the start, closed base, drained top, series "
        "with c_v = B M k/mu; from 0.05 to 0.9 in c_v t/H^2; L2 over the excess at "
        "the base; settlement of the top over its final one. H 0.2 m, xi 0.5, "
        "k/mu = (1 - xi)^2/beta of Gidaspow at Re 0, M and B of the run (printed by "
        "it)")
    layers = (10, 20, 40)
    bounds = {"excess pressure": 0.05, "settlement": 0.05}
    axes = ("excess, settlement over their largest", "z/H; c_v t/H^2")
    negatives = {
        "grains of 1.2 times the diameter": (
            {"factor": 1.2}, "excess pressure", 20)}

    def measure(self, layers, factor=1.0):
        dx = H / layers
        L = 6 * dx
        scene = Scene(
            dx=dx, phases="grains water", maxSpeed=0.1, mu=MU, log=200,
            diameter=factor * DIAMETER, cyclic="x (0 %.17g);" % L,
            grains={"nu": 0.3, "muS": 0.9, "mu2": 0.9, "initialStress": "zero"},
            solution="bulkDamping 0.3; noiseDamping 0.3;")
        scene.ground = scene.floor(-8 * dx, 16 * dx)
        scene.release = scene.box(
            "bed", 0, L, 0, H,
            "grains { solidFraction %g; } water { saturation 1; }" % XI)
        scene.end, scene.writes = 0.3, 20
        case = scene.prepared("%s%d" % (self.name, layers))
        # the water carries the grains: no stress in them, all in balance
        case.change("p", lambda p, _: p * BULK / RHO_F, "water")
        case.run("lpfSolver", "-threads", "1")
        return self.compared(case, layers == self.layers[-1])

    @staticmethod
    def stiffness(case):
        """M and B as the run prints them"""
        log = case.log("lpfSolver")
        return (float(re.search(r"Skeleton (\S+) Pa", log).group(1)),
                float(re.search(r"pressure B = ([\d.e+-]+)", log).group(1)))

    def compared(self, case, shown):
        M, B = self.stiffness(case)
        c = B * M * mobility(XI, DIAMETER)
        load = (BULK - RHO_F) * G
        largest, final = load * H, load * H * H / (2 * M)
        # by the number of the particle
        z0 = dict(zip(case.field("0", "id"),
                      (x[2] for x in case.field("0", "positions"))))
        top = max(z0.values()) - 1e-6 * H
        off, behind, way = [], [], []
        curves, notes = {}, []
        for time in case.times()[1:]:
            T = c * float(time) / H ** 2
            x = case.field(time, "positions", "water")
            p = case.field(time, "p", "water")
            found = [(b - RHO_F * G * (H - a[2])) / largest for a, b in zip(x, p)]
            fallen = [z0[i] - a[2] for i, a in zip(
                case.field(time, "id"), case.field(time, "positions"))
                if z0[i] > top]
            way.append((T, mean(fallen) / final, settled(T)))
            if T > 0.04 and T > 1.8 * (notes[-1][0] if notes else 0):
                here = [f - excess(a[2], T) for f, a in zip(found, x)]
                off += here
                notes.append((T, rms(here)))
                if shown:
                    self.curve(curves, T, x, found)
            behind.append(way[-1][1] - way[-1][2])
        curves["reference settlement"] = (
            [w[2] for w in way], [w[0] for w in way])
        curves["settlement"] = ([w[1] for w in way], [w[0] for w in way])
        return Measured(
            {"excess pressure": rms(off), "settlement": rms(behind)}, curves,
            {"excess pressure": ", ".join(
                "%.2g %% at %.2g" % (100 * e, T) for T, e in notes)})

    @staticmethod
    def curve(curves, T, x, found):
        word = "%.2f H2/c" % T
        heights = [k / 40 for k in range(41)]
        curves["reference " + word] = (
            [excess(H * z, T) for z in heights], heights)
        points = sorted((a[2] / H, f) for a, f in zip(x, found))
        curves[word] = ([f for _, f in points], [z for z, _ in points])


class Fluidisation(Verification):
    """In the frame of the bed the water of a closed vessel flows up through it
    at the speed of its fall: nothing but water carries the grains, so this speed
    is the least that fluidises them, and the gradient of the pressure the
    critical one. There is no boundary that lets water in, and cyclic planes
    cannot be level"""

    name = "fluidisation"
    reference = (
        "a bed of 0.1 m, solid fraction 0.5, grains of 2 mm, falls through still "
        "water: speed of fall, the flux of the water through it, U_mf = %.5f m/s of "
        "Ergun, of the middle half of the bed; excess pressure below it over rho_f g "
        "times its thickness, i_c = (1 - n)(G_s - 1) = %g; means from 0.01 to 0.025 "
        "of its thickness in fall: its lower side breaks up from 0.03 on" % (
            fluidising(XI, 2e-3), XI * (RHO_P / RHO_F - 1)))
    bounds = {"velocity": 0.05, "gradient": 0.05}
    axes = ("t [s]", "v/U_mf, i/i_c")
    negatives = {
        "grains of 1.8 mm": ({"diameter": 1.8e-3}, "velocity", 20),
        "grains of 2400 kg/m3": ({"rho": 2400}, "gradient", 20)}
    thick, deep = 0.1, 0.25

    def measure(self, layers, diameter=2e-3, rho=RHO_P):
        thick = self.thick
        dx = thick / layers
        L = 6 * dx
        scene = Scene(
            dx=dx, phases="grains water", maxSpeed=0.1, mu=MU, log=200,
            diameter=diameter, rhoGrains=rho, cyclic="x (0 %.17g);" % L,
            grains={"nu": 0.3, "initialStress": "zero"})
        scene.ground = scene.floor(-8 * dx, 16 * dx)
        scene.release = scene.box(
            "lake", 0, L, 0, self.deep, "water {}") + scene.box(
            "bed", 0, L, thick, 2 * thick,
            "grains { solidFraction %g; } water { saturation 1; }" % XI)
        scene.end = 0.025 * thick / fluidising(XI, 2e-3)
        scene.writes = 40
        case = scene.prepared("%s%d" % (self.name, layers))
        self.steady(case, diameter, rho)
        case.run("lpfSolver", "-threads", "1")
        return self.compared(case)

    def steady(self, case, diameter, rho):
        """Water carries the bed from the start, which falls already"""
        thick, weight = self.thick, XI * (rho - RHO_F) * G
        speed = fluidising(XI, diameter, rho)

        def inside(x):
            return thick < x[2] < 2 * thick

        case.change("p", lambda p, x: p + weight * min(
            thick, max(0, 2 * thick - x[2])), "water")
        case.change("U", lambda u, x: (0.0, 0.0, -speed))
        case.change("U", lambda u, x: (
            0.0, 0.0, speed * XI / (1 - XI) if inside(x) else 0.0), "water")

    def compared(self, case):
        speed, critical = fluidising(XI, 2e-3), XI * (RHO_P / RHO_F - 1)
        t, v, i = [], [], []
        for time in case.times():
            x = case.field(time, "positions")
            middle = mean(p[2] for p in x)

            def inside(p):
                return abs(p[2] - middle) < self.thick / 4

            t.append(float(time))
            v.append(-mean(u[2] for p, u in zip(x, case.field(time, "U"))
                           if inside(p)) / speed)
            # of the water below, a fifth of the thickness from its lower side
            i.append(mean(
                p - RHO_F * G * (self.deep - x[2]) for x, p in zip(
                    case.field(time, "positions", "water"),
                    case.field(time, "p", "water")) if x[2] < 0.8 * self.thick)
                / (critical * RHO_F * G * self.thick))
        late = range(16, len(t))
        return Measured(
            {"velocity": mean(v[k] for k in late) - 1,
             "gradient": mean(i[k] for k in late) - 1},
            {"reference": ([t[16], t[-1]], [1, 1]), "v/U_mf": (t, v),
             "i/i_c": (t, i)})


CASES = (Terzaghi, Fluidisation)
