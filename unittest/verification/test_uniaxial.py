# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""examples/uniaxial: between platens with friction the specimen starts to break where its weakest
particle does. The smallest of n draws of a Weibull distribution of scale s and modulus w is itself
Weibull distributed, with the scale s n^(-1/w) and the same modulus: three seeds lie between its
quantiles of 0.1 and 99.9 percent. Without friction all of it bears the same stress, the rows at
the platens as well: the bond of the lowest mean of two strengths breaks first, at that stress.
A sideways stress counts (1 + m/2) times in that, m = 29: inertia and rows at platens may leave one
of 1 percent of the pressure."""

import re
from pathlib import Path

import numpy as np

from tmsph_testing import HORIZON, Script, main

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ("examples/uniaxial/in.uniaxial", "potentials/granite.tmsph")    # it includes the second
SIDEWAYS = 0.01 * (1 + 29 / 2)
STRENGTH, MODULUS, PARTICLES = 200.0, 15, 25 * 50    # MPa


def first_break(friction, seed):
    """In MPa, and the run."""
    scene = Script(f"variable friction index {friction}\nvariable seed index {seed}\n"
                   "shell cd examples/uniaxial\ninclude in.uniaxial\nshell cd ../..\n"
                   "compute rock all tmsph/property/atom x0 y0 strength\nrun 0",
                   {name: (ROOT / name).read_text() for name in EXAMPLE})
    run = scene.snapshot("rock", "c_rock[1] c_rock[2] c_rock[3]").run()
    return float(re.findall(r"^First break at ([\d.]+) MPa", run.log, re.M)[0]), run


def weakest_bond(run):
    """In MPa, from the snapshot of strengths."""
    rock = run.frame("rock")
    X, strength = rock("c_rock[1] c_rock[2]"), rock["c_rock[3]"] / 1e6
    near = np.linalg.norm(X[:, None] - X[None], axis=2) < HORIZON * 1e-3
    mean = 0.5 * (strength[:, None] + strength[None])
    return mean[near & ~np.eye(len(X), dtype=bool)].min()


def quantile(share):
    return STRENGTH * PARTICLES ** (-1 / MODULUS) * (-np.log(1 - share)) ** (1 / MODULUS)


def with_friction(report):
    low, high = quantile(0.001), quantile(0.999)
    for seed in (4711, 1, 2):
        report.within(f"first break, friction 0.2, seed {seed}, MPa", first_break(0.2, seed)[0],
                      low, high)


def without_friction(report):
    stress, run = first_break(0.0, 4711)
    report.within("first break without friction/strength of the weakest bond",
                  stress / weakest_bond(run), 1 - SIDEWAYS, 1 + SIDEWAYS)


if __name__ == "__main__":
    main(with_friction, without_friction)
