# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Heated sphere in a spherical shell in equilibrium, against the exact solution. Errors are in
units of the contact pressure p, root mean squares over volume and over sigma_r and both
hoop stresses; radii are those of equal volume."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, material

INCLUSION, RADIUS, TEMPERATURE = 0.020, 0.050, 1.0
INNER, OUTER = material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2700, 1e-5)


def contact_pressure(a, R):
    shell = (1 + OUTER["poisson"]) * R**3 / 2 + (1 - 2 * OUTER["poisson"]) * a**3
    shell /= OUTER["young"] * (R**3 - a**3)
    core = (1 - 2 * INNER["poisson"]) / INNER["young"]
    return (INNER["expansion"] - OUTER["expansion"]) * TEMPERATURE / (core + shell)


class Ball:
    def __init__(self, spacing, options="", horizon=HORIZON, ranks=1, residual=1e-5, style="cg"):
        n = 2 * int(np.ceil(RADIUS / spacing)) + 1    # odd: a particle in the centre
        cloud = lattice("sc", (n, n, n), spacing, centre=True)
        cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= RADIUS)
        r = np.linalg.norm(cloud.X, axis=1)
        inside = r <= INCLUSION
        cloud.type[~inside] = 2
        V = cloud.volume
        a, R = (np.cbrt(3 * v.sum() / (4 * np.pi)) for v in (V[inside], V))
        p = contact_pressure(a, R)
        scene = Scene(cloud, [INNER, OUTER], options, horizon=horizon)
        scene.add("compute p all tmsph/property/atom sxx syy szz sxy sxz syz")
        scene.thermo("step fnorm").add(f"run 0\nset group all temperature {TEMPERATURE}")
        scene.minimize(residual * p * spacing**2, style=style).snapshot("d", "c_p[*]")
        run = scene.run(ranks)
        self.cost = run.cost
        self.n, self.steps = len(cloud), int(run.thermo("Step")[-1])
        self.residual = run.thermo("Fnorm")[-1] / self.n**0.5 / (p * spacing**2)

        s = run.frame("d")(" ".join(f"c_p[{k}]" for k in range(1, 7)))
        stress = s[:, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(-1, 3, 3)
        e = cloud.X / np.maximum(r, 1e-9)[:, None]
        radial = np.einsum("ni,nij,nj->n", e, stress, e)
        B = p * a**3 / (R**3 - a**3)
        ratio = (R / np.maximum(r, 0.1 * a)) ** 3
        exact_radial = np.where(inside, -p, B * (1 - ratio))
        exact_hoop = np.where(inside, -p, B * (1 + 0.5 * ratio))
        # Frobenius norm of the difference to the exact tensor: radial, two hoops, and shear
        ee = e[:, :, None] * e[:, None, :]
        exact = exact_hoop[:, None, None] * np.eye(3)
        exact += (exact_radial - exact_hoop)[:, None, None] * ee
        square = np.sum((stress - exact) ** 2, axis=(1, 2)) / 3 / p**2
        self.error = (np.sum(V * square) / np.sum(V)) ** 0.5
        core = r < 0.5 * a
        self.core = -np.mean(np.trace(stress, axis1=1, axis2=2)[core]) / 3 / p
        ring = ~inside & (r < a + spacing)
        hoop = 0.5 * (np.trace(stress, axis1=1, axis2=2) - radial)
        self.ring_hoop = np.sum(hoop[ring]) / np.sum(exact_hoop[ring])
