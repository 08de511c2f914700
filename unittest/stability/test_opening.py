# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The short cases of the stability suite on bonds that open. All of them:
./tmsph report --only stability."""

import openings
from cases import tested

if __name__ == "__main__":
    tested(openings)
