# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Disc of lattice particles whose rim is suddenly hot, or takes heat by convection, against the
Bessel series. The region gives the circle that the staircase of the lattice stands for; it has the
area of the particles. Convection needs its length as well. With "all": up to 80 particles along
the radius, for the report."""

import numpy as np

from heat_scenes import UNIFORM, Heated, disc_solution, listed, rms
from tmsph_testing import LATTICES, lattice, main, thorough

TIME, BIOT = 0.05, 2.0
CASES = {"Dirichlet": ("temperature 1.0", None), "Robin": (f"convection {BIOT} 1.0", BIOT)}


def error(case, n, name):
    """n particles along the radius."""
    condition, biot = CASES[case]
    cells = tuple(int(2.2 * n / edge) + 2 for edge in LATTICES[name][0])
    cloud = lattice(name, cells, 1.0 / n, centre=True).kept(lambda X: np.hypot(*X.T) < 1.0)
    R = np.sqrt(cloud.volume.sum() / np.pi)
    scene = Heated(cloud, UNIFORM, f"region rim sphere 0 0 0 {R:.17g}\n"
                   f"fix b all tmsph/heat/boundary {condition} region rim"
                   + (f" area {2 * np.pi * R:.17g}" if biot else ""))
    T = scene.run_to(TIME, 40)
    r = np.hypot(*cloud.X.T) / R
    return rms(T - disc_solution(r, TIME / R**2, None if biot is None else biot * R))


def disc(report):
    sizes = [10, 14, 20, 28, 40]    # the staircase fits the circle now better, now worse
    if thorough():
        sizes += [57, 80]
    for case in CASES:
        for name in ("square", "hex"):
            errors = np.array([error(case, n, name) for n in sizes])
            slope = -np.polyfit(np.log(sizes), np.log(errors), 1)[0]
            report.note(f"{case}, {name}, {sizes}: errors", listed(errors))
            if case == "Dirichlet":
                report.above(f"{case}, {name}: order over the range", slope, 1.9)
            else:
                report.note(f"{case}, {name}: order over the range", slope)
            report.below(f"{case}, {name}: error at 40, four times that at 80", errors[4], 8e-4)
            if sizes[-1] == 80 and case == "Dirichlet":
                report.below(f"{case}, {name}: error at 80", errors[-1], 2e-4)


if __name__ == "__main__":
    main(disc)
