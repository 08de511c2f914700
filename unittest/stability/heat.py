# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Conduction: steps, contrasts, boundaries, cracks."""

import numpy as np

from bodies import E, RHO, ROCK, SPACING, blocks, wave_speed
from cases import GOOD, Found, case, last_of, marching
from tmsph_testing import Scene, disc_materials, lattice, material

K, CAPACITY = 2.9, 850.0
EXPANDING = material(expansion=1e-5)
RANGE = "no temperature outside of those at the start and of the boundaries, by 1e-9 of their range"


def bars():
    """A bar along x in 2-D and 3-D."""
    return {"2-D": lattice("square", (20, 8), SPACING), "3-D": lattice("sc", (12, 5, 5), SPACING)}


def layers():
    """Two layers across x, without sides, their types, and the plane between them."""
    for what, cloud in {"2-D": lattice("square", (12, 7), SPACING, "y"),
                        "3-D": lattice("sc", (10, 7, 7), SPACING, "yz")}.items():
        x = cloud.X[:, 0]
        middle = (x.min() + x.max()) / 2
        cloud.type = np.where(x < middle, 1, 2)
        yield what, cloud, x, middle


def conducting(cloud, words="", materials=(ROCK,), start=0.0, conductivity="conductivity * 2.9",
               capacity="specific/heat * 850"):
    """A scene with conduction; what is observed are the extremes of the temperature."""
    scene = Scene(cloud, materials, temperature=start)
    scene.add(f"fix heat all tmsph/heat {conductivity} {capacity} {words}")
    return scene.add(observing())


def observing():
    return ("compute T all tmsph/property/atom temperature\ncompute hot all reduce max c_T\n"
            "compute cold all reduce min c_T\n"
            "thermo_style custom step c_hot c_cold f_heat f_heat[2] f_heat[6] f_heat[8]\n"
            "thermo_modify norm no format float %.17g\nthermo 1")


def ends_of(cloud, boundary_low="", boundary_high=""):
    """Boundaries at the two ends along x."""
    x, text = cloud.X[:, 0], ""
    for name, chosen, what in (("low", x < x.min() + 2.5 * SPACING, boundary_low),
                               ("high", x > x.max() - 2.5 * SPACING, boundary_high)):
        if what:
            ids = " ".join(str(i + 1) for i in np.flatnonzero(chosen))
            text += (f"group {name} id {ids}\n"
                     f"fix at_{name} {name} tmsph/heat/boundary {what}\n")
    return text


def outside(run, low, high):
    """How far temperatures leave their range, in units of it."""
    hot, cold = run.run.thermo("c_hot", -1), run.run.thermo("c_cold", -1)
    return run.measured(max(hot.max() - high, low - cold.min(), 0.0) / (high - low))


def kept(run):
    """Relative change of the heat content that boundaries do not account for."""
    content = run.run.thermo("f_heat", -1) - run.run.thermo("f_heat[2]", -1)
    return np.abs(content - content[0]).max() / np.abs(run.run.thermo("f_heat", -1)).max()


def stable_step(bench, what, scene):
    run = bench.run(scene, f"{what}, stated", "timestep 1e-12\nrun 1")
    return run.measured(run.run.thermo("f_heat[6]")[-1])



def checkered(cloud):
    """Zeros and ones in turn: the highest mode."""
    cell = np.rint(cloud.X / SPACING - 0.5).astype(int)
    return (cell.sum(axis=1) % 2).astype(float)


@case("explicit heat step",
      "a checkerboard of temperatures 0 and 1, with and without a surface held at 1, at 0.99, 1.01 "
      "and 2 times the stated stable step",
      f"at 0.99: {RANGE}; above: refused with the stable step", level="test")
def explicit(bench):
    good = True
    for what, cloud in bars().items():
        for boundary in ("", "temperature 1"):
            def scene(words):
                return conducting(cloud, words, start=checkered(cloud)).add(
                    ends_of(cloud, boundary))
            stated = stable_step(bench, f"{what} {boundary}", scene("subcycle explicit"))
            for share in (0.5, 0.99, 1.01, 2.0):
                scale = share * stated / 1e-9
                run = bench.run(scene(f"subcycle explicit time/scale {scale:.17g}"),
                                f"{what} {boundary}, {share}", "timestep 1e-9\nrun 50", every=10)
                if share < 1:
                    good &= run.ok and outside(run, 0, 1) < 1e-9
                else:
                    good &= run.end == "stopped" and "stable" in run.message
    return Found("0.99 runs, 1.01 is refused", "refused at the first run", good)


@case("long heat steps",
      "RKL2 over 0.1 to 1e8 stable steps at once, the same bodies; insulated, and one surface at 1",
      f"{RANGE}; heat kept to 1e-10")
def long_steps(bench):
    good, texts = True, []
    for what, cloud in bars().items():
        for boundary in ("", "temperature 1"):
            holds = {}
            for share in (0.1, 1.0, 100.0, 1e4, 1e6, 1e8):
                def scene(words):
                    return conducting(cloud, words, start=checkered(cloud)).add(
                        ends_of(cloud, boundary))
                if share == 0.1:
                    stated = stable_step(bench, f"{what} {boundary}", scene(""))
                run = bench.run(scene(f"time/scale {share * stated / 1e-9:.17g}"),
                                f"{what} {boundary}, {share:g}", "timestep 1e-9\nrun 3", every=1)
                holds[share] = run.ok and outside(run, 0, 1) < 1e-9 and kept(run) < 1e-10
                good &= holds[share] or share > 1e6 and run.end in GOOD
            texts.append(f"{last_of(holds)} ({what}, {boundary or 'insulated'})")
    return Found("stable steps: " + ", ".join(texts), "not reached", good)


@case("enormous time scale", "time/scale 1e12 to 1e300 with 1e-9 s, surfaces at 0 and 1",
      f"{RANGE}; or stopped, or refused; ends within a minute")
def time_scale(bench):
    good, texts = True, []
    for what, cloud in bars().items():
        holds = {}
        for scale in (1e12, 1e20, 1e300):
            scene = conducting(cloud, f"time/scale {scale:g}")
            scene.add(ends_of(cloud, "temperature 0", "temperature 1"))
            run = bench.run(scene, f"{what}, {scale:g}", "timestep 1e-9\nrun 2", every=1,
                            timeout=60)
            holds[scale] = run.ok and outside(run, 0, 1) < 1e-9
            good &= holds[scale] or run.end == "stopped"
        texts.append(f"{last_of(holds)} ({what})")
    return Found(", ".join(texts), "stopped", good)


@case("contrast of conductivities",
      "two layers between surfaces at 0 and 1, k1/k2 1 to 1e6; after 8 times the time of diffusion "
      "of the slower one",
      "temperature of the slower one within 0.01 of that of layers in series; " + RANGE)
def conductivities(bench):
    good, texts = True, []
    for what, cloud, x, middle in layers():
        found = {}
        half = middle - x.min() + SPACING / 2
        for ratio in (1.0, 1e3, 1e6):
            scene = conducting(cloud, f"time/scale {1e9 * 0.2 * half**2 * RHO * CAPACITY:.6g}",
                               [ROCK, ROCK],
                               conductivity=f"conductivity 1 {ratio:g} conductivity 2 1")
            scene.add(ends_of(cloud, "temperature 0", "temperature 1"))
            run = bench.run(scene, f"{what}, {ratio:g}", "timestep 1e-9\nrun 40", every=20,
                            timeout=100)
            if run.ok:
                good &= outside(run, 0, 1) < 1e-9
                frame = run.run.frame("final")
                r1, r2 = half / ratio, half
                exact = np.where(x < middle, (x - middle + half) / ratio,
                                 r1 + (x - middle)) / (r1 + r2)
                found[ratio] = run.measured(
                    np.abs(frame["c_watch[7]"] - exact)[cloud.type == 2].mean())
            good &= run.ok and found[ratio] < 0.01
        texts.append(" / ".join(f"{e:.1g}" for e in found.values()) + f" ({what})")
    return Found("error of the temperature at 1 / 1e3 / 1e6: " + ", ".join(texts),
                 "not reached", good)


@case("contrast of heat capacities",
      "two halves at 0 and 1, insulated, c1/c2 1 to 1e6; until 4 times the time of "
      "diffusion, of up to 100 times the smaller one",
      f"temperature of the mean to 1e-3; {RANGE}; heat kept to 1e-10", level="test")
def capacities(bench):
    good, texts = True, []
    for what, cloud in bars().items():
        x = cloud.X[:, 0]
        cloud.type = np.where(x < x.mean(), 1, 2)
        holds = {}
        length = np.ptp(x) + SPACING
        for ratio in (1.0, 1e2, 1e4, 1e6):
            time = 0.1 * length**2 * RHO * CAPACITY / K * min(ratio, 100.0)
            scene = conducting(cloud, f"time/scale {time / 1e-9:.6g}", [ROCK, ROCK],
                               start=(cloud.type == 2).astype(float),
                               capacity=f"specific/heat 1 {850 * ratio:g} specific/heat 2 850")
            run = bench.run(scene, f"{what}, {ratio:g}", "timestep 1e-9\nrun 40", every=10)
            holds[ratio] = run.ok
            if run.ok:
                ones = (cloud.type == 1).mean()
                mean = (1 - ones) / (1 - ones + ones * ratio)
                T = run.run.frame("final")["c_watch[7]"]
                holds[ratio] = (outside(run, 0, 1) < 1e-9 and kept(run) < 1e-10
                                and run.measured(np.abs(T - mean).max()) < 1e-3)
            good &= holds[ratio]
        texts.append(f"{last_of(holds)} ({what})")
    return Found(", ".join(texts), "not reached", good)


@case("jump at the surface",
      "the surface of an expanding body is at 10 to 1e4 degrees at once, 300 mechanical steps of "
      "0.4 dx/c, time/scale such that half of the body is heated; viscosity 1 2",
      "up to 1000: " + RANGE + "; strain energy bounded by that of the clamped body, E (a dT)^2 "
      "times its volume", level="test")
def surface_jump(bench):
    good, texts = True, []
    dt, steps = 0.4 * SPACING / wave_speed(ROCK), 300
    for what, cloud in blocks(small=True).items():
        holds = {}
        size = np.ptp(cloud.X[:, 0])
        scale = size**2 / 8 * RHO * CAPACITY / K / (dt * steps)
        for degrees in (10.0, 100.0, 1000.0, 1e4):
            scene = Scene(cloud, [EXPANDING], "viscosity 1 2")
            scene.add(f"fix heat all tmsph/heat conductivity * {K} specific/heat * {CAPACITY} "
                      f"time/scale {scale:.6g}\n"
                      f"fix out all tmsph/heat/boundary temperature {degrees}").add(observing())
            scene.add("thermo_style custom step c_hot c_cold f_heat f_heat[2] etotal")
            scene.add("thermo_modify norm no format float %.17g")
            run = bench.run(scene, f"{what}, {degrees:g}", marching(dt, steps), every=100)
            holds[degrees] = run.ok
            if run.ok:
                energy = run.run.thermo("TotEng", -1).max()
                clamped = E * (1e-5 * degrees) ** 2 * cloud.volume.sum() * 3
                holds[degrees] = outside(run, 0, degrees) < 1e-9 and energy < clamped
            good &= holds[degrees] or degrees > 1000 and run.end in GOOD
        texts.append(f"{last_of(holds)} ({what})")
    return Found("degrees: " + ", ".join(texts), "not reached", good)


@case("film coefficient",
      "0, 1e-12 to 1e12 and 1e300, one end, against a surface of prescribed temperature",
      f"{RANGE}; heat in rises with the coefficient, is 0 at 0 and that of a prescribed "
      "temperature to 1e-6 at 1e12", level="test")
def film(bench):
    good, texts = True, []
    for what, cloud in bars().items():
        time = 0.1 * np.ptp(cloud.X[:, 0]) ** 2 * RHO * CAPACITY / K
        taken, words = {}, f"time/scale {time / 1e-9 / 5:.6g}"
        for h in (0.0, 1e-12, 1e-3, 1.0, 1e3, 1e6, 1e12, 1e300, "given"):
            boundary = "temperature 1" if h == "given" else f"convection {h:g} 1"
            scene = conducting(cloud, words).add(ends_of(cloud, boundary))
            run = bench.run(scene, f"{what}, {h}", "timestep 1e-9\nrun 5", every=1)
            good &= run.ok and outside(run, 0, 1) < 1e-9
            taken[h] = run.measured(run.run.thermo("f_heat[2]")[-1]) if run.ok else np.nan
        values = list(taken.values())[:-1]
        good &= values[0] == 0 and all(np.diff(values) >= -1e-12 * values[-1])
        good &= abs(taken[1e12] / taken["given"] - 1) < 1e-6
        texts.append(what)
    return Found("0 to 1e300, " + ", ".join(texts), "not reached", good)


@case("radiation",
      "a cold body and surroundings of 300 to 1e6 K, black; steps of 0.1 to 1e4 stable ones",
      "at 3000 K: temperatures stay between both; beyond: bounded, or stopped")
def radiation(bench):
    good, texts = True, []
    for what, cloud in bars().items():
        holds = {}
        for outer in (300.0, 3000.0, 1e4, 1e5, 1e6):
            for share in (0.1, 10.0, 1e3, 1e4):
                scene = conducting(cloud, f"time/scale {share * 0.1 / 1e-9:.6g}").add(
                    f"fix sun all tmsph/heat/boundary radiation 5.67e-8 {outer:g} zero -273.15")
                run = bench.run(scene, f"{what}, {outer:g}, {share:g}", "timestep 1e-9\nrun 20",
                                every=5)
                good &= run.end in GOOD
                held = run.ok and outside(run, min(0.0, outer), outer) < 1e-9
                holds[outer] = holds.get(outer, True) and held
                good &= held or outer > 3000
        texts.append(f"{last_of(holds)} ({what})")
    return Found("K: " + ", ".join(texts), "bounded", good)


@case("heat with all bonds broken",
      "a block all of whose bonds break in the first step, hot in one half, with surface "
      "temperature, convection or a flux on cracks, 50 steps",
      f"{RANGE} (but for the flux); insulated: no temperature changes", level="test")
def broken(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        hot = (cloud.X[:, 0] > 0).astype(float)
        for boundary in ("", "temperature 2 cracks yes", "convection 1e3 2 cracks yes",
                         "flux 1e3 cracks yes", "radiation 5.67e-8 2 zero -273.15 cracks yes"):
            scene = conducting(cloud, "time/scale 1e7", start=hot)
            if boundary:
                scene.add(f"fix out all tmsph/heat/boundary {boundary}")
            scene.add("run 0").move(1.001 * cloud.X)
            scene.add("fix rock all tmsph/hoekbrown strength * 1 mi * 8")
            dt = 0.3 * SPACING / wave_speed(ROCK)
            run = bench.run(scene, f"{what}, {boundary or 'insulated'}", marching(dt, 50), every=10)
            good &= run.ok
            if run.ok and "flux" not in boundary:
                good &= outside(run, 0, 2 if boundary else 1) < 1e-9
            if run.ok and not boundary:
                # but for the first heat step, while the bonds held
                frames = run.run.dumps["watch"]
                still = np.abs(frames[-1]["c_watch[7]"] - frames[1]["c_watch[7]"]).max()
                good &= still == 0.0
        texts.append(what)
    return Found("all bonds gone, " + ", ".join(texts), "not reached", good)


@case("quasi-static with impossible tolerances",
      "residual 1e-4 to 1e-300, change down to 1e-300 and stride 1e-12, at most 50 evaluations an "
      "equilibrium; heating of a disc and a ball with breaking",
      "ends, within a minute: all time steps are covered")
def impossible(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        cloud.type[np.linalg.norm(cloud.X, axis=1) > 2.5 * SPACING] = 2
        worst = []
        for words in ("residual 1e-4", "residual 1e-12", "residual 1e-300", "change 1e-300",
                      "residual 1e-300 change 1e-300 stride 1e-12", "breaking 1 residual 1e-300"):
            scene = Scene(cloud, disc_materials(False), "hourglass 0.3")
            scene.add("variable T equal 10*step\nfix heat all tmsph/heat/boundary temperature v_T\n"
                      "fix rock all tmsph/hoekbrown strength * 120e6 mi * 8 weibull * 10 4711")
            scene.thermo("step pe f_rock", 1)
            run = bench.run(scene, f"{what}, {words}", "timestep 1.0\n"
                            f"tmsph/quasistatic 30 {words} evaluations 50", every=10)
            good &= run.ok and run.run.thermo("Step")[-1] == 30
            worst.append(run.run.thermo("f_rock")[-1] if run.ok else np.nan)
        texts.append("/".join(f"{n:.0f}" for n in worst) + f" ({what})")
    return Found("bonds broken: " + ", ".join(texts), "warned where no equilibrium was found", good)
