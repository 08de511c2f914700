# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""As test_resume, with ten kills of each run, on 1 and 2 processes, and the other examples that write
restart files: quasi-static with conduction, and with a run before the one that is resumed."""

from test_resume import *

QUENCH = ["-var", "dx", "0.4e-3", "-var", "restart", "20"]
BOREHOLE = ["-var", "dx", "2.5e-3", "-var", "restart", "15"]

report = Report()
for ranks in (1, 2):
    what = f"{ranks} ranks"
    killed(report, "disc", f"dynamic, {what}", DYNAMIC, ranks, 10, 16, 3 + ranks)
    killed(report, "disc", f"quasi-static, {what}", QUASISTATIC, ranks, 10, 32, 5 + ranks)
    killed(report, "quench", what, QUENCH, ranks, 5, 8, 7 + ranks)
    killed(report, "borehole", what, BOREHOLE, ranks, 5, 5, 9 + ranks)
report.finish()
