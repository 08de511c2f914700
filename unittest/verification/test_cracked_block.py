# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A block with a closed crack through it, of bonds that are gone, pressed between smooth
plates. With much friction it is as stiff as the intact block. With the crack inclined by 20
degrees it holds when the angle of friction is 6 % larger, and slides until the load is gone
when it is 6 % smaller."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

EDGE, N, STRAIN = 0.1, 20, 1e-3
SPACING = EDGE / N
ROCK = material(10e6, 0.2, 1000.0)
WAVE = (ROCK["young"] * 0.8 / (1.2 * 0.6) / ROCK["density"]) ** 0.5


def press(angle, friction, lattice_name="square"):
    """Force on the upper plate, and the movement of the upper part along the crack against
    the lower, in spacings. angle None: no crack."""
    cells = (N, N) if lattice_name == "square" else (N, round(N / 3**0.5))
    cloud = lattice(lattice_name, cells, SPACING, centre=True)
    height = 2 * cloud.X[:, 1].max() + cloud.volume[0] ** 0.5
    scene = Scene(cloud, [ROCK], "viscosity 1.0 0.0")
    scene.lines[2] = "boundary f f p"
    scene.add("change_box all x final -1 1 y final -1 1")
    along = np.array([np.cos(np.radians(angle or 0)), np.sin(np.radians(angle or 0))])
    up = cloud.X @ [-along[1], along[0]] > 1e-4 * SPACING
    if angle is not None:
        a, b = (end + 1e-4 * SPACING * np.array([-along[1], along[0]]) for end in (-along, along))
        scene.add(f"tmsph/cut all line {a[0]:.17g} {a[1]:.17g} {b[0]:.17g} {b[1]:.17g}")
    way = 40 * height / WAVE
    drag = 0.5 * ROCK["density"] * np.pi * WAVE / height * cloud.volume[0]
    step = 0.5 * SPACING / WAVE
    scene.add(f"""variable down equal "-{STRAIN * height / way:.17g}*ternary(time<{way:.17g},1,0)"
fix move all nve
fix drag all viscous {drag:.6g}
fix contact all tmsph/contact friction * * {friction}
fix floor all tmsph/wall line -1 {-height / 2:.17g} 1 {-height / 2:.17g}
fix plate all tmsph/wall line 1 {height / 2:.17g} -1 {height / 2:.17g} velocity 0 v_down
timestep {step:.17g}""")
    scene.thermo("step time ke f_plate[2] f_contact[7]", 500)
    scene.add(f"run {int(1.5 * way / step)}\nunfix drag\nrun {int(4 * way / step)}")
    run = scene.snapshot("end", "x y").run()
    moved = (run.frame("end")("x y") - cloud.X) @ along
    return run.thermo("f_plate[2]")[-1], (moved[up].mean() - moved[~up].mean()) / SPACING


def cracked(report):
    for name in ("square", "hex"):
        intact = press(None, 0.0, name)[0]
        for angle in (0.0, 20.0):
            force, slip = press(angle, 10.0, name)
            report.below(f"{name}, crack at {angle:g} degrees, stuck: force against the intact "
                         "block", abs(force / intact - 1), 0.02)
        report.note(f"{name}, crack at 45 degrees, stuck: force against the intact block",
                    f"{press(45.0, 10.0, name)[0] / intact - 1:.4f}")
        force, slip = press(20.0, np.tan(np.radians(20 * 1.06)), name)
        report.above(f"{name}, friction 6 % above: holds, force against the intact block",
                     force / intact, 0.98)
        force, slip = press(20.0, np.tan(np.radians(20 * 0.94)), name)
        report.below(f"{name}, friction 6 % below: slides, force left", force / intact, 0.5)
        report.note(f"{name}, its slip in spacings", f"{slip:.3f}")


if __name__ == "__main__":
    main(cracked)
