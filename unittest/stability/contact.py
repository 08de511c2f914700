# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Contact of bodies with each other and with walls, and of dust."""

import numpy as np

from bodies import E, RHO, ROCK, SPACING, blocks, noise, stresses, wave_speed
from cases import GOOD, Found, case, last_of, marching
from tmsph_testing import Cloud, Scene, lattice, material

C = wave_speed(ROCK)
DT = 0.4 * SPACING / C
BODIES = ("kinetic and elastic energy of the bodies never rise above their start by more than 1 %, "
          "until they have parted")
NEVER = "the total energy, contacts included, never rises above its start by more than 1 %"


def two_blocks(gap=1.0):
    """Two blocks of types 1 and 2, one behind the other along x; gap in spacings between the
    outermost particles."""
    pairs = {}
    for what, (name, cells) in {"2-D": ("square", (8, 7)), "3-D": ("sc", (5, 4, 4))}.items():
        one = lattice(name, cells, SPACING)
        two = one.X + np.eye(one.dimension)[0] * (np.ptp(one.X[:, 0]) + gap * SPACING)
        both = Cloud(np.vstack([one.X, two]), one.volume[0], SPACING)
        both.type[len(one):] = 2
        pairs[what] = both
    return pairs


def separate(cloud, materials, words="", pair="viscosity 1 2", stored=True):
    """A scene of two bodies that touch each other only; stored: count the energy of contacts."""
    scene = Scene(cloud, materials, pair).add("pair_coeff 1 2 none")
    scene.add(f"fix touch all tmsph/contact {words}")
    if stored:
        scene.add("fix_modify touch energy yes")
    return scene.thermo("step etotal", 1)


def approaching(cloud, speed):
    """Velocities along x: both bodies come closer with that speed together."""
    return np.where(cloud.type == 1, speed / 2, -speed / 2)


def floor(dimension):
    """The wall at y = 0, material above it."""
    return "line -1 0 1 0" if dimension == 2 else "plane 0 0 0 0 1 0"


def rise(run):
    """Of the total energy over its start."""
    energy = run.run.thermo("TotEng", -1)
    return run.measured(energy.max() / energy[0] - 1)


def by_stiffness(bench, what, law, scene_of, factors):
    """Whether the energy is kept, by the stiffness of the contact."""
    kept = {}
    for factor in factors:
        run = bench.run(scene_of(f"law {law} stiffness {factor:g}"), f"{what}, {law}, {factor:g}",
                        marching(DT, 400), every=200)
        kept[factor] = run.ok and rise(run) < 0.01
    return kept


@case("stiffness of contacts of bodies",
      "two blocks hit each other at 0.01 of the wave speed with 0.4 dx/c; stiffness 1e-3 to 1e12 "
      "of the default, laws implicit and penalty",
      f"implicit, up to 1e6, and penalty, at the default: {BODIES}")
def pair_stiffness(bench):
    good, limits = True, []
    for what, cloud in two_blocks(1.0).items():
        def scene(words):
            return separate(cloud, [ROCK, ROCK], words, stored=False).set(
                "vx", approaching(cloud, 0.01 * C))
        firm = by_stiffness(bench, what, "implicit", scene, (1e-3, 1.0, 1e3, 1e6, 1e9, 1e12))
        explicit = by_stiffness(bench, what, "penalty", scene, (0.1, 1.0, 3.0, 10.0, 1e3, 1e6))
        good &= last_of(firm) >= 1e6 and explicit[1.0]
        limits.append(f"implicit {last_of(firm)}, penalty {last_of(explicit)} ({what})")
    return Found("of the default: " + ", ".join(limits),
                 "penalty: energy is fed or a particle is turned inside out: bounded or stopped",
                 good)


@case("stiffness of walls",
      "a block hits a wall at 0.01 of the wave speed with 0.4 dx/c; stiffness 1e-3 to 1e12 of the "
      "default, laws implicit and penalty",
      f"implicit, up to 1e6, and penalty, at the default: {BODIES}", level="test")
def wall_stiffness(bench):
    good, limits = True, []
    for what, cloud in blocks(small=True).items():
        cloud.X[:, 1] += 0.6 * SPACING - cloud.X[:, 1].min()

        def scene(words):
            falling = Scene(cloud, [ROCK], "viscosity 1 2").thermo("step etotal", 1)
            falling.set("vy", np.full(len(cloud), -0.01 * C))
            return falling.add(f"fix wall all tmsph/wall {floor(cloud.dimension)} {words}")
        firm = by_stiffness(bench, what, "implicit", scene, (1e-3, 1.0, 1e3, 1e6, 1e9, 1e12))
        explicit = by_stiffness(bench, what, "penalty", scene, (0.1, 1.0, 3.0, 10.0, 1e3, 1e6))
        good &= last_of(firm) >= 1e6 and explicit[1.0]
        limits.append(f"implicit {last_of(firm)}, penalty {last_of(explicit)} ({what})")
    return Found("of the default: " + ", ".join(limits),
                 "penalty: energy is fed or a particle is turned inside out: bounded or stopped",
                 good)


@case("time step of a penalty",
      "a single particle pressed on a wall, stiffness 2 % (w dt 1 %) below and above "
      "the limit, and 2 "
      "times; implicit 1e6 times",
      "penalty: comes to rest 1 % below, and not 1 % above, w dt = 2 (sqrt(1 + z^2) - "
      "z) with damping z = 0.2 of "
      "velocities half a step old; implicit: always", level="test")
def penalty_step(bench):
    z, good, texts = 0.2, True, []
    limit = 2 * ((1 + z * z) ** 0.5 - z)
    for what, block in blocks(small=True).items():
        d = block.dimension
        X = block.X + np.eye(d)[1] * 40 * SPACING
        cloud = Cloud(np.vstack([X, [[0.0, 0.5 * SPACING, 0.0][:d]]]), block.volume[0], SPACING)
        n, mass = len(cloud), RHO * cloud.volume[0]
        k = 1.135 * E / (1 - 0.3**2) * cloud.volume[0] / SPACING**2
        unit = limit**2 * mass / (k * DT**2)      # stiffness at the limit
        for law, shares in (("penalty", (0.5, 0.98, 1.02, 2.0)), ("implicit", (1.0, 1e6))):
            for share in shares:
                static = 1e-6 * SPACING / max(1, share)
                force = static * k * share * unit
                scene = Scene(cloud, [ROCK])
                scene.add(f"group one id {n}\nfix press one addforce 0 {-force:.17g} 0\n"
                          f"fix wall one tmsph/wall {floor(d)} law {law} "
                          f"stiffness {share * unit:.17g}").thermo("step f_wall[9]", 1)
                depth = np.zeros(n)
                depth[-1] = 1.01 * static
                scene.add("run 0").set("y", cloud.X[:, 1] - depth)
                run = bench.run(scene, f"{what}, {law}, {share:g}", marching(DT, 1500), every=500)
                deep = run.run.thermo("f_wall[9]") if run.ok else np.array([np.inf])
                off = run.measured(np.abs(deep[-100:] / static - 1).max())
                stable = off < 1e-3
                good &= stable == (share < 1 or law == "implicit")
                texts.append(f"{law} {share:g} {'stable' if stable else 'not'} ({what})")
    return Found(f"w dt = {limit:.3f} within 1 %: " + ", ".join(texts),
                 "the particle hops on the wall, bounded", good)


@case("stiffness contrast in contact",
      "two blocks pressed on each other between held ends, nu 0, E1/E2 1 to 1e6",
      "stress of the soft block within 1 % of that at equal stiffness, and within 2 % of that in "
      "series in 2-D; equilibrium found",
      level="test")
def contact_contrast(bench):
    good, texts = True, []
    for what, cloud in two_blocks(1.0).items():
        found = {}
        for ratio in (1.0, 1e2, 1e4, 1e6):
            stiff, soft = material(E, 0.0), material(E / ratio, 0.0)
            strain = np.where(cloud.type == 1, -1e-4 / ratio, -1e-4)
            face = (cloud.X[cloud.type == 1, 0].max() + cloud.X[cloud.type == 2, 0].min()) / 2
            X = cloud.X.copy()
            X[:, 0] += strain * (cloud.X[:, 0] - face)
            depth = np.minimum(X[:, 0] - X[:, 0].min(), X[:, 0].max() - X[:, 0])
            rows = np.flatnonzero(depth < 1.2 * SPACING) + 1
            scene = Scene(cloud, [stiff, soft]).add("pair_coeff 1 2 none")
            scene.add(f"group held id {' '.join(map(str, rows))}\nfix hold held setforce 0 0 0\n"
                      "fix touch all tmsph/contact\nfix_modify touch energy yes\nrun 0")
            scene.move(X + noise(cloud, 1e-6))
            stress = 1e-4 * soft["young"]
            residual = 1e-4 * stress * SPACING ** (cloud.dimension - 1) * len(cloud) ** 0.5
            run = bench.run(scene, f"{what}, {ratio:g}", "min_style tmsph/lbfgs\n"
                            f"minimize 0 {residual:.6g} 4000 12000", every=10**6)
            if run.ok:
                s = stresses(run.run.frame("final"), cloud.dimension)[:, 0, 0]
                inner = (cloud.type == 2) & (cloud.X[:, 0] > face + 2 * SPACING) & (depth > SPACING)
                found[ratio] = run.measured(s[inner].mean() / -stress)
            good &= run.ok and abs(found[ratio] / found[1.0] - 1) < 0.01
            good &= what == "3-D" or abs(found[ratio] - 1) < 0.02
        texts.append(" / ".join(f"{s:.4f}" for s in found.values()) + f" ({what})")
    return Found("stress over exact at 1 / 1e2 / 1e4 / 1e6: " + ", ".join(texts), "not reached",
                 good)


@case("impact of two bodies",
      "two blocks from 4 spacings apart hit each other with 0.01 to 1 of the wave speed, viscosity "
      "1 2",
      f"up to 0.2: {BODIES}; momentum kept to 1e-9; they part again", level="test")
def two_bodies(bench):
    good, limits = True, []
    for what, cloud in two_blocks(4.0).items():
        bounces = {}
        for speed in (0.01, 0.1, 0.2, 0.5, 1.0):
            v = approaching(cloud, speed * C)
            scene = separate(cloud, [ROCK, ROCK], stored=False).set("vx", v)
            steps = int((8 / speed + 60) * SPACING / C / (0.5 * DT))
            run = bench.run(scene, f"{what}, {speed}", marching(0.5 * DT, steps), every=steps // 4)
            bounces[speed] = run.ok
            if run.ok:
                frame = run.run.frame("final")
                apart = frame["vx"][cloud.type == 2].mean() - frame["vx"][cloud.type == 1].mean()
                momentum = abs(frame["vx"].mean()) / (speed * C)
                bounces[speed] = rise(run) < 0.01 and momentum < 1e-9 and apart > 0
            good &= bounces[speed] or speed > 0.2 and run.end in GOOD
        limits.append(f"{last_of(bounces)} ({what})")
    return Found("relative speed over that of waves: " + ", ".join(limits),
                 "faster than the law of the solid can stop: turned inside out, stopped", good)


@case("friction",
      "a block slides on a wall, and a block on another, under pressure, friction 0 to 10 and "
      "1e6, at 0.01 of the wave speed",
      f"{NEVER}; the work of friction never falls", level="test")
def friction(bench):
    good, texts = True, []
    for mu in (0.0, 0.3, 1.0, 3.0, 10.0, 1e6):
        for what, cloud in blocks(small=True).items():
            cloud.X[:, 1] += 0.5 * SPACING - cloud.X[:, 1].min()
            v = np.zeros_like(cloud.X)
            v[:, 0], v[:, 1] = 0.01 * C, -0.002 * C
            scene = Scene(cloud, [ROCK], "viscosity 1 2").set("vx vy", v[:, :2])
            scene.add(f"fix wall all tmsph/wall {floor(cloud.dimension)} friction {mu:g}\n"
                      "fix_modify wall energy yes").thermo("step etotal f_wall[7]", 1)
            run = bench.run(scene, f"{what}, wall, {mu:g}", marching(DT, 400), every=200)
            work = run.run.thermo("f_wall[7]") if run.ok else np.array([1.0, 0.0])
            good &= run.ok and rise(run) < 0.01
            good &= np.diff(work).min() >= -1e-12 * np.abs(work).max()
        for what, cloud in two_blocks(1.0).items():
            scene = separate(cloud, [ROCK, ROCK], f"friction * * {mu:g}")
            v = np.zeros_like(cloud.X)
            v[:, 0], v[:, 1] = approaching(cloud, 0.004 * C), approaching(cloud, 0.01 * C)
            scene.set("vx vy", v[:, :2]).thermo("step etotal f_touch[7]", 1)
            run = bench.run(scene, f"{what}, bodies, {mu:g}", marching(DT, 400), every=200)
            work = run.run.thermo("f_touch[7]") if run.ok else np.array([1.0, 0.0])
            good &= run.ok and rise(run) < 0.01
            good &= np.diff(work).min() >= -1e-12 * np.abs(work).max()
        texts.append(f"{mu:g}")
    return Found("friction " + ", ".join(texts), "not reached: sticks", good)


@case("deep overlap",
      "two bodies, and a body and a wall, pushed into each other by 0.1 to 3 spacings at once",
      f"up to 1 spacing, between bodies 3: {NEVER}; beyond, where a wall takes back what comes "
      "within a spacing behind it: bounded by 10 times, or stopped")
def overlap(bench):
    good, limits = True, []
    for what, cloud in two_blocks(1.0).items():
        holds = {}
        for depth in (0.1, 0.3, 0.6, 1.0, 2.0, 3.0):
            X = cloud.X.copy()
            X[cloud.type == 2, 0] -= depth * SPACING
            scene = separate(cloud, [ROCK, ROCK]).add("run 0").move(X)
            run = bench.run(scene, f"{what}, bodies, {depth}", marching(0.5 * DT, 600), every=100)
            holds[depth] = run.ok and rise(run) < 0.01
            good &= holds[depth] or run.end == "stopped"
        limits.append(f"bodies {last_of(holds)} ({what})")
    for what, cloud in blocks(small=True).items():
        holds = {}
        for depth in (0.1, 0.3, 0.6, 1.0, 2.0, 3.0):
            cloud.X[:, 1] += (0.5 - depth) * SPACING - cloud.X[:, 1].min()
            scene = Scene(cloud, [ROCK], "viscosity 1 2").thermo("step etotal", 1)
            scene.add(f"fix wall all tmsph/wall {floor(cloud.dimension)}\n"
                      "fix_modify wall energy yes")
            run = bench.run(scene, f"{what}, wall, {depth}", marching(0.5 * DT, 600), every=100)
            holds[depth] = run.ok and rise(run) < 0.01
            good &= holds[depth] or depth > 1 and (run.end == "stopped" or run.figure < 10)
        limits.append(f"wall {last_of(holds)} ({what})")
    return Found("spacings: " + ", ".join(limits),
                 "warned at the start; energy of those that the wall takes back, bounded", good)


@case("sharp V",
      "a disc, and a ball, thrown into a V with an angle of 150 to 5 degrees at 0.005 of the wave "
      "speed, friction 0 and 1",
      f"{NEVER}; the middle never passes the corner")
def sharp_v(bench):
    good, narrowest = True, []
    bodies = {"2-D": lattice("hex", (10, 6), SPACING, centre=True),
              "3-D": lattice("sc", (6, 6, 6), SPACING, centre=True)}
    for what, cloud in bodies.items():
        radius = 4.7 if what == "2-D" else 3.1
        round_ = cloud.kept(lambda X: np.linalg.norm(X, axis=1) < radius * SPACING)
        holds = {}
        for angle in (150, 90, 45, 20, 10, 5):
            half = np.radians(angle / 2)
            lift = (radius + 1) * SPACING / np.sin(half)
            body = Cloud(round_.X + np.eye(round_.dimension)[1] * lift, round_.volume[0], SPACING)
            a, b = 100 * np.sin(half), 100 * np.cos(half)
            if what == "2-D":
                walls = [f"polyline 3 {-a:.9g} {b:.9g} 0 0 {a:.9g} {b:.9g}"]
            else:
                walls = [f"plane 0 0 0 {s * b:.9g} {a:.9g} 0" for s in (1, -1)]
            for mu in (0, 1):
                scene = Scene(body, [ROCK], "viscosity 1 2").thermo("step etotal", 1)
                for k, wall in enumerate(walls):
                    scene.add(f"fix w{k} all tmsph/wall {wall} friction {mu}\n"
                              f"fix_modify w{k} energy yes")
                scene.set("vy", np.full(len(body), -0.005 * C))
                run = bench.run(scene, f"{what}, {angle}, friction {mu}", marching(DT, 3000),
                                every=500)
                held = run.ok and rise(run) < 0.01 and all(
                    frame["y"].mean() > 0 for frame in run.run.dumps["watch"])
                holds[angle] = holds.get(angle, True) and held
                good &= held
        narrowest.append(f"{last_of(holds)} ({what})")
    return Found("degrees: " + ", ".join(narrowest), "not reached", good)


@case("dust",
      "a block all of whose bonds break at once, of random velocities of 0.001 to 0.1 of the wave "
      "speed, in a box of walls, contact with friction 0.5; 2000 steps",
      f"{NEVER}; no particle leaves the box")
def dust(bench):
    good, limits = True, []
    for what, cloud in {"2-D": lattice("square", (8, 8), SPACING, centre=True),
                        "3-D": lattice("sc", (4, 4, 4), SPACING, centre=True)}.items():
        d, holds = cloud.dimension, {}
        h = np.abs(cloud.X).max() + 1.5 * SPACING
        if d == 2:
            corners = f"{-h} {-h} {h} {-h} {h} {h} {-h} {h} {-h} {-h}"
            walls = [f"polyline 5 {corners}"]
        else:
            walls = ["plane " + " ".join(f"{x:.9g}" for x in (*(-s * h * n), *(s * n)))
                     for n in np.eye(3) for s in (1, -1)]
        for speed in (0.001, 0.01, 0.1):
            v = speed * C * np.random.default_rng(2).uniform(-1, 1, cloud.X.shape)
            scene = Scene(cloud, [ROCK], "viscosity 1 2").add("run 0").move(1.001 * cloud.X)
            scene.set("vx vy vz"[: 3 * d - 1], v)
            scene.add("fix rock all tmsph/hoekbrown strength * 1 mi * 8\n"
                      "fix touch all tmsph/contact friction * * 0.5\nfix_modify touch energy yes")
            for k, wall in enumerate(walls):
                scene.add(f"fix w{k} all tmsph/wall {wall} friction 0.5\n"
                          f"fix_modify w{k} energy yes")
            scene.thermo("step etotal ke f_rock", 10)
            run = bench.run(scene, f"{what}, {speed}", marching(0.75 * DT, 2000), every=200)
            inside = run.ok and all(np.abs(frame("x y z")[:, :d]).max() < h
                                    for frame in run.run.dumps["watch"])
            holds[speed] = inside and rise(run) < 0.01
            good &= holds[speed]
        limits.append(f"{last_of(holds)} ({what})")
    return Found("of the wave speed: " + ", ".join(limits), "not reached", good)
