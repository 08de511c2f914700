# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The same scenes at all sizes and in all systems of units."""

import numpy as np

from bodies import E, RHO, ROCK, blocks, stresses, wave_speed
from cases import Found, case, marching
from tmsph_testing import Scene, lattice, material

# metre, kilogram and second in the units of LAMMPS
SYSTEMS = {"si": (1.0, 1.0, 1.0), "cgs": (1e2, 1e3, 1.0), "micro": (1e6, 1e15, 1e6),
           "nano": (1e9, 1e21, 1e9), "lj": (1 / 0.37, 1 / 2.9, 1 / 7e-7)}
SIZES = (1e-6, 1e-4, 1e-3, 1e-2, 1.0, 1e3)
SPEED = wave_speed(ROCK)
# Positions and strains are double, the weights of bonds are rounded to single precision, 6e-8, and
# otherwise in other units: ten times that, and another ten for what grows over some hundred steps
TOLERANCE = 1e-5
SAME = "as in si with 1 mm: {} of the largest value to 1e-5"


class Measures:
    """Numbers of a scene with a particle spacing of so many metres in a system of units."""

    def __init__(self, system, size):
        self.system, self.size = system, size
        self.metre, self.kilogram, self.second = SYSTEMS[system]
        self.spacing, self.speed = size * self.metre, SPEED * self.metre / self.second
        self.dt = 0.3 * self.spacing / self.speed
        self.pascal = self.kilogram / self.metre / self.second**2
        self.density = RHO * self.kilogram / self.metre**3
        self.young = E * self.pascal

    def material(self):
        return material(self.young, 0.3, self.density, 1e-5)

    def scene(self, cloud, pair="", materials=1, temperature=0.0):
        scene = Scene(cloud, [self.material()] * materials, pair, temperature)
        scene.lines = [line.replace("units si", f"units {self.system}") for line in scene.lines]
        # the box keeps its edges off particles in units of the system
        return scene.add(f"neighbor {0.3 * self.spacing:.17g} bin").thermo("step pe", 1)

    def conduction(self, steps, fourier):
        """Conductivity and heat capacity of granite, in so many steps to that Fourier number of
        ten spacings."""
        k = 2.9 * self.kilogram * self.metre / self.second**3
        c = 850 * (self.metre / self.second) ** 2
        time = fourier * (10 * self.spacing) ** 2 * self.density * c / k
        return (f"fix heat all tmsph/heat conductivity * {k:.17g} specific/heat * {c:.17g} "
                f"time/scale {time / steps / self.dt:.17g}")


def everywhere(bench, build, steps, fields):
    """Runs build(measures, dimension) at all sizes in si and in all systems at 1 mm. The largest
    differences from si at 1 mm, by field, over the largest value; None where a run fails."""
    worst = {}
    for d in (2, 3):
        first = None
        for system, size in [("si", 1e-3)] + [("si", s) for s in SIZES if s != 1e-3] + [
                (s, 1e-3) for s in SYSTEMS if s != "si"]:
            m = Measures(system, size)
            run = bench.run(build(m, d), f"{d}-D, {system}, {size:g} m", marching(m.dt, steps),
                            every=steps)
            if not run.ok:
                return None
            frame = run.run.frame("final")
            values = {"displacements": frame("x y z")[:, :d] / m.spacing,
                      "stresses": stresses(frame, d) / m.young,
                      "temperatures": frame["c_watch[7]"], "damage": frame["c_watch[8]"]}
            if first is None:
                first = values
                start = run.run.dumps["watch"][0]("x y z")[:, :d] / m.spacing
                scale = {name: np.abs(v).max() for name, v in first.items()}
                scale["displacements"] = np.abs(first["displacements"] - start).max()
            off = {name: np.abs(values[name] - first[name]).max() / (scale[name] or 1.0)
                   for name in fields}
            run.measured(max(off.values()))
            worst = {name: max(off[name], worst.get(name, 0.0)) for name in fields}
    return worst


def told(worst):
    return ", ".join(f"{name} {value:.0e}" for name, value in worst.items()) if worst else "failed"


def boxes(m, d):
    return lattice("square" if d == 2 else "sc", (12, 10, 5)[:d] if d == 2 else (7, 6, 5),
                   m.spacing, centre=True)


WHERE = "spacing 1e-6 to 1e3 m in si; cgs, micro, nano and lj at 1 mm; "


@case("units, elastic", WHERE + "a block with random velocities, viscosity 1 2, 200 steps",
      SAME.format("displacements and stresses"), level="test")
def elastic(bench):
    def build(m, d):
        cloud = boxes(m, d)
        v = 1e-3 * m.speed * np.random.default_rng(1).uniform(-1, 1, cloud.X.shape)
        return m.scene(cloud, "viscosity 1 2").set("vx vy vz"[: 3 * d - 1], v)

    worst = everywhere(bench, build, 200, ("displacements", "stresses"))
    return Found(told(worst), "not reached", bool(worst) and max(worst.values()) < TOLERANCE)


@case("units, heat",
      WHERE + "a block with a surface at 100 degrees that expands, 100 steps",
      SAME.format("temperatures, displacements, stresses"))
def heat(bench):
    def build(m, d):
        scene = m.scene(boxes(m, d), "viscosity 1 2").add(m.conduction(100, 0.05))
        return scene.add("fix out all tmsph/heat/boundary temperature 100")

    worst = everywhere(bench, build, 100, ("temperatures", "displacements", "stresses"))
    return Found(told(worst), "not reached", bool(worst) and max(worst.values()) < TOLERANCE)


@case("units, fracture",
      WHERE + "a block torn apart at 0.001 of the wave speed, Weibull modulus 10, hourglass 0.5, "
      "viscosity 1 2, 150 steps",
      "the same bonds are broken: damage alike to 1e-12", level="test")
def fracture(bench):
    def build(m, d):
        cloud = boxes(m, d)
        v = 1e-3 * m.speed * cloud.X / np.abs(cloud.X).max()
        scene = m.scene(cloud, "hourglass 0.5 viscosity 1 2").set("vx vy vz"[: 3 * d - 1], v)
        return scene.add(f"fix rock all tmsph/hoekbrown strength * {2e8 * m.pascal:.17g} mi * 8 "
                         "weibull * 10 4711")

    worst = everywhere(bench, build, 150, ("damage",))
    counts = [run.run.frame("final")["c_watch[8]"].mean() for run in bench.runs if run.ok]
    return Found(f"{told(worst)}; mean damage {min(counts):.2f} to {max(counts):.2f}",
                 "not reached", bool(worst) and worst["damage"] < 1e-12 and min(counts) > 0)


@case("units, contact",
      WHERE + "a block hits another and both a wall, with friction 0.5, at 0.005 of the wave "
      "speed, 200 steps",
      SAME.format("displacements"))
def contact(bench):
    def build(m, d):
        cloud = boxes(m, d)
        cloud.type = np.where(cloud.X[:, 0] < 0.1 * m.spacing, 1, 2)
        cloud.X[:, 1] += 0.53 * m.spacing - cloud.X[:, 1].min()
        v = np.zeros_like(cloud.X)
        v[:, 0] = 2.5e-3 * m.speed * np.where(cloud.type == 1, 1, -1)
        v[:, 1] = -2.5e-3 * m.speed
        scene = m.scene(cloud, "viscosity 1 2", 2).add("pair_coeff 1 2 none")
        scene.set("vx vy vz"[: 3 * d - 1], v).add("fix touch all tmsph/contact friction * * 0.5")
        far = 1e3 * m.spacing
        shape = f"line {-far:.9g} 0 {far:.9g} 0" if d == 2 else "plane 0 0 0 0 1 0"
        return scene.add(f"fix wall all tmsph/wall {shape} friction 0.5")

    worst = everywhere(bench, build, 200, ("displacements",))
    return Found(told(worst), "not reached", bool(worst) and max(worst.values()) < TOLERANCE)


@case("units without a coherent pressure", "units metal, real, electron",
      "refused, with those that are right", level="test")
def incoherent(bench):
    good = True
    for system in ("metal", "real", "electron"):
        for cloud in blocks(small=True).values():
            scene = Scene(cloud, [ROCK])
            scene.lines = [line.replace("units si", f"units {system}") for line in scene.lines]
            run = bench.run(scene, f"{cloud.dimension}-D, {system}", "run 0")
            good &= run.end == "stopped" and "units" in run.message
    return Found("refused", "refused: there bar times area is no force", good)
