# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A ring (a shell in 3-D) of rock flies apart: it breaks into fragments down to single particles,
which touch with friction and without. What bodies exert on each other is all there is: momentum
and angular momentum stay to round-off at every step, in the midst of contacts, the energy never
rises above the first one, and any number of processors counts the same breaks. So it is when two
rough balls that spin rub on each other. In the midst of that particles may get new ids."""

import numpy as np

from tmsph_testing import Cloud, Scene, Script, lattice, main, material

FLOOR = "fix floor all tmsph/wall line 0 -0.02 1 -0.02 friction 0.3"
SPACING, ROCK = 1e-3, material(40e9, 0.25, 2700.0)
KEPT = 1e-10         # of angular momentum, in units of mass times speed times radius
ENERGY = 1 + 1e-3    # largest/first


def breaking(dimension, friction, speed, steps):
    """A ring with radial velocity; also with some spin, so that its angular momentum is not 0."""
    two = dimension == 2
    middle, width = (0.0225, 0.005) if two else (0.0055, 0.003)
    cells = (52, 30) if two else (16,) * 3
    cloud = lattice("hex" if two else "sc", cells, SPACING, centre=True).kept(
        lambda X: np.abs(np.linalg.norm(X, axis=1) - middle) <= 0.5 * width)
    scene = Scene(cloud, [ROCK], "viscosity 1 2 hourglass 0.5")
    scene.lines[2] = scene.lines[2].replace(" s", " f")
    scene.add("change_box all x final -0.06 0.06 y final -0.06 0.06"
              + ("" if two else " z final -0.06 0.06"))
    radius = np.linalg.norm(cloud.X, axis=1)[:, None]
    v = np.zeros((len(cloud), 3))
    v[:, :dimension] = speed * cloud.X / radius
    v[:, 0] -= 0.2 * speed * cloud.X[:, 1] / middle
    v[:, 1] += 0.2 * speed * cloud.X[:, 0] / middle
    scene.set("vx vy vz", v)
    scene.add(f"{styles(friction)}\ntimestep 4e-8")
    return scene, middle * speed, steps


def styles(friction):
    return ("fix hb all tmsph/hoekbrown strength * 100e6 mi * 8 weibull * 10 77\n"
            f"fix touch all tmsph/contact friction * * {friction}\nfix move all nve")


def spinning(friction, steps):
    """Two balls that spin alike, pressed together: their surfaces move against each other."""
    radius, speed = 0.0045, 20.0
    ball = lattice("sc", (12,) * 3, SPACING, centre=True).kept(
        lambda X: np.linalg.norm(X, axis=1) <= radius)
    apart = np.array([2 * radius + 0.8 * SPACING, 0.3 * SPACING, 0.2 * SPACING])
    cloud = Cloud(np.concatenate([ball.X - 0.5 * apart, ball.X + 0.5 * apart]), SPACING**3, SPACING)
    cloud.type = np.repeat([1, 2], len(ball))
    scene = Scene(cloud, [material(10e6, 0.2, 1000.0)] * 2).add("pair_coeff 1 2 none")
    scene.lines[2] = scene.lines[2].replace(" s", " f")
    scene.add("change_box all x final -0.03 0.03 y final -0.03 0.03 z final -0.03 0.03")
    centre = np.where(cloud.type[:, None] == 1, -0.5, 0.5) * apart
    v = np.cross([0, 0.3 * speed / radius, speed / radius], cloud.X - centre)
    v -= 0.1 * speed * centre / np.linalg.norm(centre, axis=1)[:, None]
    scene.set("vx vy vz", 0.2 * v)
    scene.add(f"fix touch all tmsph/contact friction * * {friction}\nfix move all nve\n"
              "timestep 2e-6")
    return scene, 0.2 * speed * radius, steps


def check(report, what, made, breaks=0):
    runs = []
    for ranks in (1, 4):
        scene, scale, steps = made()
        scene.add("fix_modify touch energy yes")
        for axis in "xyz":
            scene.add(f"variable p{axis} equal vcm(all,{axis})\n"
                      f"variable l{axis} equal angmom(all,{axis})")
        names = "v_px v_py v_pz v_lx v_ly v_lz"
        broken = " f_hb" if breaks else ""
        scene.thermo(f"step etotal f_touch[7] f_touch[8] {names}{broken}", steps // 40)
        runs.append(scene.add(f"run {steps}").run(ranks))
    one, four = runs
    columns = [np.stack([run.thermo(name) for name in names.split()], axis=1) for run in runs]
    mass = sum(scene.cloud.volume) * (2700.0 if breaks else 1000.0)
    speed = scale / (np.linalg.norm(scene.cloud.X, axis=1).mean())
    for ranks, run, kept in zip((1, 4), runs, columns):
        change = np.abs(kept - kept[0]).max(axis=0)
        report.below(f"{what}, on {ranks}: change of velocity/speed", change[:3].max() / speed,
                     KEPT)
        report.below(f"{what}, on {ranks}: change of angular momentum/(m v r)",
                     change[3:].max() / (mass * scale), KEPT)
        energy = run.thermo("TotEng")
        report.below(f"{what}, on {ranks}: largest energy/the first", energy.max() / energy[0],
                     ENERGY)
    report.above(f"{what}: most pairs that press", one.thermo("f_touch[8]").max(), 20)
    if breaks:
        report.above(f"{what}: broken bonds", one.thermo("f_hb")[-1], breaks)
        report.below(f"{what}: broken bonds, 4 processors less 1",
                     abs(four.thermo("f_hb") - one.thermo("f_hb")).max(), 1)
    else:
        report.above(f"{what}: work of friction/energy",
                     one.thermo("f_touch[7]")[-1] / one.thermo("TotEng")[0], 1e-3)


def numbered_anew(report, what, made, wall=""):
    """In the midst of contacts, with which end has the lower id changed: all goes on as it was, but
    for the order of sums, 1e-16 of each, which contacts amplify by the ratio of strains and
    penetrations, below 1e-3, to stresses."""
    ends = []
    for change in ("", "reset_atoms id sort yes"):
        scene, _, steps = made()
        scene.thermo("step f_touch[8]").add(f"{wall}\ncompute place all tmsph/property/atom x0 y0 z0")
        scene.add(f"run {steps}\n{change}\nrun 20")
        run = scene.snapshot("end", "id x y z vx vy vz fx fy fz c_place[*]").run(2)
        ends.append(run.frame("end"))
    place = [np.lexsort(end("c_place[1] c_place[2] c_place[3]").T) for end in ends]
    moved = np.count_nonzero(ends[0]["id"][place[0]] != ends[1]["id"][place[1]])
    report.above(f"{what}: pairs that press", run.thermo("f_touch[8]")[0], 20)
    report.above(f"{what}: particles with new ids", moved, 0.5 * len(place[0]))
    for words in ("x y z", "vx vy vz", "fx fy fz"):
        a, b = (end(words)[order] for end, order in zip(ends, place))
        report.below(f"{what}: {words} after reset_atoms id", np.abs(a - b).max() / np.abs(a).max(), 1e-9)


def resumed(report, ranks):
    """From a restart file that is written before the bonds could follow the new ids."""
    scene, _, steps = breaking(2, 0.5, 15.0, 700)
    scene.add(f"{FLOOR}\nrun {steps}\nreset_atoms id sort yes\nwrite_restart r\nrun 20")
    whole = scene.snapshot("end", "x y z vx vy vz fx fy fz").run(ranks, keep="r")
    rest = Script(f"read_restart r\n{styles(0.5)}\n{FLOOR}\nrun 20", whole.kept)
    rest = rest.snapshot("end", "x y z vx vy vz fx fy fz").run(ranks)
    report.true(f"new ids in a restart file, on {ranks}",
                all(np.array_equal(column, rest.frame("end")[name])
                    for name, column in whole.frame("end").items()), "goes on with the same bits")


def new_ids(report):
    for ranks in (1, 2):
        resumed(report, ranks)
    numbered_anew(report, "ring and wall", lambda: breaking(2, 0.5, 15.0, 700), FLOOR)
    numbered_anew(report, "shell", lambda: breaking(3, 0.5, 15.0, 200))
    numbered_anew(report, "spinning balls", lambda: spinning(0.0, 300))


def rings(report):
    for friction in (0.5, 0.0):
        check(report, f"ring, friction {friction}", lambda: breaking(2, friction, 15.0, 1200), 5000)


def shell(report):
    check(report, "shell, friction 0.5", lambda: breaking(3, 0.5, 15.0, 300), 1000)


def balls(report):
    check(report, "spinning balls", lambda: spinning(0.5, 400))


if __name__ == "__main__":
    main(rings, shell, balls, new_ids)
