# SPDX-License-Identifier: GPL-3.0-or-later
"""Beds and pools at rest between frictionless walls, in plane strain."""
import math

from planeScene import G, RHO_F, RHO_P, Scene, averaged, rms
from verify import Measured, Verification

H, XI = 0.2, 0.5


def tank(layers, phases, content, **options):
    scene = Scene(dx=H / layers, phases=phases, maxSpeed=0.1, log=200, **options)
    L = H / 2
    scene.ground = (
        scene.floor(0, L) + scene.wall("left", 0, 1, 1.5 * H)
        + scene.wall("right", L, -1, 1.5 * H))
    scene.release = scene.box("fill", 0, L, 0, H, content)
    return scene


def late(case):
    times = case.times()
    return times[len(times) // 2:]


def profile(x, value):
    """(height, value) of the column nearest to the middle"""
    nearest = min(abs(p[0] - H / 4) for p in x.values())
    points = sorted(
        (p[2] / H, value(i)) for i, p in x.items()
        if abs(p[0] - H / 4) < nearest + 1e-3 * H)
    return [v for v, _ in points], [z for _, z in points]


class Hydrostatic(Verification):
    name = "hydrostatic"
    reference = "p = rho g (H - z) in water at rest, mean over 5 to 10 sqrt(H/g)"
    bounds = {"pressure": 0.03}
    axes = ("p/(rho g H)", "z/H")
    converges = True
    findings = {"pressure": (
        "within 3 %, but not converging. As the particles leave their lattice the "
        "first moment of the kernel gradient becomes 0.991, where lambda (T 2.4) "
        "has the 0.974 of the lattice: the pressure is up to 1.6 % too low. At low "
        "resolution, with fewer steps, they leave it less. With the lambda of such "
        "a packing 0.67, 0.58 and 0.48 % (theory 9), which all rows of water would "
        "have to follow; five other ways do not converge.")}
    negatives = {
        "water of 950 kg/m3": ({"rho": 0.95 * RHO_F}, "pressure", 20)}

    def measure(self, layers, rho=RHO_F):
        scene = tank(layers, "water", "water {}", rhoWater=rho)
        scene.end, scene.writes = 10 * math.sqrt(H / G), 20
        case = scene.run("%s%d" % (self.name, layers))
        times = late(case)
        x = averaged(case, times, "positions", "water")
        p = averaged(case, times, "p", "water")
        largest = RHO_F * G * H
        error = rms(p[i][0] / largest - (1 - x[i][2] / H) for i in x)
        return Measured({"pressure": error}, {
            "reference": ([1, 0], [0, 1]),
            "": profile(x, lambda i: p[i][0] / largest)})


class BedAtRest(Verification):
    name = "bedAtRest"
    reference = (
        "sigma_zz = -rho g (H - z), sigma_xx = nu/(1 - nu) sigma_zz, nu 0.36: "
        "loaded from zero stress, mean over "
        "the last half of 60 sqrt(H/g)")
    bounds = {"vertical stress": 0.05, "lateral stress": 0.05}
    converges = True
    axes = ("-sigma/(rho g H)", "z/H")
    negatives = {
        "nu 0.25 in place of 0.36": ({"nu": 0.25}, "lateral stress", 20)}

    def measure(self, layers, nu=0.36):
        scene = tank(layers, "grains", "grains { solidFraction %g; }" % XI,
                     grains={"nu": nu, "initialStress": "zero", "muS": 0.7,
                             "mu2": 0.7})
        scene.end, scene.writes = 60 * math.sqrt(H / G), 40
        case = scene.run("%s%d" % (self.name, layers))
        times = late(case)
        x = averaged(case, times, "positions", "grains")
        s = averaged(case, times, "sigma", "grains")
        top, K0 = max(p[2] for p in x.values()) + 0.5 * scene.dx, 0.36 / 0.64
        largest = RHO_P * XI * G * H

        def errors(component, factor):
            return rms(s[i][component] / largest
                       + factor * (top - x[i][2]) / H for i in x)

        return Measured(
            {"vertical stress": errors(5, 1), "lateral stress": errors(0, K0)},
            {"reference vertical": ([1, 0], [0, 1]),
             "reference lateral": ([K0, 0], [0, 1]),
             "vertical": profile(x, lambda i: -s[i][5] / largest),
             "lateral": profile(x, lambda i: -s[i][0] / largest)})


class SaturatedBed(Verification):
    name = "saturatedBed"
    reference = (
        "p = rho_f g (H - z), effective sigma_zz = -xi (rho_p - rho_f) g (H - z), "
        "mean over 5 to 10 sqrt(H/g)")
    layers = (8, 16, 32)
    bounds = {"pore pressure": 0.03, "effective stress": 0.03}
    converges = True
    negatives = {
        "water of 900 kg/m3": ({"rho": 0.9 * RHO_F}, "pore pressure", 16)}
    axes = ("p, -sigma_zz over their largest", "z/H")

    def measure(self, layers, rho=RHO_F, more=""):
        scene = tank(
            layers, "grains water",
            "grains { solidFraction %g; } water { saturation 1; }" % XI,
            grains={"nu": 0.36}, diameter=0.002, mu=1e-3, rhoWater=rho, more=more)
        scene.end, scene.writes = 10 * math.sqrt(H / G), 20
        case = scene.run("%s%d" % (self.name, layers))
        times = late(case)
        xw = averaged(case, times, "positions", "water")
        p = averaged(case, times, "p", "water")
        xg = averaged(case, times, "positions", "grains")
        s = averaged(case, times, "sigma", "grains")
        high, heavy = RHO_F * G * H, XI * (RHO_P - RHO_F) * G * H
        return Measured(
            {"pore pressure":
                rms(p[i][0] / high - (1 - xw[i][2] / H) for i in xw),
             "effective stress":
                rms(s[i][5] / heavy + (1 - xg[i][2] / H) for i in xg)},
            {"reference": ([1, 0], [0, 1]),
             "pore pressure": profile(xw, lambda i: p[i][0] / high),
             "effective stress": profile(xg, lambda i: -s[i][5] / heavy)})


CASES = (Hydrostatic, BedAtRest, SaturatedBed)
