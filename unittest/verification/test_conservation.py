# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Forces sum to zero and have no torque, whatever the displacements, velocities
and temperatures: jittered clouds of two materials, every law and option.
Bars are round-off of the forces' sums."""

from math import fsum

import numpy as np

from tmsph_testing import Scene, lattice, main, material

SPACING = 1e-3
MATERIALS = [material(40e9, 0.3, 2700, 1.5e-5), material(10e9, 0.2, 2000, -3e-5)]
SOFT = [material(40e9, 0.49, 2700, 1.5e-5), material(10e9, 0.45, 2000, -3e-5)]
CLOUDS = {"2-D": ("square", (16, 14)), "3-D": ("sc", (8, 7, 6))}
OPTIONS = ["", "hourglass 0", "thermal strain", "law almansi", "law neohookean", "kernel cubic",
           "kernel quintic", "plane stress"]


def disturbed(dimension, options, viscous, materials):
    name, cells = CLOUDS[dimension]
    cloud = lattice(name, cells, SPACING).jitter(0.2, 3)
    cloud.type[np.random.default_rng(4).random(len(cloud)) < 0.4] = 2
    cloud.volume *= np.random.default_rng(6).uniform(0.8, 1.2, len(cloud))
    d = cloud.dimension
    random = np.random.default_rng(7)
    positions = cloud.X + 0.1 * SPACING * random.uniform(-1, 1, cloud.X.shape)
    scene = Scene(cloud, materials, options + (" viscosity 1 2" if viscous else ""))
    scene.add("run 0").move(positions)
    scene.set("temperature", random.uniform(0, 3000, len(cloud)))
    if viscous:
        scene.set("vx vy vz"[: 3 * d - 1], random.uniform(-300, 300, cloud.X.shape))
    frame = scene.dump("d", "x y z fx fy fz").add("run 0").run().frame("d")
    return frame("x y z"), frame("fx fy fz")


def check(report, dimension, options, viscous=False, materials=MATERIALS):
    x, f = disturbed(dimension, options, viscous, materials)
    r = x - x.mean(axis=0)
    torque = np.cross(r, f)
    size = np.linalg.norm(f, axis=1)
    lever = np.linalg.norm(r, axis=1)
    what = f"{dimension} {options or 'default'}{', viscous' if viscous else ''}"
    what += ", nearly incompressible" if materials is SOFT else ""
    if viscous:
        share = np.abs(f - disturbed(dimension, options, False, materials)[1]).max() / size.max()
        report.above(f"{what}: viscous forces/all", share, 0.01)
    force = np.linalg.norm([fsum(f[:, k]) for k in range(3)]) / fsum(size)
    moment = np.linalg.norm([fsum(torque[:, k]) for k in range(3)]) / fsum(size * lever)
    report.below(f"{what}: sum of forces", force, 1e-14)
    report.below(f"{what}: torque", moment, 1e-13)


def conserved(report):
    for dimension in CLOUDS:
        for options in OPTIONS:
            if dimension == "2-D" or "plane" not in options:
                check(report, dimension, options)
        check(report, dimension, "", viscous=True)
        for options in ("", "thermal strain"):
            check(report, dimension, options, viscous=True, materials=SOFT)


if __name__ == "__main__":
    main(conserved)
