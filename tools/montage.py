#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Put pictures of a run side by side, each with its title.

usage: montage.py OUT.png TITLE=PICTURE.png [TITLE=PICTURE.png ...]

The picture in doc/output.md is made with it: see cracks.py.
"""
import sys

import matplotlib
matplotlib.use("Agg")
import matplotlib.pyplot as plt

from plotting.save import save


def main(arguments):
    if len(arguments) < 2 or not all("=" in word for word in arguments[1:]):
        sys.exit(__doc__)
    out, pictures = arguments[0], [word.split("=", 1) for word in arguments[1:]]
    figure, axes = plt.subplots(1, len(pictures), figsize=(3.2 * len(pictures), 3.5), squeeze=False)
    for ax, (title, path) in zip(axes[0], pictures):
        ax.imshow(plt.imread(path), interpolation="lanczos")
        ax.set_title(title)
        ax.axis("off")
    figure.tight_layout(pad=0.3)
    save(figure, out)


if __name__ == "__main__":
    main(sys.argv[1:])
