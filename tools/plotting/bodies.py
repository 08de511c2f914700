# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Frames of a dump of particles as bodies to be drawn, walls beside them, and units for both."""
import numpy as np

import lammps_files
from lammps_files import stop

FIELDS = ("damage", "temperature", "displacement", "s1", "s3")    # drawn if nothing is asked for
LONG = {"damage": "damage: share of broken bonds", "temperature": "temperature",
        "displacement": "displacement", "s1": "largest principal stress, tension positive",
        "s3": "smallest principal stress, tension positive",
        "strength": "uniaxial compressive strength",
        "hoop": "hoop stress, tension positive", "radial": "radial stress, tension positive",
        "vonmises": "equivalent stress of von Mises", "smean": "mean stress, tension positive",
        **{f"s{ab}": f"stress {ab}, tension positive" for ab in "xx yy zz xy xz yz".split()}}
UNIT = {**{name: "Pa" for name in LONG if "stress" in LONG[name] or name == "strength"},
        **{name: "m" for name in ("displacement", "ux", "uy", "uz", "x0", "y0", "z0", "radius")},
        **{name: "m/s" for name in ("vx", "vy", "vz")}}
PREFIXES = ((1e9, "G"), (1e6, "M"), (1e3, "k"), (1.0, ""), (1e-3, "m"), (1e-6, "\u00b5"),
            (1e-9, "n"))
BASE = {"mm": ("m", 1e-3), "ms": ("s", 1e-3), "MPa": ("Pa", 1e6), "kN": ("N", 1e3)}
AREAS = ((1.0, "m\u00b2"), (1e-4, "cm\u00b2"), (1e-6, "mm\u00b2"))


def scaled(unit, largest):
    """(factor, unit) that brings values in this unit to readable numbers."""
    if unit in BASE:
        base, size = BASE[unit]
        factor, unit = scaled(base, largest * size)
        return factor * size, unit
    shown = lammps_files.UNITS.get(unit, unit)
    if unit == "m2":
        return next(((1 / size, name) for size, name in AREAS if largest >= size),
                    (1e6, AREAS[-1][1]))
    if unit not in ("m", "Pa", "N", "J", "W", "N_per_m", "J_per_m", "s") or not largest > 0:
        return 1.0, shown
    for size, prefix in PREFIXES:
        if largest >= size and not (prefix in "GMk" and prefix and unit in ("m", "s")):
            return 1 / size, prefix + shown
    return 1e9, "n" + shown


class Body:
    """The particles of one frame."""

    def __init__(self, step, names, table):
        self.step, self.columns = step, dict(zip(names, table.T))
        for place in (("x", "y", "z"), ("xu", "yu", "zu")):
            if place[0] in self.columns and place[1] in self.columns:
                break
        else:
            stop("a dump of particles has no columns x y or xu yu")
        if len(table) == 0:
            stop(f"no particles are left at step {step}")
        nothing = np.zeros(len(table))
        self.X = np.stack([self.columns.get(name, nothing) for name in place], axis=1)
        self.u = np.stack([self.columns.get(name, nothing) for name in ("ux", "uy", "uz")], axis=1)
        self.dimension = 3 if np.ptp(self.X[:, 2]) > 0 else 2
        if "ux" in self.columns:
            self.columns["displacement"] = np.linalg.norm(self.u, axis=1)
        self.radius = self.columns.get("radius")
        if self.radius is None or not self.radius.all():
            from scipy.spatial import cKDTree
            nearest = cKDTree(self.X).query(self.X, 2)[0][:, 1]
            self.radius = np.full(len(table), 0.5 * np.median(nearest))
        if not np.isfinite(self.places(1)).all() or not np.isfinite(self.radius).all():
            stop(f"particles without a place or a radius at step {step}: dump x y z and radius")

    def places(self, magnify):
        return self.X + (magnify - 1) * self.u


def steps(path):
    """The steps of the complete frames of a dump of particles; nothing if it is another file."""
    if not lammps_files.is_dump(path):
        return []
    found = []
    for step, kind, _, _ in lammps_files.complete(path):
        if kind != "ATOMS":
            return []
        found.append(step)
    return found


def bodies(path, wanted):
    """The frames of these steps, each once."""
    found = {step: Body(step, names, table)
             for step, _, names, table in lammps_files.frames(path, wanted)}
    return [found[step] for step in wanted if step in found]


def walls(folder):
    """Corners of the pieces of all walls, by step: arrays of pieces by corners by 3."""
    found = {}
    for path in filter(lammps_files.is_dump, sorted(folder.glob("dump.walls*"))):
        for step, _, names, table in lammps_files.frames(path):
            table = table[:, [k for k, name in enumerate(names) if name != "index"]]
            if table.shape[1] not in (7, 10):
                stop(f"{path} has not the 7 or 10 columns of compute tmsph/wall/local")
            found.setdefault(step, []).extend(table[:, 1:].reshape(len(table), -1, 3))
    return found


def lines(pieces, axis, at):
    """What is seen of the pieces in 2-D, or in a section of a 3-D body: pairs of points."""
    for piece in pieces:
        if len(piece) == 2:
            yield piece
            continue
        height = piece[:, axis] - at
        cut = [piece[a] + height[a] / (height[a] - height[b]) * (piece[b] - piece[a])
               for a, b in ((0, 1), (1, 2), (2, 0)) if height[a] * height[b] < 0]
        if len(cut) == 2:
            yield np.array(cut)
