# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Affine deformation is reproduced by every particle, on free surfaces and at
interfaces too, and rigid rotation by any angle gives neither stress nor force.
Bars are round-off: displacements of some 10 spacings, differentiated over one."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

SPACING = 1e-3
STIFF, SOFT = material(40e9, 0.3), material(20e9, 0.2)
CELLS = {"square": (12, 10), "hex": (12, 6), "sc": (7, 6, 5), "fcc": (4, 4, 3)}
# rows of (axis, degrees); in 2-D the axis is z
ROTATIONS = [((0, 0, 1), 10), ((0, 0, 1), 90), ((0, 0, 1), 180),
             ((1, 2, 3), 137), ((2, -1, 2), 180)]


def two_materials(name, jitter):
    cloud = lattice(name, CELLS[name], SPACING).jitter(jitter, 17)
    cloud.type[cloud.X[:, 0] > cloud.X[:, 0].mean()] = 2
    return cloud


def rotation(axis, degrees):
    """Rodrigues' formula."""
    a = np.array(axis) / np.linalg.norm(axis)
    angle = np.radians(degrees)
    cross = np.array([[0, -a[2], a[1]], [a[2], 0, -a[0]], [-a[1], a[0], 0]])
    return np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross


def scene(cloud, maps, columns):
    s = Scene(cloud, [STIFF, SOFT])
    s.add(f"compute p all tmsph/property/atom {columns}\nrun 0")
    for k, (F, shift) in enumerate(maps):
        s.move(cloud.X @ F.T + shift).add("run 0").snapshot(f"{k}", "fx fy fz c_p[*]")
    return s


def affine(report):
    for name in CELLS:
        for jitter in (0.0, 0.2):
            cloud = two_materials(name, jitter)
            d = cloud.dimension
            random = np.random.default_rng(5)
            maps = [(np.eye(d) + 0.3 * random.uniform(-1, 1, (d, d)),
                     20 * SPACING * random.uniform(-1, 1, d)) for _ in range(2)]
            axes = "xyz"[:d]
            run = scene(cloud, maps, " ".join("F" + a + b for a in axes for b in axes)).run()
            error = 0.0
            for k, (F, _) in enumerate(maps):
                frame = run.frame(f"{k}")
                measured = frame(" ".join(f"c_p[{m + 1}]" for m in range(d * d)))
                error = max(error, np.abs(measured - F.ravel()).max())
            report.below(f"affine, {name}, jitter {jitter}: error of F", error, 1e-13)


def rotated(report):
    for name in CELLS:
        cloud = two_materials(name, 0.2)
        d = cloud.dimension
        maps = [(rotation(axis, degrees)[:d, :d], np.zeros(d))
                for axis, degrees in ROTATIONS if d == 3 or axis == (0, 0, 1)]
        run = scene(cloud, maps, "sxx syy szz sxy sxz syz").run()
        stress = force = 0.0
        for k in range(len(maps)):
            frame = run.frame(f"{k}")
            stress = max(stress, np.abs(frame(" ".join(f"c_p[{m}]" for m in range(1, 7)))).max())
            force = max(force, np.abs(frame("fx fy fz")).max())
        E = STIFF["young"]
        report.below(f"rotation, {name}: stress/E", stress / E, 1e-12)
        report.below(f"rotation, {name}: force/(E dx^{d - 1})", force / (E * SPACING ** (d - 1)),
                     1e-12)


if __name__ == "__main__":
    main(affine, rotated)
