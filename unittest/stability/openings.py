# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Bonds that open: all at once, thrown at each other, by a jump of temperature, back and forth, at spacings
beyond the limit of the method."""

import numpy as np

from bodies import E, ROCK, SPACING, blocks, wave_speed
from cases import GOOD, Found, case, marching
from fracture import DT, HEAVY, bond_count, highest, included
from tmsph_testing import Scene, disc_materials

C = wave_speed(ROCK)
TENSILE = 10e6
TOOK = "f_rock[6] f_rock[9]"    # what openings took, and what was lost with them


def energy_for(ratio, spacing=SPACING):
    """G of a crack whose characteristic length the spacing is so many times."""
    return spacing / ratio * TENSILE**2 / E


def opening(ratio, words=""):
    return f"fix rock all tmsph/rankine tensile * {TENSILE} energy * {energy_for(ratio):.17g} {words}"


@case("opening everywhere",
      "a block at 1.2 to 10 times the strain of its strength, let go, spacing 0.05 to 0.85 of the characteristic "
      "length, no viscosity, 600 steps",
      "the energy never rises, by 1e-3 of the start, and no update of an opening gains 1e-4 of what they take")
def everywhere(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        bonds = bond_count(cloud)
        for ratio in (0.05, 0.3, 0.85):
            for times in (1.2, 3.0, 10.0):
                scene = Scene(cloud, [ROCK]).add("run 0").move((1 + times * TENSILE / E) * cloud.X)
                scene.add(opening(ratio)).thermo(f"step etotal f_rock f_rock[8] {TOOK} f_rock[11]", 1)
                run = bench.run(scene, f"{what}, {ratio}, {times}", marching(DT, 600), every=200)
                good &= run.ok and highest(run) < 1e-3
                if run.ok:
                    last = {name: run.run.thermo(name)[-1] for name in ("f_rock", "f_rock[6]", "f_rock[8]")}
                    good &= last["f_rock[8]"] <= 1e-4 * max(last["f_rock[6]"], 1e-300)
                    broken = last["f_rock"] / bonds
        texts.append(f"{100 * broken:.0f} % of the bonds gone at the last ({what})")
    return Found("10 times; " + ", ".join(texts), "not reached", good)


@case("opening by impact",
      "two halves of a block, thrown apart or at each other at 1e-3 to 0.05 of the wave speed, spacing 0.3 of the "
      "characteristic length, no viscosity, 600 steps",
      "the energy never rises, by 1e-3 of the start")
def impact(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        for share in (1e-3, 0.01, 0.05):
            for sign in (1, -1):
                scene = Scene(cloud, [ROCK])
                scene.set("vx", sign * share * C * np.sign(cloud.X[:, 0]))
                scene.add(opening(0.3)).thermo("step etotal f_rock", 1)
                run = bench.run(scene, f"{what}, {sign * share}", marching(0.5 * DT, 600), every=200)
                good &= run.ok and highest(run) < 1e-3
        texts.append(what)
    return Found("0.05 of the wave speed, " + ", ".join(texts), "not reached", good)


@case("temperature jump with openings",
      "disc and ball with an inclusion, 10 to 1000 degrees in one step, spacing 0.3 of the characteristic length, "
      "hourglass 0.5, viscosity 1 2, 0.3 dx/c, 1000 steps",
      "the energy that the jump brings only falls, within 2 %")
def jump(bench):
    good, texts = True, []
    for dimension in (2, 3):
        cloud, found = included(dimension), {}
        for degrees in (10.0, 100.0, 300.0, 1000.0):
            scene = Scene(cloud, disc_materials(False), HEAVY)
            scene.add(f"run 0\nset group all temperature {degrees}")
            scene.add(opening(0.3, "weibull * 10 4711")).thermo("step etotal f_rock", 1)
            run = bench.run(scene, f"{dimension}-D, {degrees:g}", marching(DT, 1000), every=200)
            good &= run.ok and highest(run) < 0.02
            if run.ok:
                found[degrees] = run.run.thermo("f_rock")[-1]
        texts.append(" / ".join(f"{n:.0f}" for n in found.values()) + f" ({dimension}-D)")
    return Found("1000 degrees; bonds gone at 10 / 100 / 300 / 1000: " + ", ".join(texts), "not reached", good)


@case("cycles of an opening crack",
      "a block, stretched in equilibrium until it opens and pressed back, five times and farther each time",
      "what openings took never falls; the block is as stiff as at first when it is pressed, within 5 %: where "
      "bonds have left, their faces press on each other by contact",
      level="test")
def cycles(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        d, half = cloud.dimension, 0.5 * np.ptp(cloud.X[:, 0]) - SPACING
        lines = ["run 0"]
        for axis, side in (("left", f"INF {-half:.9g}"), ("right", f"{half:.9g} INF")):
            lines.append(f"region {axis} block {side} INF INF INF INF\ngroup {axis} region {axis}")
        scene = Scene(cloud, [ROCK]).add("\n".join(lines)).add(opening(0.2))
        scene.add("fix left left setforce 0 0 0\nfix right right setforce 0 0 0")
        scene.thermo("step f_right[1] f_rock[6] f_rock[11]", 1)
        strain, moves = TENSILE / E, []
        for n in range(5):
            top = (0.9 + 0.3 * n) * strain * half
            at = 0.0
            for end in (top, -0.3 * strain * half, -0.6 * strain * half, 0.0):
                moves.append((end - at, end))
                at = end
        script = "\n".join(f"displace_atoms all ramp x {-by:.17g} {by:.17g} x {-half:.9g} {half:.9g} units box\n"
                           "tmsph/quasistatic 1" for by, _ in moves)
        run = bench.run(scene, what, f"timestep 1.0\n{script}", every=1, timeout=300)
        good &= run.ok
        if not run.ok:
            continue
        took = np.array([table["f_rock[6]"][-1] for table in run.run.tables[-len(moves):]])
        load = np.array([table["f_right[1]"][-1] for table in run.run.tables[-len(moves):]])
        good &= np.diff(took).min() >= -1e-12 * took.max() and took.max() > 0
        pressed = [load[k + 1] - load[k] for k in range(1, len(moves), 4)]
        change = run.measured(np.abs(np.array(pressed) / pressed[0] - 1).max())
        good &= change < 0.05
        texts.append(f"stiffness within {change:.1g} ({what})")
    return Found("five cycles, " + ", ".join(texts), "not reached", good)


@case("spacing over the characteristic length",
      "0.01 to 100, a block at 3 times the strain of its strength, 30 steps",
      "up to 0.9 ends well, with a warning above 0.3; beyond: one error", level="test")
def coarse(bench):
    good, holds = True, {}
    for what, cloud in blocks(small=True).items():
        for ratio in (0.01, 0.29, 0.31, 0.89, 0.91, 100.0):
            scene = Scene(cloud, [ROCK]).add("run 0").move((1 + 3 * TENSILE / E) * cloud.X)
            scene.add(opening(ratio)).thermo("step etotal f_rock", 1)
            run = bench.run(scene, f"{what}, {ratio}", marching(DT, 30), every=30)
            good &= run.end in GOOD and run.ok == (ratio < 0.9)
            if run.ok:
                good &= ("of the characteristic length" in run.run.log) == (ratio > 0.3)
            holds[ratio] = run.ok
    return Found(f"{max(ratio for ratio, held in holds.items() if held)}", "stopped with the remedy", good)
