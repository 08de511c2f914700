# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A straight crack with a cohesive zone by finite elements: what runs of lmp with bonds that open are
compared with. Half of a body that is symmetric about the line of the crack, bilinear elements in rows
along that line, condensed to it row by row. Nodes on it are closed until they carry the strength
(Hillerborg, Modeer, Petersson, Cem. Concr. Res. 6 (1976) 773). Laws are straight lines, so that the
equilibria are too, from one node that begins to open or reaches a kink of its law to the next: these are
followed one by one, wherever load and displacement go (snap-back)."""

import numpy as np

# Corners of a law of straight lines: openings over G/strength, tractions over the strength

LINEAR = ((0.0, 1.0), (2.0, 0.0))


def elasticity(young, poisson, plane):
    if plane == "strain":
        young, poisson = young / (1 - poisson**2), poisson / (1 - poisson)
    return young / (1 - poisson**2) * np.array(
        [[1, poisson, 0], [poisson, 1, 0], [0, 0, 0.5 * (1 - poisson)]])


def element(width, height, elastic):
    """Stiffness of a rectangle of four nodes: lower left, lower right, upper left, upper right; u v
    of each."""
    K = np.zeros((8, 8))
    for s in (-(3**-0.5), 3**-0.5):
        for t in (-(3**-0.5), 3**-0.5):
            dx = np.array([-(1 - t), 1 - t, -(1 + t), 1 + t]) / (2 * width)
            dy = np.array([-(1 - s), -(1 + s), 1 - s, 1 + s]) / (2 * height)
            B = np.zeros((3, 8))
            B[0, ::2], B[1, 1::2], B[2, ::2], B[2, 1::2] = dx, dy, dy, dx
            K += 0.25 * width * height * B.T @ elastic @ B
    return K


def graded(start, fine, h, ends, growth=1.15):
    """Coordinates from ends[0] to ends[1]: steps of h within fine, growing outside; start is one of
    them."""
    n = [int(np.ceil(abs(edge - start) / h - 1e-9)) for edge in fine]
    inner = start + h * np.arange(-n[0], n[1] + 1)
    inner = inner[(inner > ends[0] - 1e-9 * h) & (inner < ends[1] + 1e-9 * h)]

    def outwards(first, end):
        length, steps = abs(end - first), []
        while sum(steps) < length - 1e-9 * h:
            steps.append(h * growth ** (len(steps) + 1))
        steps = np.array(steps) * (length / sum(steps) if steps else 1)
        return first + np.sign(end - first) * np.cumsum(steps)

    return np.concatenate([outwards(inner[0], ends[0])[::-1], inner, outwards(inner[-1], ends[1])])


class Ligament:
    """The energy of the body by the displacement v of the nodes along the line of the crack, normal to
    it, and by the displacement U of what drives it: v S v/2 + U g v + c U^2/2."""

    def __init__(self, x, y, elastic, held, driven):
        """x: coordinates along the line, y: from 0, the line, upwards. held, driven: arrays of
        (rows, columns, 2) of the components that are prescribed, and of their displacement for U = 1;
        the normal component on the line is not to be held."""
        n = len(x)
        self.x = x
        A, b, c = np.zeros((2 * n, 2 * n)), np.zeros(2 * n), 0.0
        for row in range(len(y) - 1, 0, -1):
            K = self._row(np.diff(x), y[row] - y[row - 1], elastic)
            A, b, c = self._without(K[2 * n:, 2 * n:] + A, K[2 * n:, :2 * n], K[:2 * n, :2 * n], b, c,
                                    held[row].ravel(), driven[row].ravel())
        along, normal = np.arange(0, 2 * n, 2), np.arange(1, 2 * n, 2)
        self.S, self.g, self.c = self._without(
            A[np.ix_(along, along)], A[np.ix_(along, normal)], A[np.ix_(normal, normal)], b[along], c,
            held[0, :, 0], driven[0, :, 0], b[normal])

    @staticmethod
    def _row(widths, height, elastic):
        """Stiffness of one row of elements: nodes below, nodes above."""
        n = len(widths) + 1
        K = np.zeros((4 * n, 4 * n))
        for i, width in enumerate(widths):
            dofs = np.concatenate([np.arange(2 * i, 2 * i + 4), np.arange(2 * i, 2 * i + 4) + 2 * n])
            K[np.ix_(dofs, dofs)] += element(width, height, elastic)
        return K

    @staticmethod
    def _without(A, mixed, rest, b, c, held, driven, b_rest=0.0):
        """Minimum over the first part of the unknowns, of which some are prescribed."""
        p, f = np.flatnonzero(held), np.flatnonzero(~held)
        d = driven[p]
        r = b[f] + A[np.ix_(f, p)] @ d
        solved = np.linalg.solve(A[np.ix_(f, f)], np.column_stack([mixed[f], r]))
        S = rest - mixed[f].T @ solved[:, :-1]
        g = b_rest + mixed[p].T @ d - mixed[f].T @ solved[:, -1]
        return 0.5 * (S + S.T), g, c + 2 * b[p] @ d + d @ A[np.ix_(p, p)] @ d - r @ solved[:, -1]

    def _weights(self, notch):
        """Half of the segments of the ligament on either side."""
        h = np.diff(self.x) * ~(notch[1:] | notch[:-1])
        return 0.5 * (np.append(h, 0.0) + np.append(0.0, h))

    def crack(self, notch, strength, energy, law=LINEAR, most=None, least=0.1):
        """Equilibria from the first opening on, until so many nodes have begun to open or the load has
        fallen to this part of its peak.
        @param notch  which nodes are free
        @return displacement U, load and openings of all nodes, of each"""
        corners = np.array(law) * [energy / strength, strength]
        slopes = np.append(np.diff(corners[:, 1]) / np.diff(corners[:, 0]), 0.0)
        weight = self._weights(notch)
        weight[notch] = 1.0    # of no traction
        piece = np.where(notch, len(slopes) - 1, -1)    # of the law, -1: closed
        # all closed, the displacement at which the first node carries the strength
        v, U = self._closed(notch)
        pull = -(self.S @ v + U * self.g) / weight
        first = np.where(piece < 0, pull, -np.inf).argmax()
        v, U = v * strength / pull[first], U * strength / pull[first]
        path, moved = [], first
        while True:
            path.append((U, self.g @ v + self.c * U, 2 * v))
            begun = np.sum(piece[~notch] >= 0)
            piece[moved] += 1
            if begun >= (most or len(self.x)) or path[-1][1] < least * max(load for _, load, _ in path):
                return tuple(np.array(column) for column in zip(*path))
            dv, dU = self._direction(piece, moved, weight, slopes)
            pull = -(self.S @ v + U * self.g) / weight
            rate = -(self.S @ dv + dU * self.g) / weight
            with np.errstate(divide="ignore", invalid="ignore"):
                begins = np.where((piece < 0) & (rate > 0), (strength - pull) / rate, np.inf)
                after = np.append(corners[1:, 0], np.inf)[piece]
                passes = np.where((piece >= 0) & (dv > 0), (0.5 * after - v) / dv, np.inf)
            step = np.minimum(begins, passes)
            moved = step.argmin()
            v, U = v + max(0.0, step[moved]) * dv, U + max(0.0, step[moved]) * dU

    def _closed(self, notch):
        v, free = np.zeros(len(self.x)), np.flatnonzero(notch)
        v[free] = np.linalg.solve(self.S[np.ix_(free, free)], -self.g[free])
        return v, 1.0

    def _direction(self, piece, moved, weight, slopes):
        """On from here: node moved opens further."""
        free, n = np.flatnonzero(piece >= 0), len(self.x)
        m = len(free)
        J = np.zeros((m + 1, m + 1))
        J[:m, :m] = self.S[np.ix_(free, free)] + np.diag(2 * (weight * slopes[piece])[free])
        J[:m, m] = self.g[free]
        J[m, :m] = free == moved
        solved = np.linalg.solve(J, np.append(np.zeros(m), 1.0))
        dv = np.zeros(n)
        dv[free] = solved[:m]
        return dv, solved[m]


def centre_cracked(a, width, height, material, strength, energy, plane="stress", h=None, clamped=True,
                   law=LINEAR):
    """A plate with a crack of the length 2 a; width and height are halves. Its ends are moved apart
    without contraction (clamped) or with it.
    @return displacement of an end, mean stress, tip opening"""
    young = material["young"]
    length = young * energy / strength**2
    h = h or length / 30
    x = graded(a, (min(a, 2 * length), 4 * length), h, (0.0, width))
    y = graded(0.0, (0.0, 2 * h), h, (0.0, height))
    held = np.zeros((len(y), len(x), 2), bool)
    driven = np.zeros(held.shape)
    held[:, 0, 0] = True
    held[-1, :, 1], driven[-1, :, 1] = True, 1.0
    held[-1, :, 0] |= clamped
    body = Ligament(x, y, elasticity(young, material["poisson"], plane), held, driven)
    fine = np.sum((x > a - 1e-6 * h) & (x < a + 4 * length))
    notch = x < a - 1e-6 * h
    U, load, opening = body.crack(notch, strength, energy, law, fine)
    return U, load / width, opening[:, ~notch].max(axis=1)


def bent(depth, notch, span, length, press, material, strength, energy, plane="stress", h=None,
         law=LINEAR, least=0.1):
    """A beam with a notch in the middle of its lower face, on rollers in the distance span/2 from it,
    pressed down from above in the distance press/2 from the middle: at one point if that is 0.
    @return displacement of the load, load, coordinates of the nodes along the line of the crack from the
            lower face on and their openings"""
    zone = material["young"] * energy / strength**2
    h = h or zone / 30
    x = graded(notch, (notch - 2 * h, depth), h, (0.0, depth))
    y = [graded(0.0, (0.0, 0.5 * press), h, (0.0, 0.5 * press)),
         graded(0.5 * press, (0.5 * press, 0.5 * press + 2 * h), h, (0.5 * press, 0.5 * span), 1.05),
         graded(0.5 * span, (0.5 * span, 0.5 * span), 4 * h, (0.5 * span, 0.5 * length))]
    pressed, borne = len(y[0]) - 1, len(y[0]) + len(y[1]) - 2
    y = np.concatenate([y[0], y[1][1:], y[2][1:]])
    held = np.zeros((len(y), len(x), 2), bool)
    driven = np.zeros(held.shape)
    held[borne, 0, 0] = held[pressed, -1, 0] = True
    driven[pressed, -1, 0] = -1.0
    body = Ligament(x, y, elasticity(material["young"], material["poisson"], plane), held, driven)
    U, load, opening = body.crack(x < notch - 1e-6 * h, strength, energy, law, least=least)
    return U, 2 * load, x, opening
