# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Reading what LAMMPS writes, for the tools: text dumps, tables of fix ave/time, logs."""
import sys

import numpy as np


def stop(message):
    sys.exit(f"{sys.argv[0].rsplit('/', 1)[-1]}: {message}")


def opened(path):
    try:
        return open(path, errors="replace")
    except OSError as error:
        stop(f"cannot read {path}: {error.strerror}")


def frames(path):
    """(step, kind, names, table) of each frame of a text dump; kind is ATOMS, ENTRIES or whatever
    the label of the rows is."""
    with opened(path) as file:
        line = file.readline()
        if not line.startswith("ITEM:"):
            stop(f"{path} is not a text dump of LAMMPS: its first line is not 'ITEM: ...'")
        while line:
            if line.startswith("ITEM: TIMESTEP"):
                step = int(file.readline())
            elif line.startswith("ITEM: NUMBER OF"):
                count = int(file.readline())
            elif line.startswith(("ITEM: BOX", "ITEM: UNITS", "ITEM: TIME")):
                for _ in range(3 if line.startswith("ITEM: BOX") else 1):
                    file.readline()
            else:
                kind, *names = line.split()[1:]
                rows = [file.readline().split() for _ in range(count)]
                if any(len(row) != len(names) for row in rows):
                    stop(f"{path} ends or breaks off in the frame of step {step}")
                try:
                    table = np.array(rows, float).reshape(count, len(names))
                except ValueError:
                    stop(f"{path} has words among its numbers: dump columns with numbers only")
                yield step, kind, names, table
            line = file.readline()


def averages(path):
    """Columns by name of a table of fix ave/time: the last line with # before the data has the
    names."""
    names, rows = None, []
    with opened(path) as file:
        for line in file:
            if line.startswith("#"):
                names = line[1:].split()
            elif line.strip():
                rows.append(line.split())
    if not names or not rows or any(len(row) != len(names) for row in rows):
        stop(f"{path} is not a table of fix ave/time with a value for each name in its last # line")
    try:
        return dict(zip(names, np.array(rows, float).T))
    except ValueError:
        stop(f"{path} has words among its numbers")


def log(path):
    """Columns by name of the thermodynamic output of a log with 'thermo_modify line one', those
    of all runs together as far as their columns are the same."""
    names, rows, inside = None, [], False
    with opened(path) as file:
        for line in file:
            words = line.split()
            if words[:1] == ["Step"]:
                if names and words != names:
                    rows = []
                names, inside = words, True
            elif inside:
                try:
                    values = [float(word) for word in words]
                except ValueError:
                    values = []
                if len(values) == len(names):
                    if not rows or values[0] != rows[-1][0]:    # a run starts where one ended
                        rows.append(values)
                elif not line.startswith("WARNING"):
                    inside = False
    if not rows:
        stop(f"{path} has no thermodynamic output in columns: use 'thermo_modify line one'")
    return dict(zip(names, np.array(rows).T))
