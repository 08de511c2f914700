#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Plot errors of heat conduction against the resolution.

usage: heat_error.py OUT.png FILE [FILE ...]

The files hold what the tests print. The picture in doc/report/heat.md:
    export TMSPH_LMP=$(./tmsph where)
    for name in slab disc; do
        /usr/bin/python3 unittest/verification/test_heat_$name.py all > $name.txt
    done
    tools/heat_error.py doc/images/heat_error.png slab.txt disc.txt
"""
import re
import sys
from pathlib import Path

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt
import numpy as np

SIZES = {2: [10, 20], 4: [10, 20, 40, 80]}    # of the slabs, by how many


def main(out, *files):
    figure, (left, right) = plt.subplots(1, 2, figsize=(10, 5.4), sharex=True, sharey=True)
    for file in files:
        found = re.findall(r"^ +(.*?)(?:, \[(.*)\])?: errors: (.*)$", Path(file).read_text(), re.M)
        for title, sizes, errors in found:
            errors = [float(word) for word in errors.split(",")]
            n = [int(word) for word in sizes.split(",")] if sizes else SIZES[len(errors)]
            if "areas given" in title:
                continue    # close to those that are found
            title = title.replace(", areas found", "")
            style = "--" if "jittered" in title else "-." if "sc" in title else "-"
            axis = right if sizes else left
            axis.loglog(n, errors, "o" + style, ms=3, lw=1, label=title)
    n = np.array([10.0, 80.0])
    for axis, title in ((left, "slab"), (right, "disc, region for its rim")):
        axis.loglog(n, 0.02 * (10 / n) ** 2, "k:", lw=1, label="second order")
        axis.loglog(n, 0.05 * (10 / n), "k-", lw=0.5, label="first order")
        axis.set_title(title)
        axis.set_xlabel("particles across, along the radius")
        axis.legend(fontsize="x-small", ncols=2, loc="upper center", bbox_to_anchor=(0.5, -0.14))
    left.set_ylabel("root mean square error")
    figure.tight_layout()
    figure.savefig(out, dpi=100)


if __name__ == "__main__":
    if len(sys.argv) < 3:
        sys.exit(__doc__)
    main(*sys.argv[1:])
