# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Forces are minus the gradient of the potential energy: against LAMMPS's own
fix numdiff, which differentiates the total energy. Step 1e-5 spacings: the
truncation and round-off of central differences are then near 1e-9."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

SPACING = 1e-3
MATERIALS = [material(40e9, 0.3, 2700, 1.5e-5), material(10e9, 0.2, 2000, -3e-5)]
CASES = [("square", (10, 10), "", ""), ("hex", (10, 6), "plane stress kernel cubic", ""),
         ("square", (10, 10), "thermal strain", ""), ("square", (9, 9), "", "xy"),
         ("sc", (6, 5, 5), "", ""), ("sc", (7, 7, 7), "hourglass 0.3", "z"),
         ("fcc", (3, 3, 3), "thermal strain kernel quintic", ""),
         ("hex", (10, 6), "law neohookean", ""),
         ("sc", (6, 5, 5), "law neohookean thermal strain", "")]
# nearly incompressible: bonds across the interface have a coupling of their own; each material
# next to the other and next to one that is not
SOFT = [[material(40e9, 0.49, 2700, 1.5e-5), material(10e9, 0.45, 2000, -3e-5)],
        [material(40e9, 0.499, 2700, 1.5e-5), material(10e9, 0.2, 2000, -3e-5)]]
SOFT_CASES = [("square", (10, 10), "kernel cubic", ""), ("square", (9, 9), "thermal strain", "xy"),
              ("sc", (6, 5, 5), "", "")]


def check(report, materials, name, cells, options, periodic, heated):
    cloud = lattice(name, cells, SPACING, periodic).jitter(0.2, 3)
    cloud.type[cloud.X[:, 0] > cloud.X[:, 0].mean()] = 2
    random = np.random.default_rng(7)
    scene = Scene(cloud, materials, options)
    if cloud.dimension == 2:    # some bonds are gone, across the interface too
        scene.add(f"tmsph/cut all line {2.3 * SPACING} {4.3 * SPACING} {6.2 * SPACING} "
                  f"{5.9 * SPACING}")
    scene.add("run 0")
    scene.move(cloud.X + 0.05 * SPACING * random.uniform(-1, 1, cloud.X.shape))
    if heated:
        scene.set("temperature", random.uniform(0, 3000, len(cloud)))
    scene.add(f"fix n all numdiff 1 {1e-5 * SPACING:.6g}")
    frame = scene.dump("d", "fx fy fz f_n[1] f_n[2] f_n[3]").add("run 0").run().frame("d")
    f, g = frame("fx fy fz"), frame("f_n[1] f_n[2] f_n[3]")
    error = np.abs(f - g).max() / np.abs(f).max()
    ratios = " and ".join(str(m["poisson"]) for m in materials)
    where = f", periodic {periodic}" if periodic else ""
    report.below(f"nu {ratios}, {name} {options or 'default'}{where}"
                 f"{', heated' if heated else ''}: force against energy", error, 1e-6)


def forces(report):
    for materials, cases in [(MATERIALS, CASES)] + [(soft, SOFT_CASES) for soft in SOFT]:
        for case in cases:
            for heated in (False, True):
                check(report, materials, *case, heated)


if __name__ == "__main__":
    main(forces)
