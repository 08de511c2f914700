# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Hoek-Brown breaking in homogeneous stress. All particles are displaced so that
the Cauchy stress is known exactly; at 0.999 of the criterion no bond breaks, at
1.001 of it all do. The constants are those of Hoek, Carranza-Torres and Corkum
(2002), written down here again; so are Mohr-Coulomb and Rankine, whose states are
blocks side by side in one run."""

import numpy as np

from scenes.hoekbrown import (BLOCKS, MI, ROCK, SPACING, STRENGTH, Block, constants, critical,
                              stretches, turned)
from tmsph_testing import Cloud, Scene, lattice, main

BELOW, ABOVE = 0.999, 1.001
STRESS = 1e-7    # closed-form principal values lose half of the digits where two of them coincide


def state(report, what, direction, rock_words, rock, tags, zz=None):
    d = len(direction)
    factor = critical(direction, rock, STRENGTH, zz)
    block = Block(d, f"strength * {STRENGTH} mi * {MI} {rock_words}")
    for share in (BELOW, ABOVE):
        block.load(share * factor * np.array(direction))
    run = block.run()
    below, above = run.thermo("f_hb", 1)[-1], run.thermo("f_hb", 2)[-1]
    # the stress is what it is meant to be: before the step, in the setup of each run
    S = [run.thermo(f"c_{side}[{k}]", 2)[0] for side in ("low", "high") for k in (1, 2)]
    wanted = ABOVE * factor * np.array(direction)
    error = max(abs(S[0] - wanted.max()), abs(S[2] - wanted.max()))
    if d == 3:
        error = max(error, abs(S[1] - wanted.min()), abs(S[3] - wanted.min()))
    name = f"{what}, at {factor / STRENGTH:.6f} of the strength"
    report.below(f"{name}: error of the stress", error / (factor * np.abs(direction).max()), STRESS)
    report.below(f"{name}: broken at 0.999", below, 1)
    report.within(f"{name}: share broken at 1.001", above / len(block.bonds), 1, 1)
    report.within(f"{name}: load factor at 0.999", run.thermo("f_hb[4]", 1)[-1], 0.9989, 0.9991)
    if tags:
        tension, shear = run.thermo("f_hb[1]", 2)[-1], run.thermo("f_hb[2]", 2)[-1]
        report.within(f"{name}: share in {tags}", (tension if tags == "tension" else shear) / above,
                      1, 1)


def states(report):
    plane = [("uniaxial compression", (-1, 0), ""), ("uniaxial tension", (1, 0), "tension"),
             ("biaxial tension", (1, 1), "tension"), ("confined compression", (-1, -0.05), "shear"),
             ("shear", (1, -1), "tension")]
    space = [("uniaxial compression", (-1, 0, 0), ""), ("uniaxial tension", (1, 0, 0), "tension"),
             ("biaxial tension", (1, 1, 0), "tension"), ("triaxial tension", (1, 1, 1), "tension"),
             ("confined compression", (-1, -0.3, -0.05), "shear")]
    for gsi, disturbance in ((100, 0), (75, 0), (75, 1), (50, 0), (50, 1)):
        rock = constants(gsi, disturbance)
        words = f"gsi * {gsi} disturbance * {disturbance}"
        for name, direction, tags in plane + space:
            state(report, f"{len(direction)}-D, gsi {gsi}, D {disturbance}, {name}",
                  direction, words, rock, tags)
    # out of the plane: szz = nu (sxx + syy)
    for name, direction, tags in plane:
        state(report, f"all principals, {name}", direction, "principal all", constants(100, 0),
              tags, 0.3 * sum(direction))


def closed_forms(report):
    """The bisection against the closed forms for a = 1/2 and the strengths of any a."""
    rock = constants(100, 0)
    mb, s, a = rock
    report.below("uniaxial tension, bisection against closed form",
                 abs(critical((1, 0), rock, 1.0) / (0.5 * (np.sqrt(mb**2 + 4 * s) - mb)) - 1),
                 1e-12)
    for gsi in (100, 75, 50):
        mb, s, a = rock = constants(gsi, 1)
        report.below(f"gsi {gsi}, compression s^a and biaxial tension s/mb, against closed form",
                     abs(critical((-1, 0), rock, 1.0) / s**a - 1) +
                     abs(critical((1, 1), rock, 1.0) * mb / s - 1), 1e-12)


def two_rocks(report):
    """Bonds between rocks of equal elasticity have the mean strength and constants."""
    strengths, rocks = (100e6, 200e6), (constants(100, 0, 6.0), constants(60, 0, 12.0))
    between = tuple(np.mean(rocks, axis=0))
    for name, direction in (("compression", (-1, -0.02)), ("tension", (1, 0))):
        factor = critical(direction, between, np.mean(strengths))
        limits = [critical(direction, rock, strength) for rock, strength in zip(rocks, strengths)]
        for share in (BELOW, ABOVE):
            cloud = lattice(*BLOCKS[2], SPACING)
            cloud.type = np.where(cloud.X[:, 0] < cloud.X[:, 0].mean(), 1, 2)
            block = Block(2, "strength 1 100e6 strength 2 200e6 mi 1 6 mi 2 12 gsi 1 100 gsi 2 60",
                          cloud, 2).load(share * factor * np.array(direction))
            block.run()
            kinds = cloud.type[block.bonds - 1].sum(axis=1)
            broken = np.array([tuple(bond) in block.broken for bond in block.bonds])
            what = f"two rocks, {name} at {share}"
            for kind, limit in ((2, limits[0]), (4, limits[1]), (3, factor)):
                report.within(f"{what}: share of bonds {kind // 2}-{kind - kind // 2} broken",
                              broken[kinds == kind].mean(), *[int(share * factor > limit)] * 2)


def scattered(report):
    """Weibull strengths: a bond breaks with the mean of its ends' strengths."""
    for d in (2, 3):
        s = constants(75, 0)[1] ** constants(75, 0)[2]
        block = Block(d, f"strength * {STRENGTH} mi * {MI} gsi * 75 weibull * 10 7")
        block.load([-0.95 * STRENGTH * s] + [0] * (d - 1)).run()
        mean = block.strength[block.bonds - 1].mean(axis=1)
        due = {tuple(bond) for bond in block.bonds[0.95 * STRENGTH >= mean]}
        what = f"{d}-D, scattered strengths, compression"
        report.within(f"{what}: share due", len(due) / len(block.bonds), 0.2, 0.8)
        report.below(f"{what}: bonds not as due", len(due ^ block.broken), 1)


def mohr_coulomb(p):
    """Load factor of principal stresses, tension positive, over the cohesion."""
    N = (1 + np.sin(np.radians(FRICTION))) / (1 - np.sin(np.radians(FRICTION)))
    return max((N * max(p) - min(p)) / (2 * np.sqrt(N) * COHESION), max(p) / TENSILE)


def directions(d):
    """Twenty states from tension to confined compression; the last never fails."""
    angles = np.radians(np.linspace(15, 115, 17))
    plane = [(np.sin(a) - 0.3, -np.cos(a)) for a in angles]
    plane += [(-0.05, -1.0), (-0.1, -1.0), (-0.15, -1.0)]
    return plane if d == 2 else [(x, 0.4 * x + 0.6 * y, y) for x, y in plane]


def other_laws(report):
    laws = {"mohrcoulomb": (f"cohesion * {COHESION} friction * {FRICTION} tensile * {TENSILE}",
                            mohr_coulomb),
            "rankine": (f"tensile * {TENSILE}", lambda p: max(p) / TENSILE)}
    for d in (2, 3):
        name, cells = BLOCKS[d]
        one = lattice(name, cells, SPACING)
        shift = np.arange(len(directions(d)))[:, None, None] * np.eye(d)[0] * 25 * SPACING
        cloud = Cloud((one.X + shift).reshape(-1, d), one.volume[0], SPACING)
        for law, (words, load) in laws.items():
            factors = [1 / load(p) if load(p) > 0 else 1e6 for p in directions(d)]
            scene = Scene(cloud, [ROCK]).add(f"fix b all tmsph/{law} {words}\nrun 0")
            scene.add("compute b all tmsph/bond/local id1 state")
            for share in (BELOW, ABOVE):
                F = [turned(d) @ np.diag(stretches(share * factor * np.array(p))) @ turned(d).T
                     for factor, p in zip(factors, directions(d))]
                scene.move(np.concatenate([one.X @ f.T + s for f, s in zip(F, shift)]))
                scene.add("run 1").add(f"write_dump all local bonds{share}.local c_b[*]")
            run = scene.run()
            for share in (BELOW, ABOVE):
                id1, state = np.stack(list(run.frame(f"bonds{share}").values())).astype(int)
                for k, p in enumerate(directions(d)):
                    of = (id1 - 1) // len(one) == k
                    wanted = int(share > 1 and load(p) > 0)
                    report.within(f"{law}, {d}-D, state {k + 1} at {share}: share broken",
                                  (state[of] == 1).mean(), wanted, wanted)


COHESION, FRICTION, TENSILE = 25e6, 50.0, 9e6


if __name__ == "__main__":
    main(other_laws, closed_forms, states, two_rocks, scattered)
