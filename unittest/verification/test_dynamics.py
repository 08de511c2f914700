# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A free block that rotates and vibrates, 1e5 steps: energy and angular momentum.
The energy that velocity Verlet shows oscillates by an amount of order dt^2: half
the time step must give a quarter of the band, or the forces feed it."""

from math import fsum

from tmsph_testing import *

SPACING, STEPS, EVERY = 1e-3, 100000, 500
ROCK = material()
SPEED = (ROCK["young"] / ROCK["density"]) ** 0.5


def block(name, cells, spin, courant):
    """Angular velocity such that the rim moves at 0.02 c, and a stretching mode on top."""
    cloud = lattice(name, cells, SPACING, centre=True)
    d = cloud.dimension
    r = np.zeros((len(cloud), 3))
    r[:, :d] = cloud.X
    size = r.max()
    omega = 0.02 * SPEED / size * np.array(spin) / np.linalg.norm(spin)
    velocity = np.cross(omega, r)[:, :d]
    velocity[:, 0] += 0.01 * SPEED * np.sin(0.5 * np.pi * r[:, 0] / size)
    scene = Scene(cloud, [ROCK]).set("vx vy vz"[: 3 * d - 1], velocity)
    scene.add(f"timestep {courant * SPACING / SPEED:.6g}\nfix 1 all nve")
    scene.thermo("step ke pe", 10)
    scene.dump("d", "x y z vx vy vz", EVERY).add(f"run {STEPS}")
    return cloud, scene.run()


def energy_band(run):
    energy = run.thermo("KinEng") + run.thermo("PotEng")
    return energy, np.ptp(energy) / energy[0]


def check(report, what, *setting):
    cloud, run = block(*setting, 0.4)
    energy, band = energy_band(run)
    report.below(f"{what}: energy band/energy", band, 1e-3)
    half = energy_band(block(*setting, 0.2)[1])[1]
    report.within(f"{what}: order of the band in dt", order([band, half])[0], 1.8, 2.2)
    later, early = energy[len(energy) // 2:], energy[: len(energy) // 2]
    report.note(f"{what}: shift of the mean energy", f"{later.mean() / early.mean() - 1:.2g}")
    exchange = np.ptp(run.thermo("PotEng")) / energy[0]
    report.above(f"{what}: energy that goes to and fro/energy", exchange, 0.05)
    mass = ROCK["density"] * cloud.volume
    momenta = []
    for frame in run.dumps["d"]:
        L = np.cross(frame("x y z"), mass[:, None] * frame("vx vy vz"))
        momenta.append([fsum(L[:, k]) for k in range(3)])
    momenta = np.array(momenta)
    drift = np.linalg.norm(momenta - momenta[0], axis=1) / np.linalg.norm(momenta[0])
    report.below(f"{what}: drift of the angular momentum", drift.max(), 1e-12)
    # a random walk of rounding errors gives about a third, a systematic torque a tenth
    report.note(f"{what}: the same in the first tenth of the steps",
                f"{drift[: len(drift) // 10].max():.2g}")
    x0, x1 = (run.frame("d", k)("x y z").mean(axis=0) for k in (0, -1))
    report.below(f"{what}: shift of the centre/spacing", np.linalg.norm(x1 - x0) / SPACING, 1e-9)


report = Report()
check(report, "2-D, 12 x 12", "square", (12, 12), (0, 0, 1))
check(report, "3-D, 12 x 4 x 4", "sc", (12, 4, 4), (1, 2, 3))
report.finish()
