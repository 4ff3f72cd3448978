#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""Runs a verification case at its resolutions, prints its errors as tests and
writes result.json, which bin/lpfReport turns into a row of the report.

A case is a class with a name, a reference, bounds by quantity, and measure(),
which runs the applications and returns errors against an answer that this
code did not make. Usage: verify.py <case> [-negative]
"""
import importlib
import json
import math
import os
import sys
import time
import traceback
from dataclasses import dataclass, field

from lpfCase import ok

# The files of cases; each lists its classes in CASES
MODULES = (
    "verifyRest", "verifyDamBreak", "verifyWaves", "verifySlabs", "verifyOnset",
    "verifyViscous", "verifyConsolidation", "verifyBoiling", "verifyFlow",
    "verifyColumns", "verifyNumerics", "verifyGround", "verifyImmersed",
)


@dataclass
class Measured:
    """errors by quantity; curves by name, (x, y) lists, for the plot"""

    errors: dict
    curves: dict = field(default_factory=dict)
    notes: dict = field(default_factory=dict)  # quantity: figures in words


class Verification:
    name = ""
    reference = ""
    layers = (10, 20, 40)  # what one resolution is called in the report
    of = "layers"
    bounds = {}  # quantity: largest error
    units = {}  # quantity: unit of its error, where that is not relative
    judged = None  # layers from which the bound is asked for; default the last
    # the error of the last resolution must also be below that of the first
    converges = False
    orders = {}  # quantity: least order between the last two resolutions
    # quantities whose order is that of the last three, to their own limit
    own_limit = ()
    axes = ("x", "y")
    # quantity: why it is beyond its bound, as far as known
    findings = {}
    # name: (changed arguments of measure, quantity that must fail, layers)
    negatives = {}

    def measure(self, layers, **changed):
        raise NotImplementedError

    def label(self, layers):
        return "%g" % layers

    def judged_from(self):
        return self.layers[-1] if self.judged is None else self.judged


def cases():
    found = {}
    for module in MODULES:
        for case in importlib.import_module(module).CASES:
            found[case.name] = case()
    return found


def attempt(case, layers, **changed):
    """Measured; a run that fails has infinite errors"""
    try:
        return case.measure(layers, **changed)
    except Exception as problem:
        traceback.print_exc()
        return Measured(
            dict.fromkeys(case.bounds, math.inf),
            notes=dict.fromkeys(case.bounds, "failed: %s" % problem))


def order(layers, errors):
    """Observed between the last two; None where there is nothing to converge"""
    if len(errors) < 2 or min(errors[-2:]) <= 0 or math.inf in errors[-2:]:
        return None
    return math.log(errors[-2] / errors[-1]) / math.log(layers[-1] / layers[-2])


def order_to_limit(layers, errors):
    """Of the last three, each with as many times the layers of the one before:
    e_n = limit + a n^-order"""
    if len(errors) < 3 or math.inf in errors[-3:]:
        return None
    first, second = errors[-3] - errors[-2], errors[-2] - errors[-1]
    if not second or first / second <= 0:
        return None
    return math.log(first / second) / math.log(layers[-1] / layers[-2])


def trusted(layers, errors, bound):
    """Layers from which on every error is within the bound, or None"""
    good = None
    for n, e in reversed(list(zip(layers, errors))):
        if e > bound:
            break
        good = n
    return good


def row(case, quantity, runs):
    bound = case.bounds[quantity]
    errors = [abs(m.errors[quantity]) for m in runs]
    asked = [e for n, e in zip(case.layers, errors) if n >= case.judged_from()]
    good = max(asked) <= bound
    if case.converges:
        good = good and errors[-1] < errors[0]
    signed = [m.errors[quantity] for m in runs]
    observed = (order_to_limit(case.layers, signed) if quantity in case.own_limit
                else order(case.layers, errors))
    least = case.orders.get(quantity)
    if least is not None:
        good = good and observed is not None and observed >= least
    return {
        "quantity": quantity,
        "unit": case.units.get(quantity),
        "bound": bound,
        "least order": least,
        "errors": errors,
        "signed": signed,
        "notes": [m.notes.get(quantity, "") for m in runs],
        "order": observed,
        "trusted": trusted(case.layers, errors, bound),
        "converging": errors[-1] < errors[0],
        "status": "within" if good else "beyond",
    }


def verify(case):
    runs, seconds = [], []
    for layers in case.layers:
        start = time.time()
        runs.append(attempt(case, layers))
        seconds.append(time.time() - start)
        print("# %s %s: %s (%.0f s)" % (
            case.of, case.label(layers),
            ", ".join("%s %+.4g %s" % (q, e, runs[-1].notes.get(q, ""))
                      for q, e in runs[-1].errors.items()),
            seconds[-1]), flush=True)
    rows = [row(case, quantity, runs) for quantity in case.bounds]
    result = {
        "case": case.name, "reference": case.reference, "of": case.of,
        "layers": [case.label(n) for n in case.layers],
        "numbers": list(case.layers),
        "judged": case.label(case.judged_from()),
        "seconds": seconds, "rows": rows, "axes": case.axes,
        "curves": curves(case, runs),
    }
    for r in rows:
        ok(r["status"] == "within", "%s: %s, errors %s at %s %s; bound %g at %s%s%s" % (
            case.name, r["quantity"],
            ", ".join("%.4g" % e for e in r["errors"]), case.of,
            ", ".join(result["layers"]), r["bound"], result["judged"],
            ", converging" if case.converges else "",
            "" if r["least order"] is None else ", order %s of at least %g" % (
                r["order"] and round(r["order"], 2), r["least order"])))
    return result


def curves(case, runs):
    """The reference of the finest run, and what each run found"""
    shown = {}
    for layers, run in zip(case.layers, runs):
        for name, points in run.curves.items():
            if name.startswith("reference"):
                shown[name] = points
            else:
                shown["%s %s %s" % (name, case.label(layers), case.of)] = points
    return shown


def control(case):
    """With a law perturbed the quantity must be beyond its bound where it is
    within it without"""
    rows = []
    for name, (changed, quantity, layers) in case.negatives.items():
        right = attempt(case, layers).errors[quantity]
        wrong = attempt(case, layers, **changed).errors[quantity]
        bound = case.bounds[quantity]
        good = abs(right) <= bound < abs(wrong) < math.inf
        rows.append({
            "control": name, "quantity": quantity,
            "unit": case.units.get(quantity), "bound": bound,
            "layers": case.label(layers), "right": right, "wrong": wrong,
            "seen": good})
        ok(good, "%s: with %s, %s is off by %+.4g, without by %+.4g; bound %g"
           % (case.name, name, quantity, wrong, right, bound))
    return rows


def main():
    case = cases()[sys.argv[1]]
    if "-negative" in sys.argv[2:]:
        result = {"case": case.name, "controls": control(case)}
        failed = not all(r["seen"] for r in result["controls"])
    else:
        result = verify(case)
        failed = any(r["status"] != "within" for r in result["rows"])
    with open("result.json", "w", encoding="utf-8") as file:
        json.dump(result, file, indent=1)
    return failed


if __name__ == "__main__":
    os.environ["OMP_WAIT_POLICY"] = "passive"
    sys.exit(main())
