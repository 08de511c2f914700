# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Hollow cylinder of particles in rings, whose surfaces are true circles, with given temperatures
at both, steady: conduction, expansion and equilibrium together, up to the first break, against the
closed form (Timoshenko, Goodier, Theory of elasticity). test_heat_cylinder does it on lattices,
whose surfaces are steps. Stresses are in units of the largest one, the hoop stress at the inner
surface.

Bars: 2 % with 40 particles across the wall, one horizon and more from the surfaces. At 0.3 of the
wall from them and more, where the surface layer stays out at every spacing, the root mean square
error falls faster than in the middle between first and second order. The first break is at the
outer surface, in tension, where the criterion of Hoek and Brown with uniform strength puts the
closed form: 2 % as well."""

import numpy as np

from tmsph_testing import HORIZON, Cloud, Scene, main, material, order

INNER, OUTER = 0.01, 0.02
HOT = 1.0    # at the inner surface; one degree, so that strains are linear
INSIDE = 0.3 * (OUTER - INNER)
ROCK = material(40e9, 0.3, 2700.0, 1e-5)
STRENGTH, MI = 200e6, 29.0
TENSILE = STRENGTH / 2 * (np.sqrt(MI**2 + 4) - MI)
CONDUCTIVITY, HEAT = 3.0, 800.0
# exp(-24) from steady
TIME = 2.5 * (OUTER - INNER) ** 2 / (CONDUCTIVITY / ROCK["density"] / HEAT)


def rings(n):
    """n rings, each with particles a spacing apart and with its true area."""
    spacing = (OUTER - INNER) / n
    points, volumes = [], []
    for k in range(n):
        radius = INNER + (k + 0.5) * spacing
        count = round(2 * np.pi * radius / spacing)
        angle = 2 * np.pi * (np.arange(count) + 0.5 * (k % 2)) / count
        points.append(radius * np.stack([np.cos(angle), np.sin(angle)], axis=1))
        volumes.append(np.full(count, 2 * np.pi * radius * spacing / count))
    cloud = Cloud(np.concatenate(points), 1.0, spacing)
    cloud.volume = np.concatenate(volumes)
    return cloud


def closed_form(r, plane):
    """Temperature, radial, hoop and axial stress."""
    E, nu, alpha = ROCK["young"], ROCK["poisson"], ROCK["expansion"]
    wall = np.log(OUTER / INNER)
    T = HOT * np.log(OUTER / r) / wall
    scale = E * alpha * HOT / (2 * wall) / (1 - nu if plane == "strain" else 1)
    shell = INNER**2 / (OUTER**2 - INNER**2) * wall
    radial = scale * (-np.log(OUTER / r) - shell * (1 - OUTER**2 / r**2))
    hoop = scale * (1 - np.log(OUTER / r) - shell * (1 + OUTER**2 / r**2))
    axial = nu * (radial + hoop) - E * alpha * T if plane == "strain" else 0 * r
    return np.array([T, radial, hoop, axial])


class Cylinder:
    def __init__(self, cloud, plane):
        self.cloud = cloud
        peak = abs(closed_form(INNER, plane)[2])
        scene = Scene(cloud, [ROCK], f"plane {plane}")
        scene.add(f"region inner cylinder z 0 0 {INNER} INF INF units box\n"
                  f"region outer cylinder z 0 0 {OUTER} INF INF units box\n"
                  f"region near cylinder z 0 0 {0.5 * (INNER + OUTER)} INF INF units box\n"
                  "group near region near\ngroup far subtract all near\n"
                  f"fix heat all tmsph/heat conductivity * {CONDUCTIVITY} specific/heat * {HEAT}\n"
                  f"fix hot near tmsph/heat/boundary temperature {HOT} region inner\n"
                  "fix cold far tmsph/heat/boundary temperature 0 region outer\n"
                  f"timestep {TIME / 25:.17g}\nrun 25\n"
                  f"fix rock all tmsph/hoekbrown strength * {STRENGTH} mi * {MI}\n"
                  "compute p all tmsph/property/atom temperature sxx syy sxy szz load\n"
                  "min_style tmsph/lbfgs\n"
                  f"minimize 0 {1e-4 * peak * cloud.spacing * len(cloud) ** 0.5:.6g} 10000 100000")
        T, sxx, syy, sxy, szz, load = scene.snapshot("end", "c_p[*]").run().frame("end")(
            "c_p[1] c_p[2] c_p[3] c_p[4] c_p[5] c_p[6]").T
        x, y = cloud.X.T
        self.r = r = np.hypot(x, y)
        c, s = x / r, y / r
        found = [T, c * c * sxx + s * s * syy + 2 * c * s * sxy,
                 s * s * sxx + c * c * syy - 2 * c * s * sxy, szz]
        self.first_break = HOT / load.max()    # temperature difference
        self.exact_break = HOT * TENSILE / closed_form(OUTER - 0.5 * cloud.spacing, plane)[2]
        unit = np.array([HOT, peak, peak, peak])
        self.errors = (np.array(found) - closed_form(r, plane)) / unit[:, None]

    def away(self, distance):
        """Errors of the particles so far from the surfaces."""
        return self.errors[:, (self.r > INNER + distance) & (self.r < OUTER - distance)]

    def rms(self, rows, distance):
        return np.sqrt(np.mean(self.away(distance)[rows] ** 2))

    def largest(self, distance):
        return np.abs(self.away(distance)[1:]).max()


STRESS = slice(1, 3)


def two_rings(report):
    for plane in ("strain", "stress"):
        what = f"plane {plane}"
        cylinders = [Cylinder(rings(n), plane) for n in (10, 20, 40)]
        errors = [c.rms(STRESS, INSIDE) for c in cylinders]
        orders = order(errors)
        report.note(f"{what}: rms errors of the stress inside, n = 10, 20, 40",
                    ", ".join(f"{e:.2g}" for e in errors) + f"; orders {orders.round(2)}")
        report.note(f"{what}: rms errors of the temperature",
                    ", ".join(f"{c.rms(0, 0.0):.2g}" for c in cylinders))
        report.above(f"{what}: order of the stress inside", orders.min(), 1.5)
        finest = cylinders[-1]
        report.below(f"{what}: largest error a horizon from the surfaces, n = 40",
                     finest.largest(HORIZON * finest.cloud.spacing), 0.02)
        report.below(f"{what}: first break/exact - 1, n = 40",
                     abs(finest.first_break / finest.exact_break - 1), 0.02)


if __name__ == "__main__":
    main(two_rings)
