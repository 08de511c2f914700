# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Contact of bodies by segments, beside that by pairs, and its laws: a block under a load on a bar
that is drawn away beneath it; a block pushed into the corner of an angle. The outlines are found by
the package.

all_laws prints the table of doc/report/contact.md."""

import numpy as np

from tmsph_testing import HORIZON, Cloud, Scene, lattice, main, material

EDGE, YOUNG, POISSON, DENSITY = 0.1, 10e6, 0.2, 1000.0
WAVE = (YOUNG * (1 - POISSON) / ((1 + POISSON) * (1 - 2 * POISSON)) / DENSITY) ** 0.5
LOAD, FRICTION = 5000.0, 0.3


def together(*bodies):
    """Clouds of several spacings as one; each is a type."""
    cloud = Cloud(np.concatenate([b.X for b in bodies]), 1.0, max(b.spacing for b in bodies))
    cloud.volume = np.concatenate([b.volume for b in bodies])
    cloud.type = np.repeat(np.arange(len(bodies)) + 1, [len(b) for b in bodies])
    return cloud


def scene_of(bodies, viscosity, cfl):
    rocks = [dict(material(YOUNG, POISSON, DENSITY), horizon=HORIZON * b.spacing) for b in bodies]
    scene = Scene(together(*bodies), rocks, f"viscosity {viscosity} 0")
    scene.lines[2] = "boundary f f p"
    step = cfl * min(b.spacing for b in bodies) / WAVE
    scene.add("change_box all x final -1 1 y final -1 1\npair_coeff 1 2 none\n"
              f"fix move all nve\ntimestep {step:.17g}")
    return scene, step


def square(n, x=0.0, y=0.0, columns=1):
    """Block with n particles along its height of EDGE."""
    body = lattice("square", (int(columns * n), n), EDGE / n)
    body.X = body.X + [x, y]
    return body


def drawn(bar, block, words, cfl=0.4, viscosity=1.0):
    """The bar is drawn away under the block by a tenth of its edge; a plate with a load lies on the
    block, a smooth wall holds it back. Forces between the two while it slides."""
    low, high = square(bar, columns=2), square(block, 0.5 * EDGE, EDGE)
    scene, step = scene_of((low, high), viscosity, cfl)
    settle, way = 60 * EDGE / WAVE, 0.1 * EDGE
    speed = way / (2 * settle)
    drag = DENSITY * np.pi * WAVE / EDGE / 2 * high.volume[0]
    scene.add(f"""region feet block INF INF INF {1.01 * EDGE / bar} INF INF units box
group feet region feet
group upper type 2
fix drag upper viscous {drag:.6g}
fix feet feet setforce 0 0 0
variable load equal "-{LOAD}*ternary(time<{settle / 2:.17g},time/{settle / 2:.17g},1)"
fix hold all tmsph/wall line {0.5 * EDGE} {3 * EDGE} {0.5 * EDGE} {1.02 * EDGE}
fix plate all tmsph/wall line 1 {2 * EDGE} -1 {2 * EDGE} load NULL v_load &
    mass {0.1 * DENSITY * EDGE**2}
fix contact all tmsph/contact friction * * {FRICTION} {words}""")
    scene.thermo("step f_contact[1] f_contact[2] f_contact[10]", 20)
    scene.add(f"run {int(settle / step)}\nvelocity feet set {-speed:.17g} 0 0")
    run = scene.add(f"run {int(2 * settle / step)}").run(may_fail=True)
    if run.failed:
        return None
    sliding = slice(len(run.thermo("Step")) // 2, None)
    return run.thermo("f_contact[1]")[sliding], run.thermo("f_contact[2]")[sliding]


def figures(forces):
    """Normal force/load, friction/normal force, scatter of both."""
    along, across = np.abs(forces)
    return (across.mean() / LOAD, along.mean() / across.mean(), across.std() / across.mean(),
            along.std() / along.mean())


def cornered(report):
    """A block pushed along the diagonal into an angle whose legs stand on smooth walls."""
    angle = square(20, columns=1)
    angle.X, angle.spacing, angle.volume = 2 * angle.X, EDGE / 10, 4 * angle.volume
    angle = angle.kept(lambda X: X.min(axis=1) < 0.5 * EDGE)
    block = square(14, 0.5 * EDGE, 0.5 * EDGE)
    scene, step = scene_of((angle, block), 1.0, 0.4)
    ramp, push = 20 * EDGE / WAVE, LOAD / len(block)
    scene.add(f"""group upper type 2
variable push equal "-{push:.17g}*ternary(time<{ramp:.17g},time/{ramp:.17g},1)"
fix drag all viscous {DENSITY * np.pi * WAVE / EDGE / 2 * block.volume[0]:.6g}
fix push upper addforce v_push v_push 0
fix left all tmsph/wall line 0 1 0 -1
fix floor all tmsph/wall line -1 0 1 0
fix contact all tmsph/contact method segment""")
    scene.thermo("step ke f_contact[1] f_contact[2] f_left[1] f_floor[2] f_contact", 100)
    run = scene.add(f"run {int(3 * ramp / step)}").snapshot("end", "type x y").run()
    for name, what in (("f_contact[1]", "sideways"), ("f_contact[2]", "downwards")):
        report.within(f"corner: force {what}/push", -run.thermo(name)[-1] / LOAD, 0.999, 1.001)
    report.within("corner: force of the left wall/push", -run.thermo("f_left[1]")[-1] / LOAD,
                  0.999, 1.001)
    report.below("corner: kinetic energy/that of contact",
                 run.thermo("KinEng")[-1] / run.thermo("f_contact")[-1], 1e-3)
    end = run.frame("end")
    X = end("x y")
    report.above("corner: block outside the legs, spacings of these",
                 (X[end["type"] == 2].min() - 0.5 * EDGE) / (EDGE / 10), 0.0)


def judge(report, bar, block, words, mean, scatter):
    normal, friction, one, other = figures(drawn(bar, block, words))
    what = f"block {block} on bar {bar}, {words}"
    report.within(f"{what}: normal force/load", normal, 1 - mean, 1 + mean)
    report.within(f"{what}: friction/normal force", friction, FRICTION * (1 - 5 * mean),
                  FRICTION * (1 + 5 * mean))
    report.below(f"{what}: scatter of the normal force", one, scatter)
    report.below(f"{what}: scatter of friction", other, scatter)
    return normal, friction


def drawn_away(report):
    for words in ("method kernel", "method segment", "method kernel law penalty",
                  "method segment law penalty"):
        judge(report, 10, 14, words, 0.002, 0.01)


def half_the_step(report):
    one = figures(drawn(10, 14, "method segment"))
    half = figures(drawn(10, 14, "method segment", cfl=0.2))
    for k, name in enumerate(("normal force", "friction/normal force")):
        report.below(f"half the time step, method segment: change of {name}",
                     abs(half[k] / one[k] - 1), 0.005)


def law_of_the_paper(report):
    for method in ("kernel", "segment"):
        # the bar is that of the others
        report.above(f"law paper, method {method}: scatter of the normal force",
                     figures(drawn(10, 14, f"method {method} law paper"))[2], 0.01)


def all_laws(report):
    print("method, law, time step, viscosity: normal force/load, friction/normal force, scatter")
    for method in ("kernel", "segment"):
        for law in ("implicit", "penalty", "paper"):
            for cfl, viscosity in ((0.4, 1.0), (0.2, 1.0), (0.4, 0.0)):
                forces = drawn(10, 14, f"method {method} law {law}", cfl, viscosity)
                row = "stopped" if forces is None else " ".join(
                    f"{x:.4f}" for x in figures(forces))
                report.note(f"{method} {law} {cfl} {viscosity}", row)


if __name__ == "__main__":
    main(cornered, drawn_away, half_the_step, law_of_the_paper,
         more=(all_laws,))
