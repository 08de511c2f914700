# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Breaking: total, sudden, under pressure, of extreme rocks, and what comes after it."""

from math import gamma

import numpy as np

from bodies import E, ROCK, SPACING, blocks, rim, roomy, stresses, stretched, wave_speed
from cases import GOOD, Found, case, marching
from tmsph_testing import HORIZON, Cloud, Scene, disc_materials, lattice, material

C = wave_speed(ROCK)
HEAVY = "hourglass 0.5 viscosity 1 2"    # as advised where much breaks
DT = 0.3 * SPACING / C


def bond_count(cloud, horizon=HORIZON):
    R = np.linalg.norm(cloud.X[:, None] - cloud.X[None], axis=2)
    return int((np.triu(R, 1)[np.triu_indices(len(cloud), 1)] < horizon * cloud.spacing).sum())


def rock(strength, words="mi * 8"):
    return f"fix rock all tmsph/hoekbrown strength * {strength:.17g} {words}"


def highest(run):
    """Total energy over its start."""
    energy = run.run.thermo("TotEng", -1)
    return run.measured(energy.max() / energy[0] - 1)


def included(dimension):
    """A disc, or a ball, with an inclusion."""
    if dimension == 2:
        cloud = lattice("hex", (24, 14), SPACING, centre=True)
        cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) < 10.2 * SPACING)
    else:
        cloud = lattice("sc", (12, 12, 12), SPACING, centre=True)
        cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) < 5.7 * SPACING)
    cloud.type[np.linalg.norm(cloud.X, axis=1) > 3.5 * SPACING] = 2
    return cloud


def tension_strength(strength, mi, gsi):
    """Of a bar that may contract freely: the tension t at which the criterion of 2002 with
    sigma_1 = 0, sigma_3 = -t is met, or its parenthesis vanishes."""
    mb, s = mi * np.exp((gsi - 100) / 28), np.exp((gsi - 100) / 9)
    a = 0.5 + (np.exp(-gsi / 15) - np.exp(-20 / 3)) / 6
    low, high = 0.0, s * strength / mb
    for _ in range(200):
        t = (low + high) / 2
        due = t >= strength * max(s - mb * t / strength, 0.0) ** a
        low, high = (low, t) if due else (t, high)
    return high


@case("total fragmentation",
      "strength 1 Pa down to 1e-300: a stretched block, all of whose bonds are due at once",
      "all break in the first step; 2000 steps later there is no stress but that of contacts, and "
      "the kinetic energy of the fragments is below the elastic energy of the start")
def total(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        bonds = bond_count(cloud)
        for strength in (1.0, 1e-300):
            for touch in ("", "fix touch all tmsph/contact friction * * 0.5"):
                scene = Scene(cloud, [ROCK], HEAVY).add("run 0").move(1.001 * cloud.X)
                scene.add(rock(strength)).thermo("step etotal ke f_rock", 1).add(touch)
                run = bench.run(scene, f"{what}, {strength:g}, {'contact' if touch else 'none'}",
                                marching(DT, 2000), every=1000)
                if not run.ok:
                    good = False
                    continue
                broken = run.run.thermo("f_rock")
                energy = run.run.thermo("KinEng").max() / run.run.thermo("TotEng", -1)[0]
                run.measured(energy)
                frame = run.run.frame("final")
                good &= broken[1] == bonds and energy < 1.01
                good &= bool(touch) or np.abs(stresses(frame, cloud.dimension)).max() == 0.0
        texts.append(f"all {bonds} ({what})")
    return Found(", ".join(texts), "not reached: single particles fly on", good)


@case("total fragmentation at rest",
      "strength 1 Pa: the same block in a quasi-static step, and then 10 steps more",
      "ends, all bonds broken", level="test")
def total_static(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        bonds = bond_count(cloud)
        scene = Scene(cloud, [ROCK], HEAVY).add("run 0").move(1.001 * cloud.X)
        rows = np.flatnonzero(rim(cloud, 1)) + 1
        scene.add("group held id " + " ".join(map(str, rows)) + "\nfix hold held setforce 0 0 0")
        scene.add(rock(1.0)).thermo("step pe f_rock", 1)
        run = bench.run(scene, what, "timestep 1.0\ntmsph/quasistatic 1 evaluations 300\n"
                        "tmsph/quasistatic 10 evaluations 300", every=10, timeout=120)
        good &= run.ok
        if run.ok:
            broken = run.measured(run.run.thermo("f_rock")[-1] / bonds)
            texts.append(f"{100 * broken:.1f} % ({what})")
    return Found("bonds broken: " + ", ".join(texts), "warned where no equilibrium was found", good)


@case("temperature jump with fracture",
      "disc and ball with an inclusion, 10 to 1000 degrees in one step, hourglass 0.5, viscosity "
      "1 2, 0.3 dx/c, with and without contact, 1000 steps",
      "the energy that the jump brings only falls, within 2 %")
def jump(bench):
    good, texts = True, []
    for dimension in (2, 3):
        cloud, found = included(dimension), {}
        for degrees in (10.0, 100.0, 300.0, 1000.0):
            for touch in (False, True):
                scene = Scene(cloud, disc_materials(False), HEAVY)
                scene.add(f"run 0\nset group all temperature {degrees}")
                scene.add(rock(120e6, "mi * 8 weibull * 10 4711")).thermo("step etotal f_rock", 1)
                if touch:
                    scene.add("fix touch all tmsph/contact friction * * 0.5\n"
                              "fix_modify touch energy yes")
                run = bench.run(scene, f"{dimension}-D, {degrees:g}, contact {touch}",
                                marching(DT, 1000), every=200)
                good &= run.ok and highest(run) < 0.02
                if run.ok:
                    found[degrees] = run.run.thermo("f_rock")[-1]
        texts.append(" / ".join(f"{n:.0f}" for n in found.values()) + f" ({dimension}-D)")
    return Found("1000 degrees; bonds broken at 10 / 100 / 300 / 1000: " + ", ".join(texts),
                 "not reached", good)


@case("broken while squeezed by 90 %",
      "a block between two walls that come closer until a tenth of its length is left, at 0.02 and "
      "0.1 of the wave speed, strength 1 Pa and 100 MPa; debris or contact with friction 0.5",
      "ends, or stopped; the energy without that of fix tmsph/contact stays below the work of the "
      "walls within 2 %")
def squeezed(bench):
    good, texts = True, []
    for what, cloud in blocks(small=True).items():
        left, right = cloud.X[:, 0].min() - SPACING / 2, cloud.X[:, 0].max() + SPACING / 2
        length, holds, d = right - left, {}, cloud.dimension
        for strength in (1.0, 1e8):
            for touch in (False, True):
                for speed in (0.02, 0.1):
                    v = speed * C / 2
                    steps = int(0.9 * length / (2 * v) / DT)
                    zero = " 0" if d == 3 else ""
                    shapes = ((f"line {left:.9g} 1 {left:.9g} -1",
                               f"line {right:.9g} -1 {right:.9g} 1") if d == 2 else
                              (f"plane {left:.9g} 0 0 1 0 0", f"plane {right:.9g} 0 0 -1 0 0"))
                    scene = roomy(Scene(cloud, [ROCK], HEAVY))
                    scene.add(rock(strength, "mi * 8 weibull * 10 4711"))
                    if touch:
                        scene.add("fix touch all tmsph/contact friction * * 0.5")
                    for k, (shape, sign) in enumerate(zip(shapes, (1, -1))):
                        scene.add(f"fix w{k} all tmsph/wall {shape} velocity {sign * v:.9g} 0{zero}"
                                  f"\nfix_modify w{k} energy yes")
                    scene.thermo("step etotal f_w0[1] f_w1[1] f_rock", 1)
                    run = bench.run(scene, f"{what}, {strength:g}, contact {touch}, {speed}",
                                    marching(DT, steps), every=max(1, steps // 5))
                    good &= run.end in GOOD
                    holds[strength, touch, speed] = run.ok
                    if run.ok:
                        power = v * (run.run.thermo("f_w1[1]") - run.run.thermo("f_w0[1]"))
                        work = np.concatenate([[0], np.cumsum((power[1:] + power[:-1]) / 2)]) * DT
                        energy = run.run.thermo("TotEng")
                        excess = (energy - energy[0] - work).max() / max(work.max(), 1e-300)
                        good &= run.measured(excess) < 0.02
        bad = [f"{s:g} Pa, contact {t}, {v}" for (s, t, v), held in holds.items() if not held]
        texts.append(f"{sum(holds.values())} of {len(holds)} reach 90 % ({what}"
                     + (f"; not {', '.join(bad)})" if bad else ")"))
    return Found("; ".join(texts), "a particle is turned inside out: stopped", good)


@case("long after fragmentation",
      "a block torn apart with edges moving out at 0.02 of the wave speed, Weibull modulus 1 and "
      "10, in a box of walls, contact with friction 0.5: 20 000 steps",
      "the energy, contacts included, never rises above its start by more than 2 %")
def long_after(bench):
    good, texts = True, []
    bodies = {"2-D": lattice("square", (12, 12), SPACING, centre=True),
              "3-D": lattice("sc", (5, 5, 5), SPACING, centre=True)}
    for what, cloud in bodies.items():
        d, h = cloud.dimension, np.abs(cloud.X).max() + 3 * SPACING
        walls = ([f"polyline 5 {-h} {-h} {h} {-h} {h} {h} {-h} {h} {-h} {-h}"] if d == 2 else
                 ["plane " + " ".join(f"{x:.9g}" for x in (*(-s * h * n), *(s * n)))
                  for n in np.eye(3) for s in (1, -1)])
        for modulus in (1, 10):
            v = 0.02 * C * cloud.X / np.abs(cloud.X).max()
            scene = Scene(cloud, [ROCK], HEAVY).set("vx vy vz"[: 3 * d - 1], v)
            scene.add(rock(1e8, f"mi * 8 weibull * {modulus} 4711"))
            scene.add("fix touch all tmsph/contact friction * * 0.5\nfix_modify touch energy yes")
            for k, wall in enumerate(walls):
                scene.add(f"fix w{k} all tmsph/wall {wall} friction 0.5\n"
                          f"fix_modify w{k} energy yes")
            scene.thermo("step etotal ke f_rock", 10)
            run = bench.run(scene, f"{what}, Weibull {modulus}", marching(DT, 20000), every=4000,
                            timeout=120)
            good &= run.ok and highest(run) < 0.02
            if run.ok:
                moving = run.run.thermo("KinEng")[-1] / run.run.thermo("TotEng", -1)[0]
                texts.append(f"{run.run.thermo('f_rock')[-1] / bond_count(cloud):.0%} broken, "
                             f"{moving:.1g} "
                             f""
                             f"of the energy left as motion ({what}, modulus {modulus})")
    return Found("20 000 steps: " + "; ".join(texts), "not reached", good)


@case("strength contrast",
      "two bonded materials of equal stiffness, strength 1:1 to 1:1e6, stretched by 1e-4 in one "
      "step",
      "only bonds of the weak one break, and with 1:1 none", level="test")
def contrast(bench):
    good, texts = True, []
    m = material(E, 0.0)
    strong = 2 * 1e-4 * E * 9 * 8      # sigma_t is sigma_c/8.1
    bodies = {"2-D": lattice("square", (16, 6), SPACING, centre=True),
              "3-D": lattice("sc", (14, 4, 4), SPACING, centre=True)}
    for what, cloud in bodies.items():
        two = Cloud(cloud.X, cloud.volume[0], SPACING)
        two.type[cloud.X[:, 0] > 0] = 2
        inside = cloud.X[:, 0] < -HORIZON * SPACING
        for ratio in (1.0, 1e2, 1e4, 1e6):
            scene = Scene(two, [m, m], HEAVY).add("run 0").move(
                cloud.X @ stretched(cloud.dimension, 1 + 1e-4))
            scene.add(f"fix rock all tmsph/hoekbrown strength 1 {strong:.17g} "
                      f"strength 2 {strong / ratio:.17g} mi * 8").thermo("step etotal f_rock", 1)
            run = bench.run(scene, f"{what}, {ratio:g}", marching(DT, 1), every=1)
            if not run.ok:
                good = False
                continue
            damage = run.run.frame("final")["c_watch[8]"]
            weak = cloud.X[:, 0] > HORIZON * SPACING
            run.measured(damage[weak].mean())
            good &= not damage[inside].any() and (damage[weak].min() == 1) == (ratio > 1)
            good &= damage.any() == (ratio > 1)
        texts.append(what)
    return Found("1:1e6, " + ", ".join(texts), "not reached", good)


@case("Weibull modulus",
      "1e-3 to 1e6",
      "mean of the strengths within 4 standard errors of scale Gamma(1 + 1/modulus), from 0.5 on; "
      "finite, or refused", level="test")
def weibull(bench):
    good, done = True, []
    cloud = lattice("square", (40, 40), SPACING)
    for modulus in (1e-3, 0.1, 0.5, 1.0, 10.0, 100.0, 1e4, 1e6):
        scene = Scene(cloud, [ROCK], HEAVY).add(rock(1e8, f"mi * 8 weibull * {modulus:g} 4711"))
        scene.add("compute s all tmsph/property/atom strength\ncompute mean all reduce ave c_s\n"
                  "compute least all reduce min c_s").thermo("step etotal f_rock c_mean c_least")
        run = bench.run(scene, f"{modulus:g}", marching(DT, 20), every=10)
        good &= run.end in GOOD
        if not run.ok:
            continue
        done.append(modulus)
        if modulus >= 0.5:
            mean = gamma(1 + 1 / modulus)
            error = ((gamma(1 + 2 / modulus) - mean**2) / len(cloud)) ** 0.5
            found = run.measured(run.run.thermo("c_mean")[-1] / 1e8)
            good &= abs(found - mean) < 4 * error + 1e-12
    return Found(f"{min(done):g} to {max(done):g}" if done else "none",
                 "below 0.1, where strengths are next to 0 or infinite: refused", good)


@case("extreme rocks",
      "m_i 1e-3, 1, 8, 33, 1e3 and GSI 1, 10, 50, 100: a homogeneous stretch, nu 0, to 0.99 and to "
      "1.01 of the tensile strength",
      "no bond breaks below, all above", level="test")
def rocks(bench):
    good, count = True, 0
    m = material(E, 0.0)
    for what, cloud in blocks(small=True).items():
        for mi in (1e-3, 1.0, 8.0, 33.0, 1e3):
            for gsi in (1, 10, 50, 100):
                strength = 1e8
                limit = tension_strength(strength, mi, gsi)
                for share in (0.99, 1.01):
                    # Cauchy stress s (s^2 - 1)/2 E of a stretch s along x with nu 0
                    low, high = 0.0, 0.1
                    for _ in range(200):
                        e = (low + high) / 2
                        s = (1 + e) * e * (2 + e) / 2 * E
                        low, high = (e, high) if s < share * limit else (low, e)
                    scene = Scene(cloud, [m]).add("run 0").move(
                        cloud.X @ stretched(cloud.dimension, 1 + high))
                    scene.add(rock(strength, f"mi * {mi:g} gsi * {gsi}"))
                    scene.thermo("step f_rock", 1)
                    run = bench.run(scene, f"{what}, mi {mi:g}, GSI {gsi}, {share}",
                                    marching(1e-6 * DT, 1), every=1)
                    bonds = bond_count(cloud)
                    broken = run.run.thermo("f_rock")[-1] / bonds if run.ok else np.nan
                    right = run.measured(broken) == (0 if share < 1 else 1)
                    count += right
                    good &= right
    return Found(f"{count} of 80 states right", "not reached", good)


@case("no stress comes back",
      "the disc at 100 and 300 degrees in one step, without and with contact, 0.3 dx/c, 700 steps: "
      "particles lose their stress and then more bonds",
      "the energy that the jump brings only falls, within 2 %", level="test")
def comes_back(bench):
    good, cloud, rises = True, included(2), []
    for degrees, touch in ((300.0, ""), (100.0, "fix touch all tmsph/contact friction * * 0.5")):
        scene = Scene(cloud, disc_materials(False), HEAVY)
        scene.add(f"run 0\nset group all temperature {degrees}\n"
                  + rock(120e6, "mi * 8 weibull * 10 4711")).add(touch)
        run = bench.run(scene.thermo("step etotal", 1), f"{degrees:g} {touch}", marching(DT, 700),
                        every=350)
        rises.append(highest(run) if run.ok else np.inf)
        good &= rises[-1] < 0.02
    return Found(f"rise {', '.join(f'{rise:.2g}' for rise in rises)}", "not reached", good)
