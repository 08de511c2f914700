# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Bodies, closed forms and equilibria that several cases share."""

import numpy as np

from cases import largest, unchecked_step
from tmsph_testing import HORIZON, Scene, Script, lattice, material

SPACING = 1e-3
ROCK = material()
E, RHO = ROCK["young"], ROCK["density"]


def constants(m, dimension, plane="strain"):
    """Lame's constants, lambda for the plane state."""
    young, nu = m["young"], m["poisson"]
    stress = dimension == 2 and plane == "stress"
    lame = young * nu / ((1 - nu**2) if stress else (1 + nu) * (1 - 2 * nu))
    return lame, young / (2 * (1 + nu))


def wave_speed(m):
    """Of longitudinal waves."""
    lame, shear = constants(m, 3)
    return ((lame + 2 * shear) / m["density"]) ** 0.5


def blocks(small=False):
    """A block in 2-D and one in 3-D."""
    flat, solid = ((12, 10), (7, 6, 5)) if small else ((20, 20), (17, 17, 17))
    return {"2-D": lattice("square", flat, SPACING, centre=True),
            "3-D": lattice("sc", solid, SPACING, centre=True)}


def stretched(dimension, *stretches):
    """The gradient of stretches along the axes, 1 along those that are not given."""
    return np.diag((stretches + (1.0,) * dimension)[:dimension])


def sheared(dimension, gamma):
    F = np.eye(dimension)
    F[0, 1] = gamma
    return F


def law_stress(F, m, plane="strain"):
    """Cauchy stress of the St Venant-Kirchhoff law."""
    lame, shear = constants(m, len(F), plane)
    strain = (F.T @ F - np.eye(len(F))) / 2
    S = lame * np.trace(strain) * np.eye(len(F)) + 2 * shear * strain
    return F @ S @ F.T / np.linalg.det(F)


def wave_stability(F, m):
    """The smallest eigenvalue of the acoustic tensor of the St Venant-Kirchhoff law over all
    directions n, Q = (n.S n) I + (lambda + mu) Fn (x) Fn + mu F F^T, over the shear modulus. A
    homogeneous state is stable inside a body as long as it is positive."""
    d = len(F)
    lame, shear = constants(m, d)
    strain = (F.T @ F - np.eye(d)) / 2
    S = lame * np.trace(strain) * np.eye(d) + 2 * shear * strain
    grid = np.linspace(0, np.pi, 61)
    directions = np.array([[np.cos(a), np.sin(a)] for a in grid] if d == 2 else
                          [[np.sin(b) * np.cos(a), np.sin(b) * np.sin(a), np.cos(b)]
                           for a in grid for b in grid])
    Fn = directions @ F.T
    Q = (np.einsum("ni,ij,nj->n", directions, S, directions)[:, None, None] * np.eye(d)
         + (lame + shear) * Fn[:, :, None] * Fn[:, None, :] + shear * F @ F.T)
    return np.linalg.eigvalsh(Q).min() / shear


def stresses(frame, dimension):
    """Tensors of the particles of a frame."""
    s = frame("c_watch[1] c_watch[2] c_watch[3] c_watch[4] c_watch[5] c_watch[6]")
    full = s[:, [0, 3, 4, 3, 1, 5, 4, 5, 2]].reshape(-1, 3, 3)
    return full[:, :dimension, :dimension]


def noise(cloud, amount, seed=3):
    """Displacements of up to so many spacings in each direction."""
    return np.random.default_rng(seed).uniform(-amount, amount, cloud.X.shape) * cloud.spacing


def rim(cloud, thick=3):
    """Particles within so many spacings of the surface of a block."""
    low, high = cloud.X.min(axis=0), cloud.X.max(axis=0)
    depth = np.minimum(cloud.X - low, high - cloud.X).min(axis=1)
    return depth < (thick - 0.5) * cloud.spacing


def ends(cloud, thick=3):
    """Particles within so many spacings of both ends along x."""
    x = cloud.X[:, 0]
    return np.minimum(x - x.min(), x.max() - x) < (thick - 0.5) * cloud.spacing


def equilibrium(bench, value, cloud, materials, positions, held, stress, pair="",
                style="tmsph/lbfgs", horizon=HORIZON, iterations=4000, timeout=60, residual=1e-6,
                temperature=0.0):
    """Minimizes from the given positions, those of the held particles kept, to a residual as a
    part of a stress on the face of a particle."""
    scene = Scene(cloud, materials, pair, horizon=horizon).add("run 0").move(positions)
    if temperature:
        scene.add(f"set group all temperature {temperature}")
    rows = "\n".join(f"{i + 1} 1" for i in np.flatnonzero(held))
    scene.files["held"] = f"\n{held.sum()}\n{rows}\n"
    residual *= stress * cloud.spacing ** (cloud.dimension - 1) * len(cloud) ** 0.5
    options = f"min_style {style}\n"
    if style != "tmsph/lbfgs":
        options += f"min_modify dmax {0.01 * cloud.spacing:.6g}\n"
    hold = ("variable held atomfile held\ngroup held variable held\nfix hold held setforce 0 0 0\n"
            if held.any() else "")
    return bench.run(scene, value, f"{hold}{options}minimize 0 {residual:.6g} {iterations} "
                     f"{3 * iterations}", every=10**6, timeout=timeout)


def moved(ended, positions, cloud):
    """Largest distance of a particle from given positions at the end, in spacings."""
    X = ended.run.frame("final")("x y z"[: 2 * cloud.dimension - 1])
    return np.linalg.norm(X - positions, axis=1).max() / cloud.spacing


def drift(bench, value, cloud, m, F):
    """How far a homogeneous state is from equilibrium: a rim of two horizons, whose forces the
    surface disturbs, is held in it, the rest is shaken by 1e-3 spacings and relaxes. Largest
    distance from the state, in spacings; infinite if lmp stops."""
    X, held = cloud.X @ F.T, rim(cloud, 6)
    shaken = np.where(held[:, None], X, X + noise(cloud, 1e-3))
    run = equilibrium(bench, value, cloud, [m], shaken, held, m["young"] * 1e-3)
    return run.measured(moved(run, X, cloud)) if run.ok else np.inf


def stays(bench, what, cloud, m, gradients):
    """For gradients by a number: the last number, in order, up to which the block returns to the
    homogeneous state, and whether it does wherever the law is stable."""
    good, last, unstable = True, None, False
    for number, F in gradients.items():
        stable = wave_stability(F, m) > 0
        returns = drift(bench, f"{what}, {number}", cloud, m, F) < 1e-4
        good &= returns or not stable
        unstable |= not returns
        if not unstable:
            last = number
    return last, good


def bending(cloud, m, strain, plane="strain"):
    """Pure bending about the z axis: displacements, and sxx, with that strain at the surface."""
    young, nu = m["young"], m["poisson"]
    if cloud.dimension == 2 and plane == "strain":
        young, nu = young / (1 - nu**2), nu / (1 - nu)
    x, y = cloud.X[:, 0], cloud.X[:, 1]
    k = strain / np.abs(y).max()
    u = [-k * x * y, k * (x**2 + nu * y**2) / 2]
    if cloud.dimension == 3:
        z = cloud.X[:, 2]
        u[1] -= k * nu * z**2 / 2
        u.append(k * nu * y * z)
    return np.stack(u, axis=1), -young * k * y


def bending_error(bench, value, cloud, m, pair="", plane="strain", horizon=HORIZON):
    """Of sxx, root mean square over the middle, in units of that of the exact one; infinite if
    there is no equilibrium. The ends are held as they should be."""
    u, exact = bending(cloud, m, 1e-5, plane)
    held = ends(cloud, int(np.ceil(horizon)))
    run = equilibrium(bench, value, cloud, [m], cloud.X + u, held, np.abs(exact).max(), pair,
                      horizon=horizon)
    if not run.ok:
        return np.inf
    middle = np.abs(cloud.X[:, 0]) < np.abs(cloud.X[:, 0]).max() - 2 * np.abs(cloud.X[:, 1]).max()
    s = run.run.frame("final")["c_watch[1]"]
    return run.measured(np.linalg.norm((s - exact)[middle]) / np.linalg.norm(exact[middle]))


def beams(long=True):
    return {"2-D": lattice("square", (48, 12), SPACING, centre=True),
            "3-D": lattice("sc", (24, 8, 8), SPACING, centre=True)}


# ---- time steps ----

def stated_step(bench, value, scene):
    """What compute tmsph/dt reports, of a scene whose bonds have formed."""
    asking = Script("\n".join(scene.lines), scene.files).add("compute dt all tmsph/dt")
    asking.add("thermo_style custom step c_dt\nthermo_modify format float %.17g norm no")
    run = bench.run(asking, value)
    return run.measured(run.run.thermo("c_dt")[-1]) if run.ok else np.nan


def grows(bench, value, scene, cloud, dt, steps=600):
    """Whether noise of 1e-6 spacings grows with the time step dt, or lmp stops."""
    shaken = Scene.move(Copy(scene, cloud), cloud.X + noise(cloud, 1e-6, 9))
    shaken.thermo("step ke", 10)
    going = f"{unchecked_step(dt, SPACING)}fix 1 all nve\nrun {steps}"
    run = bench.run(shaken, value, going, every=steps)
    if not run.ok:
        return True
    energy = run.run.thermo("KinEng")
    quarter = len(energy) // 4
    run.measured(energy[-quarter:].max() / energy[1:quarter].max())
    return run.figure > 1e3


def roomy(scene):
    """Lets the box be larger than its particles: LAMMPS cannot make bins in a flat one."""
    scene.lines = [line.replace("boundary s s s", "boundary m m m")
                   .replace("boundary s s p", "boundary m m p") for line in scene.lines]
    return scene


class Copy(Scene):
    """Of a scene, to go on with."""

    def __init__(self, scene, cloud):
        self.lines, self.files, self.cloud = list(scene.lines), dict(scene.files), cloud


def largest_step(bench, what, scene, cloud):
    """The step that is stated, and the largest stable one over it, to 0.5 percent."""
    stated = stated_step(bench, f"{what}, stated", scene)

    def holds(share):
        return not grows(bench, f"{what}, {share:.4f}", scene, cloud, share * stated)

    return stated, largest(holds, 0.97, 1.1, 0.005)
