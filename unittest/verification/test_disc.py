# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Heated disc with a circular inclusion against the exact solution (Lame), at
three spacings in plane strain, and with both orders of the expansions in both
plane states. Equilibrium by minimizing; one degree, so that strains are linear.
Errors are in units of the contact pressure p, root mean squares over area and
over sigma_r and sigma_theta; radii are those of equal area. The order counts from
1 to 0.5 mm: at 2 mm the layer of one horizon at the interface reaches into the
far field."""

from tmsph_testing import *

INCLUSION, RADIUS, TEMPERATURE = 0.015, 0.050, 1.0
FAR = 0.006    # from interface and rim


class Disc:
    """quasistatic: residual of tmsph/quasistatic, instead of LAMMPS's conjugate gradients"""

    def __init__(self, plane, swapped, spacing, quasistatic=None):
        cells = (2 * int(RADIUS / spacing) + 4, 2 * int(RADIUS / spacing / 3**0.5) + 4)
        cloud = lattice("hex", cells, spacing, centre=True)
        cloud.X += [0.25 * spacing, 0.25 * 3**0.5 * spacing]    # a particle in the centre
        self.cloud = cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= RADIUS)
        inside = np.linalg.norm(cloud.X, axis=1) <= INCLUSION
        cloud.type[~inside] = 2
        self.V = V = cloud.volume
        self.a, self.R = (V[inside].sum() / np.pi) ** 0.5, (V.sum() / np.pi) ** 0.5
        pair = disc_materials(swapped)
        self.p = contact_pressure(pair, plane, self.a, self.R, TEMPERATURE)
        scene = Scene(cloud, pair, f"plane {plane}")
        scene.thermo("step fnorm").add("compute p all tmsph/property/atom sxx syy sxy")
        if quasistatic:
            scene.add(f"variable T equal {TEMPERATURE}*step/5\ntimestep 1.0\n"
                      "fix heat all tmsph/heat/boundary temperature v_T\n"
                      f"tmsph/quasistatic 5 change 0.2 residual {quasistatic}")
        else:
            scene.add(f"run 0\nset group all temperature {TEMPERATURE}")
            scene.minimize(1e-5 * abs(self.p) * spacing)
        run = scene.snapshot("d", "c_p[*]").run()
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


report = Report()
discs = []
for spacing in (2e-3, 1e-3, 0.5e-3):
    discs.append(Disc("strain", False, spacing))
    describe(report, f"plane strain, dx = {spacing * 1e3:g} mm", discs[-1], spacing <= 1e-3)
report.note("orders of the L2 error", order([d.error for d in discs]).round(2))
report.note("orders of the far error", order([d.far for d in discs]).round(3))
report.above("order of the far error", order([d.far for d in discs])[-1], 1.0)
for plane, swapped in (("strain", True), ("stress", False), ("stress", True)):
    describe(report, f"plane {plane}{', expansions swapped' if swapped else ''}, dx = 1 mm",
             Disc(plane, swapped, 1e-3), True)
# the unit of the residual is the force of 1/4000 of Young's modulus, 5 MPa; p is 0.09 MPa
describe(report, "quasi-static, plane strain, dx = 1 mm", Disc("strain", False, 1e-3, 2e-7), True)
report.finish()
