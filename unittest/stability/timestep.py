# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The stable time step: that which is stated against that which is, intact and broken, and what
happens beyond it."""

import numpy as np

from bodies import (E, RHO, ROCK, SPACING, Copy, blocks, grows, largest_step, noise, stated_step,
                    wave_speed)
from cases import Found, case, marching, unchecked_step
from tmsph_testing import HORIZON, Cloud, Scene, lattice, material

TIGHT = "largest stable step at least the stated one and at most {} of it"


def in_units(dt, m=ROCK):
    """A time step in spacings over the wave speed."""
    return dt * wave_speed(m) / SPACING


def bonds_of(cloud, horizon=HORIZON):
    """Pairs of particles within the horizon."""
    R = np.linalg.norm(cloud.X[:, None] - cloud.X[None], axis=2)
    return np.argwhere(np.triu(R < horizon * cloud.spacing, 1))


def scattered_cuts(cloud, shares, seed=5):
    """Commands of tmsph/cut that take those shares of the bonds away with small flaws all over."""
    random = np.random.default_rng(seed)
    bonds, d = bonds_of(cloud), cloud.dimension
    A, B = cloud.X[bonds[:, 0]], cloud.X[bonds[:, 1]]
    gone, commands, found = np.zeros(len(bonds), bool), [], {}
    low, high, half = cloud.X.min(axis=0), cloud.X.max(axis=0), 0.35 * cloud.spacing
    for share in shares:
        while gone.mean() < share:
            c, n = random.uniform(low, high), random.normal(size=d)
            n /= np.linalg.norm(n)
            a, b = (A - c) @ n, (B - c) @ n
            with np.errstate(divide="ignore", invalid="ignore"):
                hit = A + (a / (a - b))[:, None] * (B - A)
            gone |= (a * b < 0) & (np.linalg.norm(hit - c, axis=1) < half)
            if d == 2:
                t = half * np.array([-n[1], n[0]])
                shape = "line " + " ".join(f"{x:.12g}" for x in (*(c - t), *(c + t)))
            else:
                shape = "disc " + " ".join(f"{x:.12g}" for x in (*c, *n, half))
            commands.append(f"tmsph/cut all {shape}")
        found[share] = "\n".join(commands)
    return found


@case("time step, intact",
      "square, hexagonal, jittered, periodic, simple cubic, fcc bodies; hourglass 0 to 1, "
      "viscosity, nu 0 to 0.49",
      TIGHT.format(1.05), level="test")
def intact(bench):
    bodies = {"square": ("square", (14, 12), 0, ""), "hexagonal": ("hex", (12, 7), 0, ""),
              "plane stress": ("square", (14, 12), 0, "plane stress"),
              "hourglass 0": ("square", (14, 12), 0, "hourglass 0"),
              "hourglass 1": ("square", (14, 12), 0, "hourglass 1"),
              "viscous": ("square", (14, 12), 0, "viscosity 1 2"),
              "jittered": ("square", (14, 12), 0.2, "hourglass 0.3"),
              "periodic": ("square", (12, 12), 0, ""),
              "nu 0": ("square", (14, 12), 0, ""), "nu 0.49": ("square", (14, 12), 0, ""),
              "cubic": ("sc", (7, 6, 6), 0, ""), "fcc": ("fcc", (4, 4, 3), 0, ""),
              "cubic, viscous": ("sc", (7, 6, 6), 0, "viscosity 1 2"),
              "cubic, hourglass 1": ("sc", (7, 6, 6), 0, "hourglass 1"),
              "cubic, nu 0.49": ("sc", (7, 6, 6), 0, "")}
    found = {}
    for what, (name, cells, amount, pair) in bodies.items():
        cloud = lattice(name, cells, SPACING, "xy" if what == "periodic" else "").jitter(amount, 5)
        m = material(poisson=float(what.split("nu ")[1]) if "nu " in what else 0.3)
        stated, ratio = largest_step(bench, what, Scene(cloud, [m], pair).add("run 0"), cloud)
        found[what] = in_units(stated, m), ratio
    ratios = [ratio for _, ratio in found.values()]
    return Found(f"{min(ratios):.3f} to {max(ratios):.3f} of the stated one, which is, in dx/c: "
                 + ", ".join(f"{what} {dt:.2f}" for what, (dt, _) in found.items()),
                 "noise grows until a particle is turned inside out: stopped",
                 all(1.0 <= ratio <= 1.05 for ratio in ratios))


@case("time step, broken",
      "50, 80 and 90 % of the bonds removed by small flaws all over, 2-D and 3-D, with and "
      "without viscosity",
      TIGHT.format(1.1) + "; 0.4 of the intact one, which is advised for "
      "fracture, is stable with up to 80 % gone")
def broken(bench):
    texts, good = [], True
    for what, (name, cells) in {"2-D": ("square", (14, 12)), "3-D": ("sc", (7, 6, 6))}.items():
        cloud = lattice(name, cells, SPACING)
        cuts = scattered_cuts(cloud, (0.5, 0.8, 0.9))
        for pair in ("", "viscosity 1 2"):
            scene = Scene(cloud, [ROCK], pair)
            whole = stated_step(bench, f"{what} {pair}, intact", Copy(scene, cloud).add("run 0"))
            parts = []
            for share, commands in cuts.items():
                cut = Copy(scene, cloud).add(commands).add("run 0")
                stated, ratio = largest_step(bench, f"{what} {pair}, {share}", cut, cloud)
                good &= 1.0 <= ratio <= 1.1 and (stated > 0.4 * whole or share > 0.8)
                parts.append(f"{stated / whole:.2f} ({100 * share:.0f} %, {ratio:.3f})")
            texts.append(f"{what}{', viscous' if pair else ''}: " + ", ".join(parts))
    return Found("stated over intact (share of bonds gone, largest stable over stated): "
                 + "; ".join(texts),
                 "refused at the start of a run; noise grows otherwise", good)


@case("beyond the stable step",
      "run with 1.01, 1.1 and 10 times the stated step; and the same during a run with fix "
      "dt/reset, 1.1 to 1e6 times",
      "refused, with the stable one, at the start of a run; during it stopped with a particle",
      level="test")
def beyond(bench):
    good = True
    for what, cloud in blocks(small=True).items():
        for pair in ("", "viscosity 1 2"):
            scene = Scene(cloud, [ROCK], pair).add("run 0")
            stated = stated_step(bench, f"{what} {pair}, stated", scene)
            for share in (0.99, 1.01, 1.1, 10.0):
                run = bench.run(scene, f"{what} {pair}, {share}", marching(share * stated, 10))
                good &= run.ok if share < 1 else run.end == "stopped" and "time step" in run.message
            for share in (1.1, 1.5, 10.0, 1e3, 1e6):
                X = cloud.X + noise(cloud, 1e-3, 9)
                going = f"{unchecked_step(share * stated, SPACING)}fix 1 all nve\nrun 2000"
                run = bench.run(Copy(scene, cloud).move(X),
                                f"{what} {pair}, {share:g}, during a run", going, every=1)
                good &= run.end == "stopped"
    return Found("0.99 runs, 1.01 is refused",
                 "during a run: turned inside out, with particle, place and step", good)


@case("stiffer or broken between runs",
      "Young's modulus 4 times as large, or 80 % of the bonds cut, before a second run with the "
      "step of the first, 0.9 of the stable one",
      "refused, with the stable one", level="test")
def between(bench):
    good = True
    for what, cloud in blocks(small=True).items():
        scene = Scene(cloud, [ROCK]).add("run 0")
        stated = stated_step(bench, f"{what}, stated", scene)
        stiff = f"pair_coeff 1 1 elastic {4 * E} 0.3 density {RHO}"
        cut = scattered_cuts(cloud, (0.8,))[0.8]
        for change, commands in {"nothing": "", "stiffer": stiff, "cut": cut}.items():
            run = bench.run(scene, f"{what}, {change}",
                            f"{marching(0.9 * stated, 10)}\n{commands}\nrun 10")
            refused = run.end == "stopped" and "time step" in run.message
            good &= run.ok if change == "nothing" else refused
    return Found("both refused", "stopped before the second run", good)


@case("viscosity",
      "alpha1 from 0 to 1e4 with noise, at 0.98 of the stated step; alpha2 from 0 to 2000 with a "
      "block that is squeezed at 0.1 of the wave speed, at 0.4 of it",
      "noise dies out; with alpha2 up to 20, ten times the usual one, the total energy never "
      "rises by more than 1 %")
def viscosity(bench):
    good, steps, quadratic = True, {}, []
    for what, cloud in blocks(small=True).items():
        for alpha1 in (0, 0.1, 1, 10, 100, 1e4):
            scene = Scene(cloud, [ROCK], f"viscosity {alpha1} 0").add("run 0")
            stated = stated_step(bench, f"{what}, alpha1 {alpha1:g}, stated", scene)
            good &= not grows(bench, f"{what}, alpha1 {alpha1:g}", scene, cloud, 0.98 * stated)
            steps.setdefault(what, []).append(in_units(stated))
        for alpha2 in (0, 2, 20, 200, 2000):
            scene = Scene(cloud, [ROCK], f"viscosity 1 {alpha2}").add("run 0")
            stated = stated_step(bench, f"{what}, alpha2 {alpha2}, stated", scene)
            X = cloud.X - cloud.X.mean(axis=0)
            v = np.zeros_like(X)
            v[:, 0] = -0.1 * wave_speed(ROCK) * np.sign(X[:, 0])
            squeezed = Copy(scene, cloud).set("vx", v[:, 0]).thermo("step etotal")
            run = bench.run(squeezed.add("thermo 1"), f"{what}, alpha2 {alpha2}",
                            marching(0.4 * stated, 500))
            if not run.ok:
                quadratic.append(f"{run.end} at {alpha2} ({what})")
                good &= alpha2 > 20
                continue
            energy = run.run.thermo("TotEng", 1)
            rise = run.measured(energy.max() / energy[0] - 1)
            quadratic.append(f"{100 * rise:.1g} % at {alpha2} ({what})")
            good &= rise < 0.01
    text = "; ".join(f"{what} " + " / ".join(f"{dt:.2g}" for dt in row)
                     for what, row in steps.items())
    return Found(f"alpha1 1e4: stated step in dx/c at 0 / 0.1 / 1 / 10 / 100 / 1e4: {text}; rise "
                 f"of the energy with alpha2: {', '.join(quadratic)}",
                 "the step falls in proportion to alpha1, and is stated; alpha2 is not in it: far "
                 "above the usual 2 stopped with the particle that is turned inside out", good)


@case("time step of stiff bodies",
      "two bonded materials, E1/E2 1 to 1e6; nu 0.3 beside 0.3, 0.45 and 0.499 (coupled); nu -0.9 "
      "to 0.4999 alone",
      TIGHT.format(1.1))
def stiff(bench):
    texts, ratios = [], []
    for what, cloud in blocks(small=True).items():
        two = Cloud(cloud.X, cloud.volume[0], SPACING)
        two.type[cloud.X[:, 0] > 0] = 2
        pairs = {f"E 1:1e{n}": (two, [ROCK, material(E / 10**n)]) for n in (0, 2, 4, 6)}
        pairs |= {f"nu 0.3 and {nu}": (two, [ROCK, material(poisson=nu)]) for nu in (0.45, 0.499)}
        pairs |= {f"nu {nu}": (cloud, [material(poisson=nu)]) for nu in (-0.9, 0.0, 0.45, 0.4999)}
        for name, (body, materials) in pairs.items():
            scene = Scene(body, materials).add("run 0")
            stated, ratio = largest_step(bench, f"{what}, {name}", scene, body)
            ratios.append(ratio)
            fastest = max(materials, key=wave_speed)
            texts.append(f"{name} ({what}) {in_units(stated, fastest):.2f}")
    return Found(f"{min(ratios):.3f} to {max(ratios):.3f} of the stated one, which is, in dx/c of "
                 "the faster material: " + ", ".join(texts), "refused at the start of a run",
                 all(1.0 <= ratio <= 1.1 for ratio in ratios))
