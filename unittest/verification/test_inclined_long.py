# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plates with an inclined crack whose bonds open, pulled apart between grips in equilibrium. The crack goes on as
one by the maximum tangential stress in the same plate does, and the load at its peak, over that of the plate with
a straight crack, is that of a cohesive zone on this way: both by displacement_discontinuity.py, which
test_inclined.py holds to known solutions.

Kinks are judged by chords: the direction from the end of the notch to where the crack crosses a circle of 0.3 and of
0.5 half lengths about it, in the plate and on the way that it is compared with. The way turns back from the kink
at once, so that these differ from the kink of the criterion by up to 12 degrees. Shorter chords are told without
a bar: the end of a cut lies anywhere between two rows of particles, and half a spacing is 4 degrees at 0.2.

By name only: rows, where chords do not reach the bar of 5 degrees as cracks run along rows of a square lattice that
the way should cross under some 7 degrees. With rows normal to the load, at an inclination of 30: 8 degrees off; at 45
the cut goes through particles, which are on one of its sides: 10 degrees off at one end. On the lattice turned by 30
degrees, at 45: 7 degrees off, along the diagonals."""

import numpy as np

from displacement_discontinuity import Elements, Plate, cohesive, notch, path
from test_cct import GRIP, effective_length
from test_openings import DENSITY, ENERGY, LENGTH, POISSON, TENSILE, YOUNG, turned_lattice
from tmsph_testing import HORIZON, Scene, main, material

NOTCH, SPACING = 10, 0.3         # half length, distance of particles, over LENGTH
WIDTH, HEIGHT = 2.5, 1.5         # halves, over that of the notch
CHORDS = (0.1, 0.2, 0.3, 0.5)    # over it too; those from JUDGED on are held to the bar
JUDGED = 0.3
STRETCHES = np.concatenate([[0.3, 0.6, 0.75, 0.85], np.arange(0.9, 1.1, 0.005)])    # over that at the peak


class Inclined:
    """inclination: degrees between the crack and the normal to the load."""

    def __init__(self, name, angle, inclination):
        dx = SPACING * LENGTH
        self.direction = np.exp(1j * np.radians(inclination))
        self.spacing = dx if name == "square" else dx * (4 / 3) ** 0.25    # the same volumes
        self.notch = round(NOTCH / SPACING) * dx
        width, self.height = (np.round(part * NOTCH / SPACING) * dx for part in (WIDTH, HEIGHT))
        size = np.array([width, self.height + 3 * dx])
        # both ends of the crack are the same after half a turn
        self.cloud = turned_lattice(name, angle, self.spacing, lambda X: np.all(np.abs(X) < size, axis=1), 0.0,
                                    2 * int(1.3 * np.hypot(*size) / self.spacing))
        self.width = width * self.cloud.volume.sum() / (4 * size.prod())
        self.z = self.cloud.X @ [1, 1j]
        turned = self.z / self.direction
        near = abs(turned) < HEIGHT * self.notch    # where the plate is on both sides of it
        self.a = effective_length(np.column_stack([turned.real, turned.imag])[near], HORIZON * self.spacing, self.notch)
        self.tip = self.a * self.direction
        self.expect()
        self.pull()

    def expect(self):
        h = 0.01 * self.a
        body = Plate(YOUNG, POISSON, self.width, self.height + GRIP * SPACING * LENGTH, 0.05 * self.a)
        self.way = path(body, self.tip, h, 0.6 * self.a)
        free = len(notch(self.tip, h)) - 1
        zone = self.way[:free + 1 + int(2 * LENGTH / h)]
        moved, stress = cohesive(body, Elements(zone), free, TENSILE, ENERGY)
        self.peak, self.stretch, self.stiffness = stress.max(), moved[stress.argmax()], stress[0] / moved[0]

    def pull(self):
        """Until the crack is as long as the notch at least: its area counts what has opened in part."""
        h, end = self.height, self.notch * self.direction
        scene = Scene(self.cloud, [material(YOUNG, POISSON, DENSITY)], "plane stress")
        # between rows of particles if it is straight
        scene.add(f"tmsph/cut all line {-end.real} {1e-7 - end.imag} {end.real} {1e-7 + end.imag}\n"
                  f"region low block INF INF INF {-h} INF INF\nregion high block INF INF {h} INF INF INF\n"
                  "group low region low\ngroup high region high\n"
                  f"fix break all tmsph/rankine tensile * {TENSILE} energy * {ENERGY}\n"
                  "fix low low setforce 0 0 0\nfix high high setforce 0 0 0\n"
                  "compute damage all tmsph/property/atom damage")
        scene.thermo("step f_low[2] f_high[2] f_break[10]", 20)
        for step in self.stretch * np.diff(STRETCHES, prepend=0.0):
            scene.add(f"displace_atoms all ramp y {-step} {step} y {-h} {h} units box\ntmsph/quasistatic 1\n"
                      f"if \"$(f_break[10]) > {1.7 * self.notch}\" then \"jump SELF end\"")
        run = scene.add("label end").snapshot("end", "c_damage").run()
        load = np.array([0.25 * (table["f_low[2]"][-1] - table["f_high[2]"][-1]) / self.width for table in run.tables])
        self.measured = load[0] / (STRETCHES[0] * self.stretch)
        self.load, self.fallen = load.max(), load[-1] / load.max()
        self.damage = run.frame("end")["c_damage"]

    def chords(self, part):
        """Degrees from the direction of the notch, of the way that is expected and of the crack at both ends. There
        it is where damage is, which lies as much on the one side of a crack as on the other."""
        way = self.way[np.argmin(abs(self.way - self.tip)) + 1:] / self.direction - self.a
        expected, found = np.interp(part * self.a, abs(way), np.degrees(np.angle(way))), []
        for side in (1, -1):
            from_tip = side * self.z / self.direction - self.a
            near = 1 - abs(abs(from_tip) - part * self.a) / (1.5 * self.spacing)
            weight = np.where((from_tip.real > 0) & (near > 0) & (self.damage > 0.05), near * self.damage, 0.0)
            found.append(np.degrees(np.angle(from_tip) @ weight / weight.sum()))
        return expected, found


def compare(report, name, angle, inclinations):
    straight = Inclined(name, angle, 0)
    report.note(f"{name} {angle}, straight: peak/cohesive zone", f"{straight.load / straight.peak:.4g}")
    for inclination in inclinations:
        plate = Inclined(name, angle, inclination)
        what = f"{name} {angle}, inclined by {inclination}"
        report.within(f"{what}: stiffness/expected", plate.measured / plate.stiffness, 0.99, 1.01)
        report.note(f"{what}: peak/cohesive zone", f"{plate.load / plate.peak:.4g}")
        report.within(f"{what}: peak/that of the straight crack/expected",
                      plate.load / straight.load * straight.peak / plate.peak, 0.95, 1.05)
        report.below(f"{what}: last load/peak", plate.fallen, 0.95)
        for part in CHORDS:
            expected, found = plate.chords(part)
            for end, chord in zip(("right", "left"), found):
                text = f"{what}: {end} chord of {part}, expected {expected:.1f}, off by, degrees"
                if part < JUDGED:
                    report.note(text, f"{chord - expected:.1f}")
                else:
                    report.within(text, chord - expected, -5, 5)


def hexagonal(report):
    compare(report, "hex", 15, (15, 30, 45, 60))


def turned(report):
    compare(report, "square", 30, (30,))


def rows(report):
    compare(report, "square", 0, (15, 30, 45, 60))
    compare(report, "square", 30, (45,))


if __name__ == "__main__":
    main(hexagonal, turned, more=[rows])
