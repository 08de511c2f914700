# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""tools/plot.py on a coarse examples/uniaxial: the pictures are there, small, and show both
platens; each pixel of a map has the value of the nearest particle, a body has its area, a section
through a wall of triangles its line; wrong folders, steps and columns are told in one line."""

import atexit
import re
import shutil
import subprocess
import sys
import tempfile
from functools import cache
from pathlib import Path

import numpy as np

from tmsph_testing import Script, main, read_dump

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))
import matplotlib

matplotlib.use("Agg")
from matplotlib import pyplot as plt
from plotting import bodies, maps

EXAMPLE = ("examples/uniaxial/in.uniaxial", "potentials/granite.tmsph")    # it includes the second
GREY = 105             # of walls
LARGEST = 150_000      # bytes of a picture


@cache
def folder():
    """A temporary one, for all cases."""
    place = Path(tempfile.mkdtemp(prefix="tmsph-"))
    atexit.register(shutil.rmtree, place)
    return place


def plot(*words, fails=False):
    done = subprocess.run([sys.executable, ROOT / "tools/plot.py", *map(str, words)], text=True,
                          capture_output=True)
    if (done.returncode != 0) != fails:
        raise RuntimeError(f"plot.py {words}: {done.stdout}{done.stderr}")
    return done.stderr if fails else done.stdout


@cache
def example():
    """Runs it; its files are in the folder."""
    scene = Script("variable dx index 2.5e-3\nlog log.lammps\nshell cd examples/uniaxial\n"
                   "include in.uniaxial\nshell cd ../..\nlog none",
                   {name: (ROOT / name).read_text() for name in EXAMPLE})
    run = scene.run(keep="examples/uniaxial/*")
    for name, data in run.kept.items():
        (folder() / name).write_bytes(data)
    (folder() / "log.lammps").write_text(run.log)


def pictures(report):
    example()
    out = plot(folder(), "--magnify", 20)
    names = ["damage", "displacement", "s1", "s3", "load", "energy"]
    report.true("pictures",
                set(out.split()) == {str(folder() / f"plot.{name}.png") for name in names},
                f"{len(names)}")
    for name in names:
        path = folder() / f"plot.{name}.png"
        picture = plt.imread(path)
        report.true(f"{name}: a picture with more than lines", path.stat().st_size < LARGEST
                    and min(picture.shape[:2]) > 200
                    and len(np.unique(picture.reshape(-1, picture.shape[2]), axis=0)) > 10,
                    f"{path.stat().st_size} bytes")
    picture = (255 * plt.imread(folder() / "plot.s1.png")[..., :3]).round()
    grey = (np.abs(picture - GREY) < 8).all(axis=2).sum(axis=1) > 0.3 * picture.shape[1]
    report.true("platens in the map", np.count_nonzero(np.diff(grey.astype(int)) == 1) == 2, "two")
    plot(folder(), "--maps", "--field", "damage", "--step", 0, 2000, "--out", folder() / "two")
    one, two = (plt.imread(folder() / name).shape[1]
                for name in ("plot.damage.png", "two.damage.png"))
    report.above("two steps side by side: width over that of one", two / one, 1.3)


def walls_for_paraview(report):
    example()
    command = [sys.executable, ROOT / "tools/to_vtk.py", folder() / "dump.uniaxial", "--walls",
               folder() / "dump.walls", "--out", folder() / "vtk"]
    subprocess.run(command, check=True, capture_output=True)
    listed = re.findall(r'file="(.*?)"', (folder() / "vtk.walls.pvd").read_text())
    sizes = {re.search(r'NumberOfPoints="(\d+)" NumberOfCells="(\d+)"',
                       (folder() / name).read_text()).groups()
             for name in listed}
    report.true("walls for ParaView: two lines in each frame",
                sizes == {("4", "2")} and len(listed) == len(read_dump(folder() / "dump.uniaxial")),
                f"{len(listed)}")


def body(X, u=0.0, **columns):
    names = ["id", "x", "y", "z", "ux", "radius", *columns]
    ids = np.arange(1, len(X) + 1)
    table = [ids, *X.T, np.full(len(X), u), np.full(len(X), 0.5), *columns.values()]
    return bodies.Body(0, names, np.stack(table, axis=1))


def pixels(report):
    """A square lattice of spacing 1 and a cubic one: owners of pixels are the nearest particles."""
    X = np.array([[i, j, 0.0] for i in range(8) for j in range(6)])
    for what, X, section in (("plane", X, None),
                             ("cube", np.vstack([X + [0, 0, k] for k in range(5)]), "z=1.2")):
        shown = body(X)
        view = maps.View([shown], 1.0, section)
        owner = view.owners(shown)
        size = (view.high - view.low).max() / maps.PIXELS
        report.within(f"{what}: area of all pixels over that of the body",
                      np.count_nonzero(owner >= 0) * size**2 / 48, 0.95, 1.3)
        row, column = np.nonzero(owner >= 0)
        place = view.low + (np.stack([column, row], axis=1) + 0.5) * size
        report.below(f"{what}: farthest pixel from its particle in x or y",
                     np.abs(place - X[owner[row, column], :2]).max(), 0.75)
        if section:
            report.true(f"{what}: layer", set(X[owner[owner >= 0], 2]) == {1.0}, "the nearest")
    view = maps.View([body(X, u=0.5)], 3.0, None)
    report.below("magnified: the view goes along", abs(view.low[0] - (-0.5 * maps.NEAR + 1.0)),
                 1e-9)


def units(report):
    triangle = np.array([[0, 0, -1], [0, 0, 3], [4, 0, 3.0]])
    cut = np.array(sorted(map(list, next(bodies.lines([triangle], 2, 1.0)))))
    report.true("section of a wall", np.allclose(cut, [[0, 0, 1], [2, 0, 1]]), "a line")
    found = [bodies.scaled(unit, largest) for unit, largest in
             (("m", 0.002), ("m", 30), ("m", 4000), ("Pa", 3e7), ("m2", 3e-5), ("C", 200),
              ("", 9e9))]
    right = [(1e3, "mm"), (1, "m"), (1, "m"), (1e-6, "MPa"), (1e6, "mm\u00b2"), (1, "\u00b0C"),
             (1, "")]
    report.true("units",
                all(abs(a / b - 1) < 1e-12 and x == y for (a, x), (b, y) in zip(found, right)),
                " ".join(unit for _, unit in found))


def unfinished(report):
    """Beside a dump of a run that goes on: torn anywhere in its last frame, that one is left out;
    and a table, a log, a profile that have begun, a text and an input without a title do no
    harm."""
    place = folder() / "unfinished it is"
    place.mkdir()
    frame = ("ITEM: TIMESTEP\n{}\nITEM: NUMBER OF ATOMS\n3\nITEM: BOX BOUNDS ss ss pp\n"
             + 3 * "0 1\n" + "ITEM: ATOMS id x y damage radius\n"
             "1 0 0 0 .5\n2 1 0 .1 .5\n3 0 1 .2 .5\n")
    whole, path = frame.format(0) + frame.format(700), place / "dump.x"
    lost = []
    for size in range(len(whole) + 1):
        path.write_text(whole[:size])
        lost.append(2 - len(bodies.steps(path)))
    first = len(frame.format(0))
    report.true("complete frames of a torn dump",
                lost == [2] * first + [1] * (len(whole) - first) + [0], f"at {len(lost)} places")
    path.write_text(whole[:-20])
    for name, text in (("table.txt", "step u_m force_N\n1 2 3\n2 3 4\n3 4 5.0e"),
                       ("notes.txt", "two words\nand some\n"),
                       ("log.lammps", "run 5\n   Step Temp x_J\n"),
                       ("profile.txt", "# Chunk r_m T_C\n0 2 4\n"),
                       ("in.x", "# \n# \n"), ("dump.walls", ""), ("events.txt", "")):
        (place / name).write_text(text)
    out = plot(place).splitlines()
    report.true("plot beside unfinished files", [name.rsplit("/", 1)[1] for name in out] ==
                ["plot.damage.png", "plot.table.png"], "what is complete")
    path.write_text(whole.replace("NUMBER OF ATOMS\n3", "NUMBER OF ATOMS\nthree"))
    said = plot(place, fails=True)
    report.true("a broken dump", "dump.x is broken" in said and said.count("\n") == 1, said.strip())


def without_names(report):
    """A table under the names of LAMMPS is drawn; a dump under its names is told to be without."""
    bare = folder() / "bare"
    bare.mkdir()
    (bare / "dump.body").write_text(
        "ITEM: TIMESTEP\n0\nITEM: NUMBER OF ATOMS\n2\nITEM: BOX BOUNDS ss ss pp\n0 1\n0 1\n0 1\n"
        "ITEM: ATOMS id x y z c_field[1]\n1 0 0 0 1\n2 1 0 0 2\n")
    (bare / "curve.txt").write_text("# Time-averaged data for fix curve\n"
                                    "# TimeStep f_hot f_rock[1]\n"
                                    "0 20 0\n50 21 3\n100 22 5\n")
    done = subprocess.run([sys.executable, ROOT / "tools/plot.py", bare], text=True,
                          capture_output=True)
    said, *drawn = done.stdout.splitlines()
    report.true("curve under LAMMPS's names", drawn == [str(bare / "plot.curve.png")], "drawn")
    report.true("dump without names of columns",
                "dump_modify colname" in said and "c_field[1]" in said, said)


def beside_exact(report):
    """A table NAME.exact.txt has no picture of its own but a curve in that of NAME.txt."""
    place = folder() / "exact"
    place.mkdir()
    (place / "load.txt").write_text("step way_m load_N\n0 0 0\n5 1 2\n9 2 4\n")
    plot(place)
    alone = plt.imread(place / "plot.load.png")
    (place / "load.exact.txt").write_text("way_m load_N\n0 0\n1 3\n2 3\n")
    report.true("pictures", plot(place).split() == [str(place / "plot.load.png")], "one")
    both = plt.imread(place / "plot.load.png")
    report.true("with the exact curve", both.shape != alone.shape or (both != alone).any(), "another one")


def wrong(report):
    example()
    (folder() / "empty").mkdir()
    for words, text in (((folder() / "nowhere",), "no folder"),
                        ((folder() / "empty",), "run an input there"),
                        ((folder(), "--field", "heat"), "no column heat"),
                        ((folder(), "--step", 10**9), "its frames are"),
                        ((folder(), "--range=2:1"), "give LOW:HIGH"),
                        ((folder(), "--section", "w"), "give x, y or z"),
                        ((folder(), "--magnify", "nan"), "give a number"),
                        ((folder(), "--out", folder() / "nowhere/x"), "cannot write")):
        said = plot(*words, fails=True)
        report.true(f"plot.py {' '.join(map(str, words[1:]))}",
                    text in said and said.count("\n") == 1, said.strip())


if __name__ == "__main__":
    main(pictures, walls_for_paraview, pixels, units, without_names, unfinished, beside_exact, wrong)
