# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What plates with an inclined crack (test_inclined_long.py) are compared with, against exact and published solutions:
a crack that grows by the maximum tangential stress, with a cohesive zone on its way, by displacement
discontinuities."""

import numpy as np

from cohesive_zone import centre_cracked
from displacement_discontinuity import Elements, Infinite, Plate, cohesive, intensities, notch, path
from tmsph_testing import main, material

YOUNG, POISSON = 1.0, 0.2    # with strength and energy of one the characteristic length is one

# K_I and K_II of a kink that is short beside the crack by K_I = 1 (first two) and K_II = 1 of the crack: F11, F21, F12,
# F22 of Amestoy, Leblond, Int. J. Solids Struct. 29 (1992) 465

KINKS = {-30: (0.9017, -0.2402, 0.7298, 0.7972), -60: (0.6557, -0.3693, 1.1680, 0.3079)}


def straight(report):
    """K of an inclined straight crack, sigma sqrt(pi a) cos^2 and cos sin."""
    for inclination in (15, 45, 60):
        direction = np.exp(1j * np.radians(inclination))
        found = intensities(Infinite(YOUNG, POISSON), Elements(notch(direction, 0.01)))
        for name, value, exact in zip(("I", "II"), found, (direction.real**2, direction.real * direction.imag)):
            report.within(f"crack inclined by {inclination}: K_{name}/exact", value / (np.sqrt(np.pi) * exact),
                          0.99, 1.01)


def kinks(report):
    """To the limit of small elements and of a short kink. Stresses far away are such that none acts along
    the crack, which lets K grow by the square root of the length."""
    def found(angle, length, count, load):
        size = length / count
        points = np.append(notch(1.0, size), 1 + size * np.exp(1j * angle) * np.arange(1, count + 1))
        body = Infinite(YOUNG, POISSON, (1 - load, 1 - load, load))
        return np.array(intensities(body, Elements(points))) / np.sqrt(np.pi)

    for degrees, known in KINKS.items():
        for load, name in enumerate(("I", "II")):
            long, short = (2 * found(np.radians(degrees), length, 2 * count, load) -
                           found(np.radians(degrees), length, count, load) for length, count in ((0.08, 10), (0.04, 5)))
            for k in (0, 1):
                report.below(f"kink by {degrees}, K_{name} = 1: error of K_{'I' * (k + 1)}",
                             abs(2 * short[k] - long[k] - known[2 * load + k]), 0.015)


def ways(report):
    """The first step is that of the criterion, later ones do not shear, and neither depends on their length."""
    tip = np.exp(1j * np.radians(45))
    body = Infinite(YOUNG, POISSON)
    coarse, fine = (path(body, tip, size, 0.3, 3) for size in (0.01, 0.005))
    first = np.angle((fine[-60:] - tip) / tip, deg=True)[0]
    report.below("first step, degrees off the 53.13 of K_I = K_II", abs(first + 53.13), 0.1)
    chords = [np.angle((points[-1] - tip) / tip, deg=True) for points in (coarse, fine)]
    report.below("chord of the way, change by steps of half the length, degrees", abs(chords[1] - chords[0]), 0.5)
    one, two = intensities(body, Elements(fine))
    report.below("|K_II|/K_I at its end", abs(two / one), 0.03)


def zones(report):
    """Peaks of straight cracks: K_Ic sqrt(a/(a + 0.42 l)) in an infinite plane, and finite elements in a plate."""
    size = 0.1

    def peak(body, a):
        free = len(notch(a, size)) - 1
        crack = Elements(np.append(notch(a, size), a + size * np.arange(1, 20)))
        return cohesive(body, crack, free, 1.0, 1.0)[1].max()

    for a in (2, 5, 10):
        found = peak(Infinite(YOUNG, POISSON), a) * np.sqrt(np.pi * a)
        report.within(f"a/l {a}: K at the peak/K_Ic, of sqrt(a/(a + 0.42 l))", found / np.sqrt(a / (a + 0.42)),
                      0.99, 1.01)
    _, stress, _ = centre_cracked(5, 10, 5, material(YOUNG, POISSON), 1.0, 1.0, h=0.1)
    report.within("plate: peak/finite elements", peak(Plate(YOUNG, POISSON, 10, 5, 0.25), 5) / stress.max(), 0.99, 1.01)


if __name__ == "__main__":
    main(straight, kinks, ways, zones)
