# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The discs of test_disc_cracks.py for three draws of the strengths, and to the end also one that
is quasi-static and one whose inclusion is not bonded."""

from test_disc_cracks import SEEDS, alike, drawn, radial, touching
from tmsph_testing import main


def bonded(report):
    for seed in SEEDS:
        radial(report, seed)


def quasistatic(report):
    radial(report, SEEDS[0], quasistatic=True)
    alike(report, drawn(SEEDS[0], True), drawn(SEEDS[0], False))


def unbonded(report):
    touching(report, SEEDS[0])


if __name__ == "__main__":
    main(bonded, quasistatic, unbonded)
