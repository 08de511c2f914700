# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Conduction against closed forms: a slab with both ends suddenly hot (Dirichlet), a
plate with unit flux on one side (Neumann), a slab that cools by convection (Robin). The
error is the root mean square over the particles, of the largest temperature difference;
it vanishes in proportion to the square of the spacing."""

from tmsph_testing import *


def slab(n, name="square", jitter=0.0):
    """n cells across a slab of unit thickness, some along it, periodic there."""
    width = {"square": 8, "hex": 6}[name]
    edges = LATTICES[name][0]
    spacing = 1.0 / (n * edges[0])
    cloud = lattice(name, (n, width), spacing, periodic="y")
    return cloud.jitter(jitter, 4711) if jitter else cloud


def run(cloud, time, conditions, start=0.0, steps=100, words=""):
    """Temperatures after so much time; k = rho = c = 1. The body itself is held still."""
    scene = Scene(cloud, [material(young=1.0, poisson=0.2, density=1.0)], temperature=start)
    scene.add("region left block INF 0.5 INF INF INF INF\ngroup left region left\n"
              "group right subtract all left\n"
              f"fix heat all tmsph/heat conductivity * 1 specific/heat * 1 {words}\n{conditions}\n"
              f"timestep {time / steps:.17g}\nthermo 0\nrun {steps}")
    scene.add("compute T all property/atom temperature\nrun 0")
    return scene.snapshot("end", "c_T").run().frame("end")["c_T"]


def dirichlet(x, t):
    b = (2 * np.arange(200)[:, None] + 1) * np.pi
    return 1 - (4 / b * np.sin(b * x) * np.exp(-b**2 * t)).sum(axis=0)


def neumann(x, t):
    n = np.arange(1, 200)[:, None]
    series = ((-1.0) ** n / n**2 * np.exp(-(n * np.pi) ** 2 * t) * np.cos(n * np.pi * (1 - x))).sum(axis=0)
    return t + (3 * (1 - x) ** 2 - 1) / 6 - 2 / np.pi**2 * series


def robin(x, t, biot):
    """Insulated at 0, convection at 1, from 1 towards 0."""
    zeta = []
    for m in range(200):
        low, high = m * np.pi, (m + 0.5) * np.pi
        for _ in range(100):
            middle = 0.5 * (low + high)
            low, high = (middle, high) if middle * np.tan(middle) < biot else (low, middle)
        zeta.append(low)
    z = np.array(zeta)[:, None]
    C = 4 * np.sin(z) / (2 * z + np.sin(2 * z))
    return (C * np.exp(-z**2 * t) * np.cos(z * x)).sum(axis=0)


CASES = {
    "Dirichlet": (0.05, "fix b all tmsph/heat/boundary temperature 1.0", 0.0, dirichlet, 2e-4),
    "Neumann": (0.1, "fix b left tmsph/heat/boundary flux 1.0", 0.0, neumann, 2e-5),
    "Robin": (0.3, "fix b right tmsph/heat/boundary convection 2.0 0.0", 1.0,
              lambda x, t: robin(x, t, 2.0), 2e-4),
}


def error(case, n, **kind):
    time, conditions, start, exact, _ = CASES[case]
    cloud = slab(n, **kind)
    T = run(cloud, time, conditions, start)
    return np.sqrt(np.mean((T - exact(cloud.X[:, 0], time)) ** 2))


if __name__ == "__main__":
    report = Report()
    for case, (*_, bar) in CASES.items():
        for name in ("square", "hex"):
            errors = [error(case, n, name=name) for n in (10, 20, 40, 80)]
            print(case, name, errors, order(errors))
    report.finish()
