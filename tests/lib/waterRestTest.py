#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Water at rest, alone (pool) or in a bed of grains that it fills (bed), in
closed tanks with frictionless walls.

The resultant force of the ground is the weight, 1 %; pressure of the lowest
layer within 3 % of rho g H (L2; 6 % in gullies); in a bed the pressure gradient
carries rho_f/rho_p of each layer of grains, 3 %; energy that no term names below
0.1 % of m g H.
Usage: test pool|bed shape ...
"""
import math
import os
import sys
from concurrent.futures import ThreadPoolExecutor

from lpfCase import Case, averaged, jobs, mean, ok
from tankShapes import DX, SHAPES, release

G = 9.81
RHO = 1000.0
RHO_GRAIN = 2600.0
BOUND = {"gully30": 0.06, "corner90": 0.06}
SPAN = 10
SCHEME = {
    "pool": "CFL 0.2; water { shifting 3; densityRelaxation 0.001; }\n",
    "bed": "water { shifting 3; }\n",
}


def write(case, scene, kind, end):
    case.write_gravity((0, 0, -G))
    grains = (
        "grains { rho 2600; diameter 0.002; rheology muI; "
        "muICoeffs { muS 0.3839; mu2 0.6494; I0 0.28; nu 0.36; E auto; "
        "initialStress geostatic; } }\n"
    )
    water = "water { rho 1000; NewtonianCoeffs { mu 1e-3; } }\n"
    bed = kind == "bed"
    case.write(
        "constant/phaseProperties",
        "phases (%swater);\n%s%s"
        % ("grains " if bed else "", grains if bed else "", water),
    )
    if bed:
        case.write("constant/interphaseProperties", "drag Gidaspow;")
    case.write(
        "constant/boundaryProperties",
        "contact signedDistance;\n"
        "zones { floor { friction none; } walls { friction none; } }",
    )
    phases = "water { saturation 1; } grains { solidFraction 0.5; }"
    case.write(
        "system/terrainToParticlesDict",
        "spacing %g;\norigin (0 0 0);\nmaxSpeed 0.1;\nground\n{\n%s}\n%s"
        % (DX, scene["ground"], release(scene, phases if bed else "water {}")),
    )
    case.write(
        "system/controlDict",
        "startFrom startTime; startTime 0; stopAt endTime; endTime %.17g;\n"
        "writeControl adjustableRunTime; writeInterval %.17g;" % (end, end / 40),
    )
    case.write("system/lpfSolution", SCHEME[kind] + "logInterval 200;")


def cell(x):
    return tuple(math.floor(c / DX) for c in x)


def level_of(positions):
    """Half a spacing above the highest particle of a column, median"""
    top = {}
    for x in positions:
        column = cell(x)[:2]
        top[column] = max(x[2], top.get(column, x[2]))
    return sorted(top.values())[len(top) // 2] + 0.5 * DX


def errors_of_cells(samples, level):
    """Mean over times of p - rho g (level - z) in each cell; level is where
    the volume of the water ends"""
    found = {}
    for key, x, p in samples:
        found.setdefault(key, []).append(p - RHO * G * (level - x[2]))
    return [mean(e) for e in found.values()]


def pressure_lines(name, scene, case, times):
    samples, levels = [], []
    for time in times:
        positions = case.field(time, "positions", "water")
        levels.append(level_of(positions))
        samples += zip(positions, case.field(time, "p", "water"))
    level = scene.get("surface", scene.get("level"))
    full = RHO * G * max(level - x[2] for x, _ in samples)
    lowest = [
        (cell(x)[:2], x, p) for x, p in samples
        if x[2] - scene["height"](x[0], x[1]) < 1.0 * DX
    ]
    whole = [(cell(x), x, p) for x, p in samples]
    error, every = (
        math.sqrt(mean([e * e for e in errors_of_cells(s, level)])) / full
        for s in (lowest, whole)
    )
    bound = BOUND.get(name, 0.03)
    yield (
        error < bound,
        "%s: pressure of the lowest layer, L2 %.4f (%g), of all %.4f; level "
        "%.3f m of %.3f" % (name, error, bound, every, mean(levels), level),
    )


def buoyancy_lines(name, case, times):
    x = averaged(case, times, "positions", "grains")
    a = averaged(case, times, "gradPForce", "grains")
    exact = RHO / RHO_GRAIN * G
    layers = {}
    lowest = min(v[2] for v in x.values())
    for i, v in x.items():
        layers.setdefault(int((v[2] - lowest) / DX + 0.5), []).append(a[i][2])
    share = {k: mean(v) / exact for k, v in sorted(layers.items())}
    rms = math.sqrt(mean([(v[2] / exact - 1) ** 2 for v in a.values()]))
    worst = max(abs(s - 1) for s in share.values())
    print("# %s: buoyancy by layer %s"
          % (name, " ".join("%.3f" % s for s in share.values())))
    yield (
        worst < 0.03,
        "%s: mean buoyancy of a layer off by at most %.4f (3 %%), rms of a "
        "grain %.4f" % (name, worst, rms),
    )


def judge(kind, name, scene, case):
    lines = []
    table = case.table()
    half = next(
        k for k, t in enumerate(table["time"]) if t > 0.5 * table["time"][-1]
    )
    weight = table["mass"][-1] * G
    force = mean(table["wallForceZ"][half:])
    lines.append((
        abs(force / weight - 1) < 0.01,
        "%s: ground carries %.4f of the weight (1 %%)" % (name, force / weight),
    ))
    times = case.times()
    late = times[len(times) // 2:]
    lines += pressure_lines(name, scene, case, late)
    if kind == "bed":
        lines += buoyancy_lines(name, case, late)
    energy = table["mass"][0] * G * scene["H"]
    lines.append((
        abs(table["unexplained"][-1]) < 1e-3 * energy,
        "%s: energy unexplained %.2e of m g H (1e-3)"
        % (name, table["unexplained"][-1] / energy),
    ))
    lines.append((
        max(table["left"]) == 0, "%s: nothing left the tank" % name,
    ))
    speed = max(table["maxSpeed"][half:]) / math.sqrt(G * scene["H"])
    print("# %s: largest late speed %.1e sqrt(gH)" % (name, speed))
    return lines


def run(kind, name):
    scene = SHAPES[name]()
    case = Case(os.path.abspath("case." + name))
    write(case, scene, kind, SPAN * math.sqrt(scene["H"] / G))
    case.run("terrainToParticles")
    case.run("lpfSolver", "-threads", "1")
    return judge(kind, name, scene, case)


def main():
    kind, chosen = sys.argv[1], sys.argv[2:] or list(SHAPES)
    failed = False
    with ThreadPoolExecutor(jobs()) as pool:
        for lines in pool.map(lambda name: run(kind, name), chosen):
            for good, text in lines:
                failed = not ok(good, text) or failed
    return failed


sys.exit(main())
