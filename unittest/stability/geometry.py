# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Arrangements of particles that cannot tell strains apart, or hardly."""

import numpy as np

from bodies import (E, ROCK, SPACING, Copy, blocks, law_stress, roomy, sheared, stated_step,
                    stresses, stretched, wave_speed)
from cases import GOOD, Found, case, last_of, marching
from tmsph_testing import Cloud, Scene, lattice, material

C = wave_speed(ROCK)
DT = 0.2 * SPACING / C
# leapfrog lets the energy of a mode swing by (w dt)^2/4 = (dt/stable)^2
SWING = (0.2 / 1.2) ** 2


def with_extra(cloud, extra):
    """A block and particles far from it, in spacings from the corner of the block."""
    d = cloud.dimension
    far = cloud.X.max(axis=0) + np.eye(d)[0] * 20 * SPACING
    X = far + np.asarray(extra, float)[:, :d] * SPACING
    return Cloud(np.vstack([cloud.X, X]), cloud.volume[0], SPACING), len(cloud)


def rows(n):
    return [(i, 0, 0) for i in range(n)]


def plane_rows(n):
    return [(i, j, 0) for i in range(n) for j in range(n)]


@case("collinear and coplanar families",
      "beside a block: lines of 2 to 8 particles, planes of 2 x 2 to 4 x 4 in 3-D, a line turned "
      "by 30 degrees, and one bent by 1e-6 to 0.3 spacings; random velocities of 0.01 of the wave "
      "speed",
      "straight and flat ones carry no stress; the energy is kept to (dt/stable step)^2, 3 %",
      level="test")
def families(bench):
    good, texts = True, []
    turn = np.array([[0.75**0.5, -0.5, 0], [0.5, 0.75**0.5, 0], [0, 0, 1]])
    for what, cloud in blocks(small=True).items():
        shapes = {f"line of {n}": rows(n) for n in (2, 3, 4, 8)}
        shapes["turned line"] = (np.array(rows(8)) @ turn.T).tolist()
        if what == "3-D":
            shapes |= {f"plane of {n}": plane_rows(n) for n in (2, 3, 4)}
            shapes["turned plane"] = (np.array(plane_rows(4)) @ turn.T @ turn[[2, 0, 1]]).tolist()
        flat = list(shapes)
        for bend in (1e-6, 1e-3, 0.03, 0.1, 0.3):
            shapes[f"bent by {bend:g}"] = [(i, bend * (i % 2), bend * (i % 3)) for i in range(8)]
        for name, extra in shapes.items():
            body, n = with_extra(cloud, extra)
            v = np.random.default_rng(1).uniform(-0.01 * C, 0.01 * C, body.X.shape)
            scene = Scene(body, [ROCK]).set("vx vy vz"[: 3 * body.dimension - 1], v)
            run = bench.run(scene.thermo("step etotal", 1), f"{what}, {name}", marching(DT, 200),
                            every=50)
            good &= run.end in GOOD
            if not run.ok:
                continue
            energy = run.run.thermo("TotEng")
            swing = run.measured(np.abs(energy / energy[0] - 1).max())
            good &= swing < SWING
            if name in flat:
                good &= np.abs(stresses(run.run.frame("final"), body.dimension)[n:]).max() == 0
        texts.append(f"{len(shapes)} shapes ({what})")
    return Found(", ".join(texts), "not reached", good)


@case("isolated particles",
      "1 to half as many as the block has, and more than the block; with heat, breaking, contact",
      "fly on in a straight line to 1e-12, keep their temperature; more than the block: refused",
      level="test")
def isolated(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        runs = {}
        for share in (0, 0.25, 0.9, 1.5):
            count = max(1, int(share * len(cloud)))
            body, n = with_extra(cloud, [(5 * i, 0, 0) for i in range(count)])
            v = np.zeros_like(body.X)
            v[n:, 1] = 0.01 * C
            scene = Scene(body, [ROCK], "viscosity 1 2", temperature=np.arange(len(body)) * 1.0)
            scene.set("vx vy", v[:, :2])
            scene.add("fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850\n"
                      "fix air all tmsph/heat/boundary convection 10 0\n"
                      "fix rock all tmsph/hoekbrown strength * 1e8 mi * 8\n"
                      "fix touch all tmsph/contact")
            run = bench.run(scene, f"{what}, {count}", marching(DT, 200), every=100)
            runs[count] = run.ok
            if run.ok:
                frame = run.run.frame("final")
                away = frame["y"][n:] - body.X[n:, 1] - 200 * DT * 0.01 * C
                good &= run.measured(np.abs(away).max() / SPACING) < 1e-12
                kept = np.abs(frame["c_watch[7]"][n:] - np.arange(len(body))[n:]).max()
                good &= kept == 0.0
            good &= run.ok == (share < 1) and run.end in GOOD
        texts.append(f"{last_of(runs)} beside {len(cloud)} ({what})")
    return Found(", ".join(texts), "refused: the horizon is named", good)


@case("single particle and empty box",
      "no particle, 1, 2 and 3 particles in all, with and without all fixes",
      "runs, or refused; ends", level="test")
def almost_nothing(bench):
    good, texts = True, []
    fixes = ("fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850\n"
             "fix rock all tmsph/hoekbrown strength * 1e8 mi * 8\nfix touch all tmsph/contact")
    for what, block in blocks(small=True).items():
        d = block.dimension
        for count in (0, 1, 2, 3):
            cloud = Cloud(np.array(rows(max(count, 1)), float)[:, :d] * SPACING, SPACING**d,
                          SPACING)
            for more in ("", fixes):
                scene = roomy(Scene(cloud, [ROCK], "viscosity 1 2"))
                if not count:
                    scene.add("delete_atoms group all")
                scene.add(more)
                for commands in (marching(DT, 20), "minimize 0 1e-6 10 100",
                                 "timestep 1\ntmsph/quasistatic 3"):
                    run = bench.run(scene, f"{what}, {count}, {'fixes' if more else 'bare'}, "
                                    f"{commands.split()[0]}", commands, every=10)
                    good &= run.end in GOOD
        texts.append(what)
    return Found("ends with all, " + ", ".join(texts), "refused where no strain can be told", good)


@case("needles",
      "bars of 1, 2, 3 particles across (1 x 1 to 3 x 3 in 3-D) and 30 along, stretched by 1e-4, "
      "and then let go",
      "2 and more: stress of the law within 1e-6, energy kept to (dt/stable step)^2, 3 %; 1: no "
      "stress, and a warning", level="test")
def needles(bench):
    good, texts = True, []
    m = material(E, 0.0)
    for d in (2, 3):
        for across in (1, 2, 3):
            cells = (30, across) + ((across,) if d == 3 else ())
            cloud = lattice("square" if d == 2 else "sc", cells, SPACING, centre=True)
            F = stretched(d, 1 + 1e-4)
            scene = roomy(Scene(cloud, [m])).add("run 0").move(cloud.X @ F.T)
            scene.thermo("step etotal", 1)
            run = bench.run(scene, f"{d}-D, {across}", marching(0.5 * DT, 500), every=500)
            good &= run.end in GOOD
            if across == 1:
                good &= run.ok and "carry no stress" in run.run.log
                good &= np.abs(stresses(run.run.frame("final"), d)).max() == 0
                continue
            good &= run.ok
            if run.ok:
                s = stresses(run.run.dumps["watch"][0], d)[:, 0, 0]
                exact = law_stress(F, m)[0, 0]
                energy = run.run.thermo("TotEng")
                error = run.measured(np.abs(s / exact - 1).max())
                good &= error < 1e-6 and np.abs(energy / energy[0] - 1).max() < SWING
        texts.append(f"{d}-D")
    return Found("2 across, " + ", ".join(texts), "1 across: no stress, warned", good)


@case("thin sheet in 3-D",
      "20 x 20 particles in one layer, and in two; bent over a wave of 1e-3 to 1 spacings and let "
      "go, beside a block",
      "one layer: no stress; two: energy kept to (dt/stable step)^2, 3 %")
def sheet(bench):
    good, texts = True, []
    block = lattice("sc", (8, 8, 7), SPACING)
    for layers in (1, 2):
        extra = [(i, j, k) for i in range(20) for j in range(20) for k in range(layers)]
        cloud, n = with_extra(block, extra[: len(block) - 1] if layers == 1 else extra)
        holds = {}
        for bend in (1e-3, 0.1, 0.3, 1.0):
            X = cloud.X.copy()
            X[n:, 2] += bend * SPACING * np.sin(2 * np.pi * (X[n:, 0] - X[n, 0]) / (20 * SPACING))
            scene = Scene(cloud, [ROCK]).add("run 0").move(X).thermo("step etotal", 1)
            run = bench.run(scene, f"{layers} layers, {bend:g}", marching(DT, 300), every=100)
            holds[bend] = run.ok
            good &= run.end in GOOD
            if run.ok and layers == 2:
                energy = run.run.thermo("TotEng")
                holds[bend] = run.measured(np.abs(energy / energy[0] - 1).max()) < SWING
                good &= holds[bend]
            elif run.ok:
                good &= np.abs(stresses(run.run.frame("final"), 3)[n:]).max() == 0
                good &= "carry no stress" in run.run.log
        texts.append(f"{layers}: {last_of(holds)}")
    return Found("spacings: " + ", ".join(texts), "one layer has no stiffness of its own: warned",
                 good)


@case("hole of one particle",
      "a block with one particle missing in the middle, and with every third one "
      "missing, stretched "
      "and sheared by 0.01",
      "the homogeneous state is exact: stress to 1e-10, as without holes", level="test")
def hole(bench):
    good, worst = True, 0.0
    for what, cloud in blocks(small=True).items():
        d = cloud.dimension
        middle = np.argmin(np.linalg.norm(cloud.X, axis=1))
        for name, gone in {"one": np.arange(len(cloud)) == middle,
                           "every third": np.arange(len(cloud)) % 3 == 1}.items():
            part = cloud.kept(lambda X: ~gone)
            part.volume[:] = cloud.volume[0]
            for F in (stretched(d, 1.01), sheared(d, 0.01)):
                run = bench.run(Scene(part, [ROCK]).add("run 0").move(part.X @ F.T),
                                f"{what}, {name}, {F[0, 0]:g}", "run 0")
                if not run.ok:
                    good = False
                    continue
                exact = law_stress(F, ROCK)
                error = np.abs(stresses(run.run.frame("final"), d) - exact).max()
                worst = max(worst, run.measured(error / np.abs(exact).max()))
    return Found(f"error {worst:.0e}", "not reached", good and worst < 1e-10)


@case("duplicate particles",
      "two particles of a block 0 to 0.5 spacings apart, the block with velocities of 0.001 of the "
      "wave speed",
      "at the same place: refused, with both; apart: with half the stable step the "
      "energy swings by "
      "at most (1/2)^2")
def duplicates(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        holds, middle = {}, np.argmin(np.linalg.norm(cloud.X, axis=1))
        for apart in (0.0, 1e-300, 1e-12, 1e-6, 1e-3, 0.1, 0.5):
            near = cloud.X[middle] + np.eye(cloud.dimension)[1] * apart * SPACING
            body = Cloud(np.vstack([cloud.X, near]), cloud.volume[0], SPACING)
            v = np.random.default_rng(1).uniform(-1e-3 * C, 1e-3 * C, body.X.shape)
            scene = Scene(body, [ROCK]).set("vx vy vz"[: 3 * body.dimension - 1], v)
            scene.thermo("step etotal", 1)
            stated = None if near.tolist() == cloud.X[middle].tolist() else stated_step(
                bench, f"{what}, {apart:g}, stated", Copy(scene, body).add("run 0"))
            run = bench.run(scene, f"{what}, {apart:g}", marching(0.5 * (stated or DT), 200),
                            every=50)
            if stated is None:
                good &= run.end == "stopped" and "same place" in run.message
                continue
            holds[apart] = run.ok
            if run.ok:
                energy = run.run.thermo("TotEng")
                holds[apart] = run.measured(np.abs(energy / energy[0] - 1).max()) < 0.25
            good &= holds[apart]
        texts.append(f"{min(holds, key=lambda a: (not holds[a], a)):g} ({what})")
    return Found("spacings apart: " + ", ".join(texts), "the same place: refused, both are named",
                 good)


@case("periodic box of two horizons",
      "a periodic box of 2.5 to 0.8 times two horizons, 2-D and 3-D, on 1 and 2 processors",
      "from two horizons on: runs, noise keeps its energy to (dt/stable step)^2, 3 %; "
      "below: refused")
def periodic(bench):
    good, texts = True, []
    for d in (2, 3):
        horizon, holds = 1.5, {}
        for cells in (8, 7, 6, 4, 3, 2):    # 2 horizons are 3 spacings
            shape = (cells,) * d
            cloud = lattice("square" if d == 2 else "sc", shape, SPACING, "xyz"[:d])
            v = np.random.default_rng(1).uniform(-1e-3 * C, 1e-3 * C, cloud.X.shape)
            for ranks in (1, 2):
                scene = Scene(cloud, [ROCK], "hourglass 0.3", horizon=horizon)
                scene.set("vx vy vz"[: 3 * d - 1], v).thermo("step etotal", 1)
                run = bench.run(scene, f"{d}-D, {cells}, {ranks} processors", marching(DT, 200),
                                every=100, ranks=ranks)
                held = run.ok
                if run.ok:
                    energy = run.run.thermo("TotEng")
                    held = run.measured(np.abs(energy / energy[0] - 1).max()) < SWING
                holds[cells] = holds.get(cells, True) and held
                good &= held if cells >= 3 else run.end == "stopped"
        texts.append(f"{last_of(holds) / (2 * horizon):.2f} ({d}-D)")
    return Found("of two horizons: " + ", ".join(texts), "refused", good)


@case("bad clouds of heat",
      "heat on needles, lines, holes, a duplicate 1e-3 apart, jitter 40 %, volumes 1:100; random "
      "temperatures 0 to 1, convection at 1",
      "no temperature below 0 or above 1 by 1e-9; heat kept to 1e-10", level="test")
def heated(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        d = cloud.dimension
        random = np.random.default_rng(4)
        line, _ = with_extra(cloud, rows(8))
        close = Cloud(np.vstack([cloud.X, cloud.X[:1] + 1e-3 * SPACING]), cloud.volume[0], SPACING)
        holes = cloud.kept(lambda X: np.arange(len(X)) % 3 != 1)
        holes.volume[:] = cloud.volume[0]
        shaken = Cloud(cloud.X, cloud.volume[0], SPACING).jitter(0.4, 7)
        uneven = Cloud(cloud.X, cloud.volume[0], SPACING)
        uneven.volume = cloud.volume[0] * 10 ** random.uniform(-1, 1, len(cloud))
        needle = lattice("square" if d == 2 else "sc", (30, 2, 2)[:d], SPACING)
        for name, body in {"line": line, "duplicate": close, "holes": holes, "jitter": shaken,
                           "volumes": uneven, "needle": needle}.items():
            scene = Scene(body, [ROCK], temperature=random.uniform(0, 1, len(body)))
            scene.add("fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850 "
                      "time/scale 1e9\nfix air all tmsph/heat/boundary convection 1000 1")
            scene.thermo("step f_heat f_heat[2]", 1)
            run = bench.run(scene, f"{what}, {name}", "timestep 1e-9\nrun 20", every=1)
            good &= run.ok
            if run.ok:
                T = np.array([frame["c_watch[7]"] for frame in run.run.dumps["watch"]])
                content = run.run.thermo("f_heat") - run.run.thermo("f_heat[2]")
                run.measured(max(T.max() - 1, -T.min()))
                good &= T.min() > -1e-9 and T.max() < 1 + 1e-9
                good &= np.ptp(content) < 1e-10 * np.abs(run.run.thermo("f_heat")).max()
        texts.append(what)
    return Found("6 clouds, " + ", ".join(texts), "not reached", good)
