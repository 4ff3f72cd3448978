# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of the verification cases: dictionaries from few words, and what the
cases read out of a run. Plane strain in x and z, one particle thick, unless
`width` is given; a slope is gravity that is turned, the ground is level.
"""
import math
import os
import re
from dataclasses import dataclass, field

from lpfCase import Case, averaged, mean, rms  # noqa: F401

G = 9.81
RHO_P, RHO_F = 2600.0, 1000.0


def polygon(name, zone, points):
    text = " ".join("(%.17g %.17g %.17g)" % tuple(p) for p in points)
    return "%s { type polygon; zone %s; points (%s); }\n" % (name, zone, text)


@dataclass
class Scene:
    dx: float
    phases: str = "grains"
    width: float = 0.0  # in y [m]; 0: plane strain
    gravity: float = G
    degrees: float = 0.0  # of the slope, down along x
    ground: str = ""
    release: str = ""
    zones: str = ""  # default: no friction
    cyclic: str = ""
    corner: float = None  # y of the lattice, default: the body is centred
    rheology: str = "muI"
    grains: dict = field(default_factory=dict)
    diameter: float = 0.0005
    mu: float = 0.0  # viscosity of the water [Pa s]
    rhoWater: float = RHO_F
    rhoGrains: float = RHO_P
    water: str = ""
    more: str = ""  # of terrainToParticlesDict
    solution: str = ""
    maxSpeed: float = 1.0
    end: float = 1.0
    writes: int = 1
    log: int = 100

    @property
    def half(self):
        """Of the extent of the particles in y"""
        return 0.5 * (self.width or self.dx)

    def floor(self, x0, x1, zone="floor"):
        y = self.half + (0 if self.width and not self.cyclic else 3 * self.dx)
        return polygon("floor", zone, (
            (x0, -y, 0), (x1, -y, 0), (x1, y, 0), (x0, y, 0)))

    def wall(self, name, x, side, high, zone="wall"):
        """Across x, free towards side (1 or -1)"""
        y = self.half + (0 if self.width and not self.cyclic else 3 * self.dx)
        return polygon(name, zone, (
            (x, -side * y, 0), (x, side * y, 0),
            (x, side * y, high), (x, -side * y, high)))

    def ceiling(self, x0, x1, z, zone="ceiling"):
        y = self.half + (0 if self.width and not self.cyclic else 3 * self.dx)
        return polygon("ceiling", zone, (
            (x0, -y, z), (x0, y, z), (x1, y, z), (x1, -y, z)))

    def box(self, name, x0, x1, z0, z1, content, speed=0.0):
        y = self.half
        return (
            "%s { type box; corner (%.17g %.17g %.17g); edges ((%.17g 0 0) "
            "(0 %.17g 0) (0 0 %.17g)); velocity (%.17g 0 0); %s }\n"
            % (name, x0, -y, z0, x1 - x0, 2 * y, z1 - z0, speed, content))

    def _phases(self):
        text = "phases (%s);\n" % self.phases
        if "grains" in self.phases:
            coeffs = {
                "muS": 0.3839, "mu2": 0.6494, "I0": 0.28, "nu": 0.3,
                "E": "auto", "initialStress": "geostatic", **self.grains}
            if self.rheology != "muI":
                del coeffs["I0"]
            text += "grains { rho %g; diameter %g; rheology %s; %sCoeffs { %s } }\n" % (
                self.rhoGrains, self.diameter, self.rheology, self.rheology,
                " ".join("%s %s;" % item for item in coeffs.items()))
        if "water" in self.phases:
            text += "water { rho %g; NewtonianCoeffs { mu %.17g; } %s }\n" % (
                self.rhoWater, self.mu, self.water)
        return text

    def _frame(self):
        zones = self.zones or " ".join(
            "%s { friction none; }" % name
            for name in ("floor", "wall") if "zone %s;" % name in self.ground)
        text = "contact signedDistance;\nzones { %s }\n" % zones
        if self.cyclic:
            text += "cyclic { %s }\n" % self.cyclic
        if not self.width:
            text += "planeStrain { normal (0 1 0); thickness %.17g; }\n" % self.dx
        return text

    def write(self, name):
        case = Case(os.path.abspath("case." + name))
        th = math.radians(self.degrees)
        g = self.gravity
        case.write_gravity((g * math.sin(th), 0, -g * math.cos(th)))
        case.write("constant/phaseProperties", self._phases())
        if self.phases == "grains water":
            case.write("constant/interphaseProperties", "drag Gidaspow;")
        case.write("constant/boundaryProperties", self._frame())
        case.write(
            "system/terrainToParticlesDict",
            "spacing %.17g;\norigin (0 0 0);\nmaxSpeed %.17g;\n"
            "lattice { axes ((1 0 0) (0 1 0) (0 0 1)); origin (0 %.17g 0); }\n"
            "%sground\n{\n%s}\nrelease\n{\n%s}\n"
            % (self.dx, self.maxSpeed,
               -self.half if self.corner is None else self.corner, self.more,
               self.ground, self.release))
        case.write(
            "system/controlDict",
            "startFrom startTime; startTime 0; stopAt endTime; endTime %.17g;\n"
            "writeControl adjustableRunTime; writeInterval %.17g; "
            "timePrecision 10;" % (self.end, self.end / self.writes))
        case.write(
            "system/lpfSolution", "logInterval %d;\n%s" % (self.log, self.solution))
        return case

    def run(self, name):
        case = self.prepared(name)
        case.run("lpfSolver", "-threads", "1")
        return case

    def prepared(self, name):
        case = self.write(name)
        case.run("terrainToParticles")
        return case


def thickness(case, time, cloud, edges, volume):
    """Of the particles, volume each in the plane [m2], in bins of x: each is
    spread evenly over its spacing, so that bins of any width are filled"""
    half = 0.5 * math.sqrt(volume)
    total = [0.0] * (len(edges) - 1)
    step = edges[1] - edges[0]
    for p in case.field(time, "positions", cloud):
        first = int(math.floor((p[0] - half - edges[0]) / step))
        last = int(math.floor((p[0] + half - edges[0]) / step))
        for k in range(max(0, first), min(len(total) - 1, last) + 1):
            overlap = min(p[0] + half, edges[k + 1]) - max(p[0] - half, edges[k])
            total[k] += max(0.0, overlap) / (2 * half) * volume
    return [v / step for v in total]


def front(case, time, cloud, dx):
    """The furthest x where thickness exceeds half a spacing, in bins of two
    spacings, linear between their centres"""
    far = max(p[0] for p in case.field(time, "positions", cloud))
    count = int(max(far, 0) / (2 * dx)) + 3
    edges = [2 * dx * k for k in range(count + 1)]
    found = thickness(case, time, cloud, edges, dx * dx)
    last = max((k for k, t in enumerate(found) if t > 0.5 * dx), default=0)
    here, beyond = found[last], found[last + 1]
    return edges[last] + dx + 2 * dx * (here - 0.5 * dx) / (here - beyond)


def steps(case):
    found = re.findall(r"(\d+) steps", case.log("lpfSolver"))
    return int(found[-1]) if found else 0
