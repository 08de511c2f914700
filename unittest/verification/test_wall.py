# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Rigid walls against closed forms: a block on an incline that sticks or slides, in 2-D and
3-D; stick-slip on a belt; a block that swings in a bowl; a dropped block; a plate under a
load; a box that turns with what is in it; a bumpy floor; corners."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

GRAVITY, MU, EDGE = 9.81, 0.3, 0.1
ROCK = material(10e6, 0.2, 1000.0)
WAVE = (ROCK["young"] * 0.8 / (1.2 * 0.6) / ROCK["density"]) ** 0.5
N = 10
SPACING = EDGE / N
STEP = 0.5 * SPACING / WAVE
PERIOD = 4 * EDGE / WAVE    # of the lowest vibration, about


class Blocks(Scene):
    """Bodies in a wide box under gravity of a direction that can be changed."""

    def __init__(self, cloud, viscosity=1.0, gravity=True):
        super().__init__(cloud, [ROCK], f"viscosity {viscosity} 0.0")
        box = " ".join(f"{axis} final -2 2" for axis in "xyz"[: cloud.dimension])
        self.lines[2] = "boundary " + "f " * cloud.dimension + "p" * (3 - cloud.dimension)
        self.add(f"change_box all {box}\ntimestep {STEP:.17g}\nfix move all nve")
        if gravity:
            self.add(f"variable tilt equal 0.0\nvariable along equal sin(v_tilt)\n"
                     f"variable down equal -cos(v_tilt)\n"
                     f"fix g all gravity {GRAVITY} vector v_along v_down 0")
        self.mass = ROCK["density"] * cloud.volume.sum()

    def drag(self):
        """Near to critical for the lowest vibration; to be lifted by unfix."""
        per_particle = self.mass / len(self.cloud) * 2 * np.pi / PERIOD
        return self.add(f"fix drag all viscous {per_particle:.6g}")

    def steps(self, seconds):
        return self.add(f"run {int(np.ceil(seconds / STEP))}")


def square(n=N, spacing=SPACING):
    return lattice("square", (n, n), spacing)


def incline(report, angle):
    scene = Blocks(square()).drag()
    scene.add(f"fix w all tmsph/wall line -2 0 2 0 friction {MU}\n"
              "variable x equal xcm(all,x)\nvariable v equal vcm(all,x)")
    scene.thermo("step time v_x v_v f_w[1] f_w[2]", 100)
    tilt = np.radians(angle)
    scene.steps(0.1).add(f"variable tilt equal {tilt:.17g}")
    sticks = np.tan(tilt) < MU
    if sticks:    # what is asked is rest, not how a sudden push dies away
        scene.steps(0.4)
    run = scene.add("unfix drag").steps(0.25).run()
    x, v, t = run.thermo("v_x"), run.thermo("v_v"), run.thermo("Time")
    if sticks:
        report.below(f"incline of {angle} degrees: creep in 0.25 s, m", np.ptp(x), 1e-8)
        return
    exact = GRAVITY * (np.sin(tilt) - MU * np.cos(tilt))
    later = len(t) // 5
    report.below(f"incline of {angle} degrees: acceleration against exact",
                 abs(np.polyfit(t[later:], v[later:], 1)[0] / exact - 1), 1e-3)


def plane(report):
    """A cube on an oblique plane, pushed by gravity and held by friction, then not."""
    n, edge = 5, 5 * SPACING
    for angle, tangent in ((12.0, 0), (25.0, 1)):
        scene = Blocks(lattice("sc", (n,) * 3, SPACING)).drag()
        scene.add(f"fix w all tmsph/wall plane 0 0 0 0 1 0 friction {MU}\n"
                  "variable x equal xcm(all,x)\nvariable v equal vcm(all,x)")
        scene.thermo("step time v_x v_v", 100)
        scene.steps(0.1).add(f"variable tilt equal {np.radians(angle):.17g}")
        if not tangent:
            scene.steps(0.4)
        run = scene.add("unfix drag").steps(0.15).run()
        exact = GRAVITY * (np.sin(np.radians(angle)) - MU * np.cos(np.radians(angle)))
        t, v = run.thermo("Time"), run.thermo("v_v")
        if tangent:
            later = len(t) // 5
            report.below("cube on a plane: acceleration against exact",
                         abs(np.polyfit(t[later:], v[later:], 1)[0] / exact - 1), 1e-3)
        else:
            report.below("cube on a plane: creep, m", np.ptp(run.thermo("v_x")), 1e-8)


def belt(report):
    """A block on a moving belt, held by a spring: sticks until the spring pulls mu N, then
    swings with the belt slipping beneath it, until it is as fast as the belt."""
    speed, spring = 0.05, 4000.0
    scene = Blocks(square()).drag().add(
        f"fix hold all spring tether {spring} {EDGE / 2} NULL NULL 0.0\nvariable go equal 0.0\n"
        f"fix w all tmsph/wall line -2 0 2 0 friction {MU} velocity v_go 0\n"
        "variable x equal xcm(all,x)")
    scene.thermo("step time v_x f_w[1]", 10)
    scene.steps(0.2).add(f"unfix drag\nvariable go equal {speed}\n"
                            f"velocity all set {speed} 0 0 sum yes")
    normal = scene.mass * GRAVITY
    omega, stuck = (spring / scene.mass) ** 0.5, MU * normal / (spring * speed)
    run = scene.steps(stuck + np.pi / omega).run()
    t, x = run.thermo("Time"), run.thermo("v_x") - EDGE / 2
    t = t - t[0]
    peak = np.argmax(x)
    amplitude = speed / omega
    report.below("belt: slip amplitude against exact",
                 abs((x[peak] - MU * normal / spring) / amplitude - 1), 0.02)
    # of the swing, the time of the peak is a quarter of a period after sliding begins
    report.below("belt: stick time against exact",
                 abs((t[peak] - 0.5 * np.pi / omega) / stuck - 1), 0.02)


def bowl(report):
    """A small stiff block swings in a circular bowl without friction: a physical pendulum."""
    n, radius, start = 3, 0.1, 0.1
    spacing = 2e-3
    cloud = lattice("square", (n, n), spacing, centre=True)
    reach = radius - 0.5 * spacing          # of the centres of its lower corners
    half = 0.5 * (n - 1) * spacing
    length = (reach**2 - half**2) ** 0.5 - half    # from the centre of the bowl to its own
    inertia = (np.square(cloud.X).sum(axis=1)).mean()
    c, s = np.cos(start), np.sin(start)
    cloud.X = (cloud.X - [0, length]) @ np.array([[c, s], [-s, c]])
    scene = Blocks(cloud).add(f"timestep {0.4 * spacing / WAVE:.6g}\n"
                              f"fix w all tmsph/wall arc 0 0 {radius} 180 360\n"
                              "variable x equal xcm(all,x)")
    scene.thermo("step time v_x", 20)
    period = 2 * np.pi * ((length**2 + inertia) / (GRAVITY * length)) ** 0.5 * (1 + start**2 / 16)
    run = scene.add(f"run {int(2.2 * period / (0.4 * spacing / WAVE))}").run()
    t, x = run.thermo("Time"), run.thermo("v_x")
    down = np.nonzero((x[1:] < 0) != (x[:-1] < 0))[0]
    zero = t[down] - x[down] * (t[down + 1] - t[down]) / (x[down + 1] - x[down])
    report.below("bowl: period against exact", abs((zero[2] - zero[0]) / period - 1), 2e-3)


def drop(report):
    for law in ("implicit", "implicit stiffness 1000"):
        cloud = square()
        cloud.X[:, 1] += 0.01
        scene = Blocks(cloud, viscosity=0.0).add(
            f"fix w all tmsph/wall line -2 0 2 0 friction {MU} law {law}\n"
            "fix_modify g energy no\nvariable high equal xcm(all,y)\n"
            f"variable total equal pe+ke+f_w+{scene_mass(cloud) * GRAVITY}*v_high")
        scene.thermo("step time pe ke v_total v_high f_w[9]", 10)
        run = scene.steps(0.25).run()
        energy = run.thermo("v_total")
        fall = scene_mass(cloud) * GRAVITY * 0.01
        report.below(f"drop, law {law}: energy above the start, of that of the fall",
                     (energy.max() - energy[0]) / fall, 1e-3)
        report.note(f"drop, law {law}: energy lost by the first bounce",
                    f"{1 - (energy[-1] - energy[0] + fall) / fall:.3f}")
        high = run.thermo("v_high")
        report.above(f"drop, law {law}: bounces to, of the fall",
                     (high[np.argmin(high):].max() - EDGE / 2) / 0.01, 0.2)


def scene_mass(cloud):
    return ROCK["density"] * cloud.volume.sum()


def loaded(report):
    """A plate presses with a given force: the shortening of the block is that of the law."""
    force = 8000.0
    scene = Blocks(square(), gravity=False).drag().add(
        "fix below all tmsph/wall line -2 0 2 0\n"
        f"fix top all tmsph/wall line 2 {EDGE} -2 {EDGE} load NULL -{force} mass 1.0")
    scene.thermo("step time f_below[2] f_top[2] f_top[11] f_top[10]", 1000)
    run = scene.steps(1.0).run()
    report.below("loaded plate: force on the floor against the load",
                 abs(run.thermo("f_below[2]")[-1] / -force - 1), 1e-6)
    modulus = ROCK["young"] / (1 - ROCK["poisson"] ** 2)
    stretch = 1.0
    for _ in range(50):    # E' W l (1 - l^2)/2 = force
        stretch = 1 - 2 * force / (modulus * EDGE) / (stretch * (1 + stretch))
    report.below("loaded plate: its way against exact",
                 abs(-run.thermo("f_top[11]")[-1] / (EDGE * (1 - stretch)) - 1), 0.01)
    report.below("loaded plate: stays in line, m", abs(run.thermo("f_top[10]")[-1]), 1e-15)


def turning_box(report):
    """A closed box turns, and the block that fills it with it: by angle and angular momentum."""
    a = EDGE
    scene = Blocks(square(), gravity=False).add(
        f"variable spin equal 0.5*ternary(time<0.5,time/0.5,1)\n"
        f"fix w all tmsph/wall polyline 5 0 0 {a} 0 {a} {a} 0 {a} 0 0 friction {MU} "
        f"rotation {a / 2} {a / 2} v_spin\nfix_modify w energy yes")
    scene.thermo("step time f_w[13]", 1000)
    run = scene.steps(3.0).snapshot("end", "x y").run()
    angle = run.thermo("f_w[13]")[-1]
    report.below("turning box: its angle against exact", abs(angle / (0.5 * 2.75) - 1), 1e-4)
    x, y = (run.frame("end")("x y") - a / 2).T
    X, Y = (scene.cloud.X - a / 2).T
    turned = np.arctan2((X * y - Y * x).sum(), (X * x + Y * y).sum())
    report.below("turning box: angle of the block against its own", abs(turned - angle), 1e-4)


def bumps(report):
    """A block held between a plate and a wavy floor that is drawn away beneath it."""
    height = 0.02 * EDGE
    points = [(-0.2, 0.0)]
    for k in range(6):
        start = (1 + 0.5 * k) * EDGE
        points += [(start + 0.15 * EDGE, 0.0), (start + 0.4 * EDGE, height),
                   (start + 0.5 * EDGE, height), (start + 0.6 * EDGE, 0.0)]
    points.append((1.0, 0.0))
    flat = " ".join(f"{x:.6g} {y:.6g}" for x, y in points)
    scene = Blocks(square(), gravity=False).add(
        f"variable down equal -0.02*ternary(time<0.1,time/0.1,ternary(time<0.2,2-time/0.1,0))\n"
        f"variable away equal -0.2*ternary(time<0.2,0,ternary(time<0.4,time/0.2-1,1))\n"
        f"fix top all tmsph/wall line 1 {EDGE} -1 {EDGE} velocity 0 v_down\n"
        f"fix left all tmsph/wall line 0 1 0 -1\nfix right all tmsph/wall line {EDGE} -1 {EDGE} 1\n"
        f"fix w all tmsph/wall polyline {len(points)} {flat} friction 0.1 velocity v_away 0")
    scene.thermo("step time f_w[2] f_w[9] f_w[10]", 1)
    run = scene.steps(1.5).snapshot("end", "x y").run()
    normal, t = -run.thermo("f_w[2]"), run.thermo("Time")
    moving = t > 0.2
    jump = np.abs(np.diff(normal))[moving[1:]] / normal[moving].mean()
    report.below("bumpy floor: largest change of force in a step", jump.max(), 0.05)
    x, y = run.frame("end")("x y").T
    floor = np.interp(x - run.thermo("f_w[10]")[-1], *np.array(points).T)
    report.above("bumpy floor: lowest centre above it, spacings", (y - floor).min() / SPACING, 0.25)


def corner(report):
    """A block in a right-angled groove: one bent wall is the same as two straight ones."""
    ends = []
    cloud = square()
    c = 0.5**0.5
    cloud.X = cloud.X @ np.array([[c, c], [-c, c]])
    for walls in (["polyline 3 -1 1 0 0 1 1"], ["line -1 1 0 0", "line 0 0 1 1"]):
        scene = Blocks(cloud).drag()
        for k, wall in enumerate(walls):
            scene.add(f"fix w{k} all tmsph/wall {wall}")
        columns = " ".join(f"f_w{k}[2]" for k in range(len(walls)))
        scene.thermo(f"step {columns}", 1000)
        run = scene.steps(0.3).snapshot("end", "x y").run()
        ends.append(run.frame("end")("x y"))
        weight = -sum(run.thermo(f"f_w{k}[2]")[-1] for k in range(len(walls)))
        report.below(f"groove of {len(walls)} walls: carries the weight",
                     abs(weight / (scene.mass * GRAVITY) - 1), 1e-3)
    report.below("groove: difference of positions, spacings",
                 np.abs(ends[0] - ends[1]).max() / SPACING, 1e-9)


def inclines(report):
    for angle in (10.0, 16.0, 17.5, 30.0):
        incline(report, angle)


if __name__ == "__main__":
    main(inclines, plane, belt, bowl, drop, loaded, turning_box, bumps, corner)
