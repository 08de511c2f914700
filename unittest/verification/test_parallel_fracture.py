# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Fracture with cuts, viscosity, heating and fragments in contact, by their provisional repulsion
or with friction on the faces of cracks (fix tmsph/contact): the same to the last bit on any number
of processors, balanced or not, in one run or several, and continued from a restart. New ids and
deleted particles leave the other bonds alone."""

import numpy as np

from tmsph_testing import HORIZON, Scene, Script, lattice, main, material

SPACING = 1e-3
ROCKS = [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2700, 1e-5)]
SOFT = [material(40e9, 0.45, 2700, 1.5e-5), material(20e9, 0.42, 2700, 1e-5)]
STATE = "x y z vx vy vz fx fy fz c_t c_p[*]"
STRESSES = "sxx syy szz sxy sxz syz"


class Body:
    """A heated ball, in the plane or in space, around a core that expands more."""

    def __init__(self, dimension, friction=None, rocks=ROCKS):
        self.friction, self.rocks = friction, rocks
        two = dimension == 2
        self.radius, self.steps, self.heat = (17, 1000, 250) if two else (6.6, 300, 900)
        if rocks is SOFT:
            self.radius, self.steps = 14, 1400
        self.speed = 4465 if rocks is ROCKS else 7496    # of longitudinal waves
        n = 2 * int(self.radius) + 2
        cells = (n, n // 2 + n % 2 + 2) if two else (n,) * 3
        whole = lattice("hex" if two else "sc", cells, SPACING, centre=True)
        radius = lambda X: np.linalg.norm(X, axis=1) / (self.radius * SPACING)
        self.cloud = whole.kept(lambda X: radius(X) < 1)
        self.cloud.type = np.where(radius(self.cloud.X) < 0.3, 1, 2)
        self.pair = "viscosity 1 2"
        r = self.radius * SPACING
        self.cut = f"line {0.4 * r} 0 {0.8 * r} {0.4 * r}" if two else \
            f"disc {0.6 * r} {0.1 * SPACING} {0.1 * SPACING} 0.3 1 0.2 {0.3 * r}"

    def fixes(self, scene, more=""):
        """All that a restart does not carry."""
        if self.friction is None:
            contact, touching = "", "f_hb[5]"
        else:
            contact = f"fix cont all tmsph/contact friction * * {self.friction}\n"
            touching = "f_cont[8]"
        return scene.add(
            "fix 1 all nve\n"
            f"variable T equal {self.heat}*step/{self.steps}\n"
            "fix ramp all tmsph/heat/boundary temperature v_T\n"
            "fix hb all tmsph/hoekbrown strength 1 150e6 strength 2 120e6 mi * 8 "
            "weibull * 10 4711\n"
            "compute t all tmsph/property/atom temperature\n"
            f"compute p all tmsph/property/atom {STRESSES} load strength nbond "
            "nbroken ncut damage\n"
            f"timestep {0.35 * SPACING / self.speed:.17g}\n"
            f"{contact}variable touching equal {touching}\n"
            "thermo_style custom step temp f_hb v_touching\nthermo 100\n" + more)

    def start(self, more=""):
        scene = Scene(self.cloud, self.rocks, self.pair).add(f"tmsph/cut all {self.cut}")
        return self.fixes(scene, more)

    def ending(self, scene, runs):
        for n in runs:
            scene.add(f"run {n}")
        return scene.snapshot("end", STATE).add("write_dump all local events.local f_hb[*]")


def same(run, reference):
    """Number of values that differ in any bit, in the state and in the events."""
    differ = 0
    for one, other in zip(run.frame("end").items(), reference.frame("end").items()):
        differ += int(one[0] != other[0]) + np.count_nonzero(~(one[1] == other[1]))
    events = [np.array(sorted(map(tuple, np.transpose(list(r.frame("events").values())))))
              for r in (run, reference)]
    since = len(events[1]) - len(events[0])    # a continued run has its own events only
    order = events[1][np.argsort(events[1][:, 2], kind="stable")]
    late = np.array(sorted(map(tuple, order[since:])))
    return differ + np.count_nonzero(~(events[0] == late))


def compare(report, dimension, friction=None, rocks=ROCKS):
    body = Body(dimension, friction, rocks)
    n = body.steps
    parts = [n // 4, n // 3, n - n // 4 - n // 3]
    balance = "comm_style tiled\nfix lb all balance 40 0.95 rcb\n"
    reference = body.ending(body.start(), [n]).run()
    broken, contacts = reference.thermo("f_hb"), reference.thermo("v_touching")
    state = reference.frame("end")
    what = f"{dimension}-D, {'friction' if friction else 'repulsion'}"
    what += ", nearly incompressible" if rocks is SOFT else ""
    report.above(f"{what}: bonds broken", broken[-1], 100)
    report.above(f"{what}: bonds cut", state["c_p[11]"].sum() / 2, 20)
    report.above(f"{what}: contacts, most", contacts.max(), 0)
    report.true(f"{what}: all values finite", np.isfinite(state(" ".join(state))).all(), "a number")
    for ranks in (2, 4):
        run = body.ending(body.start(), [n]).run(ranks)
        report.below(f"{what}: {ranks} processors, values that differ", same(run, reference), 1)
    run = body.ending(body.start(balance), [n]).run(4)
    report.below(f"{what}: balanced on 4, values that differ", same(run, reference), 1)
    for ranks in (1, 2):
        run = body.ending(body.start(), parts).run(ranks)
        report.below(f"{what}: three runs on {ranks}, values that differ", same(run, reference), 1)

    middle = int(np.interp(0.4 * broken[-1], broken, reference.thermo("Step")))
    first = body.start().add(f"run {middle}\nwrite_restart middle.restart")
    written = first.run(2, keep="*.restart")
    report.within(f"{what}: broken at the restart, share", written.thermo("f_hb")[-1] / broken[-1],
                  0.1, 0.9)
    for ranks in (1, 4):
        scene = Script("comm_modify cutoff 6e-3\nread_restart middle.restart", written.kept)
        scene.add("thermo_modify norm no format float %.17g")
        run = body.ending(body.fixes(scene), [n - middle]).run(ranks)
        report.below(f"{what}: continued on {ranks}, values that differ", same(run, reference), 1)


def renumbered(report, ranks):
    """The forces of particles two horizons away from those that are deleted, and of all
    when ids are reset, found again by their reference positions."""
    body = Body(2)
    columns = "fx fy c_p[*] c_q[*]"
    scene = body.start("compute q all tmsph/property/atom x0 y0\n")
    scene.add(f"run {body.steps * 7 // 10}").snapshot("before", columns)
    top = 0.68 * body.radius * SPACING
    scene.add(f"region top block INF INF {top:.6g} INF INF INF units box\ngroup top region top")
    scene.add("delete_atoms group top compress yes\nrun 0").snapshot("deleted", columns)
    scene.add("reset_atoms id sort yes\nrun 0").snapshot("reset", columns)
    scene.add("run 50").snapshot("later", columns)
    run = scene.run(ranks)
    before = run.frame("before")

    def by_place(frame):
        return {(x, y): k for k, (x, y) in enumerate(frame("c_q[1] c_q[2]"))}

    where = by_place(before)
    gone = np.array([x for x in where if x not in by_place(run.frame("deleted"))])
    X = before("c_q[1] c_q[2]")
    distance = np.linalg.norm(X[:, None] - gone[None], axis=2).min(axis=1)
    untouched = distance > 2.02 * HORIZON * SPACING
    scale = np.abs(before("fx fy")).max()
    what = f"on {ranks}, {len(gone)} deleted, {untouched.sum()} untouched"
    for name in ("deleted", "reset"):
        frame = run.frame(name)
        there = by_place(frame)
        order = np.array([there[tuple(x)] for x in X[untouched]])
        error = np.abs(frame("fx fy")[order] - before("fx fy")[untouched]).max() / scale
        report.below(f"{name} {what}: forces", error, 1e-12)
        counts = " ".join(f"c_p[{k}]" for k in (8, 9, 10, 11))
        report.below(f"{name} {what}: strengths and bonds that differ", np.count_nonzero(
            frame(counts)[order] != before(counts)[untouched]), 1)
    report.true(f"{what}: goes on", np.isfinite(run.frame("later")("fx fy")).all(), "forces finite")


def plates(report):
    compare(report, 2)
    compare(report, 2, friction=0.3)
    compare(report, 2, friction=0.3, rocks=SOFT)


def blocks(report):
    compare(report, 3)
    compare(report, 3, friction=0.3)


def renumbering(report):
    for ranks in (1, 2):
        renumbered(report, ranks)


if __name__ == "__main__":
    main(plates, blocks, renumbering)
