# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A free body of two materials of equal expansion, heated uniformly, jittered or not, in
equilibrium: it expands without stress."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, material

SPACING, TEMPERATURE = 1e-3, 200.0
ROCK = material(40e9, 0.3, 2700, 1e-5)
SOFT = material(4e9, 0.3, 2700, 1e-5)    # equal expansion and Poisson's ratio: no stress either
BODIES = {"plane strain": ("square", (12, 9), 1.3e-5), "plane stress": ("hex", (12, 5), 1e-5),
          "3-D": ("sc", (7, 6, 5), 1e-5)}


def pairs(cloud):
    distance = np.linalg.norm(cloud.X[:, None] - cloud.X[None], axis=2)
    return np.nonzero(np.triu(distance < HORIZON * SPACING, 1))


class Expansion:
    """Errors of the strain, taken from all pairs within the horizon, over the strain, and of
    the stress over E alpha dT; size is a factor of the edges."""

    def __init__(self, plane, jitter, mode, residual=1e-11, options="", horizon=HORIZON, size=1,
                 ranks=1):
        name, cells, expansion = BODIES[plane]
        cloud = lattice(name, [size * n for n in cells], SPACING).jitter(jitter, 11)
        d = cloud.dimension
        cloud.type[cloud.X[:, 0] > cloud.X[:, 0].mean()] = 2
        a = expansion * TEMPERATURE
        # Green's strain of the constitutive form is a, the stretch of the thermal bond is 1 + a
        strain = a if mode == "bond" else (1 + 2 * a) ** 0.5 - 1
        stress = ROCK["young"] * ROCK["expansion"] * TEMPERATURE
        keyword = "" if d == 3 else "plane " + plane.split()[1]
        axes = "xx yy xy" if d == 2 else "xx yy zz xy xz yz"
        columns = " ".join("s" + axis for axis in axes.split())
        scene = Scene(cloud, [ROCK, SOFT], f"{keyword} thermal {mode} {options}", horizon=horizon)
        scene.add(f"compute p all tmsph/property/atom {columns} szz\nrun 0")
        scene.add(f"set group all temperature {TEMPERATURE}")
        scene.minimize(residual * stress * SPACING ** (d - 1)).snapshot("d", "x y z c_p[*]")
        run = scene.run(ranks)
        self.cost, frame = run.cost, run.frame("d")
        x = frame("x y z")[:, :d]
        i, j = pairs(cloud)
        before = np.linalg.norm(cloud.X[j] - cloud.X[i], axis=1)
        after = np.linalg.norm(x[j] - x[i], axis=1)
        self.strain_error = np.abs((after - before) / before - strain).max() / strain
        n = len(columns.split())
        values = frame(" ".join(f"c_p[{k + 1}]" for k in range(n)))
        self.stress_error = np.abs(values).max() / stress
        if plane == "plane strain":
            young = np.where(cloud.type == 1, ROCK["young"], SOFT["young"])
            szz = -young * ROCK["expansion"] * TEMPERATURE
            self.szz_error = np.abs(frame[f"c_p[{n + 1}]"] - szz).max() / stress
