# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Reading what LAMMPS writes, for the tools: text dumps, tables of fix ave/time and ave/chunk, logs.
Columns of tables are called by what they hold and its unit, as crack_area_m2."""
import sys

import numpy as np


# how units are written in names of columns, and how in pictures
UNITS = {"C": "\u00b0C", "percent": "%", "%": "%", "m2": "m\u00b2", "N_per_m": "N/m", "J_per_m": "J/m",
         "m_per_s": "m/s", "J_per_m2": "J/m\u00b2", "Nm": "N m",
         **{unit: unit for unit in "K s ms min h mm m Pa MPa N kN J W m/s".split()}}


def stop(message):
    sys.exit(f"{sys.argv[0].rsplit('/', 1)[-1]}: {message}")


def opened(path, mode="r"):
    try:
        return open(path, mode, errors="replace")
    except OSError as error:
        stop(f"cannot {'read' if mode == 'r' else 'write'} {path}: {error.strerror}")


def is_dump(path):
    with opened(path) as file:
        return file.readline().startswith("ITEM:")


def complete(path):
    """(step, kind, names, rows of text) of each frame of a text dump that was written to its end: the
    last one of a run that goes on, or was killed, may not be."""
    with opened(path) as file:
        line = file.readline()
        if not line.startswith("ITEM:"):
            stop(f"{path} is not a text dump of LAMMPS: its first line is not 'ITEM: ...'" if line else
                 f"{path} is empty")
        step = count = None
        try:
            while line.endswith("\n"):
                if line.startswith("ITEM: TIMESTEP"):
                    step = int(file.readline())
                elif line.startswith("ITEM: NUMBER OF"):
                    count = int(file.readline())
                elif line.startswith(("ITEM: BOX", "ITEM: UNITS", "ITEM: TIME")):
                    for _ in range(3 if line.startswith("ITEM: BOX") else 1):
                        file.readline()
                else:
                    kind, *names = line.split()[1:]
                    rows = [file.readline() for _ in range(count)]
                    if rows and not rows[-1].endswith("\n"):
                        break
                    yield step, kind, names, rows
                line = file.readline()
        except (ValueError, TypeError):    # of numbers that are none, or lacking
            if file.readline():
                stop(f"{path} is broken after the frame of step {step}")


def frames(path, wanted=None):
    """(step, kind, names, table) of each complete frame of a text dump, or of those of the wanted
    steps; kind is ATOMS, ENTRIES or whatever the label of the rows is."""
    for step, kind, names, rows in complete(path):
        if wanted is not None and step not in wanted:
            continue
        rows = [row.split() for row in rows]
        if any(len(row) != len(names) for row in rows):
            stop(f"{path} has rows of another length than its {len(names)} columns at step {step}")
        try:
            table = np.array(rows, float).reshape(len(rows), len(names))
        except ValueError:
            stop(f"{path} has words among its numbers: dump columns with numbers only")
        yield step, kind, names, table


def quantity(name):
    """What a column holds, and its unit as in UNITS or nothing: crack_area_m2 is (crack_area, m2)."""
    parts = name.split("_")
    for k in range(1, len(parts)):
        if "_".join(parts[k:]) in UNITS:
            return "_".join(parts[:k]), "_".join(parts[k:])
    return name, ""


def averages(path):
    """Columns by name of a table of fix ave/time. The names are its first line if that is neither
    a remark nor numbers, else the last line with # before the data. A last line that was not written
    to its end is left out."""
    names, remark, rows = None, None, []
    with opened(path) as file:
        for line in file:
            if line.startswith("#"):
                remark = line[1:].split()
            elif line.strip() and line.endswith("\n"):
                rows.append(line.split())
    if rows and not is_number(rows[0][0]):
        names, rows = rows[0], rows[1:]
    names = names or remark
    if not names or not rows or any(len(row) != len(names) for row in rows):
        stop(f"{path} is not a table of fix ave/time with a name for each column in its first line, or "
             "in its last # line")
    try:
        return dict(zip(names, np.array(rows, float).T))
    except ValueError:
        stop(f"{path} has words among its numbers")


def is_number(word):
    try:
        float(word)
    except ValueError:
        return False
    return True


def profiles(path):
    """Names of the columns and, for each step, (step, rows) of a table of fix ave/chunk."""
    with opened(path) as file:
        lines = [line for line in file if line.endswith("\n")]
    remarks = [line for line in lines if line.startswith("#")]
    names = remarks[-1][1:].split() if remarks else []
    words = [line.split() for line in lines if line.strip() and not line.startswith("#")]
    found, k = [], 0
    try:
        while k < len(words):
            step, count, *_ = words[k]
            if k + int(count) >= len(words):    # not written to its end
                break
            rows = np.array(words[k + 1: k + 1 + int(count)], float)
            found.append((int(step), rows.reshape(int(count), len(names))))
            k += 1 + int(count)
    except ValueError:
        stop(f"{path} is not a table of fix ave/chunk with a name for each column in its last # line")
    return names, found


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
