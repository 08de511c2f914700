# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""compute tmsph/crack/tip: the tip of a flaw that tmsph/cut lengthens is that of the bonds which cross it, in
2-D and 3-D and across periodic faces, and its speed the slope through what was told before. A crack that tears a
strip, at once or with a fracture energy, ends where a list of bonds and the damage say. The same bits on several
processors, from a restart file and with halves out of each other's reach."""

import numpy as np

from tmsph_testing import HORIZON, Scene, Script, lattice, main, material

SPACING = 1e-3
STEP = 1e-8
COLUMNS = [f"c_tip[{k}]" for k in range(1, 7)]
ROCK = material(20e9, 0.2, 2500.0)


def middles(cloud, ends):
    """Of the bonds that cross the plane y = 0 at x from one end to the other, seen from both particles;
    periodic in x as the cloud is."""
    X = cloud.X
    d = X[None] - X[:, None]
    for k, axis in enumerate("xyz"[: cloud.dimension]):
        if axis in cloud.periodic:
            period = cloud.box[1][k] - cloud.box[0][k]
            d[..., k] -= period * np.round(d[..., k] / period)
    near = np.sum(d**2, axis=2) < (HORIZON * cloud.spacing) ** 2
    i, j = np.nonzero(near & (X[:, None, 1] * (X[:, None, 1] + d[..., 1]) < 0))
    at = X[i, 0] - d[i, j, 0] * X[i, 1] / d[i, j, 1]
    cut = (at > ends[0]) & (at < ends[1])
    return X[i][cut] + 0.5 * d[i, j][cut]


def slope(time, distance):
    if len(time) < 2:
        return 0.0
    t, s = time - time.mean(), distance - distance.mean()
    return np.sum(t * s) / np.sum(t * t)


def told_speeds(tables, window, time_step):
    """Of all evaluations: the slope through those before, of which the last of a step counts."""
    last, speeds = {}, []
    for table in tables:
        for step, distance, part in zip(table["Step"], table["c_tip[4]"], table["c_tip[6]"]):
            last = {**last, step: distance} if part else {}
            steps = np.array(sorted(last)[-window:])
            speeds.append(slope(time_step * steps, np.array([last[n] for n in steps])))
    return np.array(speeds)


def flaw(dimension, start, end):
    if dimension == 2:
        return f"tmsph/cut all line {start:.17g} 0 {end:.17g} 0"
    return (f"tmsph/cut all polygon 4 {start:.17g} 0 -1 {end:.17g} 0 -1 {end:.17g} 0 1 "
            f"{start:.17g} 0 1")


def lengthened(report):
    """A flaw grows by so many spacings every 5 steps; its end is never where a bond crosses."""
    window = 6
    for what, cells, periodic, start, stride, count in (
            ("2-D", (24, 8), "", -0.1, 1.0, 12),
            ("2-D, uneven stairs", (24, 8), "", -0.1, 0.37, 30),
            ("2-D, over a periodic face", (24, 8), "x", -9.3 * SPACING, 1.0, 17),
            ("3-D, periodic in z", (14, 8, 8), "z", -0.1, 1.0, 8)):
        dimension = len(cells)
        cloud = lattice("square" if dimension == 2 else "sc", cells, SPACING, periodic, centre=True)
        scene = Scene(cloud, [ROCK])
        scene.add(f"compute tip all tmsph/crack/tip x cut yes window {window}\n"
                  f"compute broken all tmsph/crack/tip x\ntimestep {STEP}")
        scene.thermo("step " + " ".join(COLUMNS) + " c_broken[6]", 5).add("run 5")
        first = -5.123 * SPACING
        ends = first + stride * SPACING * np.arange(count)
        for end in ends:
            scene.add(flaw(dimension, start, end) + "\nrun 5")
        run = scene.run()
        found = np.array([[table[name][-1] for name in COLUMNS] for table in run.tables])
        exact = np.array([middles(cloud, (start, end))[:, 0].max() for end in ends])
        report.true(f"{what}: before there is a tip", not found[0].any(), "all are 0")
        report.below(f"{what}: error of x/spacing", np.abs(found[1:, 0] - exact).max() / SPACING, 1e-12)
        report.below(f"{what}: distance - x", np.abs(found[:, 3] - found[:, 0]).max(), 1e-300)
        report.below(f"{what}: |y|/horizon", np.abs(found[:, 1]).max() / (HORIZON * SPACING), 0.5)
        speeds = np.concatenate([table["c_tip[5]"] for table in run.tables])
        last = run.tables[-1]["c_tip[5]"][0]    # when the flaw has just grown
        fast = stride * SPACING / (5 * STEP)
        report.below(f"{what}: error of the speed/speed",
                     np.abs(speeds - told_speeds(run.tables, window, STEP)).max() / fast, 1e-10)
        # stairs of a spacing in all are off the even way by half a one each way, what the slope makes of it is
        # at most 1.5/n where the tip takes n in the window; those that fit the outputs are none
        bar = 1e-10 if stride == 1.0 else 1.5 / (stride * (window - 1))
        report.below(f"{what}: speed at the end/that of the flaw - 1", abs(last / fast - 1), bar)
        report.true(f"{what}: cut bonds alone", all(not table["c_broken[6]"].any()
                                                    for table in run.tables), "no tip without cut yes")


def directions(report):
    """Of one flaw: each direction as a word and as a vector; the group leaves others out."""
    cloud = lattice("square", (16, 16), SPACING, centre=True)
    ends = (-3.2 * SPACING, 4.3 * SPACING)
    scene = Scene(cloud, [ROCK])
    names = {"x": (1, 0), "-x": (-1, 0), "y": (0, 1), "-y": (0, -1), "3 -4 0": (0.6, -0.8)}
    for k, direction in enumerate(names):
        scene.add(f"compute {k} all tmsph/crack/tip {direction} cut yes")
    scene.add(f"region left block INF {-1.1 * SPACING} INF INF INF INF units box\ngroup left region left\n"
              "compute left left tmsph/crack/tip x cut yes")
    scene.thermo("step " + " ".join(f"c_{k}[4]" for k in range(len(names))) + " c_left[4]")
    run = scene.add(flaw(2, *ends) + "\nrun 0").run()
    middle = middles(cloud, ends)
    for k, (name, vector) in enumerate(names.items()):
        report.below(f"{name}: error of the distance/spacing",
                     abs(run.thermo(f"c_{k}[4]")[0] - (middle @ vector).max()) / SPACING, 1e-12)
    left = middles(cloud.kept(lambda X: X[:, 0] < -1.1 * SPACING), ends)[:, 0].max()
    report.below("a group: error/spacing", abs(run.thermo("c_left[4]")[0] - left) / SPACING, 1e-12)


def apart(report):
    """Halves that were moved out of each other's reach: who knows both ends depends on the processors,
    the tip does not."""
    cloud = lattice("square", (24, 12), SPACING, centre=True)
    scene = Scene(cloud, [ROCK])
    scene.add("compute tip all tmsph/crack/tip 1 0.1 0 cut yes\nregion high block INF INF 0 INF INF INF\n"
              "group high region high").thermo("step " + " ".join(COLUMNS))
    scene.add(flaw(2, -1, 1) + "\nrun 0\ndisplace_atoms high move 0 0.1 0 units box\nrun 0")
    direction = np.array([1, 0.1]) / np.hypot(1, 0.1)
    exact = (middles(cloud, (-1, 1)) @ direction).max()
    tips = [[run.thermo(name)[0] for name in COLUMNS] for run in map(scene.run, (1, 2, 4))]
    report.below("error of the distance/spacing", abs(tips[0][3] - exact) / SPACING, 1e-12)
    for ranks, tip in zip((2, 4), tips[1:]):
        report.true(f"out of reach, {ranks} processes", tip == tips[0], "the same bits")


# Speed of surface waves, that of shear waves times (0.862 + 1.14 nu)/(1 + nu), Viktorov 1967; cracks are slower
RAYLEIGH = (0.862 + 1.14 * ROCK["poisson"]) / (1 + ROCK["poisson"]) * np.sqrt(
    ROCK["young"] / (2 * (1 + ROCK["poisson"])) / ROCK["density"])


class Strip:
    """With a notch on its left, pulled apart by its grips; its crack is through before the end. Bonds
    at the corners of the grips fail too, outside of the group."""

    steps, every, step = 1300, 10, 1.75e-7

    def __init__(self, energy):
        self.cloud = lattice("square", (40, 20), 1.5e-3, centre=True)
        self.rock = "tensile * 15e6" + (f" energy * {energy}" if energy else "")

    def fixes(self, scene):
        scene.add(f"fix break all tmsph/rankine {self.rock}\nfix move all nve\n"
                  f"fix hold grips setforce 0 0 0\ntimestep {self.step}\n"
                  "compute tip middle tmsph/crack/tip x\n"
                  "compute zone middle tmsph/crack/tip x open 0.01\n"
                  "compute field all tmsph/property/atom x0 y0 damage\n"
                  "compute bond middle tmsph/bond/local id1 id2 only broken")
        names = COLUMNS + [name.replace("tip", "zone") for name in COLUMNS]
        return scene.add(f"thermo_style custom step f_break {' '.join(names)}\n"
                         f"thermo_modify norm no format float %.17g\nthermo {self.every}")

    def scene(self):
        grip = 0.5 * 20 * 1.5e-3 - 3 * 1.5e-3
        scene = Scene(self.cloud, [ROCK], "viscosity 0.5 0")
        scene.add("tmsph/cut all line -1 1e-7 -15e-3 1e-7")
        y = self.cloud.X[:, 1]
        scene.set("vy", 0.08 / (2 * grip) * np.clip(y, -grip, grip))
        scene.add(f"region low block INF INF INF {-grip} INF INF\nregion high block INF INF {grip} INF "
                  "INF INF\ngroup low region low\ngroup high region high\ngroup grips union low high\n"
                  "region middle block INF INF -6e-3 6e-3 INF INF\ngroup middle region middle")
        return self.fixes(scene)

    def tips(self, run):
        return np.stack([run.tables[-1][name] for name in run.tables[-1]], axis=1)


def torn(report):
    for what, energy in (("at once", 0), ("with a fracture energy", 60)):
        strip = Strip(energy)
        scene = strip.scene()
        scene.dump("field", "c_field[*]", strip.every, "middle")
        scene.add(f"dump bond all local {strip.every} bond.local c_bond[*]\n"
                  'dump_modify bond format line "%.17g %.17g"')
        run = scene.add(f"run {strip.steps}").run()
        table = run.tables[-1]
        X = strip.cloud.X[:, 0]
        exact, between = np.zeros(len(table["Step"])), np.zeros(len(table["Step"]), bool)
        horizon = HORIZON * 1.5e-3
        for n, (bonds, field) in enumerate(zip(run.dumps["bond"], run.dumps["field"])):
            id1, id2 = (bonds[f"c_bond[{k}]"].astype(int) - 1 for k in (1, 2))
            exact[n] = np.max(0.5 * (X[id1] + X[id2]), initial=-1.0)
            damaged = field["c_field[1]"][field["c_field[3]"] > 0]
            zone = table["c_zone[1]"][n]
            between[n] = (not table["c_zone[6]"][n] or
                          damaged.max() - 0.5 * horizon <= zone <= damaged.max())
        there = exact > -1
        report.above(f"{what}: outputs with a tip", there.sum(), 20)
        if energy == 0:
            report.below(f"{what}: error of x/spacing",
                         np.abs(table["c_tip[1]"] - exact)[there].max() / 1.5e-3, 1e-12)
            report.true(f"{what}: threshold", np.array_equal(table["c_tip[4]"], table["c_zone[4]"]),
                        "nothing to a bond that breaks at once")
        else:
            ahead = table["c_tip[1]"][there] - exact[there]
            report.within(f"{what}: bonds without traction ahead of those gone, spacings", ahead.min() /
                          1.5e-3, -1e-12, np.inf)
            lead = (table["c_zone[4]"] - table["c_tip[4]"])[there]
            report.above(f"{what}: least lead of the zone, spacings", lead.min() / 1.5e-3, -1e-12)
            report.above(f"{what}: largest", lead.max() / 1.5e-3, 1)
        report.true(f"{what}: zone", between.all(), "ends at most half a horizon behind the damage")
        report.above(f"{what}: way of the tip/ligament", np.ptp(table["c_tip[1]"][there]) / 45e-3, 0.8)
        speed = table["c_tip[5]"]
        report.below(f"{what}: error of the speed/speed",
                     np.abs(speed - told_speeds(run.tables, 10, strip.step)).max() / speed.max(), 1e-10)
        if energy:
            report.within(f"{what}: largest speed/Rayleigh's", speed.max() / RAYLEIGH, 0.05, 1.0)


PART = 2 + len(COLUMNS) - 1    # column of Strip.tips(), after step and broken bonds


def bits(report):
    """On several processors and from a restart file; steps of it are those of outputs."""
    for what, energy in (("at once", 0), ("with a fracture energy", 60)):
        strip = Strip(energy)
        whole = strip.tips(strip.scene().add(f"run {strip.steps}").run())
        for ranks in (2, 4):
            run = strip.scene().add(f"run {strip.steps}").run(ranks)
            report.true(f"{what}, {ranks} processes", np.array_equal(strip.tips(run), whole), "the same bits")
        with_tip = np.flatnonzero(whole[:, PART])
        report.within(f"{what}: outputs with a tip", len(with_tip), 20, len(whole) - 1)
        half = with_tip[10] * strip.every
        first = strip.scene().add(f"run {half}\nwrite_restart half.restart").run(2, keep="half.restart")
        rest = strip.fixes(Script("read_restart half.restart", first.kept))
        run = rest.add(f"run {strip.steps - half}").run()
        report.true(f"{what}, from a restart file", np.array_equal(strip.tips(run), whole[half // strip.every:]),
                    "the same bits")


if __name__ == "__main__":
    main(lengthened, directions, apart, torn, bits)
