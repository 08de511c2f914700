# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Patch test: a rim of two horizons of a block is held in an affine deformation, so that the
particles inside have bonds to particles with full families only. These
start from a random displacement and find their equilibrium."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, material

SPACING, STRAIN = 1e-3, 1e-3
ROCK = material()
LATTICES_2D = ("square", "hex")


class Patch:
    """error: root mean square distance of the particles inside from the affine deformation,
    over the strain times the edge; n cells along an edge."""

    def __init__(self, name, n, jitter=0.0, options="", horizon=HORIZON, residual=1e-8, ranks=1):
        d = 2 if name in LATTICES_2D else 3
        cells = (n, n // 2) if name == "hex" else (n,) * d
        cloud = lattice(name, cells, SPACING)
        low, high = (np.array(side) for side in cloud.box)
        inside = ((cloud.X > low + 2 * horizon * SPACING) &
                  (cloud.X < high - 2 * horizon * SPACING)).all(axis=1)
        cloud.jitter(jitter, 3)
        random = np.random.default_rng(7)
        gradient = STRAIN * random.uniform(-1, 1, (d, d))
        affine = cloud.X @ (np.eye(d) + gradient).T
        start = affine + inside[:, None] * random.uniform(-1, 1, (len(cloud), d)) * \
            STRAIN * SPACING
        scene = Scene(cloud, [ROCK], options, horizon=horizon).add("run 0").move(start)
        scene.files["held"] = f"\n{len(cloud)}\n" + "".join(
            f"{i + 1} {int(not free)}\n" for i, free in enumerate(inside))
        scene.add("variable held atomfile held\ngroup held variable held\n"
                  "fix hold held setforce 0 0 0")
        scene.minimize(residual * ROCK["young"] * STRAIN * SPACING ** (d - 1))
        scene.snapshot("d", "x y z")
        run = scene.run(ranks)
        self.cost = run.cost
        off = run.frame("d")("x y z")[:, :d] - affine
        self.error = np.mean(np.sum(off[inside] ** 2, axis=1)) ** 0.5 / (STRAIN * n * SPACING)
