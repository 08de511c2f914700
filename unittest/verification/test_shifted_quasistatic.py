# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Shifted bodies that break in equilibrium, in all ways at all places, see test_shifted.py."""

from test_shifted import Quasistatic, shifted
from tmsph_testing import main


def quasistatic(report):
    shifted(report, Quasistatic, True)


if __name__ == "__main__":
    main(quasistatic)
