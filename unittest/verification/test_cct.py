# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Centre-cracked plates whose bonds open, pulled apart between grips in equilibrium: the peak of the load
against finite elements with a cohesive zone (cohesive_zone.py), which are held to the limits of an
infinite plate first. Other spacings, lattices and lengths: test_cct_long.py."""

import numpy as np

from cohesive_zone import centre_cracked
from test_openings import DENSITY, ENERGY, LENGTH, POISSON, ROCK, TENSILE, YOUNG, turned_lattice
from tmsph_testing import HORIZON, Scene, main, material

SPEED = np.sqrt(YOUNG / DENSITY)
LATTICES = (("square", 0), ("square", 30), ("hex", 0), ("hex", 15))
COLUMNS = ("f_low[2]", "f_high[2]", "f_break[11]", "f_break")
BETWEEN = 0.03    # largest difference of peaks between lattices
SIZES = {1: (4, 2.5), 2: (6, 3), 5: (10, 5), 10: (18, 9)}    # half width and height for each a, over LENGTH

# Rows beyond the height are held. Without a crack the plate is as stiff as one that is by so many
# spacings higher (0.70 to 0.82 on these lattices, at two heights): the fits at the last free rows
# see the held ones

GRIP = 0.77


def crossing(X, reach):
    """Bonds across the line y = 0: where they cross it, and their weight. The pull of a bond across the line is as
    its kernel times its height."""
    low, high = (X[(side * X[:, 1] > 0) & (abs(X[:, 1]) < reach)] for side in (-1, 1))
    between = high[:, None] - low[None]
    q = 2 * np.linalg.norm(between, axis=2) / reach
    weight = np.where(q < 2, (1 - 0.5 * q) ** 4 * (1 + 2 * q) * between[..., 1], 0.0)
    at = high[:, None, 0] - high[:, None, 1] / between[..., 1] * between[..., 0]
    return at, weight


def effective_length(X, reach, a):
    """Half of the notch, by the weight of the bonds that it cuts: on a lattice the last of these end
    somewhere near the end of the line."""
    at, weight = crossing(X, reach)
    at = np.abs(at)
    inner = X[:, 0].max() - 2 * reach
    return inner * weight[at < a].sum() / weight[at < inner].sum()


class Plate:
    """Lengths a and spacing over LENGTH. It is stretched by so many steps to some multiple of the stretch
    at the peak by finite elements."""

    def __init__(self, a, spacing, name, angle, steps=150, far=1.15, rock=ROCK):
        dx = spacing * LENGTH
        self.width, self.height = (np.round(size / spacing) * dx for size in SIZES[a])
        self.notch = round(a / spacing) * dx
        self.spacing = dx if name == "square" else dx * (4 / 3) ** 0.25    # the same volumes
        size = np.array([self.width, self.height + 3 * dx])
        self.cloud = turned_lattice(name, angle, self.spacing, lambda X: np.all(np.abs(X) < size, axis=1),
                                    0.0 if (name, angle) == ("square", 0) else 0.3,
                                    2 * int(1.3 * np.hypot(*size) / self.spacing))
        self.width *= self.cloud.volume.sum() / (4 * size.prod())
        self.a = effective_length(self.cloud.X, HORIZON * self.spacing, self.notch)
        U, stress, opening = centre_cracked(
            self.a, self.width, self.height + GRIP * dx, material(YOUNG, POISSON), TENSILE, ENERGY,
            h=min(0.05 * LENGTH, 0.05 * self.a))
        self.peak, self.stretch = stress.max(), U[stress.argmax()]
        self.stiffness = stress[0] / U[0]
        self.steps, self.step, self.rock = steps, far * self.stretch / steps, rock
        run = self.hold(self.scene()).add(
            f"variable k loop {steps}\nlabel next\n"
            f"displace_atoms all ramp y {-self.step} {self.step} y {-self.height} {self.height} units box\n"
            "tmsph/quasistatic 1\nnext k\njump SELF next").run()
        moved = self.step * np.arange(1, steps + 1)
        self.energy, self.gained = (run.tables[-1][f"f_break[{k}]"][-1] for k in (6, 8))
        self.take(moved, *(np.array([table[column][-1] for table in run.tables])
                           for column in COLUMNS))

    def scene(self, pair=""):
        """With grips that do not move by themselves."""
        h = self.height
        scene = Scene(self.cloud, [material(YOUNG, POISSON, DENSITY)], f"plane stress {pair}")
        scene.add(f"tmsph/cut all line {-self.notch} 1e-7 {self.notch} 1e-7\n"
                  f"region low block INF INF INF {-h} INF INF\nregion high block INF INF {h} INF INF INF\n"
                  "group low region low\ngroup high region high\n"
                  f"fix break all tmsph/rankine {self.rock}")
        return scene

    def hold(self, scene):
        """After all else that acts on the grips."""
        scene.add("fix low low setforce 0 0 0\nfix high high setforce 0 0 0")
        return scene.thermo(f"step {' '.join(COLUMNS)} f_break[6] f_break[8]", 20)

    def take(self, moved, low, high, opening, broken):
        """Load and stiffness from the forces on the grips."""
        self.load = 0.25 * (low - high) / self.width
        begun = np.argmax(opening + broken > 0)
        part = slice(begun // 3, begun)
        self.measured = np.polyfit(moved[part], self.load[part], 1)[0]

    def pull(self, slowness=80):
        """Peak of the load if a wave crosses the height so many times until then."""
        time, h = slowness * 2 * self.height / SPEED, self.height
        step, speed = 0.7 * self.spacing / SPEED, self.stretch / time
        # drag on what moves otherwise than all of the plate evenly, a tenth of the critical one
        drag = 0.2 * np.pi * SPEED / (4 * h) * DENSITY * self.cloud.volume[0]
        scene = self.scene("viscosity 0.1 0")
        scene.set("vy", speed / h * np.clip(self.cloud.X[:, 1], -h, h))
        scene.add(f"fix move all nve\nfix drag all viscous {drag}\n"
                  f"variable even atom {drag * speed / h}*y\nfix even all addforce 0 v_even 0\n"
                  f"timestep {step:.17g}")
        run = self.hold(scene).add(f"run {int(1.25 * time / step)}").run()
        self.take(speed * step * run.thermo("Step"),
                  *(run.thermo(column) for column in COLUMNS))
        return self.load.max()


def compare(report, a, spacing, lattices=LATTICES):
    ratios = []
    for name, angle in lattices:
        plate = Plate(a, spacing, name, angle)
        what = f"a {a}, spacing {spacing}, {name} {angle}"
        report.within(f"{what}: stiffness/finite elements", plate.measured / plate.stiffness, 0.99, 1.01)
        ratios.append(plate.load.max() / plate.peak)
        report.within(f"{what}: peak/finite elements", ratios[-1], 0.96, 1.04)
        report.within(f"{what}: last load/peak", plate.load[-1] / plate.load.max(), -0.2, 0.2)
        report.below(f"{what}: gained by updates/dissipated", plate.gained / plate.energy, 1e-4)
    report.below(f"a {a}, spacing {spacing}: peaks between lattices", np.ptp(ratios), BETWEEN)


def infinite(report):
    """Plates 20 times as large as their crack. K at the peak is that of cohesive zones, K_Ic
    sqrt(a/(a + 0.42 l)) to a percent, and of second order in the size of elements."""
    def toughness(a, h):
        size = 20 * a * LENGTH
        _, stress, _ = centre_cracked(a * LENGTH, size, size, material(YOUNG, POISSON), TENSILE, ENERGY,
                                      h=h * LENGTH, clamped=False)
        return stress.max() * np.sqrt(np.pi * a * LENGTH / (YOUNG * ENERGY))

    for a, known in ((1, 0.840), (2.2, 0.915), (5, 0.959)):    # by another program
        coarse, fine = toughness(a, 0.1), toughness(a, 0.05)
        report.within(f"a/l {a}: K at the peak/K_Ic, of {known}", fine / known, 0.99, 1.01)
        report.within(f"a/l {a}: of sqrt(a/(a + 0.42 l))", fine / np.sqrt(a / (a + 0.42)), 0.99, 1.01)
        report.below(f"a/l {a}: change by elements of half the size", abs(fine - coarse), 0.003)


def plates(report):
    compare(report, 2, 0.2, (LATTICES[0], LATTICES[3]))


if __name__ == "__main__":
    main(infinite, plates)
