#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plot the forces on the lower plate of examples/slide against time, for several laws.

usage: slide.py OUT.png TITLE=LOG [TITLE=LOG ...]

The picture in doc/report/contact.md:
    cd examples/slide
    for law in implicit penalty paper; do
        ../../tmsph run in.slide -var law $law -log log.$law
    done
    ../../tmsph run in.slide -var law paper -var cfl 0.25 -log log.paper.half
    ../../tools/slide.py ../../doc/images/slide.png implicit=log.implicit penalty=log.penalty \\
        paper=log.paper paper,\\ half\\ the\\ step=log.paper.half
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
    for title, log in (word.split("=", 1) for word in arguments[1:]):
        table = read_thermo(Path(log).read_text())[-1]
        above.plot(table["Time"], -table["f_below[2]"] / 1e3, label=title, lw=1)
        below.plot(table["Time"], table["f_below[1]"] / 1e3, label=title, lw=1)
    stretch = 1 - PUSH / EDGE
    exact = MODULUS * EDGE * stretch * (1 - stretch**2) / 2e3
    above.axhline(exact, color="k", ls=":", lw=1, label="exact without friction")
    below.axhline(FRICTION * exact, color="k", ls=":", lw=1, label="0.3 of that")
    above.set_ylabel("normal force, kN/m")
    below.set_ylabel("friction, kN/m")
    below.set_xlabel("time, s")
    above.legend()
    below.legend()
    figure.tight_layout()
    figure.savefig(arguments[0], dpi=100)


if __name__ == "__main__":
    main(sys.argv[1:])
