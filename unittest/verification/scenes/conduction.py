# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Slabs and discs that conduct heat, against the closed forms of heat_scenes."""

import numpy as np

from heat_scenes import SIDES, UNIFORM, Heated, dirichlet, disc_solution, neumann, rms, robin, slab
from tmsph_testing import LATTICES, lattice

# time, boundaries, temperature at first, exact solution

SLABS = {
    "Dirichlet": (0.05, "fix b all tmsph/heat/boundary temperature 1.0", 0.0, dirichlet),
    "Neumann": (0.1, "fix b left tmsph/heat/boundary flux 1.0", 0.0, neumann),
    "Robin": (0.3, "fix b right tmsph/heat/boundary convection 2.0 0.0", 1.0,
              lambda x, t: robin(x, t, 2.0)),
}
DISC_TIME, BIOT = 0.05, 2.0
DISCS = {"Dirichlet": ("temperature 1.0", None), "Robin": (f"convection {BIOT} 1.0", BIOT)}


class Conducting:
    """error: root mean square of that of the temperatures, between 0 and 1."""

    EXPLICIT = 0.3    # step in units of dx^2/diffusivity, about 0.7 of the stable one

    def solve(self, scene, time, steps, spacing, exact, ranks):
        if any("subcycle explicit" in line for line in scene.lines):
            steps = max(steps, int(np.ceil(time / (self.EXPLICIT * spacing**2))))
        scene.steps(time, steps).snapshot("end", "c_T")
        run = scene.run(ranks)
        self.cost = run.cost
        self.error = rms(run.frame("end")["c_T"] - exact)


class ConductingSlab(Conducting):
    def __init__(self, case, n, name="square", steps=100, words="", jitter=0.0, ranks=1):
        time, conditions, start, exact = SLABS[case]
        cloud = slab(n, name, jitter, width=n if jitter else None)
        scene = Heated(cloud, f"{UNIFORM} {words}", SIDES + conditions, start)
        self.solve(scene, time, steps, cloud.spacing, exact(cloud.X[:, 0], time), ranks)


class ConductingDisc(Conducting):
    EXPLICIT = 0.06    # particles close to the rim limit it

    def __init__(self, case, n, name="hex", steps=40, words="", ranks=1):
        condition, biot = DISCS[case]
        cells = tuple(int(2.2 * n / edge) + 2 for edge in LATTICES[name][0])
        cloud = lattice(name, cells, 1.0 / n, centre=True).kept(lambda X: np.hypot(*X.T) < 1.0)
        R = np.sqrt(cloud.volume.sum() / np.pi)
        scene = Heated(cloud, f"{UNIFORM} {words}", f"region rim sphere 0 0 0 {R:.17g}\n"
                       f"fix b all tmsph/heat/boundary {condition} region rim")
        exact = disc_solution(np.hypot(*cloud.X.T) / R, DISC_TIME / R**2, biot and biot * R)
        self.solve(scene, DISC_TIME, steps, cloud.spacing, exact, ranks)
