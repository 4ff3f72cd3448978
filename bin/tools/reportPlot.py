#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Draws what a verification case found: its curves beside the reference, and
its errors against resolution with their bounds.

Usage: reportPlot.py <result.json> <picture.png>

Needs VTK's Python package, which libvtk9-dev brings. Like the painter of
src/vtkConversion it draws on the processor, with VTK's text renderer and PNG
writer, and needs no display."""
import json
import math
import sys

import numpy
from vtkmodules.util.numpy_support import numpy_to_vtk, vtk_to_numpy
from vtkmodules.vtkCommonDataModel import vtkImageData
from vtkmodules.vtkIOImage import vtkPNGWriter
from vtkmodules.vtkRenderingCore import vtkTextProperty, vtkTextRenderer
import vtkmodules.vtkRenderingFreeType  # noqa: F401  the renderer's fonts

WIDTH, HEIGHT = 1300, 560
INK = (0.1, 0.1, 0.1)
# Okabe and Ito, after the black of references
COLOURS = ((0.0, 0.45, 0.70), (0.84, 0.37, 0.0), (0.0, 0.62, 0.45),
           (0.80, 0.47, 0.65), (0.34, 0.71, 0.91), (0.90, 0.62, 0.0),
           (0.35, 0.35, 0.35), (0.60, 0.20, 0.10))


class Canvas:
    """Row 0 is the lowest"""

    def __init__(self):
        self.rgb = numpy.ones((HEIGHT, WIDTH, 3))
        self.window = (0, 0, WIDTH, HEIGHT)

    def cover(self, y, x, share, ink):
        area = self.rgb[y, x]
        area += share[..., None] * (numpy.array(ink) - area)

    def segment(self, a, b, ink, width):
        x0, y0, x1, y1 = self.window
        left = max(x0, int(min(a[0], b[0]) - width - 1))
        right = min(x1, int(max(a[0], b[0]) + width + 2))
        low = max(y0, int(min(a[1], b[1]) - width - 1))
        high = min(y1, int(max(a[1], b[1]) + width + 2))
        if left >= right or low >= high:
            return
        y, x = numpy.mgrid[low:high, left:right] + 0.5
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = dx * dx + dy * dy
        t = ((x - a[0]) * dx + (y - a[1]) * dy) / length if length else 0 * x
        t = numpy.clip(t, 0, 1)
        away = numpy.hypot(x - a[0] - t * dx, y - a[1] - t * dy)
        self.cover(slice(low, high), slice(left, right),
                   numpy.clip(0.5 * width + 0.5 - away, 0, 1), ink)

    def line(self, points, ink, width=2.0, dash=0):
        for a, b in zip(points, points[1:]):
            length = math.dist(a, b)
            if not dash or not length:
                self.segment(a, b, ink, width)
                continue
            for k in range(int(length / dash / 2) + 1):
                s, e = 2 * k * dash / length, (2 * k + 1) * dash / length
                self.segment(*(tuple(p + min(1, f) * (q - p)
                                     for p, q in zip(a, b)) for f in (s, e)),
                             ink, width)

    def text(self, x, y, words, at="left", size=17, upright=False, ink=INK):
        image = words and rendered(words, size, upright, ink)
        if image is None or not words:
            return
        high, wide = image.shape[:2]
        shift = {"left": 0, "centre": wide // 2, "right": wide}[at]
        left = int(x) - (wide // 2 if upright else shift)
        low = int(y) - high // 2
        area = self.rgb[low:low + high, left:left + wide]
        part = image[:area.shape[0], :area.shape[1]]
        share = part[..., 3:] / 255.0
        area += share * (part[..., :3] / 255.0 - area)

    def write(self, name):
        image = vtkImageData()
        image.SetDimensions(WIDTH, HEIGHT, 1)
        flat = (255 * numpy.clip(self.rgb, 0, 1) + 0.5).astype(numpy.uint8)
        image.GetPointData().SetScalars(
            numpy_to_vtk(flat.reshape(-1, 3), deep=True))
        writer = vtkPNGWriter()
        writer.SetFileName(name)
        writer.SetInputData(image)
        writer.Write()


def rendered(words, size, upright, ink):
    style = vtkTextProperty()
    style.SetFontFamilyToArial()
    style.SetFontSize(size)
    style.SetColor(*ink)
    style.SetOrientation(90 if upright else 0)
    renderer = vtkTextRenderer.GetInstance()
    renderer.SetScaleToPowerOfTwo(False)
    image = vtkImageData()
    # at 72 dots per inch a point is a pixel
    if not renderer.RenderString(
            style, words, image, [0, 0], 72, vtkTextRenderer.FreeType):
        return None
    wide, high, _ = image.GetDimensions()
    pixels = vtk_to_numpy(image.GetPointData().GetScalars())
    return pixels.reshape(high, wide, -1)


def ticks(low, high):
    rough = (high - low) / 5
    power = 10 ** math.floor(math.log10(rough))
    step = min((power * f for f in (1, 2, 5, 10)), key=lambda s: abs(s - rough))
    first = math.ceil(low / step - 1e-9)
    return [k * step for k in range(first, int(high / step + 1e-9) + 1)]


class Panel:
    def __init__(self, canvas, left, x, y, titles, log=False):
        self.canvas, self.log = canvas, log
        self.box = (left + 85, 70, left + 490, HEIGHT - 55)
        self.x, self.y = x, y
        self.frame(*titles)

    def at(self, x, y):
        if self.log:
            x, y = math.log10(x), math.log10(y)
        x0, y0, x1, y1 = self.box
        return (x0 + (x - self.x[0]) / (self.x[1] - self.x[0]) * (x1 - x0),
                y0 + (y - self.y[0]) / (self.y[1] - self.y[0]) * (y1 - y0))

    def frame(self, x_title, y_title):
        x0, y0, x1, y1 = self.box
        c = self.canvas
        c.line(((x0, y0), (x1, y0), (x1, y1), (x0, y1), (x0, y0)), INK, 1.2)
        c.text(0.5 * (x0 + x1), 20, x_title, "centre")
        c.text(x0 - 65, 0.5 * (y0 + y1), y_title, upright=True)

    def x_tick(self, value, words):
        px = self.at(value, 10 ** self.y[0] if self.log else self.y[0])[0]
        y0 = self.box[1]
        self.canvas.line(((px, y0), (px, y0 + 6)), INK, 1.2)
        self.canvas.text(px, y0 - 16, words, "centre", 15)

    def y_tick(self, value, words):
        py = self.at(10 ** self.x[0] if self.log else self.x[0], value)[1]
        x0 = self.box[0]
        self.canvas.line(((x0, py), (x0 + 6, py)), INK, 1.2)
        self.canvas.text(x0 - 8, py, words, "right", 15)

    def curve(self, points, ink, width=2.0, dash=0, dots=False):
        placed = [self.at(*p) for p in points]
        x0, y0, x1, y1 = map(int, self.box)
        self.canvas.window = (x0, y0, x1, y1)
        self.canvas.line(placed, ink, width, dash)
        if dots:
            for p in placed:
                self.canvas.segment(p, p, ink, 9)
        self.canvas.window = (0, 0, WIDTH, HEIGHT)


def span(values):
    low, high = min(values), max(values)
    room = 0.05 * (high - low) or 0.5
    return low - room, high + room


def key(canvas, left, entries):
    """Names under each other, beside the panels"""
    y = HEIGHT - 65
    for name, ink, dash in entries:
        canvas.line(((left, y), (left + 28, y)), ink, 3, dash)
        canvas.text(left + 35, y, name, size=14)
        y -= 24


def curve_panel(canvas, result):
    curves = result["curves"]
    x = [v for c in curves.values() for v in c[0]]
    y = [v for c in curves.values() for v in c[1]]
    panel = Panel(canvas, 0, span(x), span(y), result["axes"])
    for value in ticks(*panel.x):
        panel.x_tick(value, "%g" % round(value, 9))
    for value in ticks(*panel.y):
        panel.y_tick(value, "%g" % round(value, 9))
    entries, number = [], 0
    for name in sorted(curves, key=lambda n: n.startswith("reference")):
        reference = name.startswith("reference")
        ink = INK if reference else COLOURS[number % len(COLOURS)]
        number += not reference
        panel.curve(list(zip(*curves[name])), ink, 2.5 if reference else 2.0,
                    9 if reference else 0)
        entries.append((name.strip(), ink, 9 if reference else 0))
    return entries


def error_panel(canvas, result, left):
    numbers = result["numbers"]
    finite = [(r, [(n, max(e, 1e-6)) for n, e in zip(numbers, r["errors"])
                   if math.isfinite(e)]) for r in result["rows"]]
    values = [e for _, points in finite for _, e in points]
    values += [r["bound"] for r in result["rows"] if r["bound"] > 0]
    y = (math.floor(math.log10(min(values))), math.ceil(math.log10(max(values))))
    x = span([math.log10(n) for n in numbers])
    panel = Panel(canvas, left, x, (y[0], max(y[1], y[0] + 1)),
                  (result["of"], "error"), log=True)
    for n, name in zip(numbers, result["layers"]):
        panel.x_tick(n, name)
    for power in range(panel.y[0], panel.y[1] + 1):
        panel.y_tick(10.0 ** power, "%g" % 10.0 ** power)
    entries = []
    for k, (r, points) in enumerate(finite):
        ink = COLOURS[k % len(COLOURS)]
        panel.curve(points, ink, 2.5, dots=True)
        entries.append(("error: " + r["quantity"], ink, 0))
        if r["bound"] > 0:
            ends = [10 ** v for v in panel.x]
            panel.curve([(v, r["bound"]) for v in ends], ink, 1.5, 6)
            entries.append(("bound %g" % r["bound"], ink, 6))
    return entries


def main():
    with open(sys.argv[1], encoding="utf-8") as file:
        result = json.load(file)
    canvas = Canvas()
    canvas.text(WIDTH / 2, HEIGHT - 25, result["case"], "centre", 20)
    entries = curve_panel(canvas, result) if result["curves"] else []
    entries += error_panel(canvas, result, 500 if entries else 0)
    key(canvas, 1010, entries)
    canvas.write(sys.argv[2])


main()
