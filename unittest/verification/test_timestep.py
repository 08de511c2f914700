# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The stable time step that compute tmsph/dt reports: at 0.98 of it random noise
stays as it is, at 1.05 of it the body blows up."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

SPACING, STEPS = 1e-3, 20000
ROCK, SOFT = material(), material(poisson=0.48)
NOISE = 1e-6    # of the spacing
BODIES = {"square block": ("square", (16, 12), 0.0, ""),
          "hexagonal block, plane stress": ("hex", (14, 7), 0.0, "plane stress"),
          "jittered block": ("square", (14, 14), 0.2, "hourglass 0.3"),
          "periodic sheet": ("square", (12, 12), 0.0, ""),
          "cubic block": ("sc", (7, 6, 6), 0.0, ""),
          "fcc block": ("fcc", (4, 4, 3), 0.0, ""),
          "nearly incompressible inclusion": ("square", (12, 12), 0.0, "")}


def body(name, viscous):
    lattice_name, cells, jitter, options = BODIES[name]
    periodic = "xy" if "periodic" in name else ""
    cloud = lattice(lattice_name, cells, SPACING, periodic).jitter(jitter, 5)
    rocks = [ROCK, SOFT] if "inclusion" in name else [ROCK]
    inside = np.abs(cloud.X - cloud.X.mean(axis=0)).max(axis=1) < 3 * SPACING
    cloud.type[inside] = len(rocks)
    scene = Scene(cloud, rocks, options + (" viscosity 1 2" if viscous else ""))
    return cloud, scene.add("compute dt all tmsph/dt\nrun 0")


def stable_step(name, viscous):
    run = body(name, viscous)[1].thermo("step c_dt").add("run 0").run()
    return run.thermo("c_dt")[0]


BLOWN_UP = ("turned inside out", "lost its bonded partner")


def growth(name, viscous, dt):
    """Kinetic energy late in a run over that early in it; infinite if lmp stops. The time step
    is set by fix dt/reset, as a run that starts with one above the stable one is refused."""
    cloud, scene = body(name, viscous)
    noise = np.random.default_rng(9).normal(0, NOISE * SPACING, cloud.X.shape)
    scene.move(cloud.X + noise)
    scene.add(f"timestep {0.5 * dt:.17g}\nfix 1 all nve\n"
              f"fix step all dt/reset 1 {dt:.17g} {dt * (1 + 1e-12):.17g} {SPACING}")
    run = scene.thermo("step ke dt", 10).add(f"run {STEPS}").run(may_fail=True)
    if run.failed:
        if any(words in run.log for words in BLOWN_UP):
            return np.inf
        raise RuntimeError(run.log[-2000:])
    if abs(run.thermo("Dt")[-1] / dt - 1) > 1e-9:
        raise RuntimeError("the time step is not the one asked for")
    ke = run.thermo("KinEng")
    early = ke[1:4] if viscous else ke[1: len(ke) // 4]    # viscosity lets the noise die out
    return ke[-len(ke) // 4:].max() / early.max()


def check(report, name, viscous):
    what = f"{name}{', viscous' if viscous else ''}"
    dt = stable_step(name, viscous)
    speed = (ROCK["young"] * 0.7 / (1.3 * 0.4) / ROCK["density"]) ** 0.5
    report.note(f"{what}: dt c_p/dx", f"{dt * speed / SPACING:.3f}")
    report.below(f"{what}: growth at 0.98 dt", growth(name, viscous, 0.98 * dt), 2.0)
    report.above(f"{what}: growth at 1.05 dt", growth(name, viscous, 1.05 * dt), 1e6)


def limits(report):
    for name in BODIES:
        for viscous in (False, True):
            check(report, name, viscous)


if __name__ == "__main__":
    main(limits)
