#!/usr/bin/env python3
# SPDX-License-Identifier: GPL-3.0-or-later
"""The dam break of tests/benchmarks/run with PySPH, to stand beside it.

    pysphDamBreak.py particles steps threads sound-speed

Weakly compressible SPH as PySPH has it by default: Wendland C2, h/dx 1.3, one
evaluation a step, walls of three layers of particles, double precision. Prints
one line of JSON: fluid and wall particles, steps, seconds of the wall and of the
processors over the steps after the first ones, in which PySPH compiles.
"""
import json
import os
import sys
import tempfile
import time

particles, steps, threads = (int(a) for a in sys.argv[1:4])
soundSpeed = float(sys.argv[4])
os.environ["OMP_NUM_THREADS"] = str(threads)

import numpy as np  # noqa: E402
from pysph.base.kernels import WendlandQuintic  # noqa: E402
from pysph.base.utils import get_particle_array_wcsph  # noqa: E402
from pysph.solver.application import Application  # noqa: E402
from pysph.sph.scheme import WCSPHScheme  # noqa: E402

COLUMN, TANK = (1.0, 0.5, 1.0), (3.0, 0.5, 1.5)
H_OVER_DX, RHO, G = 1.3, 1000.0, 9.81
LAYERS, FIRST_STEPS = 3, 3
dx = (COLUMN[0] * COLUMN[1] * COLUMN[2] / particles) ** (1 / 3)
h = H_OVER_DX * dx


def lattice(lower, upper):
    """Points of spacing dx between, half of it from the lower end; as many as
    fit, as terrainToParticles has it"""
    axes = [dx * (np.arange(round(a / dx), int(b / dx + 1e-6)) + 0.5)
            for a, b in zip(lower, upper)]
    return [x.ravel() for x in np.meshgrid(*axes, indexing="ij")]


def particle_array(name, points):
    x, y, z = points
    return get_particle_array_wcsph(
        name=name, x=x, y=y, z=z, h=np.full_like(x, h),
        m=np.full_like(x, RHO * dx ** 3), rho=np.full_like(x, RHO))


class DamBreak(Application):
    done = 0

    def create_particles(self):
        fluid = particle_array("fluid", lattice((0, 0, 0), COLUMN))
        wall = LAYERS * dx
        top = [dx * int(end / dx + 1e-6) for end in TANK]
        points = lattice([-wall] * 3, (top[0] + wall, top[1] + wall, top[2]))
        inside = np.ones(len(points[0]), dtype=bool)
        for x, end in zip(points, top):
            inside &= (x > 0) & (x < end)
        boundary = particle_array("boundary", [x[~inside] for x in points])
        self.counts = (fluid.get_number_of_particles(),
                       boundary.get_number_of_particles())
        self.scheme.setup_properties([fluid, boundary])
        return [fluid, boundary]

    def create_scheme(self):
        return WCSPHScheme(
            ["fluid"], ["boundary"], dim=3, rho0=RHO, c0=soundSpeed, h0=h,
            hdx=H_OVER_DX, gz=-G, alpha=0.02, beta=0.0, gamma=7.0)

    def configure_scheme(self):
        self.dt = 0.25 * h / (1.1 * soundSpeed)
        self.scheme.configure_solver(
            kernel=WendlandQuintic(dim=3), dt=self.dt,
            tf=2 * (steps + FIRST_STEPS) * self.dt, pfreq=10 ** 9)

    def post_step(self, solver):
        self.done += 1
        now = time.perf_counter(), time.process_time()
        if self.done == FIRST_STEPS:
            self.began = now
        if self.done == FIRST_STEPS + steps:
            self.took = [b - a for a, b in zip(self.began, now)]


with tempfile.TemporaryDirectory() as folder:
    app = DamBreak(fname="damBreak", output_dir=folder)
    argv = ["--disable-output", "--quiet",
            "--max-steps", str(steps + FIRST_STEPS)]
    app.run(argv + (["--openmp"] if threads > 1 else []))
print(json.dumps({
    "fluid": app.counts[0], "boundary": app.counts[1], "steps": steps,
    "wall": app.took[0], "processor": app.took[1],
    "courant": soundSpeed * app.dt / h}))
