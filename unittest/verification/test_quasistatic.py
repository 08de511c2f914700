# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Quasi-static stepping and its minimizer on a coarse disc. First break against the slow
dynamic run, what the table of events and the outputs say, the same results to the last bit on
any number of processors and from restarts; minima against those of LAMMPS's conjugate
gradients, in fewer force evaluations, in 2-D and 3-D, with held particles and without bonds;
a block under a wall that moves; an inclusion and cracks that touch with friction."""

import re

import numpy as np

from tmsph_testing import HORIZON, Scene, Script, disc_materials, lattice, main, material

SPACING, RADIUS = 2.5e-3, 0.05
RATE = 0.04    # degrees per step
ROCK = "fix rock all tmsph/hoekbrown mi * 8 strength 1 150e6 strength 2 120e6 weibull * 10 4711\n"
REACH = f"comm_modify cutoff {2 * HORIZON * SPACING:.6g}"    # as in Scene
STATE = "x y z fx fy fz c_t c_p[*]"


def disc():
    cells = (2 * int(RADIUS / SPACING) + 4, 2 * int(RADIUS / SPACING / 3**0.5) + 4)
    cloud = lattice("hex", cells, SPACING, centre=True)
    cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= RADIUS)
    cloud.type[np.linalg.norm(cloud.X, axis=1) > 0.015] = 2
    return cloud


CLOUD = disc()


def fixes(scene, more=""):
    """All that a restart does not carry."""
    return scene.add(
        f"variable T equal {RATE}*step\nfix heat all tmsph/heat/boundary temperature v_T\n{ROCK}"
        "compute t all tmsph/property/atom temperature\n"
        "compute p all tmsph/property/atom sxx syy sxy damage load nbroken\n"
        f"timestep {0.4 * SPACING / 4465:.17g}\nfix move all nve\n"
        f"thermo_style custom step f_heat f_rock pe ke\nthermo_modify norm no format float %.17g\n"
        f"thermo 500\n{more}")


def start(more=""):
    return fixes(Scene(CLOUD, disc_materials(False), "viscosity 1 2"), more)


def ending(scene):
    return scene.snapshot("end", STATE).add("write_dump all local events.local f_rock[*]")


def events(run):
    rows = np.array(list(run.frame("events").values())).T
    return rows[np.lexsort((rows[:, 1], rows[:, 0], rows[:, 2]))]


def differing(run, reference):
    """Number of values that differ in any bit; a continued run has its own events only."""
    count = sum(np.count_nonzero(~(run.frame("end")[name] == column))
                for name, column in reference.frame("end").items())
    mine, all_events = events(run), events(reference)
    return count + np.count_nonzero(~(mine == all_events[len(all_events) - len(mine):]))


def evaluations(run):
    return sum(int(n) for n in re.findall(r"(\d+) force evaluations\n", run.log))


def sequence(report):
    """To 160 degrees."""
    steps = 4000
    dynamic = ending(start().add("run 3000")).run()
    run = ending(start("dump d all custom 1000 d.dump id c_t\n"
                       "fix mean all ave/time 700 1 700 f_heat "
                       f"file mean.local\ntmsph/quasistatic {steps}")).run(keep="mean.local")
    table, event = run.tables[-1], events(run)
    first, slow = event[:, 12].min(), events(dynamic)[:, 12].min()
    report.below(f"first break at {first:.2f}, in the slow dynamic run at {slow:.2f}, difference",
                 abs(first - slow), 4)
    report.true("thermo on multiples of 500 steps", np.array_equal(
        table["Step"], np.arange(0, steps + 1, 500)), "from 0 to the end")
    report.true("dump on multiples of 1000 steps",
                [f.step for f in run.dumps["d"]] == list(range(0, steps + 1, 1000)), "as in a run")
    rows = np.array([line.split() for line in run.kept["mean.local"].decode().splitlines()
                     if not line.startswith("#")], float)
    report.below("fix ave/time on multiples of 700 steps, temperature wrong by",
                 np.abs(rows - [[n, RATE * n] for n in range(0, steps, 700)]).max(), 1e-10)
    report.below("temperature of events against their step",
                 np.abs(event[:, 12] - RATE * event[:, 2]).max(), 1e-9)
    report.above("bonds broken", len(event), 50)
    report.below("of the table and the fix, difference", abs(len(event) - table["f_rock"][-1]), 1)
    lost = run.frame("end")["c_p[6]"].sum() / 2
    report.below("lost by particles, difference", abs(lost - len(event)), 1)
    report.below("kinetic energy", np.abs(table["KinEng"]).max(), 1e-300)
    report.below("force evaluations/steps", evaluations(run) / steps, 1)


def decomposition(report):
    """Ranks, runs in parts and restarts. A part starts afresh, so that the reference has the
    same parts or writes a restart at the same step."""
    steps, middle = 3500, 2700
    again = f"tmsph/quasistatic {middle}\ntmsph/quasistatic {steps - middle}"
    whole = ending(start(again)).run()
    report.above("bonds broken, all ranks", len(events(whole)), 20)
    for ranks in (2, 4):
        run = ending(start(again)).run(ranks)
        report.below(f"{ranks} processors, values that differ", differing(run, whole), 1)
    written = ending(start(f"restart {middle} r.*.restart\ntmsph/quasistatic {steps}")).run(
        2, keep="*.restart")
    report.below("with a restart file written, values that differ", differing(written, whole), 1)
    for ranks in (1, 4):
        scene = Script(f"{REACH}\nread_restart r.{middle}.restart", written.kept)
        run = ending(fixes(scene, f"tmsph/quasistatic {steps - middle}")).run(ranks)
        report.below(f"continued on {ranks}, values that differ", differing(run, whole), 1)
    after = start(f"tmsph/quasistatic {middle}\nthermo_style custom step pe ke\nunfix heat"
                  "\nthermo 10\nrun 200").run()
    share = after.tables[-1]["KinEng"].max() / after.tables[-1]["PotEng"].max()
    report.below("run after it: kinetic/potential energy", share, 1e-3)


def energies(report, what, scene, run_words, less=1.0, dmax=0.01 * SPACING):
    """Of the minimum that two minimizers find, and their cost."""
    found = {}
    for style, options in (("cg", f"line forcezero dmax {dmax}"), ("tmsph/lbfgs", "norm two")):
        run = Script("\n".join(scene.lines), scene.files).add(
            f"min_style {style}\nmin_modify {options}\n{run_words}").run()
        cost = re.findall(r"evaluations = \d+ (\d+)", run.log)
        found[style] = run.thermo("PotEng")[-1], int(cost[-1])
    (cg, n), (lbfgs, m) = found["cg"], found["tmsph/lbfgs"]
    report.below(f"{what}: energy of the minimum against cg", abs(lbfgs / cg - 1), 1e-7)
    report.below(f"{what}: force evaluations {m}, of cg {n}, ratio", m / n, less)


def minima(report):
    heated = lambda cloud, more="": Scene(cloud, disc_materials(False), "").add(
        f"run 0\nset group all temperature 80\n{more}thermo_style custom step pe\n"
        "thermo_modify norm no format float %.17g")
    force = 15e6 * SPACING
    energies(report, "disc", heated(CLOUD),
             f"minimize 0 {1e-6 * force * len(CLOUD)**0.5} 20000 99999", 0.5)
    held = ("region low block INF INF INF -0.03 INF INF units box\ngroup low region low\n"
            "fix hold low setforce 0 0 0\n")
    energies(report, "disc, a part held", heated(CLOUD, held),
             f"minimize 0 {1e-6 * force * len(CLOUD)**0.5} 20000 99999")
    ball = lattice("fcc", (8, 8, 8), SPACING, centre=True)
    ball = ball.kept(lambda X: np.linalg.norm(X, axis=1) < 5.2 * SPACING)
    ball.type[np.linalg.norm(ball.X, axis=1) > 2.5 * SPACING] = 2
    energies(report, "ball", heated(ball), f"minimize 0 {1e-6 * force * SPACING * len(ball)**0.5} "
             "20000 99999")
    stripe = lattice("hex", (24, 12), SPACING, periodic="x")
    stripe.type[stripe.X[:, 1] > 12 * SPACING] = 2
    energies(report, "periodic stripe", heated(stripe),
             f"minimize 0 {1e-6 * force * len(stripe)**0.5} 20000 99999")
    other = Script("units lj\nlattice fcc 1.0\nregion b block 0 4 0 4 0 4\ncreate_box 1 b\n"
                   "create_atoms 1 box\nmass 1 1\npair_style lj/cut 2.38\npair_coeff 1 1 1 1\n"
                   "region a block 1 2 1 2 1 2\ngroup a region a\n"
                   "displace_atoms a random 0.1 0.1 0.1 4711\nthermo_style custom step pe\n"
                   "thermo_modify norm no format float %.17g")
    energies(report, "Lennard-Jones", other, "minimize 0 1e-6 20000 99999", dmax=0.1)

    positions = []
    for ranks in (1, 2, 4):
        scene = heated(CLOUD).add(f"min_style tmsph/lbfgs\nminimize 0 {1e-4 * force} 1000 9999")
        positions.append(scene.snapshot("end", "x y fx fy").run(ranks).frame("end")("x y fx fy"))
    report.below("minimize on 2 and 4 processors, values that differ",
                 sum(np.count_nonzero(p != positions[0]) for p in positions[1:]), 1)


def pressed(report):
    """A block between two walls without friction: the same force in few steps and in many."""
    block = lattice("square", (12, 12), SPACING)
    height = 12 * SPACING
    forces = []
    for stride in (0.1, 0.001):
        scene = Scene(block, [material(40e9, 0.2)], "plane strain").add(
            f"fix low all tmsph/wall line 0 0 1 0\n"
            f"fix top all tmsph/wall line 1 {height} 0 {height} velocity 0 -1e-5\n"
            "thermo_style custom step f_low[2] f_top[2] f_top[11]\n"
            "thermo_modify norm no format float %.17g\nthermo 10\ntimestep 0.1\n"
            f"tmsph/quasistatic 30 residual 1e-5 stride {stride}")
        run = scene.run()
        forces.append(run.thermo("f_top[2]")[-1])
        report.below(f"stride {stride}: wall against its velocity times the time",
                     abs(run.thermo("f_top[11]")[-1] / -3e-5 - 1), 1e-12)
        report.below(f"stride {stride}: forces on both walls, sum/force",
                     abs(run.thermo("f_low[2]")[-1] / forces[-1] + 1), 1e-3)
    exact = 40e9 / (1 - 0.2**2) * 3e-5 / height * 12 * SPACING    # per unit of thickness
    report.below("force of few steps against many", abs(forces[0] / forces[1] - 1), 1e-3)
    report.below("force against uniaxial plane strain", abs(forces[1] / exact - 1), 0.02)


def touching(report):
    """An inclusion that is not bonded but rubs, and faces of cracks."""
    contact = "fix rub all tmsph/contact friction * * 0.3"
    steps, middle = 3500, 3300

    def body():
        return Scene(CLOUD, disc_materials(False), "viscosity 1 2").add(
            f"pair_coeff 1 2 none\n{contact}")

    run = ending(fixes(body(), f"restart {middle} r.*.restart\ntmsph/quasistatic {steps}")).run(
        keep="*.restart")
    report.above("with friction: bonds broken", len(events(run)), 2)
    # 3 stresses for breaking; 10 of contact: gradient, velocity, acceleration, can bonds balance,
    # compliance, and 4 for couples; under its pressure 2 rounds of 3 stresses and 2 norms of stress
    told = re.findall(r"^  on: .*, breaking with 3 .*, contact with 14 doubles more per ghost, "
                      r"pressed surfaces with 10 ", run.log, re.M)
    report.true("with friction: the start tells what is on", len(told) == 1, str(told))
    report.true("with friction: equilibrium on all steps", "not found" not in run.log, "no warning")
    report.below("with friction: force evaluations/steps", evaluations(run) / steps, 1)
    other = ending(fixes(body(), f"restart {middle} r.*.restart\ntmsph/quasistatic {steps}")).run(2)
    report.below("with friction: on 2 processors, values that differ", differing(other, run), 1)
    scene = Script(f"{REACH}\nread_restart r.{middle}.restart\n{contact}", run.kept)
    rest = ending(fixes(scene, f"tmsph/quasistatic {steps - middle}")).run()
    report.below("with friction: continued, values that differ", differing(rest, run), 1)


if __name__ == "__main__":
    main(sequence, decomposition, minima, pressed, touching)
