# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Hollow cylinder, hot inside and cold outside: steady temperature and thermal stress against the
closed form (Timoshenko and Goodier, Theory of Elasticity, 3rd ed., sect. 150). Away from the
surfaces, which are staircases, is a horizon of a cylinder of 20 particles across the wall."""

import numpy as np

from heat_scenes import Heated, rms
from tmsph_testing import HORIZON, LATTICES, lattice, material

INNER, OUTER, HOT, AWAY = 0.5, 1.0, 100.0, HORIZON / 20
ROCK = material(40e9, 0.25, 2700.0, 1e-5)


class HollowCylinder:
    """n particles across the wall. temperature: root mean square error over the difference; of the
    stress, over the largest one: typical, a root mean square, and largest away from the surfaces,
    everywhere a root mean square."""

    def __init__(self, n, plane="strain", name="hex", options="", ranks=1):
        spacing = (OUTER - INNER) / n
        cells = tuple(int(2.2 * OUTER / spacing / edge) + 2 for edge in LATTICES[name][0])
        wall = lambda X: (np.hypot(*X.T) < OUTER) & (np.hypot(*X.T) > INNER)
        whole = lattice(name, cells, spacing, centre=True)
        cloud = whole.kept(wall)
        cell = whole.volume[0]
        a = np.sqrt(np.count_nonzero(np.hypot(*whole.X.T) <= INNER) * cell / np.pi)
        b = np.sqrt(a**2 + len(cloud) * cell / np.pi)
        edges = (f"region hole sphere 0 0 0 {a:.17g} side out\nregion rim sphere 0 0 0 {b:.17g}\n"
                 "region half sphere 0 0 0 0.75\ngroup inner region half\n"
                 "group outer subtract all inner\n"
                 f"fix a inner tmsph/heat/boundary temperature {HOT} region hole\n"
                 "fix b outer tmsph/heat/boundary temperature 0.0 region rim")
        r = np.hypot(*cloud.X.T)
        steady = HOT * np.log(b / r) / np.log(b / a)
        diffusivity = 2.9 / (ROCK["density"] * 850)
        scene = Heated(cloud, "conductivity * 2.9 specific/heat * 850", edges, start=0.5 * HOT,
                       materials=[ROCK])
        scene.lines = [line + f" plane {plane} {options}" if line.startswith("pair_style") else line
                       for line in scene.lines]
        scene.add("compute p all tmsph/property/atom sxx syy sxy")
        # the slowest mode decays like exp(-pi^2 kappa t/(b - a)^2)
        scene.thermo("step fnorm f_a[1] f_b[1]").add(
            f"timestep {2.5 * (b - a)**2 / diffusivity / 40:.17g}\nneigh_modify every 1000\nrun 40")
        young, nu = ROCK["young"], ROCK["poisson"]
        scale = (young * ROCK["expansion"] * HOT / (2 * np.log(b / a))
                 / (1 - nu if plane == "strain" else 1))
        scene.minimize(1e-6 * scale * spacing)
        run = scene.snapshot("end", "c_T c_p[*]").run(ranks)
        self.cost, end = run.cost, run.frame("end")

        ring = a**2 / (b**2 - a**2) * np.log(b / a)
        radial = scale * (-np.log(b / r) - ring * (1 - b**2 / r**2))
        hoop = scale * (1 - np.log(b / r) - ring * (1 + b**2 / r**2))
        c, s = cloud.X.T / r
        xx, yy, xy = end("c_p[1] c_p[2] c_p[3]").T
        measured = (c * c * xx + s * s * yy + 2 * c * s * xy,
                    s * s * xx + c * c * yy - 2 * c * s * xy)
        error = np.stack([measured[0] - radial, measured[1] - hoop]) / np.abs(hoop).max()
        away = np.minimum(r - a, b - r) > AWAY * (b - a)
        self.temperature = rms(end["c_T"] - steady) / HOT
        self.typical, self.largest = rms(error[:, away]), np.abs(error[:, away]).max()
        self.everywhere = rms(error)
