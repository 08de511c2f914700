# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Heated or stretched blocks of regular lattices that are clamped by periodic directions:
homogeneous states, and heating that varies along x."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, material

SPACING = 1e-3
ROCK = material(40e9, 0.3, 2700, 1e-5)
E, NU, ALPHA = ROCK["young"], ROCK["poisson"], ROCK["expansion"]
G = E / (2 * (1 + NU))
STATES = {"plane strain": ("hex", (10, 6), E * NU / ((1 + NU) * (1 - 2 * NU)), (1 + NU) * ALPHA),
          "plane stress": ("hex", (10, 6), E * NU / (1 - NU**2), ALPHA),
          "3-D": ("sc", (8, 8, 8), E * NU / ((1 + NU) * (1 - 2 * NU)), ALPHA)}
STRESSES = "sxx syy szz sxy sxz syz".split()


class State:
    """A homogeneous state of a block that is periodic in some directions, with
    the rest of its surface free."""

    def __init__(self, plane, periodic, T, stretch=None, options="", size=1):
        name, cells, self.lam, self.expansion = STATES[plane]
        self.d = d = len(cells)
        cloud = lattice(name, [size * n for n in cells], SPACING, periodic)
        self.V = cloud.volume.sum()
        keyword = "" if plane == "3-D" else "plane " + plane.split()[1]
        scene = Scene(cloud, [ROCK], f"{keyword} {options}").thermo("step pe press pxx pyy pzz vol")
        scene.add(f"compute p all tmsph/property/atom {' '.join(STRESSES)}\nrun 0")
        if stretch is not None and len(periodic) < d:
            scene.move(cloud.X * stretch)    # x, the periodic direction, has stretch 1
        elif stretch is not None:
            box = " ".join(f"{axis} scale {s:.17g}" for axis, s in zip("xyz", stretch))
            scene.add(f"change_box all {box} remap")
        scene.add(f"set group all temperature {T:.17g}\nrun 0").snapshot("d", "fx fy fz c_p[*]")
        run = scene.run()
        self.cost = run.cost
        frame = run.frame("d")
        values = frame(" ".join(f"c_p[{k}]" for k in range(1, 7)))
        self.stress = dict(zip(STRESSES, values.mean(axis=0)))
        self.spread = np.ptp(values, axis=0).max()
        self.force = np.abs(frame("fx fy fz")).max() / (E * SPACING ** (d - 1))
        self.energy, self.pressure = run.thermo("PotEng")[0], run.thermo("Press")[0]
        self.tensor = [run.thermo(p)[0] for p in ("Pxx", "Pyy", "Pzz")]
        self.volume = run.thermo("Volume")[0]

    def second_piola(self, strain):
        """lambda tr(E) + 2 mu E of a diagonal strain; energy density is half S:E."""
        return self.lam * np.sum(strain) + 2 * G * np.array(strain)


class Wavy:
    """A periodic block heated by 1 + cos(k x), in equilibrium. With beta = (d lambda + 2 mu) a
    and M = lambda + 2 mu the strain along x is beta cos(k x)/M, so that sxx = -beta and
    syy = -beta - 2 mu beta cos(k x)/M. The error is the root mean square of that of both, over
    the amplitude of syy."""

    def __init__(self, plane, n, options="", horizon=HORIZON, residual=1e-6, ranks=1):
        _, cells, lam, expansion = STATES[plane]
        d = len(cells)
        rows = max(7, int(np.ceil(2 * horizon)))
        cloud = lattice("square" if d == 2 else "sc", (n,) + (rows,) * (d - 1), SPACING, "xyz"[:d])
        wave = np.cos(2 * np.pi * cloud.X[:, 0] / (n * SPACING))
        mean = -(d * lam + 2 * G) * expansion
        amplitude = -2 * G * mean / (lam + 2 * G)
        keyword = "" if d == 3 else "plane " + plane.split()[1]
        scene = Scene(cloud, [ROCK], f"{keyword} {options}", horizon=horizon)
        scene.add("compute p all tmsph/property/atom sxx syy\nrun 0").set("temperature", 1 + wave)
        scene.minimize(residual * amplitude * SPACING ** (d - 1)).snapshot("d", "c_p[*]")
        run = scene.run(ranks)
        self.cost, (sxx, syy) = run.cost, run.frame("d")("c_p[1] c_p[2]").T
        square = (sxx - mean) ** 2 + (syy - mean + amplitude * wave) ** 2
        self.error = np.mean(square) ** 0.5 / amplitude
