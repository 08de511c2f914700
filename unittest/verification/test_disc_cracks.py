# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The heated disc of examples/disc at 1 mm, and the expansions exchanged, or the inclusion not
bonded. First break against the exact elastic field with the drawn strengths, lengths and number of
the radial cracks, the circumferential crack, and that nothing flies apart or passes through
another; the first break also quasi-static, and by each criterion, at 2 mm. Paths depend on the
draw: what is tested are temperatures and counts: main cracks by 160 to 180 degrees, through by 220
to 260. Three draws, and cracks of the quasi-static and the unbonded disc up to the rim:
test_disc_cracks_long.py.

A particle is in a crack when a quarter of its bonds is broken: a straight crack takes
two fifths of the bonds of the particles along it. Cracks are clusters of such particles
in the matrix, nearer than 1.8 spacings (the second neighbors). A main crack crosses the
circle 10 mm outside the interface."""

from functools import cache
from pathlib import Path

import numpy as np

from tmsph_testing import HORIZON, Script, disc_materials, disc_stress, main

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ("examples/disc/in.disc", "potentials/mu2022.tmsph")    # it includes the second
SPACING, MI = 1e-3, 7.8    # the example's Hoek-Brown constant
SEEDS = (4711, 1, 2)
STOPS = (120, 160, 230, 260)    # degrees at which the example ends a run
IN_CRACK, LINK = 0.25, 1.8 * SPACING


def clusters(X, link):
    """The index of a member of its cluster for each point."""
    label = np.arange(len(X))
    if not len(X):
        return label
    i, j = np.nonzero(np.linalg.norm(X[:, None] - X[None], axis=2) < link)
    while True:
        lower = label.copy()
        np.minimum.at(lower, i, label[j])
        if np.array_equal(lower, label):
            return label
        label = lower


def closest(X, reach):
    """The shortest distance between two points if it is below reach, else reach."""
    order = np.argsort(X[:, 0])
    X, least = X[order], reach
    for shift in range(1, len(X)):
        gap = X[shift:] - X[:-shift]
        near = gap[:, 0] < reach
        if not near.any():
            break
        least = min(least, np.linalg.norm(gap[near], axis=1).min())
    return least


def load(criterion, mean, radius, strength):
    """Factor of stresses with such Mohr circles, tension positive, over those at which they break;
    strength is the first value of the criterion: UCS, cohesion or tensile strength."""
    ratio = 0.5 * (MI + (MI**2 + 4) ** 0.5)    # of the strengths in compression and tension
    if criterion == "hoekbrown":    # a = 1/2, s = 1
        pull = MI * (mean + radius)
        return 0.5 * (pull + np.sqrt(pull**2 + 16 * radius**2)) / strength
    if criterion == "mohrcoulomb":
        return (radius - mean + ratio * (mean + radius)) / (2 * ratio**0.5 * strength)
    return (mean + radius) / strength


class Disc:
    """One run of the example, up to end, one of STOPS. friction: see there; None: bonded."""

    def __init__(self, seed, swapped=False, friction=None, quasistatic=False, end=STOPS[-1],
                 criterion="hoekbrown", spacing=SPACING):
        touching = f"variable friction index {friction}\n" if friction is not None else ""
        stops = " ".join(str(T) for T in STOPS if T <= end)
        scene = Script(f"variable seed index {seed}\nvariable mi index {MI}\n{touching}"
                       f"variable criterion index {criterion}\n"
                       f"variable swap index {'yes' if swapped else 'no'}\nvariable dump index 0\n"
                       # each restart file makes a quasi-static run begin its search anew
                       "variable restart index 0\n"
                       f"variable quasistatic index {'yes' if quasistatic else 'no'}\n"
                       f"variable until index {stops}\n"
                       f"variable dx index {spacing}\nshell cd examples/disc\ninclude in.disc\n"
                       "shell cd ../..", {name: (ROOT / name).read_text() for name in EXAMPLE})
        scene.add("compute q all tmsph/property/atom x0 y0 strength\n"
                  "compute b all tmsph/bond/local id1 id2\nrun 0")
        scene.snapshot("end", "type x y vx vy c_q[*]")
        scene.add("write_dump all local events.local f_break[*]\n"
                  "write_dump all local bonds.local c_b[*]")
        run = scene.run()
        self.log = run.log
        self.swapped, self.criterion, self.end = swapped, criterion, run.frame("end")
        self.X, self.strength = self.end("c_q[1] c_q[2]"), self.end["c_q[3]"]
        self.inside = self.end["type"] == 1
        self.bonds = np.stack(list(run.frame("bonds").values()), axis=1)[:, :2].astype(int) - 1
        events = run.frame("events")
        self.broken = events("f_break[1] f_break[2]").astype(int) - 1
        self.place, self.T = events("f_break[5] f_break[6]"), events["f_break[13]"]
        self.family = np.bincount(self.bonds.ravel(), minlength=len(self.X))
        tables = run.tables
        self.kinetic = max(table["kinetic_J"].max() for table in tables)
        self.elastic = max(table["elastic_J"].max() for table in tables)
        self.r = np.hypot(*self.X.T)
        cell = spacing**2 * 3**0.5 / 2
        self.a, self.R = np.sqrt(np.array([self.inside.sum(), len(self.X)]) * cell / np.pi)

    def exact_first_break(self):
        """The temperature at which the first bond fails in the exact field: the mean stress of
        its ends, each with that of its own material, and their mean strength."""
        stress = disc_stress(disc_materials(self.swapped), "strain", self.a, self.R, self.X,
                             self.inside)
        xx, yy, xy = 0.5 * (stress[self.bonds[:, 0]] + stress[self.bonds[:, 1]]).T
        radius = np.hypot(0.5 * (xx - yy), xy)
        return 1 / load(self.criterion, 0.5 * (xx + yy), radius,
                        self.strength[self.bonds].mean(axis=1)).max()

    def in_cracks(self, T):
        """Indices of the matrix particles in cracks, and their clusters."""
        lost = np.bincount(self.broken[self.T <= T].ravel(), minlength=len(self.X))
        members = np.nonzero((lost > IN_CRACK * self.family) & ~self.inside)[0]
        return members, clusters(self.X[members], LINK)

    def reach(self, T):
        """How far out a crack that starts at the interface has come."""
        members, label = self.in_cracks(T)
        tips = [0.0]
        for cluster in np.unique(label):
            r = self.r[members[label == cluster]]
            if r.min() < self.a + HORIZON * SPACING:
                tips.append(r.max())
        return max(tips)

    def temperature_at(self, radius):
        """When a crack comes so far out; to one degree."""
        low, high = 0.0, 261.0
        if self.reach(high) < radius:
            return np.inf
        while high - low > 1.0:
            middle = 0.5 * (low + high)
            low, high = (low, middle) if self.reach(middle) >= radius else (middle, high)
        return high

    def crack_length(self, T, side):
        """Of particles in cracks in the matrix, right (side 1) or left (-1) of the inclusion within
        45 degrees, times the spacing; a straight crack has two rows of them."""
        members, _ = self.in_cracks(T)
        x, y = self.X[members].T
        return 0.5 * SPACING * np.count_nonzero(side * x > np.abs(y))

    def main_cracks(self):
        members, _ = self.in_cracks(np.inf)
        ring = members[np.abs(self.r[members] - self.a - 0.010) < SPACING]
        return len(np.unique(clusters(self.X[ring], LINK)))


@cache
def drawn(seed, quasistatic):
    return Disc(seed, quasistatic=quasistatic)


def sound(report, what, disc):
    report.below(f"{what}: largest kinetic energy/largest potential energy",
                 disc.kinetic / disc.elastic, 1.0)
    finite = all(np.isfinite(column).all() for column in disc.end.values())
    report.true(f"{what}: all finite", finite, "at the end")
    report.above(f"{what}: shortest distance/spacing",
                 closest(disc.end("x y"), 2 * SPACING) / SPACING, 0.5)


def first_break(report, what, disc):
    exact = disc.exact_first_break()
    report.below(f"{what}: first break at {disc.T.min():.2f}, exact field {exact:.2f}, difference",
                 abs(disc.T.min() / exact - 1), 0.04)


def criteria(report):
    """Of equal uniaxial strengths: breaks are in the order in which the curves lie where one
    stress is tension, the other compression."""
    discs = {criterion: Disc(SEEDS[0], end=STOPS[0], criterion=criterion, spacing=2 * SPACING)
             for criterion in ("mohrcoulomb", "hoekbrown", "rankine")}
    for criterion, disc in discs.items():
        first_break(report, f"{criterion}, 2 mm", disc)
        report.above(f"{criterion}, 2 mm: broken bonds", len(disc.T), 0)
    first = [disc.T.min() for disc in discs.values()]
    report.true("mohrcoulomb breaks first, rankine last", first == sorted(first),
                "by their curves")


def alike(report, quasistatic, dynamic):
    report.below("first break of the quasi-static disc against the dynamic one, difference",
                 abs(quasistatic.T.min() - dynamic.T.min()), 4)


def radial(report, seed, quasistatic=False):
    disc = drawn(seed, quasistatic)
    what = f"seed {seed}{', quasi-static' if quasistatic else ''}"
    first_break(report, what, disc)
    report.below(f"{what}: crack 5 mm beyond the interface at",
                 disc.temperature_at(disc.a + 0.005), 180)
    report.below(f"{what}: crack through to the rim at",
                 disc.temperature_at(disc.R - 2 * SPACING), 260)
    report.within(f"{what}: main cracks", disc.main_cracks(), 2, 5)
    sound(report, what, disc)


def circumferential(report, seed):
    disc = Disc(seed, swapped=True)
    what = f"exchanged, seed {seed}"
    r, angle = np.hypot(*disc.place.T), np.degrees(np.arctan2(*disc.place.T[::-1])) % 360
    along = (np.abs(r - disc.a) < 1.5 * SPACING) & (disc.T <= 200)
    report.within(f"{what}: angular bins of 72 with broken bonds at the interface at 200 degrees",
                  len(np.unique(angle[along] // 5)), 40, 72)
    report.true(f"{what}: no crack to the rim", disc.temperature_at(disc.R - 2 * SPACING) == np.inf,
                f"first break at {disc.T.min():.2f}, exact field {disc.exact_first_break():.2f}")
    sound(report, what, disc)


def touching(report, seed, end=STOPS[-1]):
    """An interface that touches sheds the tension that a bonded one passes on."""
    bonded, disc = drawn(seed, False), Disc(seed, friction=0.3, end=end)
    what = f"friction 0.3, seed {seed}"
    report.below(f"{what}: broken bonds/those of the bonded disc at {end} degrees",
                 len(disc.T) / np.count_nonzero(bonded.T <= end), 1)
    if end == STOPS[-1]:
        report.below(f"{what}: crack through to the rim at",
                     disc.temperature_at(disc.R - 2 * SPACING), 260)
    sound(report, what, disc)


def bonded(report):
    radial(report, SEEDS[0])


def quasistatic(report):
    """Up to the first cracks."""
    disc = Disc(SEEDS[0], quasistatic=True, end=120)
    first_break(report, "quasi-static to 120 degrees", disc)
    alike(report, disc, drawn(SEEDS[0], False))
    sound(report, "quasi-static to 120 degrees", disc)


def exchanged(report):
    circumferential(report, SEEDS[0])


def unbonded(report):
    touching(report, SEEDS[0], end=160)


if __name__ == "__main__":
    main(bonded, quasistatic, exchanged, unbonded, criteria)
