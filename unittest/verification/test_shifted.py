# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A small body in the middle of a periodic box, and the same across a face, an edge and a corner of
it: in one run and in three, with a restart in between, on other processors, balanced, with new ids.
All fields of all particles and what fixes tell agree to 1e-9 of the largest, broken bonds are the
same. With names of features as arguments only these."""

from tmsph_testing import *

BAR = 1e-9
GRAIN = 2.0**-40    # positions are multiples of it: reference distances are exact at any place
SPACING = 2.0**-10
BOX = {2: 32, 3: 18}                          # spacings
CELLS = {2: (8, 8), 3: (5, 5, 6)}
PLACES = {2: {"face": (16.4, 0), "edge": (15.6, -16.3)},
          3: {"face": (0, 9.3, 0), "edge": (8.7, 0, 9.2), "corner": (9.4, -8.8, 9.1)}}
# of one body that crosses the faces in the run; the upper half closes in on the lower one and slips
DRIFT = np.array([40.0, -30.0, 20.0])
CLOSING = np.array([6.0, 3.0, 4.0])


def grains(x):
    return np.round(np.asarray(x) / GRAIN) * GRAIN


class Body:
    """Two halves of different rock, jittered, in motion and unevenly hot, at a place in the box."""

    def __init__(self, dimension, shift):
        cloud = lattice({2: "square", 3: "sc"}[dimension], CELLS[dimension], SPACING).jitter(0.1, 5)
        self.low = grains((0.5 * (BOX[dimension] - np.array(CELLS[dimension])) + shift) * SPACING)
        reference = grains(cloud.X)
        length = BOX[dimension] * SPACING
        cloud.type = np.where(reference[:, -1] < 0.5 * CELLS[dimension][-1] * SPACING, 1, 2)
        cloud.X = (reference + self.low) % length
        cloud.periodic = "xyz"[:dimension]
        cloud.box = (np.zeros(3), np.full(3, length))
        random = np.random.default_rng(6)
        self.temperature = random.uniform(50, 100, len(cloud))
        y = (reference - reference.mean(axis=0)) / (4 * SPACING)
        self.velocity = DRIFT[:dimension] + 3 * np.sin(2 * y[:, ::-1]) + 2 * y
        across = CLOSING[:dimension].copy()
        across[-1] *= -1
        self.velocity[cloud.type == 2] += across
        self.cloud, self.dimension = cloud, dimension

    def at(self, *spacings):
        """Words for a place, in spacings from the lower corner of the body, perhaps outside of the box."""
        return " ".join(f"{x:.17g}" for x in self.low + np.array(spacings) * SPACING)


class Feature:
    """What an input has before its first run, before each run, and what runs."""

    ROCKS = [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2500, 1e-5)]
    pair = "viscosity 0.5 1"
    bonded = True
    dimensions = (2, 3)
    told = "pe"
    forces = True
    keeps_ids = False    # LAMMPS refuses new ones

    def once(self, body):
        return ""

    def fixes(self, body):
        return "fix move all nve"

    def steps(self, part):
        return f"run {20 * part}"


class Interface(Feature):
    """elastic and thermal, two rocks"""


class Averaged(Feature):
    """averaged dilatation and its interfaces"""
    ROCKS = [material(40e9, 0.45, 2700, 1.5e-5), material(20e9, 0.3, 2500, 1e-5)]


class Breaking(Feature):
    """breaking, fragments that repel each other"""
    told = "f_rock f_rock[1] f_rock[2] f_rock[5]"

    def fixes(self, body):
        return "fix move all nve\nfix rock all tmsph/hoekbrown strength * 60e6 mi * 10 weibull * 10 4711"


class Contact(Feature):
    """contact with friction of two bodies, of the faces of a cut and of cracks"""
    bonded = False
    keeps_ids = True
    told = "f_touch[1] f_touch[2] f_touch[3] f_touch[7] f_touch[8] f_touch[9] f_touch[10] f_rock"

    def once(self, body):
        nx, ny = CELLS[body.dimension][0], CELLS[body.dimension][1]
        if body.dimension == 2:
            return f"tmsph/cut all line {body.at(0.31 * nx, 0.1)} {body.at(0.72 * nx, 0.33 * ny)}"
        return f"tmsph/cut all disc {body.at(0.5 * nx, 0.5 * ny, 1.5)} 0.3 0.1 1 {1.9 * SPACING:.17g}"

    def fixes(self, body):
        return ("fix move all nve\nfix rock all tmsph/hoekbrown strength * 90e6 mi * 10 weibull * 10 4711\n"
                "fix touch all tmsph/contact friction * * 0.4 self yes")


class Segments(Contact):
    """contact with friction, method segment"""
    dimensions = (2,)

    def fixes(self, body):
        return "fix move all nve\nfix touch all tmsph/contact friction * * 0.4 method segment self no"

    told = "f_touch[1] f_touch[2] f_touch[7] f_touch[8] f_touch[9] f_touch[10]"

    def once(self, body):
        return ""


class Walls(Feature):
    """walls with friction: endless, moving, turning, under a load, over faces of the box"""
    keeps_ids = True
    told = " ".join(f"f_{wall}[{k}]" for wall in ("floor", "plate", "jaw", "hill") for k in (1, 2, 3, 7, 8, 9, 11)
                    ) + " f_hill[6] f_hill[13]"

    def fixes(self, body):
        at, nx, top = body.at, CELLS[body.dimension][0], CELLS[body.dimension][-1]
        wide = BOX[body.dimension]
        if body.dimension == 2:
            walls = (f"floor all tmsph/wall line {at(-wide, -0.1)} {at(2 * wide, -0.1)} friction 0.3",
                     f"plate all tmsph/wall polyline 3 {at(0.4 * nx + wide, top + 0.1)} {at(0.7 * nx, top + 0.5)} "
                     f"{at(0.4 * nx, top + 0.1)} velocity 3 -8 friction 0.5",
                     f"jaw all tmsph/wall line {at(nx + 0.1, -2)} {at(nx + 0.1, top + 2)} load -1e5 0 mass 1e-3",
                     f"hill all tmsph/wall arc {at(-3.05, 3.9)} {3 * SPACING:.17g} 100 -100 side both "
                     f"rotation {at(-2.9, 4.1)} 2000 friction 0.2")
        else:
            walls = (f"floor all tmsph/wall plane {at(0, 0, -0.1)} 0 0 1 friction 0.3",
                     f"plate all tmsph/wall plane {at(0, 0, top + 0.1)} 0 0 -1 velocity 3 2 -8 friction 0.5",
                     f"jaw all tmsph/wall plane {at(nx + 0.1, 0, 0)} -1 0 0 load -1 0 0 mass 1e-6",
                     f"hill all tmsph/wall plane {at(0, -0.05, 0)} 0 1 0 side both friction 0.2 velocity v_in 4 0")
        return "variable in equal 3*sin(1e7*time)\nfix move all nve\nfix " + "\nfix ".join(walls)


class Heat(Feature):
    """conduction with surfaces, across contacts, heat of friction"""
    bonded = False
    keeps_ids = True
    told = "f_heat f_heat[1] f_heat[2] f_heat[4] f_warm[1] f_warm[3] f_lost[2] f_lost[3]"

    def once(self, body):
        return "group some id < 25"

    def fixes(self, body):
        return ("fix move all nve\nfix touch all tmsph/contact friction * * 0.4\n"
                "fix heat all tmsph/heat conductivity * 3 specific/heat 1 850 specific/heat 2 700 time/scale 1e4 "
                "contact * * 2000 friction yes\n"
                "fix warm some tmsph/heat/boundary temperature 200 place surface\n"
                "fix lost all tmsph/heat/boundary convection 5000 20 cracks yes")


class Minimum(Feature):
    """minimizer tmsph/lbfgs"""
    forces = False
    told = "pe"

    def steps(self, part):
        return f"min_style tmsph/lbfgs\nminimize 0 1e-9 {4000} 20000"


class Quasistatic(Feature):
    """equilibria on the thermal clock, breaking"""
    forces = False
    told = "f_rock f_rock[1] f_rock[2]"

    def fixes(self, body):
        return ("variable T equal 2*step\nfix warm all tmsph/heat/boundary temperature v_T\n"
                "fix rock all tmsph/hoekbrown strength * 60e6 mi * 10 weibull * 10 4711")

    def steps(self, part):
        return f"tmsph/quasistatic {20 * part} residual 1e-10"


FEATURES = {f.__doc__: f for f in (Interface, Averaged, Breaking, Contact, Segments, Walls, Heat, Minimum,
                                   Quasistatic)}


def both(feature, body, script):
    """What has to be said again after a restart."""
    d = body.dimension
    stress = {2: "sxx syy sxy", 3: "sxx syy szz sxy sxz syz"}[d]
    u = " ".join("u" + a for a in "xyz"[:d])
    script.add(feature.fixes(body) + "\ntimestep 4e-8\n"
               f"compute p all tmsph/property/atom {u} {stress} temperature damage x0 y0 z0\n"
               "compute b all tmsph/bond/local id1 id2 state\n"
               f"thermo_style custom step {feature.told}\n"
               "thermo_modify norm no format float %.17g\nthermo 1000000")
    return script


def finish(feature, script):
    return script.snapshot("d", "c_p[*] vx vy vz" + (" fx fy fz" if feature.forces else "")).add(
        "dump b all local 1 b.local c_b[1] c_b[2] c_b[3]\nrun 0 post no" if False else "")


def start(feature, body, grid=""):
    scene = Scene(body.cloud, feature.ROCKS, feature.pair)
    scene.lines.insert(4, "comm_modify cutoff %g" % (6.1 * SPACING))
    scene.lines[5] = grid
    scene.set("temperature", body.temperature)
    scene.set("vx vy vz"[: 3 * body.dimension - 1], body.velocity)
    if not feature.bonded:
        scene.add("pair_coeff 1 2 none")
    scene.add(feature.once(body))
    return both(feature, body, scene)


def one(feature, body):
    return finish(feature, start(feature, body).add(feature.steps(6))).run()


def three(feature, body):
    scene = start(feature, body)
    for part in (1, 3, 2):
        scene.add(feature.steps(part))
    return finish(feature, scene).run()


def restarted(feature, body, ranks=3, grid="processors * 3 1"):
    first = start(feature, body).add(feature.steps(1)).add(feature.steps(2)).add("write_restart r")
    kept = first.run(keep="r").kept
    script = Script(f"comm_modify cutoff {6.1 * SPACING:g}\n{grid}\nread_restart r", kept)
    both(feature, body, script).add(feature.steps(3))
    return finish(feature, script).run(ranks)


def balanced(feature, body):
    scene = start(feature, body, "comm_style tiled").add(feature.steps(2))
    scene.add("balance 1.0 rcb").add(feature.steps(4))
    return finish(feature, scene).run(4)


def renumbered(feature, body):
    scene = start(feature, body).add(feature.steps(1)).add("reset_atoms id sort yes")
    scene.add(feature.steps(5))
    return finish(feature, scene).run()


WAYS = {"in one run": one, "in three runs": three, "restarted": restarted, "balanced": balanced}


def compare(report, name, run, middle, same_ids=True):
    mine, his = run.frame("d"), middle.frame("d")
    worst = {}
    for column in his:
        if column == "id" or column in X0:
            continue
        scale = np.abs(his[column]).max()
        if scale > 0:
            worst[column] = np.abs(mine[column] - his[column]).max() / scale
    for column in run.tables[-1]:
        a, b = run.thermo(column)[-1], middle.thermo(column)[-1]
        if b != 0:
            worst[column] = abs(a - b) / abs(b)
    column = max(worst, key=worst.get)
    report.below(f"{name}: {column}", worst[column], BAR)


X0 = ()
if __name__ == "__main__":
    report = Report()
    for name, kind in FEATURES.items():
        if len(sys.argv) > 1 and kind.__name__ not in sys.argv[1:]:
            continue
        for d in kind.dimensions:
            feature = kind()
            k = 3 * (d - 1) + 3 + d * 0
            X0 = tuple(f"c_p[{n}]" for n in range({2: 8, 3: 12}[d], {2: 11, 3: 15}[d]))
            middle = one(feature, Body(d, np.zeros(d)))
            print(d, name, {c: v[-1] for c, v in middle.tables[-1].items()})
            for where, shift in dict(middle=(0,) * d, **PLACES[d]).items():
                body = Body(d, np.array(shift))
                for way, run in WAYS.items():
                    if where == "middle" and way == "in one run":
                        continue
                    compare(report, f"{d}-D, {name}, {where}, {way}", run(feature, body), middle)
    report.finish()
