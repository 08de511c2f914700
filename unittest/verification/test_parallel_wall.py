# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Sliding over a moving, bumpy wall under a loaded plate, in 2-D, and on a turning plane in
3-D: the same to the last bit on any number of processors, balanced or not, in one run or
several, and continued from a restart written while it slides."""

import numpy as np

from tmsph_testing import Scene, Script, lattice, main, material

SPACING, ROCK = 0.01, material(10e6, 0.2, 1000.0)
STATE = "x y z vx vy vz fx fy fz"
STEPS = 1500


class Body:
    def __init__(self, dimension):
        two = dimension == 2
        name, cells = ("square", (16, 8)) if two else ("sc", (6, 6, 6))
        self.cloud = lattice(name, cells, SPACING)
        self.walls = (
            "variable away equal -0.3*ternary(step<300,0,1)\n"
            "variable press equal -800*(1-exp(-step/50))\n"
            "fix top all tmsph/wall line 1 0.08 -1 0.08 load NULL v_press mass 2.0\n"
            "fix left all tmsph/wall line 0 1 0 -1 friction 0.1\n"
            "fix low all tmsph/wall polyline 6 -1 0 0.162 0 0.165 0.0005 0.17 0.0005 0.175 0 1 0 "
            "friction 0.3 velocity v_away 0\n" if two else
            "variable spin equal 3*ternary(step<300,0,1)\n"
            "fix g all gravity 200 vector 0 0 -1\nfix low all tmsph/wall plane 0 0 0 0 0 1 "
            "friction 0.3 rotation 0 0 0 0 0 1 v_spin\n")
        self.columns = "f_low[1] f_low[7] f_low[8]"

    def fixes(self, scene, more=""):
        scene.add(f"fix move all nve\n{self.walls}timestep 5e-5\n{more}")
        return scene.add(f"thermo_style custom step {self.columns}\n"
                         "thermo_modify norm no format float %.17g\nthermo 100")

    def start(self, more=""):
        return self.fixes(Scene(self.cloud, [ROCK], "viscosity 1 0"), more)

    def ending(self, scene, runs):
        for n in runs:
            scene.add(f"run {n}")
        return scene.snapshot("end", STATE)


def different(run, reference):
    a, b = run.frame("end")(STATE), reference.frame("end")(STATE)
    return np.count_nonzero(~(a == b))


def compare(report, dimension):
    body = Body(dimension)
    what = f"{dimension}-D"
    reference = body.ending(body.start(), [STEPS]).run()
    report.above(f"{what}: work of friction, J", reference.thermo("f_low[7]")[-1], 1e-3)
    report.above(f"{what}: touching, mean since step 300",
                 reference.thermo("f_low[8]")[3:].mean(), 4)
    parts = [200, 401, STEPS - 601]
    balance = "comm_style tiled\nfix lb all balance 40 0.95 rcb\n"
    whole = [STEPS]
    for ranks, more, runs, label in ((2, "", whole, ""), (4, "", whole, ""),
                                     (4, balance, whole, ", balanced"),
                                     (1, "", parts, ", three runs"),
                                     (2, "", parts, ", three runs")):
        run = body.ending(body.start(more), runs).run(ranks)
        report.below(f"{what}: on {ranks}{label}, values that differ",
                     different(run, reference), 1)
        work = run.thermo("f_low[7]")[-1] / reference.thermo("f_low[7]")[-1]
        report.below(f"{what}: on {ranks}{label}, work of friction", abs(work - 1), 1e-12)
    written = body.start().add("run 700\nwrite_restart middle.restart").run(2, keep="*.restart")
    for ranks in (1, 4):
        scene = Script(f"comm_modify cutoff {6 * SPACING}\nread_restart middle.restart",
                       written.kept)
        run = body.ending(body.fixes(scene), [STEPS - 700]).run(ranks)
        report.below(f"{what}: continued on {ranks}, values that differ",
                     different(run, reference), 1)
        work = run.thermo("f_low[7]")[-1] / reference.thermo("f_low[7]")[-1]
        report.below(f"{what}: continued on {ranks}, work of friction", abs(work - 1), 1e-12)


def in_2d(report):
    compare(report, 2)


def in_3d(report):
    compare(report, 3)


if __name__ == "__main__":
    main(in_2d, in_3d)
