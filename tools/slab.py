#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plot the temperature profiles of examples/slab beside the exact ones.

usage: slab.py OUT.png [FOLDER]

The picture in doc/report/heat.md:
    ./tmsph run examples/slab/in.slab
    tools/slab.py doc/images/slab.png examples/slab
"""
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

import lammps_files

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "unittest" / "verification"))
from heat_scenes import dirichlet, neumann, robin

# as in.slab has them: thickness, end in units of L^2/diffusivity, temperatures, q L/k, h L/k

THICKNESS, END, COLD, HOT, FLUX, BIOT = 0.1, 0.3, 20.0, 100.0, 100.0, 2.0
EXACT = {
    "temperature": lambda x, t: COLD + (HOT - COLD) * dirichlet(x, t),
    "flux": lambda x, t: COLD + FLUX * neumann(x, t),
    "convection": lambda x, t: COLD + (HOT - COLD) * robin(x, t, BIOT),
}


def profiles(path):
    """Each as position and temperature of the columns that have particles."""
    for _, rows in lammps_files.profiles(path)[1]:
        _, x, count, T = rows.T
        yield x[count > 0], T[count > 0]


def main(out, folder="."):
    figure, axes = plt.subplots(1, 3, figsize=(11, 3.6))
    for axis, (kind, exact) in zip(axes, EXACT.items()):
        found = list(profiles(Path(folder, f"profile.{kind}.txt")))[1:]    # the first is the start
        for number, (x, T) in enumerate(found, 1):
            if number not in (1, 2, 4, 10):
                continue
            time = END * number / len(found)
            x = (x - x[0] + 0.5 * (x[1] - x[0])) / THICKNESS
            fine = np.linspace(0, 1, 200)
            line, = axis.plot(fine, exact(fine, time), lw=1, label=f"{time:.2g}")
            axis.plot(x, T, ".", ms=4, color=line.get_color())
        error = np.sqrt(np.mean((T - exact(x, END)) ** 2))
        print(f"{kind}: root mean square error at the end {error:.3g} degrees")
        axis.set_title(kind)
        axis.set_xlabel("depth/thickness")
    axes[0].set_ylabel("temperature, C")
    axes[1].legend(title="time/(L$^2$/diffusivity)", fontsize="x-small")
    figure.tight_layout()
    figure.savefig(out, dpi=100)


if __name__ == "__main__":
    if not 2 <= len(sys.argv) <= 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
