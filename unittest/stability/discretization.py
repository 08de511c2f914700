# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Clouds of particles and the options that act on them: hourglass control, kernels and horizons,
jitter, volumes, thickness."""

import numpy as np

from bodies import (E, ROCK, SPACING, beams, bending_error, blocks, law_stress, noise, stated_step,
                    stresses, wave_speed)
from cases import COLUMNS, FIELDS, Found, case, marching
from tmsph_testing import HORIZON, Cloud, Scene, lattice, material

BENDING = "bending stress of a bar, 12 rows in 2-D, 8 in 3-D"


def vibration(bench, value, cloud, m, pair="", share=0.98, steps=1500, horizon=HORIZON):
    """Largest kinetic energy in the last quarter of a run over that in the first, of a block that
    vibrates at a share of its stable time step; infinite if lmp stops. The block starts with a
    smooth motion of 1e-3 of the wave speed and with noise of a tenth of that."""
    scene = Scene(cloud, [m], pair, horizon=horizon).add("run 0")
    stable = stated_step(bench, f"{value}, stable step", scene)
    X = cloud.X - cloud.X.mean(axis=0)
    waves = np.sin(np.pi * X / np.ptp(X, axis=0)) + 0.1 * noise(cloud, 1) / cloud.spacing
    scene.set("vx vy vz"[: 3 * cloud.dimension - 1], 1e-3 * wave_speed(m) * waves)
    scene.thermo("step ke", 10)
    run = bench.run(scene, f"{value}, {share} of it", marching(share * stable, steps),
                    every=steps // 4)
    if not run.ok:
        return np.inf
    energy = run.run.thermo("KinEng", 1)
    quarter = len(energy) // 4
    return run.measured(energy[-quarter:].max() / energy[:quarter].max())


def some_strain(dimension):
    """A gradient with strains and rotations of up to 0.1."""
    return np.eye(dimension) + 0.1 * np.random.default_rng(2).uniform(-1, 1, (dimension,) * 2)


@case("hourglass", "coefficient 0 to 100",
      f"{BENDING}: no more than 1.5 times as wrong as with "
      "0.1, from "
      "0.01 to 0.5; vibrations do not grow at 0.98 of the stable step")
def hourglass(bench):
    texts, good = [], True
    for what, cloud in beams().items():
        error = {z: bending_error(bench, f"{what}, {z}", cloud, ROCK, f"hourglass {z}")
                 for z in (0, 0.001, 0.01, 0.1, 0.3, 0.5, 1, 3, 10, 100)}
        good &= all(error[z] < 1.5 * error[0.1] for z in (0.01, 0.1, 0.3, 0.5))
        usable = [z for z, e in error.items() if e < 1.5 * error[0.1]]
        body = blocks(small=True)[what]
        growths = {z: vibration(bench, f"{what}, {z}", body, ROCK, f"hourglass {z}")
                   for z in (0, 0.1, 1, 100)}
        good &= max(growths.values()) < 2
        texts.append(f"{min(usable)} to {max(usable)} ({what}); "
                     + ", ".join(f"{100 * e:.0f} %" for e in error.values()))
    return Found(f"error within 1.5 of that at 0.1 from {'; '.join(texts)} at 0, 0.001, ... 100",
                 "bounded: too stiff in bending, and a shorter stable step", good)


@case("hourglass patterns", "checkerboards of 1e-3 spacings, hourglass 0 to 1",
      "they have energy and oscillate if the coefficient is above 0, without growth; with 0 they "
      "neither grow nor feel a force inside", level="test")
def patterns(bench):
    good, stiff = True, []
    for what, cloud in {"2-D": lattice("square", (8, 8), SPACING, "xy"),
                        "3-D": lattice("sc", (8, 8, 8), SPACING, "xyz")}.items():
        sign = (-1.0) ** np.rint(cloud.X / SPACING - 0.5).sum(axis=1)
        X = cloud.X.copy()
        X[:, 0] += 1e-3 * SPACING * sign
        for z in (0.0, 0.1, 1.0):
            scene = Scene(cloud, [ROCK], f"hourglass {z}").add("run 0").move(X)
            scene.thermo("step etotal", 10)
            run = bench.run(scene, f"{what}, {z}", marching(0.4 * SPACING / wave_speed(ROCK), 1000))
            if not run.ok:
                return Found(f"{what}, {z}", run.message, False)
            energy, scale = run.run.thermo("TotEng", 1), E * cloud.volume.sum() * 1e-6
            run.measured(energy[0] / scale)
            quarter = len(energy) // 4
            good &= energy[-quarter:].max() <= 1.01 * energy[:quarter].max() + 1e-12 * scale
            good &= energy[0] < 1e-12 * scale if z == 0 else energy[0] > 0.01 * z * scale
            if z:
                stiff.append(f"{energy[0] / scale:.2g} ({what}, {z})")
    return Found("energy over E V (a/dx)^2: " + ", ".join(stiff) + "; 0 without", "bounded", good)


@case("kernels and horizons",
      "wendland, cubic, quintic with horizons of 1.5 to 5 spacings, square, hexagonal and simple "
      "cubic lattices",
      f"{BENDING}: within horizon over height, 1.5 spacings over height at least; vibrations do "
      "not "
      "grow at 0.98 of the stable step")
def kernels(bench):
    worst, good = {}, True
    bars = beams() | {"hexagonal": lattice("hex", (48, 7), SPACING, centre=True)}
    for what, cloud in bars.items():
        body = {"2-D": ("square", (12, 10)), "3-D": ("sc", (8, 7, 6)),
                "hexagonal": ("hex", (12, 6))}[what]
        height = np.ptp(cloud.X[:, 1]) / SPACING + 1
        for kernel in ("wendland", "cubic", "quintic"):
            for horizon in (1.5, 2.0, 2.5, 3.015, 4.0, 5.0):
                value, pair = f"{what}, {kernel}, {horizon}", f"kernel {kernel}"
                error = bending_error(bench, value, cloud, ROCK, pair, horizon=horizon)
                growth = vibration(bench, value, lattice(*body, SPACING), ROCK, pair,
                                   horizon=horizon)
                good &= error < max(horizon, 1.5) / height and growth < 2
                worst[horizon] = max(worst.get(horizon, 0.0), error)
    errors = ", ".join(f"{100 * e:.0f} % ({h} dx)" for h, e in worst.items())
    return Found(f"all; largest error {errors}",
                 "bounded: softer near surfaces with long horizons", good)


@case("jitter",
      "particles of a lattice moved by 0 to 40 % of the spacing in each direction, hourglass 0.3",
      "homogeneous strain exact to 1e-13; vibrations do not grow at 0.98 of the stable step; "
      "error in bending stated", level="quick")
def jitter(bench):
    texts, good = [], True
    for what, bar in beams().items():
        errors = []
        for amount in (0.0, 0.1, 0.2, 0.3, 0.4):
            cloud = blocks(small=True)[what].jitter(amount, 11)
            F = some_strain(cloud.dimension)
            run = bench.run(Scene(cloud, [ROCK], "hourglass 0.3").add("run 0").move(cloud.X @ F.T),
                            f"{what}, {amount}, homogeneous")
            exact = law_stress(F, ROCK)
            affine = np.abs(stresses(run.run.frame("final"), cloud.dimension) - exact).max() / E
            good &= run.measured(affine) < 1e-13
            good &= vibration(bench, f"{what}, {amount}", cloud, ROCK, "hourglass 0.3") < 2
            jittered = Cloud(bar.X, bar.volume[0], SPACING).jitter(amount, 12)
            errors.append(bending_error(bench, f"{what}, {amount}, bending", jittered, ROCK,
                                        "hourglass 0.3"))
        texts.append(" / ".join(f"{100 * e:.0f}" for e in errors) + f" % ({what})")
    return Found("40 %; error in bending at 0 / 10 / 20 / 30 / 40 %: " + ", ".join(texts),
                 "not reached; stresses get rough in proportion to the jitter", good)


@case("volumes 1:100",
      "volumes of particles of a lattice at random from 1:1 to 1:100; and lattices whose spacing "
      "grows from one side to the other, 1:1 to 1:100 in volume",
      "homogeneous strain exact to 1e-12, forces sum up to nothing, vibrations do not grow at "
      "0.98 of the stable step; error in bending of the graded bar stated")
def volumes(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        d = cloud.dimension
        for ratio in (1, 10, 100):
            for kind in ("random", "graded"):
                body = scattered(cloud, ratio) if kind == "random" else graded(cloud, ratio)
                horizon = HORIZON * body.spacing / SPACING
                F = some_strain(d)
                value = f"{what}, {kind}, 1:{ratio}"
                run = bench.run(Scene(body, [ROCK]).add("run 0").move(body.X @ F.T), value)
                frame, exact = run.run.frame("final"), law_stress(F, ROCK)
                good &= run.measured(np.abs(stresses(frame, d) - exact).max() / E) < 1e-12
                forces = frame("fx fy fz")
                good &= np.abs(forces.sum(axis=0)).max() < 1e-12 * np.abs(forces).sum()
                good &= vibration(bench, value, body, ROCK) < 2
    bar = beams()["2-D"]
    errors = [bending_error(bench, f"2-D, graded bar, 1:{ratio}", graded(bar, ratio), ROCK)
              for ratio in (1, 10, 100)]
    good &= np.isfinite(errors).all()
    return Found("1:100; error in bending of the graded bar at 1:1 / 1:10 / 1:100: "
                 + " / ".join(f"{100 * e:.0f}" for e in errors) + " %", "not reached", good)


def scattered(cloud, ratio):
    body = Cloud(cloud.X, 1.0, SPACING)
    body.volume = cloud.volume * ratio ** np.random.default_rng(7).uniform(-0.5, 0.5, len(cloud))
    return body


def graded(cloud, ratio):
    """The lattice with spacings in y that grow in a geometric series, the volumes with them; the
    horizon is that of the longest spacing."""
    y = cloud.X[:, 1]
    rows = int(round(np.ptp(y) / SPACING)) + 1
    step = ratio ** (np.arange(rows) / (rows - 1))
    step *= rows / step.sum() * SPACING
    centre = np.cumsum(step) - step / 2 - rows * SPACING / 2
    k = np.rint((y - y.min()) / SPACING).astype(int)
    X = cloud.X.copy()
    X[:, 1] = centre[k]
    body = Cloud(X, 1.0, max(step.max(), SPACING))
    body.volume = cloud.volume * step[k] / SPACING
    return body


@case("thickness in plane strain and stress",
      "volumes for a thickness of 1e-9, 1e-3, 1 and 1e6; one material and two with a coupled "
      "interface; forces of a shaken block, and its relaxation",
      "stresses, stable time step, positions after relaxation and iterations to it the same to "
      "1e-6, forces in proportion", level="test")
def thickness(bench):
    worst, cloud = 0.0, blocks(small=True)["2-D"]
    X = cloud.X + noise(cloud, 0.02)
    for what, plane, materials in (("strain", "strain", [ROCK]), ("stress", "stress", [ROCK]),
                                   ("coupled", "strain", [ROCK, material(poisson=0.45)])):
        found = {}
        for thick in (1.0, 1e-9, 1e-3, 1e6):
            body = Cloud(cloud.X, cloud.volume[0] * thick, SPACING)
            body.type[cloud.X[:, 0] > 0] = len(materials)
            scene = Scene(body, materials, f"plane {plane} viscosity 1 2").add("run 0").move(X)
            scene.add("compute dt all tmsph/dt").thermo("step c_dt")
            force = 1e-7 * E * SPACING * thick * len(cloud) ** 0.5
            scene.add(f"compute watch all tmsph/property/atom {FIELDS}\nrun 0")
            scene.snapshot("first", COLUMNS).add("uncompute watch")
            run = bench.run(scene, f"{what}, {thick:g}", "min_style tmsph/lbfgs\nminimize 0 "
                            f"{force:.6g} 5000 5000", every=10**6)
            first, final = run.run.frame("first"), run.run.frame("final")
            found[thick] = (stresses(first, 2), first("fx fy") / thick, run.run.thermo("c_dt", 1),
                            final("x y"), np.array(float(run.run.cost.steps)))
            error = max(np.abs(mine - one).max() / np.abs(one).max()
                        for mine, one in zip(found[thick], found[1.0]))
            worst = max(worst, run.measured(error))
    return Found(f"1e-9 to 1e6: {worst:.0e}", "not reached", worst < 1e-6)
