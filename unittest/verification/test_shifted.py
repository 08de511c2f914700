# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A small body in the middle of a periodic box, and the same across a face, an edge and a corner of
it: in one run and in three, with a restart in between, on other processors, balanced, with other
image flags and new ids. All fields of all particles and what fixes tell agree to 1e-9 of the
largest, damage too. A body slides through the boundary on walls as long as the box, and longer.
With "all": in all ways at all places."""

import numpy as np

from tmsph_testing import HORIZON, Scene, Script, lattice, main, material, thorough

BAR = 1e-9
GRAIN = 2.0**-40    # positions are multiples of it: reference distances are exact at any place
SPACING = 2.0**-10
BOX = {2: 32, 3: 18}                          # spacings
CELLS = {2: (8, 8), 3: (5, 5, 6)}
PLACES = {2: {"face": (16.4, 0), "edge": (15.6, -16.3)},
          3: {"face": (0, 9.3, 0), "edge": (8.7, 0, 9.2), "corner": (9.4, -8.8, 9.1)}}
# of the body, which crosses faces in the run; the upper half closes in on the lower one and slips
DRIFT = np.array([40.0, -30.0, 20.0])
CLOSING = np.array([6.0, 3.0, -4.0])
GHOSTS = f"comm_modify cutoff {6.1 * SPACING:g}"


def grains(x):
    return np.round(np.asarray(x) / GRAIN) * GRAIN


class Body:
    """Two halves of different rock, jittered, in motion and unevenly hot, at a place in the box."""

    def __init__(self, dimension, shift):
        cells, length = np.array(CELLS[dimension]), BOX[dimension] * SPACING
        cloud = lattice({2: "square", 3: "sc"}[dimension], cells, SPACING).jitter(0.1, 5)
        reference = grains(cloud.X)
        self.corner = grains((0.5 * (BOX[dimension] - cells) + shift) * SPACING)
        cloud.type = np.where(reference[:, -1] < 0.5 * cells[-1] * SPACING, 1, 2)
        cloud.X = (reference + self.corner) % length
        cloud.periodic, cloud.box = "xyz"[:dimension], (np.zeros(3), np.full(3, length))
        self.temperature = np.random.default_rng(6).uniform(50, 100, len(cloud))
        y = (reference - reference.mean(axis=0)) / (4 * SPACING)
        self.velocity = DRIFT[:dimension] + 3 * np.sin(2 * y[:, ::-1]) + 2 * y
        self.velocity[cloud.type == 2] += CLOSING[3 - dimension:]
        self.cloud, self.dimension = cloud, dimension

    def at(self, *spacings):
        """Words for a place, in spacings from the lower corner of the body, perhaps outside of the
        box."""
        return " ".join(f"{x:.17g}" for x in self.corner + np.array(spacings) * SPACING)


class Feature:
    """What an input has before its first run, before each run, and what runs."""

    rocks = [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2500, 1e-5)]
    dimensions = (2, 3)
    bonded = True
    horizon = HORIZON
    told = "pe"
    forces = True

    def groups(self, body):
        return ""

    def fixes(self, body):
        return "fix move all nve"

    def flaw(self, body):
        return ""

    def steps(self, part):
        return f"run {20 * part}"


class Breaking(Feature):
    """two rocks, breaking"""
    told = "f_rock f_rock[1] f_rock[2] f_rock[5]"

    def fixes(self, body):
        return ("fix move all nve\n"
                "fix rock all tmsph/hoekbrown strength * 90e6 mi * 10 weibull * 10 4711")


class Opening(Feature):
    """two rocks, bonds that open"""
    told = "f_rock f_rock[6] f_rock[10] f_rock[11]"
    horizon = 2.7    # of spacings that are shorter when particles are moved: 3 of these

    def fixes(self, body):
        return ("fix move all nve\n"
                "fix rock all tmsph/hoekbrown strength * 90e6 mi * 10 weibull * 10 4711 energy * 15 "
                "between 1 2 energy 8")


class Averaged(Feature):
    """averaged dilatation"""
    rocks = [material(40e9, 0.45, 2700, 1.5e-5), material(20e9, 0.3, 2500, 1e-5)]


class Contact(Feature):
    """contact, cut, breaking"""
    bonded = False
    told = "f_touch[1] f_touch[2] f_touch[3] f_touch[7] f_touch[8] f_touch[9] f_touch[10] f_rock"

    def fixes(self, body):
        return ("fix move all nve\n"
                "fix rock all tmsph/hoekbrown strength * 90e6 mi * 10 weibull * 10 4711\n"
                "fix touch all tmsph/contact friction * * 0.4 self yes")

    def flaw(self, body):
        if body.dimension == 2:
            return f"tmsph/cut all line {body.at(2.5, 0.8)} {body.at(5.8, 2.6)}"
        return f"tmsph/cut all disc {body.at(2.5, 2.5, 1.5)} 0.3 0.1 1 {1.9 * SPACING:.17g}"


class Segments(Contact):
    """contact of method segment"""
    dimensions = (2,)
    told = "f_touch[1] f_touch[2] f_touch[7] f_touch[8] f_touch[9] f_touch[10]"

    def fixes(self, body):
        return ("fix move all nve\n"
                "fix touch all tmsph/contact friction * * 0.4 method segment self no")

    def flaw(self, body):
        return ""

    def steps(self, part):    # the bodies leave each other later
        return f"run {10 * part}"


class Walls(Feature):
    """walls: endless, in motion, turning, under a load"""
    told = " ".join(f"f_{wall}[{k}]" for wall in ("floor", "plate", "jaw", "hill")
                    for k in (1, 2, 3, 7, 8, 9, 11))

    def fixes(self, body):
        at, wide, cells = body.at, BOX[body.dimension], CELLS[body.dimension]
        right, top = cells[0], cells[-1]
        if body.dimension == 2:
            walls = (f"floor all tmsph/wall line {at(-wide, -0.05)} {at(2 * wide, -0.05)} "
                     "friction 0.3",
                     f"plate all tmsph/wall polyline 3 {at(3 + wide, top + 0.05)} "
                     f"{at(6, top + 0.5)} {at(3, top + 0.05)} velocity 3 -80 friction 0.5",
                     f"jaw all tmsph/wall line {at(right + 0.05, -2)} {at(right + 0.05, top + 2)} "
                     "load -1e5 0 mass 1e-3",
                     f"hill all tmsph/wall arc {at(-3.02, 3.9)} {3 * SPACING:.17g} 100 -100 "
                     f"side both velocity 60 0 rotation {at(-2.9, 4.1)} 2000 friction 0.2")
        else:
            walls = (f"floor all tmsph/wall plane {at(0, 0, -0.05)} 0 0 1 velocity 0 0 30 "
                     "friction 0.3",
                     f"plate all tmsph/wall plane {at(0, 0, top + 0.05)} 0 0 -1 velocity 3 2 -8 "
                     "friction 0.5",
                     f"jaw all tmsph/wall plane {at(right + 0.05, 0, 0)} -1 0 0 load -1 0 0 "
                     "mass 1e-6",
                     f"hill all tmsph/wall plane {at(0, -0.05, 0)} 0 1 0 side both friction 0.2 "
                     "velocity v_in 4 0")
        return "variable in equal 3*sin(1e7*time)\nfix move all nve\nfix " + "\nfix ".join(walls)


class Heat(Feature):
    """conduction, its surfaces and contacts"""
    bonded = False
    told = "f_heat f_heat[1] f_heat[2] f_heat[4] f_warm[1] f_warm[3] f_lost[2] f_lost[3]"

    def groups(self, body):
        return "group some id < 25"

    def fixes(self, body):
        ball = "sphere" if body.dimension == 3 else "cylinder z"
        middle = body.at(*(0.5 * np.array(CELLS[body.dimension])))
        ends = "" if body.dimension == 3 else " INF INF"
        return (f"region ball {ball} {middle} {3.7 * SPACING:.17g}{ends} units box\n"
                "fix move all nve\n"
                "fix touch all tmsph/contact friction * * 0.4\n"
                "fix heat all tmsph/heat conductivity * 3 specific/heat 1 850 specific/heat 2 700 "
                "time/scale 1e4 contact * * 2000 friction yes\n"
                "fix warm some tmsph/heat/boundary temperature 200 place surface region ball\n"
                "fix lost all tmsph/heat/boundary convection 5000 20 cracks yes")


class Minimum(Feature):
    """minimizer tmsph/lbfgs"""
    forces = False

    def groups(self, body):    # one side is held: there is one equilibrium
        return f"group held id <= {np.prod(CELLS[body.dimension][1:])}"

    def fixes(self, body):
        return "fix hold held setforce 0 0 0\nmin_style tmsph/lbfgs"

    def steps(self, part):
        return f"minimize 0 1e-10 {50 * part} 20000"


class Quasistatic(Minimum):
    """equilibria on the thermal clock, breaking"""
    told = "f_rock f_rock[1] f_rock[2]"

    def fixes(self, body):
        return ("variable T equal 25*step\nfix warm all tmsph/heat/boundary temperature v_T\n"
                f"fix rock all tmsph/hoekbrown strength * {200 if body.dimension == 2 else 330}e6 "
                "mi * 10\n"
                "fix hold held setforce 0 0 0")

    def steps(self, part):    # as short as can be: they do not depend on what a run knows
        return f"thermo 1\ntmsph/quasistatic {part} residual 1e-11 evaluations 3000"


FEATURES = (Breaking, Opening, Averaged, Contact, Segments, Walls, Heat, Minimum)


def again(feature, body, script):
    """What has to be said after a restart too."""
    axes = "xyz"[: body.dimension]
    words = [f"s{a}{b}" for k, a in enumerate(axes) for b in axes[k:]] + [f"u{a}" for a in axes]
    return script.add(
        f"{feature.fixes(body)}\ntimestep 4e-8\n"
        f"compute p all tmsph/property/atom {' '.join(words)} "
        f"temperature damage\ncompute r all tmsph/property/atom {' '.join(a + '0' for a in axes)}\n"
        f"thermo_style custom step {feature.told}\nthermo_modify norm no format float %.17g\n"
        "thermo 1000000")


def start(feature, body, first="", images=""):
    scene = Scene(body.cloud, feature.rocks, "viscosity 0.5 1", horizon=feature.horizon)
    scene.lines.insert(scene.lines.index("read_data cloud.data"), f"{GHOSTS}\n{first}")
    scene.set("temperature", body.temperature)
    scene.set("vx vy vz"[: 3 * body.dimension - 1], body.velocity)
    if not feature.bonded:
        scene.add("pair_coeff 1 2 none")
    scene.add(feature.groups(body) + "\n" + images)
    return again(feature, body, scene).add(feature.flaw(body))


def end(feature, script, ranks=1):
    forces = " fx fy fz" if feature.forces else ""
    return script.snapshot("d", "c_p[*] vx vy vz" + forces).snapshot("r", "c_r[*]").run(ranks)


def one(feature, body):
    return end(feature, start(feature, body).add(feature.steps(6)))


def three(feature, body):
    scene = start(feature, body, images="set type 2 image 1 0 0\nset atom 7 image 0 -2 0")
    for part in (1, 3, 2):
        scene.add(feature.steps(part))
    return end(feature, scene)


def restarted(feature, body):
    scene = start(feature, body).add(feature.steps(1)).add(feature.steps(2))
    kept = scene.add("write_restart r").run(keep="r").kept
    script = again(feature, body, Script(f"{GHOSTS}\nprocessors * 3 1\nread_restart r", kept))
    return end(feature, script.add(feature.steps(3)), 3)


def balanced(feature, body):
    scene = start(feature, body, "comm_style tiled").add(feature.steps(2)).add("balance 1.0 rcb")
    return end(feature, scene.add(feature.steps(4)), 4)


WAYS = {"in one run": one, "in three": three, "restarted on 3": restarted,
        "balanced on 4": balanced}
CHOSEN = {"face": three, "edge": restarted, "corner": balanced}


def compare(report, name, run, middle, order=slice(None)):
    mine, his = run.frame("d"), middle.frame("d")
    worst = {}
    for column in set(his) - {"id"}:
        scale = np.abs(his[column]).max()
        if scale > 0:
            worst[column] = np.abs(mine[column][order] - his[column]).max() / scale
    table = middle.tables[-1]
    for column in set(table) - {"Step"}:
        # a component of a force by the size of the force, or of what it is a sum of
        alike = [column] + [f"{column[:-3]}[{k}]" for k in (1, 2, 3, 10)
                            if column[-3:] in ("[1]", "[2]", "[3]")]
        scale = max(abs(table[c][-1]) for c in alike if c in table)
        if scale > 0:
            worst[column] = abs(run.thermo(column)[-1] - middle.thermo(column)[-1]) / scale
    column = max(worst, key=worst.get)
    report.below(f"{name}: worst is {column}", worst[column], BAR)


def shifted(report, kind, everything):
    for d in kind.dimensions:
        feature = kind()
        middle = one(feature, Body(d, np.zeros(d)))
        for where, shift in PLACES[d].items():
            body = Body(d, np.array(shift))
            for way, run in WAYS.items():
                if everything or run is CHOSEN[where]:
                    compare(report, f"{d}-D, {kind.__doc__}, {where}, {way}", run(feature, body),
                            middle)


def case(kind):
    """A case of a report: a body with a feature, shifted."""
    def judged(report):
        shifted(report, kind, thorough())

    judged.__name__ = kind.__name__.lower()
    return judged


def renumbered(report):
    """New ids between two runs, where LAMMPS lets particles have some."""
    for d, where in ((2, "edge"), (3, "corner")):
        feature, length = Breaking(), BOX[d] * SPACING
        middle = one(feature, Body(d, np.zeros(d)))
        body = Body(d, np.array(PLACES[d][where]))
        scene = start(feature, body).add(feature.steps(1)).add("reset_atoms id sort yes")
        run = end(feature, scene.add(feature.steps(5)))
        words = " ".join(f"c_r[{k + 1}]" for k in range(d))
        X, Y = run.frame("r")(words), middle.frame("r")(words)
        Y += body.corner - Body(d, np.zeros(d)).corner
        apart = X[None] - Y[:, None]
        apart = np.abs(apart - length * np.round(apart / length)).max(axis=2)
        order = apart.argmin(axis=1)
        report.true(f"{d}-D, new ids", np.any(order != np.arange(len(order))), "are others")
        compare(report, f"{d}-D, {feature.__doc__}, {where}, new ids", run, middle, order)


def refused(report):
    """Image flags that are changed in between are an error that says so."""
    feature = Averaged()
    scene = start(feature, Body(2, np.array(PLACES[2]["face"])))
    scene.add("run 200\nrun 0\nset group all image 0 0 0\nrun 1")
    run = scene.run(may_fail=True)
    errors = [line for line in run.log.splitlines() if line.startswith("ERROR")]
    report.true("image flags that are changed between runs",
                len(errors) == 1 and "set image" in errors[0], "are one error")


def slide(report, dimension, wall, friction):
    """On a wall through the boundary, under gravity: m (dv + mu dv_n) = -mu m g t at each moment as
    long as all particles slip, and as in a box that is not periodic."""
    n, length = (10, 30) if dimension == 2 else (5, 15)
    runs = []
    for periodic in (True, False):
        cloud = lattice({2: "square", 3: "sc"}[dimension], (n,) * dimension, 1e-3)
        cloud.X[:, 0] += 2e-3
        cloud.periodic = "xy"[: dimension - 1] if periodic else ""
        cloud.box = (np.zeros(3), np.full(3, length * 1e-3))
        # particles that also spread to the sides, in 3-D, slip in slightly other directions
        scene = Scene(cloud, [material(4e6, 0.25 if dimension == 2 else 0.0)], "viscosity 1 2")
        down = "0 -1 0" if dimension == 2 else "0 0 -1"
        shape = wall if periodic or dimension == 3 else "line -0.1 0 0.2 0"
        scene.add(f"fix g all gravity 100 vector {down}\n"
                  f"fix floor all tmsph/wall {shape} friction {friction}\n"
                  "fix move all nve\nvelocity all set 5 0 NULL units box\ntimestep 3e-6\n"
                  "variable vx equal vcm(all,x)\nvariable vn equal vcm(all,VN)\n"
                  "variable now equal time"
                  .replace("VN", "xyz"[dimension - 1]))
        scene.thermo(f"step v_vx v_vn v_now f_floor[{dimension}] f_floor[8]", 50)
        runs.append(scene.add("run 3000\nrun 1000").run())
    name = f"{dimension}-D, {wall}, friction {friction}"
    here, there = ({c: np.concatenate([t[c] for t in run.tables]) for c in run.tables[0]}
                   for run in runs)
    want = 5 - friction * (100 * here["v_now"] + here["v_vn"])
    report.below(f"{name}: error of the velocity", np.abs(here["v_vx"] - want).max() / 5,
                 1e-12 if dimension == 2 else BAR)
    touching = here["f_floor[8]"]    # at first the body, which is let go, bounces
    report.true(f"{name}: particles that touch",
                np.array_equal(touching[1:], there["f_floor[8]"][1:])
                and np.all(touching[-40:] == n ** (dimension - 1)),
                "as in a wide box, all in the end")
    for column in ("v_vx", "v_vn", f"f_floor[{dimension}]"):
        report.below(f"{name}: {column} against a wide box",
                     np.abs(here[column] - there[column]).max() / np.abs(there[column]).max(), BAR)


def sliding(report):
    for wall in ("line 0 0 0.03 0", "line -0.01 0 0.04 0", "polyline 3 0.01 0 0.025 0 0.04 0"):
        slide(report, 2, wall, 0.1)
    slide(report, 2, "line 0 0 0.03 0", 0)
    slide(report, 3, "plane 0 0 0 0 0 1", 0.1)


if __name__ == "__main__":
    # equilibria that break are in test_shifted_quasistatic.py
    main(*map(case, FEATURES), renumbered, refused, sliding)
