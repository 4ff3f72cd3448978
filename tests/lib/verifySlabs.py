# SPDX-License-Identifier: GPL-3.0-or-later
"""Thin sheets on slopes of 1, 2, 4 and 8 layers: slabs between cyclic planes,
and the parabolic cap of Savage and Hutter; a granular dam break on a slope."""
import math

from planeScene import G, RHO_F, RHO_P, Scene, mean, thickness
from verify import Measured, Verification
from verifyDamBreak import bins, binned, depths, ritter

RIGID = {"muS": 0.6, "mu2": 0.6, "nu": 0, "stiffness": 20, "cohesion": 1e4}
STILL = "bulkDamping 0.3; noiseDamping 0.3;"
FREE = {"muS": 1e-6, "mu2": 1e-6, "nu": 0.3}
SLIDES_OVER_BASE = (
    "basal friction acts on the lowest layer of particles, which stops under the "
    "weight of those above; without internal friction nothing hands it on, and "
    "the others slide over it. The reference moves as a plug over the depth, "
    "which the material that it asks for does not.")


def acceleration(case, start):
    """Slope of the mean velocity over time from start on, least squares"""
    t = case.table()
    points = [(s, p / m) for s, p, m in zip(t["time"], t["momentumX"], t["mass"])
              if s > start]
    tm, um = mean(p[0] for p in points), mean(p[1] for p in points)
    return sum((s - tm) * (u - um) for s, u in points) / sum(
        (s - tm) ** 2 for s, _ in points)


class Slab(Verification):
    layers = (1, 2, 4, 8)
    judged = 4
    bounds = {"acceleration": 0.05}
    axes = ("layers", "a/g")
    phases, content = "grains", "grains { solidFraction 0.5; }"
    degrees, mu, ru, share = 25, 0.3, 0.0, 1.0

    def exact(self):
        th = math.radians(self.degrees)
        return math.sin(th) - self.mu * (1 - self.ru) * self.share * math.cos(th)

    def measure(self, layers, friction=None):
        dx = 0.01
        L = 8 * dx
        scene = Scene(
            dx=dx, phases=self.phases, degrees=self.degrees, width=L, log=10,
            diameter=0.002, mu=1e-3, grains=RIGID, solution=STILL,
            cyclic="x (0 %g); y (%g %g);" % (L, -L / 2, L / 2),
            zones="floor { friction Coulomb; mu %g; ru %g; }" % (
                friction or self.mu, self.ru),
            end=0.25)
        scene.ground = scene.floor(-L, 2 * L)
        scene.release = scene.box("slab", 0, L, 0, layers * dx, self.content)
        case = scene.run("%s%d" % (self.name, layers))
        a = acceleration(case, 0.05) / G
        return Measured(
            {"acceleration": a / self.exact() - 1},
            {"reference": ([1, 8], [self.exact()] * 2),
             "": ([layers, layers + 0.1], [a, a])},
            {"acceleration": "a/g %.4f" % a})


class Coulomb(Slab):
    name = "slab.coulomb"
    reference = "a = g (sin th - mu cos th), 25 degrees, mu 0.3"
    negatives = {"friction of 0.33": ({"friction": 0.33}, "acceleration", 4)}


class PorePressure(Slab):
    name = "slab.ru"
    reference = "a = g (sin th - (1 - r_u) mu cos th), 25 degrees, mu 0.6, r_u 0.5"
    mu, ru = 0.6, 0.5


class Saturated(Slab):
    name = "slab.saturated"
    reference = (
        "a = g (sin th - mu (1 - rho_f/rho_m) cos th), 25 degrees, mu 0.4, "
        "solid fraction 0.5")
    phases = "grains water"
    content = "grains { solidFraction 0.5; } water { saturation 1; }"
    mu, share = 0.4, 1 - RHO_F / (0.5 * (RHO_P + RHO_F))
    negatives = {"friction of 0.5": ({"friction": 0.5}, "acceleration", 4)}


def seeping(drive, xi, diameter, mu=1e-3):
    """Speed of water over that of the grains where drive [Pa/m] of bulk is what
    Ergun's drag takes: beta u = drive"""
    a = 1.75 * xi * RHO_F / diameter
    b = 150 * xi * xi * mu / ((1 - xi) * diameter ** 2)
    return (math.sqrt(b * b + 4 * a * drive) - b) / (2 * a)


class Seepage(Saturated):
    """The slab of Saturated; and one that friction holds, through which the water
    goes on"""

    name = "slab.seepage"
    reference = (
        "water seeps down through a slab of 25 degrees, grains of 2 mm, solid "
        "fraction 0.5: slip u of Ergun, beta u = (1 - xi) rho_f (g sin th - a), with a "
        "= 0 held by friction of 1.2, with a of slab.saturated sliding at 0.4")
    bounds = {"held": 0.05, "sliding": 0.05}
    layers = (1, 2, 4, 8, 16)
    axes = ("layers", "slip [m/s]")
    negatives = {"grains of 2.3 mm": ({"diameter": 0.0023}, "held", 4)}

    def run(self, layers, friction, diameter):
        dx = 0.01
        L = 8 * dx
        scene = Scene(
            dx=dx, phases=self.phases, degrees=self.degrees, log=10,
            diameter=diameter, mu=1e-3, grains=RIGID, solution=STILL,
            cyclic="x (0 %g);" % L, end=0.25, writes=10,
            zones="floor { friction Coulomb; mu %g; }" % friction)
        scene.ground = scene.floor(-L, 2 * L)
        scene.release = scene.box("slab", 0, L, 0, layers * dx, self.content)
        return scene.run("%s%d" % (self.name, layers))

    @staticmethod
    def slip(case):
        """Mean of the second half of the run"""
        times = case.times()
        return mean(
            mean(u[0] for u in case.field(t, "U", "water"))
            - mean(u[0] for u in case.field(t, "U"))
            for t in times[len(times) // 2:])

    def measure(self, layers, diameter=0.002):
        sin = math.sin(math.radians(self.degrees))
        found = [self.slip(self.run(layers, friction, diameter))
                 for friction in (1.2, self.mu)]
        exact = [seeping(0.5 * RHO_F * G * (sin - a), 0.5, 0.002)
                 for a in (0, Saturated().exact())]
        return Measured(
            {"held": found[0] / exact[0] - 1, "sliding": found[1] / exact[1] - 1},
            {"reference": ([1, 16], [exact[0]] * 2),
             "reference sliding": ([1, 16], [exact[1]] * 2),
             "held": ([layers, layers + 0.1], [found[0]] * 2),
             "sliding": ([layers, layers + 0.1], [found[1]] * 2)},
            {"held": "%.4f m/s" % found[0], "sliding": "%.4f m/s" % found[1]})


def growth(tau):
    """g of the plane cap at tau = sqrt(2 C) t, by bisection:
    sqrt(g (g - 1)) + ln(sqrt g + sqrt(g - 1)) = tau"""
    low, high = 1.0, 1.0 + tau * tau
    for _ in range(100):
        g = 0.5 * (low + high)
        value = math.sqrt(g * (g - 1)) + math.log(math.sqrt(g) + math.sqrt(g - 1))
        low, high = (g, high) if value < tau else (low, g)
    return low


class Cap(Verification):
    """Frictionless inside, Coulomb below: earth pressure coefficient k = 1"""

    name = "savageHutter"
    k, grains = 1.0, FREE
    reference = (
        "Savage-Hutter parabolic cap, h0/L = 0.05, 35 degrees, friction of 25 "
        "degrees, t = 3 sqrt(L/g): centre x_c = g (sin z - cos z tan d) t^2/2, "
        "height h0/g(t), earth pressure coefficient 1")
    findings = dict.fromkeys(("centre", "height"), SLIDES_OVER_BASE)
    layers = (1, 2, 4, 8)
    judged = 4
    bounds = {"centre": 0.02, "height": 0.10}
    axes = ("x/L", "h/h0")
    L = 1.0

    phases, content = "grains", "grains { solidFraction 0.6; }"

    def material(self, delta, h0, t):
        """What Scene has to know of it, with a base of mu = tan(delta)"""
        return {
            "grains": self.grains,
            "zones": "floor { friction Coulomb; mu %.17g; }" % math.tan(
                math.radians(delta))}

    def measure(self, layers, delta=25):
        h0, L = 0.05 * self.L, self.L
        dx, t = h0 / layers, 3 * math.sqrt(L / G)
        scene = Scene(
            dx=dx, phases=self.phases, degrees=35, maxSpeed=3.0, end=t, log=200,
            **self.material(delta, h0, t))
        scene.ground = scene.floor(-2 * L, 4 * L)
        columns = int(round(2 * L / dx))
        scene.release = "".join(
            self.column(scene, k, h0) for k in range(columns))
        case = scene.run("%s%d" % (self.name, layers))
        return self.compared(case, scene, h0, t)

    def column(self, scene, k, h0):
        """Of as many particles as the height has, rounded"""
        x = -self.L + (k + 0.5) * scene.dx
        count = int(round(h0 * (1 - (x / self.L) ** 2) / scene.dx))
        if not count:
            return ""
        return scene.box("c%d" % k, x - 0.5 * scene.dx, x + 0.5 * scene.dx, 0,
                         count * scene.dx, self.content)

    def compared(self, case, scene, h0, t):
        L, z, d = self.L, math.radians(35), math.radians(25)
        g = growth(math.sqrt(4 * self.k * G * math.cos(z) * h0) / L * t)
        way = 0.5 * G * (math.sin(z) - math.cos(z) * math.tan(d)) * t * t
        last = case.times()[-1]

        def centre(time):
            return mean(p[0] for p in case.field(time, "positions", self.phases))

        moved = centre(last) - centre("0")
        edges, centres = bins(way - 1.3 * g * L, way + 1.3 * g * L, 52)
        found = thickness(case, last, self.phases, edges, scene.dx ** 2)
        exact = binned(
            lambda s: max(0.0, h0 / g * (1 - ((s - way) / (g * L)) ** 2)), edges)
        # of the mean of the bins within a quarter of the half length
        middle = [k for k, c in enumerate(centres) if abs(c - way) < 0.25 * L * g]
        height = mean(found[k] for k in middle) / mean(exact[k] for k in middle)
        xs = [c / L for c in centres]
        return Measured(
            {"centre": moved / way - 1, "height": height - 1},
            {"reference": (xs, [e / h0 for e in exact]),
             "": (xs, [f / h0 for f in found])})


def active(phi, delta):
    """Earth pressure coefficient of a layer that lengthens, Savage and Hutter,
    J. Fluid Mech. 199 (1989) 177; angles in degrees"""
    c2 = math.cos(math.radians(phi)) ** 2
    t2 = math.tan(math.radians(delta)) ** 2
    return 2 / c2 * (1 - math.sqrt(1 - (1 + t2) * c2)) - 1


class Plug(Cap):
    """In plane strain without dilatancy sqrt(J2) = mu p is sin(phi) = mu"""

    name = "savageHutter.plug"
    k, findings = active(35, 25), {}
    grains = dict(FREE, muS=math.sin(math.radians(35)),
                  mu2=math.sin(math.radians(35)))
    reference = Cap.reference.replace(
        "coefficient 1", "coefficient %.3f, active, internal friction of 35 "
        "degrees" % active(35, 25))
    negatives = {"friction of 27 degrees": ({"delta": 27}, "centre", 4)}


class Liquid(Cap):
    """No friction inside, and a viscosity that hands that of the base on: from
    the base to the surface the speed differs by 5 % of what it is at the end"""

    name = "savageHutter.liquid"
    findings = {}
    phases, content = "water", "water {}"
    reference = Cap.reference + (
        ", a liquid whose speed differs by 5 % over the depth")
    negatives = {"friction of 27 degrees": ({"delta": 27}, "centre", 4)}

    def material(self, delta, h0, t):
        z, rho, differs = math.radians(35), 1500, 0.05
        mu = math.tan(math.radians(delta))
        base = mu * rho * G * math.cos(z) * h0
        speed = G * (math.sin(z) - math.cos(z) * mu) * t
        return {
            "rhoWater": rho, "mu": base * h0 / (2 * differs * speed),
            "zones": "floor { friction none; waterFriction Voellmy; "
                     "waterFrictionCoeffs { mu %.17g; xi 1e9; } }" % mu}


class Mangeney(Verification):
    reference = (
        "Mangeney 2000: h/h0 = (2 - (x/t - m0 t/2)/c0)^2/9, c0^2 = k g cos th h0, "
        "m0 = g cos th (tan th - mu), 25 degrees, mu %g, t = %g sqrt(h0/g), k %s")
    bounds = {"depth": 0.05}
    axes = ("x/h0", "h/h0")
    phases, content = "grains", "grains { solidFraction 0.6; }"
    mu, h0, k, duration, grains = 0.0, 0.2, 1.0, 3, FREE

    def material(self, mu, c0, speed):
        """speed: of the slab at the end"""
        return {
            "grains": self.grains, "maxSpeed": 2 * c0 + speed,
            "zones": "floor { friction Coulomb; mu %g; }" % mu}

    def measure(self, layers, mu=None):
        h0, th = self.h0, math.radians(25)
        t = self.duration * math.sqrt(h0 / G)
        c0 = math.sqrt(self.k * G * math.cos(th) * h0)
        m0 = G * (math.sin(th) - self.mu * math.cos(th))
        moved = 0.5 * m0 * t * t
        scene = Scene(
            dx=h0 / layers, phases=self.phases, degrees=25, end=t, log=200,
            **self.material(self.mu if mu is None else mu, c0, m0 * t))
        # the rear moves with the slab: its own collapse stays behind
        rear = -2.07 * self.duration * h0
        scene.ground = scene.floor(
            rear - 3 * h0, 2 * c0 * t + 0.5 * G * t * t + 4 * h0)
        scene.release = scene.box("dam", rear, 0, 0, h0, self.content)
        case = scene.run("%s%d" % (self.name, layers))
        xs = bins(-0.8 * c0 * t + moved, c0 * t + moved, 36)
        return depths(
            case, scene, xs, h0, h0, lambda x: ritter(x, t, c0, m0))


class Smooth(Mangeney):
    name = "mangeney.smooth"
    reference = Mangeney.reference % (0, 3, 1)
    negatives = {"basal friction of 0.3": ({"mu": 0.3}, "depth", 20)}


class Rough(Mangeney):
    name = "mangeney.coulomb"
    # it does not come nearer with more
    mu, layers = 0.2, (5, 10, 20)
    reference = Mangeney.reference % (0.2, 3, 1)
    findings = {"depth": SLIDES_OVER_BASE}


class RoughPlug(Mangeney):
    name = "mangeney.plug"
    mu, k, grains = 0.3, active(35, math.degrees(math.atan(0.3))), Plug.grains
    reference = Mangeney.reference % (
        0.3, 3, "%.3f, active, internal friction of 35 degrees" % k)
    findings = {"depth": (
        "the rarefaction is late by up to 0.10 h0 at 40 layers, no less than at 20 "
        "(0.06 h0 in Ritter): the reference has no acceleration across the layer, "
        "an earth pressure that is active at once, and no shear over the depth, "
        "where the speed here rises from 0.41 m/s at the ground to 0.59 m/s. Later, in "
        "a longer dam: 9.1, 7.4, 4.9 % at 3, 5, 8 sqrt(h0/g) and 10 layers, 6.2, 6.1, "
        "4.3 % at 20, 5.9, 6.7, 4.7 % at 40: no steady fall.")}
    negatives = {"no basal friction": ({"mu": 0}, "depth", 20)}


class RoughLiquid(Mangeney):
    """No friction inside, and a viscosity that hands that of the base on, in a dam
    that has become long: before, a viscosity that keeps the speed even over the
    depth resists the lengthening, too. Sound by the speeds in the frame that moves
    with the slab, which is what presses on it"""

    name = "mangeney.liquid"
    phases, content = "water", "water {}"
    mu, duration, differs = 0.1, 12, 0.1
    reference = Mangeney.reference % (
        0.1, 12, "1, a liquid whose speed differs by 10 % of that of the slab over "
        "the depth")
    negatives = {"no basal friction": ({"mu": 0}, "depth", 20)}

    def material(self, mu, c0, speed):
        base = self.mu * RHO_F * G * math.cos(math.radians(25)) * self.h0
        return {
            "maxSpeed": 2 * c0 + speed,
            "mu": base * self.h0 / (2 * self.differs * speed),
            "water": "TaitCoeffs { soundSpeed %.17g; }" % (20 * c0),
            "zones": "floor { friction none; waterFriction Voellmy; "
                     "waterFrictionCoeffs { mu %.17g; xi 1e9; } }" % mu}


CASES = (
    Coulomb, PorePressure, Saturated, Seepage, Cap, Plug, Liquid, Smooth, Rough,
    RoughPlug, RoughLiquid)
