# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Particles that leave a box with fixed boundaries: a run goes on with those that remain, as if the
others had been deleted, or LAMMPS says that it lost them."""

import numpy as np

from tmsph_testing import Scene, Script, lattice, main, material

SPACING = 1e-3


def scene_of(dimension, lost, fixes=""):
    """A block in a box with fixed boundaries, three spacings from the face at high x."""
    cells = (8, 6) if dimension == 2 else (6, 4, 4)
    cloud = lattice("square" if dimension == 2 else "sc", cells, SPACING)
    scene = Scene(cloud, [material(expansion=1e-5)], pair="viscosity 1 2", temperature=20.0)
    box = np.array([-1.0, cells[0] + 3.0, -1.0, cells[1] + 1.0, -1.0, cells[-1] + 1.0]) * SPACING
    if dimension == 2:
        box[4:] = -0.5 * SPACING, 0.5 * SPACING
    lines = cloud.data(20.0).splitlines()
    at = next(n for n, line in enumerate(lines) if "xlo" in line)
    lines[at:at + 3] = [f"{box[2 * k]:.17g} {box[2 * k + 1]:.17g} {a}lo {a}hi"
                        for k, a in enumerate("xyz")]
    scene.files["cloud.data"] = "\n".join(lines) + "\n"
    text = "\n".join(scene.lines)
    text = text.replace("boundary s s p", "boundary f f p")
    scene.lines = [text.replace("boundary s s s", "boundary f f f")]
    scene.lost = f"thermo_modify lost {lost}\n"
    return scene.add(f"neighbor {0.5 * SPACING} bin\nfix move all nve\n"
                     f"timestep 5e-8\n{fixes}")


def all_fixes(dimension):
    floor = f"line 0 0 1 0" if dimension == 2 else "plane 0 0 0 0 0 1"
    down = "0 -1 0" if dimension == 2 else "0 0 -1"
    return (f"fix weight all gravity 1e6 vector {down}\n"
            f"fix floor all tmsph/wall {floor} friction 0.3\n"
            "fix touch all tmsph/contact friction * * 0.4\n"
            "fix rock all tmsph/hoekbrown strength * 1e8 mi * 8\n"
            "fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850 time/scale 1e3\n"
            "fix hot all tmsph/heat/boundary convection 1e5 400\n")


def as_deleted(report):
    """A corner that is lost at the start of a run, and the same deleted."""
    for dimension, ranks in ((2, 1), (2, 3), (3, 4)):
        ends, tables = [], []
        for goes in ("set group corner x 1", "delete_atoms group corner compress no"):
            scene = scene_of(dimension, "ignore", all_fixes(dimension))
            scene.add("region corner block 4.1e-3 INF INF 2.1e-3 INF INF units box\n"
                      "group corner region corner\nvariable y atom y*1.0002\nrun 0\n"
                      "set group all y v_y")
            scene.thermo("step pe ke f_floor[2] f_rock f_heat f_touch[7]", 20)
            scene.add(f"{scene.lost}run 20\n{goes}\nrun 60")
            run = scene.snapshot("end", "x y z vx vy vz fx fy fz").run(ranks)
            ends.append(run.frame("end"))
            tables.append(run.tables[-1])
        what = f"{dimension}-D on {ranks}: lost as deleted"
        report.true(f"{what}: who remains",
                    len(ends[0]["id"]) == len(ends[1]["id"]) < len(scene.cloud), "same")
        report.true(f"{what}: state", all(np.array_equal(ends[0][k], ends[1][k]) for k in ends[0]),
                    "same bits")
        for name in tables[0]:
            scale = max(abs(tables[1][name]).max(), 1e-300)
            report.below(f"{what}: {name}", abs(tables[0][name] - tables[1][name]).max() / scale,
                         1e-12)


def leaves(report):
    """A vibrating block flies out of the box, row by row; its dust touches in pairs too, whose planes
    stay when those who marked them are gone."""
    touch = "\nfix touch all tmsph/contact\nfix_modify touch energy yes"
    for dimension, contact in ((2, ""), (3, ""), (2, touch), (3, touch)):
        results = []
        for ranks in (1, 3):
            scene = scene_of(dimension, "ignore",
                             "fix rock all tmsph/hoekbrown strength * 60e6 mi * 8" + contact)
            scene.add("variable vy atom 2e3*(y-3e-3)\nvelocity all set 100 v_vy 0\n"
                      "compute fx all reduce sum fx\n"
                      "compute fy all reduce sum fy\nvariable f atom abs(fx)+abs(fy)\n"
                      "compute most all reduce max v_f\nvariable n equal count(all)")
            scene.thermo("step v_n pe ke c_fx c_fy c_most", 25).add(scene.lost + "run 1500")
            results.append(scene.run(ranks))
        table = results[0].tables[0]
        what = f"leaving, {dimension}-D{', in contact' if contact else ''}"
        left = table["v_n"][-1]
        report.within(f"{what}: particles left", left, 1, 0.8 * table["v_n"][0])
        report.true(f"{what}: on 3 processors",
                    np.array_equal(table["v_n"], results[1].thermo("v_n")),
                    "the same at the same time")
        scale = abs(table["PotEng"]).max()
        report.below(f"{what}: energy on 3 processors",
                     abs(table["PotEng"] - results[1].thermo("PotEng")).max() / scale, 1e-10)
        balance = np.hypot(table["c_fx"], table["c_fy"]).max() / table["c_most"].max()
        report.below(f"{what}: sum of all forces over the largest", balance, 1e-10)
        # lost particles and bonds take energy along, viscosity takes some: nothing brings any
        energy = table["PotEng"] + table["KinEng"]
        growth = np.diff(energy).max() / energy[0]
        report.below(f"{what}: growth of the energy", growth, 1e-6)


def told(report):
    """LAMMPS's own error, a warning, and a restart after losses."""
    fly = "velocity all set 100 0 0"
    stops = scene_of(2, "error", fly)
    stops = stops.add(stops.lost + "thermo 100000\nrun 1000").run(may_fail=True)
    report.true("lost error", stops.failed and "Lost atoms: original 48 current" in stops.log
                and "partner" not in stops.log, "LAMMPS's error")
    goes = scene_of(2, "warn", fly)
    run = goes.add(goes.lost + "thermo 500\nrun 1000").run()
    report.true("lost warn", "WARNING: Lost atoms" in run.log, "goes on")
    whole = scene_of(2, "ignore", fly).add("variable n equal count(all)")
    whole.thermo("step v_n pe ke", 100).add(whole.lost + "run 800\nwrite_restart r\nrun 300")
    state = "x y vx vy fx fy"
    run = whole.snapshot("end", state).run(keep="r")
    again = Script("read_restart r\nfix move all nve\ntimestep 5e-8\nneighbor 5e-4 bin\n"
                   "variable n equal count(all)\n"
                   "thermo_style custom step v_n pe ke\n"
                   "thermo_modify norm no lost ignore format float %.17g\n"
                   "run 300", run.kept).snapshot("end", state).run()
    report.true("restart after losses",
                again.thermo("v_n")[-1] == run.thermo("v_n")[-1] < run.thermo("v_n")[0]
                # LAMMPS sums in the order of the arrays, up to 48 particles
                and abs(again.thermo("KinEng")[-1] / run.thermo("KinEng")[-1] - 1) < 48 * 2.2e-16
                and np.array_equal(again.frame("end")(state), run.frame("end")(state)),
                "goes on as the run")


if __name__ == "__main__":
    main(as_deleted, leaves, told)
