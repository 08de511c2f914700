# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Disc of lattice particles whose rim is suddenly hot, or takes heat by convection, against the
Bessel series. The region gives the circle that the staircase of the lattice stands for; it has the
area of the particles. With "all": every resolution and both lattices, for the report."""

from heat_scenes import *

TIME, BIOT = 0.05, 2.0
CASES = {"Dirichlet": ("temperature 1.0", None), "Robin": (f"convection {BIOT} 1.0", BIOT)}


def error(case, n, name):
    """n particles along the radius."""
    condition, biot = CASES[case]
    cells = tuple(int(2.2 * n / edge) + 2 for edge in LATTICES[name][0])
    cloud = lattice(name, cells, 1.0 / n, centre=True).kept(lambda X: np.hypot(*X.T) < 1.0)
    R = np.sqrt(cloud.volume.sum() / np.pi)
    scene = Heated(cloud, UNIFORM, f"region rim sphere 0 0 0 {R:.17g}\n"
                   f"fix b all tmsph/heat/boundary {condition} region rim area {2 * np.pi * R:.17g}")
    T = scene.run_to(TIME, 40)
    r = np.hypot(*cloud.X.T) / R
    return rms(T - disc_solution(r, TIME / R**2, None if biot is None else biot * R))


report = Report()
thorough = "all" in sys.argv
for case in CASES:
    for name in ("square", "hex") if thorough else ("hex",):
        sizes = np.array((10, 20, 40, 80) if thorough else (10, 60))
        errors = [error(case, n, name) for n in sizes]
        report.note(f"{case}, {name}: errors at {sizes}", errors)
        if thorough:
            report.note(f"{case}, {name}: orders", order(errors))
        report.above(f"{case}, {name}: order over the range",
                     order([errors[0], errors[-1]], sizes[-1] / sizes[0])[0], 1.9)
        report.below(f"{case}, {name}: error at {sizes[-1]}", errors[-1],
                     2e-4 * (80 / sizes[-1]) ** 2)
report.finish()
