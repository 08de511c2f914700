# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A crack that turns and its cohesive zone by displacement discontinuities (Crouch, Starfield, Boundary
Element Methods in Solid Mechanics, London 1983): what runs of lmp with inclined cracks are compared with. Plane
elasticity in complex numbers, x + i y; elements of a constant jump, which is a pair of edge dislocations at their
ends, by the potentials of Muskhelishvili. Body, crack and load are the same after half a turn about the origin:
one end of the crack is enough. Elements of a crack are of one size: constant jumps do not converge where sizes
change."""

import numpy as np


class Elements:
    """Straight ones between the points of an open line. The jump is what the left side moves by more than the
    right one."""

    def __init__(self, points):
        points = np.asarray(points)
        self.start, self.end = points[:-1], points[1:]
        self.middle = 0.5 * (self.start + self.end)
        self.size = abs(self.end - self.start)
        self.along = (self.end - self.start) / self.size

    def __len__(self):
        return len(self.start)


def traction(mean, deviator, normal):
    return mean * normal - (deviator * normal).conj()


def rows(values):
    """Real parts, below them imaginary ones."""
    return np.concatenate([values.real, values.imag])


class Plane:
    """Elastic, in plane stress."""

    def __init__(self, young, poisson):
        self.shear = young / (2 * (1 + poisson))
        self.kappa = (3 - poisson) / (1 + poisson)

    def _fields(self, z, elements, jump):
        """Displacement, (sxx + syy)/2 and (syy - sxx)/2 + i sxy at points z (rows) by elements (columns)."""
        z, sums = z[:, None], (0.0, 0.0, 0.0)
        for half in (1, -1):    # the second by symmetry, with jumps turned
            A = 1j * half * jump * self.shear / (np.pi * (self.kappa + 1))
            start, end = half * elements.start, half * elements.end
            p, q = 1 / (z - start), 1 / (z - end)
            log = np.log(abs(q / p)) + 1j * np.angle(q / p)    # its cut is the element
            phi, more = A * (p - q), -A * (p**2 - q**2)        # phi', phi''
            psi = A.conj() * log - A * (start.conj() * p - end.conj() * q)
            u = (self.kappa * A * log - z * phi.conj() - psi.conj()) / (2 * self.shear)
            deviator = z.conj() * more + A.conj() * (p - q) + A * (start.conj() * p**2 - end.conj() * q**2)
            sums = tuple(a + b for a, b in zip(sums, (u, 2 * phi.real, deviator)))
        return sums

    def influence(self, z, normal, elements):
        """Displacement and traction on planes of these normals at z (rows) by jumps along each element, then normal
        to it (columns)."""
        parts = [self._fields(z, elements, jump * elements.along) for jump in (1.0, 1j)]
        return (np.hstack([part[0] for part in parts]),
                np.hstack([traction(part[1], part[2], normal[:, None]) for part in parts]))

    def tractions(self, crack, elements):
        """On elements of the crack: along them, then normal."""
        return rows(self.influence(crack.middle, 1j * crack.along, elements)[1] / crack.along[:, None])


class Infinite(Plane):
    """Under stresses sxx, syy, sxy far away."""

    def __init__(self, young, poisson, stress=(0.0, 1.0, 0.0)):
        super().__init__(young, poisson)
        self.mean, self.deviator = 0.5 * (stress[0] + stress[1]), 0.5 * (stress[1] - stress[0]) + 1j * stress[2]

    def system(self, crack):
        """Tractions on the crack are S @ jumps + g, both along elements and then normal, for a load of one."""
        return self.tractions(crack, crack), rows(traction(self.mean, self.deviator, 1j * crack.along) / crack.along)

    @staticmethod
    def stress(jumps):
        """For these jumps by a load of one, far away."""
        return 1.0


class Plate(Plane):
    """Its lower and upper ends are moved apart, without contraction, by a displacement of one each; width and height
    are halves. Elements of about the given size lie along its edges."""

    def __init__(self, young, poisson, width, height, size):
        super().__init__(young, poisson)
        n, m = (2 * int(np.ceil(length / size)) for length in (height, width))
        low, high = width - 1j * height, width + 1j * height
        self.edges = Elements(np.append(np.linspace(low, high, n, endpoint=False), np.linspace(high, -low, m + 1)))
        self.held = np.arange(n + m) >= n
        self.inner = self.edges.middle + 1e-9j * self.edges.along * self.edges.size
        self.inverse = np.linalg.inv(self._conditions(self.edges))
        self.moved = self.inverse @ rows(np.where(self.held, 1j, 0.0))
        at, weight = np.polynomial.legendre.leggauss(60)
        # from the middle of an element to that of another, where what they do to the sides is smooth
        self.section, self.weight = width * at + 1j * self.inner[int(0.9 * n)].imag, 0.5 * weight

    def _conditions(self, elements):
        """What is prescribed on the edges: displacement or traction."""
        u, t = self.influence(self.inner, -1j * self.edges.along, elements)
        return rows(np.where(self.held[:, None], u, t / self.shear))    # of one size

    def system(self, crack):
        """As of the infinite plane."""
        back = self.inverse @ self._conditions(crack)
        edges = self.tractions(crack, self.edges)
        up = np.full(len(self.section), 1j)
        pull, pull_edges = (self.weight @ self.influence(self.section, up, part)[1].imag
                            for part in (crack, self.edges))
        self.pull = pull - pull_edges @ back, pull_edges @ self.moved
        return self.tractions(crack, crack) - edges @ back, edges @ self.moved

    def stress(self, jumps):
        """Mean one across the plate for these jumps of the last system by a displacement of one."""
        return self.pull[0] @ jumps + self.pull[1]


def intensities(body, crack):
    """K_I, K_II at the end of a free crack, by its last element, for a load of one. Of equal elements the last
    opens by sqrt(pi/2) times the exact value in its middle."""
    S, g = body.system(crack)
    jumps = np.linalg.solve(S, -g)
    factor = 2 * np.sqrt(2 / crack.size[-1]) * body.shear / (body.kappa + 1)
    return factor * jumps[-1], factor * jumps[len(crack) - 1]


def tangential(one, two):
    """Direction of the largest tangential stress for K_I, K_II and that stress times sqrt(2 pi r) (Erdogan, Sih,
    J. Basic Eng. 85 (1963) 519)."""
    angle = -2 * np.arctan2(2 * two, one + np.sqrt(one**2 + 8 * two**2))
    return angle, np.cos(angle / 2) ** 2 * (one * np.cos(angle / 2) - 3 * two * np.sin(angle / 2))


def notch(tip, size):
    """Points from the origin to the tip, in steps of at most this size."""
    return tip * np.linspace(0, 1, 1 + int(np.ceil(abs(tip) / size - 1e-9)))


def path(body, tip, size, length, elements=2):
    """Points of a crack from the origin to the tip, and of its way from there by the maximum tangential stress, in
    steps of so many elements."""
    points, direction = notch(tip, size), tip / abs(tip)
    for _ in range(int(np.ceil(length / (elements * size) - 1e-9))):
        angle, _ = tangential(*intensities(body, Elements(points)))
        direction = direction * np.exp(1j * angle)
        points = np.append(points, points[-1] + direction * size * np.arange(1, elements + 1))
    return points


def cohesive(body, crack, free, strength, energy, slip=False):
    """Equilibria of a crack whose first elements are free and whose others begin to open one by one, where they
    carry the strength, with a traction that falls in proportion to the opening.
    @param slip  whether faces slide freely as soon as they open; else when they are free
    @return load and mean stress of each"""
    S, g = body.system(crack)
    n, most, open_ones, states = len(crack), 2 * energy / strength, np.arange(len(crack)), []
    for last in range(free, n):
        while True:
            soft = (open_ones >= free) & (open_ones <= last)
            sliding = open_ones <= last if slip else open_ones < free
            equations = np.concatenate([sliding, open_ones <= last])
            unknown = np.concatenate([sliding, open_ones < last])    # the last one is about to open
            law = np.concatenate([np.zeros(n), np.where(soft, strength, 0.0)])
            A = np.column_stack([(S + np.diag(law / most))[np.ix_(equations, unknown)], g[equations]])
            jumps = np.zeros(2 * n + 1)
            jumps[np.append(unknown, True)] = np.linalg.solve(A, law[equations])
            gone = np.sum(jumps[n + free:2 * n] >= most)
            if not gone:
                break
            free += gone
        states.append((jumps[-1], jumps[-1] * body.stress(jumps[:-1] / jumps[-1])))
    return np.array(states).T
