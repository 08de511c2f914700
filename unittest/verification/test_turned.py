# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A body and the same body turned: by 37 degrees in 2-D, about a general axis by
a general angle in 3-D. Turned back, all that the computes give agrees: vectors,
tensors, scalars and the list of bonds; for each feature alone and for all
together. The bar is 1e-9 of the largest value of each field. Positions are
turned in double precision: strains differ by 1e-16 |x|/dx from the start, 1e-15
here, where 1e-3 is the largest, fields by some 1e-12. The runs are short, for
differences grow where particles collide. Equilibria are sought to a residual of 3e-12: one
of 1e-10 leaves 2e-9 of the stresses open.

With "all": the difference of each field."""

import numpy as np

from tmsph_testing import HORIZON, Cloud, Scene, lattice, main, material, thorough

BAR = 1.0e-9
SPACING = 1.0e-3
MATERIALS = [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2700, 1.0e-5)]
STEP = "timestep 5e-8"
KINDS = {"strain": 2, "stress": 2, "3-D": 3}    # plane strain, plane stress: dimension
BOTH = ("strain", "3-D")
SCALARS = "temperature volume damage nbond nbroken ncut s1 s2 s3 smean vonmises".split()
STRESS = "sxx sxy sxz sxy syy syz sxz syz szz".split()
GRADIENT = "Fxx Fxy Fxz Fyx Fyy Fyz Fzx Fzy Fzz".split()


def rotation(axis, degrees):
    """Rodrigues' formula."""
    x, y, z = np.array(axis, float) / np.linalg.norm(axis)
    K = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
    angle = np.radians(degrees)
    return np.eye(3) + np.sin(angle) * K + (1 - np.cos(angle)) * K @ K


def axis_and_angle(Q):
    """The inverse: the axis, and the angle in degrees."""
    skew = np.array([Q[2, 1] - Q[1, 2], Q[0, 2] - Q[2, 0], Q[1, 0] - Q[0, 1]])
    twice_sine = np.linalg.norm(skew)
    return skew / twice_sine, np.degrees(np.arctan2(twice_sine, np.trace(Q) - 1))


def text(*values):
    return " ".join(f"{v:.17g}" for v in np.concatenate([np.ravel(v) for v in values]))


class Turn:
    """Where everything of a scene is turned to."""

    def __init__(self, dimension, on):
        self.d = dimension
        self.degrees = 37.0 if on else 0.0
        self.Q = np.eye(3)
        if on:
            self.Q = rotation((0, 0, 1), 37.0) if dimension == 2 else rotation((1, -2, 3), 62.0)

    def __call__(self, vectors):
        """Vectors of the body, in rows or one, in space."""
        v = np.asarray(vectors, float)
        return v @ self.Q[: self.d, : self.d].T

    def text(self, vector):
        return text(self(vector))


def potato(dimension, jitter):
    """An irregular body of two materials."""
    if dimension == 2:
        cloud = lattice("hex", (26, 15), SPACING, centre=True)

        def inside(X):
            angle = np.arctan2(X[:, 1], X[:, 0])
            radius = 9.3 * (1 + 0.15 * np.cos(3 * angle) + 0.1 * np.sin(2 * angle))
            return np.hypot(*X.T) < radius * SPACING
    else:
        cloud = lattice("sc", (11, 11, 11), SPACING, centre=True)

        def inside(X):
            x, y, z = X.T / SPACING
            return (x / 5) ** 2 + (y / 4.3) ** 2 + (z / 4) ** 2 + x * y * z / 120 < 1
    volume = cloud.volume[0]
    cloud = cloud.kept(inside)
    x = cloud.X / SPACING - ([1.2, 0.6] if dimension == 2 else [0.3, 0.2, -0.4])
    size = [4.1, 3.2] if dimension == 2 else [2.6, 2.3, 2.1]
    cloud.type = np.where(((x / size) ** 2).sum(axis=1) < 1, 1, 2)
    cloud.volume[:] = volume
    return cloud.jitter(jitter, 5)


def flow(X, speed):
    """A smooth velocity field, none of whose gradients vanishes."""
    x = X / (9 * SPACING)
    n = np.roll(x, -1, axis=1)
    return speed * (np.sin(2 * n + 0.3) + 0.3 * x - 0.4 * np.cos(1.7 * (x - n)))


def warmth(X):
    """A temperature field."""
    x = X / (9 * SPACING)
    return 60 * (1 + np.sin(2 * x[:, 0] + 0.4) * np.cos(1.5 * x[:, 1]))


def turned_cloud(cloud, turn):
    other = Cloud(turn(cloud.X), 1.0, cloud.spacing)
    other.type, other.volume = cloud.type, cloud.volume
    return other


class Turned(Scene):
    """The head of a scene of the cloud, which is given as it stands before it is turned."""

    def __init__(self, kind, cloud, turn, options="viscosity 0.2 0.0", speed=1.5,
                 materials=MATERIALS, heated=True, horizon=HORIZON):
        plane = "" if kind == "3-D" else f"plane {kind} "
        super().__init__(turned_cloud(cloud, turn), materials, plane + options,
                         warmth(cloud.X) if heated else 0.0, horizon)
        self.add("atom_modify map array").lines.insert(0, self.lines.pop())
        self.original, self.turn, self.speed = cloud, turn, speed
        self.rock, self.scalars, self.vectors = False, [], []

    def total(self, fix):
        """Force, torque, work and deepest penetration of a contact or wall."""
        self.vectors += [f"f_{fix}[{k}]" for k in range(1, 7)]
        self.scalars += [f"f_{fix}[{k}]" for k in (7, 8, 9)]

    def moving(self):
        """Before the run: families form, then the particles get velocities."""
        velocities = self.turn(flow(self.original.X, self.speed))
        return self.set("vx vy vz"[: 3 * self.turn.d - 1], velocities)

    def breaking(self, words):
        self.rock = True
        return self.add(f"fix hb all tmsph/hoekbrown {words}")

    def finish(self, run, at_rest=False):
        """Runs and writes everything. Forces in equilibrium are what round-off left."""
        positions = "ux uy uz x0 y0 z0".split()
        scalars = SCALARS + (["strength", "load"] if self.rock else [])
        words = positions + scalars + sorted(set(STRESS)) + GRADIENT
        columns = " ".join(f"c_p[{k + 1}]" for k in range(len(words)))
        self.add(f"compute p all tmsph/property/atom {' '.join(words)}")
        self.add("compute b all tmsph/bond/local id1 id2 state length stretch")
        self.add("compute dt all tmsph/dt\ncompute c all tmsph/crack")
        self.scalars += ["c_dt", "pe"] + [f"c_c[{k}]" for k in range(1, 5)]
        self.thermo("step " + " ".join(self.scalars + self.vectors))
        self.add(run).snapshot("d", f"x y z vx vy vz fx fy fz {columns}")
        self.add("dump b all local 1 b.local index c_b[1] c_b[2] c_b[3] c_b[4] c_b[5]\n"
                 "dump_modify b format float %.17g\nrun 0")
        done = self.run()
        frame = done.frame("d")
        table = done.tables[-2]
        frame.scalars = {name: table[name][-1:] for name in map(thermo_name, self.scalars)}
        frame.vectors = np.array([table[name][-1] for name in self.vectors]).reshape(-1, 3)
        frame.words, frame.at_rest, frame.rock = scalars, at_rest, self.rock
        if "was not found" in done.log:
            raise RuntimeError("an equilibrium was not found")
        for k, word in enumerate(words):
            frame[word] = frame.pop(f"c_p[{k + 1}]")
        bonds = done.frame("b")
        order = np.lexsort((bonds["c_b[2]"], bonds["c_b[1]"]))
        frame.bonds = np.stack([bonds[f"c_b[{k}]"][order] for k in range(1, 6)], axis=1)
        return frame


def thermo_name(word):
    return {"pe": "PotEng"}.get(word, word)


def apart(a, b):
    largest = np.abs(a).max()
    return np.abs(a - b).max() / largest if largest > 0 else np.abs(b).max()


def compare(report, name, frames, Q):
    """The two frames, the second turned back. One line with the worst of all fields."""
    a, b = frames
    differences = {}
    for names in ("x y z", "ux uy uz", "x0 y0 z0", "vx vy vz") + ("fx fy fz",) * (not a.at_rest):
        differences[names] = apart(a(names), b(names) @ Q)
    for names, unit in ((STRESS, 0.0), (GRADIENT, np.eye(3))):
        A, B = (f(" ".join(names)).reshape(-1, 3, 3) - unit for f in (a, b))
        differences[names[0]] = apart(A, Q.T @ B @ Q)
    for word in a.words:
        differences[word] = apart(a[word], b[word])
    for word in a.scalars:
        differences[word] = apart(a.scalars[word], b.scalars[word])
    for k in range(len(a.vectors)):
        differences[f"vector {k}"] = apart(a.vectors[k], b.vectors[k] @ Q)
    if a.bonds.shape != b.bonds.shape or not (a.bonds[:, :3] == b.bonds[:, :3]).all():
        report.true(f"{name}: bonds", False, "the same bonds, broken and cut alike")
        return
    for k, word in ((3, "length"), (4, "stretch")):
        differences[word] = apart(a.bonds[:, k], b.bonds[:, k])
    if thorough():
        report.note(name, " ".join(f"{key} {value:.1e}" for key, value in differences.items()))
    worst = max(differences, key=differences.get)
    report.below(f"{name}: {worst}", differences[worst], BAR)


# ---- scenes: each returns the final frame ----

def elastic(kind, turn, options="viscosity 0.2 0.0"):
    scene = Turned(kind, potato(turn.d, 0.1), turn, options).add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 200")


def strained(kind, turn):
    return elastic(kind, turn, "viscosity 1.0 2.0 thermal strain law almansi kernel quintic "
                               "hourglass 0.3")


def incompressible(kind, turn):
    materials = [material(40e9, 0.49, 2700, 1.5e-5), material(20e9, 0.2, 2700, 1e-5)]
    scene = Turned(kind, potato(turn.d, 0.1), turn, "viscosity 0.2 0.0 dilatation averaged",
                   materials=materials).add(f"fix move all nve\ntimestep 2e-8\nrun 0")
    return scene.moving().finish("run 200")


def rows(kind, turn):
    """A lattice with particles on the horizon and on the flaw."""
    cloud = potato(turn.d, 0.0)
    scene = Turned(kind, cloud, turn, horizon=3.0)
    if turn.d == 2:
        y = cloud.X[np.abs(cloud.X[:, 1]).argmin(), 1]
        ends = turn.text((-3 * SPACING, y)), turn.text((4 * SPACING, y))
        scene.add("tmsph/cut all line " + " ".join(ends))
        scene.add(f"tmsph/cut all arc {turn.text((0, 0))} {text(6 * SPACING)} "
                  + text(turn.degrees + 100, turn.degrees + 190))
    else:
        middle = cloud.X[(cloud.X**2).sum(axis=1).argmin()]
        scene.add(f"tmsph/cut all disc {turn.text(middle)} {turn.text((0, 1, 1))} "
                  + text(3 * SPACING))
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 100")


def breaking(kind, turn, words="gsi 2 80"):
    scene = Turned(kind, potato(turn.d, 0.1), turn, speed=1.5, heated=False)
    scene.breaking(f"strength 1 130e6 strength 2 100e6 mi * 8 weibull * 10 4711 {words}")
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 150")


def opening(kind, turn):
    """Bonds that open, at a lower stress between the materials, and some that are gone: in 3-D that takes more."""
    scene = Turned(kind, potato(turn.d, 0.0), turn, speed=3.0 if turn.d == 2 else 5.0, heated=False)
    scene.breaking("strength 1 130e6 strength 2 100e6 mi * 8 energy * 15 between 1 2 energy 8 strength 8e6")
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 100")


def rubble(kind, turn):
    """Most bonds break, and what they held is thrown towards one point: grains left to themselves
    fly apart, for without bonds they touch along the line between them, a spacing apart, where
    most neighbours were farther. The run ends before waves from the surface free the middle."""
    scene = Turned(kind, potato(turn.d, 0.1), turn, speed=8.0)
    scene.breaking("strength 1 80e6 strength 2 60e6 mi * 8 weibull * 10 4711")
    scene.add("fix touch all tmsph/contact friction * * 0.3 self yes")
    scene.total("touch")
    scene.add(f"fix move all nve\ntimestep 2e-8\nrun 0")
    scene.moving().add(f"run {70 if turn.d == 2 else 30}")
    inwards = -60 / (9 * SPACING) * scene.original.X
    scene.set("vx vy vz"[: 3 * turn.d - 1], turn(inwards))
    return scene.finish("run 40")


def all_principals(kind, turn):
    return breaking(kind, turn, "principal all")


def heat_words(turn):
    if turn.d == 2:
        axes = text(turn.degrees + 25)
    else:
        axes = text(*axis_and_angle(turn.Q @ rotation((2, 1, -1), 40)))
    third = "1.2" if turn.d == 3 else ""
    return (f"conductivity 1 orthotropic 3.4 2.1 {third} {axes} conductivity 2 2.5 "
            "specific/heat * 850")


def boundaries(scene, cloud):
    """Convection everywhere, flux on one side, a temperature on the other."""
    along = cloud.X @ np.array([1.0, 0.4, 0.2])[: cloud.dimension] / SPACING
    ids = lambda chosen: " ".join(str(k + 1) for k in np.flatnonzero(chosen))
    scene.add(f"group front id {ids(along > 4.0)}\ngroup back id {ids(along < -4.5)}")
    scene.add("fix air all tmsph/heat/boundary convection 2e3 20.0")
    scene.add("fix sun front tmsph/heat/boundary flux 2e5")
    scene.add("fix sky front tmsph/heat/boundary radiation 5e-8 900.0 zero -273.15")
    return scene.add("fix cold back tmsph/heat/boundary temperature -10.0")


def heat(kind, turn, jitter=0.1):
    cloud = potato(turn.d, jitter)
    scene = Turned(kind, cloud, turn, "").add(f"fix heat all tmsph/heat {heat_words(turn)}")
    return boundaries(scene, cloud).add("timestep 0.05").finish("run 60")


def heat_rows(kind, turn):
    return heat(kind, turn, 0.0)


def contact(kind, turn, words="method kernel", jitter=0.1):
    """The inclusion is a body of its own."""
    scene = Turned(kind, potato(turn.d, jitter), turn, speed=-8.0).add("pair_coeff 1 2 none")
    scene.add(f"fix touch all tmsph/contact friction * * 0.3 {words}")
    scene.total("touch")
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 100")


def segments(kind, turn):
    return contact(kind, turn, "method segment")


def segment_rows(kind, turn):
    return contact(kind, turn, "method segment", 0.0)


def blocks(kind, turn, words="method kernel"):
    """A block slides on another and against a corner of walls: everything on one lattice."""
    d = turn.d
    cloud = lattice("square" if d == 2 else "sc", (10, 8, 5)[:d], SPACING)
    cloud = cloud.kept(lambda X: (X[:, 1] < 4 * SPACING) | (X[:, 0] < 6 * SPACING))
    cloud.type = np.where(cloud.X[:, 1] < 4 * SPACING, 2, 1)
    scene = Turned(kind, cloud, turn, heated=False).add("pair_coeff 1 2 none")
    scene.add(f"fix touch all tmsph/contact friction * * 0.3 {words}")
    scene.total("touch")
    if d == 2:
        corner = np.array([(-0.5, 9), (0, 0), (5, 0), (10, 0), (10, 9)]) * SPACING
        scene.add(f"fix box all tmsph/wall polyline 5 {turn.text(corner)} friction 0.2")
    else:
        scene.add(f"fix box all tmsph/wall plane {turn.text((0, 0, 0))} {turn.text((0, 1, 0))} "
                  "friction 0.2")
    scene.total("box")
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    V = np.where(cloud.type == 1, 1.0, 0.2)[:, None] * np.array([9.0, -7.0, 3.0])[:d]
    return scene.set("vx vy vz"[: 3 * d - 1], turn(V)).finish("run 120")


def segment_blocks(kind, turn):
    return blocks(kind, turn, "method segment")


def collision(kind, turn):
    """A stone flies against the body, and grains meet in pairs."""
    d = turn.d
    cloud = potato(d, 0.1)
    volume = cloud.volume[0]
    cloud.type[:] = 1
    stone = potato(d, 0.1).kept(lambda X: ((X / SPACING) ** 2).sum(axis=1) < 8)
    way = np.array([1.0, 0.3, 0.2])[:d]
    way /= np.linalg.norm(way)
    ahead = (cloud.X @ way)
    stone.X = stone.X + way * (ahead.max() + 1.3 * SPACING - (stone.X @ way).min())
    place = np.array([12.0, -9.0, 5.0])[:d] * SPACING
    other = place + 6 * SPACING * way
    grains = np.array([place, place + np.roll(way, 1) * 1.1 * SPACING,
                       other, other + np.eye(d)[0] * 1.2 * SPACING])
    all_of = Cloud(np.concatenate([cloud.X, stone.X, grains]), volume, SPACING)
    all_of.type = np.concatenate([cloud.type, np.full(len(stone), 2), [1, 2, 1, 2]])
    V = np.zeros(all_of.X.shape)
    V[len(cloud):-4] = -80 * way
    across = np.roll(way, 2) if d == 3 else way
    V[-4] = 30 * np.roll(way, 1) + 8 * across
    V[-2] = 30 * np.eye(d)[0] + 9 * np.eye(d)[1]
    scene = Turned(kind, all_of, turn, heated=False).add("pair_coeff 1 2 none")
    scene.add("fix touch all tmsph/contact friction * * 0.4")
    scene.total("touch")
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    scene.set("vx vy vz"[: 3 * d - 1], turn(V))
    return scene.finish("run 200")


def cut(scene):
    turn, d = scene.turn, SPACING
    if turn.d == 2:
        ends = turn.text((-6.1 * d, -2.3 * d)), turn.text((-1.4 * d, 3.2 * d))
        scene.add("tmsph/cut all line " + " ".join(ends))
        return scene.add(f"tmsph/cut all arc {turn.text((1.0 * d, -3.0 * d))} {text(3.3 * d)} "
                         + text(turn.degrees + 200, turn.degrees + 290))
    corners = [(-3.3, -2.1, -1.2), (0.4, -2.3, -1.5), (0.6, 2.2, -0.7), (-3.1, 2.4, -0.4)]
    normal = np.cross(np.subtract(corners[1], corners[0]), np.subtract(corners[2], corners[0]))
    last = np.array(corners[3])    # into the plane of the others
    last -= normal * ((last - corners[0]) @ normal) / (normal @ normal)
    scene.add("tmsph/cut all polygon 4 " + " ".join(turn.text(np.array(c) * d)
                                                     for c in corners[:3] + [last]))
    return scene.add(f"tmsph/cut all disc {turn.text((1.9 * d, 0.2 * d, 0.3 * d))} "
                     f"{turn.text((0.6, -0.3, 1.0))} {text(2.2 * d)}")


def cuts(kind, turn):
    scene = cut(Turned(kind, potato(turn.d, 0.1), turn, speed=6.0))
    scene.add("fix touch all tmsph/contact friction * * 0.3 self yes")
    scene.total("touch")
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 100")


def walls(scene):
    """A floor that moves along itself, and another wall that turns."""
    scene.total("floor")
    scene.total("jaw")
    turn, X, d = scene.turn, scene.original.X, SPACING
    if turn.d == 2:
        down, side = np.array([0.2, -1.0]) / 1.04**0.5, np.array([1.0, 0.2]) / 1.04**0.5
        floor = ((X @ down).max() + 0.46 * d) * down
        scene.add(f"fix floor all tmsph/wall line {turn.text(floor - 20 * d * side)} "
                  f"{turn.text(floor + 20 * d * side)} friction 0.3 "
                  f"velocity {turn.text(3 * side - 4 * down)}")
        reach = np.hypot(*(X - 16 * d * side).T).min() - 0.45 * d
        return scene.add(f"fix jaw all tmsph/wall arc {turn.text(16 * d * side)} {text(reach)} "
                         + text(turn.degrees + 290, turn.degrees + 60)
                         + f" friction 0.3 rotation {turn.text(16 * d * side)} 800")
    down, side = np.array([0.2, -0.3, -1.0]) / 1.13**0.5, np.array([1.0, 0.4, -0.3]) / 1.25**0.5
    floor, face = ((X @ n).max() + 0.47 * d for n in (down, side))
    scene.add(f"fix floor all tmsph/wall plane {turn.text(floor * down)} {turn.text(-down)} "
              f"friction 0.3 velocity {turn.text(3 * np.cross(down, side) - 4 * down)}")
    return scene.add(f"fix jaw all tmsph/wall plane {turn.text(face * side)} {turn.text(-side)} "
                     f"friction 0.3 rotation {turn.text(face * side)} "
                     f"{turn.text((0.3, 1.0, -0.5))} 800")


def wall(kind, turn):
    scene = walls(Turned(kind, potato(turn.d, 0.1), turn, speed=6.0))
    scene.add(f"fix move all nve\n{STEP}\nrun 0")
    return scene.moving().finish("run 100")


def held(scene):
    """A free body may come to rest in any position."""
    nearest = np.argsort((scene.original.X**2).sum(axis=1))[:6]
    scene.add("group held id " + " ".join(str(k + 1) for k in nearest))
    return scene.add("fix hold held setforce 0 0 0")


def equilibrium(kind, turn):
    """Minimized until round-off is left."""
    scene = held(Turned(kind, potato(turn.d, 0.1), turn, ""))
    scene.add("min_style tmsph/lbfgs\nrun 0\nminimize 0 1e-12 400 2000")
    return scene.finish("run 0", at_rest=True)


def quasistatic(kind, turn):
    """Heated until bonds break; residuals near round-off."""
    scene = held(Turned(kind, potato(turn.d, 0.1), turn, "", heated=False))
    scene.breaking("strength 1 80e6 strength 2 60e6 mi * 8 weibull * 10 4711")
    scene.add("variable T equal 2*time\ntimestep 1.0")
    scene.add("fix heat all tmsph/heat/boundary temperature v_T")
    return scene.finish("tmsph/quasistatic 50 residual 3e-12", at_rest=True)


def together(kind, turn):
    cloud = potato(turn.d, 0.1)
    materials = [material(40e9, 0.45, 2700, 1.5e-5), material(20e9, 0.2, 2700, 1e-5)]
    scene = cut(Turned(kind, cloud, turn, speed=4.0, materials=materials))
    scene.breaking("strength 1 900e6 strength 2 700e6 mi * 8 weibull * 10 4711")
    scene.add("fix touch all tmsph/contact friction * * 0.3 self yes")
    scene.total("touch")
    scene.add(f"fix heat all tmsph/heat {heat_words(turn)} contact * * 2e3 friction yes "
              "viscous yes time/scale 1e5")
    walls(boundaries(scene, cloud)).add(f"fix move all nve\ntimestep 2e-8\nrun 0")
    return scene.moving().finish("run 150")


SCENES = {
    elastic: KINDS, strained: BOTH, incompressible: BOTH, rows: BOTH, breaking: KINDS, opening: KINDS,
    rubble: BOTH, all_principals: ("strain",), heat: BOTH, heat_rows: BOTH, contact: KINDS,
    segments: ("strain",), segment_rows: ("strain",), blocks: BOTH, segment_blocks: ("stress",),
    collision: BOTH, cuts: ("stress", "3-D"), wall: BOTH, equilibrium: BOTH,
    quasistatic: ("stress", "3-D"), together: BOTH,
}

def case(scene, kind):
    """A case of a report: a scene and the same turned."""
    def judged(report):
        name = f"{scene.__name__} {kind}"
        frames = [scene(kind, Turn(KINDS[kind], on)) for on in (False, True)]
        compare(report, name, frames, Turn(KINDS[kind], True).Q)
        frame = frames[0]
        touching = [n for word, (n,) in frame.scalars.items() if word.endswith("[8]")]
        if 0 in touching or frame.rock and not frame["nbroken"].any():
            report.true(name, False, "its contacts touch and its bonds break")

    judged.__name__ = f"{scene.__name__}_{kind}"
    return judged


if __name__ == "__main__":
    main(*(case(scene, kind) for scene, kinds in SCENES.items() for kind in kinds))
