# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Waves of temperature in a periodic lattice are eigenvectors of the discrete operator. Each
decays at its rate, known from the kernel: the checkerboard too, which never grows. With explicit
steps by 1 - z a step, with RKL2 by its stability polynomial. And the long waves of an orthotropic
solid with turned axes, in 2-D and 3-D, decay at the rate of the differential equation.
An irregular cloud conducts like a lattice, and linear fields are steady in it.
With "all": a finer lattice in 3-D, for the report."""

import numpy as np

from heat_scenes import UNIFORM, Heated, rms, weight
from tmsph_testing import HORIZON, LATTICES, lattice, main, order, thorough

rng = np.random.default_rng(7)


def periodic(name, n):
    cells = (n,) * len(LATTICES[name][0])
    if name == "hex":
        cells = (n, n // 2)    # nearly as long as wide
    return lattice(name, cells, 1.0 / n, periodic="xyz"[: len(cells)])


def wave(cloud, numbers):
    """A cosine with so many periods along each edge of the box, and its wave vector."""
    q = 2 * np.pi * np.array(numbers) / (cloud.box[1] - cloud.box[0])
    return np.cos((cloud.X - cloud.X[0]) @ q), q


def discrete_rate(cloud, q):
    """sum_j G_0j (1 - cos q.X_j)/(rho c V) for k = rho = c = 1."""
    D, h = cloud.dimension, HORIZON * cloud.spacing
    L = cloud.box[1] - cloud.box[0]
    X = cloud.X - cloud.X[0]
    X -= np.round(X / L) * L
    R = np.linalg.norm(X, axis=1)
    X, R = X[(R > 0) & (R < h)], R[(R > 0) & (R < h)]
    w = weight(R, h, D)
    return 2 * D / np.sum(w * R**2) * np.sum(w * (1 - np.cos(X @ q)))


def amplitude(T, mode):
    return T @ mode / (mode @ mode)


def rkl2(ratio, z):
    """Stability polynomial of the step that is so many stable steps long."""
    s = max(3, int(np.ceil(0.5 * (np.sqrt(9 + 16 * ratio) - 1))))
    s += s % 2 == 0
    b = (s * (s + 1) - 2) / (2 * s * (s + 1))
    x = 1 - z / (0.25 * (s * (s + 1) - 2))
    return 1 - b + b * np.polynomial.legendre.legval(x, [0] * s + [1])


def checkerboards(report, name, numbers, n=12):
    cloud = periodic(name, n)
    mode, q = wave(cloud, numbers)
    what = f"{name}, {numbers} waves"
    for method in ("explicit", "rkl2"):
        head = Heated(cloud, f"{UNIFORM} subcycle {method}", start=mode)
        stable = head.steps(1e-9, 1, "step f_heat[6]").run().thermo("f_heat[6]")[-1]
        ratio, steps = (0.9, 5) if method == "explicit" else (20.0, 2)
        z = discrete_rate(cloud, q) * ratio * stable
        factor = 1 - z if method == "explicit" else rkl2(ratio, z)
        T = Heated(cloud, f"{UNIFORM} subcycle {method}", start=mode).run_to(
            steps * ratio * stable, steps)
        # weights and conductances are single precision: 2^-24 each, and z is of the order of 1
        error = amplitude(T, mode) - factor**steps
        report.below(f"{what}, {method}: amplitude after {steps} steps, difference to "
                     f"{factor**steps:.6f}", abs(error), 2e-6 * max(1.0, z / ratio * steps))
        report.below(f"{what}, {method}: rest, of other shape",
                     np.abs(T - amplitude(T, mode) * mode).max(), 1e-6)
    return mode


def never_grows(report, name, numbers, n=12):
    """On every one of 50 steps of several lengths."""
    cloud = periodic(name, n)
    mode, _ = wave(cloud, numbers)
    for method, length in (("explicit", 0.9), ("rkl2", 0.3), ("rkl2", 5.0), ("rkl2", 1000.0)):
        scene = Heated(cloud, f"{UNIFORM} subcycle {method}", start=mode)
        scene.add("compute hi all reduce maxabs c_T")
        stable = 1.0 / (2 * discrete_rate(cloud, wave(cloud, (n // 2,) * cloud.dimension)[1]))
        sizes = scene.steps(50 * length * stable, 50, "step c_hi", 1).run().thermo("c_hi")
        report.true(f"{name}, {method}, steps of {length:g}: never grows",
                    np.all(np.diff(sizes) <= 0), f"{sizes[0]:.3g} to {sizes[-1]:.3g}")


def orthotropic(report, name, n):
    """A superposition of long waves; each keeps its own rate q.K.q. Error of the temperatures, and
    largest error of a rate, relative."""
    cloud = periodic(name, n)
    D = cloud.dimension
    if D == 2:
        k, words = (4.0, 0.5), "orthotropic 4.0 0.5 27"
        c, s = np.cos(np.radians(27)), np.sin(np.radians(27))
        Q = np.array([[c, -s], [s, c]])
        numbers = [(1, 0), (0, 1), (1, 1), (1, -1)]
    else:
        k, words = (3.0, 1.0, 0.5), "orthotropic 3.0 1.0 0.5 1 2 -1 40"
        axis, angle = np.array([1, 2, -1]) / np.sqrt(6), np.radians(40)
        cross = np.array([[0, -axis[2], axis[1]], [axis[2], 0, -axis[0]], [-axis[1], axis[0], 0]])
        Q = np.eye(3) + np.sin(angle) * cross + (1 - np.cos(angle)) * cross @ cross
        numbers = [(1, 0, 0), (0, 1, 0), (0, 0, 1), (1, 1, 0), (1, 0, -1), (0, 1, -1)]
    K = Q @ np.diag(k) @ Q.T
    modes = [wave(cloud, m) for m in numbers]
    time = 1.0 / np.mean([q @ K @ q for _, q in modes])
    T = Heated(cloud, f"conductivity * {words} specific/heat * 1",
               start=sum(mode for mode, _ in modes)).run_to(time, 60)
    rates = [np.log(amplitude(T, mode)) / (-q @ K @ q * time) - 1 for mode, q in modes]
    report.note(f"orthotropic, {name}, {n}: errors of the rates of the waves {numbers}",
                np.round(rates, 5))
    exact = sum(mode * np.exp(-q @ K @ q * time) for mode, q in modes)
    return rms(T - exact) / rms(exact), np.abs(rates).max()


def disordered(report, n=40, jitter=0.2):
    """A long wave in an irregular cloud decays as on the lattice. With the conductances of the
    kernel as they are it would conduct 0.8 % less; what is left is the chance of a small sample."""
    cloud = periodic("square", n)
    _, q = wave(cloud, (1, 0))
    rate = discrete_rate(cloud, q)
    cloud.jitter(jitter, 1)
    mode = np.cos(cloud.X @ q)
    T = Heated(cloud, UNIFORM, start=mode).run_to(0.5 / rate, 20)
    report.below(f"jittered by {jitter}: error of the rate",
                 abs(-np.log(amplitude(T, mode)) / 0.5 - 1), 0.003)


def linear(report, name, n, jitter):
    """A linear field in an irregular cloud that is held where it does not go on across the periodic
    boundary stays as it is: conjugate gradients leave 1e-6 of the unevenness, which is of the order
    of the slope times the spacing. With the conductances of the kernel as they are it changes by 13
    to 30 % of what it changes over a spacing."""
    cloud = periodic(name, n).jitter(jitter, 3)
    x = cloud.X[:, 0]
    scene = Heated(cloud, UNIFORM, start=x, conditions=(
        f"region inside block 0.2 0.8 INF INF INF INF\ngroup inside region inside\n"
        "group held subtract all inside\nvariable x atom x\n"
        "fix b held tmsph/heat/boundary temperature v_x place body"))
    T = scene.run_to(0.5, 20)
    inside = (x > 0.2) & (x < 0.8)
    report.below(f"jittered by {jitter}, {name}: change of a linear field/change over a spacing",
                 np.abs(T - x)[inside].max() / cloud.spacing, 1e-4)


def linear_fields(report):
    linear(report, "square", 20, 0.3)
    linear(report, "hex", 20, 0.3)
    linear(report, "sc", 15, 0.2)


def decay(report):
    checkerboards(report, "square", (6, 6))
    checkerboards(report, "square", (6, 0))
    checkerboards(report, "square", (1, 2))
    checkerboards(report, "hex", (6, 3))
    checkerboards(report, "sc", (4, 4, 4), 8)
    checkerboards(report, "sc", (4, 1, 0), 8)


def growth(report):
    never_grows(report, "square", (6, 6))
    never_grows(report, "sc", (4, 4, 4), 8)


def orthotropic_decay(report):
    sizes = {"square": (20, 40), "hex": (20, 40),
             "sc": (20, 40) if thorough() else (20, 28)}
    for name, (coarse, fine) in sizes.items():
        errors = [orthotropic(report, name, n) for n in (coarse, fine)]
        report.below(f"orthotropic, {name}: error at {fine}", errors[1][0], 0.01 * (40 / fine) ** 2)
        report.above(f"orthotropic, {name}: order",
                     order([rate for _, rate in errors], fine / coarse)[0], 1.9)


if __name__ == "__main__":
    main(disordered, linear_fields, decay, growth, orthotropic_decay)
