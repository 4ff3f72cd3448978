# SPDX-License-Identifier: GPL-3.0-or-later
"""Dam breaks against shallow-water solutions and measurements, plane strain."""
import csv
import math
import os

from planeScene import G, Scene, front, rms, thickness
from verify import Measured, Verification

H0 = 0.4
DATA = os.path.join(
    os.path.dirname(os.path.abspath(__file__)), "..", "reference")


def ritter(x, t, c0, m0=0.0):
    """Depth over h0: Ritter, and with m0 its form on a slope (Mangeney 2000)"""
    s = x / t - 0.5 * m0 * t
    if s <= -c0:
        return 1.0
    return 0.0 if s >= 2 * c0 else (2 - s / c0) ** 2 / 9


def bins(x0, x1, count):
    step = (x1 - x0) / count
    edges = [x0 + step * k for k in range(count + 1)]
    return edges, [0.5 * (a + b) for a, b in zip(edges, edges[1:])]


def binned(function, edges, parts=20):
    """Mean of a function over each bin"""
    return [
        sum(function(a + (b - a) * (k + 0.5) / parts) for k in range(parts)) / parts
        for a, b in zip(edges, edges[1:])]


def depths(case, scene, xs, h0, unit, exact, time=-1):
    """Depth over h0 in bins(...) at the last time, or that of the number given,
    against exact(x); x over unit"""
    edges, centres = xs
    found = [h / h0 for h in thickness(
        case, case.times()[time], scene.phases, edges, scene.dx ** 2)]
    expected = binned(exact, edges)
    xs = [x / unit for x in centres]
    return Measured(
        {"depth": rms(f - e for f, e in zip(found, expected))},
        {"reference": (xs, expected), "": (xs, found)})


class Ritter(Verification):
    name = "ritter"
    reference = (
        "Ritter: h = (2 c0 - x/t)^2/(9 g), x/(c0 t) from -0.8 to 1, "
        "t = 5 sqrt(h0/g)")
    bounds = {"depth": 0.05}
    axes = ("x/(c0 t)", "h/h0")
    negatives = {
        "gravity 40 % smaller": ({"gravity": 0.6 * G}, "depth", 20)}

    rear = -6 * H0  # further than the rarefaction goes

    def scene(self, layers):
        scene = Scene(dx=H0 / layers, phases="water", log=200,
                      maxSpeed=2 * math.sqrt(G * H0))
        scene.ground = (
            scene.floor(self.rear, 20 * H0)
            + scene.wall("rear", self.rear, 1, 2 * H0))
        scene.release = scene.box("dam", self.rear, 0, 0, H0, "water {}")
        return scene

    def measure(self, layers, gravity=G, solution=""):
        scene, c0 = self.scene(layers), math.sqrt(G * H0)
        scene.solution = solution
        scene.gravity = gravity
        t = scene.end = 5 * math.sqrt(H0 / G)
        case = scene.run("%s%d" % (self.name, layers))
        return depths(
            case, scene, bins(-0.8 * c0 * t, c0 * t, 36), H0, c0 * t,
            lambda x: ritter(x, t, c0))


def stoker(ratio):
    """(hm, um, S) over h0 and c0, by bisection of the depth in the middle"""
    def excess(h):
        return 2 * (1 - math.sqrt(h)) - (h - ratio) * math.sqrt(
            (h + ratio) / (2 * h * ratio))

    low, high = ratio, 1.0
    for _ in range(100):
        middle = 0.5 * (low + high)
        low, high = (middle, high) if excess(middle) > 0 else (low, middle)
    um = 2 * (1 - math.sqrt(low))
    return low, um, low * um / (low - ratio)


class Stoker(Ritter):
    name = "stoker"
    reference = (
        "Stoker, wet bed of 0.1 h0: rarefaction, middle state, bore; x/(c0 t) "
        "from -0.8 to 1.3, t = 8 sqrt(h0/g); noted is the error at 5 sqrt(h0/g)")
    bounds = {"depth": 0.05}
    axes = ("x/(c0 t)", "h/h0")
    ratio = 0.1
    rear = -9 * H0
    findings = {"depth": (
        "shallow water is the flow after a long time: it leaves out the width of "
        "the bore, 0.5 h0, and the splash of the first moment. What they do falls "
        "with time, not with refinement.")}
    negatives = {"bed of 0.25 h0": ({"bed": 0.25}, "depth", 20)}

    def measure(self, layers, bed=0.1):
        scene, c0 = self.scene(layers), math.sqrt(G * H0)
        end = 13 * H0
        scene.ground += scene.wall("far", end, -1, 2 * H0)
        scene.release += scene.box("bed", 0, end, 0, bed * H0, "water {}")
        unit = math.sqrt(H0 / G)
        scene.end, scene.writes = 8 * unit, 8
        case = scene.run("%s%d" % (self.name, layers))
        hm, _, S = stoker(self.ratio)

        def depth_at(t):
            def depth(x):
                s = x / (c0 * t)
                return self.ratio if s > S else max(hm, ritter(x, t, c0))

            return depths(
                case, scene, bins(-0.8 * c0 * t, 1.3 * c0 * t, 42), H0, c0 * t,
                depth, round(t / unit))

        found, before = depth_at(8 * unit), depth_at(5 * unit)
        found.notes["depth"] = "%.3g %% at 5" % (100 * before.errors["depth"])
        return found


def table(name):
    with open(os.path.join(DATA, name), encoding="utf-8") as file:
        rows = csv.reader(x for x in file if not x.startswith("#"))
        next(rows)
        return [tuple(map(float, r)) for r in rows]


def interpolated(points, x):
    for (x0, y0), (x1, y1) in zip(points, points[1:]):
        if x0 <= x <= x1:
            return y0 + (y1 - y0) * (x - x0) / (x1 - x0)
    return points[0][1] if x < points[0][0] else points[-1][1]


class MartinMoyce(Verification):
    name = "martinMoyce"
    reference = (
        "Martin and Moyce 1952, column a x 2a, tables 2 and 6; time moved so "
        "that Z = 1.44 at T = 1.19")
    of = "spacings in a"
    bounds = {"front": 0.10, "height": 0.10}
    axes = ("t sqrt(2g/a); t sqrt(g/a)", "x/a; h/(2a)")
    negatives = {
        "column a x a": ({"tall": 1}, "height", 20)}
    a = 0.05715

    def measure(self, layers, tall=2):
        a = self.a
        scene = Scene(dx=a / layers, phases="water", log=200, mu=1e-3,
                      maxSpeed=2 * math.sqrt(2 * G * a))
        scene.ground = (
            scene.floor(0, 12 * a) + scene.wall("rear", 0, 1, 4 * a))
        scene.release = scene.box("column", 0, a, 0, tall * a, "water {}")
        unit = math.sqrt(a / (2 * G))  # of T
        scene.end, scene.writes = 4.4 * unit, 44
        case = scene.run("%s%d" % (self.name, layers))
        Z, height = [], []
        for time in case.times():
            T = float(time) / unit
            Z.append((T, front(case, time, "water", scene.dx) / a))
            side = thickness(case, time, "water", [0, a / 5], scene.dx ** 2)
            height.append((T / math.sqrt(2), side[0] / (2 * a)))
        return self.compared(Z, height)

    @staticmethod
    def compared(Z, height):
        crossing = next(
            (s + (t - s) * (1.44 - y) / (z - y)
             for (s, y), (t, z) in zip(Z, Z[1:]) if y <= 1.44 <= z))
        shift = 1.19 - crossing
        measured = [p for p in table("martinMoyceFront.csv") if p[0] >= 1.19]
        heights = [p for p in table("martinMoyceHeight.csv")
                   if p[0] <= 2.8]
        moved = [(t + shift, z) for t, z in Z]
        fallen = [(t + shift / math.sqrt(2), h) for t, h in height]

        def error(points, found):
            return rms(interpolated(found, t) - v for t, v in points) / max(
                v for _, v in points)

        def column(points):
            return [p[0] for p in points], [p[1] for p in points]

        return Measured(
            {"front": error(measured, moved), "height": error(heights, fallen)},
            {"reference front": column(measured),
             "reference height": column(heights),
             "front": column(moved), "height": column(fallen)},
            {"front": "time moved by %+.3f in T" % shift})


CASES = (Ritter, Stoker, MartinMoyce)
