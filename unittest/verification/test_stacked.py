# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Two blocks on top of each other in a box with smooth walls, pressed by 4 %: equal and
different spacings, equal and 10:1 stiffness, contact as it is and 1000 times stiffer. The
force is that of St Venant-Kirchhoff material in oedometric compression, both blocks under
the same force. A contact 1000 times stiffer is to be stable; its force is too large, since
the contact stands for the cells on both sides of the surface.

Each block has the horizon that fits its spacing."""

from tmsph_testing import *

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


def press(report, low, high, ratio=1.0, stiffness=1.0):
    cloud = stacked(low, high)
    rocks = [material(YOUNG, POISSON, 1000.0), material(YOUNG * ratio, POISSON, 1000.0)]
    for rock, n in zip(rocks, (low, high)):
        rock["horizon"] = HORIZON * EDGE / n
    wave = (max(r["young"] for r in rocks) * 0.8 / (1.2 * 0.6) / 1000) ** 0.5
    step = 0.4 * EDGE / max(low, high) / wave
    scene = Scene(cloud, rocks, "viscosity 1.0 0.0")
    scene.lines[2] = "boundary f f p"
    scene.add("change_box all x final -1 1 y final -1 1\npair_coeff 1 2 none")
    height, push = 2 * EDGE, 2 * EDGE * STRAIN
    wave_slow = (min(r["young"] for r in rocks) * 0.8 / (1.2 * 0.6) / 1000) ** 0.5
    way = 20 * height / wave_slow    # slow: twenty passes of the wave
    drag = 0.5 * 1000 * np.pi * wave_slow / height * cloud.volume.min()
    scene.add(f"""variable down equal "-{push / way:.17g}*ternary(time<{way:.17g},1,0)"
fix move all nve
fix drag all viscous {drag:.6g}
fix contact all tmsph/contact stiffness {stiffness}
fix floor all tmsph/wall line -1 0 1 0
fix plate all tmsph/wall line 1 {height} -1 {height} velocity 0 v_down
fix left all tmsph/wall line 0 1 0 -1
fix right all tmsph/wall line {EDGE} -1 {EDGE} 1
compute p all tmsph/property/atom syy sxx
timestep {step:.17g}""")
    scene.thermo("step time ke f_floor[2] f_plate[2] f_contact[2] f_contact[10] f_contact[8]", 500)
    run = scene.add(f"run {int(1.4 * way / step)}").snapshot("end", "type x y c_p[*]").run()
    what = f"{low}/{high}" + (f", stiffness {ratio:g}:1" if ratio != 1 else "") + \
        (f", contact x {stiffness:g}" if stiffness != 1 else "")
    should = exact([YOUNG, YOUNG * ratio])
    if stiffness == 1:
        report.below(f"{what}: force on the floor against exact",
                     abs(-run.thermo("f_floor[2]")[-1] / should - 1), 0.03)
    report.below(f"{what}: force of contact against that on the floor",
                 abs(run.thermo("f_contact[2]")[-1] / run.thermo("f_floor[2]")[-1] - 1), 1e-3)
    report.below(f"{what}: kinetic over strain energy",
                 run.thermo("KinEng")[-1] / (should * push), 1e-6)
    if stiffness != 1:
        return
    end = run.frame("end")
    inside = (np.abs(end["x"] - EDGE / 2) < EDGE / 2 - 0.2 * EDGE) & \
        (end["y"] > 0.3 * EDGE) & (end["y"] < 1.6 * EDGE)
    pressure = -end["c_p[1]"][inside]
    report.below(f"{what}: scatter of pressure between the walls",
                 pressure.std() / pressure.mean(), 0.05)


report = Report()
press(report, 10, 10)
press(report, 10, 20)
press(report, 20, 10)
press(report, 14, 20)
press(report, 10, 10, ratio=10)
press(report, 14, 20, ratio=10)
press(report, 10, 10, stiffness=1000)
press(report, 14, 20, stiffness=1000)
report.finish()
