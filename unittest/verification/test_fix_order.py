# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Walls and contact act after all other forces, wherever the input defines them: the same bits for
every place of the package's fixes among LAMMPS's own. Those keep their order, which has a meaning
in LAMMPS, as sums of floating-point numbers have."""

import random

import numpy as np

from tmsph_testing import Cloud, Scene, Script, lattice, main, material

SPACING = 1e-3


def blocks(dimension):
    """A block on a wider one, both pushed into a corner of two walls; steps of 20 ns."""
    cells, lattice_name = ((8, 5), "square") if dimension == 2 else ((5, 4, 4), "sc")
    up = dimension - 1
    low = lattice(lattice_name, cells, SPACING)
    high = lattice(lattice_name, tuple(n - 1 for n in cells), SPACING)
    shift = np.zeros(dimension)
    shift[up] = cells[up] * SPACING
    cloud = Cloud(np.concatenate([low.X, high.X + shift]), SPACING**dimension, SPACING)
    cloud.type[len(low):] = 2
    scene = Scene(cloud, [material(expansion=1e-5)] * 2, pair="viscosity 1 2", temperature=20.0)
    scene.add("pair_coeff 1 2 none\ngroup high type 2\ntimestep 2e-8\nfix move all nve\n"
              "variable seen equal f_floor[7]+f_touch[7]+f_floor[2]")
    return scene


def others(dimension):
    """Fixes of LAMMPS that act on forces, in an order that is kept."""
    flat = ["fix flat all enforce2d"] if dimension == 2 else []
    down = "vector -0.5 -1 0" if dimension == 2 else "vector -0.5 0 -1"
    return [f"fix weight all gravity 2e6 {down}",
            f"fix push high addforce {SPACING**dimension * 1e9:g} 0 0",
            f"fix drag all viscous {2700 * SPACING**dimension * 1e5:g}"] + flat


def ours(dimension):
    floor, side = ("line 0 0 1 0", "line 0 1 0 -1") if dimension == 2 \
        else ("plane 0 0 0 0 0 1", "plane 0 0 0 1 0 0")
    return [f"fix floor all tmsph/wall {floor} friction 0.3",
            f"fix side all tmsph/wall {side} friction 0.5",
            "fix touch all tmsph/contact friction * * 0.4",
            "fix rock all tmsph/hoekbrown strength * 3e7 mi * 8",
            "fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850 time/scale 1e3",
            "fix hot all tmsph/heat/boundary convection 1e5 400",
            "fix mean all ave/time 1 1 1 v_seen file mean.txt"]


def mixed(dimension, seed, more=()):
    """All fixes; LAMMPS's own stay in their order. Seed 0: walls and contact last, as once was a
    must."""
    if seed == 0:
        first = ours(dimension)
        return first[3:6] + others(dimension) + list(more) + [first[2], first[0], first[1],
                                                              first[6]]
    draw = random.Random(seed)
    fixes = ours(dimension)
    draw.shuffle(fixes)
    at = 0
    for fix in others(dimension):
        at = draw.randint(at, len(fixes))
        fixes.insert(at, fix)
        at += 1
    return fixes


COLUMNS = ("step pe ke f_floor[1] f_floor[2] f_floor[7] f_side[1] f_touch[2] f_touch[7] "
           "f_rock f_heat v_seen")


def outcome(scene, keep="mean.txt"):
    scene.dump("end", "x y z vx vy vz fx fy fz",
               every=1000000).snapshot("end", "x y z vx vy vz fx fy fz")
    run = scene.run(keep=keep)
    end = run.frame("end")
    return run, (end("x y z vx vy vz fx fy fz").tobytes(),
                 [sorted((k, v.tobytes()) for k, v in t.items())
                  for t in run.tables], run.kept.get("mean.txt"))


def alike(report, what, make, seeds, moved):
    """make(seed) is a scene; moved(run): it tests something."""
    run, reference = outcome(make(0))
    report.true(f"{what}: walls rub, surfaces touch", moved(run), "so that the order could matter")
    for seed in seeds:
        report.true(f"{what}, order {seed}", outcome(make(seed))[1] == reference, "same bits")


def rubs(run):
    return run.thermo("f_floor[7]")[-1] > 0.0 and run.thermo("f_touch[2]")[-1] != 0.0 \
        and run.thermo("f_side[1]")[-1] != 0.0


def touches(run):
    return run.thermo("f_floor[2]").any() and run.thermo("f_touch[2]").any()


def dynamics(dimension):
    def make(seed):
        scene = blocks(dimension).add("\n".join(mixed(dimension, seed)))
        return scene.thermo(COLUMNS, 20).add("run 200")
    return make


def between_runs(seed):
    """A force that comes between two runs, and a wall that is defined anew; seed 0: from the
    start."""
    scene = blocks(2)
    late = "fix late high addforce 0 -2e3 0"
    scene.add("\n".join(mixed(2, seed, [late.replace("-2e3", "0")])))
    return scene.thermo(COLUMNS, 20).add(f"run 60\n{late}\nrun 60")


def equilibrium(command):
    def make(seed):
        fixes = "\n".join(mixed(2, seed)).replace("friction 0.3", "").replace("friction 0.5", "")
        push = others(2)[1]
        scene = blocks(2).add(fixes.replace(push, "fix push all addforce -200 -200 0"))
        return scene.thermo(COLUMNS, 5).add("min_style tmsph/lbfgs\n" + command)
    return make


def restarts(report):
    state = "x y vx vy fx fy"
    whole = dynamics(2)(0).add("run 40").snapshot("end", state).run()
    for seed in (1, 2):
        first = blocks(2).add("\n".join(mixed(2, seed))).thermo(COLUMNS, 20)
        first = first.add("run 200\nwrite_restart r").run(keep="r")
        rest = Script("read_restart r\ngroup high type 2\ntimestep 2e-8\nfix move all nve\n"
                      "variable seen equal f_floor[7]+f_touch[7]+f_floor[2]\n"
                      + "\n".join(mixed(2, seed + 7)), first.kept)
        rest.add(f"thermo_style custom {COLUMNS}\nthermo_modify norm no format float %.17g\n"
                 "thermo 20\nrun 40")
        rest = rest.snapshot("end", state).run()
        table = rest.tables[0]
        # LAMMPS sums the kinetic energy in the order of the arrays
        rounding = {"KinEng": len(blocks(2).cloud) * np.finfo(float).eps}
        same = all(abs(table[name][-1] - whole.thermo(name)[-1])
                   <= rounding.get(name, 0.0) * abs(table[name][-1]) for name in table)
        same = same and np.array_equal(rest.frame("end")(state), whole.frame("end")(state))
        report.true(f"restart in order {seed + 7} of a run in order {seed}", same, "same bits")


def held(dimension, more=""):
    """A block falls on the top rows of another, which are held by fix setforce."""
    speed = ["1"] * (dimension - 1) + ["-5"]
    top = {2: 5, 3: 4}[dimension] - 1.1

    def make(seed):
        low = " ".join(["INF INF"] * (dimension - 1) + [f"{top * SPACING} INF"]
                       + ["INF INF"] * (3 - dimension))
        velocity = " ".join(speed[:dimension] + ["NULL"] * (3 - dimension))
        scene = blocks(dimension).add(f"region above block {low} units box\n"
                                      "group above region above\n"
                                      "group low type 1\ngroup top intersect above low\n"
                                      f"velocity high set {velocity}")
        fixes = ["fix hold top setforce 0 0 0", "fix touch all tmsph/contact friction * * 0.4",
                 "fix drag all viscous 1e-9"] + ([more] if more else [])
        order = [fixes[0], fixes[1], fixes[2]] if seed % 2 else [fixes[1], fixes[2], fixes[0]]
        scene.add("\n".join(order + fixes[3:]))
        scene.add("compute f all reduce sum fx fy fz\ncompute all all reduce sum vx vy vz\n"
                  "compute v top reduce maxabs vx vy vz")
        return scene.thermo("step f_touch[8] f_hold[*] c_f[*] c_v[*] c_all[*]", 20).add("run 100")
    return make


def stays(report, dimension):
    """What fix setforce holds does not move under contact; the fix tells the whole force on it."""
    table = outcome(held(dimension)(1))[0].tables[-1]
    columns = lambda name: np.array([table[f"{name}[{k}]"] for k in (1, 2, 3)])
    report.true(f"{dimension}-D: the held rows are touched", table["f_touch[8]"][-1] > 0,
                "so that they could move")
    report.true(f"{dimension}-D: held rows stay", not columns("c_v").any(), "exactly")
    whole = np.abs(columns("f_hold") + columns("c_f") + 1e-9 * columns("c_all")).max()
    report.below(f"{dimension}-D: force of fix setforce less that on all particles, and the drag",
                 whole / np.abs(columns("f_hold")).max(), 1e-10)
    pushed = outcome(held(dimension, "fix push top addforce 1 0 0")(1))[0].tables[-1]
    report.true(f"{dimension}-D: a force after it acts", (pushed["c_v[1]"][1:] > 0).all(),
                "as in LAMMPS")


def in_2d(report):
    alike(report, "2-D", dynamics(2), (1, 2, 3, 4, 5, 6), rubs)


def in_3d(report):
    alike(report, "3-D", dynamics(3), (1, 2), rubs)


def forces_held(report):
    for d in (2, 3):
        alike(report, f"{d}-D, held", held(d), (1, 2),
              lambda run: run.thermo("f_touch[8]")[-1] > 0.0)
        stays(report, d)


def forces_between_runs(report):
    alike(report, "a force that comes between runs", between_runs, (1, 2), rubs)


def minima(report):
    alike(report, "minimize", equilibrium("minimize 0 0 20 40"), (1, 2), touches)


def quasistatic(report):
    alike(report, "quasi-static", equilibrium("tmsph/quasistatic 3 evaluations 3000"), (1, 2),
          touches)


if __name__ == "__main__":
    main(in_2d, in_3d, forces_held, forces_between_runs, minima, quasistatic, restarts)
