#!/usr/bin/python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Turn a text dump of particles into files of VTK, for ParaView, or into extended XYZ, for ASE.

usage: to_vtk.py DUMP [--bonds BONDS] [--walls WALLS] [--names NAME ...] [--xyz] [--out PREFIX]

Every frame becomes PREFIX.STEP.vtu, and PREFIX.pvd is the series of all with the steps as times
(PREFIX: the name of the dump). Every column becomes a field of the points; columns ux uy, vx vy and
fx fy, with uz, vz and fz if they are there, become the vectors displacement, velocity and force.
Positions are x y z or xu yu zu, 0 where there is none.

--names NAME ...  the names of the columns that are called c_ID[k], f_ID[k] or v_NAME, in their
                  order ('dump_modify ID colname' does the same when the dump is written)
--bonds BONDS     'dump local' of compute tmsph/bond/local, with id1 and id2 as its first columns
                  after index (or named batom1 and batom2), written at the same steps: lines in
                  PREFIX.bonds.STEP.vtu and PREFIX.bonds.pvd
--walls WALLS     'dump local' of compute tmsph/wall/local: lines in 2-D, triangles in 3-D, in
                  PREFIX.walls.STEP.vtu and PREFIX.walls.pvd
--xyz             also all frames in PREFIX.xyz: ASE reads all columns of that by their names, of a
                  dump only those that are not renamed

What doc/output.md shows:
    ./tmsph run examples/disc/in.disc -var bonds yes
    cd examples/disc
    ../../tools/to_vtk.py dump.disc --bonds dump.bonds
"""
import argparse
import base64
import re
import sys

import numpy as np

import lammps_files
from lammps_files import stop

VERTEX, LINE, TRIANGLE = 1, 3, 5    # cell types of VTK
VECTORS = {"displacement": "u{}", "velocity": "v{}", "force": "f{}"}
TYPES = {"f": "Float64", "i": "Int64", "u": "UInt8"}


def array(name, values):
    values = np.ascontiguousarray(values)
    data = values.tobytes()
    size = np.array(len(data), "<u8").tobytes()
    parts = f' NumberOfComponents="{values.shape[1]}"' if values.ndim == 2 else ""
    return (f'<DataArray type="{TYPES[values.dtype.kind]}" Name="{name}"{parts} format="binary">'
            f"{(base64.b64encode(size + data)).decode()}</DataArray>\n")


def grid(path, points, cells, kind, point_data, cell_data):
    """cells: one row of points for each cell."""
    offsets = cells.shape[1] * np.arange(1, len(cells) + 1)
    with lammps_files.opened(path, "w") as file:
        file.write('<?xml version="1.0"?>\n<VTKFile type="UnstructuredGrid" version="1.0" '
                   'byte_order="LittleEndian" header_type="UInt64">\n<UnstructuredGrid>\n'
                   f'<Piece NumberOfPoints="{len(points)}" NumberOfCells="{len(cells)}">\n')
        for tag, fields in (("PointData", point_data), ("CellData", cell_data)):
            file.write(f"<{tag}>\n" + "".join(map(array, fields, fields.values())) + f"</{tag}>\n")
        file.write("<Points>\n" + array("Points", points) + "</Points>\n<Cells>\n"
                   + array("connectivity", cells.astype("<i8").ravel())
                   + array("offsets", offsets.astype("<i8"))
                   + array("types", np.full(len(cells), kind, "u1"))
                   + "</Cells>\n</Piece>\n</UnstructuredGrid>\n</VTKFile>\n")


def series(path, files):
    with lammps_files.opened(path, "w") as file:
        file.write('<?xml version="1.0"?>\n<VTKFile type="Collection" version="1.0">\n'
                   '<Collection>\n')
        for step, name in files:
            file.write(f'<DataSet timestep="{step}" part="0" file="{name}"/>\n')
        file.write("</Collection>\n</VTKFile>\n")


def stacked(columns, names):
    """Columns side by side, the third as zeros if it is missing; None without the first two."""
    if not all(name in columns for name in names[:2]):
        return None
    return np.stack([columns.get(name, np.zeros_like(columns[names[0]])) for name in names], axis=1)


def fields(columns):
    """What goes to the points: vectors put together, whole numbers as such."""
    out, rest = {}, dict(columns)
    for name, letters in VECTORS.items():
        names = [letters.format(axis) for axis in "xyz"]
        vector = stacked(columns, names)
        if vector is not None and name not in columns:
            out[name] = vector
            for part in names:
                rest.pop(part, None)
    for name, column in rest.items():
        out[name] = column.astype("<i8") if name in ("id", "type", "mol") else column.astype("<f8")
    return out


def renamed(names, given, path):
    """The names of the columns, the given ones for those of computes, fixes and variables."""
    ours = [k for k, name in enumerate(names) if re.match(r"[cfv]_", name)]
    if given is None:
        return list(names)
    if len(given) != len(ours):
        stop(f"{path} has {len(ours)} columns of computes, fixes and variables "
             f"({' '.join(names[k] for k in ours)}), --names gives {len(given)}")
    names = list(names)
    for k, name in zip(ours, given):
        names[k] = name
    return names


def particles(path, given):
    """(step, ids, points, fields) of each frame, particles in order of their ids."""
    for step, kind, names, table in lammps_files.frames(path):
        if kind != "ATOMS":
            stop(f"{path} is not a dump of particles: its rows are {kind}; give it with --bonds")
        names = renamed(names, given, path)
        columns = dict(zip(names, table.T))
        if "id" not in columns:
            stop(f"{path} has no column id")
        order = np.argsort(columns["id"])
        columns = {name: column[order] for name, column in columns.items()}
        for position in (["x", "y", "z"], ["xu", "yu", "zu"]):
            points = stacked(columns, position)
            if points is not None:
                break
        else:
            stop(f"{path} has no columns x y or xu yu")
        left = {name: column for name, column in columns.items() if name not in position}
        yield step, columns["id"], points.astype("<f8"), fields(left)


def bonds(path, known):
    """(step, points, rows of two points, fields) of each frame; known: ids and points by step."""
    for step, kind, names, table in lammps_files.frames(path):
        if kind == "ATOMS":
            stop(f"{path} is a dump of particles, not of bonds")
        ours = [k for k, name in enumerate(names)
                if name.startswith("c_") or (name != "index" and "batom1" in names)]
        if len(ours) < 2:
            stop(f"{path} has no columns of compute tmsph/bond/local with id1 and id2, or batom1 and "
                 "batom2")
        if step not in known:
            continue
        ids, points = known[step]
        pairs = table[:, ours[:2]]
        if not np.isin(pairs, ids).all():
            stop(f"{path}: columns {names[ours[0]]} and {names[ours[1]]} are not ids of particles: "
                 "they must be id1 and id2 of compute tmsph/bond/local")
        data = {names[k]: table[:, k].astype("<f8") for k in ours[2:]}
        if len(ours) > 2 and np.isin(table[:, ours[2]], (0, 1, 2)).all():
            data = {"state": data.pop(names[ours[2]]), **data}
        yield step, points, np.searchsorted(ids, pairs), data


def walls(path):
    """(step, points, rows of two or three points, fields) of each frame."""
    for step, _, names, table in lammps_files.frames(path):
        table = table[:, [k for k, name in enumerate(names) if name != "index"]]
        if table.shape[1] not in (7, 10):
            stop(f"{path} has not the 7 or 10 columns of compute tmsph/wall/local")
        corners = (table.shape[1] - 1) // 3
        points = np.ascontiguousarray(table[:, 1:]).reshape(-1, 3).astype("<f8")
        yield (step, points, np.arange(len(points)).reshape(-1, corners),
               {"wall": table[:, 0].astype("<i8")})


def write_xyz(file, step, points, data):
    """A frame of extended XYZ; species have no element."""
    columns = {re.sub(r"\W", "_", name): column for name, column in data.items()}
    kinds = [f"{name}:{'I' if column.dtype.kind == 'i' else 'R'}:{int(np.prod(column.shape[1:]))}"
             for name, column in columns.items()]
    file.write(f"{len(points)}\nProperties=species:S:1:pos:R:3:{':'.join(kinds)} step={step}\n")
    for k, point in enumerate(points):
        values = [*point, *(value for column in columns.values() for value in np.atleast_1d(column[k]))]
        file.write("X " + " ".join(f"{value:.17g}" for value in values) + "\n")


def main(words):
    parser = argparse.ArgumentParser(usage=__doc__.split("usage: ")[1].split("\n")[0],
                                     add_help=False)
    parser.add_argument("dump", nargs="?")
    parser.add_argument("--bonds")
    parser.add_argument("--walls")
    parser.add_argument("--xyz", action="store_true")
    parser.add_argument("--names", nargs="+")
    parser.add_argument("--out")
    parser.add_argument("-h", "--help", action="store_true")
    arguments = parser.parse_args(words)
    if arguments.help or not arguments.dump:
        sys.exit(__doc__)
    prefix, files, known = arguments.out or arguments.dump, [], {}
    short = prefix.rsplit("/", 1)[-1]
    xyz = lammps_files.opened(f"{prefix}.xyz", "w") if arguments.xyz else None
    for step, ids, points, data in particles(arguments.dump, arguments.names):
        grid(f"{prefix}.{step}.vtu", points, np.arange(len(points))[:, None], VERTEX, data, {})
        files.append((step, f"{short}.{step}.vtu"))
        if xyz:
            write_xyz(xyz, step, points, data)
        if arguments.bonds:
            known[step] = ids, points
    if not files:
        stop(f"{arguments.dump} breaks off within its first frame")
    series(f"{prefix}.pvd", files)
    print(f"{len(files)} frames in {prefix}.pvd")
    if xyz:
        xyz.close()
    for what, path, cells in (("bonds", arguments.bonds, lambda path: bonds(path, known)),
                              ("walls", arguments.walls, walls)):
        if not path:
            continue
        lines = []
        for step, points, rows, data in cells(path):
            kind = LINE if rows.shape[1] == 2 else TRIANGLE
            grid(f"{prefix}.{what}.{step}.vtu", points, rows, kind, {}, data)
            lines.append((step, f"{short}.{what}.{step}.vtu"))
        if not lines:
            stop(f"{path} has none of the steps of {arguments.dump}")
        series(f"{prefix}.{what}.pvd", lines)
        print(f"{len(lines)} frames in {prefix}.{what}.pvd")


if __name__ == "__main__":
    main(sys.argv[1:])
