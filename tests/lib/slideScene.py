# SPDX-License-Identifier: GPL-3.0-or-later
"""A small general scene: a block of grains collapses over the break between a
chute and a level plate, along a side wall; a second block falls onto the
plate, a third flies off its end and out of the domain.

Nothing is parallel to an axis. Every input goes through a `Placement`, so that
the scene can be scaled, turned, mirrored and moved as a whole.
"""
import math

SPACING = 0.02
YAW, SLOPE = math.radians(20), math.radians(32)

# down the chute along the level, across, up
FORWARD = (math.cos(YAW), math.sin(YAW), 0.0)
ACROSS = (-math.sin(YAW), math.cos(YAW), 0.0)
UP = (0.0, 0.0, 1.0)
# along the chute and normal to it
DOWN = tuple(math.cos(SLOPE) * f - math.sin(SLOPE) * u
             for f, u in zip(FORWARD, UP))
NORMAL = tuple(math.sin(SLOPE) * f + math.cos(SLOPE) * u
               for f, u in zip(FORWARD, UP))

CUBE = ((1, 0, 0), (0, 1, 0), (0, 0, 1))


def combined(*terms):
    """Sum of number * vector"""
    return tuple(sum(s * v[k] for s, v in terms) for k in range(3))


class Placement:
    """length: scale of lengths, a power of 4, with density and g unchanged;
    rows: matrix of the turn, entries 0, 1, -1; then a shift in m."""

    def __init__(self, length=1.0, rows=CUBE, shift=(0.0, 0.0, 0.0)):
        self.length, self.rows, self.shift = length, rows, shift
        self.time = math.sqrt(length)  # of a power of 4: exact
        self.speed = self.time
        self.mirrored = self.determinant() < 0

    def determinant(self):
        (a, b, c), (d, e, f), (g, h, i) = self.rows
        return a * (e * i - f * h) - b * (d * i - f * g) + c * (d * h - e * g)

    def vector(self, v, factor=1.0):
        return tuple(factor * sum(r * x for r, x in zip(row, v))
                     for row in self.rows)

    def point(self, x):
        turned = self.vector(x, self.length)
        return tuple(a + b for a, b in zip(turned, self.shift))

    def vector_back(self, v, factor=1.0):
        """The inverse of a turn is its transpose"""
        return tuple(sum(self.rows[r][k] * v[r] for r in range(3)) / factor
                     for k in range(3))

    def point_back(self, x):
        return self.vector_back(
            tuple(a - b for a, b in zip(x, self.shift)), self.length)

    def tensor_back(self, t, factor=1.0):
        """Symmetric: xx xy xz yy yz zz"""
        full = ((t[0], t[1], t[2]), (t[1], t[3], t[4]), (t[2], t[4], t[5]))

        def component(a, b):
            return sum(self.rows[r][a] * full[r][s] * self.rows[s][b]
                       for r in range(3) for s in range(3)) / factor

        return tuple(component(a, b) for a, b in
                     ((0, 0), (0, 1), (0, 2), (1, 1), (1, 2), (2, 2)))


def text(v):
    return "(%r %r %r)" % tuple(v)


class Slide:
    """Writes the dictionaries into a Case; round_input acts on each
    coordinate before it is placed."""

    def __init__(self, place=None, steps=200, round_input=None):
        self.place = place or Placement()
        self.steps = steps
        self.round_input = round_input or (lambda x: x)
        self.control = {}
        self.solution = {}
        self.gate = None  # time at which a gate below the block opens [s]

    def point(self, x):
        return self.place.point(tuple(self.round_input(c) for c in x))

    def polygon(self, name, points, zone):
        placed = [self.point(p) for p in points]
        if self.place.mirrored:
            # the corners turn around; the same one comes first
            placed = placed[:1] + placed[:0:-1]
        return "%s { type polygon; zone %s; points (%s); }\n" % (
            name, zone, " ".join(text(p) for p in placed))

    def ground(self):
        upper = combined((-0.9, DOWN))
        lower = combined((0.5, FORWARD))
        left, right, wide = 0.23, -0.31, -0.71
        high = combined((0.6, UP))

        def at(foot, across, more=(0, 0, 0)):
            return combined((1, foot), (across, ACROSS), (1, more))

        none = (0.0, 0.0, 0.0)
        # seen from the free side the corners turn counter-clockwise
        # seen from the free side the corners turn counter-clockwise. A
        # mirrored quadrangle has mirrored triangles, and with sides that
        # differ by less than sqrt(3) their surface elements are mirrored, too
        gate = "" if self.gate is None else self.polygon("gate", [
            at(none, right), at(none, left),
            at(none, left, combined((0.15, NORMAL))),
            at(none, right, combined((0.15, NORMAL)))], "gate")
        return (
            gate + self.polygon("chute", [
                at(upper, right), at(none, right),
                at(none, left), at(upper, left)], "chute")
            + self.polygon("plate", [
                at(none, wide), at(lower, wide),
                at(lower, right), at(none, right)], "plate")
            + self.polygon("runout", [
                at(none, right), at(lower, right),
                at(lower, left), at(none, left)], "plate")
            + self.polygon("upperWall", [
                at(upper, left), at(none, left),
                at(none, left, high), at(upper, left, high)], "wall")
            + self.polygon("lowerWall", [
                at(none, left), at(lower, left),
                at(lower, left, high), at(none, left, high)], "wall"))

    def box(self, name, corner, axes, count, velocity=(0.0, 0.0, 0.0)):
        """A box of count grains along axes that starts at corner"""
        p = self.place
        edges = [p.vector(a, n * SPACING * p.length)
                 for a, n in zip(axes, count)]
        return """%s
{
    type box; corner %s;
    edges (%s);
    lattice { axes (%s); origin %s; }
    velocity %s;
    grains { solidFraction 0.55; }
}
""" % (name, text(self.point(corner)), " ".join(map(text, edges)),
       " ".join(text(p.vector(a)) for a in axes), text(self.point(corner)),
       text(p.vector(velocity, p.speed)))

    def releases(self):
        dx = SPACING
        chute = (DOWN, ACROSS, NORMAL)
        level = (FORWARD, ACROSS, UP)
        return (
            self.box("block", combined(
                (-10 * dx, DOWN), (0.23 - 7 * dx, ACROSS)), chute, (10, 7, 5))
            + self.box("falling", combined(
                (0.2, FORWARD), (-0.2, ACROSS), (0.8 * dx, UP)),
                level, (4, 4, 4), combined((0.6, FORWARD), (-3.0, UP)))
            + self.box("flying", combined(
                (0.5 + 2 * dx, FORWARD), (-0.68, ACROSS), (3 * dx, UP)),
                level, (2, 2, 2), combined((3.0, FORWARD), (1.0, UP))))

    def write(self, case):
        p = self.place
        case.write_gravity(p.vector((0.0, 0.0, -9.81)))
        case.write("constant/phaseProperties", """
phases (grains);
grains
{
    rho 2600; diameter %r; rheology muI;
    muICoeffs
    {
        muS 0.3839; mu2 0.6494; I0 0.28; nu 0.36; E auto;
        initialStress geostatic;
    }
}""" % (0.005 * p.length))
        case.write("constant/boundaryProperties", """
contact signedDistance;
zones
{
    chute { friction Coulomb; mu 0.45; }
    plate { friction Coulomb; mu 0.55; ru 0.25; }
    wall  { friction Coulomb; mu 0.3; }
%s}""" % ("" if self.gate is None else
          "    gate  { friction none; opensAt %r; }\n" % self.gate))
        case.write("system/terrainToParticlesDict", """
spacing %r;
maxSpeed %r;
ground
{
%s}
release
{
%s}""" % (SPACING * p.length, 3.0 * p.speed, self.ground(), self.releases()))
        control = {
            "startFrom": "latestTime", "stopAt": "nextWrite",
            "endTime": repr(10.0 * p.time), "writeControl": "timeStep",
            "writeInterval": str(self.steps), "writeFormat": "binary",
            **self.control}
        case.write("system/controlDict", "\n".join(
            "%s %s;" % item for item in control.items()))
        solution = {
            "CFL": "0.3", "artificialViscosity": "0.01",
            "stop": "{ criterion movingMass; share 0.001; speed %r; "
                    "after %r; }" % (0.02 * p.speed, 0.01 * p.time),
            **self.solution}
        case.write("system/lpfSolution", "\n".join(
            "%s %s%s" % (k, v, "" if v.endswith("}") else ";")
            for k, v in solution.items()))
