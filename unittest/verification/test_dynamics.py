# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A free block that rotates and vibrates, 1e5 steps: energy and angular momentum.
The energy that velocity Verlet shows oscillates by an amount of order dt^2: half
the time step must give a quarter of the band, or the forces feed it."""

import numpy as np

from scenes.dynamics import SPACING, Spinning
from tmsph_testing import main, order


def check(report, what, *setting):
    body = Spinning(*setting, 0.4)
    energy, run = body.energy, body.run
    report.below(f"{what}: energy band/energy", body.band, 1e-3)
    half = Spinning(*setting, 0.2).band
    report.within(f"{what}: order of the band in dt", order([body.band, half])[0], 1.8, 2.2)
    later, early = energy[len(energy) // 2:], energy[: len(energy) // 2]
    report.note(f"{what}: shift of the mean energy", f"{later.mean() / early.mean() - 1:.2g}")
    exchange = np.ptp(run.thermo("PotEng")) / energy[0]
    report.above(f"{what}: energy that goes to and fro/energy", exchange, 0.05)
    drift = body.momentum_drift()
    report.below(f"{what}: drift of the angular momentum", drift.max(), 1e-12)
    # a random walk of rounding errors gives about a third, a systematic torque a tenth
    report.note(f"{what}: the same in the first tenth of the steps",
                f"{drift[: len(drift) // 10].max():.2g}")
    x0, x1 = (run.frame("d", k)("x y z").mean(axis=0) for k in (0, -1))
    report.below(f"{what}: shift of the centre/spacing", np.linalg.norm(x1 - x0) / SPACING, 1e-9)


def in_2d(report):
    check(report, "2-D, 12 x 12", "square", (12, 12), (0, 0, 1))


def in_3d(report):
    check(report, "3-D, 12 x 4 x 4", "sc", (12, 4, 4), (1, 2, 3))


if __name__ == "__main__":
    main(in_2d, in_3d)
