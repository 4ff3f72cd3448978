# SPDX-License-Identifier: GPL-3.0-or-later
"""Closed tanks in which grains or water stand at rest: their ground, how they
are filled, and the height of the floor."""
import math

DX = 0.01


def polygon(name, points, zone="walls"):
    text = " ".join("(%.17g %.17g %.17g)" % p for p in points)
    return "%s { type polygon; zone %s; points (%s); }\n" % (name, zone, text)


def walls(x0, x1, y0, y1, z0, z1):
    """Four vertical walls that look inwards"""
    return (
        polygon("left", [(x0, y0, z0), (x0, y1, z0), (x0, y1, z1), (x0, y0, z1)])
        + polygon("right", [(x1, y0, z0), (x1, y0, z1), (x1, y1, z1), (x1, y1, z0)])
        + polygon("front", [(x0, y0, z0), (x0, y0, z1), (x1, y0, z1), (x1, y0, z0)])
        + polygon("back", [(x0, y1, z0), (x1, y1, z0), (x1, y1, z1), (x0, y1, z1)])
    )


def slope(name, x0, z0, x1, z1, width):
    return polygon(
        name,
        [(x0, 0, z0), (x1, 0, z1), (x1, width, z1), (x0, width, z0)],
        "floor",
    )


def inclined(degrees):
    length, width, level = 12 * DX, 6 * DX, 14 * DX
    rise = length * math.tan(math.radians(degrees))
    deepest = 16 * DX if degrees > 30 else 14 * DX
    return {
        "ground": slope("bed", 0, 0, length, rise, width)
        + walls(0, length, 0, width, 0, 3 * level),
        "box": (0, 0, 0, length, width, 3 * level),
        "level": deepest,
        "H": deepest,
        "height": lambda x, y: x * math.tan(math.radians(degrees)),
    }


def level_floor():
    side, H = 8 * DX, 20 * DX
    return {
        "ground": slope("bed", 0, 0, side, 0, side)
        + walls(0, side, 0, side, 0, 1.5 * H),
        "box": (0, 0, 0, side, side, 1.5 * H),
        "level": H,
        "H": H,
        "height": lambda x, y: 0.0,
    }


def corner():
    """A trough whose two floors meet at 90 degrees"""
    scene = gully(45)
    return scene


def gully(degrees=30):
    half, width = 7 * DX, 6 * DX
    t = math.tan(math.radians(degrees))
    H = 13 * DX
    return {
        "ground": slope("bedRight", 0, 0, half, half * t, width)
        + slope("bedLeft", -half, half * t, 0, 0, width)
        + walls(-half, half, 0, width, 0, 2.5 * H),
        "box": (-half, 0, 0, half, width, 2.5 * H),
        "level": H,
        "H": H,
        "height": lambda x, y: abs(x) * t,
    }


def hopper():
    """Floor down 20 degrees, rear wall and gate normal to it, as the flume"""
    a = math.radians(20)
    c, s = math.cos(a), math.sin(a)
    L, width, tall = 14 * DX, 8 * DX, 14 * DX

    def at(x, y, z):
        return (x * c + z * s, y, (L - x) * s + z * c)

    ground = polygon(
        "bed", [at(0, 0, 0), at(L, 0, 0), at(L, width, 0), at(0, width, 0)],
        "floor",
    )
    ground += polygon(
        "rear", [at(0, 0, 0), at(0, width, 0), at(0, width, tall), at(0, 0, tall)]
    )
    ground += polygon(
        "gate", [at(L, 0, 0), at(L, 0, tall), at(L, width, tall), at(L, width, 0)]
    )
    ground += polygon(
        "rightSide", [at(0, 0, 0), at(0, 0, tall), at(L, 0, tall), at(L, 0, 0)]
    )
    ground += polygon(
        "leftSide",
        [at(0, width, 0), at(L, width, 0), at(L, width, tall), at(0, width, tall)],
    )
    return {
        "ground": ground,
        "lattice": ((c, 0, -s), (s, 0, c), (0, 0, L * s)),
        "fill": (at(0, 0, 0), at(L, width, tall), 0.6 * L * width * tall),
        "H": 0.8 * tall,
        # of the square, which the surface cuts from wall to wall
        "surface": 0.5 * (L * s + tall * c) + 0.1 * tall * c,
        "height": lambda x, y: -1e9 if x > L * c else (L - x / c) * s,
    }


SHAPES = {
    "level": level_floor,
    "incline20": lambda: inclined(20),
    "incline45": lambda: inclined(45),
    "corner90": corner,
    "gully30": gully,
    "hopper": hopper,
}


def release(scene, phases):
    """Dictionary of the release and of the lattice of a scene"""
    lattice = ""
    if "lattice" in scene:
        e1, e3, o = scene["lattice"]
        lattice = (
            "lattice { axes ((%.17g %.17g %.17g) (0 1 0) (%.17g %.17g %.17g));"
            " origin (%.17g %.17g %.17g); }\n" % (e1 + e3 + o)
        )
    if "fill" in scene:
        a, b, volume = scene["fill"]
        body = (
            "type fill; box ((%.17g %.17g %.17g) (%.17g %.17g %.17g)); "
            "volume %.17g; surface level;" % (a + b + (volume,))
        )
    else:
        body = (
            "type tank; box ((%.17g %.17g %.17g) (%.17g %.17g %.17g)); "
            "level %.17g;" % (scene["box"] + (scene["level"],))
        )
    return "%srelease { %s zone all; %s }\n" % (lattice, body, phases)
