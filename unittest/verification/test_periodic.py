# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Periodic boundaries and processors: homogeneous deformation of the box gives
its F exactly, a periodic cell is loaded like the middle one of three copies in
a row and like its double, momentum is conserved through the boundary, and
forces, motion and bonds are the same to the last bit on 1, 2 and 4 processors. A
flaw along a row of particles cuts the bonds that it cuts without the boundary."""

from math import fsum

import numpy as np

from tmsph_testing import Cloud, Scene, lattice, main, material

# positions are multiples of GRAIN: distances are exact wherever a copy stands, and so are the
# weights of the bonds, which are kept in single precision
GRAIN = 2.0**-40
SPACING = 2.0**-10
MATERIALS = [material(40e9, 0.3, 2700, 1.5e-5), material(10e9, 0.2, 2000, 1e-5)]
# 7 spacings are just above two horizons: neighbor lists have images beyond the nearest
CELLS = {"2-D": ("square", (9, 7)), "3-D": ("sc", (7, 7, 8))}


class Cell:
    """A periodic cell of two materials, jittered, displaced and heated at random."""

    def __init__(self, name, axes):
        lattice_name, cells = CELLS[name]
        self.cloud = lattice(lattice_name, cells, SPACING, axes).jitter(0.2, 21)
        self.cloud.X = np.round(self.cloud.X / GRAIN) * GRAIN
        random = np.random.default_rng(22)
        n = len(self.cloud)
        self.cloud.type = random.integers(1, 3, n)
        self.shift = 0.05 * SPACING * random.uniform(-1, 1, self.cloud.X.shape)
        self.velocity = random.uniform(-20, 20, self.cloud.X.shape)
        self.temperature = random.uniform(0, 500, n)

    def copies(self, count, periodic):
        """The cell repeated along x."""
        cloud, one = Cloud(np.tile(self.cloud.X, (count, 1)), 1.0, SPACING), self.cloud
        length = one.box[1][0] - one.box[0][0]
        cloud.X[:, 0] += np.repeat(np.arange(count), len(one)) * length
        cloud.type, cloud.volume = np.tile(one.type, count), np.tile(one.volume, count)
        cloud.periodic = one.periodic if periodic else one.periodic.replace("x", "")
        high = one.box[1].copy()
        high[0] = one.box[0][0] + count * length
        cloud.box = (one.box[0], high)
        return cloud

    def scene(self, cloud, options=""):
        scene = Scene(cloud, MATERIALS, options).add("run 0")
        count = len(cloud) // len(self.cloud)
        scene.move(cloud.X + np.tile(self.shift, (count, 1)))
        return scene.set("temperature", np.tile(self.temperature, count))


def forces(cell, cloud):
    frame = cell.scene(cloud).add("run 0").snapshot("d", "fx fy fz").run().frame("d")
    return frame("fx fy fz")


def repetition(report, name):
    """Round-off of sums in another order, on forces of equal size."""
    cell = Cell(name, "xyz"[: int(name[0])])
    n = len(cell.cloud)
    single = forces(cell, cell.cloud)
    size = np.abs(single).max()
    double = forces(cell, cell.copies(2, True))
    error = max(np.abs(double[:n] - single).max(), np.abs(double[n:] - single).max()) / size
    report.below(f"{name}: force against the doubled cell", error, 1e-12)
    row = forces(cell, cell.copies(3, False))
    report.below(f"{name}: force against the middle of three cells",
                 np.abs(row[n: 2 * n] - single).max() / size, 1e-12)
    report.below(f"{name}: sum of forces",
                 max(abs(fsum(single[:, k])) for k in range(3)) / fsum(np.abs(single).ravel()),
                 1e-14)


def homogeneous(report, name):
    """Box scaled at once by change_box, and in steps by fix deform; bar: round-off."""
    cell = Cell(name, "xyz"[: int(name[0])])
    d = cell.cloud.dimension
    stretch = np.array([1.08, 0.95, 1.03][:d])
    axes = "xyz"[:d]
    words = " ".join("F" + a + b for a in axes for b in axes)
    for method in ("change_box", "fix deform"):
        scene = Scene(cell.cloud, MATERIALS)
        scene.add(f"compute p all tmsph/property/atom {words}\nrun 0")
        box = " ".join(f"{a} scale {s}" for a, s in zip(axes, stretch))
        if method == "change_box":
            scene.add(f"change_box all {box} remap\nrun 0")
        else:    # a run of its own at the end: fix deform moves the box after the forces
            scene.add(f"fix box all deform 1 {box} remap x\nrun 20\nunfix box\nrun 0")
        frame = scene.snapshot("d", "c_p[*]").run().frame("d")
        F = frame(" ".join(f"c_p[{k + 1}]" for k in range(d * d)))
        error = np.abs(F - np.diag(stretch).ravel()).max()
        report.below(f"{name}, {method}: error of F", error, 1e-13)


def processors(report, name, steps=200):
    """Motion across all boundaries, with viscosity and changing temperature."""
    cell = Cell(name, "xyz"[: int(name[0])])
    d = cell.cloud.dimension
    momenta, states = [], []
    for ranks in (1, 2, 4):
        scene = cell.scene(cell.copies(2, True), "viscosity 1 2")
        drift = np.array([300.0, -200.0, 100.0])[:d]
        scene.set("vx vy vz"[: 3 * d - 1], np.tile(cell.velocity, (2, 1)) + drift)
        scene.add("variable T equal 300+2*step\nfix heat all tmsph/heat/boundary temperature v_T\n"
                  "fix 1 all nve\ntimestep 4e-8\nneigh_modify every 10 delay 0 check no")
        columns = "x y z vx vy vz fx fy fz"
        scene.snapshot("start", columns).add(f"run {steps}").snapshot("end", "ix " + columns)
        run = scene.run(ranks)
        states.append(run.frame("end")(columns))
        start, end = run.frame("start"), run.frame("end")
        mass = np.array([MATERIALS[t - 1]["density"] for t in np.tile(cell.cloud.type, 2)])
        momenta.append([[fsum(mass * frame[v]) for v in ("vx", "vy", "vz")[:d]]
                        for frame in (start, end)])
    before, after = np.array(momenta[0])
    report.below(f"{name}: momentum lost in {steps} steps", np.abs(after - before).max()
                 / np.abs(before).max(), 1e-13)
    report.above(f"{name}: particles that crossed the boundary in x",
                 np.count_nonzero(end["ix"]), 0)
    for k, ranks in ((1, 2), (2, 4)):
        report.true(f"{name}: {ranks} processors like one, {steps} steps",
                    np.array_equal(states[0], states[k]), "to the last bit")
    still = [forces_on(cell, ranks) for ranks in (1, 2, 4)]
    report.true(f"{name}: forces on 1, 2, 4 processors",
                np.array_equal(still[0], still[1]) and np.array_equal(still[0], still[2]),
                "to the last bit")


def forces_on(cell, ranks):
    scene = cell.scene(cell.copies(2, True), "viscosity 1 2").add("run 0")
    return scene.snapshot("d", "fx fy fz").run(ranks).frame("d")("fx fy fz")


def flaw_on_a_row(report, name):
    """Away from the boundary, on particles but for round-off."""
    lattice_name, d = CELLS[name][0], int(name[0])
    cut = []
    for periodic in ("xyz"[:d], ""):
        cloud = lattice(lattice_name, (12,) * d, SPACING, periodic).jitter(1e-12, 23)
        corners = [(3.5, 3.5), (3.5, 8.5)] if d == 2 else \
            [(3.5, 3.5, 3.5), (3.5, 8.5, 3.5), (3.5, 8.5, 8.5), (3.5, 3.5, 8.5)]
        place = " ".join(f"{x * SPACING:.17g}" for corner in corners for x in corner)
        scene = Scene(cloud, MATERIALS[:1]).add("compute p all tmsph/property/atom ncut")
        scene.add(f"tmsph/cut all {'line' if d == 2 else 'polygon 4'} {place}\nrun 0")
        cut.append(scene.snapshot("d", "c_p").run().frame("d")("c_p"))
    report.above(f"{name}: ends of bonds that a flaw on a row cuts", cut[1].sum(), 0)
    report.true(f"{name}: in a periodic box the same", np.array_equal(*cut), "all of them")


def cells(report, name):
    flaw_on_a_row(report, name)
    repetition(report, name)
    homogeneous(report, name)
    processors(report, name)


def in_2d(report):
    cells(report, "2-D")


def in_3d(report):
    cells(report, "3-D")


if __name__ == "__main__":
    main(in_2d, in_3d)
