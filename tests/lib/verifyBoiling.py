# SPDX-License-Identifier: GPL-3.0-or-later
"""Water that stands higher on one side of a sheet pile flows below its tip and up
through the bed on the other side, until the bed boils."""
from planeScene import G, RHO_F, RHO_P, Scene, mean, polygon
from verify import Measured, Verification

XI = 0.5
# Width of both legs and of the pile, which gap and depths are multiples of [m]
WIDTH = 0.06
GAP, BED, POND = WIDTH, 3 * WIDTH, 0.5 * WIDTH
TIP = (WIDTH, 2 * WIDTH)
FAR = 3 * WIDTH
# from surface to surface along the middle of legs and gap
WAY = 2 * (BED - 0.5 * GAP) + 2 * WIDTH


class Boiling(Verification):
    """The bed bears more on one side and less on the other; where nothing is left
    to bear it boils, and takes no larger gradient"""

    name = "boiling"
    reference = (
        "critical gradient i_c = xi (rho_p/rho_f - 1) = %g. Levels of 0.27 m, a mean "
        "gradient of %.2f i_c, lift nothing: rise of the top of the bed over that "
        "with 0.39 m. Those of 0.39 m, %.2f i_c, boil: gradient up the leg, mean of "
        "0.1 to 0.3 s, is i_c" % (
            XI * (RHO_P / RHO_F - 1),
            *(head / WAY / (XI * (RHO_P / RHO_F - 1)) for head in (0.27, 0.39))))
    of, layers = "rows in a leg", (8, 12, 16)
    bounds = {"gradient": 0.05, "rise": 0.05}
    findings = {
        "gradient": (
            "It swings by half of i_c from one time to the next (picture): the mean is of "
            "a hundred times, for that of eleven was known to some 10 %. 13.6 % too low "
            "at 6 rows, 12.7 at 8, 6.2 at 12."),
        "rise": (
            "The bed that should not boil rises by 0.09 mm at 12 rows, a 25th of what "
            "the other does, and the less the finer it is.")}
    axes = ("t [s]", "i/i_c up the leg")
    negatives = {"grains of 2300 kg/m3": ({"rho": 2300}, "gradient", 16)}

    def scene(self, layers, head, rho):
        dx = WIDTH / layers
        scene = Scene(
            dx=dx, phases="grains water", maxSpeed=0.1, mu=1e-3, log=200,
            diameter=5e-4, rhoGrains=rho, end=0.3, writes=150,
            grains={"nu": 0.3, "muS": 0.9, "mu2": 0.9},
            solution="bulkDamping 0.3; noiseDamping 0.3;")
        top = BED + POND + head + 0.1
        scene.ground = (
            scene.floor(0, FAR) + scene.wall("left", 0, 1, top)
            + scene.wall("right", FAR, -1, top) + self.pile(scene, top))
        wet = "grains { solidFraction %g; } water { saturation 1; }" % XI
        scene.release = (
            scene.box("below", 0, FAR, 0, GAP, wet)
            + scene.box("bedLeft", 0, TIP[0], GAP, BED, wet)
            + scene.box("bedRight", TIP[1], FAR, GAP, BED, wet)
            + scene.box("pondLeft", 0, TIP[0], BED, BED + POND + head, "water {}")
            + scene.box("pondRight", TIP[1], FAR, BED, BED + POND, "water {}"))
        return scene

    @staticmethod
    def pile(scene, top):
        y = scene.half + 3 * scene.dx

        def side(name, x, sign):
            return polygon(name, "wall", (
                (x, -sign * y, GAP), (x, sign * y, GAP),
                (x, sign * y, top), (x, -sign * y, top)))

        return side("pileLeft", TIP[0], -1) + side("pileRight", TIP[1], 1) + polygon(
            "tip", "wall", ((TIP[0], -y, GAP), (TIP[0], y, GAP),
                            (TIP[1], y, GAP), (TIP[1], -y, GAP)))

    @staticmethod
    def way(x):
        """From the surface on the left, along legs and gap"""
        if x[2] < GAP:
            across = min(max(x[0] - 0.5 * WIDTH, 0), 2 * WIDTH)
            return BED - 0.5 * GAP + across
        return BED - x[2] if x[0] < TIP[0] else WAY - (BED - x[2])

    def flow(self, layers, head, rho):
        """Times, gradients up the right leg, and rise of its top"""
        case = self.scene(layers, head, rho).prepared(
            "%s%d.%g" % (self.name, layers, 100 * head))
        # near the end of the diffusion of pressure
        case.change("p", lambda p, x: RHO_F * G * max(0.0, (
            BED + POND + head * (1 - min(1, max(0, self.way(x) / WAY))) - x[2])),
            "water")
        case.run("lpfSolver", "-threads", "1")
        times = case.times()
        start = dict(zip(case.field("0", "id"), case.field("0", "positions")))
        surface = {i for i, x in start.items()
                   if x[0] > TIP[1] and x[2] > BED - 2.1 * WIDTH / layers}
        rise = mean(
            x[2] - start[i][2] for i, x in zip(
                case.field(times[-1], "id"), case.field(times[-1], "positions"))
            if i in surface)
        return [float(t) for t in times], [
            self.gradient(case, t) for t in times], rise

    @staticmethod
    def gradient(case, time):
        """Of the head, upwards, least squares: away from tip and surface"""
        points = [
            (x[2], p / (RHO_F * G) + x[2]) for x, p in zip(
                case.field(time, "positions", "water"),
                case.field(time, "p", "water"))
            if x[0] > TIP[1] and GAP + 0.02 < x[2] < BED - 0.01]
        zm, hm = mean(z for z, _ in points), mean(h for _, h in points)
        return -sum((z - zm) * (h - hm) for z, h in points) / sum(
            (z - zm) ** 2 for z, _ in points)

    def measure(self, layers, rho=RHO_P):
        critical = XI * (RHO_P / RHO_F - 1)
        times, held, still = self.flow(layers, 0.27, rho)
        _, boiling, lifted = self.flow(layers, 0.39, rho)
        late = [k for k, t in enumerate(times) if t > 0.0999]
        i = mean(boiling[k] for k in late) / critical
        return Measured(
            {"gradient": i - 1, "rise": still / lifted},
            {"reference": ([0, times[-1]], [1, 1]),
             "0.27 m": (times, [g / critical for g in held]),
             "0.39 m": (times, [g / critical for g in boiling])},
            {"gradient": "i %.3f" % (i * critical), "rise": "%.2f and %.2f mm" % (
                1e3 * still, 1e3 * lifted)})


CASES = (Boiling,)
