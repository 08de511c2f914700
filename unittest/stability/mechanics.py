# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Elastic bodies: stiffness, strains, speeds, time steps, options and clouds at their limits."""

from cases import *
from tmsph_testing import *

SPACING = 1e-3
ROCK = material()
E, RHO = ROCK["young"], ROCK["density"]


def wave_speed(m):
    """Of longitudinal waves."""
    nu = m["poisson"]
    return (m["young"] * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / m["density"]) ** 0.5


def blocks():
    """A small block in 2-D and one in 3-D."""
    return {"2-D": lattice("square", (12, 10), SPACING), "3-D": lattice("sc", (7, 6, 5), SPACING)}


def affine(cloud, diagonal):
    """Positions after stretches along the axes."""
    return cloud.X * np.asarray(diagonal)[: cloud.dimension]


@case("turned inside out", "a block is squeezed along x to the stretch s = 0.5, 0.1, ..., 0, -0.5",
      "det F > 0: runs for s > 0, names a particle for s <= 0", level="test")
def inverted(bench):
    good = True
    for what, cloud in blocks().items():
        for s in (0.5, 0.1, 1e-3, 1e-6, 0.0, -1e-6, -0.5):
            scene = Scene(cloud, [ROCK]).add("run 0").move(affine(cloud, (s, 1, 1)))
            run = bench.run(scene, f"{what}, {s}")
            good &= run.ok if s > 0 else run.end == "stopped" and "inside out" in run.message
    return Found("s = 1e-6 runs, 0 does not", "stopped: particle, place and step", good)
