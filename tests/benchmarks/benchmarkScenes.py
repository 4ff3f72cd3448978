# SPDX-License-Identifier: GPL-3.0-or-later
"""Scenes of the benchmark, what a log of the solver says of them, and tables.

A scene is a dictionary of what stands in the dictionaries of a case; see SCENES.
"""
import math
import os
import re
import shutil
import sys

sys.path.insert(
    0, os.path.join(os.path.dirname(os.path.abspath(__file__)), "../lib"))
from lpfCase import Case  # noqa: E402

H_OVER_DX = 1.3
G = 9.81
CFL = 0.45
# Column of 1 x 0.5 x 1 m at the end of a tank of 3 x 0.5 x 1.5 m
COLUMN = (1.0, 0.5, 1.0)
TANK = "ground { tank { type box; min (0 0 0); max (3 0.5 1.5); " \
    "side inside; omit (zMax); } }\n"
MAX_SPEED = 4.5
WATER_SPEED = 10 * 2 * (G * COLUMN[2]) ** 0.5
PHASES = {"water": "water", "grains": "grains", "mixture": "grains water"}
RELEASE = {
    "water": "water {}",
    "grains": "grains { solidFraction 0.6; }",
    "mixture": "grains { solidFraction 0.5; } water { saturation 1; }",
}


def column(scene, particles, **change):
    """The column of so many particles of each phase, in a tank"""
    spacing = (COLUMN[0] * COLUMN[1] * COLUMN[2] / particles) ** (1 / 3)
    return dict({
        "phases": PHASES[scene], "spacing": spacing, "maxSpeed": MAX_SPEED,
        "g": (0, 0, -G), "ground": TANK, "release": RELEASE[scene],
        "box": COLUMN, "soundSpeed": "auto", "E": "auto", "CFL": CFL,
        "rhoGrains": 2600, "rhoWater": 1000, "mu": 1e-3, "diameter": 0.005,
        "friction": 0.5, "precision": "double"}, **change)


def sheet(**change):
    """8056 + 8056 particles of 5.64 m, two layers on a slope of 14 degrees, as
    the debris flow of Xianchi has them: gravity is tilted, not the ground"""
    slope, spacing = math.radians(14.04), 5.64
    return column("mixture", 1, **dict({
        "spacing": spacing, "maxSpeed": 24.6, "soundSpeed": 246,
        "g": (G * math.sin(slope), 0, -G * math.cos(slope)),
        "ground": "ground { slope { type plane; point (800 150 0); normal "
                  "(0 0 1); direction (1 0 0); size (2400 900); } }\n",
        "box": (76 * spacing, 53 * spacing, 2 * spacing),
        "rhoGrains": 2100, "rhoWater": 1100, "mu": 0.017, "diameter": 3,
        "friction": 0.3}, **change))


def write(path, scene, end=1e-9, interval=None):
    """The case of a scene, prepared"""
    case = Case(path)
    case.write_gravity(scene["g"])
    case.write(
        "constant/phaseProperties",
        "phases (%(phases)s);\n"
        "grains { rho %(rhoGrains)g; diameter %(diameter)g; rheology muI; "
        "muICoeffs { muS 0.38; mu2 0.65; I0 0.28; nu 0.3; E %(E)s; "
        "cohesion 0; initialStress geostatic; } }\n"
        "water { rho %(rhoWater)g; equationOfState Tait; TaitCoeffs { gamma 7; "
        "soundSpeed %(soundSpeed)s; } viscosity Newtonian; NewtonianCoeffs "
        "{ mu %(mu)g; } }" % scene)
    if scene["phases"] == PHASES["mixture"]:
        case.write("constant/interphaseProperties", "drag Gidaspow;")
    case.write(
        "constant/boundaryProperties",
        "contact signedDistance;\n"
        "zones { %s { friction Coulomb; mu %g; } }"
        % (re.search(r"{ (\w+)", scene["ground"]).group(1), scene["friction"]))
    case.write(
        "system/terrainToParticlesDict",
        "spacing %.9g;\norigin (0 0 0);\nmaxSpeed %g;\n%s"
        "release { type box; corner (0 0 0); "
        "edges ((%.9g 0 0) (0 %.9g 0) (0 0 %.9g)); %s }"
        % (scene["spacing"], scene["maxSpeed"], scene["ground"],
           *scene["box"], scene["release"]))
    solution = "logInterval 1000;\nCFL %s;\n" % scene["CFL"]
    if scene["precision"] != "double":
        solution += "precision %s;\n" % scene["precision"]
    case.write("system/lpfSolution", solution)
    control(case, end, interval)
    case.run("terrainToParticles")
    return case


def prepare(path, scene, steps):
    """A case that runs some `steps`: the step is that of a first one"""
    case = write(path, scene)
    first = solve(case, 1)
    control(case, steps * first["deltaT"])
    return case


def control(case, end, interval=None):
    case.write(
        "system/controlDict",
        "startFrom startTime; startTime 0; stopAt endTime; endTime %.9g;\n"
        "deltaT 1; writeControl adjustableRunTime; writeInterval %.9g;\n"
        "timePrecision 12;" % (end, interval or end))


NUMBERS = {
    "steps": r"Wall time of (\d+) steps",
    "wall": r"steps (\S+) s,",
    "rate": r"s, (\S+) particle-steps/s; c dt/h",
    "courant": r"c dt/h (\S+),",
    "perSecond": r", (\S+) s a simulated second",
    "bytes": r"MiB, (\S+) bytes a particle",
    "passes": r"; ([\d.]+) pair passes",
    "processor": r", (\S+) particle-steps in a second of one",
    "pairs": r"Pairs of a particle within the support (\S+)",
}


def removeTimes(case):
    shutil.rmtree(
        os.path.join(case.path, "postProcessing"), ignore_errors=True)
    for name in case.times():
        if name != "0":
            shutil.rmtree(os.path.join(case.path, name))


def solve(case, threads):
    """What the log of one run says"""
    removeTimes(case)
    case.run("lpfSolver", "-threads", str(threads))
    log = case.log("lpfSolver")
    found = {}
    for key, pattern in NUMBERS.items():
        match = re.search(pattern, log)
        found[key] = float(match.group(1)) if match else float("nan")
    found["table"] = re.findall(
        r"^ +([\d.]+) +([\d.]+) +([\d.]+) +(\d+)  (\S.*)$",
        log[log.find("share %"):], re.M)
    # made once a run, which is short here
    set_up = [row for row in found["table"]
              if row[4].endswith("elements of the ground")]
    found["table"] = [row for row in found["table"] if row not in set_up]
    once = sum(float(share) for share, *_ in set_up)
    for key in "rate", "processor":
        found[key] /= 1 - 0.01 * once
    for key in "wall", "perSecond":
        found[key] *= 1 - 0.01 * once
    found["engine"] = re.search(r"Pair engine (.*);", log).group(1)
    found["particles"] = sum(
        int(n) for n in re.findall(r"(\d+) particles of \w+,", log))
    speeds = re.findall(r"(?:wave speed|c0) (\S+) m/s", log)
    found["soundSpeed"] = max(float(c) for c in speeds)
    found["h"] = float(re.search(r"smoothing length (\S+) m", log).group(1))
    found["deltaT"] = CFL * found["h"] / found["soundSpeed"]
    return found


def nanoseconds(found, pattern):
    """Of a processor a particle-step, in the passes that match"""
    return sum(float(ns) for _, _, ns, _, what in found["table"]
               if re.search(pattern, what))


class Tables:
    """Lines and tables as they are found, on the screen and for a document"""

    def __init__(self):
        self.text = []

    def line(self, text=""):
        print(text, flush=True)
        self.text.append(text)

    def table(self, head, rows):
        rows = [[str(c) for c in row] for row in rows]
        self.line()
        self.line("| " + " | ".join(head) + " |")
        self.line("|" + "---|" * len(head))
        for row in rows:
            self.line("| " + " | ".join(row) + " |")
        self.line()
