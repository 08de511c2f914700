# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The elastic scenes that other methods of LAMMPS can do too, from the inputs in tools/peers."""

from pathlib import Path

import numpy as np

from scenes.beam import timoshenko
from tmsph_testing import Script, sampled_frequency

from .accuracy import of, seconds, section, table, time_to
from .studies import Study

INPUTS = Path(__file__).resolve().parents[1] / "peers"
YOUNG, POISSON = 1.0, 0.25
PLANE_YOUNG, PLANE_POISSON = YOUNG / (1 - POISSON**2), POISSON / (1 - POISSON)
WAVE = 1.2**0.5     # speed of P waves
SLENDER = 10        # length of bar and beam over their height

# The largest stable time step of each method in its scenes, in spacings/WAVE: found by trying, for
# central forces from the dispersion of the lattices. Each runs with 0.8 of its own.
LIMIT = {2: {"tmsph": 1.5, "tlsph": 1.05, "pmb": 1.9, "bpm": 2.2},
         3: {"tmsph": 1.4, "tlsph": 1.0, "pmb": 1.9, "lps": 1.5, "bpm": 2.05}}
NAMES = {"tmsph": "tmsph", "tlsph": "smd/tlsph", "pmb": "peri/pmb", "lps": "peri/lps",
         "bpm": "bpm/spring"}


def root(function, low, high):
    """By bisection."""
    for _ in range(100):
        middle = 0.5 * (low + high)
        if (function(low) > 0) == (function(middle) > 0):
            low = middle
        else:
            high = middle
    return low


def bessel(order, x):
    """J0 or J1 by Bessel's integral; the trapezoidal rule is exact here."""
    angle = 2 * np.pi * np.arange(64) / 64
    return np.mean(np.cos(order * angle - x * np.sin(angle)))


def longitudinal(dim):
    """Love's correction for the lateral inertia of a bar."""
    k = np.pi / SLENDER
    if dim == 2:
        return k * PLANE_YOUNG**0.5 / (1 + PLANE_POISSON**2 * k**2 / 12) ** 0.5
    return k * YOUNG**0.5 / (1 + POISSON**2 * k**2 / 6) ** 0.5


def bending():
    """Timoshenko's theory; that of the scene has another size and density."""
    from scenes import beam
    length = beam.HEIGHT
    omega = timoshenko(PLANE_YOUNG, PLANE_POISSON)[0]
    return omega * length * beam.RHO**0.5


def radial(dim):
    """k R of the first radial mode of a disc or ball whose rim is free."""
    if dim == 2:
        return root(lambda x: x * bessel(0, x) - 2 / 3 * bessel(1, x), 1.0, 3.0)
    return root(lambda x: x / np.tan(x) - 1 + 0.75 * x**2, 1.5, 3.0)


class Lammps:
    """One run of an input of tools/peers."""

    def __init__(self, name, method, dim, n, **variables):
        variables.update(folder=INPUTS, method=method, dim=dim, n=n,
                         courant=0.8 * LIMIT[dim][method])
        head = "".join(f"variable {key} index {value}\n" for key, value in variables.items())
        run = Script(head + f"include {INPUTS}/in.{name}").run()
        self.cost, self.table = run.cost, run.tables[-1]


class Vibration(Lammps):
    """error of the frequency"""

    def __init__(self, scene, method, dim, n):
        self.exact = {"bar": lambda: longitudinal(dim), "beam": bending,
                      "disc": lambda: radial(2) * WAVE, "ball": lambda: radial(3) * WAVE}[scene]()
        more = {"k": radial(dim)} if scene in ("disc", "ball") else {}
        super().__init__("vibration", method, dim, n, scene=scene, period=2 * np.pi / self.exact,
                         **more)
        times = self.table["Time"]
        measured = sampled_frequency(self.table["c_q"], times[1] - times[0])
        # radius of equal area or volume
        N = self.cost.particles
        size = {"disc": (N * 3**0.5 / 2 / np.pi) ** 0.5 / n,
                "ball": (3 * N / 4 / np.pi) ** (1 / 3) / n}.get(scene, 1.0)
        self.error = measured * size / self.exact - 1


class Tension(Lammps):
    """error of the elongation"""

    def __init__(self, method, dim, n):
        super().__init__("tension", method, dim, n)
        self.error = self.table["v_error"][-1]


def peer_studies():
    def methods(dim):
        return {NAMES[method]: {"method": method} for method in LIMIT[dim]}

    def sizes(*values):
        return [(1 / n, {"n": n}) for n in values]
    text = {
        "bar2d": "A free bar, ten times as long as high, in plane strain, vibrates in its first "
                 "longitudinal mode. Error of the frequency against that of a slender bar with Love's "
                 "correction.",
        "bar3d": "The same in 3-D, with a square section.",
        "beam": "The same bar in its first bending mode, in plane strain, against Timoshenko's theory.",
        "disc": "A free disc in plane strain in its first radial mode, hexagonal lattice.",
        "ball": "A free ball in its first radial mode, cubic lattice.",
        "tension2d": "A bar four times as long as high, in plane strain, is pulled at both ends and "
                     "comes to rest under drag. Error of the strain between the quarters of its length.",
        "tension3d": "The same in 3-D, with a square section."}

    def study(name, title, scene, common, few, more):
        return Study(f"peers_{name}", title, text[name], scene, lambda run: abs(run.error),
                     "error of the strain" if scene is Tension else "error of the frequency",
                     common, sizes(*few), "n", methods(common["dim"]), sizes(*more),
                     dimension=common["dim"])
    return [
        study("bar2d", "Longitudinal vibration of a bar, 2-D", Vibration,
              {"scene": "bar", "dim": 2}, (4, 6, 8, 12), (16, 24, 32)),
        study("bar3d", "Longitudinal vibration of a bar, 3-D", Vibration,
              {"scene": "bar", "dim": 3}, (4, 6, 8), (12, 16)),
        study("beam", "Bending vibration of a beam, 2-D", Vibration,
              {"scene": "beam", "dim": 2}, (4, 6, 8), (12, 16, 24)),
        study("disc", "Radial vibration of a disc, 2-D", Vibration,
              {"scene": "disc", "dim": 2}, (8, 16, 32), (64, 128)),
        study("ball", "Radial vibration of a ball, 3-D", Vibration,
              {"scene": "ball", "dim": 3}, (5, 8, 12), (18, 27)),
        study("tension2d", "Bar in tension, 2-D", Tension, {"dim": 2}, (4, 6, 8, 12), (16, 24)),
        study("tension3d", "Bar in tension, 3-D", Tension, {"dim": 3}, (4, 6), (8, 12, 16))]


INTRODUCTION = """\
Elastic scenes with exact solutions that other methods of the same LAMMPS can do as well, with
the same particles and the same horizon of 3.015 spacings; inputs in `tools/peers`. Poisson's
ratio is 1/4, the only one of bonds with central forces, whose stiffness is set so that the
inside of a body has the right moduli. tmsph runs with its defaults, smd/tlsph with its usual
hourglass control of 10 and without viscosity, peri and bpm without breaking. Each method takes
0.8 of the largest time step that is stable in its scenes{limits}: found by trying, for peri/pmb
and bpm from the dispersion of their lattices. peri/lps is a 3-D model: it has no plane strain."""


def limits():
    return " (in units of spacing/speed of P waves: " + "; ".join(
        f"{dim}-D " + ", ".join(f"{NAMES[method]} {limit:g}" for method, limit in row.items())
        for dim, row in LIMIT.items()) + ")"


def advantage(rows, label):
    """How many times longer than tmsph a peer takes to the smallest error that both reach."""
    mine, other = of(rows, NAMES["tmsph"]), of(rows, label)
    if not other:
        return ""
    target = max(min(row["error"] for row in other), min(row["error"] for row in mine))
    theirs, ours = time_to(other, target), time_to(mine, target)
    bound = "more than " if ours == mine[0]["seconds"] else ""
    return f"{bound}{theirs / ours:.1f} at {100 * target:.2g} %"


def page(measured):
    """measured: pairs of a study and its rows."""
    labels = [NAMES[method] for method in LIMIT[3] if method != "tmsph"]
    faster, reached = [], []
    for study, rows in measured:
        there = {row["choice"] for row in rows}
        faster.append([study.title] + [advantage(rows, label) if label in there else "cannot"
                                       for label in labels])
        reached.append([study.title] + [seconds(time_to(of(rows, label), study.target))
                                        if label in there else "cannot"
                                        for label in [NAMES["tmsph"]] + labels])
    machines = "; ".join(dict.fromkeys(row["machine"] for _, rows in measured for row in rows))
    parts = ["# Error against run time: other methods", INTRODUCTION.format(limits=limits()),
             f"Machine: {machines}.", "## tmsph is faster by", "At the smallest error that both reach.",
             table(["scene"] + labels, faster), "## Time to an error of 1 %",
             "\"Not reached\": at the sizes that were run.",
             table(["scene", "tmsph"] + labels, reached)]
    return "\n\n".join(parts + [section(study, rows) for study, rows in measured]) + "\n"
