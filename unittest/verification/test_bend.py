# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Three-point bend of a notched beam whose bonds open, examples/notch: load against the opening of the notch beside
finite elements with a cohesive zone (cohesive_zone.py), which are held to known stress intensities and openings
first. There is no snap-back. The notch of the finite elements is as long as that of the bonds that are cut. The bars
are a peak within 4 % and a softening branch within 8 % of the finite elements, down to 0.3 of the peak. Of the spacings
of 0.3, 0.2 and 0.1 of the characteristic length the last has the peak, none the branch: on the square lattice the peak
is 20, 12 and 4 % high, the branch 22 to 56, 11 to 26 and 3 to 11 %. These run by name only: test_bend.py spacings, or
lattices, rate. By default the elastic stiffness is held to the bar of the peak at 0.2, and what updates gain to
theirs."""

import re
from pathlib import Path

import numpy as np

from cohesive_zone import bent
from test_cct import crossing
from tmsph_testing import HORIZON, Script, main, material

EXAMPLE = Path(__file__).resolve().parents[2] / "examples/notch"
ROCK, TENSILE, ENERGY = material(60e9, 0.25), 10e6, 37.5
LENGTH = ROCK["young"] * ENERGY / TENSILE**2    # characteristic
DEPTH, BEAM, NOTCH = 0.108, 0.378, 0.054
TABLE = EXAMPLE / "load.exact.txt"
BRANCH = np.arange(0.9, 0.25, -0.1)    # loads over the peak of the finite elements at which branches are compared


def effective_notch(X, dx):
    """By the weight of the bonds that it cuts, as in test_cct.py. The example cuts those that cross it at its end."""
    reach = HORIZON * dx
    at, weight = crossing(X[:, ::-1], reach)
    places = np.linspace(reach, DEPTH - reach, 1000)
    below = np.array([weight[at < place].sum() for place in places])
    slope, start = np.polyfit(places, below, 1)
    return (weight[at < NOTCH + 1e-4 * dx].sum() - start) / slope


def taken(x, y, ux, dx):
    """Energy per thickness of a crack in the middle that has opened as the sides have gone apart, beyond the reach of
    bonds across it, less their strain by the traction there; it took and holds what the linear law gives.
    @return nan where that strain is more than half of a full opening, which is then too small a difference"""
    near, far = HORIZON * dx, (HORIZON + 2) * dx
    heights = np.linspace(NOTCH, DEPTH - dx, 400)
    sides = []
    for side in (-1, 1):
        band = (side * x > near) & (side * x < far)
        order = np.argsort(y[band])
        sides.append(np.poly1d(np.polyfit(y[band][order], ux[band][order], 7))(heights))
    apart, reach = sides[1] - sides[0], near + far
    end, strain = 2 * ENERGY / TENSILE, TENSILE / ROCK["young"]
    if reach * strain > 0.5 * end:
        return np.nan
    opening = np.clip((apart - reach * strain) / (1 - reach * strain / end), 0, end) / end
    return ENERGY * np.trapz(1 - (1 - opening) * (1 - opening), heights)


def exact(span, press, gauge, depth=DEPTH, notch=NOTCH):
    """Displacement, opening of the notch at the height of the gauges, and load."""
    U, load, x, opening = bent(depth, notch, span, BEAM, press, ROCK, TENSILE, ENERGY)
    return U, np.array([np.interp(gauge, x, row) for row in opening]), load


class Beam:
    """examples/notch, and the same beam by finite elements."""

    def __init__(self, spacing, name="square", angle=0, speed=8e-3):
        dx = spacing * LENGTH
        values = dict(dx=f"{dx:.17g}", lattice="hexagonal" if name == "hex" else name, angle=angle, speed=speed, dump=0)
        script = Script("\n".join(f"variable {key} index {value}" for key, value in values.items())
                        + "\ninclude in.notch\nwrite_dump all custom places.txt x y c_field[3] c_field[4]",
                        {"in.notch": (EXAMPLE / "in.notch").read_text()})
        run = script.run(keep="*.txt")
        self.energy, self.held, self.gained, self.lost = (
            run.thermo(name)[-1] for name in ("energy_J", "held_J", "gained_J", "lost_J"))
        _, opening, self.load = np.loadtxt(run.kept["load.txt"].decode().splitlines(), skiprows=2).T[:3]
        self.opening = 1e-3 * opening
        places = re.search(r"Rollers (\S+) m apart, ends of the punch (\S+) m, gauges (\S+) m", run.log)
        particles = int(re.search(r"(\d+) atoms in group beam", run.log)[1])
        x, y, ux, uy = np.loadtxt(run.kept["places.txt"].decode().splitlines(), skiprows=9).T
        self.expected = taken(x, y, ux, dx)
        notch = effective_notch(np.array([x - ux, y - uy]).T, dx)
        _, *self.exact = exact(*(float(word) for word in places.groups()), particles * dx**2 / BEAM, notch)

    def peak(self):
        return self.load.max() / self.exact[1].max()

    def stiffness(self):
        """Load at the opening where that of the finite elements is a third of its peak, before the zone counts."""
        opening, load = self.exact
        third = np.interp(load.max() / 3, load[:load.argmax()], opening[:load.argmax()])
        up = self.load.argmax() + 1
        return np.interp(third, self.opening[:up], self.load[:up]) / (load.max() / 3)

    def branch(self):
        """Loads over those of the finite elements behind their peak, at the same openings to 3 %: bonds leave one by
        one, and the load falls in steps."""
        opening, load = self.exact
        peak = load.argmax()
        places = np.interp(-BRANCH * load[peak], -load[peak:], opening[peak:])
        return np.array([self.load[abs(self.opening - place) < 0.03 * place].mean() / (part * load[peak])
                         for part, place in zip(BRANCH, places)])


def reference(report):
    """The finite elements: opening of the mouth of an elastic beam, and stress intensity at the peak, which is the
    toughness for a large beam: 1/K^2 is linear in 1/size (Bazant, J. Eng. Mech. 110 (1984) 518). Formulas for spans of
    four depths: Tada, Paris, Irwin, The stress analysis of cracks handbook, to 1 %."""
    ratio, span = 0.5, 4.0    # over the depth

    def beam(depth, h, least):
        _, load, _, opening = bent(depth, ratio * depth, span * depth, 1.2 * span * depth, 0.0, ROCK, TENSILE, ENERGY,
                                   h=h, least=least)
        return 1.5 * load * span / depth, opening[:, 0]    # nominal stress

    def mouth(elements):
        stress, opening = beam(LENGTH, LENGTH / elements, 0.99)
        return opening[0] * ROCK["young"] / (4 * stress[0] * ratio * LENGTH)

    known = 0.76 - 2.28 * ratio + 3.87 * ratio**2 - 2.04 * ratio**3 + 0.66 / (1 - ratio) ** 2
    report.within("elastic opening/known, extrapolated", (2 * mouth(80) - mouth(40)) / known, 0.99, 1.01)

    shape = (1.99 - ratio * (1 - ratio) * (2.15 - 3.93 * ratio + 2.7 * ratio**2)) / (
        (1 + 2 * ratio) * (1 - ratio) ** 1.5)

    def weakness(size):
        stress, _ = beam(size * LENGTH, 0.1 * LENGTH, 0.99)
        return ROCK["young"] * ENERGY / (stress.max() * shape * np.sqrt(ratio * size * LENGTH)) ** 2

    report.within("K of a large beam/K_Ic, extrapolated", (2 * weakness(16) - weakness(8)) ** -0.5, 0.99, 1.01)


def snap_back(report):
    """None: displacement and opening grow all the way."""
    U, opening, _ = exact(0.324, 0.0, 0.0)
    report.above("least step of the displacement/its largest value", np.diff(U).min() / U.max(), 0.0)
    report.above("least step of the opening/its largest value", np.diff(opening).min() / opening.max(), 0.0)


def table():
    """For the default spacing of the example: opening, load, way of the punch."""
    dx = 0.2 * LENGTH
    U, opening, load = exact(0.324 - dx, dx, 0.5 * dx)
    rows = np.array([1e3 * opening, load, 1e3 * U]).T
    return np.vstack([np.zeros(3), rows])


def write(report):
    """The table of the example, anew."""
    head = "opening_mm load_N_per_m way_mm\n# finite elements with a cohesive zone, by test_bend.py write"
    np.savetxt(TABLE, table(), "%.5g", header=head, comments="")


def example(report):
    """Has the curve of the finite elements, to the digits that are written."""
    right = table()
    difference = np.abs(np.loadtxt(TABLE, skiprows=2) - right).max(axis=0) / right.max(axis=0)
    report.below("largest difference/largest value of a column", difference.max(), 1e-4)


def compare(report, *beam):
    judge(report, ", ".join(str(word) for word in beam), Beam(*beam))


def judge(report, what, found):
    report.within(f"{what}: peak/finite elements", found.peak(), 0.96, 1.04)
    branch = found.branch()
    report.within(f"{what}: lowest load behind it/finite elements", branch.min(), 0.92, 1.08)
    report.within(f"{what}: highest load behind it/finite elements", branch.max(), 0.92, 1.08)
    report.note(f"{what}: all", np.round(branch, 3))
    if np.isfinite(found.expected):
        report.within(f"{what}: energy of the crack/that of its opening",
                      (found.energy + found.held + found.lost) / found.expected, 0.95, 1.05)
    begins(report, what, found)


def begins(report, what, beam):
    """Elastic, and no update gains energy later on."""
    report.within(f"{what}: stiffness/finite elements", beam.stiffness(), 0.96, 1.04)
    report.below(f"{what}: gained by updates/dissipated", beam.gained / beam.energy, 1e-4)


def elastic(report):
    beam = Beam(0.2)
    begins(report, "0.2", beam)
    report.note("peak/finite elements", f"{beam.peak():.3f}")
    report.note("branch/finite elements", np.round(beam.branch(), 3))


def spacings(report):
    for spacing in (0.3, 0.2, 0.1):
        compare(report, spacing)


def lattices(report):
    for lattice in (("square", 30), ("hex", 0), ("hex", 15)):
        compare(report, 0.2, *lattice)


def rate(report):
    """Half as fast is slow enough."""
    fast, slow = (Beam(0.3, speed=speed).load.max() for speed in (8e-3, 4e-3))
    report.below("change of the peak by half of the rate", abs(slow / fast - 1), 0.005)


if __name__ == "__main__":
    main(reference, snap_back, example, elastic, more=(spacings, lattices, rate, write))
