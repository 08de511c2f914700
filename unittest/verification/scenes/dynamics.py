# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A free block that rotates and vibrates: energy and angular momentum."""

from math import fsum

import numpy as np

from tmsph_testing import Scene, lattice, material

SPACING, STEPS, EVERY = 1e-3, 100000, 500
ROCK = material()
SPEED = (ROCK["young"] / ROCK["density"]) ** 0.5


class Spinning:
    """Angular velocity such that the rim moves at 0.02 c, and a stretching mode on top."""

    def __init__(self, name, cells, spin, courant, steps=STEPS, every=EVERY, options="", ranks=1):
        self.cloud = cloud = lattice(name, cells, SPACING, centre=True)
        d = cloud.dimension
        r = np.zeros((len(cloud), 3))
        r[:, :d] = cloud.X
        size = r.max()
        omega = 0.02 * SPEED / size * np.array(spin) / np.linalg.norm(spin)
        velocity = np.cross(omega, r)[:, :d]
        velocity[:, 0] += 0.01 * SPEED * np.sin(0.5 * np.pi * r[:, 0] / size)
        scene = Scene(cloud, [ROCK], options).set("vx vy vz"[: 3 * d - 1], velocity)
        scene.add(f"timestep {courant * SPACING / SPEED:.6g}\nfix 1 all nve")
        scene.thermo("step ke pe", max(1, every // 50))
        scene.dump("d", "x y z vx vy vz", every).add(f"run {steps}")
        self.run = scene.run(ranks)
        self.cost = self.run.cost
        self.energy = self.run.thermo("KinEng") + self.run.thermo("PotEng")
        self.band = np.ptp(self.energy) / self.energy[0]

    def momentum_drift(self):
        """Of the angular momentum in the dumps, over its magnitude."""
        mass = ROCK["density"] * self.cloud.volume
        momenta = []
        for frame in self.run.dumps["d"]:
            L = np.cross(frame("x y z"), mass[:, None] * frame("vx vy vz"))
            momenta.append([fsum(L[:, k]) for k in range(3)])
        momenta = np.array(momenta)
        return np.linalg.norm(momenta - momenta[0], axis=1) / np.linalg.norm(momenta[0])
