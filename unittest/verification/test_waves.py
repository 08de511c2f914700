# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Standing plane waves in periodic blocks, longitudinal and transverse. The
frequency must be that of the lattice, which follows from the equations in
closed form, and with refinement approach that of the continuum in second order.
The Wendland kernel is known to be 4.5 % slow at 16 particles per wavelength.
With viscosity the wave's damping, too, must be that of the lattice."""

import numpy as np

from scenes.waves import E, MODULUS, RHO, SPACING, StandingWave
from tmsph_testing import HORIZON, main, order

HOURGLASS, VISCOSITY = 0.1, 0.7
H = 0.5 * HORIZON * SPACING    # Wendland's smoothing length


def wendland_slope(R):
    """-W'/R but for a constant factor: W = (1 - q)^4 (1 + 4 q), q = R/horizon."""
    return (1 - R / (HORIZON * SPACING)) ** 3


def lattice_bonds(d):
    """Vectors to the neighbours, their lengths, and V w with the constant of W."""
    reach = np.arange(-4, 5) * SPACING
    X = np.stack(np.meshgrid(*[reach] * d), axis=-1).reshape(-1, d)
    R = np.linalg.norm(X, axis=1)
    X, R = X[(R > 0) & (R < HORIZON * SPACING)], R[(R > 0) & (R < HORIZON * SPACING)]
    constant = {2: 7 / (4 * np.pi * H**2), 3: 21 / (16 * np.pi * H**3)}[d] * 5 / H**2
    return X, R, wendland_slope(R) * constant * SPACING**d


def lattice_frequency(d, n, polarization):
    """Put u_j = p exp(i k.X) into section 2 of the method: with g = K^-1 sum V w X sin(k.X),
    rho omega^2 = M g^2 + chi [2 sum V w (1 - cos k.X) - g K g]."""
    X, R, w = lattice_bonds(d)
    k = 2 * np.pi / (n * SPACING)
    K = np.sum(w * X[:, 0] ** 2)
    g = np.sum(w * X[:, 0] * np.sin(k * X[:, 0])) / K
    penalty = 2 * np.sum(w * (1 - np.cos(k * X[:, 0]))) - K * g**2
    return ((MODULUS[polarization] * g**2 + HOURGLASS * E * penalty) / RHO) ** 0.5


def lattice_damping(d, n, polarization):
    """beta in u'' = -omega^2 u - beta u', from the linear term of the artificial viscosity."""
    X, R, w = lattice_bonds(d)
    k = 2 * np.pi / (n * SPACING)
    kappa = np.sum(w * R**2) / d
    bond = w * X[:, polarization] ** 2 / (R**2 + 0.01 * H**2) * (1 - np.cos(k * X[:, 0]))
    return VISCOSITY * (MODULUS[0] / RHO) ** 0.5 * H / kappa * np.sum(bond)


def measured(d, n, polarization, viscosity=0.0):
    """Frequency and damping from the amplitude over almost three periods."""
    wave = StandingWave(d, n, polarization, f"hourglass {HOURGLASS} viscosity {viscosity} 0")
    q, dt = wave.q, wave.dt
    # a single mode of velocity Verlet, whose viscosity sees the velocity of half a step before,
    # obeys q_(m+1) - 2 q_m + q_(m-1) = -omega^2 dt^2 q_m - beta dt (q_m - q_(m-1)) exactly
    terms = np.stack([-q[1:-1] * dt**2, -(q[1:-1] - q[:-2]) * dt], axis=1)
    if not viscosity:
        terms = terms[:, :1]
    scale = np.linalg.norm(terms, axis=0)
    solution = np.linalg.lstsq(terms / scale, q[2:] - 2 * q[1:-1] + q[:-2], rcond=None)[0] / scale
    return solution[0] ** 0.5, solution[1:]


def check(report, d, polarization, sizes):
    wave = "longitudinal" if polarization == 0 else "transverse"
    errors = []
    for n in sizes:
        omega = measured(d, n, polarization)[0]
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


def check_damping(report, d, polarization, n):
    what = f"{d}-D {'longitudinal' if polarization == 0 else 'transverse'}, viscous"
    omega, (beta,) = measured(d, n, polarization, VISCOSITY)
    report.note(f"{what}: damping/frequency", f"{beta / omega:.4f}")
    report.below(f"{what}: error of the frequency",
                 abs(omega / lattice_frequency(d, n, polarization) - 1), 1e-6)
    report.below(f"{what}: error of the damping",
                 abs(beta / lattice_damping(d, n, polarization) - 1), 1e-6)


def frequencies(report):
    check(report, 2, 0, (8, 16, 32, 64))
    check(report, 2, 1, (16, 32))
    check(report, 3, 0, (8, 16, 32))
    check(report, 3, 1, (16,))


def damping(report):
    for d, n in ((2, 18), (3, 11)):
        for polarization in (0, 1):
            check_damping(report, d, polarization, n)


if __name__ == "__main__":
    main(frequencies, damping)
