# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Conduction against closed forms: a slab with both ends suddenly hot (Dirichlet), a plate with
unit flux on one side (Neumann), a slab that cools by convection (Robin), on lattices in 2-D and
3-D: second order. Jittered particles, whose surfaces are rough: first order at least, with areas
that are found and areas that are given; all errors below that of a surface half a spacing off.
Errors are root mean squares over the particles; those of jittered ones also over draws, whose
chance counts. With "all": every resolution, for the report."""

import numpy as np

from heat_scenes import SIDES, UNIFORM, Heated, dirichlet, listed, neumann, rms, robin, slab
from tmsph_testing import main, order, thorough

# time, boundaries, temperature at first, exact solution, largest error at 80 particles

CASES = {
    "Dirichlet": (0.05, "fix b all tmsph/heat/boundary temperature 1.0", 0.0, dirichlet, 2e-4),
    "Neumann": (0.1, "fix b left tmsph/heat/boundary flux 1.0", 0.0, neumann, 2e-5),
    "Robin": (0.3, "fix b right tmsph/heat/boundary convection 2.0 0.0", 1.0,
              lambda x, t: robin(x, t, 2.0), 2e-4),
}
JITTER, DRAWS = 0.2, (4711, 1, 2)


def solve(case, cloud, words=""):
    """Error of the temperatures, and area of the surface/exact."""
    time, conditions, start, exact, _ = CASES[case]
    sides = 2 if case == "Dirichlet" else 1
    area = sides * np.prod((cloud.box[1] - cloud.box[0])[1:])
    boundary = f"region body block 0 1 INF INF INF INF\n{SIDES}{conditions}"
    scene = Heated(cloud, UNIFORM, boundary + words.format(area=area), start)
    T = scene.run_to(time, 100, columns="step f_b[3]")
    return rms(T - exact(cloud.X[:, 0], time)), scene.done.thermo("f_b[3]")[-1] / area


def half_a_spacing(case, cloud):
    """Error of a surface that is half a spacing off: it moves the field by as much."""
    time, _, _, exact, _ = CASES[case]
    x, step = np.linspace(0.01, 0.99, 981), 1e-4
    slope = (exact(x + step, time) - exact(x - step, time)) / (2 * step)
    return 0.5 * cloud.spacing * rms(slope)


def lattices(report):
    for case, (*_, bar) in CASES.items():
        for name in ("square", "hex"):
            sizes = np.array((10, 20, 40, 80) if thorough() else (10, 40, 80))
            errors, areas = np.transpose([solve(case, slab(n, name)) for n in sizes])
            orders = order(errors, sizes[1:] / sizes[:-1])
            report.note(f"{case}, {name}: errors", listed(errors))
            report.above(f"{case}, {name}: lowest order", orders.min(), 1.9)
            report.below(f"{case}, {name}: error at 80", errors[-1], bar)
            report.below(f"{case}, {name}: area of the surface/exact - 1", np.abs(areas - 1).max(),
                         1e-6)
        errors = [solve(case, slab(n, "sc"))[0] for n in (10, 20)]
        report.note(f"{case}, sc in 3-D: errors", listed(errors))
        report.above(f"{case}, sc in 3-D: order", order(errors)[0], 1.9)


def jittered(report):
    for case in CASES:
        sizes = (10, 20, 40, 80) if thorough() else (10, 20, 40)
        for words, areas_are in (("", "found"), (" area {area}", "given")):
            clouds = [[slab(n, "square", JITTER, width=n, draw=draw) for n in sizes]
                      for draw in DRAWS]
            solved = np.array([[solve(case, cloud, " region body" + words) for cloud in row]
                               for row in clouds])
            errors = np.sqrt(np.mean(solved[..., 0] ** 2, axis=0))
            name = f"{case}, jittered by {JITTER}, areas {areas_are}"
            report.note(f"{name}: errors", listed(errors))
            report.note(f"{name}: areas/exact - 1", listed(np.abs(solved[..., 1] - 1).max(axis=0)))
            # a slope by least squares; of two sizes chance would decide
            report.above(f"{name}: order", -np.polyfit(np.log(sizes), np.log(errors), 1)[0], 1.0)
            for n, cloud, error in zip(sizes, clouds[0], errors):
                report.below(f"{name}: error at {n}", error, half_a_spacing(case, cloud))
        report.below(f"{case}, jittered: given area - 1", np.abs(solved[..., 1] - 1).max(), 1e-12)


if __name__ == "__main__":
    main(lattices, jittered)
