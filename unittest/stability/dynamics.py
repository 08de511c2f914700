# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Bodies in fast motion and long runs."""

import numpy as np

from bodies import (E, RHO, ROCK, SPACING, Copy, blocks, equilibrium, moved, stated_step, stresses,
                    wave_speed)
from cases import GOOD, Found, case, last_of, marching
from tmsph_testing import HORIZON, Scene, Script, disc_materials, lattice, material

C = wave_speed(ROCK)
STEP = 0.4 * SPACING / C


def axial_moment(frame, mass):
    """Angular momentum about the z axis."""
    return (mass * (frame["x"] * frame["vy"] - frame["y"] * frame["vx"])).sum()


def round_bodies():
    disc = lattice("hex", (24, 14), SPACING, centre=True)
    ball = lattice("sc", (12, 12, 12), SPACING, centre=True)
    return {"2-D": disc.kept(lambda X: np.linalg.norm(X, axis=1) < 10.2 * SPACING),
            "3-D": ball.kept(lambda X: np.linalg.norm(X, axis=1) < 5.7 * SPACING)}


@case("spun body",
      "disc and ball set spinning at once, rim speed 0.01 to 2 of sqrt(E/rho), the speed at which "
      "the hoop stress of a thin ring is E; 2000 steps of 0.2 dx/c",
      "up to 0.5 (stress E/4): angular momentum kept to 1e-10, energy to 1 %")
def spun(bench):
    limits, good = [], True
    speeds = (0.01, 0.1, 0.3, 0.5, 0.7, 1.0, 1.5, 2.0)
    for what, cloud in round_bodies().items():
        holds, mass = {}, RHO * cloud.volume
        radius = np.linalg.norm(cloud.X, axis=1).max()
        for speed in speeds:
            spin = speed * (E / RHO) ** 0.5 / radius
            v = spin * np.stack([-cloud.X[:, 1], cloud.X[:, 0]], axis=1)
            scene = Scene(cloud, [ROCK]).set("vx vy", v).thermo("step etotal ke", 10)
            run = bench.run(scene, f"{what}, {speed}", marching(0.5 * STEP, 2000), every=500)
            holds[speed] = run.ok
            if run.ok:
                frames = run.run.dumps["watch"]
                moments = [axial_moment(frame, mass) for frame in frames]
                energy = run.run.thermo("TotEng")
                drift = run.measured(np.abs(energy / energy[0] - 1).max())
                kept = np.abs(np.array(moments) / moments[0] - 1).max()
                holds[speed] = drift < 0.01 and kept < 1e-10
        good &= all(holds[s] for s in speeds if s <= 0.5)
        limits.append(f"{last_of(holds)} ({what})")
    return Found(", ".join(limits) + " of sqrt(E/rho)",
                 "strains of order 1: stopped with the particle that is turned inside out", good)


def shock_force(speed):
    """Stress over rho c^2 behind a plane shock that stops matter of that speed, in units of the
    wave speed: P = s (1 - s^2)/2 and, from mass and momentum, speed^2 = P (1 - s); None above the
    largest speed that the law can stop, 0.3175."""
    s = np.linspace(1, 0.384, 100000)
    P = s * (1 - s**2) / 2
    reached = np.sqrt(P * (1 - s))
    return np.interp(speed, reached, P) if speed <= reached[-1] else None


@case("impact",
      "a block and a cube hit a frictionless wall at 0.01 to 1 of the wave speed, nu 0, viscosity "
      "1 2",
      "up to 0.2: force on the wall within 3 % of that of the shock of the law (mass and "
      "momentum) until the wave is back from the far end; the total energy never above its start "
      "by more than 1 %", level="test")
def impact(bench):
    good, limits, m = True, [], material(E, 0.0)
    c = wave_speed(m)
    for what, cloud in {"2-D": lattice("square", (30, 12), SPACING),
                        "3-D": lattice("sc", (20, 8, 8), SPACING)}.items():
        length = np.ptp(cloud.X[:, 0]) + SPACING
        face = cloud.volume.sum() / length
        wall = "line 0 1 0 0" if what == "2-D" else "plane 0 0 0 1 0 0"
        dt = 0.2 * SPACING / c
        steps = int(3 * length / c / dt)
        bounces = {}
        for speed in (0.01, 0.1, 0.2, 0.25, 0.3, 0.35, 0.5, 0.7, 1.0):
            scene = Scene(cloud, [m], "viscosity 1 2").set("vx", np.full(len(cloud), -speed * c))
            scene.add(f"fix wall all tmsph/wall {wall}").thermo("step etotal f_wall[1]", 1)
            run = bench.run(scene, f"{what}, {speed}", marching(dt, steps), every=steps // 10)
            bounces[speed] = run.ok
            if not run.ok:
                good &= speed > 0.2 and run.end == "stopped"
                continue
            energy = run.run.thermo("TotEng")
            good &= energy.max() < 1.01 * energy[0]
            force = np.abs(run.run.thermo("f_wall[1]"))
            plateau = force[int(0.5 * length / c / dt): int(1.5 * length / c / dt)].mean()
            exact = shock_force(speed)
            ratio = run.measured(plateau / (RHO * c**2 * face * exact) if exact else np.nan)
            good &= speed > 0.2 or abs(ratio - 1) < 0.03
        limits.append(f"{last_of(bounces)} ({what})")
    return Found(f"up to {', '.join(limits)} of the wave speed it bounces; the law allows 0.3175",
                 "collapses as the law does: stopped with the particle that is turned inside out",
                 good)


@case("flight",
      "a body flies at 1e-3 to 1e6 of the wave speed for 1000 steps, on 1 and 2 processors",
      "stress no more than the round-off of the displacement, 2^-53 u/spacing E on each step, "
      "adds up to in a random walk: 10 sqrt(1000) times that")
def flight(bench):
    good, worst = True, 0.0
    for what, cloud in blocks(small=True).items():
        for speed in (1e-3, 1.0, 1e3, 1e6):
            for ranks in (1, 2):
                scene = Scene(cloud, [ROCK]).set("vx", np.full(len(cloud), speed * C))
                run = bench.run(scene, f"{what}, {speed:g}, {ranks} processors",
                                marching(STEP, 1000), every=500, ranks=ranks)
                if not run.ok:
                    good = False
                    continue
                frame = run.run.frame("final")
                shift = np.abs(frame["x"] - cloud.X[:, 0]).max() / SPACING
                stress = run.measured(np.abs(stresses(frame, cloud.dimension)).max() / E)
                worst = max(worst, stress / (shift * 2.0**-53))
    return Found(f"1e6 times the wave speed; largest stress {worst:.1f} times 2^-53 u/spacing E",
                 "bounded", good and worst < 10 * 1000**0.5)


@case("impossible velocities", "velocity of one particle 0.1 to 1e100 times the wave speed",
      "runs, or stopped with a particle; no NaN in a dump", level="test")
def velocities(bench):
    good, limits = True, []
    for what, cloud in blocks(small=True).items():
        holds = {}
        for speed in (0.1, 1.0, 10.0, 1e3, 1e6, 1e10, 1e30, 1e100):
            for pair in ("", "viscosity 1 2"):
                scene = Scene(cloud, [ROCK], pair)
                scene.add(f"run 0\nset atom {len(cloud) // 2} vx {speed * C:.6g}")
                run = bench.run(scene, f"{what} {pair}, {speed:g}", marching(STEP, 20), every=1)
                good &= run.end in GOOD
                holds[speed] = holds.get(speed, True) and run.ok
        limits.append(f"{last_of(holds)} ({what})")
    return Found(", ".join(limits) + " of the wave speed",
                 "stopped: turned inside out, or lost its bonded partner", good)


@case("almansi",
      "the law of the paper, without an energy: a block that vibrates with strains of 1e-4 to 0.1 "
      "for 20 000 steps",
      "documented as drifting; bounded by ten times its start, or stopped")
def almansi(bench):
    texts, good = [], True
    for what, cloud in blocks(small=True).items():
        found = []
        for strain in (1e-4, 1e-3, 1e-2, 0.05, 0.1):
            X = (cloud.X - cloud.X.mean(axis=0)) / np.ptp(cloud.X, axis=0).max()
            v = strain * C * np.stack([np.sin(np.pi * X[:, 0]), np.sin(np.pi * X[:, 1])], axis=1)
            scene = Scene(cloud, [ROCK], "law almansi").set("vx vy", v)
            scene.thermo("step etotal", 100)
            run = bench.run(scene, f"{what}, {strain}", marching(0.5 * STEP, 20000), every=5000)
            if run.ok:
                energy = run.run.thermo("TotEng")
                change = run.measured(energy[-20:].mean() / energy[:20].mean() - 1)
                good &= abs(change) < 10
                found.append(f"{100 * change:+.1g} %")
            else:
                good &= run.end == "stopped"
                found.append(run.end)
        texts.append(" / ".join(found) + f" ({what})")
    return Found("change of the energy at 1e-4 / 1e-3 / 0.01 / 0.05 / 0.1: " + "; ".join(texts),
                 "drifts, then a particle is turned inside out: stopped", good)


@case("hot at once",
      "an inclusion of 1.5 times the expansion of its matrix heated by 10 to 1e5 degrees in one "
      "step of a run, viscosity 1 2, 1500 steps",
      "the energy that the jump brings only falls, within 1 %; or stopped")
def hot(bench):
    good, limits = True, []
    for dimension in (2, 3):
        cloud = round_bodies()[f"{dimension}-D"]
        cloud.type[np.linalg.norm(cloud.X, axis=1) > 4 * SPACING] = 2
        for mode in ("bond", "strain"):
            holds = {}
            for degrees in (10.0, 100.0, 1000.0, 1e4, 3e4, 1e5):
                scene = Scene(cloud, disc_materials(False), f"thermal {mode} viscosity 1 2").add(
                    f"run 0\nset group all temperature {degrees}").thermo("step etotal", 10)
                run = bench.run(scene, f"{dimension}-D, {mode}, {degrees:g}",
                                marching(0.5 * STEP, 1500), every=300)
                holds[degrees] = run.ok
                if run.ok:
                    energy = run.run.thermo("TotEng", 1)
                    rise = run.measured(energy.max() / energy[0] - 1)
                    holds[degrees] = rise < 0.01
                good &= holds[degrees] or degrees > 1000 and run.end == "stopped"
            limits.append(f"{last_of(holds):g} ({dimension}-D, {mode})")
    return Found("degrees: " + ", ".join(limits), "thermal strains of order 1: stopped", good)


@case("energy of breaking",
      "a block torn apart from inside, strength 200 MPa, Weibull modulus 10, 3 and 1, edges moving "
      "out with 0.001 and 0.002 of the wave speed; hourglass, viscosity, share of the stable step",
      "with hourglass 0.5, viscosity 1 2 and 0.3 of the stable step the energy never rises by more "
      "than 2 %, from a half of the bonds broken to all of them")
def breaking(bench):
    advised = "hourglass 0.5 viscosity 1 2"
    settings = ((advised, 0.3, (10, 3, 1)), (advised, 0.4, (10, 3, 1)),
                ("hourglass 0.1 viscosity 1 2", 0.4, (10, 3, 1)), ("hourglass 0.1", 0.4, (10,)))
    bodies = {"2-D": lattice("square", (20, 20), SPACING, centre=True),
              "3-D": lattice("sc", (9, 9, 9), SPACING, centre=True)}
    rises = {}
    for pair, share, moduli in settings:
        for what, cloud in bodies.items():
            scene = Scene(cloud, [ROCK], pair)
            stated = stated_step(bench, f"{what}, {pair}, stated", Copy(scene, cloud).add("run 0"))
            for modulus in moduli:
                for speed in (0.001, 0.002):
                    v = speed * C * cloud.X / np.abs(cloud.X).max()
                    torn = Copy(scene, cloud).set("vx vy vz"[: 3 * cloud.dimension - 1], v)
                    torn.add("fix rock all tmsph/hoekbrown strength * 2e8 mi * 8 "
                             f"weibull * {modulus} 4711").thermo("step etotal f_rock", 10)
                    run = bench.run(torn, f"{what}, {pair}, {share}, Weibull {modulus}, {speed}",
                                    marching(share * stated, int(240 / share)), every=300)
                    energy = run.run.thermo("TotEng") if run.ok else [1.0, np.inf]
                    rises.setdefault((pair, share), []).append(
                        run.measured(max(energy) / energy[0]))
    texts = [f"{sum(rise > 1.02 for rise in row)} of {len(row)} rise, at most to {max(row):.3g} "
             f"({pair}, {share})" for (pair, share), row in rises.items()]
    return Found(texts[0], "energy is fed where few bonds are left: " + "; ".join(texts[1:])
                 + ". Bounded: all bonds break and fragments fly; warned without viscosity",
                 max(rises[advised, 0.3]) < 1.02)


@case("a million steps at rest",
      "36 particles in 2-D and 64 in 3-D: untouched; turned by 57 degrees; heated by 100 degrees "
      "at once, viscosity 1 2",
      "untouched: not a bit changes; turned: stress below 1e-12 E; heated: expanded by alpha dT "
      "to 1e-8", level="full")
def rest(bench):
    good, texts = True, []
    for what, cloud in {"2-D": lattice("square", (6, 6), SPACING, centre=True),
                        "3-D": lattice("sc", (4, 4, 4), SPACING, centre=True)}.items():
        d, n = cloud.dimension, 10**6
        m = material(expansion=1e-5)
        alpha = 1e-5 * (1.3 if d == 2 else 1.0)
        going = marching(STEP, n)
        run = bench.run(Scene(cloud, [m]), f"{what}, untouched", going, every=n // 4, timeout=600)
        shift = run.measured(moved(run, cloud.X, cloud))
        good &= shift == 0.0
        c, s = np.cos(1.0), np.sin(1.0)
        turn = np.eye(d)
        turn[:2, :2] = [[c, -s], [s, c]]
        X = cloud.X @ turn.T
        run = bench.run(Scene(cloud, [m]).add("run 0").move(X), f"{what}, turned", going,
                        every=n // 4, timeout=600)
        stress = run.measured(np.abs(stresses(run.run.frame("final"), d)).max() / E)
        away = moved(run, X, cloud)
        good &= stress < 1e-12
        scene = Scene(cloud, [m], "viscosity 1 2").add("run 0\nset group all temperature 100")
        run = bench.run(scene, f"{what}, heated", going, every=n // 4, timeout=600)
        final = run.run.frame("final")("x y z"[: 2 * d - 1])
        size = np.ptp(final[:, 0]) / np.ptp(cloud.X[:, 0]) - 1
        error = run.measured(abs(size / (100 * alpha) - 1))
        good &= error < 1e-8
        texts.append(f"{what}: moved by {shift:g}; stress {stress:.0e} E and {away:.0e} spacings "
                     f"away; expansion wrong by {error:.0e}")
    return Found("1e6 steps. " + "; ".join(texts), "not reached", good)


@case("a million steps of slow heating",
      "a disc and a ball with an inclusion, 0 to 1000 degrees in 1e6 steps of 0.4 dx/c, viscosity "
      "1 2, against equilibrium",
      "core pressure at the end that of equilibrium within 1 %; kinetic energy below 1e-6 of the "
      "elastic one", level="full")
def slow_heating(bench):
    good, texts, n = True, [], 10**6
    for dimension, cloud in ((2, lattice("hex", (10, 6), SPACING, centre=True)),
                             (3, lattice("sc", (6, 6, 6), SPACING, centre=True))):
        cloud.type[np.linalg.norm(cloud.X, axis=1) > 2.2 * SPACING] = 2
        core = cloud.type == 1
        ramp = f"variable T equal 1000*step/{n}\nfix heat all tmsph/heat/boundary temperature v_T\n"
        scene = Scene(cloud, disc_materials(False), "viscosity 1 2").thermo("step pe ke", 1000)
        run = bench.run(scene, f"{dimension}-D, heated", ramp + marching(0.35 * SPACING / C, n),
                        every=n // 4, timeout=900)
        start = run.run.frame("final")("x y z"[: 2 * dimension - 1])
        still = equilibrium(bench, f"{dimension}-D, equilibrium", cloud, disc_materials(False),
                            start, np.zeros(len(cloud), bool), E * 1e-3, temperature=1000)
        pressure = [stresses(ended.run.frame("final"), dimension)[core].mean(axis=0)[0, 0]
                    for ended in (run, still)]
        error = run.measured(abs(pressure[0] / pressure[1] - 1))
        moving = run.run.thermo("KinEng")[-1] / run.run.thermo("PotEng")[-1]
        good &= error < 0.01 and moving < 1e-6
        texts.append(f"{dimension}-D: {100 * error:.1g} %, kinetic energy {moving:.0e}")
    return Found("1e6 steps. " + "; ".join(texts), "not reached", good)


@case("a million particles",
      "a cube of 100 x 100 x 100 and a sheet of 1000 x 1000, 20 steps of 0.2 dx/c with noise, 2 "
      "processors, a dump of a thousand of them",
      "runs; energy kept to 1 %", level="full")
def million(bench):
    texts, good = [], True
    for what, region, name, d in (("3-D", "0 99.5 0 99.5 0 99.5", "sc", 3),
                                  ("2-D", "0 999.5 0 999.5 -0.5 0.5", "sq", 2)):
        text = f"""units si
dimension {d}
boundary s s {'s' if d == 3 else 'p'}
atom_style tmsph
lattice {name} {SPACING}
region box block {region}
create_box 1 box
create_atoms 1 box
reset_atoms id sort yes
set group all volume {SPACING**d}
pair_style tmsph {HORIZON * SPACING}
pair_coeff 1 1 elastic {E} 0.3 density {RHO}
neighbor {0.3 * SPACING} bin
run 0
velocity all create 1e12 4711 loop geom
thermo_style custom step atoms etotal
thermo_modify norm no format float %.17g
thermo 5
group sample id <= 1000"""
        run = bench.run(Script(text), what, marching(0.5 * STEP, 20), every=20, timeout=900,
                        ranks=2, group="sample")
        if not run.ok:
            good = False
            texts.append(f"{run.end} ({what})")
            continue
        energy = run.run.thermo("TotEng")
        drift = run.measured(np.abs(energy / energy[0] - 1).max())
        good &= drift < 0.01 and run.run.thermo("Atoms")[-1] == 10**6
        texts.append(f"energy to {drift:.0e}, {run.run.cost.memory / 1e9:.1f} GB ({what})")
    return Found("1e6 particles: " + ", ".join(texts), "not reached", good)
