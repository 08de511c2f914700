# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What the tests of heat conduction share: bodies that conduct, and exact solutions. All is in
units of a slab of unit thickness with k = rho = c = 1 unless a test says otherwise."""

import numpy as np

from tmsph_testing import LATTICES, Scene, lattice, material

SOLID = material(young=1.0, poisson=0.2, density=1.0)
UNIFORM = "conductivity * 1 specific/heat * 1"


class Heated(Scene):
    """A body that conducts; it is held still. conditions: what comes before the run, fixes with
    the boundaries among it."""

    def __init__(self, cloud, words=UNIFORM, conditions="", start=0.0, materials=None):
        super().__init__(cloud, materials or [SOLID] * cloud.type.max(), temperature=start)
        self.add(f"fix heat all tmsph/heat {words}\n{conditions}\n"
                 "compute T all tmsph/property/atom temperature")

    def steps(self, time, steps, columns="step f_heat", every=0):
        return self.thermo(columns, every).add(f"timestep {time / steps:.17g}\nrun {steps}")

    def run_to(self, time, steps, **words):
        """Temperatures then; the run itself stays in self.done."""
        self.done = self.steps(time, steps, **words).snapshot("end", "c_T").run()
        return self.done.frame("end")["c_T"]


def slab(n, name="square", jitter=0.0, width=None, draw=4711):
    """n cells across a slab of unit thickness, some along it, periodic there."""
    edges = LATTICES[name][0]
    width = width or {"square": 8, "hex": 6, "sc": 7}[name]
    cells = (n,) + (width,) * (len(edges) - 1)
    cloud = lattice(name, cells, 1.0 / (n * edges[0]), periodic="yz"[: len(edges) - 1])
    return cloud.jitter(jitter, draw) if jitter else cloud


SIDES = ("region left block INF 0.5 INF INF INF INF\ngroup left region left\n"
         "group right subtract all left\n")


def dirichlet(x, t):
    """0 at first, both ends at 1."""
    b = (2 * np.arange(200)[:, None] + 1) * np.pi
    return 1 - (4 / b * np.sin(b * x) * np.exp(-b**2 * t)).sum(axis=0)


def neumann(x, t):
    """0 at first, insulated at 1, flux 1 at 0."""
    n = np.arange(1, 200)[:, None]
    series = (-1.0) ** n / n**2 * np.exp(-(n * np.pi) ** 2 * t) * np.cos(n * np.pi * (1 - x))
    return t + (3 * (1 - x) ** 2 - 1) / 6 - 2 / np.pi**2 * series.sum(axis=0)


def bisect(f, low, high):
    """A zero of f, whose sign changes between low and high; for arrays too."""
    low, high = np.array(low, float), np.array(high, float)
    rises = f(high) > f(low)
    for _ in range(80):
        middle = 0.5 * (low + high)
        above = (f(middle) > 0) == rises
        low, high = np.where(above, low, middle), np.where(above, middle, high)
    return 0.5 * (low + high)


def robin(x, t, biot):
    """1 at first, insulated at 0, convection at 1 to 0."""
    m = np.arange(200)
    z = bisect(lambda z: z * np.sin(z) - biot * np.cos(z), m * np.pi, (m + 0.5) * np.pi)[:, None]
    C = 4 * np.sin(z) / (2 * z + np.sin(2 * z))
    return (C * np.exp(-z**2 * t) * np.cos(z * x)).sum(axis=0)


def bessel(order, x):
    """J_0 or J_1 by their integral, exact to round-off with the midpoint rule."""
    x = np.asarray(x, float)
    m = 64 + 2 * int(np.max(np.abs(x), initial=0.0))
    angle = (np.arange(m) + 0.5) * np.pi / m
    return np.mean(np.cos(order * angle - np.multiply.outer(x, np.sin(angle))), axis=-1)


def disc_solution(r, t, biot=None, terms=30):
    """Unit disc, 0 at first, whose rim is at 1, or takes heat from 1 by convection."""
    m = np.arange(terms)
    if biot is None:
        z = bisect(lambda z: bessel(0, z), (m + 0.5) * np.pi, (m + 1) * np.pi)
        C = 2 / (z * bessel(1, z))
    else:
        # z J_1 = Bi J_0: one root between successive zeros of J_1
        top = bisect(lambda z: bessel(1, z), (m + 1.0) * np.pi, (m + 1.5) * np.pi)
        z = bisect(lambda z: z * bessel(1, z) - biot * bessel(0, z), np.append(1e-6, top[:-1]), top)
        C = 2 / z * bessel(1, z) / (bessel(0, z) ** 2 + bessel(1, z) ** 2)
    grid = np.linspace(0.0, 1.1, 2001)    # smooth enough for cubic accuracy far below the tests'
    series = (C * np.exp(-z**2 * t) * bessel(0, np.multiply.outer(grid, z))).sum(axis=1)
    return np.interp(r, grid, 1 - series)


def rms(error, volume=None):
    return np.sqrt(np.average(np.square(error), weights=volume))


def listed(values):
    return ", ".join(f"{v:.3e}" for v in values)


def weight(R, horizon, dimension):
    """w(R) = -W'(R)/R of the Wendland kernel up to a constant factor, which the norm cancels."""
    q = 2 * R / horizon
    return np.where(R < horizon, (1 - q / 2) ** 3, 0.0)
