# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A horizon for each material: a coarse and a fine block that are bonded. Homogeneous strain is
exact, momentum and angular momentum are conserved, a vibration keeps its energy; the same to
the last bit on two processors and after a restart."""

import numpy as np

from tmsph_testing import HORIZON, Cloud, Scene, Script, lattice, main, material

COARSE, FINE = 1e-3, 0.5e-3
ROCKS = [dict(material(), horizon=HORIZON * COARSE), dict(material(), horizon=HORIZON * FINE)]
STATE = "x y vx vy fx fy"
STEP, STEPS = 0.3 * FINE / 4465, 1000

low, high = lattice("square", (10, 8), COARSE), lattice("square", (20, 12), FINE)
cloud = Cloud(np.concatenate([low.X, high.X + [0, 8 * COARSE]]), 1.0, COARSE)
cloud.volume = np.concatenate([low.volume, high.volume])
cloud.type = np.repeat([1, 2], [len(low), len(high)])


def fixes(scene):
    return scene.add(f"fix move all nve\ntimestep {STEP:.17g}\n"
                     "thermo_style custom step etotal pe\n"
                     "thermo_modify norm no format float %.17g\nthermo 20")


def start():
    scene = Scene(cloud, ROCKS)
    X = (cloud.X - cloud.X.mean(axis=0)) / (5 * COARSE)
    return fixes(scene.set("vx vy", np.stack([X[:, 0] + 0.3 * X[:, 1], -0.5 * X[:, 1]], axis=1)))


def differ(run, reference):
    return np.count_nonzero(~(run.frame("end")(STATE) == reference.frame("end")(STATE)))


def strained(report):
    gradient = np.array([[2e-3, 1e-3], [-5e-4, -1e-3]])
    scene = Scene(cloud, ROCKS).add("compute p all tmsph/property/atom sxx syy sxy nbond\nrun 0")
    scene.move(cloud.X + cloud.X @ gradient.T).add("run 0").snapshot("end", "c_p[*]")
    frame = scene.run().frame("end")
    for k, name in enumerate(("sxx", "syy", "sxy"), 1):
        s = frame[f"c_p[{k}]"]
        report.below(f"homogeneous strain: spread of {name}/E", np.ptp(s) / ROCKS[0]["young"],
                     1e-12)
    inner = (np.abs(cloud.X - [5 * COARSE, 11 * COARSE]) < COARSE).all(axis=1)
    report.within("bonds in the fine block", frame["c_p[4]"][inner].mean(), 28, 28)


def moving(report):
    reference = start().dump("all", STATE, STEPS // 5).add(f"run {STEPS}").snapshot(
        "end", STATE).run()
    mass = 2700 * cloud.volume
    first, last = reference.frame("all", 0), reference.frame("all")
    momentum = lambda f: (mass[:, None] * f("vx vy")).sum(axis=0)
    spin = lambda f: (mass * (f["x"] * f["vy"] - f["y"] * f["vx"])).sum()
    size = (mass[:, None] * np.abs(first("vx vy"))).sum()
    report.below("change of momentum/sum of magnitudes",
                 np.abs(momentum(last) - momentum(first)).max() / size, 1e-12)
    report.below("change of angular momentum/sum of magnitudes",
                 abs(spin(last) - spin(first)) / (size * 10 * COARSE), 1e-12)
    energy = reference.thermo("TotEng")
    report.below("band of the energy", np.ptp(energy) / energy[0], 2e-3)
    written = start().add(f"run {STEPS // 2}\nwrite_restart middle.restart").run(
        2, keep="*.restart")
    scene = Script(f"comm_modify cutoff {2 * HORIZON * COARSE}\nread_restart middle.restart",
                   written.kept)
    run = fixes(scene).add(f"run {STEPS - STEPS // 2}").snapshot("end", STATE).run()
    report.below("2 processors, then 1 after a restart: values that differ",
                 differ(run, reference), 1)


if __name__ == "__main__":
    main(strained, moving)
