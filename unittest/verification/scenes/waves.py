# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Standing plane waves of small amplitude in periodic blocks, longitudinal (polarization 0)
and transverse (1)."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, material, sampled_frequency

SPACING, STRAIN = 1e-3, 1e-6
ROCK = material()
E, NU, RHO = ROCK["young"], ROCK["poisson"], ROCK["density"]
SHEAR = E / (2 * (1 + NU))
MODULUS = {0: E * (1 - NU) / ((1 + NU) * (1 - 2 * NU)), 1: SHEAR}    # by polarization


class StandingWave:
    """Amplitude q at equal intervals over some periods, n particles per wave."""

    def __init__(self, d, n, polarization, options="", horizon=HORIZON, courant=0.25, every=1,
                 periods=2.75, ranks=1):
        # 7 rows: numbers of particles that are no multiple of the eight that are treated at once
        rows = max(7, int(np.ceil(2 * horizon)))
        cloud = lattice(*(("square", (n, rows)) if d == 2 else ("sc", (n, rows, rows))), SPACING,
                        "xyz"[:d])
        k = 2 * np.pi / (n * SPACING)
        speed = (MODULUS[polarization] / RHO) ** 0.5
        velocity = np.zeros_like(cloud.X)
        velocity[:, polarization] = STRAIN * speed * np.sin(k * cloud.X[:, 0])
        dt = courant * SPACING / (MODULUS[0] / RHO) ** 0.5
        steps = int(periods * n * SPACING / speed / dt)
        axis = "xy"[polarization]
        scene = Scene(cloud, [ROCK], options, horizon=horizon)
        scene.set("vx vy vz"[: 3 * d - 1], velocity)
        scene.add(f"compute p all tmsph/property/atom u{axis} x0\n"
                  f"variable q atom c_p[1]*sin({k:.17g}*c_p[2])\ncompute q all reduce sum v_q\n"
                  f"timestep {dt:.17g}\nfix 1 all nve\nrun 0")
        run = scene.thermo("step c_q", every).add(f"run {steps // every * every}").run(ranks)
        self.q, self.dt, self.interval, self.cost = run.thermo("c_q"), dt, every * dt, run.cost
        self.exact = speed * k

    def speed_error(self):
        """Of the phase speed, with the error of the time step in it."""
        return sampled_frequency(self.q, self.interval) / self.exact - 1
