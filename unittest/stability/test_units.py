# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The short cases of the stability suite on systems of units. All of them:
./tmsph report --only stability."""

import units
from cases import tested

if __name__ == "__main__":
    tested(units)
