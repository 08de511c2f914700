# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Heated disc with a circular inclusion against the exact solution (Lame), at
three spacings in plane strain, and with both orders of the expansions in both
plane states. Equilibrium by minimizing; one degree, so that strains are linear.
Errors are in units of the contact pressure p, root mean squares over area and
over sigma_r and sigma_theta; radii are those of equal area. The order counts from
1 to 0.5 mm: at 2 mm the layer of one horizon at the interface reaches into the
far field."""

from scenes.disc import Disc
from tmsph_testing import disc_materials, main, order


def describe(report, what, disc, judged):
    """Measured values, against their bars from 1 mm on."""
    report.note(what, f"{len(disc.cloud)} particles, {disc.steps} iterations, "
                f"residual {disc.residual:.1g} p dx")
    if judged:
        report.below(f"{what}: L2 error", disc.error, 0.035)
        report.below(f"{what}: far error", disc.far, 0.01)
        report.above(f"{what}: inner ring's hoop stress/exact", disc.ring_hoop, 0.92)
        report.within(f"{what}: core pressure/p", disc.core, 0.975, 1.025)
    else:
        report.note(f"{what}: L2 error, far error, inner ring, core",
                    f"{disc.error:.4f}, {disc.far:.5f}, {disc.ring_hoop:.4f}, {disc.core:.4f}")


def spacings(report):
    discs = []
    for spacing in (2e-3, 1e-3, 0.5e-3):
        discs.append(Disc("strain", disc_materials(False), spacing))
        describe(report, f"plane strain, dx = {spacing * 1e3:g} mm", discs[-1], spacing <= 1e-3)
    report.note("orders of the L2 error", order([d.error for d in discs]).round(2))
    report.note("orders of the far error", order([d.far for d in discs]).round(3))
    report.above("order of the far error", order([d.far for d in discs])[-1], 1.0)


def planes(report):
    for plane, swapped in (("strain", True), ("stress", False), ("stress", True)):
        describe(report, f"plane {plane}{', expansions swapped' if swapped else ''}, dx = 1 mm",
                 Disc(plane, disc_materials(swapped), 1e-3), True)


def quasistatic(report):
    # the unit of the residual is the force of 1/4000 of Young's modulus, 5 MPa; p is 0.09 MPa
    describe(report, "quasi-static, plane strain, dx = 1 mm",
             Disc("strain", disc_materials(False), 1e-3, quasistatic=2e-7), True)


if __name__ == "__main__":
    main(spacings, planes, quasistatic)
