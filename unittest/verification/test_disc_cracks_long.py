# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The discs of test_disc_cracks.py for three draws of the strengths, and to the end also one that
is quasi-static and one whose inclusion is not bonded."""

from test_disc_cracks import *

report = Report()
bonded = [radial(report, seed) for seed in SEEDS]
alike(report, radial(report, SEEDS[0], quasistatic=True), bonded[0])
touching(report, SEEDS[0], bonded[0])
report.finish()
