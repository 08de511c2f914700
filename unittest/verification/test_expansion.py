# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A uniformly heated free body expands without stress, jittered or not: found by
minimizing the energy. The strain is taken from all pairs within the horizon."""

from scenes.expansion import BODIES, Expansion
from tmsph_testing import main


def check(report, plane, jitter, mode):
    what = f"{plane}, jitter {jitter}, thermal {mode}"
    body = Expansion(plane, jitter, mode)
    report.below(f"{what}: error of the strain/strain", body.strain_error, 1e-8)
    report.below(f"{what}: stress/(E alpha dT)", body.stress_error, 1e-8)
    if plane == "plane strain":
        report.below(f"{what}: error of szz/(E alpha dT)", body.szz_error, 1e-8)


def expanded(report):
    for plane in BODIES:
        for jitter in (0.0, 0.2):
            for mode in ("bond", "strain"):
                check(report, plane, jitter, mode)


if __name__ == "__main__":
    main(expanded)
