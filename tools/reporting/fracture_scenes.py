# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Cracks whose bonds open: the scenes of unittest/verification as tables of the report. What a run
gives, and the bars that it is held to, are those of the verification."""

import inspect
from dataclasses import dataclass
from pathlib import Path
from typing import Callable

import cohesive_zone
import test_bend
import test_cct
import test_kalthoff
import test_openings
import test_openings_long
from scenes import relaxed

LENGTH = test_openings.LENGTH


@dataclass
class Table:
    """Runs by their parameters. measure takes what stands in for the report of a verification and the
    parameters of a run, and returns rows of a curve: its name, x, y. sources: what results depend on.
    spread: a quantity whose largest difference between runs with the same values of some parameters
    has a bar."""

    name: str
    title: str
    text: str
    runs: list
    measure: Callable
    sources: tuple
    spread: tuple = ()    # name in the verification, quantity, parameters, bar

    def depends(self):
        """Text of the sources."""
        paths = [Path(one if isinstance(one, Path) else inspect.getsourcefile(one))
                 for one in self.sources]
        return "".join(path.read_text() for path in paths)


# ---- Strips ----

LATTICES = [("square", angle) for angle in (0, 15, 30, 45)] + [("hex", angle) for angle in (0, 15, 30)]


def strip_runs():
    plain = test_openings.SPACING

    def run(body, plane, spacing=plain):
        return {"body": body, "plane": plane, "spacing": spacing}
    runs = [run(f"{name} {angle}", "strain") for name, angle in LATTICES]
    runs += [run(f"{name} {angle}", "stress") for name, angle in (("square", 0), ("hex", 15))]
    runs += [run(f"relaxed {seed}", plane) for seed in (1, 2) for plane in ("strain", "stress")]
    runs += [run(name, "") for name in test_openings_long.SOLIDS]
    runs += [run(body, "strain", spacing) for spacing in (3e-3, 2e-3, 1e-3, 0.5e-3) for body in ("square 0", "hex 15")]
    return runs + [run("square 0", "strain", 0.275e-3)]    # half an hour


def pull_strip(report, body, plane, spacing):
    if body in test_openings_long.SOLIDS:
        test_openings_long.solid(report, (body,))
        return
    name, number = body.split()
    cloud = (test_openings_long.relaxed_strip(int(number)) if name == "relaxed" else
             test_openings.strip_lattice(name, int(number), spacing))
    test_openings.energy(report, body, test_openings.Strip(cloud, words=f"plane {plane}"))


def strips():
    return Table(
        "fracture_energy", "Energy of a crack in a strip",
        "A notched strip of 60 by 30 mm is pulled apart between grips until the crack is through: E 20 GPa, nu 0.2, "
        f"tensile strength 14.77 MPa, G 60 J/m2, characteristic length l = E G/strength^2 = {1e3 * LENGTH:.1f} mm. "
        "Energy that the openings took, over G times the area of the crack. Beyond 0.3 l the start of "
        "a run warns, and the bar does not count. "
        "3-D strips are 7 spacings thick and periodic.",
        strip_runs(), pull_strip, (test_openings, test_openings_long, relaxed))


# ---- Bars, plates, beams, plates that are hit ----

def bars():
    known = {f"{name}{', plane ' + plane if plane else ''}": (name, cells, plane)
             for name, cells, plane in test_openings.BARS}
    return Table(
        "fracture_bars", "Bars without a notch",
        "A bar is drawn apart evenly until its middle, which is weaker than its ends, tears. Largest load over "
        "strength times section.",
        [{"bar": name} for name in known],
        lambda report, bar: test_openings.bars(report, (known[bar],)), (test_openings,))


def plates():
    sizes = [(2, 0.2), (2, 0.3), (1, 0.2), (1, 0.3), (5, 0.3), (10, 0.3), (5, 0.2), (1, 0.1), (2, 0.1), (5, 0.1),
             (10, 0.2)]    # long ones in the end
    return Table(
        "fracture_plates", "Centre-cracked plates",
        "Plane stress, pulled between grips in equilibrium; a is half the length of the crack. Stiffness and peak "
        "of the load over those of finite elements with a cohesive zone (`unittest/verification/cohesive_zone.py`), "
        "which `test_cct.py infinite` holds to the limits of an infinite plate.",
        [{"a/l": a, "spacing/l": spacing, "lattice": f"{name} {angle}"} for a, spacing in sizes
         for name, angle in test_cct.LATTICES],
        pull_plate, (test_cct, test_openings, cohesive_zone),
        ("peaks between lattices", "peak/finite elements", ("a/l", "spacing/l"), test_cct.BETWEEN))


def pull_plate(report, **parameters):
    name, angle = parameters["lattice"].split()
    test_cct.compare(report, parameters["a/l"], parameters["spacing/l"], ((name, int(angle)),))


AT_ONCE, FAR = f"tensile * {test_openings.TENSILE}", 2.2    # some of its plates bear more


def pull_brittle(report, **parameters):
    name, angle = parameters["lattice"].split()
    plate = test_cct.Plate(parameters["a/l"], parameters["spacing/l"], name, int(angle), far=FAR, rock=AT_ONCE)
    report.note("peak/finite elements", plate.load.max() / plate.peak)
    report.note("stretch at the peak/largest stretch", (plate.load.argmax() + 1) / plate.steps)


def brittle():
    return Table(
        "fracture_at_once", "Breaking at once",
        "Centre-cracked plates as above, of the same strength, whose bonds break at once: no `energy`. What such a "
        "crack takes is in proportion to the spacing, so that the peak grows with it, and is that of the finite "
        "elements at one spacing only.",
        [{"a/l": a, "spacing/l": spacing, "lattice": f"{name} {angle}"}
         for a, spacing in ((2, 0.3), (2, 0.2), (2, 0.1), (5, 0.3), (5, 0.2))
         for name, angle in (test_cct.LATTICES[0], test_cct.LATTICES[3])],
        pull_brittle, (test_cct, test_openings, cohesive_zone))


def bend(report, **parameters):
    spacing = parameters["spacing/l"]
    name, angle = parameters["lattice"].split()
    beam = test_bend.Beam(spacing, name, int(angle))
    test_bend.judge(report, f"{spacing}", beam)
    few = max(1, len(beam.load) // 150)
    opening, load = beam.exact
    return ([("tmsph", 1e3 * x, y) for x, y in zip(beam.opening[::few], beam.load[::few])]
            + [("finite elements", 1e3 * x, y) for x, y in zip(opening[::2], load[::2])])


def beams():
    cases = [(spacing, "square 0") for spacing in (0.3, 0.2, 0.1)]
    cases += [(spacing, lattice) for spacing in (0.2, 0.1) for lattice in ("square 30", "hex 0", "hex 15")]
    return Table(
        "fracture_bend", "Three-point bend of a notched beam",
        "`examples/notch`: E 60 GPa, nu 0.25, strength 10 MPa, G 37.5 J/m2, l = 22.5 mm, plane stress, beam 108 mm "
        "deep, notch to its middle. Load against the opening of the notch beside finite elements with a cohesive "
        "zone; branch: loads at the same openings behind the peak, down to 0.3 of it, over those of the finite "
        "elements.",
        [{"spacing/l": spacing, "lattice": lattice} for spacing, lattice in cases],
        bend, (test_bend, test_cct, cohesive_zone, test_bend.EXAMPLE / "in.notch"))


def hit(report, lattice, strength, dx):
    name, angle = lattice.split()
    plate = test_kalthoff.Plate(name, int(angle), strength=strength, dx=dx)
    plate.judge(report, lattice)
    if dict(strength=strength, dx=dx) == test_kalthoff.STRONG:
        plate.judge_start(report, lattice)


def kalthoff():
    settings = [dict(strength=1.0e9, dx=1e-3), test_kalthoff.STRONG, dict(strength=1.0e9, dx=0.5e-3)]
    return Table(
        "fracture_kalthoff", "The test of Kalthoff and Winkler",
        "`examples/kalthoff`: steel, 190 GPa, G 22.13 kJ/m2, plane strain, hit at 16.5 m/s (half of the "
        "projectile's 33); line from the tip of the notch to that of the crack after 44 microseconds. In the "
        "experiment 65 to 75 degrees, starting at 24 to 25 microseconds (Kalthoff, Int. J. Fract. 101 (2000)). l is "
        "4.2 mm at 1.0 GPa and 1.16 mm at 1.9 GPa.",
        [{"lattice": f"{name} {angle}", **setting} for setting in settings for name, angle in test_kalthoff.LATTICES],
        hit, (test_kalthoff, test_kalthoff.EXAMPLE),
        ("largest difference of the angles", "angle of the crack", ("strength", "dx"), test_kalthoff.BETWEEN))


def torn():
    return Table(
        "fracture_torn", "Bodies torn apart by their rotation",
        "A block spins so fast that it flies apart; without viscosity. What openings took is booked, and nothing "
        "else is to change.",
        [{"dimension": d} for d in (2, 3)],
        lambda report, dimension: test_openings.torn_by_rotation(report, (dimension,)), (test_openings,))


def tables():
    return [strips(), plates(), bars(), beams(), kalthoff(), brittle(), torn()]
