# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Nearly incompressible materials: Poisson's ratio 0.45, 0.49 and 0.499 with
averaged dilatation. Homogeneous finite strain in closed form; a cantilever (Timoshenko);
a disc that spins and one under pressure; a heated disc of two materials (Lame).
Required: stresses within 5 %. tables_of_one and tables_of_two print the figures of
doc/report/incompressible.md for so many materials, without bars."""

import numpy as np

from scenes.disc import Disc
from tmsph_testing import HORIZON, Scene, lattice, main, material

E0, STRAIN = 40e9, 1e-5
SPACING = 1e-3
RATIOS = (0.45, 0.49, 0.499)
BAR, NOISE = 0.05, 0.01


def rock(nu):
    return material(E0, nu)


def lame(nu):
    return E0 * nu / ((1 + nu) * (1 - 2 * nu)), E0 / (2 * (1 + nu))


def rms(values):
    return np.mean(values) ** 0.5


class State:
    """Stresses at equilibrium against the exact ones, in units of the exact root mean square."""

    def __init__(self, cloud, nu, options, prepare, exact, chosen, inner, residual=1e-5):
        scene = Scene(cloud, [rock(nu)], options).thermo("step fnorm")
        scene.add("compute p all tmsph/property/atom sxx syy sxy uy\nrun 0")
        prepare(scene)
        scene.minimize(residual * E0 * STRAIN * SPACING, 60000)
        scene.add("compute dt all tmsph/dt").thermo("step c_dt").add("run 0")
        run = scene.snapshot("d", "c_p[*]").run()
        self.frame = run.frame("d")
        self.steps = int(run.tables[-2]["Step"][-1])
        lam, mu = lame(nu)
        self.dt = run.thermo("c_dt")[-1] / SPACING * ((lam + 2 * mu) / 2700) ** 0.5
        error = self.frame("c_p[1] c_p[2] c_p[3]") - exact
        size = rms(square(exact)[chosen])
        self.error, self.inner = rms(square(error)[chosen]) / size, rms(square(error)[inner]) / size
        # a checkerboard is what differs from the mean of the nearest neighbors
        p = 0.5 * (error[:, 0] + error[:, 1])
        near = np.linalg.norm(cloud.X[:, None] - cloud.X[None], axis=2)
        near = (near < 1.3 * SPACING) & (near > 0)
        self.noise = rms((p - near @ p / near.sum(axis=1))[inner] ** 2) / size

    def __str__(self):
        return (f"L2 {self.error:.4f}, inside {self.inner:.4f}, noise {self.noise:.5f}, "
                f"dt c_p/dx {self.dt:.3f}, {self.steps} iterations")


def square(stress):
    """Of the tensors xx yy xy."""
    return stress[:, 0] ** 2 + stress[:, 1] ** 2 + 2 * stress[:, 2] ** 2


def loads(scene, cloud, force):
    """Dead loads on the particles."""
    for axis, column in zip("xy", force.T):
        scene.files[f"load.{axis}"] = f"\n{len(cloud)}\n" + "".join(
            f"{i + 1} {f:.17g}\n" for i, f in enumerate(column))
        scene.add(f"variable load{axis} atomfile load.{axis}")
    scene.add("variable work atom -v_loadx*x-v_loady*y\n"
              "fix load all addforce v_loadx v_loady 0 energy v_work\nfix_modify load energy yes")


def cantilever(nu, options="", rows=12, jitter=0.0, residual=1e-5):
    """Held at the left in the exact positions of three columns, pulled up at the right; judged one
    height away from the ends."""
    H, L, c = rows * SPACING, 5 * rows * SPACING, 0.5 * rows * SPACING
    cloud = lattice("square", (5 * rows, rows), SPACING).jitter(jitter, 1)
    x, y = cloud.X[:, 0], cloud.X[:, 1] - c
    E, poisson, inertia = E0 / (1 - nu**2), nu / (1 - nu), 2 * c**3 / 3
    P = E0 * STRAIN * inertia / (L * c)
    ux = -P * y / (6 * E * inertia) * ((6 * L - 3 * x) * x + (2 + poisson) * (y**2 - c**2))
    uy = P / (6 * E * inertia) * (3 * poisson * y**2 * (L - x) + (4 + 5 * poisson) * c**2 * x
                                  + (3 * L - x) * x**2)
    exact = np.stack([-P * (L - x) * y / inertia, 0 * x, P / (2 * inertia) * (c**2 - y**2)], axis=1)
    held, end = x < 3 * SPACING, x > L - SPACING
    pull = (c**2 - y**2) * end

    def prepare(scene):
        scene.move(cloud.X + np.stack([ux, uy], axis=1) * held[:, None])
        loads(scene, cloud, np.stack([0 * x, P * pull / pull.sum()], axis=1))
        scene.add(f"region held block INF {3 * SPACING} INF INF INF INF units box\n"
                  "group held region held\nfix held held setforce 0 0 0")

    middle = (x > H) & (x < L - H)
    inner = middle & (np.abs(y) < c - 2 * SPACING)
    state = State(cloud, nu, options, prepare, exact, middle, inner, residual)
    state.tip = state.frame["c_p[4]"][end].mean() / uy[end].mean()
    return state


def surface(cloud):
    """Outward surface vectors of the particles, 2 V_i sum_j V_j grad W_ji; the Wendland kernel."""
    delta = HORIZON * cloud.spacing
    X = cloud.X[:, None] - cloud.X[None]
    q = np.linalg.norm(X, axis=2) / delta
    w = 35 / np.pi / delta**4 * 4 * np.maximum(1 - q, 0) ** 3
    return 2 * cloud.volume[:, None] * np.einsum("ij,ijk->ik", w * cloud.volume[None], X)


def disc(nu, load, options="", radius=20, jitter=0.0):
    """Spinning, or under pressure on its outer particles; the latter is judged inside only."""
    cells = (2 * radius + 4, int(2 * radius / 3**0.5) + 4)
    cloud = lattice("hex", cells, SPACING, centre=True)
    cloud.X += [0.25 * SPACING, 0.25 * 3**0.5 * SPACING]
    cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= radius * SPACING).jitter(jitter, 1)
    r, V = np.linalg.norm(cloud.X, axis=1), cloud.volume
    R, s = (V.sum() / np.pi) ** 0.5, E0 * STRAIN
    e = cloud.X / np.maximum(r, 1e-9)[:, None]
    if load == "spin":
        force = s / R**2 * V[:, None] * cloud.X
        radial = s * (3 - 2 * nu) / (8 * (1 - nu)) * (1 - r**2 / R**2)
        hoop = s / (8 * (1 - nu)) * (3 - 2 * nu - (1 + 2 * nu) * r**2 / R**2)
    else:
        force = -s * surface(cloud)
        force *= 2 * np.pi * R * s / -np.sum(force * e)
        radial = hoop = np.full(len(cloud), -s)
    force -= force.mean(axis=0)
    c, n = e.T
    exact = np.stack([c * c * radial + n * n * hoop, n * n * radial + c * c * hoop,
                      c * n * (radial - hoop)], axis=1)
    exact[r < 1e-9] = [radial[r.argmin()], radial[r.argmin()], 0]    # no direction in the centre
    return State(cloud, nu, options, lambda scene: loads(scene, cloud, force), exact, r > -1,
                 r < R - 4 * SPACING)


def homogeneous(report, name, cells, nu, options, jitter):
    """Stress of a homogeneous finite strain at every particle, at surfaces and cuts too."""
    cloud = lattice(name, cells, SPACING).jitter(jitter, 3)
    d = cloud.dimension
    F = np.eye(d) + 0.05 * np.array([[1, 0.4, 0.2], [-0.6, -0.8, 0.3], [0.1, 0.5, -0.3]])[:d, :d]
    columns = [f"c_p[{k}]" for k in range(1, 7)]
    scene = Scene(cloud, [rock(nu)], options)
    scene.add("compute p all tmsph/property/atom sxx syy szz sxy sxz syz")
    size = np.array(cells) * SPACING
    if d == 2:
        scene.add("tmsph/cut all line " + " ".join(f"{k:.6g}" for k in
                                                    [*(0.31 * size), *(0.62 * size * [1, 0.9])]))
    scene.add("run 0").move(cloud.X @ F.T).add("run 0")
    values = scene.snapshot("d", "c_p[*]").run().frame("d")(" ".join(columns))
    lam, mu = lame(nu)
    strain = 0.5 * (F.T @ F - np.eye(d))
    S = lam * np.trace(strain) * np.eye(d) + 2 * mu * strain
    sigma = F @ S @ F.T / np.linalg.det(F)
    places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)]
    error = max(np.abs(values[:, k] - sigma[a, b]).max()
                for k, (a, b) in enumerate(places) if max(a, b) < d)
    # round-off: positions to 2^-53 of some 20 spacings, strains of 0.05, lambda/sigma
    bar = 1e-12 * lam / np.abs(sigma).max()
    report.below(f"homogeneous, {name} nu {nu} {options}: error", error / np.abs(sigma).max(), bar)


def tables_of_one(_):
    for nu in (0.3, 0.45, 0.49, 0.499, 0.4999):
        for options in ("", "dilatation plain") if nu == 0.45 else ("",):
            state = cantilever(nu, options, 16, residual=1e-6)
            print(f"cantilever {nu} {options}: tip {state.tip:.4f}, {state}", flush=True)
            for load in ("spin", "pressure"):
                print(f"{load} {nu} {options}: {disc(nu, load, options, 25)}", flush=True)
    for zeta in (0.03, 0.1, 0.3, 1.0):
        for nu in (0.3, 0.499):
            print(f"hourglass {zeta}: cantilever {nu}: {cantilever(nu, f'hourglass {zeta}')}\n"
                  f"  spin {nu}: {disc(nu, 'spin', f'hourglass {zeta}')}", flush=True)
    for nu in (0.3, 0.45, 0.49, 0.499):
        options = "hourglass 0.3"
        print(f"jitter 0.2, {options}: cantilever {nu}: {cantilever(nu, options, jitter=0.2)}\n"
              f"  spin {nu}: {disc(nu, 'spin', options, jitter=0.2)}", flush=True)


def tables_of_two(_):
    for spacing in (2e-3, 1e-3):
        for inner, outer in ((0.3, 0.2), (0.3, 0.45), (0.3, 0.49), (0.3, 0.499), (0.45, 0.2),
                             (0.49, 0.2), (0.499, 0.2), (0.45, 0.45), (0.49, 0.49),
                             (0.499, 0.499), (0.499, 0.45), (0.45, 0.499)):
            pair = material(40e9, inner, 2700, 1.5e-5), material(20e9, outer, 2700, 1e-5)
            two = Disc("strain", pair, spacing)
            print(f"two materials {inner} in {outer}, {spacing * 1e3:g} mm: L2 {two.error:.4f}, "
                  f"far {two.far:.4f}, core {two.core:.4f}, ring {two.ring_hoop:.4f}", flush=True)


def strained(report):
    for name, cells in (("square", (18, 14)), ("sc", (7, 6, 5))):
        for nu in RATIOS:
            homogeneous(report, name, cells, nu, "", 0.2)


def one_material(report):
    for nu in RATIOS:
        for what, state in [("cantilever", cantilever(nu)), ("spinning disc", disc(nu, "spin"))]:
            report.below(f"{what}, nu {nu}: L2 error", state.error, BAR)
            report.below(f"{what}, nu {nu}: pressure against neighbors", state.noise, NOISE)
        state = disc(nu, "pressure")
        report.below(f"disc under pressure, nu {nu}: L2 error inside", state.inner, BAR)
        report.below(f"disc under pressure, nu {nu}: pressure against neighbors", state.noise,
                     NOISE)


def two_materials(report):
    pair = material(40e9, 0.49, 2700, 1.5e-5), material(20e9, 0.49, 2700, 1e-5)
    two = Disc("strain", pair, 1.5e-3, residual=1e-4)
    report.below("two materials, nu 0.49 both: L2 error", two.error, BAR)
    report.within("two materials, nu 0.49 both: core pressure/p", two.core, 1 - BAR, 1 + BAR)


if __name__ == "__main__":
    main(strained, one_material, two_materials, more=(tables_of_one, tables_of_two))
