# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Standing plane waves in periodic blocks, longitudinal and transverse. The
frequency must be that of the lattice, which follows from the equations in
closed form, and with refinement approach that of the continuum in second order.
The Wendland kernel is known to be 4.5 % slow at 16 particles per wavelength."""

from tmsph_testing import *

SPACING, STRAIN, HOURGLASS = 1e-3, 1e-6, 0.1
ROCK = material()
E, NU, RHO = ROCK["young"], ROCK["poisson"], ROCK["density"]
SHEAR = E / (2 * (1 + NU))
MODULUS = {0: E * (1 - NU) / ((1 + NU) * (1 - 2 * NU)), 1: SHEAR}    # by polarization


def wendland_slope(R):
    """-W'/R but for a constant factor: W = (1 - q)^4 (1 + 4 q), q = R/horizon."""
    return (1 - R / (HORIZON * SPACING)) ** 3


def lattice_frequency(d, n, polarization):
    """Put u_j = p exp(i k.X) into section 2 of the method: with g = K^-1 sum V w X sin(k.X),
    rho omega^2 = M g^2 + chi [2 sum V w (1 - cos k.X) - g K g]."""
    reach = np.arange(-4, 5) * SPACING
    X = np.stack(np.meshgrid(*[reach] * d), axis=-1).reshape(-1, d)
    R = np.linalg.norm(X, axis=1)
    X, R = X[(R > 0) & (R < HORIZON * SPACING)], R[(R > 0) & (R < HORIZON * SPACING)]
    w = wendland_slope(R)
    # the kernel's constant cancels in g, and is that of W in two or three dimensions in chi
    h = 0.5 * HORIZON * SPACING
    w *= {2: 7 / (4 * np.pi * h**2), 3: 21 / (16 * np.pi * h**3)}[d] * 5 / h**2 * SPACING**d
    k = 2 * np.pi / (n * SPACING)
    K = np.sum(w * X[:, 0] ** 2)
    g = np.sum(w * X[:, 0] * np.sin(k * X[:, 0])) / K
    penalty = 2 * np.sum(w * (1 - np.cos(k * X[:, 0]))) - K * g**2
    return ((MODULUS[polarization] * g**2 + HOURGLASS * E * penalty) / RHO) ** 0.5


def measured_frequency(d, n, polarization):
    """From the amplitude over almost three periods."""
    name, cells = ("square", (n, 8)) if d == 2 else ("sc", (n, 7, 7))
    cloud = lattice(name, cells, SPACING, "xyz"[:d])
    k = 2 * np.pi / (n * SPACING)
    speed = (MODULUS[polarization] / RHO) ** 0.5
    velocity = np.zeros_like(cloud.X)
    velocity[:, polarization] = STRAIN * speed * np.sin(k * cloud.X[:, 0])
    dt = 0.25 * SPACING / (MODULUS[0] / RHO) ** 0.5
    steps = int(5.5 * n * SPACING / speed / dt / 2)
    axis = "xy"[polarization]
    scene = Scene(cloud, [ROCK], f"hourglass {HOURGLASS}")
    scene.set("vx vy vz"[: 3 * d - 1], velocity)
    scene.add(f"compute p all tmsph/property/atom u{axis} x0\n"
              f"variable q atom c_p[1]*sin({k:.17g}*c_p[2])\ncompute q all reduce sum v_q\n"
              f"timestep {dt:.17g}\nfix 1 all nve\nthermo_style custom step c_q\nthermo 1\n"
              f"run 0\nrun {steps}")
    q = scene.run().thermo("c_q")
    # a single mode of velocity Verlet obeys q_(m+1) - 2 q_m + q_(m-1) = -omega^2 dt^2 q_m exactly
    curvature = q[2:] - 2 * q[1:-1] + q[:-2]
    return (-np.dot(curvature, q[1:-1]) / np.dot(q[1:-1], q[1:-1])) ** 0.5 / dt


def check(report, d, polarization, sizes):
    wave = "longitudinal" if polarization == 0 else "transverse"
    errors = []
    for n in sizes:
        omega = measured_frequency(d, n, polarization)
        what = f"{d}-D {wave}, {n} particles per wave"
        exact = lattice_frequency(d, n, polarization)
        # strain 1e-6, and weights in single precision
        report.below(f"{what}: error against the lattice", abs(omega / exact - 1), 1e-6)
        speed = omega * n * SPACING / (2 * np.pi)
        errors.append(speed / (MODULUS[polarization] / RHO) ** 0.5 - 1)
        if n == 16 and polarization == 0 and d == 2:
            report.within(f"{what}: error of the speed", errors[-1], -0.05, -0.04)
        else:
            report.note(f"{what}: error of the speed", f"{errors[-1]:.4f}")
    if len(sizes) > 1:
        report.above(f"{d}-D {wave}: order", order(errors)[-1], 1.9)


report = Report()
check(report, 2, 0, (8, 16, 32, 64))
check(report, 2, 1, (16, 32))
check(report, 3, 0, (8, 16, 32))
check(report, 3, 1, (16,))
report.finish()
