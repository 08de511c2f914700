# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Energies of cracks as in test_openings.py on more lattices, on relaxed clouds, in plane stress, in 3-D and
at other spacings; how far arrangements of particles are from balance."""

import numpy as np

from scenes.relaxed import Body, Relaxed
from test_openings import (ENERGY, HEIGHT, NOTCH, SPACING, Strip, TENSILE, WIDTH, YOUNG, energies, energy,
                           even_bodies, imbalance_told, shaken, strip_lattice)
from tmsph_testing import HORIZON, lattice, main

LAYERS = 7    # in 3-D: the least that a periodic direction may have


def lattices(report):
    energies(report, (("square", 15), ("square", 30), ("square", 45), ("hex", 0), ("hex", 30)))


def relaxed_strip(seed, layers=0):
    """layers: spacings of its thickness, in which it is periodic; 0 in 2-D."""
    size = np.array([WIDTH, HEIGHT, layers * SPACING][:3 if layers else 2])
    low, high = -0.5 * size, 0.5 * size
    ends = " ".join(f"{a:.17g} {b:.17g}" for a, b in zip(low, high))
    shape = f"block {ends}" if layers else f"block {ends} INF INF"
    particles = round(np.prod(size) / SPACING ** len(size))
    return Relaxed([Body("strip", shape, particles)], low, high, "z" if layers else "", seed=seed).cloud


def clouds(report):
    """Two draws."""
    for seed in (1, 2):
        cloud = relaxed_strip(seed)
        for plane in ("strain", "stress"):
            energy(report, f"relaxed {seed}, plane {plane}", Strip(cloud, words=f"plane {plane}"))


def plane_stress(report):
    for name, angle in (("square", 0), ("hex", 15)):
        energy(report, f"{name} {angle}, plane stress",
               Strip(strip_lattice(name, angle, SPACING), words="plane stress"))


SOLIDS = ("simple cubic", "relaxed, 3-D")


def solid(report, which=SOLIDS):
    """Strips that are periodic in their thickness. Pulled apart faster, as they have 7 times the particles."""
    for what in which:
        cloud = (relaxed_strip(1, LAYERS) if what.startswith("relaxed") else
                 lattice("sc", (40, 20, LAYERS), SPACING, "z", centre=True))
        energy(report, what, Strip(cloud, 0.05, thickness=LAYERS * SPACING), 0.08)


def spacings(report):
    """The energy of the crack at spacings from .18 of the characteristic length on; where the start
    warns, beyond 0.3, it may be any."""
    area = WIDTH - NOTCH
    for spacing in (1e-3, 2e-3, 3e-3):
        strip = Strip(strip_lattice("square", 0, spacing))
        run = strip.scene().add(f"run {strip.steps}").run()
        took, gained, lost = (run.thermo(f"f_break[{k}]")[-1] for k in (6, 8, 9))
        ratio = spacing * TENSILE**2 / (YOUNG * ENERGY)
        what, energy = f"{ratio:.2f} of the length", (took + lost) / (ENERGY * area)
        if ratio <= 0.3:
            report.within(f"{what}: energy of the crack/(G area)", energy, 0.95, 1.05)
        else:
            report.note(f"{what}: energy of the crack/(G area)", f"{energy:.3f}")
            report.within(f"{what}: warned", float("of the characteristic length" in run.log), 1, 1)
        report.below(f"{what}: gained by updates/dissipated", gained / took, 1e-4)


def imbalance(cloud):
    """By tmsph_arrangement.h, median over the interior: here of particles of one type."""
    X = cloud.X[None] - cloud.X[:, None]
    R, horizon = np.linalg.norm(X, axis=2), HORIZON * cloud.spacing
    weight = np.where((R > 0) & (R < horizon), cloud.volume * (1 - R / horizon) ** 3, 0)    # Wendland C2
    moment = np.einsum("ij,ijk->ik", weight, X)
    size = np.linalg.norm(moment, axis=1)
    spacing = cloud.volume ** (1 / cloud.dimension)
    ratio = 2 * size * cloud.dimension / np.sum(weight * R**2, axis=1) * spacing
    fewer = -moment / np.maximum(size, 1e-300)[:, None]
    beyond = np.max(np.where(weight > 0, np.einsum("ijk,ik->ij", X, fewer), 0), axis=1)
    inside = beyond >= 0.75 * np.max(np.where(weight > 0, R, 0), axis=1)
    return np.median(ratio[inside]), inside.sum()


def arrangements(report):
    for name, cloud in even_bodies():
        if cloud.type.max() > 1:
            continue
        bodies = [(name, cloud, 0)]
        if not name.startswith(("relaxed", "turned")):
            bodies += [(f"{name}, shaken by {amount}", shaken(cloud, amount, seed), 1)
                       for amount in (0.1, 0.2) for seed in (1, 2)]
            report.note(f"{name}, shaken by 0.05: imbalance", f"{imbalance(shaken(cloud, 0.05, 1))[0]:.4f}")
        for what, body, times in bodies:
            told, (exact, inside) = imbalance_told(report, what, body, times), imbalance(body)
            report.note(f"{what}: imbalance", f"{exact:.4f}, {inside} of {len(body)} particles inside")
            if times:    # told with 2 digits
                report.within(f"{what}: told/exact", told / exact, 0.94, 1.06)
    for d, numbers in ((2, (100, 400, 1600)), (3, (500, 1000, 2000))):
        for what, end in (("block", "block" + " 0 0.02" * d + " INF INF" * (3 - d)),
                          ("ball", "sphere 0.01 0.01 " + ("0.01" if d == 3 else "0") + " 0.01")):
            for n in numbers:
                cloud = Relaxed([Body("all", end, n)], (0,) * d, (0.02,) * d).cloud
                cloud.spacing = cloud.volume[0] ** (1 / d)    # of the body, not of the box
                report.below(f"{d}-D relaxed {what} of {n}: imbalance", imbalance(cloud)[0], 0.03)


if __name__ == "__main__":
    main(lattices, clouds, plane_stress, solid, spacings, arrangements)
