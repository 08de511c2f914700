# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A box that fixes change while bonds or contacts reach across its periodic faces: fields, lists
and forces are those of homogeneous deformation everywhere."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

SPACING, RATE = 1e-3, 1000.0
YOUNG, POISSON = 40e9, 0.25


def body(dimension, fixes, pair=""):
    """Fills a box that is periodic in all directions."""
    cells = (20, 8) if dimension == 2 else (9, 7, 7)
    cloud = lattice("square" if dimension == 2 else "sc", cells, SPACING,
                    periodic="xyz"[:dimension])
    return Scene(cloud, [material(YOUNG, POISSON)], pair=pair).add(f"fix move all nve\n{fixes}")


FIELDS = """\
compute n all tmsph/property/atom sxx
compute low all reduce min c_n
compute high all reduce max c_n
compute b all tmsph/bond/local stretch
compute short all reduce min c_b inputs local
compute long all reduce max c_b inputs local
compute each all stress/atom NULL pair
compute less all reduce min c_each[1]
compute more all reduce max c_each[1]"""
COLUMNS = "step lx c_low c_high c_short c_long c_less c_more"


def stress(strain):
    """Cauchy stress of St Venant-Kirchhoff material that is stretched along x alone."""
    modulus = YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    return (1 + strain) * modulus * (strain + strain**2 / 2)


def uniform(report, what, run, bar):
    """Of the run, and of the run 0 after it if there was one."""
    for name, table in zip((what, what + ", after run 0"), run.tables):
        lx = table["Lx"]
        expected = stress(lx / run.tables[0]["Lx"][0] - 1)
        scale = abs(expected).max()
        for column in ("c_low", "c_high"):
            report.below(f"{name}: {column} of sxx", abs(table[column] - expected).max() / scale,
                         bar)
        spread = abs(table["c_more"] - table["c_less"]).max() / abs(table["c_more"]).max()
        report.below(f"{name}: stress/atom", spread, bar)
        stretch = lx[-1] / run.tables[0]["Lx"][0] - 1
        report.below(f"{name}: longest bond", abs(table["c_long"][-1] - stretch) / abs(stretch),
                     bar)


def remapped_positions(report):
    """Fix deform remap x moves owners after the forces."""
    for dimension, ranks in ((2, 1), (2, 3), (2, 4), (3, 1), (3, 4)):
        scene = body(dimension, f"fix stretch all deform 1 x erate {RATE} remap x").add(FIELDS)
        run = scene.thermo(COLUMNS, 10).add("timestep 1e-7\nrun 40\nrun 0").run(ranks)
        uniform(report, f"remap x, {dimension}-D on {ranks}", run, 1e-10)


def pressed(report):
    """Fix press/berendsen moves them too; the body is at rest but for that."""
    scene = body(2, "fix press all press/berendsen x 0 -1e8 1e-6 modulus 4.8e10").add(FIELDS)
    run = scene.thermo(COLUMNS, 10).add("timestep 1e-7\nrun 40\nrun 0").run()
    report.above("press/berendsen: strain",
                 abs(run.thermo("Lx", 0)[-1] / run.thermo("Lx", 0)[0] - 1), 1e-6)
    uniform(report, "press/berendsen", run, 1e-10)


def remapped_velocities(report):
    """Fix deform remap v leaves particles to velocities that grow across the body, which may drift
    through the faces of the box."""
    for viscosity, drift in ((0, 0), (1, 0), (1, 200)):
        for dimension, ranks in ((2, 1), (2, 3), (3, 4)):
            scene = body(dimension, f"fix stretch all deform 1 x erate {RATE} remap v",
                         pair=f"viscosity {viscosity} 0").add(FIELDS)
            scene.add(f"variable vx atom {drift}+{RATE}*(x-0.5*lx)\nvelocity all set v_vx 0 NULL\n"
                      "compute push all reduce max fx")
            scene.thermo(COLUMNS + " c_push", 100).add("timestep 2e-8\nrun 400")
            # at the start of a run 0 LAMMPS leaves particles that cross a face their former
            # velocity
            run = (scene if drift else scene.add("run 0")).run(ranks)
            what = f"remap v, viscosity {viscosity}, drift {drift}, {dimension}-D on {ranks}"
            uniform(report, what, run, 1e-10)
            unit = abs(run.thermo("c_high", 0)[-1]) * SPACING ** (dimension - 1)
            report.below(f"{what}: largest force over that on a section of a particle",
                         max(table["c_push"].max() for table in run.tables) / unit, 1e-9)


def contact(report):
    """Two bodies that touch across faces of a box that becomes shorter and wider, homogeneously:
    they press and rub as if the faces were elsewhere, or farther apart."""
    results = []
    for shift, rows, ranks in ((0.0, 8, 1), (0.0, 8, 4), (3e-3, 8, 1), (0.0, 16, 1)):
        cloud = lattice("square", (10, rows), SPACING, periodic="xy")
        cloud.type = 1 + (cloud.X[:, 0] > 5e-3)
        cloud.X[:, 0] = (cloud.X[:, 0] + shift) % 10e-3
        scene = Scene(cloud, [material(YOUNG, POISSON)] * 2).add(
            "pair_coeff 1 2 none\nfix move all nve\nfix touch all tmsph/contact friction * * 0.3\n"
            f"fix shrink all deform 1 x erate -{RATE} y erate {RATE} remap v")
        scene.add(f"variable vx atom -{RATE}*(x-0.5*lx)\nvariable vy atom {RATE}*(y-0.5*ly)\n"
                  "velocity all set v_vx v_vy NULL")
        scene.thermo("step f_touch[7] f_touch[10]", 100)
        run = scene.add("timestep 2e-8\nrun 100").run(ranks)
        results.append(np.array([run.thermo(f"f_touch[{k}]")[-1] / rows for k in (7, 10)]))
    report.above("contact: normal forces", results[0][1], 0.0)
    for what, other in zip(("on 4 processors", "across other faces", "with faces farther apart"),
                           results[1:]):
        for name, error in zip(("work of friction", "normal forces"), abs(other / results[0] - 1)):
            report.below(f"contact {what}: {name}", error, 1e-9)


if __name__ == "__main__":
    main(remapped_positions, pressed, remapped_velocities, contact)
