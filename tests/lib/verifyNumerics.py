# SPDX-License-Identifier: GPL-3.0-or-later
"""What any result must not depend on, and the ledger of energy."""
import math
import os
import re
import subprocess

from planeScene import G, Scene
from verify import Measured, Verification
from verifyColumns import PLANE, SAND
from verifyDamBreak import Ritter
from verifyRest import SaturatedBed


class Symmetry(Verification):
    """The scene of tests/cases/quick/symmetry, turned and mirrored"""

    name = "symmetry"
    reference = (
        "the same scene turned by 90 degrees about x, y, z and mirrored in x, y, "
        "z: positions, velocity, stress, density after 200 steps")
    of, layers = "turns and mirrors", (3,)
    bounds = {"turned": 1e-9, "mirrored": 1e-9}

    def label(self, layers):
        return "3 + 3"

    def measure(self, layers):
        script = os.path.join(
            os.environ["LPF_PROJECT_DIR"], "tests/cases/quick/symmetry/test")
        text = subprocess.run(
            [script], capture_output=True, text=True, check=True).stdout
        return Measured({word: self.largest(text, word) for word in self.bounds})

    @staticmethod
    def largest(text, word):
        """Of the lines that give figures; the others say what was compared"""
        lines = re.findall(r"ok - %s .*positions (.*)" % word, text)
        if len(lines) != 3:
            raise RuntimeError("%d lines of %s" % (len(lines), word))
        return max(float(v) for line in lines
                   for v in re.findall(r"\d\.\d+e[-+]\d+", line))


class SpacingPairs(SaturatedBed):
    name = "spacingPairs"
    of, layers, judged = "spacing of grains over that of water", (1, 1.3, 2), 1
    reference = SaturatedBed.reference + ", 20 layers of grains"
    converges = False
    negatives = {}

    def measure(self, ratio):
        return super().measure(20, more="water { spacingRatio %g; }\n" % ratio)


class TimeStep(Verification):
    """Column and dam break with the CFL number of the default, its half and
    quarter; with notes on what they give"""

    name = "timeStep"
    reference = "Lube 2005, a = 1: runout 1.2, 20 layers; Ritter, 10 layers; CFL 0.45, 0.225, 0.1125"
    of, layers, judged = "steps in one", (1, 2, 4), 1
    bounds = {"runout": 0.15, "depth": 0.05}

    def measure(self, parts):
        cfl = "CFL %g;" % (0.45 / parts)
        column = PLANE[1]().measure(20, solution=cfl)
        dam = Ritter().measure(10, solution=cfl)
        return Measured(
            {"runout": column.errors["runout"], "depth": dam.errors["depth"]},
            {("column " + k if k[:3] != "ref" else k): v
             for k, v in column.curves.items() if k != "reference height"},
            {"runout": column.notes["runout"]})


class Energy(Verification):
    """A body falls over in a closed box with rough floor"""

    reference = (
        "a closed box: energy never rises by more than 0.5 % of what is "
        "released, and the losses, each by its own sum, are what is released")
    bounds = {"rise": 0.005, "unexplained": 0.02}
    axes = ("t sqrt(g/H)", "energy lost, sum of losses over released")
    phases, content, H = "grains", "grains { solidFraction 0.6; }", 0.1
    high = 3  # walls over H
    LOSSES = ("plastic", "separation", "friction", "viscous", "projection",
              "wallTension", "leftEnergy", "artificial", "diffusion", "drag")

    def measure(self, layers):
        H = self.H
        scene = Scene(
            dx=H / layers, phases=self.phases, maxSpeed=1.4, log=50, mu=1e-3,
            grains=SAND, diameter=0.002,
            zones="floor { friction Coulomb; mu 0.5; } wall { friction none; }")
        scene.ground = (
            scene.floor(0, 2 * H) + scene.wall("left", 0, 1, self.high * H)
            + scene.wall("right", 2 * H, -1, self.high * H))
        scene.release = scene.box("body", 0, H, 0, H, self.content)
        scene.end = 10 * math.sqrt(H / G)
        case = scene.run("%s%d" % (self.name, layers))
        return self.ledger(case.table())

    def ledger(self, t):
        total = [sum(v) for v in zip(t["kinetic"], t["potential"], t["elastic"])]
        loss = [sum(v) for v in zip(*(t[name] for name in self.LOSSES))]
        released = total[0] - min(
            p + e for p, e in zip(t["potential"], t["elastic"]))
        lowest, rise = total[0], 0.0
        for e in total:
            lowest = min(lowest, e)
            rise = max(rise, e - lowest)
        off = max(abs(total[0] - e - s) for e, s in zip(total, loss))
        unit = math.sqrt(self.H / G)
        every = max(1, len(total) // 60)
        time = [s / unit for s in t["time"]][::every]
        return Measured(
            {"rise": rise / released, "unexplained": off / released},
            {"reference energy lost":
                (time, [(total[0] - e) / released for e in total][::every]),
             "sum of losses": (time, [s / released for s in loss][::every])})


class EnergyGrains(Energy):
    name = "energy.grains"


class EnergyWater(Energy):
    name = "energy.water"
    high = 8  # a drop of the splash flies above 5 H
    phases, content = "water", "water {}"


class EnergyBoth(Energy):
    name = "energy.both"
    layers = (8, 16, 24)
    phases = "grains water"
    content = "grains { solidFraction 0.5; } water { saturation 1; }"


CASES = (Symmetry, SpacingPairs, TimeStep, EnergyGrains, EnergyWater, EnergyBoth)
