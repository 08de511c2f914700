# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""First bending mode of a free-free beam, ten times as long as high, against
Timoshenko's beam, in plane strain and plane stress, with refinement. The beam
theory itself is good to 1e-3 here. Free surfaces make the error of first order
at least."""

from scenes.beam import Beam
from tmsph_testing import main, order


def check(report, plane):
    errors = []
    for rows in (6, 12, 24):
        beam = Beam(plane, rows)
        errors.append(beam.error)
        report.note(f"plane {plane}, {rows} rows: error of the period", f"{errors[-1]:.5f}")
    report.note(f"plane {plane}: Euler-Bernoulli/Timoshenko", f"{beam.slender:.5f}")
    report.below(f"plane {plane}: error of the period at 24 rows", abs(errors[-1]), 0.01)
    report.above(f"plane {plane}: order", order(errors)[-1], 1.0)


def plane_strain(report):
    check(report, "strain")


def plane_stress(report):
    check(report, "stress")


if __name__ == "__main__":
    main(plane_strain, plane_stress)
