# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Heated sphere in a spherical shell against the exact solution, in 3-D at two
spacings; equilibrium by minimizing. Errors are in units of the contact pressure
p, root mean squares over volume and over sigma_r and both hoop stresses; radii
are those of equal volume."""

from scenes.sphere import Ball
from tmsph_testing import main, order


def spheres(report):
    balls = []
    for spacing in (5e-3, 2.5e-3):
        ball = Ball(spacing)
        balls.append(ball)
        what = f"dx = {spacing * 1e3:g} mm"
        report.note(what, f"{ball.n} particles, {ball.steps} iterations, "
                    f"residual {ball.residual:.1g} p dx^2")
        report.note(f"{what}: inner ring's hoop stress/exact", f"{ball.ring_hoop:.4f}")
        if spacing == 2.5e-3:
            report.below(f"{what}: L2 error", ball.error, 0.035)
            report.within(f"{what}: core pressure/p", ball.core, 0.95, 1.05)
        else:
            report.note(f"{what}: L2 error, core pressure/p", f"{ball.error:.4f}, {ball.core:.4f}")
    report.note("order of the L2 error", f"{order([b.error for b in balls])[0]:.3f}")
    report.above("order of the core pressure", order([b.core - 1 for b in balls])[0], 1.0)


if __name__ == "__main__":
    main(spheres)
