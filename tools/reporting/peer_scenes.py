# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Elastic scenes that other methods of LAMMPS can do too, from the inputs in tools/peers."""

from pathlib import Path

import numpy as np

from scenes import beam
from tmsph_testing import Script, sampled_frequency

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
    return beam.timoshenko(PLANE_YOUNG, PLANE_POISSON)[0] * beam.HEIGHT * beam.RHO**0.5


def radial(dim):
    """k R of the first radial mode of a disc or ball whose rim is free."""
    if dim == 2:
        return root(lambda x: x * bessel(0, x) - 2 / 3 * bessel(1, x), 1.0, 3.0)
    return root(lambda x: x / np.tan(x) - 1 + 0.75 * x**2, 1.5, 3.0)


class Lammps:
    """One run of an input of tools/peers."""

    inputs = INPUTS

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
