#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plot the forces on the lower plate of examples/slide against time, for several laws.

usage: slide.py OUT.png TITLE=LOG [TITLE=LOG ...]

The picture in doc/report/contact.md:
    cd examples/slide
    ../../tmsph run in.slide -log log.a
    ../../tmsph run in.slide -var visc 0 -log log.b
    ../../tmsph run in.slide -var law penalty -log log.c
    ../../tmsph run in.slide -var law paper -log log.d
    ../../tmsph run in.slide -var law paper -var cfl 0.25 -log log.e
    ../../tmsph run in.slide -var law paper -var visc 0 -log log.f     # stops with an error
    ../../tools/slide.py ../../doc/images/slide.png "paper, no viscosity"=log.f paper=log.d \\
        "paper, half the step"=log.e implicit=log.a "implicit, no viscosity"=log.b penalty=log.c
"""
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

sys.path.insert(0, str(Path(__file__).resolve().parents[1] / "unittest" / "verification"))
from tmsph_testing import read_thermo

EDGE, MODULUS, FRICTION, PUSH = 0.1, 1e7 / (1 - 0.2**2), 0.3, 8e-3


def main(arguments):
    if len(arguments) < 2 or not all("=" in word for word in arguments[1:]):
        sys.exit(__doc__)
    figure, (above, below) = plt.subplots(2, 1, figsize=(7, 6), sharex=True)
    for k, (title, log) in enumerate(word.split("=", 1) for word in arguments[1:]):
        table = read_thermo(Path(log).read_text())[-1]
        style = dict(label=title, lw=1 if k < 3 else 2, ls=["-", "--", ":"][k % 3])
        above.plot(table["time_s"], -table["below_y_N"] / 1e3, **style)
        below.plot(table["time_s"], table["below_x_N"] / 1e3, **style)
    stretch = 1 - PUSH / EDGE
    exact = MODULUS * EDGE * stretch * (1 - stretch**2) / 2e3
    above.axhline(exact, color="k", ls=":", lw=1, label="exact without friction")
    below.axhline(FRICTION * exact, color="k", ls=":", lw=1, label="0.3 of that")
    above.set_ylabel("normal force, kN/m")
    below.set_ylabel("friction, kN/m")
    below.set_xlabel("time, s")
    above.legend(fontsize="small")
    figure.tight_layout()
    figure.savefig(arguments[0], dpi=100)


if __name__ == "__main__":
    main(sys.argv[1:])
