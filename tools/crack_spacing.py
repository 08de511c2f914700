#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Count the cracks of examples/quench that reach a depth below the long edge.

usage: crack_spacing.py [--plot OUT.png] TITLE=DUMP [TITLE=DUMP ...]

From the last frame of each dump: number of cracks, mean spacing and its scatter, at depths from
one particle row to the middle of the plate, and the lengths of the longest cracks. A crack at a
depth is a run of damaged particles in the rows there, with gaps below one horizon. The end of the
plate, as far as its own edge reaches, is left out. --plot draws the plates, coloured by damage.

The tables and the picture in doc/report/quench.md:
    cd examples/quench
    ../../tmsph run in.quench -var restart 0 -var end 0.2 && mv dump.quench dump.long
    for T in 300 400 500 600; do
      ../../tmsph run in.quench -var restart 0 -var T0 $T && mv dump.quench dump.$T
    done
    ../../tools/crack_spacing.py --plot ../../doc/images/quench.png "300 C, 50 ms"=dump.300 \\
        "300 C, 200 ms"=dump.long "400 C, 50 ms"=dump.400 "600 C, 50 ms"=dump.600
    ../../tools/crack_spacing.py "500 C, 50 ms"=dump.500
"""
import sys

import numpy as np

import lammps_files

DAMAGED = 0.3      # share of broken bonds; beside a straight crack it is about 0.4
HORIZON = 3.015    # in spacings
DEPTHS = (0.25, 0.5, 0.75, 1.0, 1.5, 2.0, 2.5, 3.0, 4.0)    # mm


def frames(path):
    """(step, temperature, damage, x, y) of each frame; reference positions in mm."""
    for step, _, names, table in lammps_files.frames(path):
        T, damage, x, y = (table[:, names.index(name)] for name in ("temperature", "damage", "x0",
                                                                    "y0"))
        yield step, T, damage, 1e3 * x, 1e3 * y


class Plate:
    def __init__(self, path):
        for frame in frames(path):
            pass
        self.step, self.temperature, self.damage, self.x, self.y = frame
        rows = np.unique(self.y.round(6))
        self.row = rows[1] - rows[0]
        self.spacing = self.row * 2 / 3**0.5    # of the hexagonal lattice
        self.width = rows[-1] + 0.5 * self.row
        self.length = self.x.max() + 0.25 * self.spacing
        self.window = self.length - 0.5 * self.width

    def cracks(self, depth):
        """Places along the edge of the cracks that reach so deep."""
        rows = np.abs(self.width - self.y - depth) < self.row
        x = np.sort(self.x[rows & (self.damage > DAMAGED) & (self.x < self.window)])
        if len(x) == 0:
            return x
        parts = np.split(x, np.flatnonzero(np.diff(x) > HORIZON * self.spacing) + 1)
        return np.array([part.mean() for part in parts])

    def longest(self, count=4):
        """Depths of the deepest cracks, each followed from where it is at the smallest depth."""
        depths = np.arange(DEPTHS[0], self.width, self.row)
        tips = {}
        for place in self.cracks(depths[0]):
            at, deepest = place, depths[0]
            for depth in depths[1:]:
                found = self.cracks(depth)
                if len(found) == 0 or np.abs(found - at).min() > HORIZON * self.spacing:
                    break
                at, deepest = found[np.abs(found - at).argmin()], depth
            tips[place] = deepest
        return sorted(tips.values(), reverse=True)[:count]


def table(title, plate):
    print(f"{title}, step {plate.step}, {plate.window:.2f} mm of the edge")
    print("  depth mm  cracks  spacing mm  scatter  depth/spacing")
    for depth in DEPTHS:
        places = plate.cracks(depth)
        if len(places) == 0:
            break
        spacing = plate.window / len(places)
        scatter = f"{np.std(np.diff(places)):7.2f}" if len(places) > 2 else "      -"
        print(f"  {depth:8.2f} {len(places):7d} {spacing:11.2f} {scatter} {depth / spacing:14.2f}")
    print("  longest cracks, mm: " + ", ".join(f"{d:.1f}" for d in plate.longest()))


def plot(out, plates):
    import matplotlib
    matplotlib.use("Agg")
    from matplotlib import colors, pyplot as plt
    from plotting import maps
    from plotting.save import save
    figure, axes = plt.subplots(len(plates), 1, squeeze=False, figsize=(7, 2.7 * len(plates) + 0.6),
                                layout="constrained")
    cmap, norm = maps.colours("damage"), colors.Normalize(0, maps.DAMAGED)
    for ax, (title, plate) in zip(axes[:, 0], plates):
        size = (370 * plate.spacing / plate.length) ** 2    # square points
        ax.scatter(plate.x, plate.y, c=plate.damage, s=size, cmap=cmap, norm=norm, linewidths=0)
        ax.set_title(title, fontsize="medium")
        ax.set_aspect("equal")
        ax.set_xlim(0, plate.length)
        ax.set_ylim(0, plate.width)
        ax.set_ylabel("mm")
    axes[-1, 0].set_xlabel("mm")
    figure.colorbar(plt.cm.ScalarMappable(norm, cmap), ax=list(axes[:, 0]), location="bottom", aspect=40,
                    shrink=0.8, extend="max", label="damage: share of broken bonds")
    save(figure, out)


def main(arguments):
    out = None
    if arguments[:1] == ["--plot"] and len(arguments) > 1:
        out, arguments = arguments[1], arguments[2:]
    if not arguments or not all("=" in word for word in arguments):
        sys.exit(__doc__)
    plates = [(title, Plate(path)) for title, path in (word.split("=", 1) for word in arguments)]
    for title, plate in plates:
        table(title, plate)
    if out:
        plot(out, plates)


if __name__ == "__main__":
    main(sys.argv[1:])
