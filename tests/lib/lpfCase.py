# SPDX-License-Identifier: GPL-3.0-or-later
"""Cases for tests: write dictionaries, run applications, read what they write.

Standard library only. Fields are read from binary or ascii files of
<time>/lagrangian/<cloud>/ as lists of floats or tuples.
"""
import array
import math
import os
import re
import shutil
import subprocess
import sys

WIDTH = {"vectorField": 3, "symmTensorField": 6, "scalarField": 1}


def header(name):
    return (
        "FoamFile { version 2.0; format ascii; class dictionary; object %s; }\n"
        % os.path.basename(name)
    )


class Case:
    def __init__(self, path):
        self.path = path
        shutil.rmtree(path, ignore_errors=True)
        os.makedirs(path)

    def write(self, name, text):
        file = os.path.join(self.path, name)
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w") as f:
            f.write(header(name) + text + "\n")

    def write_gravity(self, g):
        file = os.path.join(self.path, "constant/g")
        os.makedirs(os.path.dirname(file), exist_ok=True)
        with open(file, "w") as f:
            f.write(
                "FoamFile { version 2.0; format ascii; "
                "class uniformDimensionedVectorField; object g; }\n"
                "dimensions [0 1 -2 0 0 0 0];\nvalue (%r %r %r);\n" % tuple(g)
            )

    def run(self, application, *options, check=True):
        log = os.path.join(self.path, "log." + application)
        with open(log, "w") as f:
            status = subprocess.run(
                [application, "-case", self.path] + list(options),
                stdout=f, stderr=subprocess.STDOUT, stdin=subprocess.DEVNULL,
            ).returncode
        if check and status:
            sys.stdout.write(open(log).read()[-3000:])
            raise RuntimeError("%s ended with %d" % (application, status))
        return status

    def log(self, application):
        return open(os.path.join(self.path, "log." + application)).read()

    def times(self):
        found = []
        for name in os.listdir(self.path):
            if os.path.isdir(os.path.join(self.path, name, "lagrangian")):
                found.append((float(name), name))
        return [name for _, name in sorted(found)]

    def table(self, start="0", name="balance.dat"):
        """Columns by name without unit, as lists"""
        file = os.path.join(
            self.path, "postProcessing", "lpfSolver", start, name
        )
        lines = open(file).read().split("\n")
        names = [c.split("[")[0] for c in lines[0].lstrip("# ").split()]
        rows = [[float(v) for v in x.split()] for x in lines[1:] if x.strip()]
        return {n: [r[k] for r in rows] for k, n in enumerate(names)}

    def field(self, time, name, cloud="grains"):
        file = os.path.join(self.path, time, "lagrangian", cloud, name)
        data = open(file, "rb").read()
        head = data[: data.index(b"}")].decode()
        kind = re.search(r"class\s+(\S+?);", head).group(1)
        binary = re.search(r"format\s+(\w+);", head).group(1) == "binary"
        body = data[data.index(b"}") + 1:]
        start = re.search(rb"\n\s*(\d+)\s*\(", body)
        count = int(start.group(1))
        body = body[start.end():]
        if kind.startswith("Cloud"):
            return self._positions(body, count, binary)
        if kind == "labelField":
            return self._numbers(body, count, binary, "i", int)
        width = WIDTH[kind]
        flat = self._numbers(body, count * width, binary, "d", float)
        if width == 1:
            return flat
        return [
            tuple(flat[k * width: (k + 1) * width]) for k in range(count)
        ]

    def time_of_velocity(self, time):
        """Half a step before that of the positions (doc/design.md)"""
        text = open(os.path.join(self.path, time, "uniform/time")).read()
        return float(time) - 0.5 * float(re.search(r"deltaT\s+(\S+);", text).group(1))

    def change(self, name, changed, cloud="grains", time="0"):
        """Positions or a field of numbers, vectors or symmetric tensors, each
        value by a function of it and of where it is"""
        values = [changed(v, x) for v, x in zip(
            self.field(time, name, cloud), self.field(time, "positions", cloud))]
        kind, line = "scalarField", "%r\n"
        if isinstance(values[0], tuple):
            kind, line = {
                3: ("vectorField", "(%r %r %r)\n"),
                6: ("symmTensorField", "(%r %r %r %r %r %r)\n")}[len(values[0])]
        if name == "positions":
            kind, line = "Cloud<passiveParticle>", "(%r %r %r) 0\n"
        file = os.path.join(self.path, time, "lagrangian", cloud, name)
        with open(file, "w") as f:
            f.write(
                "FoamFile { version 2.0; format ascii; class %s; object %s; }\n"
                "%d\n(\n%s)\n"
                % (kind, name, len(values), "".join(line % v for v in values)))

    @staticmethod
    def _numbers(body, count, binary, code, convert):
        if binary:
            values = array.array(code)
            values.frombytes(body[: count * values.itemsize])
            return list(values)
        words = re.findall(rb"[^\s()]+", body)[:count]
        return [convert(w) for w in words]

    @staticmethod
    def _positions(body, count, binary):
        if not binary:
            flat = [float(w) for w in re.findall(rb"[^\s()]+", body)[: 4 * count]]
            return [tuple(flat[4 * k: 4 * k + 3]) for k in range(count)]
        # a line each: '(' three doubles, a label of 4 bytes, ')'
        record, first = 31, body.index(b"(") + 1
        result = []
        for k in range(count):
            values = array.array("d")
            begin = first + k * record
            values.frombytes(body[begin: begin + 24])
            result.append(tuple(values))
        return result


def mean(values):
    values = list(values)
    return sum(values) / len(values)


def rms(values):
    return math.sqrt(mean(v * v for v in values))


def averaged(case, times, name, cloud):
    """Field by id, mean over times; each value a tuple"""
    total = {}
    for time in times:
        ids = case.field(time, "id", cloud)
        for i, v in zip(ids, case.field(time, name, cloud)):
            v = v if isinstance(v, tuple) else (v,)
            old = total.get(i, (0.0,) * len(v))
            total[i] = tuple(a + b / len(times) for a, b in zip(old, v))
    return total


def jobs():
    """Runs of one thread that this test may have at a time"""
    return max(1, (os.cpu_count() or 1) // int(os.environ.get("LPF_TEST_JOBS", 1)))


# of system/lpfSolution: grains without what the default scheme adds
PLAIN = ("bulkDamping 0; shearDamping 0; grains { densityRelaxation 0; shifting 0; "
         "stressDiffusion 0; frictionAt grains; }")


def ok(condition, text):
    print(("ok - " if condition else "not ok - ") + text, flush=True)
    return condition
