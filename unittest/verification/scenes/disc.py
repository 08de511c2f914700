# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Heated disc with a circular inclusion in equilibrium, against the exact solution (Lame).
One degree, so that strains are linear. Errors are in units of the contact pressure p, root
mean squares over area and over sigma_r and sigma_theta; radii are those of equal area."""

import numpy as np

from tmsph_testing import HORIZON, Scene, contact_pressure, disc_polar_stress, lattice

INCLUSION, RADIUS, TEMPERATURE = 0.015, 0.050, 1.0
FAR = 0.006    # from interface and rim


def lattice_disc(spacing):
    cells = (2 * int(RADIUS / spacing) + 4, 2 * int(RADIUS / spacing / 3**0.5) + 4)
    cloud = lattice("hex", cells, spacing, centre=True)
    cloud.X += [0.25 * spacing, 0.25 * 3**0.5 * spacing]    # a particle in the centre
    return cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= RADIUS)


class Disc:
    """pair: materials of inclusion and matrix. residual: root mean square force on a particle in
    units of p times the spacing. quasistatic: residual of tmsph/quasistatic, instead of
    minimize. cloud: its particles, if they are not on a lattice."""

    def __init__(self, plane, pair, spacing, options="", horizon=HORIZON, ranks=1,
                 residual=1e-5, style="cg", quasistatic=None, cloud=None):
        self.cloud = cloud = cloud or lattice_disc(spacing)
        inside = np.linalg.norm(cloud.X, axis=1) <= INCLUSION
        cloud.type[~inside] = 2
        self.V = V = cloud.volume
        self.a, self.R = (V[inside].sum() / np.pi) ** 0.5, (V.sum() / np.pi) ** 0.5
        self.p = contact_pressure(pair, plane, self.a, self.R, TEMPERATURE)
        scene = Scene(cloud, pair, f"plane {plane} {options}", horizon=horizon)
        scene.thermo("step fnorm").add("compute p all tmsph/property/atom sxx syy sxy")
        if quasistatic:
            scene.add(f"variable T equal {TEMPERATURE}*step/5\ntimestep 1.0\n"
                      "fix heat all tmsph/heat/boundary temperature v_T\n"
                      f"tmsph/quasistatic 5 change 0.2 residual {quasistatic}")
        else:
            scene.add(f"run 0\nset group all temperature {TEMPERATURE}")
            scene.minimize(residual * abs(self.p) * spacing, style=style)
        scene.snapshot("d", "c_p[*]")
        run = scene.run(ranks)
        self.cost = run.cost
        self.steps = int(run.thermo("Step")[-1])
        self.residual = run.thermo("Fnorm")[-1] / len(cloud) ** 0.5 / (abs(self.p) * spacing)
        self.evaluate(*run.frame("d")("c_p[1] c_p[2] c_p[3]").T, inside)

    def evaluate(self, sxx, syy, sxy, inside):
        x, y = self.cloud.X.T
        r = np.hypot(x, y)
        c, s = np.divide([x, y], r, out=np.stack([np.ones_like(x), np.zeros_like(x)]), where=r > 0)
        radial = c * c * sxx + s * s * syy + 2 * c * s * sxy
        hoop = s * s * sxx + c * c * syy - 2 * c * s * sxy
        exact_radial, exact_hoop = disc_polar_stress(self.p, self.a, self.R, r, inside)
        square = 0.5 * ((radial - exact_radial) ** 2 + (hoop - exact_hoop) ** 2) / self.p**2

        def norm(chosen):
            return (np.sum((self.V * square)[chosen]) / np.sum(self.V[chosen])) ** 0.5

        self.error = norm(r > -1)
        self.far = norm((np.abs(r - self.a) > FAR) & (r < self.R - FAR))
        ring = ~inside & (r < self.a + self.cloud.spacing)
        self.ring_hoop = np.sum(hoop[ring]) / np.sum(exact_hoop[ring])
        core = r < self.a - FAR
        self.core = -np.mean(0.5 * (sxx + syy)[core]) / self.p
