#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Pictures of what a run left in a folder: maps of the fields, curves of the tables, energies of
the log, directions and numbers of the break events.

usage: plot.py FOLDER [options]            (./tmsph plot FOLDER [options] does the same)

Written are, in the folder:
  plot.FIELD.png               a map of each field in the last frame of dump.*, beside walls; with
                               several dumps plot.DUMP.FIELD.png
  plot.TABLE.png               curves of TABLE.txt, a table of fix ave/time or a profile of
                               fix ave/chunk; beside exact ones, if TABLE.exact.txt has any
  plot.energy.png              energies of log.lammps, columns whose names end with _J
  plot.rose.png, plot.events.png   directions and cumulative number of the events in events.txt
  plot.movie.mp4               with --movie, where ffmpeg is installed

options:
  --field NAME ...    columns of the dump, or displacement (default: damage, temperature,
                      displacement, s1 and s3, those which the dump has and which are not the same
                      everywhere)
  --step N ...        draw the frames nearest to these steps, side by side (default: the last)
  --magnify M         draw displacements M times as large
  --section AXIS[=A]  of a 3-D body: across the axis x, y or z, at A m (default: z, in the middle)
  --range=LOW:HIGH    of the colours, in the units of the dump
  --movie             all frames of the first field as a movie
  --maps              maps only
  --out PREFIX        (default FOLDER/plot)

A column of a dump is a length, stress or velocity by its name, in the units si. Columns of tables
are called by what they hold and its unit, such as crack_area_m2. In a table the first column, or
the second if the first is the step, is drawn against all others, and it is the title of maps at its
steps.
"""
import argparse
import re
import sys
from pathlib import Path

try:
    import matplotlib
    import scipy    # noqa: F401, for the maps
except ImportError as missing:
    sys.exit(f"plot.py: {missing}: install python3-matplotlib and python3-scipy")
matplotlib.use("Agg")

import numpy as np

import cracks
import lammps_files
from lammps_files import stop
from plotting import bodies, curves, maps

BINS = 18              # of the rose over 180 degrees
EXACT = ".exact"       # behind the name of a table


def files(folder, pattern):
    return [path for path in sorted(folder.glob(pattern)) if path.is_file()]


def tables(folder):
    """Columns by name of each table of fix ave/time, and its remark."""
    found = {}
    for path in files(folder, "*.txt"):
        with lammps_files.opened(path) as file:
            first = file.readline().split()
            remark = row = file.readline()
            if first[:2] == ["#", "Time-averaged"]:    # without title1: names by LAMMPS
                first, remark = remark.lstrip("# ").split(), ""
            while row.startswith("#"):
                row = file.readline()
        row = row.split()
        named = first[:1] == ["TimeStep"] or all(word.isidentifier() for word in first)
        if len(row) == len(first) > 1 and named and all(map(lammps_files.is_number, row)):
            columns = lammps_files.averages(path)
            found[path.stem] = ({name.replace("TimeStep", "step"): columns[name]
                                 for name in columns},
                                remark.lstrip("# ").strip() if remark.startswith("#") else "")
    return found


def about(folder):
    """The folder and what the only input in it says of itself in its first words."""
    inputs, words = files(folder, "in.*"), []
    name = folder.resolve().name
    inputs = [path for path in inputs if path.name == f"in.{name}"] or inputs
    if len(inputs) == 1:
        for line in inputs[0].read_text(errors="replace").splitlines():
            if not line.startswith("# ") or (words and words[-1].endswith((".", ":"))):
                break
            words += re.split(r"(?<=[.:])\s", line[2:].strip())[:1]
    return f"{name}: {' '.join(words).rstrip('.:')}" if words else name


class Titles:
    """What a table says about steps: its first column after the step."""

    def __init__(self, folder, known):
        self.table = next((columns for columns, _ in known.values() if "step" in columns
                           and len(columns) > 1), None)
        names = [name for columns, _ in known.values() for name in columns]
        names += [name for path in files(folder, "profile*.txt")
                  for name in lammps_files.profiles(path)[0]]
        units = [lammps_files.quantity(name)[1] for name in names]
        self.degrees = next((unit for unit in units if unit in ("C", "K")), "")

    def of(self, step):
        if self.table is None:
            return f"step {step}"
        name = next(name for name in self.table if name != "step")
        steps = self.table["step"]
        value = np.interp(step, steps, self.table[name])
        what, unit = lammps_files.quantity(name)
        factor, unit = bodies.scaled(unit, np.abs(self.table[name]).max())
        if abs(value) < 1e-3 * np.abs(self.table[name]).max():
            value = 0.0
        return f"{curves.text(what)} {value * factor:.4g} {unit}".strip() + f"\nstep {step}"


def chosen_fields(arguments, shown, path):
    """Those asked for, or all usual ones that differ from place to place."""
    have = shown[-1].columns
    if not arguments.field:
        return [field for field in bodies.FIELDS if field in have
                and any(np.ptp(body.columns[field]) > 1e-9 * np.abs(body.columns[field]).max()
                        for body in shown)]
    for field in arguments.field:
        if field not in have:
            stop(f"{path} has no column {field}: give one of {' '.join(have)}")
    return arguments.field


def draw_maps(folder, path, name, arguments, titles):
    steps = bodies.steps(path)
    wanted = []
    for step in arguments.step or steps[-1:]:
        if not min(steps) <= step <= max(steps):
            stop(f"{path} has no step {step}: its frames are of steps {min(steps)} to {max(steps)}")
        wanted.append(min(steps, key=lambda known: abs(known - step)))
    shown, walls = bodies.bodies(path, wanted), bodies.walls(folder)
    view = maps.View(shown, arguments.magnify, arguments.section)
    caption = about(folder) + (f"; {name}" if name else "")
    if shown[0].dimension == 3:
        caption += f"; section across {'xyz'[view.axis]} at {view.at:.3g} m"
    if arguments.magnify != 1:
        caption += f", displacements drawn {arguments.magnify:g} times as large"
    if walls:
        caption += "; grey: walls"

    def drawing(field, view, shown):
        unit = bodies.UNIT.get(field, titles.degrees if field == "temperature" else "")
        low, high, colours = maps.limits(field, np.concatenate([b.columns[field] for b in shown]))
        if arguments.range:
            low, high = arguments.range
        return (view, shown, field, (low, high, colours), unit, [titles.of(b.step) for b in shown],
                caption, walls)

    fields = chosen_fields(arguments, shown, path)
    have = list(shown[-1].columns)
    if not fields and not set(bodies.FIELDS) & set(have):
        print(f"no maps of {path}: it has none of the columns {' '.join(bodies.FIELDS)}; name them "
              f"by dump_modify colname, or give --field with some of {' '.join(have)}")
    elif not fields:
        print(f"no maps of {path}: its fields are the same everywhere; name some with --field")
    for field in fields:
        maps.draw_map(f"{arguments.out}.{field}.png", *drawing(field, view, shown))
    if arguments.movie and fields:
        shown = bodies.bodies(path, steps)
        view = maps.View(shown, arguments.magnify, arguments.section)
        maps.draw_movie(f"{arguments.out}.movie.mp4", *drawing(fields[0], view, shown))


def draw_events(path, out, degrees):
    """The rose and the numbers, against the temperature, or time where that is the same."""
    if not lammps_files.is_dump(path):
        return
    events = cracks.Events(path)
    if len(events) < 2:
        return
    radius = cracks.REACH * events.spacing() or np.inf
    edges, counts, _, _ = cracks.rose(events, radius, BINS)
    cracks.draw_rose(f"{out}.rose.png", edges, counts)
    print(f"{out}.rose.png")
    heated = np.ptp(events.temperature) > 0
    name = f"temperature_{degrees}".rstrip("_") if heated else "time_s"
    x = events.temperature if heated else events.time
    order = np.argsort(x, kind="stable")
    shear = np.cumsum(events.shear[order])
    total = np.arange(1, len(x) + 1)
    curves.draw_curves(f"{out}.events.png",
                       {name: x[order], "all_broken_bonds": total, "in_tension": total - shear,
                        "in_shear": shear,
                        "energy_of_the_bonds_J": np.cumsum(events.energy[order])},
                       "break events, added up")


def draw_tables(folder, out, known):
    title = folder.resolve().name
    for name, (columns, remark) in known.items():
        if name.endswith(EXACT) and name.removesuffix(EXACT) in known:
            continue
        exact, _ = known.get(name + EXACT, ({}, ""))
        curves.draw_curves(f"{out}.{name}.png", columns,
                           f"{title}, {name}.txt" + (f"\n{remark}" if remark else ""), exact)
    for path in files(folder, "profile*.txt"):
        names, found = lammps_files.profiles(path)
        curves.draw_profiles(f"{out}.{path.stem}.png", names, found, f"{title}, {path.name}")
    log = folder / "log.lammps"
    if log.exists() and re.search(r"\n   Step .*\n *\d+ ", log.read_text(errors="replace")):
        columns = lammps_files.log(log)
        first = next(name for name in columns if name != "Step")
        energies = {name: column for name, column in columns.items() if name.endswith("_J")}
        if energies and first not in energies:
            curves.draw_curves(f"{out}.energy.png", {first: columns[first], **energies},
                               f"{title}, energies")


def main(words):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0],
                                     add_help=False)
    parser.add_argument("folder", nargs="?")
    parser.add_argument("--field", nargs="+")
    parser.add_argument("--step", nargs="+", type=int)
    parser.add_argument("--magnify", type=float, default=1.0)
    parser.add_argument("--section")
    parser.add_argument("--range")
    parser.add_argument("--movie", action="store_true")
    parser.add_argument("--maps", action="store_true")
    parser.add_argument("--out")
    parser.add_argument("-h", "--help", action="store_true")
    arguments = parser.parse_args(words)
    if arguments.help or not arguments.folder:
        sys.exit(__doc__)
    folder = Path(arguments.folder)
    if not folder.is_dir():
        stop(f"there is no folder {folder}")
    if not np.isfinite(arguments.magnify):
        stop(f"--magnify {arguments.magnify}: give a number")
    if arguments.section:
        axis, _, at = arguments.section.partition("=")
        if axis not in ("x", "y", "z") or (at and not lammps_files.is_number(at)):
            stop(f"--section {arguments.section}: give x, y or z, with =VALUE behind it or not")
    if arguments.range:
        low, _, high = arguments.range.partition(":")
        numbers = lammps_files.is_number(low) and lammps_files.is_number(high)
        if not numbers or float(low) >= float(high):
            stop(f"--range={arguments.range}: give LOW:HIGH, such as --range=-1e7:1e7")
        arguments.range = float(low), float(high)
    arguments.out = arguments.out or str(folder / "plot")
    known = tables(folder)
    dumps = [path for path in files(folder, "dump.*") if bodies.steps(path)]
    events = folder / "events.txt"
    if not dumps and not known and not events.exists():
        stop(f"{folder} has no dump.* with a complete frame of particles, no table *.txt and no "
             "events.txt: run an input there")
    titles, out = Titles(folder, known), arguments.out
    for path in dumps:
        name = path.name[len("dump."):] if len(dumps) > 1 else ""
        arguments.out = f"{out}.{name}" if name else out
        draw_maps(folder, path, name, arguments, titles)
    if not arguments.maps:
        draw_tables(folder, out, known)
        if events.exists():
            draw_events(events, out, titles.degrees)


if __name__ == "__main__":
    main(sys.argv[1:])
