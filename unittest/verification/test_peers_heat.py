# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Thermal problems that rock codes verify themselves with, as far as other tests do not have them
(see doc/report/peers_verification.md): a slab that generates heat, a line source in a large body
with its thermal stress, and a half-space whose surface is suddenly heated, in equilibrium and with
inertia (Danilovskaya's problem).

Bars: 1 % of the largest value, 2 % for stresses, which on a lattice have errors of first order near
surfaces and sources; for the wave 3 %, half a horizon and more from its front, where the exact
stress jumps."""

import numpy as np

from heat_scenes import SIDES, UNIFORM, Heated, rms, slab
from tmsph_testing import lattice, main, material, order

ROCK = material(40e9, 0.25, 2700.0, 1e-5)
K, C = 3.0, 800.0
KAPPA = K / (ROCK["density"] * C)
E, NU, ALPHA = ROCK["young"], ROCK["poisson"], ROCK["expansion"]


def erfc(x):
    """By its integral from x on; to 1e-9."""
    x = np.atleast_1d(np.asarray(x, float))
    u, w = np.polynomial.legendre.leggauss(60)
    u, w = 3.5 * (u + 1), 3.5 * w    # exp(-49) beyond
    y = np.abs(x)[:, None] + u
    tail = 2 / np.pi**0.5 * (np.exp(-y**2) @ w)
    return np.where(x >= 0, tail, 2 - tail)


def exponential_integral(x):
    """E_1: exp(-x) times the integral of exp(-u)/(x + u), with u = exp(v)."""
    v = np.linspace(-40, 5, 4001)
    u = np.exp(v)
    return np.exp(-x) * np.sum(np.exp(-u) * u / (np.asarray(x)[..., None] + u), -1) * (v[1] - v[0])


def generating_slab(report):
    errors = []
    for n in (10, 20):
        body = Heated(slab(n), UNIFORM + " source * 8.0",
                      SIDES + "fix a all tmsph/heat/boundary temperature 0.0")
        T = body.run_to(4.0, 40)
        x = body.cloud.X[:, 0]
        errors.append(np.abs(T - 4 * x * (1 - x)).max())
    report.below("slab that generates heat, n = 20: largest error/largest temperature", errors[-1],
                 0.01)
    report.above("the same: order", order(errors)[-1], 1.5)


def line_source(report):
    """Plane strain; the heat has not come to the rim of the disc yet, but its stress has."""
    dx, R = 1e-3, 0.06
    cloud = lattice("square", (124, 124), dx, centre=True)
    cloud = cloud.kept(lambda X: np.hypot(*X.T) < R)
    r = np.hypot(*cloud.X.T)
    cloud.type[r < dx] = 2    # four particles
    power, time = 100.0, 0.2 * R**2 / KAPPA / 10
    body = Heated(cloud, f"conductivity * {K} specific/heat * {C} source 2 {power / (4 * dx**2)}",
                  materials=[ROCK, ROCK])
    body.add("compute p all tmsph/property/atom sxx syy sxy")
    body.steps(time, 100).minimize(1e3 * dx)
    end = body.snapshot("end", "c_T c_p[*]").run().frame("end")
    b = (cloud.volume.sum() / np.pi) ** 0.5
    exact = power / (4 * np.pi * K) * exponential_integral(r**2 / (4 * KAPPA * time))
    away = (r > 5 * dx) & (r < R - 4 * dx)
    report.below("line source: error of the temperature 5 spacings and more from it/largest",
                 np.abs(end["c_T"] - exact)[away].max() / exact[away].max(), 0.01)
    grid = np.linspace(1e-6 * R, b, 3001)
    middle, width = 0.5 * (grid[1:] + grid[:-1]), np.diff(grid)
    ring = exponential_integral(middle**2 / (4 * KAPPA * time)) * middle * width
    heat = power / (4 * np.pi * K) * np.append(0, np.cumsum(ring))
    inside = np.interp(r, grid, heat)
    scale = E * ALPHA / (1 - NU)
    radial = scale * (heat[-1] / b**2 - inside / r**2)
    hoop = scale * (heat[-1] / b**2 + inside / r**2 - exact)
    c, s = cloud.X.T / r
    xx, yy, xy = end("c_p[1] c_p[2] c_p[3]").T
    error = np.stack([c * c * xx + s * s * yy + 2 * c * s * xy - radial,
                      s * s * xx + c * c * yy - 2 * c * s * xy - hoop])[:, away]
    report.below("line source: radial and hoop stress, largest error/largest stress",
                 np.abs(error).max() / np.abs(np.stack([radial, hoop])[:, away]).max(), 0.02)


def half_space(report):
    """One particle row after the other along x, periodic in y; the far end feels nothing yet."""
    n, T0 = 160, 1.0
    cloud = lattice("square", (n, 8), 1.0 / n, periodic="y")
    x = cloud.X[:, 0]
    time = 0.02 / KAPPA    # depth of the heat 0.28
    body = Heated(cloud, f"conductivity * {K} specific/heat * {C}",
                  SIDES + f"fix a left tmsph/heat/boundary temperature {T0}", materials=[ROCK])
    body.add("compute p all tmsph/property/atom sxx syy szz")
    body.steps(time, 200).minimize(1e-4 * E * ALPHA * T0 / n)
    end = body.snapshot("end", "c_T c_p[*]").run().frame("end")
    T = erfc(x / (4 * KAPPA * time) ** 0.5)
    report.below("half-space: largest error of the temperature", np.abs(end["c_T"] - T).max(), 0.01)
    scale = E * ALPHA * T0 / (1 - NU)
    error = max(np.abs(end["c_p[1]"]).max(),
                *(np.abs(end[f"c_p[{k}]"] + scale * T).max() for k in (2, 3)))
    report.below("half-space in equilibrium: largest error of a stress/stress at the surface",
                 error / scale, 0.02)


def danilovskaya(report):
    """Lengths in kappa/c, times in kappa/c^2: the Laplace transform of the stress is
    (exp(-x sqrt p) - exp(-x p))/(1 - p) in units of M (1+nu)/(1-nu) alpha T0."""
    n, unit, T0, tau = 480, 60, 1.0, 2.0
    modulus = E * (1 - NU) / ((1 + NU) * (1 - 2 * NU))
    c = (modulus / ROCK["density"]) ** 0.5
    dx = 1e-4
    cloud = lattice("square", (n, 8), dx, periodic="y")
    scale = unit * dx * c / KAPPA    # of the time of heat, so that kappa/c is so many spacings
    steps = 4 * int(tau * unit)
    body = Heated(cloud, f"conductivity * {K} specific/heat * {C} time/scale {scale:.17g}",
                  f"region near block INF {10 * dx} INF INF INF INF\ngroup near region near\n"
                  f"fix a near tmsph/heat/boundary temperature {T0}", materials=[ROCK])
    body.lines = [line + " viscosity 1.0 0.0" if line.startswith("pair_style") else line
                  for line in body.lines]
    body.add("fix move all nve\ncompute p all tmsph/property/atom sxx")
    body.steps(tau * unit * dx / c, steps)
    end = body.snapshot("end", "c_T c_p").run().frame("end")
    xi = cloud.X[:, 0] / (unit * dx)
    root = tau**0.5
    pair = sum(np.exp(tau - sign * xi) * erfc(xi / (2 * root) - sign * root) for sign in (1, -1))
    exact = np.where(xi < tau, np.exp(np.minimum(tau - xi, 9)), 0) - 0.5 * pair
    size = modulus * (1 + NU) / (1 - NU) * ALPHA * T0
    error = end["c_p"] / size - exact
    away = (np.abs(xi - tau) > 0.15) & (xi > 0.1)
    report.note("Danilovskaya: largest exact stress, tension and pressure",
                f"{exact.max():.3f} {exact.min():.3f}")
    report.below("Danilovskaya: rms error of the stress/jump at the front, away from it",
                 rms(error[away]), 0.03)
    front = np.interp(0.5 * (exact[xi < tau].max() + exact[xi > tau].min()),
                      *[a[np.abs(xi - tau) < 0.1][::-1] for a in (end["c_p"] / size, xi)])
    report.below("Danilovskaya: place of the front against exact", abs(front / tau - 1), 0.01)


if __name__ == "__main__":
    main(generating_slab, line_source, half_space, danilovskaya)
