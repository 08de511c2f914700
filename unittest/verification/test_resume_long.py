# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""As test_resume, with ten kills of each run, on 1 and 2 processes."""

from test_resume import *

report = Report()
for ranks in (1, 2):
    disc(report, f"dynamic, {ranks} ranks", DYNAMIC, ranks, 10, 16, 3 + ranks)
    disc(report, f"quasi-static, {ranks} ranks", QUASISTATIC, ranks, 10, 32, 5 + ranks)
report.finish()
