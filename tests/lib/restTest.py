#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Grains at rest in closed tanks with frictionless walls, 50 sqrt(H/g).

The resultant force of the ground is the weight, 1 %; sigma_zz of the level
floor at 20 layers within 5 % (L2 over its maximum); nothing creeps, nothing is
below the ground, and contact by projection carries less than 1 %.
Usage: test [shape ...]
"""
import math
import os
import sys
from concurrent.futures import ThreadPoolExecutor

from lpfCase import Case, jobs, ok
from tankShapes import DX, SHAPES, release

G = 9.81
RHO = 1300.0


def write(case, scene, end):
    case.write_gravity((0, 0, -G))
    case.write(
        "constant/phaseProperties",
        "phases (grains);\ngrains { rho 2600; diameter 0.002; rheology muI; "
        "muICoeffs { muS 0.3839; mu2 0.6494; I0 0.28; nu 0.36; E auto; "
        "initialStress geostatic; } }",
    )
    case.write(
        "constant/boundaryProperties",
        "contact signedDistance;\n"
        "zones { floor { friction none; } walls { friction none; } }",
    )
    case.write(
        "system/terrainToParticlesDict",
        "spacing %g;\norigin (0 0 0);\nmaxSpeed 0.1;\nground\n{\n%s}\n%s"
        % (
            DX,
            scene["ground"],
            release(scene, "grains { solidFraction 0.5; }"),
        ),
    )
    case.write(
        "system/controlDict",
        "startFrom startTime; startTime 0; stopAt endTime; endTime %.17g;\n"
        "writeControl adjustableRunTime; writeInterval %.17g;" % (end, end / 20),
    )
    case.write("system/lpfSolution", "logInterval 200;")


def mean(values):
    return sum(values) / len(values)


def by_id(case, time, name):
    return dict(zip(case.field(time, "id"), case.field(time, name)))


def stress_error(case, scene, times):
    """L2 of sigma_zz, mean over times, over its maximum on the floor"""
    depth = {
        i: scene["level"] - x[2]
        for i, x in by_id(case, times[0], "positions").items()
    }
    total = dict.fromkeys(depth, 0.0)
    for time in times:
        for i, s in by_id(case, time, "sigma").items():
            total[i] += s[5] / len(times)
    square = [(total[i] + RHO * G * depth[i]) ** 2 for i in depth]
    return math.sqrt(mean(square)) / (RHO * G * scene["level"])


def judge(name, scene, case):
    lines = []
    table = case.table()
    last = len(table["time"])
    half = next(
        k for k, t in enumerate(table["time"]) if t > 0.5 * table["time"][-1]
    )
    span = table["time"][-1] - table["time"][half]
    weight = table["mass"][-1] * G

    force = mean(table["wallForceZ"][half:last])
    lines.append((
        abs(force / weight - 1) < 0.01,
        "%s: ground carries %.4f of the weight (1 %%)" % (name, force / weight),
    ))
    wall = table["wallImpulse"][-1] - table["wallImpulse"][half]
    contact = table["contactImpulse"][-1] - table["contactImpulse"][half]
    lines.append((
        contact < 0.01 * wall,
        "%s: contact %.2e of the wall impulse (1 %%)" % (name, contact / wall),
    ))

    times = case.times()
    middle, end = times[len(times) // 2], times[-1]
    x0, x1 = by_id(case, middle, "positions"), by_id(case, end, "positions")
    moved = max(math.dist(x0[i], x1[i]) for i in x0)
    lines.append((
        moved < 0.1 * DX and len(x1) == len(by_id(case, "0", "id")),
        "%s: moved %.4f dx from half time to the end (%.1f s), none left"
        % (name, moved / DX, span),
    ))
    lowest = min(x[2] - scene["height"](x[0], x[1]) for x in x1.values())
    lines.append((
        lowest > 0,
        "%s: lowest grain %.3f dx above the ground" % (name, lowest / DX),
    ))
    if name == "level":
        error = stress_error(case, scene, times[len(times) // 2:])
        lines.append((
            error < 0.05, "%s: sigma_zz L2 %.4f of its maximum (5 %%)"
            % (name, error)
        ))
    speed = max(table["maxSpeed"][half:]) / math.sqrt(G * scene["H"])
    print("# %s: largest late speed %.1e sqrt(gH)" % (name, speed))
    return lines


def run(name):
    scene = SHAPES[name]()
    case = Case(os.path.abspath("case." + name))
    write(case, scene, 50 * math.sqrt(scene["H"] / G))
    case.run("terrainToParticles")
    case.run("lpfSolver", "-threads", "1")
    return judge(name, scene, case)


chosen = sys.argv[1:] or list(SHAPES)
failed = False
with ThreadPoolExecutor(jobs()) as pool:
    for lines in pool.map(run, chosen):
        for good, text in lines:
            failed = not ok(good, text) or failed
sys.exit(failed)
