# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Two bodies of rock far apart fly at each other off centre, touch with friction and fly on:
discs in 2-D, balls in 3-D; by pairs of particles, and in 2-D also by segments, with an annulus
of finer spacing as the other body. Momentum and angular momentum, energy, that neither passes
through the other; and the same to the last bit on any number of processors, in one run or
several, and continued from a restart written while they touch."""

import numpy as np

from tmsph_testing import Cloud, Scene, Script, lattice, main, material

SPACING, SPEED = 0.01, 4.0
ROCK = material(10e6, 0.2, 1000.0)
WAVE = (10e6 * 0.8 / (1.2 * 0.6) / 1000) ** 0.5
STATE = "type x y z vx vy vz fx fy fz"


class Pair:
    def __init__(self, dimension, method="kernel", friction=0.4, speed=SPEED, courant=0.3):
        two = dimension == 2
        self.method, self.friction, self.speed = method, friction, speed
        self.radius = (8 if two else 4.5) * SPACING
        cells = (20,) * 2 if two else (12,) * 3
        ball = lattice("square" if two else "sc", cells, SPACING, centre=True)
        ball = ball.kept(lambda X: np.linalg.norm(X, axis=1) <= self.radius)
        away = np.array([2 * self.radius + 5 * SPACING, 0.9 * self.radius, 0.4 * self.radius])
        other = ball
        if method == "segment":
            other = lattice("hex", (25, 15), 0.8 * SPACING, centre=True).kept(
                lambda X: np.abs(np.linalg.norm(X, axis=1) - 0.65 * self.radius)
                <= 0.35 * self.radius)
        self.cloud = Cloud(np.concatenate([ball.X, other.X + away[:dimension]]), 0.0, SPACING)
        self.cloud.volume = np.concatenate([ball.volume, other.volume])
        self.second = np.arange(len(self.cloud)) >= len(ball)
        if method == "segment":
            self.cloud.type = 1 + self.second
        self.step = courant * SPACING / WAVE
        self.steps = int(20 * SPACING / speed / self.step)

    def fixes(self, scene):
        scene.add("fix move all nve\n"
                  f"fix touch all tmsph/contact friction * * {self.friction} method {self.method}\n"
                  f"timestep {self.step:.17g}")
        return scene.add("thermo_style custom step etotal f_touch[7] f_touch[8]\n"
                         "thermo_modify norm no format float %.17g\nthermo 50")

    def start(self):
        scene = Scene(self.cloud, [ROCK] * self.cloud.type.max())
        if self.method == "segment":
            scene.add("pair_coeff 1 2 none")
        scene.lines[2] = scene.lines[2].replace(" s", " f")
        scene.add("change_box all x final -1 1 y final -1 1"
                  + (" z final -1 1" if self.cloud.dimension == 3 else ""))
        v = np.where(self.second, -0.5, 0.5)[:, None] * np.array([self.speed, 0, 0])
        scene.set("vx", v[:, 0])
        return self.fixes(scene)

    def ending(self, scene, runs):
        for n in runs:
            scene.add(f"run {n}")
        return scene.snapshot("end", STATE)


def moments(frame, mass):
    x, v = frame("x y z"), frame("vx vy vz")
    momentum, turning = mass * v, mass * np.cross(x, v)
    return (momentum.sum(axis=0), np.abs(momentum).sum(), turning.sum(axis=0),
            np.abs(turning).sum())


def different(run, reference):
    a, b = run.frame("end")(STATE), reference.frame("end")(STATE)
    return np.count_nonzero(~(a == b))


def collide(report, dimension, method="kernel"):
    what, pair = f"{dimension}-D, {method}", Pair(dimension, method)
    scene = pair.start().dump("all", STATE, pair.steps // 40)
    reference = pair.ending(scene, [pair.steps]).run()
    mass = 1000.0 * pair.cloud.volume[:, None]
    first, end = reference.frame("all", 0), reference.frame("end")
    p0, p_size, l0, l_size = moments(first, mass)
    p1, _, l1, _ = moments(end, mass)
    touching = reference.thermo("f_touch[8]")
    report.above(f"{what}: most that touched", touching.max(), 4 if method == "kernel" else 2)
    report.below(f"{what}: touching at the end", touching[-1], 1)
    report.below(f"{what}: change of momentum/sum of magnitudes",
                 np.abs(p1 - p0).max() / p_size, 1e-12)
    report.below(f"{what}: change of angular momentum/sum of magnitudes",
                 np.abs(l1 - l0).max() / l_size, 1e-12)
    energy = reference.thermo("TotEng")
    report.below(f"{what}: largest energy/the first", energy.max() / energy[0], 1.001)
    turned = end["vx"][pair.second].mean()
    report.above(f"{what}: velocity of the second body, before {-SPEED / 2}", turned, -SPEED / 4)
    report.above(f"{what}: work of friction/energy", reference.thermo("f_touch[7]")[-1] / energy[0],
                 1e-4)
    x = end("x y z")
    gap = np.linalg.norm(x[pair.second][:, None] - x[~pair.second][None], axis=2).min()
    report.above(f"{what}: shortest distance of the bodies/spacing", gap / SPACING, 1.0)

    middle = int(touching.argmax()) * 50
    parts = [middle, 37, pair.steps - middle - 37]
    for ranks, runs in ((4, [pair.steps]), (2, parts)):
        run = pair.ending(pair.start(), runs).run(ranks)
        report.below(f"{what}: on {ranks}, {len(runs)} runs, values that differ",
                     different(run, reference), 1)
    written = pair.start().add(f"run {middle}\nwrite_restart middle.restart").run(
        2, keep="*.restart")
    for ranks in (1, 4):
        scene = Script(f"comm_modify cutoff {6 * SPACING}\nread_restart middle.restart",
                       written.kept)
        run = pair.ending(pair.fixes(scene), [pair.steps - middle]).run(ranks)
        report.below(f"{what}: continued on {ranks}, values that differ",
                     different(run, reference), 1)


def by_pairs(report):
    collide(report, 2)


def by_segments(report):
    collide(report, 2, "segment")


def in_3d(report):
    collide(report, 3)


if __name__ == "__main__":
    main(by_pairs, by_segments, in_3d)
