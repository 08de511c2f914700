# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Two blocks on top of each other in a box with smooth walls, pressed by 4 %, with contact
between them, against the force of St Venant-Kirchhoff material in oedometric compression."""

import numpy as np

from tmsph_testing import HORIZON, Cloud, Scene, lattice, material

EDGE, STRAIN, POISSON = 0.1, 0.04, 0.2
YOUNG = 10e6


def block(n):
    return lattice("square", (n, n), EDGE / n)


def stacked(low, high):
    one, two = block(low), block(high)
    cloud = Cloud(np.concatenate([one.X, two.X + [0, EDGE]]), 1.0, EDGE / min(low, high))
    cloud.volume = np.concatenate([one.volume, two.volume])
    cloud.type = np.repeat([1, 2], [len(one), len(two)])
    return cloud


def force(young, stretch):
    modulus = young * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON))
    return modulus * EDGE * stretch * (1 - stretch**2) / 2


def exact(young):
    """The force under which both blocks together lose STRAIN of their height."""
    low, high = 0.0, 2 * STRAIN    # strain of the first block
    for _ in range(100):
        first = 0.5 * (low + high)
        if force(young[0], 1 - first) > force(young[1], 1 - (2 * STRAIN - first)):
            high = first
        else:
            low = first
    return force(young[0], 1 - low)


class Stacked:
    """low and high particles along the edges of the lower and the upper block, whose stiffness
    is ratio times that of the lower; stiffness is the factor of the contact, words are others of
    it; every: steps between values of its force."""

    def __init__(self, low, high, ratio=1.0, stiffness=1.0, options="", horizon=HORIZON,
                 courant=0.4, passes=20, ranks=1, words="", every=500):
        cloud = stacked(low, high)
        rocks = [material(YOUNG, POISSON, 1000.0), material(YOUNG * ratio, POISSON, 1000.0)]
        for rock, n in zip(rocks, (low, high)):
            rock["horizon"] = horizon * EDGE / n
        wave = (max(r["young"] for r in rocks) * 0.8 / (1.2 * 0.6) / 1000) ** 0.5
        step = courant * EDGE / max(low, high) / wave
        scene = Scene(cloud, rocks, f"viscosity 1.0 0.0 {options}", horizon=horizon)
        scene.lines[2] = "boundary f f p"
        scene.add("change_box all x final -1 1 y final -1 1\npair_coeff 1 2 none")
        height, push = 2 * EDGE, 2 * EDGE * STRAIN
        wave_slow = (min(r["young"] for r in rocks) * 0.8 / (1.2 * 0.6) / 1000) ** 0.5
        way = passes * height / wave_slow    # slow: so many passes of the wave
        drag = 0.5 * 1000 * np.pi * wave_slow / height * cloud.volume.min()
        scene.add(f"""variable down equal "-{push / way:.17g}*ternary(time<{way:.17g},1,0)"
fix move all nve
fix drag all viscous {drag:.6g}
fix contact all tmsph/contact stiffness {stiffness} {words}
fix floor all tmsph/wall line -1 0 1 0
fix plate all tmsph/wall line 1 {height} -1 {height} velocity 0 v_down
fix left all tmsph/wall line 0 1 0 -1
fix right all tmsph/wall line {EDGE} -1 {EDGE} 1
compute p all tmsph/property/atom syy sxx
timestep {step:.17g}""")
        scene.thermo("step time ke f_floor[2] f_plate[2] f_contact[2] f_contact[10] f_contact[8]",
                     every)
        run = scene.add(f"run {int(1.4 * way / step)}").snapshot("end",
                                                                 "type x y c_p[*]").run(ranks)
        self.cost = run.cost
        should = exact([YOUNG, YOUNG * ratio])
        self.contact = -run.thermo("f_contact[2]")
        floor, contact = -run.thermo("f_floor[2]")[-1], self.contact[-1]
        self.error = floor / should - 1
        self.imbalance = contact / floor - 1
        self.kinetic = run.thermo("KinEng")[-1] / (should * push)
        end = run.frame("end")
        inside = (np.abs(end["x"] - EDGE / 2) < EDGE / 2 - 0.2 * EDGE) & \
            (end["y"] > 0.3 * EDGE) & (end["y"] < 1.6 * EDGE)
        pressure = -end["c_p[1]"][inside]
        self.scatter = pressure.std() / pressure.mean()    # between the walls
