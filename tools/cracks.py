#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Orientation, number and length of cracks from the break events of fix tmsph/hoekbrown.

usage: cracks.py EVENTS [options]

EVENTS is what 'write_dump all local events.txt index f_ID[*]' or a 'dump local' writes, the columns
named or not; of a dump with several frames the last is taken. Written are, beside EVENTS:
  cracks.rose.csv, .png        events per direction of the crack, tension and shear apart
  cracks.dip.csv               the same of the dips, in 3-D
  cracks.events.csv, .png      all events in their order, with cumulative number and energy
  cracks.length.csv, .png      crack length against temperature, with --curve or --log
  cracks.clusters.csv, .png    clusters of events with their magnitudes, with --clusters
  cracks.front.csv, .png       how far a crack has run, with --from

options:
  --curve FILE        table of fix ave/time that has the crack area of compute tmsph/crack
  --log FILE          log with it, as an alternative
  --columns T A       names of the columns of temperature and crack area in that table
                      (default: temperature and crack_area, with or without a unit as in
                      crack_area_m2; or f_heat and c_crack[3])
  --thickness H       thickness of a 2-D body: crack length is area over thickness (default 1)
  --against WHAT      temperature, time or step, for the events (default temperature)
  --bins N            bins of the rose over 180 degrees (default 18)
  --radius R          distance within which events tell the direction of a crack
                      (default: 4 spacings of the particles, which follow from the events)
  --clusters WINDOW   events that are within WINDOW, in what --against says, and within the radius of each
                      other, directly or by others, are one emission; its magnitude is the logarithm to base
                      10 of its energy, b by maximum likelihood
  --complete M        magnitude from which on all emissions count for b (default: that of most of them)
  --from X Y [Z]      the front of the crack is the farthest event from there so far
  --out PREFIX        (default cracks, in the folder of EVENTS)

The direction of a crack at an event is the longest axis of the cloud of events around it, in 3-D
the strike and dip of its plane. An event alone counts with the direction normal to its bond. Where
events fill the surroundings evenly there is no direction; those are counted apart. Angles are from
the x axis, counterclockwise; in 3-D strike is the angle of the horizontal line in the crack.

The picture in doc/output.md:
    ./tmsph run examples/disc/in.disc
    cd examples/disc
    ../../tools/cracks.py events.txt --curve broken_bonds.txt
    ../../tools/montage.py ../../doc/images/cracks.png rose=cracks.rose.png \\
        events=cracks.events.png length=cracks.length.png
"""
import argparse
import re
import sys
from pathlib import Path

import numpy as np

import lammps_files
from lammps_files import stop

# of the events of fix tmsph/hoekbrown, as examples/disc names them
COLUMNS = "id1 id2 step time x y z nx ny nz kind energy temperature".split()
REACH = 4.0            # spacings: a crack is some 3 wide
ROUND = 0.5            # above this ratio of variances a cloud has no direction
COLOURS = ("tab:red", "tab:blue")


class Events:
    """The table of break events, in order of time."""

    def __init__(self, path):
        frame = None
        for frame in lammps_files.frames(path):
            pass
        if frame is None:
            stop(f"{path} breaks off within its first frame")
        step, kind, names, table = frame
        if kind == "ATOMS":
            stop(f"{path} is a dump of particles: give the events, 'dump local ... f_ID[*]'")
        columns = [k for k, name in enumerate(names)
                   if name in COLUMNS or re.fullmatch(r"f_\S+\[\d+\]", name)]
        if len(columns) != len(COLUMNS):
            stop(f"{path} has {len(columns)} columns of a fix, not the {len(COLUMNS)} of the events of "
                 "fix tmsph/hoekbrown: use 'write_dump all local FILE index f_ID[*]'")
        table = table[:, columns]
        if not np.isin(table[:, 10], (1, 2)).all():
            stop(f"{path}: column 11 is not 1 for tension or 2 for shear: give all 13 in "
                 "their order")
        table = table[np.lexsort((table[:, 1], table[:, 0], table[:, 2]))]
        self.ids, self.step, self.time = table[:, :2].astype(int), table[:, 2], table[:, 3]
        self.place, self.bond = table[:, 4:7], table[:, 7:10]
        self.shear, self.energy, self.temperature = table[:, 10] == 2, table[:, 11], table[:, 12]
        self.dimension = 3 if np.any(self.bond[:, 2]) else 2

    def __len__(self):
        return len(self.step)

    def spacing(self):
        """Two bonds of one particle to neighbors have midpoints half a spacing apart."""
        nearest = []
        ends = self.ids.ravel()
        order = np.argsort(ends, kind="stable")
        for part in np.split(order // 2, np.flatnonzero(np.diff(ends[order])) + 1):
            if len(part) > 1:
                gap = np.linalg.norm(self.place[part[1:]] - self.place[part[0]], axis=1)
                nearest.append(gap.min())
        return 2 * np.percentile(nearest, 10) if nearest else 0.0

    def axes(self, radius):
        """The normal of the crack at each event; NaN where there is no direction."""
        d = self.dimension
        normal = np.array(self.bond[:, :d])
        for i, near in enumerate(neighborhoods(self.place[:, :d], radius)):
            if len(near) < d + 1:
                continue
            variance, axis = np.linalg.eigh(np.cov(self.place[near, :d].T))
            normal[i] = axis[:, 0] if variance[0] < ROUND * variance[1] else np.nan
        return normal


def neighborhoods(X, radius):
    """The points within the radius of each point, itself among them."""
    cell = np.floor(X / radius).astype(int)
    boxes = {}
    for i, key in enumerate(map(tuple, cell)):
        boxes.setdefault(key, []).append(i)
    around = np.stack(np.meshgrid(*[[-1, 0, 1]] * X.shape[1]), -1).reshape(-1, X.shape[1])
    for i, key in enumerate(cell):
        near = np.array([j for shift in around for j in boxes.get(tuple(key + shift), ())])
        yield near[np.linalg.norm(X[near] - X[i], axis=1) <= radius]


def rose(events, radius, bins):
    """Edges of the bins in degrees and the number of events in each, in tension and in shear; how
    many have no direction; dips in 3-D."""
    normal = events.axes(radius)
    known = ~np.isnan(normal[:, 0])
    # the line in the crack: the normal turned by a right angle, in 3-D that of its horizontal part
    angle = (np.degrees(np.arctan2(normal[:, 1], normal[:, 0])) + 90) % 180
    edges = np.linspace(0, 180, bins + 1)
    counts = [np.histogram(angle[known & (events.shear == kind)], edges)[0] for kind in (False,
                                                                                         True)]
    dip = np.degrees(np.arccos(np.abs(normal[known, 2]))) if events.dimension == 3 else None
    return edges, counts, int(np.count_nonzero(~known)), dip


def table(path, names, columns):
    with lammps_files.opened(path, "w") as file:
        file.write(",".join(names) + "\n")
        for row in zip(*columns):
            file.write(",".join(f"{value:.10g}" for value in row) + "\n")


def draw_rose(path, edges, counts):
    figure, ax = pyplot().subplots(figsize=(5, 5), subplot_kw=dict(projection="polar"))
    middle, width = np.radians(edges[:-1] + np.diff(edges) / 2), np.radians(np.diff(edges))
    bottom = np.zeros(len(middle))
    for count, colour, label in zip(counts, COLOURS, ("tension", "shear")):
        for turn, name in ((0, label), (np.pi, None)):
            ax.bar(middle + turn, count, width, bottom, color=colour, label=name)
        bottom = bottom + count
    ax.yaxis.set_major_locator(pyplot().MaxNLocator(4))
    ax.set_rlabel_position(75)
    ax.set_title("events by direction of the crack")
    ax.legend(loc="lower right", bbox_to_anchor=(1.1, -0.12))
    save(figure, path)


def draw_curves(path, x, label, curves, ylabel):
    figure, ax = pyplot().subplots(figsize=(6, 4))
    for name, y, colour in curves:
        ax.plot(x, y, color=colour, label=name, drawstyle="steps-post" if name else "default")
    ax.set_xlabel(label)
    ax.set_ylabel(ylabel)
    ax.set_ylim(bottom=0)
    if curves[0][0]:
        ax.legend()
    save(figure, path)


def pyplot():
    import matplotlib
    matplotlib.use("Agg")
    import matplotlib.pyplot
    return matplotlib.pyplot


def save(figure, path):
    figure.tight_layout()
    figure.savefig(path, dpi=100)
    pyplot().close(figure)


def crack_length(arguments):
    """Temperatures and crack lengths from the table of fix ave/time or the log, and their units as
    the names of the columns tell them."""
    path = arguments.curve or arguments.log
    columns = (lammps_files.averages if arguments.curve else lammps_files.log)(path)
    pairs = [arguments.columns] if arguments.columns else [("temperature", "crack_area"),
                                                           ("f_heat", "c_crack[3]")]
    bare = {lammps_files.quantity(name)[0]: name for name in columns}
    for pair in pairs:
        T, area = (name if name in columns else bare.get(name) for name in pair)
        if T and area:
            units = [lammps_files.UNITS.get(lammps_files.quantity(name)[1], "")
                     for name in (T, area)]
            return columns[T], columns[area] / arguments.thickness, units
    stop(f"{path} has the columns {' '.join(columns)}: say with --columns which of them are "
         "temperature and crack area")


def tell_clusters(arguments, events, x, radius):
    import emissions    # needs scipy, which nothing else here does
    label = emissions.clusters(events.place, x, radius, arguments.clusters)
    count, begin, duration, centre, energy, magnitude = emissions.describe(label, events.place, x,
                                                                           events.energy)
    table(f"{arguments.out}.clusters.csv",
          ("events", arguments.against, "duration", "x", "y", "z", "energy", "magnitude"),
          (count, begin, duration, *centre.T, energy, magnitude))
    found = emissions.b_value(magnitude, arguments.complete)
    print(f"clusters within {radius:g} and {arguments.against} {arguments.clusters:g}: {len(count)}, "
          f"the largest of {count.max()} events and magnitude {magnitude.max():.3g}")
    print("b-value " + (f"{found[0]:.3g} +- {found[1]:.2g} from magnitude {found[2]:.3g} on" if found
                        else "not known: fewer than ten clusters, or all of one magnitude"))
    figure, (left, right) = pyplot().subplots(1, 2, figsize=(9, 4))
    left.scatter(begin, magnitude, s=4 + 40 * (count / count.max()) ** 0.5, color=COLOURS[0], alpha=0.6)
    left.set_xlabel(arguments.against)
    left.set_ylabel("magnitude, log10 of the energy")
    ascending = np.sort(magnitude[np.isfinite(magnitude)])
    right.step(ascending, np.arange(len(ascending), 0, -1), color="black", where="pre")
    if found:
        above = np.count_nonzero(ascending >= found[2])
        span = np.array([found[2], ascending[-1]])
        right.plot(span, above * 10 ** (-found[0] * (span - found[2])), color=COLOURS[1],
                   label=f"b = {found[0]:.2f}")
        right.legend()
    right.set_yscale("log")
    right.set_xlabel("magnitude M")
    right.set_ylabel("clusters of M or more")
    save(figure, f"{arguments.out}.clusters.png")


def tell_front(arguments, events, x):
    import emissions
    start = np.zeros(3)
    start[:len(arguments.front)] = arguments.front
    when, distance = emissions.front(events.place, x, start)
    table(f"{arguments.out}.front.csv", (arguments.against, "distance"), (when, distance))
    draw_curves(f"{arguments.out}.front.png", when, arguments.against, ((None, distance, "black"),),
                "distance of the front")
    speed = emissions.front_speed(when, distance)
    print(f"front {distance[-1]:g} away, " +
          ("at once" if speed is None else f"{speed:.4g} per {arguments.against} in the middle of its way"))


def with_unit(what, unit):
    return f"{what}, {unit}" if unit else what


def main(words):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0],
                                     add_help=False)
    parser.add_argument("events", nargs="?")
    parser.add_argument("--curve")
    parser.add_argument("--log")
    parser.add_argument("--columns", nargs=2)
    parser.add_argument("--thickness", type=float, default=1.0)
    parser.add_argument("--against", choices=("temperature", "time", "step"), default="temperature")
    parser.add_argument("--bins", type=int, default=18)
    parser.add_argument("--radius", type=float)
    parser.add_argument("--clusters", type=float)
    parser.add_argument("--complete", type=float)
    parser.add_argument("--from", dest="front", type=float, nargs="+")
    parser.add_argument("--out")
    parser.add_argument("-h", "--help", action="store_true")
    arguments = parser.parse_args(words)
    if arguments.help or not arguments.events:
        sys.exit(__doc__)
    if arguments.bins < 1:
        stop("--bins must be at least 1")
    if arguments.thickness <= 0 or (arguments.radius is not None and arguments.radius <= 0):
        stop("--thickness and --radius must be above 0")
    if arguments.clusters is not None and arguments.clusters < 0:
        stop("--clusters must not be negative")
    if arguments.complete is not None and arguments.clusters is None:
        stop("--complete is for --clusters: give that too")
    if arguments.front and len(arguments.front) not in (2, 3):
        stop("--from needs two or three coordinates")
    if arguments.curve and arguments.log:
        stop("give --curve or --log, not both")
    arguments.out = arguments.out or str(Path(arguments.events).parent / "cracks")

    events = Events(arguments.events)
    if len(events) == 0:
        stop(f"{arguments.events} has no events: nothing broke")
    radius = arguments.radius or REACH * events.spacing() or np.inf
    edges, counts, directionless, dip = rose(events, radius, arguments.bins)
    table(f"{arguments.out}.rose.csv", ("from_degrees", "to_degrees", "tension", "shear"),
          (edges[:-1], edges[1:], *counts))
    draw_rose(f"{arguments.out}.rose.png", edges, counts)
    if dip is not None:
        tilts = np.linspace(0, 90, 10)
        table(f"{arguments.out}.dip.csv", ("from_degrees", "to_degrees", "events"),
              (tilts[:-1], tilts[1:], np.histogram(dip, tilts)[0]))

    curve = crack_length(arguments) if arguments.curve or arguments.log else None
    x, label = getattr(events, arguments.against), arguments.against
    if curve and label == "temperature":
        label = with_unit(label, curve[2][0])
    order = np.argsort(x, kind="stable")
    total, shear = np.arange(1, len(events) + 1), np.cumsum(events.shear[order])
    table(f"{arguments.out}.events.csv",
          ("events", "tension", "shear", "energy", *COLUMNS[:10], "temperature"),
          (total, total - shear, shear, np.cumsum(events.energy[order]), *events.ids[order].T,
           events.step[order], events.time[order], *events.place[order].T, *events.bond[order].T,
           events.temperature[order]))
    draw_curves(f"{arguments.out}.events.png", x[order], label,
                (("all", total, "black"), ("tension", total - shear, COLOURS[0]),
                 ("shear", shear, COLOURS[1])), "broken bonds")

    print(f"events: {len(events)}, {total[-1] - shear[-1]} in tension, {shear[-1]} in shear")
    print(f"first at {arguments.against} {x.min():g}, last at {x.max():g}; "
          f"energy of the bonds {events.energy.sum():g}")
    print(f"directions within {radius:g}; {directionless} events have none")
    if arguments.clusters is not None:
        tell_clusters(arguments, events, x, radius)
    if arguments.front:
        tell_front(arguments, events, x)
    if curve:
        T, length, (degrees, area) = curve
        table(f"{arguments.out}.length.csv", ("temperature", "length"), (T, length))
        what = (("crack area", area) if events.dimension == 3 else
                ("crack length", area.removesuffix("\u00b2")))
        draw_curves(f"{arguments.out}.length.png", T, with_unit("temperature", degrees),
                    ((None, length, "black"),), with_unit(*what))
        print(f"crack length at the end: {length[-1]:g}")


if __name__ == "__main__":
    main(sys.argv[1:])
