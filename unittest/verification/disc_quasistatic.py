# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Quasi-static stepping against slow dynamics on the heated disc, for three draws of the
strengths, and minimizers on the elastic disc. A study, without bars; some minutes:
    TMSPH_LMP=$(./tmsph where) /usr/bin/python3 unittest/verification/disc_quasistatic.py"""

import re

import numpy as np

from test_disc_cracks import SEEDS, SPACING, Disc
from tmsph_testing import Scene, disc_materials, lattice

RESIDUALS = (1e-3, 1e-4, 1e-6)    # in units of 15 MPa on the section of a particle
STYLES = {"cg": "line forcezero dmax {dmax}", "fire": "dmax {dmax} tmax 1.0",
          "tmsph/lbfgs": "norm two"}


def cracks():
    print("| steps | draw | first break, C | 5 mm, C | rim, C | main cracks "
          "| bonds broken by 160 C "
          "| by 200 C | by 260 C | force evaluations |")
    print("|" + "---|" * 10)
    for quasistatic in (False, True):
        for seed in SEEDS:
            disc = Disc(seed, quasistatic=quasistatic)
            cost = sum(map(int, re.findall(r"(\d+) force evaluations\n", disc.log))) or 13000
            print(f"| {'quasi-static' if quasistatic else 'dynamic'} | {seed} | {disc.T.min():.1f} "
                  f"| {disc.temperature_at(disc.a + 0.005):.0f} "
                  f"| {disc.temperature_at(disc.R - 2 * SPACING):.0f} | {disc.main_cracks()} "
                  f"| {np.sum(disc.T <= 160)} | {np.sum(disc.T <= 200)} | {len(disc.T)} | {cost} |",
                  flush=True)


def minimizers():
    """Force evaluations from the reference positions to equilibrium at 80 degrees."""
    print("| minimizer | spacing, mm | " + " | ".join(f"{r:g}" for r in RESIDUALS) + " |")
    print("|" + "---|" * (2 + len(RESIDUALS)))
    for spacing in (2e-3, 1e-3, 0.5e-3):
        cells = (2 * int(0.05 / spacing) + 4, 2 * int(0.05 / spacing / 3**0.5) + 4)
        cloud = lattice("hex", cells, spacing, centre=True)
        cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= 0.05)
        cloud.type[np.linalg.norm(cloud.X, axis=1) > 0.015] = 2
        for style, options in STYLES.items():
            scene = Scene(cloud, disc_materials(False), "plane strain")
            scene.add(f"run 0\nset group all temperature 80\nmin_style {style}\nmin_modify "
                      f"{options.format(dmax=0.01 * spacing)}\ntimestep {1.6 * spacing / 4465}")
            for residual in RESIDUALS:
                scene.add(f"minimize 0 {residual * 15e6 * spacing * len(cloud)**0.5} 99999 99999")
            counts = re.findall(r"force evaluations = \d+ (\d+)", scene.run().log)
            print(f"| {style} | {spacing * 1e3:g} | "
                  + " | ".join(map(str, np.cumsum([int(n) for n in counts]))) + " |", flush=True)


if __name__ == "__main__":
    minimizers()
    cracks()
