#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains and water together, against answers that need no particles.

slab      a saturated layer that slides on a rough plane between cyclic planes:
          a = g (sin th - mu (1 - rho_f/rho_m) cos th), 2 % at 8 layers; at 1, 2
          and 4 layers the error is printed
pour      grains fall into a tank of water: its level rises by Vs/A, 2 %, while
          they sink and when they lie; density by rate and by sum agree
level     water fills the lower half of a bed, all of it at the same height, or
          higher on one side: it comes to rest within one spacing
pores     water that drains from pores six tenths full: what diffusion of density
          makes or takes is below a tenth of drag, and the ledger closes
alone     each phase moves as if the other did not exist where it is far away
Usage: test slab|pour|level|pores|alone

Settling and Ergun: tests/unit/interphaseTest.C.
"""
import itertools
import math
import os
import re
import sys
from concurrent.futures import ThreadPoolExecutor

from lpfCase import PLAIN, Case, jobs, ok
from tankShapes import walls

G, DX = 9.81, 0.01
RHO_P, RHO_F = 2600.0, 1000.0
LATTICE_SUM = 1.0095  # of V W, at h = 1.3 spacings


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
            % (scene.get("density", RHO_P), scene.get("diameter", 0.002),
               mu_inside, mu_inside,
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


# ---------------------------------------------------------------- pour

def surface(case, time, area, layers=4):
    """Level of the water: its uppermost particles fill a slab, whose volume,
    grains included, and whose centre are known"""
    x = case.field(time, "positions", "water")
    m = case.field(time, "mass", "water")
    full = case.field(time, "alpha", "water")  # water over bulk volume
    top = sorted(range(len(x)), key=lambda i: -x[i][2])
    top = top[: int(round(layers * area / DX ** 2))]
    volume = sum(m[i] / (RHO_F * full[i]) for i in top)
    return mean([x[i][2] for i in top]) + 0.5 * volume / area


def sum_over_rate(case, time, side, level):
    """Of each particle of water with a full kernel, its height and its density
    by where the others are over that which is integrated: sum V W, with V of
    the integrated density, over that of a lattice. Where sides are cyclic that
    is a column without neighbours behind them: none of it is nearer than 2 h"""
    h = 1.3 * DX
    x = [p[:3] for p in case.field(time, "positions", "water")]
    V = [m / (rho * share) for m, rho, share in zip(
        case.field(time, "mass", "water"), case.field(time, "rho", "water"),
        case.field(time, "alpha", "water"))]
    cells = {}
    for i, p in enumerate(x):
        cells.setdefault(tuple(int(c // (2 * h)) for c in p), []).append(i)

    def kernel_sum(p):
        near = (range(int(c // (2 * h)) - 1, int(c // (2 * h)) + 2) for c in p)
        total = 0.0
        for cell in itertools.product(*near):
            for j in cells.get(cell, ()):
                q = math.dist(p, x[j]) / h
                total += V[j] * max(0.0, 1 - q / 2) ** 4 * (1 + 2 * q)
        return total * 21 / (16 * math.pi * h ** 3)

    return [
        (p[2], kernel_sum(p) / LATTICE_SUM) for p in x
        if min(p[0], p[1], side - p[0], side - p[1], p[2], level - p[2]) > 2 * h]


def tank(side, high):
    """Walls around, grains one spacing from them"""
    return {
        "zones": "floor { friction Coulomb; mu 0.5; } walls { friction none; }",
        "ground": floor(0, side, 0, side) + walls(0, side, 0, side, 0, high),
        "inset": DX,
    }


def far_from_walls(side, _):
    """Cyclic sides: a tank whose walls are far away"""
    return {
        "zones": "floor { friction Coulomb; mu 0.5; }",
        "cyclic": "cyclic { x (0 %g); y (0 %g); }" % (side, side),
        "ground": floor(-side, 2 * side, -side, 2 * side),
        "inset": 0,
    }


def of_bed_and_water(shares, top):
    yield "in the bed", [s for z, s in shares if z < top]
    yield "above it", [s for z, s in shares if z > top]


def poured(name, sides, columns, density=RHO_P, above=2 * DX, end=2,
           deep=24, layers=12):
    """Grains as coarse as a spacing: the pores of a dry layer that sinks fill
    within half a second. Of finer grains its upper part stays dry for long, and
    the water rises by the air in it, too. They begin a distance above the water:
    rock plunges into it as one body, light grains (1500 kg/m3, at 0) swim until
    their pores fill, and sink without a splash."""
    side, depth = columns * DX, deep * DX
    phi = 0.5
    case = Case(os.path.abspath("case." + name))
    scene = sides(side, 3 * depth)
    x0, x1 = scene["inset"], side - scene["inset"]
    z0 = depth + above
    run_scene = {
        **scene,
        "release": box("pool", (0, 0, 0), (side, side, depth), "water {}")
        + box("grains", (x0, x0, z0), (x1, x1, z0 + layers * DX),
              "grains { solidFraction %g; }" % phi),
        "diameter": 0.01, "density": density, "stress": "zero",
        "maxSpeed": 1.5, "end": end, "interval": 0.05,
    }
    write(case, run_scene)
    run(case)
    area = side * side
    rise = phi * (x1 - x0) ** 2 * layers * DX / area
    before = surface(case, "0", area)
    states = [
        (max(p[2] for p in case.field(time, "positions")),
         surface(case, time, area)) for time in case.times()]
    lowest = min(top for top, _ in states)
    sinking = [level for top, level in states
               if lowest + 2 * DX < top < level - 4 * DX]
    lying = [level for top, level in states if top < lowest + 0.5 * DX]
    for levels, what in ((sinking, "sink"), (lying, "lie")):
        error = mean(levels) - before - rise
        yield (
            abs(error) < 0.02 * rise,
            "pour, %s: level rises by %.2f mm while grains %s (mean of %d "
            "times), Vs/A %.2f, off by %+.3f (2 %%), %+.3f spacings"
            % (name, 1e3 * (rise + error), what, len(levels), 1e3 * rise,
               error / rise, error / DX),
        )
    if side < 6 * 1.3 * DX:
        return
    last = case.times()[-1]
    top, level = states[-1]
    for where, shares in of_bed_and_water(
            sum_over_rate(case, last, side, level), top):
        share = mean(shares)
        yield (
            abs(share - 1) < 0.02,
            "pour, %s: density by sum over that by rate %.4f, rms %.4f, of %d "
            "particles %s (2 %%)"
            % (name, share,
               math.sqrt(mean([(s - share) ** 2 for s in shares])),
               len(shares), where),
        )


def pour():
    with ThreadPoolExecutor(jobs()) as pool:
        found = pool.map(
            lambda scene: list(poured(*scene)),
            # the longest first
            (("otherDeepTank", tank, 18, 2000, 2 * DX, 2.5, 30, 21),
             # not looked at while (T 6.22) was made
             ("otherTank", tank, 18, 2000, 2 * DX, 2, 30, 10),
             ("deepTank", tank, 12, RHO_P, 2 * DX, 2.5, 24, 24),
             ("wideTank", far_from_walls, 6), ("narrowTank", tank, 12),
             ("lightGrains", tank, 12, 1500, 0, 3)))
        return [line for lines in found for line in lines]


# ---------------------------------------------------------------- level

WET = "grains { solidFraction 0.5; } water { saturation 1; }"
DRY = "grains { solidFraction 0.5; }"
SIDE, BED = 8 * DX, 14 * DX


def beds():
    """Releases and the level at the end [m], porosity 0.5"""
    half = BED / 2

    def layer(name, z0, z1, content, x0=0.0, x1=SIDE):
        return box(name, (x0, 0, z0), (x1, SIDE, z1), content)

    step = 2 * DX
    return {
        "inside": (
            layer("wet", 0, half, WET) + layer("dry", half, BED, DRY), half),
        "step": (
            layer("wetLeft", 0, half + step, WET, x1=SIDE / 2)
            + layer("wetRight", 0, half - step, WET, x0=SIDE / 2)
            + layer("dryLeft", half + step, BED, DRY, x1=SIDE / 2)
            + layer("dryRight", half - step, BED, DRY, x0=SIDE / 2), half),
        "drain": (
            layer("dry", 0, half, DRY) + layer("wet", half, BED, WET), half),
        "fill": (
            layer("dry", 0, BED, DRY)
            + layer("pool", BED, BED + 3 * DX, "water {}"), 6 * DX),
    }


def level(kind):
    release, expected = beds()[kind]
    case = Case(os.path.abspath("case.%s" % kind))
    write(case, {
        "zones": "floor { friction Coulomb; mu 0.5; } walls { friction none; }",
        "ground": floor(0, SIDE, 0, SIDE)
        + walls(0, SIDE, 0, SIDE, 0, 2 * BED),
        "release": release, "diameter": 0.005,
        "maxSpeed": 0.5, "end": 3, "interval": 0.1,
    })
    run(case)
    late = [t for t in case.times() if float(t) > 2]
    found = mean([surface(case, t, SIDE * SIDE, 2) for t in late])
    highest = mean([
        sorted(p[2] for p in case.field(t, "positions", "water"))[-1]
        for t in late
    ])
    table = case.table()
    scale = table["mass"][0] * G * BED
    print("# %s: highest water %.4f m" % (kind, highest))
    return [
        (abs(found - expected) < DX,
         "%s: level %.4f m, %.4f at equilibrium (one spacing)"
         % (kind, found, expected)),
        (max(table["left"]) == 0, "%s: nothing left the tank" % kind),
        (abs(table["unexplained"][-1]) < 1e-3 * scale,
         "%s: energy unexplained %.1e of m g H (1e-3)"
         % (kind, table["unexplained"][-1] / scale)),
    ]


def levels():
    with ThreadPoolExecutor(jobs()) as pool:
        return sum(pool.map(level, beds()), [])


# ---------------------------------------------------------------- pores

def pores():
    case = Case(os.path.abspath("case.pores"))
    write(case, {
        "zones": "floor { friction Coulomb; mu 0.5; } walls { friction none; }",
        "ground": floor(0, SIDE, 0, SIDE) + walls(0, SIDE, 0, SIDE, 0, BED),
        "release": box("bed", (0, 0, 0), (SIDE, SIDE, BED / 2), WET.replace(
            "saturation 1", "saturation 0.6")),
        "diameter": 0.005, "maxSpeed": 0.5, "end": 0.15, "interval": 0.15,
    })
    run(case)
    table = case.table()
    heat = {n: table[n][-1] for n in ("diffusion", "drag", "unexplained")}
    return [
        (abs(heat["diffusion"]) < 0.1 * heat["drag"],
         "pores: diffusion %.1e J, drag %.1e J (a tenth)"
         % (heat["diffusion"], heat["drag"])),
        (abs(heat["unexplained"]) < 0.005 * heat["drag"],
         "pores: energy unexplained %.1e J (0.5 %% of drag)"
         % heat["unexplained"]),
    ]


# ---------------------------------------------------------------- alone

# scene, passes over pairs and over the ground a step, bytes a particle: 144 of
# each phase, all of them beside the ground, whose sums are a third of it
# bytes with the bits of neighbours and of the elements of the ground, which
# are many in a tank where all particles are near walls
COST = (("grains", 2, 1, 1080), ("water", 2, 1, 900), ("both", 11, 2, 1200),
        ("standard", 2 + 2 / 6, 1, 1600))
# the first three with the plain scheme, the last with that of the default, of which
# two passes are made in one step of six, at its own time step


def alone():
    """Two tanks apart from each other, one of grains, one of water: all
    runs take the same steps, for maxDeltaT rules"""
    side, depth, apart = 6 * DX, 8 * DX, 30 * DX
    column = 3 * DX

    def tank(name, x0):
        text = floor(x0, x0 + side, 0, side) + walls(
            x0, x0 + side, 0, side, 0, 2 * depth)
        for word in ("floor", "left", "right", "front", "back"):
            text = text.replace(word + " {", name + word + " {")
        return text

    ground = tank("a", 0) + tank("b", apart)
    grains = box("column", (0, 0, 0), (column, side, depth), DRY)
    water = box("dam", (apart, 0, 0), (apart + column, side, depth), "water {}")
    fields = {}
    for name, phases, release in (
        ("both", "grains water", grains + water),
        ("grains", "grains", grains),
        ("water", "water", water),
        ("standard", "grains", grains),
    ):
        case = Case(os.path.abspath("case.alone." + name))
        write(case, {
            "zones": "floor { friction Coulomb; mu 0.5; } "
                     "walls { friction none; }",
            "ground": ground, "release": release,
            "state": " TaitCoeffs { soundSpeed 20; }",
            "maxSpeed": 1.5, "end": 0.1, "interval": 0.1,
            "control": "" if name == "standard" else "maxDeltaT 2e-5;",
            "solution": PLAIN if name in ("grains", "both") else "",
        }, phases)
        run(case)
        last = case.times()[-1]
        for cloud in ("grains", "water"):
            if cloud in phases:
                names = ["positions", "U", "id"]
                names += ["sigma"] if cloud == "grains" else ["p", "rho"]
                fields[name, cloud] = [
                    case.field(last, n, cloud) for n in names
                ]
                fields[name, cloud, "speed"] = max(
                    math.sqrt(sum(c * c for c in u))
                    for u in fields[name, cloud][1]
                )
        memory = re.search(
            r"(\S+) bytes a particle; ([\d.]+) pair passes and (\d+) ground pass",
            case.log("lpfSolver"),
        )
        fields[name] = [float(v) for v in memory.groups()]
    lines = [
        (abs(fields[name][1] - p) < 0.02 and fields[name][2] == w
         and fields[name][0] < most,
         "alone: %s: %.3g pair passes (%.3g), %d of the ground (%d), %.0f bytes a "
         "particle (%d)"
         % ((name, fields[name][1], p, fields[name][2], w, fields[name][0], most)))
        for name, p, w, most in COST
    ]
    return lines + [
        (fields["both", cloud] == fields[cloud, cloud]
         and fields[cloud, cloud, "speed"] > 0.1,
         "alone: %s have the same bits as without %s, largest speed %.2f m/s"
         % (cloud, other, fields[cloud, cloud, "speed"]))
        for cloud, other in (("grains", "water"), ("water", "grains"))
    ]


KINDS = {"slab": slabs, "pour": pour, "level": levels, "pores": pores,
         "alone": alone}


def main():
    failed = False
    for kind in sys.argv[1:]:
        for good, text in KINDS[kind]():
            failed = not ok(good, text) or failed
    return failed


if __name__ == "__main__":
    sys.exit(main())
