#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""What the paper leaves open about its flume, one reading a row.

Each row changes the tutorials ../water30 and ../water70 in what it names, runs
them and takes the front of the grains at the end, from the gate. Estimates: a
depth-averaged model in one dimension without drainage, of the reading with that
friction and pore pressure, where there is one.
"""
import os
import re
import shutil
import subprocess
import sys
from concurrent.futures import ThreadPoolExecutor

HERE = os.path.dirname(os.path.abspath(__file__))
BULK, GRAINS = 100 / (0.5 * 2600), 100.0
WATER = {"water30": 0.3 * BULK * 1000, "water70": 0.7 * BULK * 1000}
# r_u of the paper's Table 1: chute, plate
RU = {"water30": (0.5, 0.7), "water70": (0.55, 0.8)}
PAPER = {"water30": 5.2, "water70": 8.2}

# r_u, mu_s inside, diameter [m], packing, friction of side walls; estimates
ROWS = [
    ("none", 0.3839, 0.005, "mixed", True, (6.0, None)),
    ("none", 0.46, 0.005, "mixed", True, (5.2, 7.9)),
    ("none", 0.8, 0.005, "mixed", True, (3.3, 5.0)),
    ("none", 0.3839, 0.02, "mixed", True, None),
    ("none", 0.3839, 0.005, "settled", True, None),
    ("none", 0.3839, 0.005, "mixed", False, None),
    ("both", 0.3839, 0.005, "mixed", True, (7.2, None)),
    ("total", 0.3839, 0.005, "mixed", True, (4.4, 5.8)),
    ("both", 0.46, 0.02, "settled", False, None),
]


def edit(folder, file, changes):
    path = os.path.join(folder, file)
    text = open(path).read()
    for pattern, new in changes:
        text, count = re.subn(pattern, new, text, flags=re.M)
        if count == 0:
            raise RuntimeError("%s has no '%s'" % (path, pattern))
    with open(path, "w") as f:
        f.write(text)


def release(condition, ru, packing):
    """The body of the release: grains, and water as the reading has it"""
    fill = (
        "    type    fill;\n"
        "    box     (($xRear -0.25 $zRear) ($xGateTop 0.25 $zGateTop));\n"
        "    volume  %.9g;\n    surface level;\n    %s\n"
    )
    if ru == "total":
        mass = GRAINS + WATER[condition]
        return fill % (BULK, "grains { solidFraction 0.5; mass %.9g; }" % mass)
    if condition == "water70":
        if packing == "settled":
            return fill % (BULK, "grains { solidFraction 0.5; mass 100; } "
                           "water { dryBulkFraction 0.7; excess onTop; }")
        volume = GRAINS / 2600 + WATER[condition] / 1000
        return fill % (
            volume, "grains { solidFraction %.9g; mass 100; } "
            "water { saturation 1; }" % (GRAINS / 2600 / volume))
    if packing == "mixed":
        return fill % (BULK, "grains { solidFraction 0.5; mass 100; } "
                       "water { dryBulkFraction 0.3; }")
    # six tenths of the bed full, along the floor, the rest dry
    layers = ""
    depth = BULK / 0.25
    for name, low, high, water in (
        ("wet", 0, 0.6 * depth, "water { saturation 1; }"),
        ("dry", 0.6 * depth, depth, ""),
    ):
        layers += (
            "%s { type box; corner (#eval{ -3.5*cos(degToRad(20)) + "
            "%.9g*sin(degToRad(20)) } -0.25 #eval{ 3.5*sin(degToRad(20)) + "
            "%.9g*cos(degToRad(20)) }); edges ((#eval{ 0.5*cos(degToRad(20)) } "
            "0 #eval{ -0.5*sin(degToRad(20)) }) (0 0.5 0) (#eval{ "
            "%.9g*sin(degToRad(20)) } 0 #eval{ %.9g*cos(degToRad(20)) })); "
            "grains { solidFraction 0.5; mass %.9g; } %s }\n"
            % (name, low, low, high - low, high - low,
               GRAINS * (high - low) / depth, water)
        )
    return layers


def make(folder, condition, row, spacing):
    ru, mu_s, diameter, packing, side = row[:5]
    shutil.copytree(os.path.join(HERE, "..", condition), folder,
                    ignore=shutil.ignore_patterns(
                        "[0-9]*", "postProcessing", "log.*", "VTK", "*.foam",
                        "polyMesh", "terrain", "releaseProperties"))
    edit(folder, "system/terrainToParticlesDict", [
        (r"^spacing .*", "spacing %g;" % spacing),
        (r"^release\n\{[\s\S]*?^\}",
         "release\n{\n%s}" % release(condition, ru, packing)),
    ])
    edit(folder, "system/depositionSampleDict", [
        (r"^cellSize .*", "cellSize %g;" % (spacing / 5)),
    ])
    edit(folder, "system/controlDict", [(r"^writeInterval .*", "writeInterval 0.5;")])
    edit(folder, "constant/phaseProperties", [
        (r"\bmuS +[^;]*;", "muS %g;" % mu_s),
        # mu_2 is above mu_s
        (r"\bmu2 +[^;]*;", "mu2 %g;" % max(0.6494, mu_s + 0.05)),
        (r"diameter .*", "diameter %g;" % diameter),
    ])
    chute, plate = RU[condition] if ru != "none" else (0, 0)
    zones = [
        (r"(hopper|chute) .*", r"\1 { friction Coulomb; mu 0.8; ru %g; }" % chute),
        (r"plate .*", "plate { friction Coulomb; mu 0.8; ru %g; }" % plate),
    ]
    if not side:
        zones.append((r"walls .*", "walls { friction none; }"))
    edit(folder, "constant/boundaryProperties", zones)
    if ru == "total":
        mass = 1 + WATER[condition] / GRAINS
        edit(folder, "constant/phaseProperties", [
            (r"phases +\([^)]*\);", "phases (grains);"),
            (r"rho +\[[^\]]*\] 2600;.*", "rho %.9g;" % (2600 * mass)),
            (r"^water\n\{[\s\S]*?^\}", ""),
        ])
        os.remove(os.path.join(folder, "constant/interphaseProperties"))


def run(folder):
    for application, options in (
        ("terrainToParticles", []),
        ("lpfSolver", ["-threads", "1"]),
        ("depositionSample", ["-latestTime"]),
    ):
        with open(os.path.join(folder, "log." + application), "w") as log:
            status = subprocess.run(
                [application, "-case", folder] + options, stdout=log,
                stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL).returncode
        if status:
            return "%s failed" % application
    return None


def front(folder):
    """Of the grains at the last time, from fronts.csv"""
    for root, _, files in os.walk(os.path.join(folder, "postProcessing")):
        if "fronts.csv" in files and os.path.basename(root) not in (
                "water", "bulk"):
            lines = open(os.path.join(root, "fronts.csv")).read().split("\n")
            names = [x for x in lines if x.startswith("#") and "," in x][-1]
            column = [n.strip("# ").split("[")[0].strip()
                      for n in names.split(",")]
            rows = [x for x in lines if x.strip() and not x.startswith("#")]
            place = next(k for k, n in enumerate(column)
                         if n.endswith("front"))
            return float(rows[-1].split(",")[place])
    return float("nan")


def result(job):
    index, condition, row, spacing = job
    folder = os.path.join(HERE, "run", "%d.%s" % (index, condition))
    make(folder, condition, row, spacing)
    problem = run(folder)
    if problem:
        return problem
    left = re.findall(r"mass +water: .* left (\S+) kg",
                      open(os.path.join(folder, "log.lpfSolver")).read())
    return "%.2f (%s)" % (front(folder), left[-1] if left else "no water")


def main():
    spacing = float(sys.argv[1]) if len(sys.argv) > 1 else 0.05
    shutil.rmtree(os.path.join(HERE, "run"), ignore_errors=True)
    jobs = [
        (k, c, row, spacing) for k, row in enumerate(ROWS)
        for c in ("water30", "water70")
    ]
    with ThreadPoolExecutor(2) as pool:
        found = list(pool.map(result, jobs))
    lines = [
        "Front of the grains at 5 s from the gate [m], in brackets the water "
        "that left the plate [kg]; spacing %g m" % spacing, "",
        "| r_u | mu_s | d [mm] | packing | friction of side walls | II | III "
        "| estimate II, III |",
        "|---|---|---|---|---|---|---|---|",
    ]
    for k, row in enumerate(ROWS):
        ru, mu_s, diameter, packing, side, estimate = row
        text = "" if not estimate else ", ".join(
            "beyond the plate" if e is None else "%.1f" % e for e in estimate)
        lines.append("| %s | %.2f | %g | %s | %s | %s | %s | %s |" % (
            ru, mu_s, 1e3 * diameter, packing, "yes" if side else "no",
            found[2 * k], found[2 * k + 1], text))
    lines.append("| paper | | | | | %.1f | %.1f | |"
                 % (PAPER["water30"], PAPER["water70"]))
    text = "\n".join(lines) + "\n"
    with open(os.path.join(HERE, "readings.md"), "w") as f:
        f.write(text)
    print(text)
    return any("failed" in f for f in found)


sys.exit(main())
