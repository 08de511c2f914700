# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The area that heat goes through is that of the body: faces that meet at corners and edges, convex
and re-entrant, thin plates, lattices of several kinds, turned; the power of a flux is q times it. A
field that a flux through two opposite faces of a block holds is linear and steady up to its
corners. A square and a cube that cool by convection all around do so as their closed form, with an
error of second order."""

import numpy as np

from heat_scenes import UNIFORM, Heated, listed, rms, robin
from tmsph_testing import LATTICES, Cloud, lattice, main, order

WITHIN = 0.01
EXACT = 1e-6    # areas are sums of single precision weights
FLUX = 3.0


def block(name, *cells):
    return lattice(name, cells, 1.0 / cells[0])


def turned(cloud):
    """By 37 degrees, in space about a general axis by Rodrigues' formula; and the rotation."""
    angle = np.radians(37.0)
    if cloud.dimension == 2:
        Q = np.array([[np.cos(angle), -np.sin(angle)], [np.sin(angle), np.cos(angle)]])
    else:
        x, y, z = np.array([1.0, 2.0, -0.7]) / np.linalg.norm([1.0, 2.0, -0.7])
        C = np.array([[0, -z, y], [z, 0, -x], [-y, x, 0]])
        Q = np.eye(3) + np.sin(angle) * C + (1 - np.cos(angle)) * C @ C
    return Cloud(cloud.X @ Q.T, cloud.volume[0], cloud.spacing), Q


def faces_of_box(cloud):
    edges = cloud.box[1] - cloud.box[0]
    return 2 * np.sum(np.prod(edges) / edges)


def without(cloud, *boxes):
    """Less what is in boxes of (low, high) corners."""
    def keep(X):
        return ~np.any([np.all((X > low) & (X < high), axis=1) for low, high in boxes], axis=0)
    return cloud.kept(keep)


def plate(name, rows, normal):
    """So many rows, periodic along its faces, and the area of these."""
    edges = np.array(LATTICES[name][0])
    cells = {"square": (10, 10), "hex": (10, 6), "sc": (8, 8, 8), "fcc": (6, 6, 6)}[name]
    along = [k for k in range(len(cells)) if k != normal]
    whole = lattice(name, cells, 1.0, periodic="".join("xyz"[k] for k in along))
    gap = edges[normal] / (1 if name in ("square", "sc") else 2)
    return whole.kept(lambda X: X[:, normal] < rows * gap), 2 * np.prod((edges * cells)[along])


def bodies():
    """Name, cloud, area of its faces, accuracy."""
    for n in (10, 20, 40):
        yield f"square {n}", block("square", n, n), 4.0, EXACT
    yield "rectangle 12 x 5", block("square", 12, 5), 2 + 10 / 12, EXACT
    for n in (10, 20):
        cloud = block("hex", n, n // 2)
        yield f"hexagonal lattice, {n} along the rows", cloud, faces_of_box(cloud), WITHIN
    for n in (6, 12):
        yield f"cube {n}", block("sc", n, n, n), 6.0, WITHIN
    yield "cube 8, fcc", block("fcc", 6, 6, 6), 6 * LATTICES["fcc"][0][0] ** 2, WITHIN
    yield "box 12 x 8 x 2", block("sc", 12, 8, 2), 2 * (96 + 24 + 16) / 144, WITHIN
    for n in (10, 20):
        yield f"L, {n}", without(block("square", n, n), ((0.5, 0.5), (1, 1))), 4.0, WITHIN
    square = block("square", 24, 24)
    yield "notch", without(square, ((1 / 3, 0.5), (2 / 3, 1.0))), 5.0, WITHIN
    yield "square hole", without(square, ((1 / 3, 1 / 3), (2 / 3, 2 / 3))), 4 + 4 / 3, WITHIN
    yield "L in 3-D", without(block("sc", 12, 12, 8), ((0.5, 0.5, -1), (1, 1, 1))), \
        4 * 8 / 12 + 2 * 0.75, WITHIN
    for rows in (2, 3, 4, 5, 8):
        yield f"plate of {rows} rows", *plate("square", rows, 1), EXACT
        yield f"hexagonal plate of {rows} rows", *plate("hex", rows, 1), EXACT
    for rows in (3, 4, 5, 8):
        yield f"hexagonal plate across its rows, {rows}", *plate("hex", rows, 0), EXACT
    for rows in (2, 3, 4):
        yield f"plate of {rows} rows in 3-D", *plate("sc", rows, 2), EXACT
        yield f"plate of {rows} rows, fcc", *plate("fcc", rows, 2), EXACT


def heated(cloud, words=""):
    """Area as found and power of a flux."""
    scene = Heated(cloud, UNIFORM, f"fix b all tmsph/heat/boundary flux {FLUX} {words}")
    scene.run_to(1e-6, 1, columns="step f_b[1] f_b[3]")
    return scene.done.thermo("f_b[3]")[-1], scene.done.thermo("f_b[1]")[-1]


def areas(report):
    for name, cloud, exact, bar in bodies():
        found, power = heated(cloud)
        report.below(f"{name}: area/exact - 1", abs(found / exact - 1), bar)
        report.below(f"{name}: power/(q area) - 1", abs(power / (FLUX * found) - 1), 1e-12)
        if not cloud.periodic:
            again, _ = heated(turned(cloud)[0])
            report.below(f"{name}, turned: area/not turned - 1", abs(again / found - 1), EXACT)


def one_face(report, name, cloud, Q, direction):
    """A flux in through one face and out through the opposite one: T = X.slope stays as it is."""
    slope = Q @ direction
    words = " ".join(f"{v:.17g}" for v in np.append(slope, [0.0] * (3 - len(slope))))
    back = " ".join(f"{-v:.17g}" for v in np.append(slope, [0.0] * (3 - len(slope))))
    T = cloud.X @ slope
    scene = Heated(cloud, UNIFORM, f"fix a all tmsph/heat/boundary flux 1.0 facing {words}\n"
                   f"fix b all tmsph/heat/boundary flux -1.0 facing {back}", T)
    end = scene.run_to(0.3, 20, columns="step f_a[3] f_b[3]")
    report.below(f"{name}: change of a linear field/change over a spacing",
                 np.abs(end - T).max() / cloud.spacing, 1e-4)
    return scene.done.thermo("f_a[3]")[-1]


def linear(report):
    for name, cloud, exact in (("square 12", block("square", 12, 12), 1.0),
                               ("square 12 x 3", block("square", 12, 3), 3 / 12),
                               ("hexagonal lattice", block("hex", 12, 6), None),
                               ("cube 8", block("sc", 8, 8, 8), 1.0),
                               ("cube, fcc", block("fcc", 5, 5, 5), None)):
        D = cloud.dimension
        if exact is None:
            exact = np.prod((cloud.box[1] - cloud.box[0])[1:])
        body, Q = turned(cloud)
        found = one_face(report, f"{name}, turned", body, Q, np.eye(D)[0])
        report.below(f"{name}, turned: area of one face/exact - 1", abs(found / exact - 1), WITHIN)


def cooled(name, n, biot=2.0, time=0.1):
    """A square or a cube of unit width, 1 at first, by convection to 0 all around: error."""
    cloud = block(name, *(n,) * len(LATTICES[name][0]))
    scene = Heated(cloud, UNIFORM, f"fix b all tmsph/heat/boundary convection {biot} 0.0", 1.0)
    T = scene.run_to(time, 100)
    # its half is a slab of unit thickness in units of itself
    along = [robin(np.abs(2 * x - 1), 4 * time, biot / 2) for x in cloud.X.T]
    return rms(T - np.prod(along, axis=0))


def convection(report):
    for name, sizes in (("square", (10, 20, 40)), ("sc", (6, 12))):
        errors = [cooled(name, n) for n in sizes]
        report.note(f"convection, {name}, {sizes} across: errors", listed(errors))
        report.above(f"convection, {name}: lowest order", order(errors).min(), 1.9)


if __name__ == "__main__":
    main(areas, linear, convection)
