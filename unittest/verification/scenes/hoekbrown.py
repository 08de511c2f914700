# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Homogeneous states of a free block of intact rock whose Cauchy stress is known exactly, and
the Hoek-Brown criterion of Hoek, Carranza-Torres and Corkum (2002), written down here again."""

import numpy as np

from tmsph_testing import Scene, lattice, material

SPACING, MI = 1e-3, 8.0
ROCK = material(40e9, 0.3, 2700)
LAMBDA = 40e9 * 0.3 / (1.3 * 0.4)
SHEAR = 40e9 / 2.6
STRENGTH = 120e6
BLOCKS = {2: ("hex", (7, 4)), 3: ("sc", (5, 5, 5))}


def constants(gsi, disturbance, mi=MI):
    return (mi * np.exp((gsi - 100) / (28 - 14 * disturbance)),
            np.exp((gsi - 100) / (9 - 3 * disturbance)),
            0.5 + (np.exp(-gsi / 15) - np.exp(-20 / 3)) / 6)


def critical(direction, rock, strength, zz=None):
    """The factor by which principal stresses (tension positive) meet the criterion; by
    bisection."""
    values = list(direction) + ([zz] if zz is not None else [])
    S1, S3 = -min(values), -max(values)
    mb, s, a = rock
    low, high = 0.0, 100.0 * strength
    for _ in range(200):
        middle = 0.5 * (low + high)
        bracket = mb * middle * S3 / strength + s
        broken = bracket <= 0 or middle * (S1 - S3) >= strength * bracket**a
        low, high = (low, middle) if broken else (middle, high)
    return high


def stretches(principal):
    """Those of a St Venant-Kirchhoff body with these principal Cauchy stresses: the second
    Piola-Kirchhoff stress is J sigma/stretch^2, Hooke's law gives the strain. Iterated."""
    principal = np.asarray(principal, float)
    d, stretch = len(principal), np.ones(len(principal))
    for _ in range(60):
        second = np.prod(stretch) * principal / stretch**2
        strain = (second - LAMBDA * second.sum() / (d * LAMBDA + 2 * SHEAR)) / (2 * SHEAR)
        stretch = np.sqrt(1 + 2 * strain)
    return stretch


def turned(d):
    """Principal directions that are not those of the lattice."""
    angle = np.radians(17)
    turn = np.eye(d)
    turn[:2, :2] = [[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]]
    if d == 3:
        tilt = np.eye(3)
        tilt[1:, 1:] = turn[:2, :2]
        turn = turn @ tilt
    return turn


class Block:
    """A free block that is taken from one homogeneous stress to the next."""

    def __init__(self, d, breaking, cloud=None, rocks=1):
        name, cells = BLOCKS[d]
        self.cloud = cloud or lattice(name, cells, SPACING)
        self.scene = Scene(self.cloud, [ROCK] * rocks)
        self.scene.add(f"fix hb all tmsph/hoekbrown {breaking}\n"
                       "compute s all tmsph/property/atom s1 s2 s3 strength\n"
                       "compute low all reduce min c_s[1] c_s[3]\n"
                       "compute high all reduce max c_s[1] c_s[3]\n"
                       "compute b all tmsph/bond/local id1 id2 state\n"
                       "thermo_style custom step f_hb f_hb[1] f_hb[2] f_hb[4] c_low[*] c_high[*]\n"
                       "thermo_modify norm no format float %.17g\nrun 0")
        self.scene.add("write_dump all local bonds.local c_b[*]").snapshot("s", "c_s[4]")

    def load(self, principal):
        d = self.cloud.dimension
        turn = turned(d)
        F = turn @ np.diag(stretches(principal)) @ turn.T
        self.scene.move(self.cloud.X @ F.T).add("run 1")
        return self

    def run(self):
        run = self.scene.add("write_dump all local events.local f_hb[*]").run()
        self.bonds = np.stack(list(run.frame("bonds").values()), axis=1)[:, :2].astype(int)
        self.strength = run.frame("s")["c_s[4]"]
        events = np.stack(list(run.frame("events").values()), axis=1)[:, :2].astype(int)
        self.broken = set(map(tuple, events))
        return run


class Loading:
    """A state taken past the criterion in equal steps, the last half a step beyond it. error is
    how far the load at which the bonds break is off; with factor, that of the load factor
    after the first step."""

    def __init__(self, direction, steps, factor=False):
        limit = critical(direction, constants(100, 0), STRENGTH)
        block = Block(len(direction), f"strength * {STRENGTH} mi * {MI} gsi * 100")
        shares = (np.arange(steps) + 1) / (steps - 0.5)
        for share in shares[: 1 if factor else steps]:
            block.load(share * limit * np.array(direction))
        run = block.run()
        self.cost = run.cost
        if factor:
            self.error = run.thermo("f_hb[4]", 1)[-1] / shares[0] - 1
        else:
            broken = np.array([run.thermo("f_hb", k + 1)[-1] for k in range(steps)])
            self.error = shares[np.argmax(broken > 0)] - 1 if broken.any() else np.inf
