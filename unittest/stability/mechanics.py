# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Elastic bodies in equilibrium: stiffness, Poisson's ratio, strains, options and clouds at their
limits."""

import numpy as np

from bodies import (E, ROCK, SPACING, beams, bending_error, blocks, ends, equilibrium, law_stress,
                    sheared, stays, stresses, stretched, wave_stability)
from cases import Found, case, last_of
from tmsph_testing import HORIZON, Scene, contact_pressure, disc_materials, lattice, material


@case("turned inside out", "a block is squeezed along x to the stretch s = 0.5, 0.1, ..., 0, -0.5",
      "det F > 0: runs for s > 0, names a particle for s <= 0", level="test")
def inverted(bench):
    good = True
    for what, cloud in blocks(small=True).items():
        for s in (0.5, 0.1, 1e-3, 1e-6, 0.0, -1e-6, -0.5):
            F = stretched(cloud.dimension, s)
            run = bench.run(Scene(cloud, [ROCK]).add("run 0").move(cloud.X @ F.T), f"{what}, {s}")
            good &= run.ok if s > 0 else run.end == "stopped" and "inside out" in run.message
    return Found("s = 1e-6 runs, 0 does not", "stopped: particle, place and step", good)


@case("exact under any strain",
      "uniaxial and hydrostatic stretch 0.1 to 10, simple shear to 5, plane strain, plane stress "
      "and 3-D, jitter 0.2",
      "stress of every particle that of the law, to 1e-11 of E (1 + strain)", level="test")
def affine(bench):
    worst = 0.0
    for what, cloud in blocks(small=True).items():
        cloud.jitter(0.2, 5)
        d = cloud.dimension
        states = {f"uniaxial {s}": stretched(d, s) for s in (0.1, 0.3, 3.0, 10.0)}
        states |= {f"hydrostatic {s}": s * np.eye(d) for s in (0.1, 0.3, 3.0, 10.0)}
        states |= {f"shear {g}": sheared(d, g) for g in (1.0, 5.0)}
        for plane in ("strain", "stress")[: 4 - d]:
            scene = Scene(cloud, [ROCK], f"plane {plane}").add("run 0")
            for name, F in states.items():
                moving = Scene(cloud, [ROCK], f"plane {plane}").add("run 0").move(cloud.X @ F.T)
                run = bench.run(moving, f"{what}, {plane}, {name}")
                exact = law_stress(F, ROCK, plane)
                error = np.abs(stresses(run.run.frame("final"), d) - exact).max()
                worst = max(worst, run.measured(error / (E + np.abs(exact).max())))
    return Found(f"all; largest error {worst:.0e}", "bounded: stress of the law", worst < 1e-11)


@case("stiffness contrast",
      "E1/E2 = 1, 10, ..., 1e6 of two bonded bars in series, nu 0, 20 spacings each, 2-D and 3-D; "
      "at 1e6 also 40 and 80 spacings, and with coupled interfaces (dilatation averaged)",
      "stress of the soft bar that of u/(L1/E1 + L2/E2) within half a horizon over its length; "
      "the error halves with the spacing")
def contrast(bench):
    def error(what, n, power, pair=""):
        cells = (2 * n, 8) if what == "2-D" else (2 * n, 6, 6)
        cloud = lattice("square" if what == "2-D" else "sc", cells, SPACING)
        x, length = cloud.X[:, 0], n * SPACING
        cloud.type[x > length] = 2
        stiff, soft = material(E, 0.0), material(E / 10**power, 0.0)
        stress = 1e-4 * soft["young"]
        u = np.zeros_like(cloud.X)
        u[:, 0] = stress * np.where(x < length, x / E, length / E + (x - length) / soft["young"])
        run = equilibrium(bench, f"{what}, {n} spacings, 1e{power} {pair}", cloud, [stiff, soft],
                          cloud.X + u, ends(cloud), stress, pair, residual=1e-4)
        if not run.ok:
            return np.inf
        far = np.abs(x - 1.5 * length) < 3 * SPACING
        s = run.run.frame("final")["c_watch[1]"]
        return run.measured(np.abs(s[far] / stress - 1).max())

    worst = {what: max(error(what, 20, power) for power in range(7)) for what in ("2-D", "3-D")}
    finer = [error("2-D", n, 6) for n in (20, 40, 80)]
    coupled = {what: error(what, 20, 6, "dilatation averaged") for what in ("2-D", "3-D")}
    good = max(*worst.values(), *coupled.values()) < 0.5 * HORIZON / 20
    good &= all(fine < 0.6 * coarse for coarse, fine in zip(finer, finer[1:]))
    percent = lambda errors: ", ".join(f"{100 * e:.2g} % ({what})" for what, e in errors.items())
    return Found(f"1e6: at most {percent(worst)}, an interface layer of {20 * worst['2-D']:.1f} "
                 "spacings; "
                 + " / ".join(f"{100 * e:.2g}" for e in finer) + " % with 20 / 40 / 80 spacings; "
                 f"coupled {percent(coupled)}", "not reached", good)


@case("Poisson's ratio",
      "-0.99 to 0.4999, a bent bar, plane strain and plane stress (12 rows), 3-D (8 rows); -1, "
      "0.49995 and 0.5; 0.46 with dilatation plain and with law almansi",
      "from -0.9 to 0.4999 bending stress no more than 1.5 times as wrong as at 0.3; beyond: "
      "refused")
def poisson(bench):
    ratios = (0.3, -0.99, -0.9, -0.5, 0.0, 0.45, 0.49, 0.499, 0.4999)
    texts, good = [], True
    for what, cloud in beams().items():
        for plane in ("strain", "stress")[: 4 - cloud.dimension]:
            key = f"{what}, plane {plane}" if cloud.dimension == 2 else what
            error = {nu: bending_error(bench, f"{key}, {nu}", cloud, material(poisson=nu),
                                       f"plane {plane}", plane) for nu in ratios}
            usual = [error[nu] for nu in ratios if nu >= -0.9]
            good &= max(usual) < 1.5 * error[0.3]
            texts.append(f"{100 * error[0.3]:.1f} % at 0.3, at most {100 * max(usual):.1f} %, "
                         f"{100 * error[-0.99]:.0f} % at -0.99 ({key})")
    cloud = blocks(small=True)["2-D"]
    for nu, option in ((-1.0, ""), (0.49995, ""), (0.5, ""), (0.46, "dilatation plain"),
                       (0.46, "law almansi")):
        run = bench.run(Scene(cloud, [material(poisson=nu)], option), f"{nu} {option}")
        good &= run.end == "stopped" and "Poisson" in run.message
    return Found("-0.9 to 0.4999: error " + "; ".join(texts),
                 "near -1 the shear modulus is many times Young's, and so are errors at surfaces; "
                 "outside of "
                 "the range refused, and above 0.45 without averaged dilatation", good)


def squeezed(bench, gradient, values):
    """Limits up to which blocks return to a homogeneous state, with those of the law."""
    limits, good = [], True
    for what, cloud in blocks().items():
        gradients = {value: gradient(cloud.dimension, value) for value in values}
        limit, fine = stays(bench, what, cloud, ROCK, gradients)
        theory = last_of({value: wave_stability(F, ROCK) > 0 for value, F in gradients.items()})
        good &= fine
        limits.append(f"{limit} ({what}, law {theory})")
    return ", ".join(limits), good


RETURNS = ("returns to the homogeneous state from noise of 1e-3 spacings wherever the law is "
           "stable (positive acoustic tensor)")
COLLAPSES = ("collapses, as the law does: another equilibrium, or stopped with the particle that "
             "is turned inside out")


@case("90 % compression, one direction", "stretch 0.9 to 0.1 of a block whose rim is held, nu 0.3",
      RETURNS)
def compression(bench):
    limit, good = squeezed(bench, stretched, (0.9, 0.8, 0.75, 0.72, 0.7, 0.68, 0.66, 0.64, 0.62,
                                              0.6, 0.58, 0.56, 0.5, 0.4, 0.3, 0.2, 0.1))
    return Found("stretch " + limit, COLLAPSES, good)


@case("90 % compression, all directions", "stretch 0.9 to 0.1, the same block", RETURNS)
def hydrostatic(bench):
    limit, good = squeezed(bench, lambda d, s: s * np.eye(d), (0.95, 0.9, 0.88, 0.86, 0.84, 0.82,
                                                               0.8, 0.7, 0.5, 0.3, 0.1))
    return Found("stretch " + limit, COLLAPSES, good)


@case("10x stretch", "stretch 1.5 to 10, the same block", RETURNS, level="test")
def stretch(bench):
    limit, good = squeezed(bench, stretched, (1.5, 2.0, 3.0, 5.0, 7.0, 10.0))
    return Found("stretch " + limit, "not reached", good)


@case("simple shear", "shear 0.5 to 5, the same block", RETURNS, level="test")
def shear(bench):
    limit, good = squeezed(bench, sheared, (0.5, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0, 5.0))
    return Found("shear " + limit, COLLAPSES, good)


@case("stretch with free sides", "stretch 1.2 to 10 of a bar held at its ends, nu 0 and 0.3",
      "stress within 5 % of the law's, whose sides contract to nothing at the stretch sqrt(1 + "
      "1/nu') (nu' = nu/(1 - nu) in plane strain), up to 0.95 of that")
def free_sides(bench):
    limits, good, last_error = [], True, 0.0
    for what, cloud in {"2-D": lattice("square", (30, 8), SPACING, centre=True),
                        "3-D": lattice("sc", (20, 6, 6), SPACING, centre=True)}.items():
        middle = np.abs(cloud.X[:, 0]) < 2 * SPACING
        for nu in (0.0, 0.3):
            prime = nu / (1 - nu) if cloud.dimension == 2 else nu
            allowed = (1 + 1 / prime) ** 0.5 if nu else np.inf
            holds = {}
            for s in (1.2, 1.5, 1.7, 1.8, 1.9, 2.0, 2.05, 2.1, 2.5, 5.0, 10.0):
                side = max(1 - prime * (s**2 - 1), 0.01) ** 0.5
                F = stretched(cloud.dimension, s, *(side,) * (cloud.dimension - 1))
                run = equilibrium(bench, f"{what}, nu {nu}, {s}", cloud, [material(poisson=nu)],
                                  cloud.X @ F.T, ends(cloud), E)
                holds[s] = run.ok and s < allowed
                if holds[s]:
                    exact = law_stress(F, material(poisson=nu))[0, 0]
                    stress = run.run.frame("final")["c_watch[1]"][middle]
                    holds[s] = run.measured(np.abs(stress / exact - 1).max()) < 0.05
            good &= all(held for s, held in holds.items() if s < 0.95 * allowed)
            limits.append(f"{last_of(holds)} ({what}, nu {nu}, law {allowed:.3g})")
    return Found(", ".join(limits), "the law has no width left: thin and bounded, or stopped with "
                 "the particle that is turned inside out", good)


@case("rigid rotation",
      "turned by 90, 180 and 137 degrees about skew axes and moved by 0 to 1e9 spacings",
      "no stress but round-off: below 10 times 2^-53 u/spacing, in units of E", level="test")
def rigid(bench):
    worst, last = 0.0, 0.0
    for what, cloud in blocks(small=True).items():
        d = cloud.dimension
        for degrees in (90, 180, 137):
            c, s = np.cos(np.radians(degrees)), np.sin(np.radians(degrees))
            turn = np.eye(d)
            turn[:2, :2] = [[c, -s], [s, c]]
            if d == 3:
                skew = np.linalg.qr(np.array([[1.0, 2, 3], [2, -1, 1], [0, 1, 2]]))[0]
                turn = skew @ turn @ skew.T
            for distance in (0.0, 1e3, 1e6, 1e9):
                X = cloud.X @ turn.T + distance * SPACING
                scene = Scene(cloud, [ROCK]).add("run 0").move(X)
                run = bench.run(scene, f"{what}, {degrees}, {distance:g}")
                if not run.ok:
                    return Found(f"{distance:g} spacings", run.message, False)
                stress = np.abs(stresses(run.run.frame("final"), d)).max() / E
                shift = np.abs(X - cloud.X).max() / SPACING
                run.measured(stress)
                worst = max(worst, stress / (shift * 2.0**-53))
    return Found(f"all; largest stress {worst:.1f} times 2^-53 u/spacing E: 1e-7 E at 1e9 "
                 "spacings",
                 "bounded: round-off of the displacement", worst < 10)


@case("released from extreme strain",
      "a free block starts uniformly stretched by 0.7 to 10 or sheared by 1 to 5; minimizers "
      "tmsph/lbfgs, cg, fire",
      "back without strain: energy below 1e-6 of that at the start, or stopped, or told that it "
      "stopped early", level="full")
def released(bench):
    states = {f"stretch {s}": (s, 0.0) for s in (0.7, 0.85, 1.5, 3.0, 10.0)}
    states |= {f"shear {g}": (1.0, g) for g in (1.0, 5.0)}
    good, texts = True, []
    for style in ("tmsph/lbfgs", "cg", "fire"):
        back = []
        for what, cloud in blocks(small=True).items():
            for state, (s, gamma) in states.items():
                F = s * sheared(cloud.dimension, gamma)
                run = equilibrium(bench, f"{style}, {what}, {state}", cloud, [ROCK], cloud.X @ F.T,
                                  np.zeros(len(cloud), bool), 1e-6 * E, style=style,
                                  iterations=20000)
                if not run.ok:
                    good &= run.end == "stopped"
                    continue
                energy = run.run.thermo("PotEng")
                left = run.measured(energy[-1] / energy[0])
                told = "force tolerance" not in run.run.log
                good &= left < 1e-6 or told
                if left < 1e-6:
                    back.append(state)
        texts.append(f"{style} {len(back)} of {2 * len(states)}")
    return Found("back from: " + ", ".join(texts), "minimizer ends at its limits, bounded", good)


def heated_inclusion(dimension):
    """A disc, or a ball, with an inclusion, its two materials, and Lame's contact pressure per
    degree, in plane strain or 3-D."""
    pair = disc_materials(False)
    if dimension == 2:
        cloud, a, R = lattice("hex", (38, 22), SPACING, centre=True), 6.0, 18.0
    else:
        cloud, a, R = lattice("sc", (18, 18, 18), SPACING, centre=True), 4.5, 9.0
    r = np.linalg.norm(cloud.X, axis=1) / SPACING
    cloud.type[r > a] = 2
    cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= R * SPACING)
    volume = lambda chosen: chosen.sum() * cloud.volume[0] / SPACING**dimension
    radius = lambda v: (v / np.pi) ** 0.5 if dimension == 2 else (3 * v / (4 * np.pi)) ** (1 / 3)
    a, R = radius(volume(cloud.type == 1)), radius(volume(cloud.type > 0))
    if dimension == 2:
        return cloud, pair, contact_pressure(pair, "strain", a, R, 1.0)
    inner, outer = pair
    compliance = (1 - 2 * inner["poisson"]) / inner["young"] + (
        (1 + outer["poisson"]) * R**3 / 2 + (1 - 2 * outer["poisson"]) * a**3
    ) / (outer["young"] * (R**3 - a**3))
    return cloud, pair, (inner["expansion"] - outer["expansion"]) / compliance


@case("temperature jump",
      "disc and ball with an inclusion, 1 to 1e5 degrees in one step, thermal bond and strain",
      "pressure in the core within a spacing over its radius of Lame's, and in proportion to the "
      "jump within 4 times the thermal strain, 6 % at 1000 degrees")
def jump(bench):
    good, texts = True, []
    for dimension in (2, 3):
        cloud, pair, lame = heated_inclusion(dimension)
        core = np.linalg.norm(cloud.X, axis=1) < 3 * SPACING
        for mode in ("bond", "strain"):
            found = {}
            for degrees in (1.0, 100.0, 1000.0, 1e4, 1e5):
                expected, patience = lame * degrees, 1000 if degrees < 5000 else 200
                run = equilibrium(bench, f"{dimension}-D, {mode}, {degrees:g}", cloud, pair,
                                  cloud.X, np.zeros(len(cloud), bool), expected,
                                  f"thermal {mode}", residual=1e-5, iterations=patience,
                                  temperature=degrees)
                if run.ok:
                    s = stresses(run.run.frame("final"), dimension)[core].mean(axis=0)
                    found[degrees] = run.measured(-np.trace(s) / dimension / expected)
            good &= abs(found[1.0] - 1) < 1 / (6 if dimension == 2 else 4.5)
            good &= all(abs(found[t] / found[1.0] - 1) < 4 * 1.5e-5 * t for t in (100.0, 1000.0))
            texts.append(f"{', '.join(f'{p:.3f}' for p in list(found.values())[:3])} "
                         f"({dimension}-D, {mode})")
    return Found("1000 degrees: pressure over Lame's at 1, 100, 1000 degrees: " + "; ".join(texts),
                 "1e4 and 1e5 degrees, where rock has melted: strains of order 1, bounded", good)
