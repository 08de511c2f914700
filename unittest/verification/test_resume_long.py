# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""As test_resume and test_resume_calls, with ten kills of each run, on 1 and 2 processes, and the
other examples that write restart files: quasi-static with conduction, and with a run before the one
that is resumed; and a second kill after more of the first ones."""

from test_resume import DYNAMIC, QUASISTATIC, killed
from test_resume_calls import in_a_folder, kills_at_each_place
from tmsph_testing import main

QUENCH = ["-var", "dx", "0.4e-3", "-var", "restart", "20"]
BOREHOLE = ["-var", "dx", "2.5e-3", "-var", "restart", "15"]


def each_place(report):
    in_a_folder(kills_at_each_place, report, 5)


def examples(report):
    for ranks in (1, 2):
        what = f"{ranks} ranks"
        killed(report, "disc", f"dynamic, {what}", DYNAMIC, ranks, 10, 16, 3 + ranks)
        killed(report, "disc", f"quasi-static, {what}", QUASISTATIC, ranks, 10, 32, 5 + ranks)
        killed(report, "quench", what, QUENCH, ranks, 5, 8, 7 + ranks)
        killed(report, "borehole", what, BOREHOLE, ranks, 5, 5, 9 + ranks)


if __name__ == "__main__":
    main(each_place, examples)
