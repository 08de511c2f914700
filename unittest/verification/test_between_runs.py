# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What an input may do between two runs, and in which order it may define things."""

import numpy as np

from tmsph_testing import Cloud, Scene, Script, lattice, main, material

SPACING = 1e-3
REST = "velocity all set 0 0 0"


def blocks(gap):
    """A block on another one that is wider, so many spacings above it; steps of 10 ns."""
    low = lattice("square", (10, 6), SPACING)
    high = lattice("square", (6, 4), SPACING)
    cloud = Cloud(np.concatenate([low.X, high.X + SPACING * np.array([2.0, 6.0 + gap])]),
                  SPACING**2, SPACING)
    cloud.type[len(low):] = 2
    scene = Scene(cloud, [material()] * 2, pair="viscosity 1 2")
    scene.add("pair_coeff 1 2 none\ngroup low type 1\ngroup high type 2\nfix 1 all nve\n"
              "timestep 1e-8")
    return scene


def forget_contact(report):
    """A compute after the contact is gone has the stress by bonds alone, as in a run of no
    steps."""
    scene = blocks(0.0).add("fix touch all tmsph/contact\ncompute p all tmsph/property/atom syy\n"
                            "compute most all reduce max c_p")
    scene.thermo("step").add("run 0\ndisplace_atoms high move 0 -1e-5 0 units box\nrun 20")
    scene.add("unfix touch\nvariable now equal $(c_most)\n"
              "thermo_style custom step c_most v_now\nrun 0")
    last = scene.run()
    report.true("stress after unfix tmsph/contact",
                last.thermo("c_most")[-1] == last.thermo("v_now")[-1]
                and last.thermo("c_most")[-1] != 0.0, "that of the bonds")


def meet_after_reset(report):
    """Bodies that meet later do so as well if the step is set back in between."""
    falls = blocks(8.4).add("velocity high set 0 -100 0 units box\nfix touch all tmsph/contact")
    falls.thermo("step f_touch[2]").add("thermo 500\nrun 5500\nreset_timestep 0\nrun 3500")
    force = falls.run().thermo("f_touch[2]")
    # 2 m v in the last 1400 steps is a mean of 9e5
    report.below("force of bodies that meet after reset_timestep", force.min(), -1e5)


def leave_the_group(report):
    """Particles in contact that met after the first run may leave the group of the contact."""
    falls = blocks(3.2).add("velocity high set 0 -100 0 units box\ngroup touch union high low\n"
                            "fix touch touch tmsph/contact")
    falls.thermo("step f_touch[8]").add("run 3000\n"
                                        "region some block 0 5e-3 INF INF INF INF units box\n"
                                        "group touch clear\ngroup touch region some\nrun 10")
    before, after = (falls_run["f_touch[8]"][-1] for falls_run in falls.run().tables)
    report.within("pairs that touch after half of them left the group", after, 1, before - 1)


def leave_the_wall(report):
    """Particles that left the group of a wall are free of it from the setup of the next run on."""
    press = blocks(0.0).add("group held union high low\n"
                            "fix wall held tmsph/wall line 0 1e-5 1e-2 1e-5\n"
                            "compute f all reduce sum fy")
    press.thermo("step c_f f_wall[2]").add("run 20\ngroup held clear\nrun 0")
    run = press.run()
    force = run.thermo("f_wall[2]", 0)[-1]
    report.above("force of the wall", abs(force), 1e5)
    report.below("force on the free body, relative", abs(run.thermo("c_f")[-1] / force), 1e-9)


def delete_far_away(report):
    """What touches goes on as if nothing had happened after particles far away were deleted, with the ids that all
    had or new ones; then the forces are added up in another order."""
    for ids, rounding in (("no", 0.0), ("yes", 1e-14)):
        press = blocks(0.0).add("fix push high addforce 0 -1e4 0\n"
                                "fix touch all tmsph/contact friction * * 0.4\n"
                                "fix wall all tmsph/wall line 0 0 1e-2 0 friction 0.3")
        press.thermo("step f_touch[2] f_wall[1] f_wall[2]").add(
            "run 100\nregion hole block 0 1e-3 4e-3 5e-3 INF INF units box\n"
            f"delete_atoms region hole compress {ids}\nrun 0")
        run = press.run()
        for name in ("f_touch[2]", "f_wall[1]", "f_wall[2]"):
            before, after = run.thermo(name, 0)[-1], run.thermo(name)[-1]
            report.true(f"{name} after delete_atoms compress {ids}",
                        before != 0.0 and abs(after - before) <= rounding * abs(before), "as before")


def plane(report):
    """Velocities across the plane of a 2-D scene rub at nothing and change nothing in the plane."""
    press = blocks(0.0).add("fix touch all tmsph/contact friction * * 0.4\n"
                            "fix wall all tmsph/wall line 0 1e-5 1e-2 1e-5 friction 0.3")
    press.add("variable across atom SPEED*x\nset group all vz v_across")
    press.thermo("step pe f_wall[1] f_wall[2] f_wall[3] f_wall[7]").add("run 100")
    runs = []
    for speed in (0, 1e4):
        scene = Script("\n".join(press.lines).replace("SPEED", str(speed)), press.files)
        runs.append(scene.run())
    for name in ("PotEng", "f_wall[1]", "f_wall[2]", "f_wall[3]", "f_wall[7]"):
        still, moving = (run.thermo(name)[-1] for run in runs)
        report.true(f"{name} with velocities across the plane", still == moving, "as without")


def heated(before, after=""):
    """A block of which one side may be held; heat alone."""
    cloud = lattice("square", (8, 8), SPACING)
    scene = Scene(cloud, [material()]).add(
        "region side block INF 2.5e-3 INF INF INF INF units box\ngroup side region side\n"
        "variable T equal 100+step\ntimestep 1e-3")
    scene.add(before).add("fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850")
    return scene.add(after)


def order_of_boundaries(report):
    """What a boundary brings does not depend on whether it is defined before fix tmsph/heat."""
    held = "fix hold side tmsph/heat/boundary temperature v_T place body"
    for name, scene in (("before", heated(held)), ("after", heated("", held))):
        scene.thermo("step f_heat f_heat[2] f_hold[2]", 10).add("run 20")
        run = scene.run()
        content = run.thermo("f_heat")[-1]    # 0 at temperature 0, at the start
        for column in ("f_heat[2]", "f_hold[2]"):
            report.below(f"{column} of a boundary {name} the fix, error of the balance",
                         abs(run.thermo(column)[-1] - content) / content, 1e-12)


def energies_in_variables(report):
    """Variables of sources and boundaries may ask for energies on heat steps, whenever a run
    starts."""
    for words, fix in (("source * v_given", ""),
                       ("", "fix in all tmsph/heat/boundary flux v_given")):
        scene = Scene(lattice("square", (8, 8), SPACING), [material()])
        scene.add("compute energy all pe\nvariable given equal 1e6+c_energy\n"
                  "timestep 1e-8\nthermo 7\n"
                  "fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850 every 10 "
                  f"{words}\n{fix}\n"
                  "run 13\nrun 24")
        run = scene.run(may_fail=True)
        report.true(f"every 10, {words or fix}: energies", not run.failed, "are there")


def books(report):
    """Boundaries that come and go between runs have their own accounts, and the sum has all."""
    scene = heated("", "fix one side tmsph/heat/boundary flux 1e6")
    columns = "step f_heat f_heat[2] f_heat[4] "
    scene.thermo(columns + "f_one[2]", 20).add("run 20\nfix two all tmsph/heat/boundary flux 2e6")
    scene.thermo(columns + "f_one[2] f_two[2]", 20).add(
        "run 20\nunfix one\nfix one side tmsph/heat/boundary flux -1e6\nrun 20\nwrite_restart r")
    run = scene.run(keep="r")
    first, second, third = run.tables
    scale = third["f_heat"][-1]
    for number, table in enumerate(run.tables, 1):
        error = abs(table["f_heat"] - table["f_heat[2]"]).max() / scale
        report.below(f"balance of run {number}", error, 1e-12)
    report.true("a boundary keeps its account", second["f_one[2]"][0] == first["f_one[2]"][-1] > 0
                and third["f_two[2]"][0] == second["f_two[2]"][-1] > 0, "from run to run")
    report.true("a new one starts with none", second["f_two[2]"][0] == 0 == third["f_one[2]"][0],
                "of the same id as well")
    again = Script("read_restart r\nregion side block INF 2.5e-3 INF INF INF INF units box\n"
                   "fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850\n"
                   "fix two all tmsph/heat/boundary flux 2e6\n"
                   "fix one side tmsph/heat/boundary flux -1e6", run.kept)
    again.add(f"thermo_style custom {columns} f_one[2] f_two[2]\n"
              "thermo_modify format float %.17g\nrun 0")
    restarted = again.run().tables[-1]
    for name in restarted:
        report.below(f"{name} after a restart", abs(restarted[name][-1] - third[name][-1]) / scale,
                     1e-14)


def late_contact(report):
    """Bodies have their surfaces from the first run: a contact that comes later is told of it."""
    late = blocks(0.0).add("run 0\nfix touch all tmsph/contact\nrun 0\nwrite_restart r")
    first = late.run(keep="r")
    again = Script("read_restart r\nfix touch all tmsph/contact\nrun 0", first.kept).run()
    early = blocks(0.0).add("fix touch all tmsph/contact\nrun 0\nwrite_restart r").run(keep="r")
    well = Script("read_restart r\nfix touch all tmsph/contact\nrun 0", early.kept).run()
    warning = "touch was defined after the first run"
    report.true("a contact that comes late is told", warning in first.log and warning in again.log,
                "after a restart too")
    report.true("one that comes first is not", warning not in early.log + well.log,
                "after a restart neither")


def balanced(report):
    """fix balance moves particles between processors, not the box: quasi-static steps leave it
    alone."""
    scene = heated("").add("unfix heat\nfix ramp all tmsph/heat/boundary temperature v_T\n"
                           "fix even all balance 10 1.05 shift xy 5 1.05\ntmsph/quasistatic 2")
    report.true("tmsph/quasistatic with fix balance", not scene.run(may_fail=True).failed, "runs")


def without_setup(report):
    """A restart that a run without setup wrote continues to the last bit."""
    fixes = "fix push high addforce 0 -1e4 0\nfix touch all tmsph/contact friction * * 0.4\n" \
        "fix wall all tmsph/wall line 0 0 1e-2 0 friction 0.3\ntimestep 1e-8\n" \
        "thermo_style custom step pe ke f_touch[2] f_wall[2]\n" \
        "thermo_modify norm no format float %.17g\n"
    whole = blocks(0.0).add(f"{fixes}restart 15 *.rst\nrun 10\nrun 10 pre no")
    whole = whole.snapshot("end", "x y vx vy fx fy").run(keep="15.rst")
    rest = Script(f"read_restart 15.rst\nfix 1 all nve\n{fixes}run 5", whole.kept)
    rest = rest.snapshot("end", "x y vx vy fx fy").run()
    ends = [run.frame("end") for run in (whole, rest)]
    report.true("state after a restart from a run without setup",
                all(np.array_equal(ends[0][name], ends[1][name]) for name in ends[0]), "as in one run")
    # what LAMMPS sums up rounds by the order of the arrays
    rounding = len(ends[0]["id"]) * np.finfo(float).eps
    for name in rest.tables[0]:
        last, one = rest.thermo(name)[-1], whole.thermo(name)[-1]
        report.true(f"{name} after a restart from a run without setup",
                    abs(last - one) <= rounding * abs(one), "as in one run")


MIDRUN = (
    ("set group all volume 2e-6", "mass|volume|density"),
    ("set group all mass 5.4e-3", "mass|volume|set mass"),
    ("set group all type 2", "of type 2|mass|density|set type"),
    ("pair_coeff 1 1 elastic 40e9 0.3 density 5400", "mass|density|pair_coeff"),
    ("set group all volume 2e-6\nset group all mass 5.4e-3", "set volume|before the first run"),
    ("pair_coeff 1 3 none", "none' came later|tmsph/cut"))

STARTS = ("run 0", "run 1", "minimize 0 0 1 1", "tmsph/quasistatic 1")


def stretched():
    """A block of type 1 with some of type 3, stretched after a first run; type 2 is denser and
    stiffer."""
    cloud = lattice("square", (8, 6), SPACING)
    cloud.type[cloud.X[:, 1] > 3e-3] = 3
    materials = [material(), material(80e9, density=5400), material()]
    scene = Scene(cloud, materials).add("fix 1 all nve\ntimestep 1e-8\nrun 0\n"
                                        "variable X atom x*1.001\n"
                                        "set group all x v_X")
    return scene


def matter(report):
    """What set and pair_coeff change after the first run agrees at the start of the next one, or is
    refused."""
    for change, words in MIDRUN:
        for start in STARTS:
            run = stretched().add(f"{change}\n{start}").run(may_fail=True)
            error = next((line for line in run.log.splitlines() if line.startswith("ERROR")), "")
            report.true(f"{change.splitlines()[-1]}, then {start}",
                        all(word in error for word in words.split("|")), "an error that names it")
    kept = stretched().add("run 0\nwrite_restart r").run(keep="r").kept
    for change, words in MIDRUN[:4]:
        run = Script(f"read_restart r\nfix 1 all nve\n{change}\nrun 0", kept).run(may_fail=True)
        report.true(f"{change} after a restart", run.failed and "has mass" in run.log, "an error")
    for words in ("", " compress no"):
        run = stretched().add("region some block INF 1.5e-3 INF INF INF INF units box\n"
                              f"delete_atoms region some{words}\nrun 0").run(may_fail=True)
        report.true(f"delete_atoms{words}", not run.failed, "goes on")
    scene = stretched().thermo("step pe").add("run 0\nset group all type 2 mass 5.4e-3\nrun 0\n"
                                              "pair_coeff 2 2 elastic 40e9 0.3 density 5400\nrun 0")
    energies = [table["PotEng"][-1] for table in scene.run().tables[1:]]
    report.below("energy with a stiffer type and its mass", abs(energies[1] / energies[0] - 2),
                 1e-12)
    report.below("energy with other elastic constants", abs(energies[2] / energies[0] - 1), 1e-12)


if __name__ == "__main__":
    main(matter, forget_contact, meet_after_reset, leave_the_group, leave_the_wall,
         delete_far_away, plane, late_contact, balanced, without_setup, order_of_boundaries,
         energies_in_variables, books)
