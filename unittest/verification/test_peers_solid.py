# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Problems that peridynamic codes verify themselves with, as far as other tests do not have them
(see doc/report/peers_verification.md), against closed forms: the front of a pulse in a slender
bar, a torsional vibration, a crack in tension.

Bars: those of Peridynamics.jl for the front and for torsion are 25 and 30 %, here 2 and 10 %, the
latter of first order at least as the sides are soft. Bonds across a cut are missing up to half a
horizon beyond its tips: by that share of its half-length the opening of a crack may be wrong, and
by twice that the energy release rate, where the correction for the width grows as well; with
first order."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, main, material, order, sampled_frequency

ROCK = material(40e9, 0.25, 2700.0)
E, NU, RHO = ROCK["young"], ROCK["poisson"], ROCK["density"]


def pulse(report):
    """A bar 1/60 as wide as long, plane stress, whose end is pulled for a while: the front at half
    the height of the plateau goes with sqrt(E/rho)."""
    rows, columns, dx, v = 5, 300, 1e-3, 1e-3
    cloud = lattice("square", (columns, rows), dx)
    c = (E / RHO) ** 0.5
    dt = 0.3 * dx / c
    scene = Scene(cloud, [ROCK], "plane stress")
    ramp = 20 * dx / c
    scene.add(f"region end block INF {dx} INF INF INF INF\ngroup end region end\n"
              f"group rest subtract all end\nfix move rest nve\ntimestep {dt:.17g}\n"
              f"variable v equal {v}*ternary(time<{ramp:.9g},time/{ramp:.9g},1)\n"
              f"variable u equal {v}*ternary(time<{ramp:.9g},time^2/{2 * ramp:.9g},"
              f"time-{0.5 * ramp:.9g})\n"
              "fix pull end move variable v_u NULL NULL v_v NULL NULL")
    places = []
    steps = round(120 * dx / c / dt)
    for k in range(2):
        scene.add(f"run {steps}").snapshot(f"at{k}", "vx")
    run = scene.run()
    x = cloud.X[:, 0].reshape(columns, -1).mean(axis=1)
    for k in range(2):
        profile = run.frame(f"at{k}")["vx"].reshape(columns, -1).mean(axis=1)
        j = np.flatnonzero(profile > 0.5 * v)[-1]
        places.append(x[j] + dx * (profile[j] - 0.5 * v) / (profile[j] - profile[j + 1]))
    speed = (places[1] - places[0]) / (steps * dt)
    report.below("pulse in a bar: speed against sqrt(E/rho)", abs(speed / c - 1), 0.02)


def torsion(n):
    """Frequency over the exact one and change of the energy. Free square rod, first mode:
    G J theta'' = rho I theta_tt with J = 0.1406 a^4, I = a^4/6."""
    length, dx = 8 * n, 8e-3 / n
    cloud = lattice("sc", (length, n, n), dx, centre=True)
    G = E / (2 * (1 + NU))
    speed = (G * 0.140577 * 6 / RHO) ** 0.5
    omega = np.pi * speed / (length * dx)
    shape = np.sin(np.pi * cloud.X[:, 0] / (length * dx))
    scene = Scene(cloud, [ROCK])
    spin = 1e-3 * omega * shape
    scene.set("vy vz", np.stack([-spin * cloud.X[:, 2], spin * cloud.X[:, 1]], axis=1))
    period = 2 * np.pi / omega
    every = int(np.ceil(period / 24 / (0.4 * dx / (E / RHO) ** 0.5)))
    scene.files["shape"] = f"\n{len(cloud)}\n" + "".join(f"{i + 1} {v:.17g}\n" for i,
                                                         v in enumerate(shape))
    scene.add("variable s atomfile shape\ncompute u all tmsph/property/atom uy uz y0 z0\nrun 0\n"
              "variable q atom (c_u[2]*c_u[3]-c_u[1]*c_u[4])*v_s\ncompute q all reduce sum v_q\n"
              "fix move all nve\n"
              f"timestep {period / 24 / every:.17g}")
    run = scene.thermo("step c_q etotal", every).add(f"run {24 * every}").run()
    measured = sampled_frequency(run.thermo("c_q")[1:], period / 24)
    energy = run.thermo("TotEng")
    return measured / omega, np.ptp(energy) / energy[0]


class Crack:
    """A crack of half-length a in the middle of a plate of half-width b = 2.5 a under tension S,
    plane strain, cut further at both tips by so many spacings."""

    dx, S = 1e-3, 1e6
    plane = E / (1 - NU**2)

    def __init__(self, half, further=0):
        n, rows = 5 * half, 10 * half    # so high that it counts as infinite
        cloud = lattice("square", (n, rows), self.dx, centre=True)
        self.a, b = half * self.dx, 0.5 * n * self.dx
        self.alpha = self.a / b
        tip, edge = self.a + further * self.dx, (0.5 * rows - 0.9) * self.dx
        force = self.S * self.dx
        scene = Scene(cloud, [ROCK]).thermo("step pe")
        scene.add(f"region top block INF INF {edge} INF INF INF\ngroup top region top\n"
                  f"region low block INF INF INF {-edge} INF INF\ngroup low region low\n"
                  f"tmsph/cut all line {-tip} 0 {tip} 0\n"
                  f"fix t top addforce 0 {force} 0\nfix l low addforce 0 {-force} 0\n"
                  "compute u all tmsph/property/atom uy")
        run = scene.minimize(1e-5 * force, style="tmsph/lbfgs").snapshot("end", "c_u").run()
        self.energy = run.thermo("PotEng")[-1]
        u = run.frame("end")["c_u"].reshape(n, rows)    # x, then y
        gap = u[:, rows // 2] - u[:, rows // 2 - 1] - self.S / self.plane * self.dx
        self.middle = gap[n // 2 - 1 : n // 2 + 1].mean()

    def opening_error(self):
        """Against 4 S a/E' V(a/b), V of Tada (1973), good to 0.6 %."""
        alpha = self.alpha
        V = (-0.071 - 0.535 * alpha + 0.169 * alpha**2 + 0.020 * alpha**3
             - 1.071 / alpha * np.log(1 - alpha))
        return abs(self.middle * self.plane / (4 * self.S * self.a * V) - 1)


def release_error(half):
    """The energy of the body grows under a constant load by what two tips release; against
    K^2/E' with K = S (pi a sec(pi a/2b))^(1/2) (Feddersen)."""
    long, short = Crack(half, 2), Crack(half, -2)
    rate = (long.energy - short.energy) / (8 * long.dx)
    exact = long.S**2 * np.pi * long.a / np.cos(0.5 * np.pi * long.alpha) / long.plane
    return abs(rate / exact - 1)


def rods(report):
    frequency, energy = zip(*[torsion(n) for n in (6, 9)])
    report.note("torsion of a square rod, 6 and 9 rows: frequency/exact",
                "{:.4f} {:.4f}".format(*frequency))
    report.below("torsion, 9 rows: error of the frequency", abs(frequency[1] - 1), 0.10)
    report.above("torsion: order", order(np.array(frequency) - 1, 1.5)[0], 1.0)
    report.below("torsion: change of energy/energy", max(energy), 0.01)


def cracks(report):
    gaps = []
    for half in (8, 16, 24):
        gaps.append(Crack(half).opening_error())
        report.below(f"crack of half-length {half}: error of the opening in the middle", gaps[-1],
                     0.5 * HORIZON / half)
    report.above("crack: order of the opening", order(gaps[:2])[0], 0.8)
    for half in (12, 24):
        report.below(f"crack of half-length {half}: error of the energy release rate",
                     release_error(half),
                     HORIZON / half)


if __name__ == "__main__":
    main(pulse, rods, cracks)
