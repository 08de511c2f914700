# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Bonds that open: a notched strip between grips is pulled apart. The crack takes the given energy
on lattices in any direction, no update of the openings gains energy, and half-way the run goes on
from a restart file and on several processors with the same bits. So do equilibria of it; a crack between
two types of the same rock is as one in it. Bars without a notch bear the strength. A body that is torn
apart by its own rotation keeps its angular momentum and gains no energy. Limits of the method are told."""

import copy
import re

import numpy as np

from scenes.relaxed import Body, Relaxed
from tmsph_testing import Scene, Script, lattice, main, material

YOUNG, POISSON, DENSITY, TENSILE, ENERGY = 20e9, 0.2, 2500.0, 14.77e6, 60.0
LENGTH = YOUNG * ENERGY / TENSILE**2    # characteristic, 5.5 mm
SPACING = 1.5e-3                        # 0.27 of it
WIDTH, HEIGHT, NOTCH = 60e-3, 30e-3, 15e-3
SPEED = np.sqrt(1.12 * YOUNG / DENSITY)
ROCK = f"tensile * {TENSILE} energy * {ENERGY}"


def turned_lattice(name, angle, spacing, inside, shift=0.3, cells=120):
    cloud = lattice(name, (cells, cells), spacing, centre=True)
    c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
    # off the middle, where a lattice that is not turned would have particles on the edges
    cloud.X = cloud.X @ np.array([[c, s], [-s, c]]) + shift * spacing
    return cloud.kept(inside)


def strip_lattice(name, angle, spacing):
    return turned_lattice(name, angle, spacing, lambda X: np.all(
        np.abs(X) < np.array([0.5 * WIDTH, 0.5 * HEIGHT]), axis=1),
        cells=max(120, 2 * int(0.6 * np.hypot(WIDTH, HEIGHT) / spacing)))


class Strip:
    """Its crack is through after a half of the run. thickness: in 3-D, where it is periodic."""

    def __init__(self, cloud, rate=0.02, words="", thickness=1.0):
        spacing = cloud.spacing
        self.cloud, self.spacing, self.rate = cloud, spacing, rate
        self.words, self.thickness = f"viscosity 0.5 0 {words}", thickness
        self.step = 0.35 * spacing / SPEED
        self.steps = int(0.42e-3 * 0.05 / rate / self.step)

    def scene(self):
        grip = 0.5 * HEIGHT - 3 * self.spacing
        scene = Scene(self.cloud, [material(YOUNG, POISSON, DENSITY)], self.words)
        tip, t = -0.5 * WIDTH + NOTCH, self.thickness
        scene.add(f"tmsph/cut all line -1 1e-7 {tip} 1e-7" if self.cloud.dimension == 2 else
                  f"tmsph/cut all polygon 4 -1 1e-7 {-t} {tip} 1e-7 {-t} {tip} 1e-7 {2 * t} -1 1e-7 {2 * t}")
        # both grips move, and the strip is stretched evenly as it begins
        y = self.cloud.X[:, 1]
        scene.set("vy", self.rate / (2 * grip) * np.clip(y, -grip, grip))
        scene.add(f"region low block INF INF INF {-grip} INF INF\n"
                  f"region high block INF INF {grip} INF INF INF\n"
                  "group low region low\ngroup high region high\ngroup grips union low high")
        return self.fixes(scene)

    def fixes(self, scene):
        scene.add(f"fix break all tmsph/rankine {ROCK}\nfix move all nve\n"
                  f"fix hold grips setforce 0 0 0\ntimestep {self.step:.17g}")
        return scene.thermo(f"step f_break {' '.join(f'f_break[{k}]' for k in range(6, 12))}", 100)

    def resumed(self, restart, steps):
        scene = Scene(self.cloud, [material(YOUNG, POISSON, DENSITY)], self.words)
        at = next(k for k, line in enumerate(scene.lines) if line.startswith("read_data"))
        scene.lines[at] = "read_restart half.restart"
        scene.lines = scene.lines[:1] + [line for line in scene.lines[1:] if not
                                         line.startswith(("units", "dimension", "boundary",
                                                          "atom_style"))]
        scene.files = {"half.restart": restart}
        return self.fixes(scene).add(f"run {steps}")


STRETCH = 0.65e-6    # of a strip in a step of equilibria; its crack is through after 20 of 40


def still_strip(name, angle, spacing, split=False):
    """A strip that equilibria() stretches, and half the distance of its grips. split: its halves have
    types of their own."""
    grip = 0.5 * HEIGHT - 3 * spacing
    cloud = strip_lattice(name, angle, spacing)
    if split:
        cloud.type = 1 + (cloud.X[:, 1] > 0)
    scene = Scene(cloud, [material(YOUNG, POISSON, DENSITY)] * cloud.type.max())
    scene.add(f"tmsph/cut all line -1 1e-7 {-0.5 * WIDTH + NOTCH} 1e-7\n"
              f"region low block INF INF INF {-grip} INF INF\nregion high block INF INF {grip} INF INF INF\n"
              "group low region low\ngroup high region high")
    return scene, grip


def equilibria(scene, grip, steps, rock=ROCK, first=""):
    """first: before them, as LAMMPS moves nothing after read_restart without a run."""
    columns = " ".join(f"f_break[{k}]" for k in range(6, 12))
    return scene.add(
        f"fix break all tmsph/rankine {rock}\nfix low low setforce 0 0 0\nfix high high setforce 0 0 0\n"
        f"thermo_style custom step pe f_low[2] f_high[2] f_break {columns}\n"
        f"thermo_modify norm no format float %.17g\nthermo 1\n{first}\nvariable k loop {steps}\nlabel next\n"
        f"displace_atoms all ramp y {-0.5 * STRETCH} {0.5 * STRETCH} y {-grip} {grip} units box\n"
        "tmsph/quasistatic 1\nnext k\njump SELF next")


def still(report):
    """In equilibrium. What the grips do in a step, as if the load grew in it as in an intact strip, is never
    less than what bonds gain and openings take."""
    for name, angle in (("square", 0), ("hex", 15)):
        run = equilibria(*still_strip(name, angle, SPACING), 40).run()
        table = {key: np.array([0.0] + [one[key][-1] for one in run.tables]) for key in run.tables[0]}
        load = 0.5 * np.abs(table["f_low[2]"] - table["f_high[2]"])
        work = (load[:-1] + 0.5 * load[1]) * STRETCH
        took = table["f_break[6]"] + table["f_break[9]"]
        what, whole = f"{name} {angle}, in equilibrium", ENERGY * (WIDTH - NOTCH)
        report.above(f"{what}: least energy that leaves in a step/(G area)",
                     (work - np.diff(table["PotEng"] + took)).min() / whole, -1e-9)
        report.below(f"{what}: gained by updates/dissipated", table["f_break[8]"][-1] / took[-1], 1e-4)
        report.below(f"{what}: load in the end/largest", load[-1] / load.max(), 0.01)
        report.note(f"{what}: energy of the crack/(G area)", f"{took[-1] / whole:.3f}")


def still_bits(report):
    """On several processors, and from a restart file between equilibria with open bonds."""
    state = "x y z fx fy fz"
    scene, grip = still_strip("square", 0, 2e-3)
    whole = equilibria(scene, grip, 22).snapshot("end", state).run()
    columns = whole.frame("end")(state)
    for ranks in (2, 4):
        scene, grip = still_strip("square", 0, 2e-3)
        run = equilibria(scene, grip, 22).snapshot("end", state).run(ranks)
        report.within(f"equilibria on {ranks} processes: largest difference",
                      np.abs(run.frame("end")(state) - columns).max(), 0, 0)
    scene, grip = still_strip("square", 0, 2e-3)
    first = equilibria(scene, grip, 18).add("write_restart half.restart").run(2, keep="half.restart")
    report.above("bonds that open where it is cut in two", first.tables[-1]["f_break[11]"][-1], 10)
    rest = Script("read_restart half.restart", first.kept)
    run = equilibria(rest, grip, 4, first="run 0 post no").snapshot("end", state).run()
    report.within("equilibria from a restart file: largest difference",
                  np.abs(run.frame("end")(state) - columns).max(), 0, 0)
    report.within("energy of the crack/that without a restart",
                  run.tables[-1]["f_break[6]"][-1] / whole.tables[-1]["f_break[6]"][-1], 1 - 1e-12, 1 + 1e-12)


def energy(report, what, strip, bar=0.05):
    """Per area of the crack, with what updates and leaving bonds lose. The bar in 2-D is that of the scatter of a
    calibration over lattices: 3 to 4 % each way."""
    run = strip.scene().add(f"run {strip.steps}").run()
    took, gained, lost = (run.thermo(f"f_break[{k}]")[-1] for k in (6, 8, 9))
    area = (WIDTH - NOTCH) * strip.thickness
    report.within(f"{what}: energy of the crack/(G area)", (took + lost) / (ENERGY * area),
                  1 - bar, 1 + bar)
    report.note(f"{what}: of that by the law", f"{took / (took + lost):.3f}")
    report.below(f"{what}: gained by updates/dissipated", gained / took, 1e-4)
    report.above(f"{what}: bonds that left", run.thermo("f_break")[-1], 100)


def energies(report, lattices=(("square", 0), ("hex", 15))):
    """More lattices, clouds, plane stress and 3-D: test_openings_long.py."""
    for name, angle in lattices:
        energy(report, f"{name} {angle}", Strip(strip_lattice(name, angle, SPACING)))


def interface(report):
    """A crack along the boundary of two types. Alike, they take what one type does, to the scatter of a
    calibration over lattices; values for bonds between them are taken from 'between'."""
    def crack(words, split=True):
        scene, grip = still_strip("square", 0, SPACING, split)
        run = equilibria(scene, grip, 40, words).run()
        took = run.tables[-1]["f_break[6]"][-1] + run.tables[-1]["f_break[9]"][-1]
        load = max(abs(table["f_low[2]"][-1]) for table in run.tables)
        return took / (ENERGY * (WIDTH - NOTCH)), load

    one, load = crack(ROCK, split=False)
    two, load_of_two = crack(ROCK)
    given, load_given = crack(f"tensile * {1.5 * TENSILE} energy * {2 * ENERGY} "
                              f"between 1 2 strength {TENSILE} energy {ENERGY}")
    half, _ = crack(f"{ROCK} between 1 2 energy {0.5 * ENERGY}")
    report.within("energy of the crack between types/in one type", two / one, 0.95, 1.05)
    # the bar of peaks, see test_cct.py
    report.within("largest load", load_of_two / load, 0.96, 1.04)
    report.within("with between: energy/without", given / two, 0.95, 1.05)
    report.within("with between: largest load/without", load_given / load_of_two, 0.96, 1.04)
    report.within("with half of the energy between: energy/half of that", half / (0.5 * two), 0.95, 1.05)


def softening(report):
    """By two lines the crack takes the same energy, to the scatter of a calibration over lattices, and
    opens farther. Events have the energy of their bonds; damage counts openings."""
    def pulled(words, steps, more=""):
        scene, grip = still_strip("square", 0, 1e-3)
        equilibria(scene, grip, steps, f"tensile * {TENSILE} energy * {ENERGY} {words}")
        return scene.add(more)

    whole = ENERGY * (WIDTH - NOTCH)
    events = "write_dump all local events.txt index f_break[12]"
    linear = pulled("", 40).run()
    run = pulled("softening bilinear", 60, events).run(keep="events.txt")
    last = {key: run.tables[-1][key][-1] for key in run.tables[-1]}
    took = last["f_break[6]"] + last["f_break[9]"]
    of_linear = linear.tables[-1]["f_break[6]"][-1] + linear.tables[-1]["f_break[9]"][-1]
    report.within("bilinear: energy of the crack/that of the linear law", took / of_linear, 0.95, 1.05)
    report.below("bilinear: gained by updates/dissipated", last["f_break[8]"] / took, 1e-4)
    report.note("bilinear: energy of the crack/(G area)", f"{took / whole:.3f}")
    rows = np.array([[float(word) for word in line.split()] for line in
                     run.kept["events.txt"].decode().split("f_break[12]")[-1].strip().splitlines()])
    report.within("events: number/bonds that left", len(rows) / last["f_break"], 1, 1)
    report.above("events: least energy", rows[:, 1].min(), 0)
    # those that open still have taken no more than the largest of them each
    unfinished = last["f_break[6]"] - rows[:, 1].sum()
    report.within("events: energy of openings that is not theirs/largest of theirs, each",
                  unfinished / (rows[:, 1].max() * last["f_break[11]"]), 0, 1)


def heat(report):
    """What crosses a strip between its cold and its warm half in a short time falls with the openings
    between them, and none gets lost."""
    def crossed(steps):
        scene, grip = still_strip("square", 0, 1e-3)
        if steps:
            equilibria(scene, grip, steps)
        scene.add("region warm block INF INF 0 INF INF INF\ngroup warm region warm\nrun 0 post no\n"
                  "set group warm temperature 1.0\n"
                  "fix conduction all tmsph/heat conductivity * 2.5 specific/heat * 800\n"
                  "compute T all tmsph/property/atom temperature\n"
                  "compute sum all reduce sum c_T\n"
                  "variable warmed atom c_T*(y<0)\ncompute warmed all reduce sum v_warmed\n"
                  "thermo_style custom step c_warmed c_sum\nthermo_modify norm no format float %.17g\n"
                  "timestep 1e-3\nrun 1")
        table = scene.run().tables[-1]
        report.below(f"{steps} steps: heat that was lost", abs(table["c_sum"][-1] / table["c_sum"][0] - 1), 1e-13)
        return table["c_warmed"][-1]

    whole, half, more = (crossed(steps) for steps in (0, 17, 22))
    report.within("heat across a crack that opens/before it", half / whole, 0.5, 0.999)
    report.within("heat across one that is nearly through/before it", more / whole, 0.0, 0.5)


def cut_in_mid_opening(report):
    """tmsph/cut takes the opening with the bond: nothing acts across a line that is cut all through."""
    strip = Strip(strip_lattice("square", 0, 2e-3))
    scene = strip.scene()
    scene.add("region above block INF INF 0 INF INF INF\ngroup above region above\n"
              "variable pull equal fcm(above,y)")
    told = "thermo_style custom step f_break[11] v_pull\nrun 0\nprint \"told $(f_break[11]) $(v_pull)\""
    scene.add(f"run {int(0.55 * strip.steps)}\nunfix hold\n{told}\n"
              f"tmsph/cut all line -1 1e-7 1 1e-7\n{told}")
    before, after = np.array([[float(word) for word in line.split()[1:]]
                              for line in scene.run().log.splitlines() if line.startswith("told")])
    report.above("bonds that open before it", before[0], 10)
    report.below("bonds that open after it/before", after[0] / before[0], 0.999)
    report.above("force across before it/(strength width)", abs(before[1]) / (TENSILE * WIDTH), 1e-3)
    report.below("force across after it/before", abs(after[1] / before[1]), 1e-9)


def same_bits(report):
    strip = Strip(strip_lattice("square", 0, 2e-3))
    half, end = int(0.55 * strip.steps), strip.steps
    whole = strip.scene().add(f"run {end}").snapshot("end", "x y vx vy").run()
    columns = whole.frame("end")("x y vx vy")
    for ranks in (2, 4):
        run = strip.scene().add(f"run {end}").snapshot("end", "x y vx vy").run(ranks)
        report.within(f"{ranks} processes: largest difference",
                      np.abs(run.frame("end")("x y vx vy") - columns).max(), 0, 0)
    first = strip.scene().add(f"run {half}\nwrite_restart half.restart").run(2, keep="half.restart")
    report.above("bonds that open where it is cut in two", first.thermo("f_break[11]")[-1], 10)
    rest = strip.resumed(first.kept["half.restart"], end - half)
    run = rest.snapshot("end", "x y vx vy").run()
    report.within("from a restart file: largest difference",
                  np.abs(run.frame("end")("x y vx vy") - columns).max(), 0, 0)
    for k, what in ((6, "energy"), (10, "area")):
        report.within(f"{what} of the crack/that without a restart",
                      run.thermo(f"f_break[{k}]")[-1] / whole.thermo(f"f_break[{k}]")[-1],
                      1 - 1e-12, 1 + 1e-12)


def torn_by_rotation(report, dimensions=(2, 3)):
    """Without viscosity, in the plane and in space; energy that openings take is booked."""
    for d in dimensions:
        cells = (14, 20) if d == 2 else (6, 10, 4)
        body = lattice("square" if d == 2 else "sc", cells, 1e-3, centre=True)
        turning = 1.3e4 if d == 2 else 2.6e4
        scene = Scene(body, [material(YOUNG, POISSON, DENSITY)])
        scene.lines[2] = scene.lines[2].replace(" s", " f")
        scene.add("change_box all x final -0.05 0.05 y final -0.05 0.05"
                  + (" z final -0.05 0.05" if d == 3 else ""))
        scene.set("vx vy", turning * np.stack([-body.X[:, 1], body.X[:, 0]], axis=1))
        scene.add(f"fix break all tmsph/rankine {ROCK}\nfix move all nve\n"
                  f"timestep {0.2e-3 / SPEED:.17g}\nvariable spin equal angmom(all,z)")
        scene.thermo("step etotal f_break[6] f_break[7] f_break[8] f_break[9] f_break[11] v_spin", 20)
        run = scene.add(f"run {600 if d == 2 else 300}").run()
        energy, spin = run.thermo("TotEng"), run.thermo("v_spin")
        took = run.thermo("f_break[6]") + run.thermo("f_break[9]")
        report.above(f"{d}-D: bonds that opened", run.thermo("f_break[11]").max(), 100)
        report.below(f"{d}-D: largest energy/that of the start - 1", energy.max() / energy[0] - 1,
                     1e-3)
        report.below(f"{d}-D: energy with what openings took/that of the start - 1",
                     np.abs((energy + took) / energy[0] - 1).max(), 1e-3)
        report.below(f"{d}-D: change of the angular momentum", np.ptp(spin) / abs(spin[0]), 1e-10)


def stretched_bar(name, cells, plane, crossings):
    """Its ends are drawn apart but contract freely, and it is stretched evenly from the start, so that no waves run.
    They are stronger than its middle.
    @param crossings of a wave from end to end until it carries its strength
    @return load over the strength of the middle, until a fifth of it is lost"""
    bar = lattice(name, cells, SPACING, centre=True)
    d, along = bar.dimension, bar.X[:, 0]
    size = (np.array(bar.box[1]) - np.array(bar.box[0]))[:d]
    young, contraction = ((YOUNG / (1 - POISSON**2), POISSON / (1 - POISSON)) if plane == "strain"
                          else (YOUNG, POISSON))
    bar.type[abs(along) > 4 * SPACING] = 2
    held, time, step = 0.5 * size[0] - 3.1 * SPACING, crossings * size[0] / SPEED, 0.35 * SPACING / SPEED
    rate = TENSILE / young / time
    velocity = -contraction * rate * bar.X
    velocity[:, 0] = rate * np.clip(along, -held, held)
    scene = Scene(bar, 2 * [material(YOUNG, POISSON, DENSITY)],
                  (f"plane {plane} " if plane else "") + "viscosity 0.1 0")
    scene.set("vx vy vz"[:3 * d - 1], velocity)
    pull = f"0.5*(f_left[1]-f_right[1])/{np.prod(size[1:]) * TENSILE:.17g}"
    scene.add(f"region left block INF {-held} INF INF INF INF\nregion right block {held} INF INF INF INF INF\n"
              "group left region left\ngroup right region right\n"
              f"fix break all tmsph/rankine {ROCK} tensile 2 {3 * TENSILE} energy 2 {9 * ENERGY}\nfix move all nve\n"
              "fix left left setforce 0 NULL NULL\nfix right right setforce 0 NULL NULL\n"
              f"variable pull equal {pull}\ntimestep {step:.17g}")
    scene.thermo("step v_pull f_break[11]", 2)
    scene.add(f"run {int(0.95 * time / step)}\nfix stop all halt 2 v_pull < 0.8 error continue\n"
              f"run {int(0.6 * time / step)}")
    return scene.run().thermo("v_pull")


BARS = (("square", (24, 8), "stress"), ("hex", (24, 5), "strain"), ("sc", (16, 4, 4), ""), ("fcc", (12, 3, 3), ""))


def bars(report, which=BARS):
    """Without a notch a bar bears its strength, to a percent."""
    for name, cells, plane in which:
        pull = stretched_bar(name, cells, plane, 80)
        what = f"bar, {name}{', plane ' + plane if plane else ''}"
        report.within(f"{what}: peak/strength", pull.max(), 0.99, 1.01)
        report.below(f"{what}: last load/strength", pull[-1], 0.85)


def limits(report):
    """One clear error, or a warning, each."""
    block = lattice("square", (12, 12), 1e-3, centre=True)
    rock = material(YOUNG, POISSON, DENSITY)

    def told(words, pair="", poisson=POISSON):
        scene = Scene(block, [dict(rock, poisson=poisson)], pair)
        return scene.add(f"fix break all tmsph/rankine {words}\nfix move all nve\nrun 0").run(
            may_fail=True).log

    for words, more, text in (
            ("energy * 0", {}, "energy 0 is out of range: it must be positive"),
            ("energy * nan", {}, "ERROR"),
            ("energy 60", {}, "ERROR"),
            ("energy 3 60", {}, "ERROR"),
            ("toughness * -1", {}, "toughness -1 is out of range: it must be positive"),
            ("energy * 1", {}, "of the characteristic length of cracks there"),
            ("energy * 60 between 1 1 energy 20", {}, "needs two types"),
            ("energy * 60 between 1 2 energy 20", {}, "ERROR"),
            ("energy * 60 between 1 1", {}, "lacks what bonds between the two have"),
            ("energy * 60 between 1 1 energy 20 toughness 1e6", {}, "an energy and a toughness"),
            ("energy * 60 between 1 1 energy -20", {}, "energy -20 is out of range"),
            ("energy * 10", {}, "WARNING: Spacing 0.001 of type 1 is 0.5 of"),
            ("energy * 60", dict(pair="kernel cubic"), "calibrated for kernel wendland"),
            ("energy * 60", dict(poisson=0.4999), "its dilatation is averaged")):
        log = told(f"tensile * 10e6 {words}", **more)
        report.within(f"'{words}' {more or ''}: told", float(text in log), 1, 1)
        errors = float("WARNING" not in text)
        report.within(f"'{words}' {more or ''}: errors", log.count("ERROR"), errors, errors)
    pulled = Strip(strip_lattice("square", 0, 2e-3))
    log = pulled.scene().add(f"run {int(0.5 * pulled.steps)}\nthermo_style one\nunfix break\nrun 1").run(
        may_fail=True).log
    report.within("fix removed while bonds open: told",
                  float("ERROR: Bonds have begun to open" in log), 1, 1)
    log = told("tensile * 10e6 toughness * 1e6")
    line = next(row for row in log[log.index("TMSPH breaking"):].splitlines()
                if row.split()[:1] == ["1"])
    energy, toughness = (float(word) for word in line.split()[4:6])
    exact = 1e12 * (1 - POISSON**2) / YOUNG
    report.within("K of the table/given", toughness / 1e6, 0.999, 1.001)
    report.within("G of the table/K^2 (1 - nu^2)/E", energy / exact, 0.999, 1.001)


def even_bodies():
    """Name and cloud: lattices and relaxed clouds, with free surfaces and interfaces."""
    def disc(seed):
        hole = ("region disc sphere 0 0 0 0.012 units box\n"
                "region hole sphere 0 0 0 0.006 side out units box")
        cloud = Relaxed([Body("core", "sphere 0 0 0 0.006", 113),
                         Body("ring", "intersect 2 disc hole", 340, before=hole)],
                        (-0.013,) * 2, (0.013,) * 2, seed=seed, horizon=3.015e-3).cloud
        cloud.spacing = 1e-3    # of the disc, not of the box
        return cloud

    split = lattice("square", (30, 8), 1e-3, centre=True)
    split.type = 1 + (split.X[:, 0] > 0)
    return (("square", lattice("square", (30, 10), 1e-3, centre=True)), ("of two types", split),
            ("hexagonal", lattice("hex", (20, 6), 1e-3, centre=True)),
            ("cubic", lattice("sc", (9,) * 3, 1e-3, centre=True)),
            ("face-centred", lattice("fcc", (6,) * 3, 1e-3, centre=True)),
            ("turned disc", turned_lattice("square", 20, 1e-3, lambda X: np.linalg.norm(X, axis=1) < 0.01,
                                           cells=40)),
            *((f"relaxed of two types, draw {seed}", disc(seed)) for seed in (1, 2)),
            ("relaxed cube", Relaxed([Body("all", "block 0 0.02 0 0.02 0 0.02", 700)], (0,) * 3,
                                     (0.02,) * 3).cloud))


def imbalance_told(report, name, cloud, times, ranks=1):
    """In the one warning that there is, or none: of a body whose bonds cross a cut."""
    scene = Scene(cloud, [material(YOUNG, POISSON, DENSITY)] * cloud.type.max())
    if cloud.dimension == 2:
        scene.add("tmsph/cut all line -1 1e-5 -0.002 1e-5")
    log = scene.add(f"fix break all tmsph/rankine {ROCK}\nrun 0\nrun 0").run(ranks).log
    told = re.findall(r"lie irregularly: an even stress leaves forces of (\S+) .*'tmsph/relax'", log)
    report.within(f"{name}: warnings", len(told), times, times)
    return float(told[0]) if told else 0.0


def shaken(cloud, amount, seed):
    return copy.deepcopy(cloud).jitter(amount, seed)


def arrangements(report):
    """Particles that lie irregularly are warned of: lattices that are shaken by a tenth of the spacing or
    more, not lattices and relaxed clouds. How far they are from balance: test_openings_long.py."""
    for name, cloud in even_bodies():
        imbalance_told(report, name, cloud, 0)
        if not name.startswith(("relaxed", "of two", "turned")):
            imbalance_told(report, f"{name}, shaken by 0.1", shaken(cloud, 0.1, 1), 1)
            imbalance_told(report, f"{name}, shaken by 0.2", shaken(cloud, 0.2, 2), 1, ranks=2)


if __name__ == "__main__":
    main(energies, still, still_bits, softening, interface, heat, bars, cut_in_mid_opening, same_bits, torn_by_rotation,
         limits, arrangements)
