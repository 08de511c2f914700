# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""First bending mode of a free-free beam, ten times as long as high, in 2-D, against
Timoshenko's beam, which is good to 1e-3 here."""

import numpy as np
from numpy.polynomial import legendre

from tmsph_testing import HORIZON, Scene, lattice, material, sampled_frequency

HEIGHT, SLENDER, VELOCITY = 0.01, 10, 1e-3
ROCK = material()
RHO = ROCK["density"]


def timoshenko(young, poisson):
    """Frequency and shape of the first mode, by Ritz's method with 16 Legendre polynomials for
    the deflection w and the rotation phi, functions of s = 2 x/L."""
    n, length = 16, SLENDER * HEIGHT
    shear = young / (2 * (1 + poisson)) * 5 * (1 + poisson) / (6 + 5 * poisson)
    s, weight = legendre.leggauss(2 * n)
    value = legendre.legvander(s, n - 1)
    slope = np.stack([legendre.legval(s, legendre.legder(row)) for row in np.eye(n)], axis=1)
    slope *= 2 / length
    weight = (weight * length / 2)[:, None]
    zero = np.zeros_like(value)
    strain, turn = np.hstack([slope, -value]), np.hstack([zero, slope])
    deflection, rotation = np.hstack([value, zero]), np.hstack([zero, value])
    area, inertia = HEIGHT, HEIGHT**3 / 12

    def form(a, b, factor):
        return factor * a.T @ (weight * b)

    K = form(strain, strain, shear * area) + form(turn, turn, young * inertia)
    M = form(deflection, deflection, RHO * area) + form(rotation, rotation, RHO * inertia)
    L = np.linalg.inv(np.linalg.cholesky(M))
    squares, vectors = np.linalg.eigh(L @ K @ L.T)
    first = 2    # after two rigid motions
    mode = L.T @ vectors[:, first]
    return squares[first] ** 0.5, mode[:n], mode[n:]


def euler_bernoulli(young):
    length = SLENDER * HEIGHT
    return (4.730040745 / length) ** 2 * (young * HEIGHT**2 / 12 / RHO) ** 0.5


class Beam:
    def __init__(self, plane, rows, options="", horizon=HORIZON, courant=0.5, periods=2, ranks=1):
        young, poisson = ROCK["young"], ROCK["poisson"]
        if plane == "strain":
            young, poisson = young / (1 - poisson**2), poisson / (1 - poisson)
        self.omega, deflection, rotation = timoshenko(young, poisson)
        self.slender = euler_bernoulli(young) / self.omega
        speed = (young / (1 - poisson**2) / RHO) ** 0.5
        spacing = HEIGHT / rows
        cloud = lattice("square", (SLENDER * rows, rows), spacing, centre=True)
        s = 2 * cloud.X[:, 0] / (SLENDER * HEIGHT)
        shape = np.stack([-cloud.X[:, 1] * legendre.legval(s, rotation),
                          legendre.legval(s, deflection)], axis=1)
        shape /= np.abs(shape).max()
        scene = Scene(cloud, [ROCK], f"plane {plane} {options}", horizon=horizon)
        scene.set("vx vy", VELOCITY * shape)
        # 24 samples a period
        every = int(np.ceil(2 * np.pi / self.omega / 24 / (courant * spacing / speed)))
        dt = 2 * np.pi / self.omega / 24 / every
        scene.add("compute p all tmsph/property/atom ux uy\nfix 1 all nve\n"
                  f"timestep {dt:.17g}\nrun 0")
        for axis, column in zip("xy", shape.T):
            scene.files[f"shape.{axis}"] = f"\n{len(cloud)}\n" + "".join(
                f"{i + 1} {v:.17g}\n" for i, v in enumerate(column))
            scene.add(f"variable s{axis} atomfile shape.{axis}")
        scene.add("variable q atom c_p[1]*v_sx+c_p[2]*v_sy\ncompute q all reduce sum v_q")
        run = scene.thermo("step c_q", every).add(f"run {24 * periods * every}").run(ranks)
        self.cost = run.cost
        # error of the period
        self.error = self.omega / sampled_frequency(run.thermo("c_q"), every * dt) - 1
