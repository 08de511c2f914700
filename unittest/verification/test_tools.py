# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""tools/cracks.py and tools/to_vtk.py on what a coarse examples/disc writes, and the dumps
themselves read by programs that are not ours: ASE, and MDAnalysis and VTK where they are
installed. Counts are those of the fix
itself, lengths those of compute tmsph/crack; the cracks of the disc run radially, with the
expansions exchanged around the inclusion; events made of the bonds that tmsph/cut removes along
a line or plane point along it. Wrong files stop with one line that says why."""

import atexit
import base64
import csv
import re
import shutil
import subprocess
import sys
import tempfile
import xml.etree.ElementTree as xml
from functools import cache
from pathlib import Path

import numpy as np

from tmsph_testing import Scene, Script, lattice, main, material, read_dump

ROOT = Path(__file__).resolve().parents[2]
EXAMPLE = ("examples/disc/in.disc", "potentials/mu2022.tmsph")    # it includes the second
FIELDS = "ux uy temperature damage sxx syy szz sxy s1 s3 strength radius".split()
INNER, SPACING = 0.015, 2.5e-3


@cache
def folder():
    """A temporary one, for all cases."""
    place = Path(tempfile.mkdtemp(prefix="tmsph-"))
    atexit.register(shutil.rmtree, place)
    return place


def tool(name, *words, fails=False):
    command = [sys.executable, ROOT / "tools" / name, *map(str, words)]
    done = subprocess.run(command, cwd=folder(), text=True, capture_output=True)
    if (done.returncode != 0) != fails:
        raise RuntimeError(f"{name} {words}: {done.stdout}{done.stderr}")
    return done.stderr if fails else done.stdout


def table(name):
    with open(folder() / name) as file:
        rows = list(csv.reader(file))
    return dict(zip(rows[0], np.array(rows[1:], float).T))


def disc(swap, dumps=True):
    """Runs the example; its files are left in the folder, under examples/disc."""
    scene = Script(f"variable dx index {SPACING}\nvariable swap index {swap}\n"
                   f"variable dump index {2500 if dumps else 0}\n"
                   f"variable rate index {0.02 if dumps else 0.04}\n"
                   f"variable bonds index {'yes' if dumps else 'no'}\nlog log.disc\n"
                   "shell cd examples/disc\ninclude in.disc\nshell cd ../..\nlog none",
                   {name: (ROOT / name).read_text() for name in EXAMPLE})
    run = scene.run(keep="examples/disc/*")
    for name, data in run.kept.items():
        (folder() / name).write_bytes(data)
    (folder() / "log.disc").write_text(run.log)


@cache
def example():
    disc("no")


def axes(name):
    """Events in the rose, and the mean of their directions as vectors of twice the angle."""
    rose = table(name)
    count = rose["tension"] + rose["shear"]
    angle = np.radians(rose["from_degrees"] + rose["to_degrees"])
    return count.sum(), np.array([count @ np.cos(angle), count @ np.sin(angle)]) / count.sum()


def counts(report):
    example()
    out = tool("cracks.py", "events.txt", "--curve", "broken_bonds.txt", "--out", "curve")
    tool("cracks.py", "events.txt", "--log", "log.disc", "--out", "log", "--against", "step")
    curve = np.loadtxt(folder() / "broken_bonds.txt", skiprows=1)
    last = curve[-1]    # step temperature broken tension shear area opening
    events = table("curve.events.csv")
    report.true("cumulative events at the end", events["events"][-1] == last[2] > 100,
                f"{last[2]:g} of the fix")
    report.true("of them in tension and in shear", (events["tension"][-1], events["shear"][-1])
                == (last[3], last[4]), f"{last[3]:g}, {last[4]:g} of the fix")
    report.true("temperatures ascend", np.all(np.diff(events["temperature"]) >= 0), "in the table")
    by_step = table("log.events.csv")
    # of the fix on a step: all events up to that step
    seen = np.searchsorted(by_step["step"], curve[:, 0], side="right")
    report.true("events up to each step of the curve", np.array_equal(seen, curve[:, 2]),
                "the fix's own count")
    length = table("curve.length.csv")
    report.true("crack length", np.array_equal(length["length"], curve[:, 5])
                and np.array_equal(length["temperature"], curve[:, 1]), "of compute tmsph/crack")
    short = table("log.length.csv")
    report.below("crack length from the log: difference at the end",
                 abs(short["length"][-1] / curve[-1, 5] - 1), 1e-6)
    none = int(re.search(r"(\d+) events have none", out)[1])
    report.true("rose: all events but those without direction",
                axes("curve.rose.csv")[0] + none == last[2],
                f"{last[2]:g}")
    for name in ("rose", "events", "length"):
        report.true(f"picture of the {name}",
                    (folder() / f"curve.{name}.png").read_bytes()[:4] == b"\x89PNG", "PNG")


def directions(report):
    """cracks.py as a module, for the direction at each event."""
    example()
    sys.path.insert(0, str(ROOT / "tools"))
    import cracks

    def cosines():
        events = cracks.Events(folder() / "events.txt")
        X = events.place[:, :2]
        r = np.linalg.norm(X, axis=1)
        normal = events.axes(cracks.REACH * events.spacing())
        chosen = (r > INNER + 2 * SPACING) & ~np.isnan(normal[:, 0])
        around = np.abs(np.abs(r - INNER) < 1.5 * SPACING) & ~np.isnan(normal[:, 0])
        radial = np.abs(np.sum(normal * X, axis=1)) / r
        return events, radial[chosen] ** 2, radial[around] ** 2

    events, outside, _ = cosines()
    report.within("spacing from the events/spacing", events.spacing() / SPACING, 0.9, 1.1)
    report.below("radial cracks: mean square of normal times radius", outside.mean(), 0.25)
    disc("yes", dumps=False)
    report.above("exchanged, at the interface: the same", cosines()[2].mean(), 0.75)


def events_file(rows):
    """A dump local of one frame with these rows."""
    names = " ".join(f"f_b[{k}]" for k in range(1, 14))
    return "\n".join(["ITEM: TIMESTEP", "0", "ITEM: NUMBER OF ENTRIES", str(len(rows)),
                      "ITEM: BOX BOUNDS ff ff pp", "0 1", "0 1", "0 1",
                      f"ITEM: ENTRIES index {names}", *rows, ""])


def cut_events(cloud, shape):
    """Writes line.txt, as if all bonds that a cut crosses had broken; their number."""
    scene = Scene(cloud, [material()]).add(
        f"tmsph/cut all {shape}\ncompute b all tmsph/bond/local id1 id2 only cut\n"
        "run 0\nwrite_dump all local cut.local index c_b[1] c_b[2]")
    cut = scene.run().frame("cut")
    i, j = cut["c_b[1]"].astype(int) - 1, cut["c_b[2]"].astype(int) - 1
    X = np.zeros((len(cloud), 3))
    X[:, : cloud.dimension] = cloud.X
    bond = X[j] - X[i]
    bond /= np.linalg.norm(bond, axis=1)[:, None]
    rows = np.hstack([0.5 * (X[i] + X[j]), bond])
    (folder() / "line.txt").write_text(events_file(
        [f"{k + 1} {i[k] + 1} {j[k] + 1} {k} {k} " + " ".join(f"{v:.9g}" for v in row) + f" 1 1 {k}"
         for k, row in enumerate(rows)]))
    return len(i)


def line(report):
    for angle in (0, 25, 60, 100):
        c, s = 0.3 * np.cos(np.radians(angle)), 0.3 * np.sin(np.radians(angle))
        number = cut_events(lattice("hex", (50, 29), 0.02, centre=True), f"line {-c} {-s} {c} {s}")
        tool("cracks.py", "line.txt", "--bins", 180, "--out", "line")
        count, mean = axes("line.rose.csv")
        found = np.degrees(np.arctan2(*mean[::-1])) / 2
        report.true(f"line at {angle} degrees: events", count == number > 50, f"all {number}")
        report.below(f"line at {angle} degrees: direction off by",
                     abs((found - angle + 90) % 180 - 90), 1.0)


def emissions(report):
    """Clusters of a list whose clusters, magnitudes and b are known, and a front of known speed."""
    random = np.random.default_rng(5)
    number, b, least = 4000, 1.2, -6.0
    centre = np.stack([np.arange(number) * 1.0, np.zeros(number)], 1)    # a metre and a second apart
    magnitude = least + random.exponential(np.log10(np.e) / b, number)
    rows, parts = [], 3
    for n in range(number):
        for k in range(parts):    # of one cluster, linked from one to the next
            rows.append(f"{len(rows) + 1} {2 * len(rows) + 1} {2 * len(rows) + 2} {n} {n + 0.1 * k:.17g} "
                        f"{centre[n, 0] + 0.1 * k:.17g} 0 0 1 0 0 1 {10 ** magnitude[n] / parts:.17g} {n}")
    (folder() / "emissions.txt").write_text(events_file(rows))
    said = tool("cracks.py", "emissions.txt", "--against", "time", "--clusters", 0.15, "--radius", 0.15,
                "--from", 0, 0, "--out", "emissions")
    found = table("emissions.clusters.csv")
    report.within("clusters", len(found["events"]) / number, 1, 1)
    report.true("events in each", np.all(found["events"] == parts), str(parts))
    report.below("magnitude: largest error", abs(found["magnitude"] - magnitude).max(), 1e-8)
    report.below("duration: largest error", abs(found["duration"] - 0.2).max(), 1e-8)
    value, error, complete = (float(word) for word in
                              re.search(r"b-value (\S+) \+- (\S+) from magnitude (\S+) on", said).groups())
    # the bin with most clusters, of 0.1, hides as much of the list
    report.below("b: error in standard errors", abs(value - b) / error, 3)
    report.within("b: standard error over b/sqrt(N)", error / (b / np.sqrt(number)), 0.9, 1.2)
    report.within("complete from", complete, least - 0.1, least + 0.1)
    speed = float(re.search(r"front \S+ away, (\S+) per time", said).group(1))
    report.within("speed of the front", speed, 0.999, 1.001)


def plane(report):
    """3-D: a round cut that strikes at 40 degrees and dips by 35."""
    strike, dip = np.radians(40), np.radians(35)
    normal = np.sin(dip) * np.array([-np.sin(strike), np.cos(strike), 0]) + [0, 0, np.cos(dip)]
    cloud = lattice("sc", (16,) * 3, 0.02, centre=True)
    shape = "disc 0 0 0 " + " ".join(f"{v:.9g}" for v in normal) + " 0.1"
    number = cut_events(cloud, shape)
    tool("cracks.py", "line.txt", "--bins", 180, "--out", "plane")
    count, mean = axes("plane.rose.csv")
    report.true("plane: events", count == number > 50, f"all {number}")
    report.below("plane: strike off by", abs(np.degrees(np.arctan2(*mean[::-1])) / 2 - 40), 2.0)
    tilt = table("plane.dip.csv")
    report.above("plane: share of the events that dip by 30 to 40 degrees",
                 tilt["events"][tilt["from_degrees"] == 30][0] / number, 0.8)


def other_readers(report):
    """ASE's reader and ours, and what goes to ParaView."""
    example()
    from ase.io import read
    tool("to_vtk.py", "dump.disc", "--bonds", "dump.bonds", "--xyz")
    named = read(folder() / "dump.disc.xyz", index=":")
    frames = read(folder() / "dump.disc", index=":", format="lammps-dump-text", order=True)
    ours = read_dump(folder() / "dump.disc")
    report.true("frames that ASE reads", len(frames) == len(ours) > 3, f"{len(ours)}")
    report.true("frames of extended XYZ that ASE reads", len(named) == len(ours), f"{len(ours)}")
    same = {"positions": True, "types": True, "fields by their names": True}
    for theirs, all_of_them, frame in zip(frames, named, ours):
        same["positions"] &= np.array_equal(theirs.get_positions()[:, :2], frame("x y"))
        same["types"] &= np.array_equal(theirs.get_atomic_numbers(), frame["type"])
        fields = dict(all_of_them.arrays)
        fields["ux"], fields["uy"] = fields["displacement"].T[:2]
        for name in ["id", "type"] + FIELDS:
            same["fields by their names"] &= np.array_equal(fields[name], frame[name])
    for what, equal in same.items():
        report.true(f"{what} of ASE and of our reader", equal, "equal in all frames")
    vtk(report, ours)
    vtk_reader(report, ours)
    mdanalysis(report, ours)


def installed(module):
    """A module that the tests do without, or nothing."""
    import importlib
    try:
        return importlib.import_module(module)
    except ImportError:
        print(f"     {module} is not installed: not read with it", flush=True)
        return None


def vtk_reader(report, ours):
    """Names, radii and bonds as VTK's own reader, which is ParaView's, finds them."""
    if not installed("vtkmodules"):
        return
    from vtkmodules.util.numpy_support import vtk_to_numpy
    from vtkmodules.vtkIOXML import vtkXMLUnstructuredGridReader

    def grid(name):
        reader = vtkXMLUnstructuredGridReader()
        reader.SetFileName(str(folder() / name))
        reader.Update()
        return reader.GetOutput()

    good = True
    for frame in ours:
        points = grid(f"dump.disc.{frame.step}.vtu")
        data = points.GetPointData()
        good &= np.array_equal(vtk_to_numpy(points.GetPoints().GetData())[:, :2], frame("x y"))
        for name in FIELDS[2:]:
            good &= np.array_equal(vtk_to_numpy(data.GetArray(name)), frame[name])
    report.true("VTK: points, fields and radii", good, "equal in all frames")
    lines = grid(f"dump.disc.bonds.{ours[-1].step}.vtu")
    rows = read_dump(folder() / "dump.bonds")[-1]
    ends = vtk_to_numpy(lines.GetCells().GetConnectivityArray()).reshape(-1, 2)
    state = vtk_to_numpy(lines.GetCellData().GetArray("state"))
    report.true("VTK: bonds and their states", np.array_equal(ends + 1, rows("batom1 batom2"))
                and np.array_equal(state, rows["btype"]), f"{len(rows['btype'])}")


def mdanalysis(report, ours):
    """It reads ids, types and positions of a dump, in single precision and from the corner of the
    box; further columns only as of a later version than Debian's."""
    module = installed("MDAnalysis")
    if not module:
        return
    import warnings
    warnings.simplefilter("ignore")
    universe = module.Universe(str(folder() / "dump.disc"), format="LAMMPSDUMP",
                               topology_format="LAMMPSDUMP",
                               lammps_coordinate_convention="unscaled")
    good = len(universe.trajectory) == len(ours)
    for frame, _ in zip(ours, universe.trajectory):
        shift = universe.atoms.positions[:, :2] - frame("x y")
        good &= np.ptp(shift, axis=0).max() < 4e-7 * np.abs(frame("x y")).max()
        good &= np.array_equal(universe.atoms.ids, frame["id"])
        good &= np.array_equal(universe.atoms.types.astype(int), frame["type"])
    report.true("MDAnalysis: ids, types, positions", good, "equal in all frames")


def decoded(element):
    data = base64.b64decode(element.text)
    kind = {"Float64": "<f8", "Int64": "<i8", "UInt8": "u1"}[element.get("type")]
    size = int(np.frombuffer(data, "<u8", 1)[0])
    assert size == len(data) - 8
    return np.frombuffer(data, kind, offset=8).reshape(-1,
                                                       int(element.get("NumberOfComponents",
                                                                       1))).squeeze()


def vtk(report, frames):
    """The files for ParaView, decoded here."""
    listed = [(int(s.get("timestep")),
               s.get("file")) for s in xml.parse(folder() / "dump.disc.pvd").iter("DataSet")]
    report.true("frames in the series", len(listed) == len(frames), f"{len(frames)}")
    good = True
    for (_, name), frame in zip(listed, frames):
        root = xml.parse(folder() / name).getroot()
        arrays = {a.get("Name"): decoded(a) for a in root.iter("DataArray")}
        good &= np.array_equal(arrays["Points"][:, :2], frame("x y"))
        good &= np.array_equal(arrays["type"], frame["type"])
        good &= np.array_equal(arrays["displacement"][:, :2], frame("ux uy"))
        good &= not arrays["displacement"][:, 2].any()
        for field in FIELDS[2:]:
            good &= np.array_equal(arrays[field], frame[field])
        good &= np.array_equal(arrays["connectivity"], np.arange(len(frame["id"])))
    report.true("points and all fields of the files for ParaView", good, "those of the dump")
    root = xml.parse(folder() / f"dump.disc.bonds.{listed[-1][0]}.vtu").getroot()
    arrays = {a.get("Name"): decoded(a) for a in root.iter("DataArray")}
    rows = read_dump(folder() / "dump.bonds")[-1]
    report.true("lines are the bonds", np.array_equal(arrays["connectivity"].reshape(-1, 2) + 1,
                                                      rows("batom1 batom2")),
                f"{len(rows['index'])}")
    report.true("broken ones among them", np.count_nonzero(arrays["state"] == 1)
                == np.count_nonzero(rows["btype"] == 1) > 0, "as in the dump")


def wrong_files(report):
    example()
    lines = (folder() / "events.txt").read_text().split("\n")
    (folder() / "short.txt").write_text("\n".join(lines[:20]))
    (folder() / "words.txt").write_text("hello\n")
    (folder() / "empty.txt").write_text(events_file([]))
    for words, text in ((("dump.disc",), "dump of particles"), (("absent",), "cannot read absent"),
                        (("words.txt",), "not a text dump"), (("short.txt",), "breaks off"),
                        (("dump.bonds",), "0 columns of a fix, not the 13"),
                        (("empty.txt",), "nothing broke"),
                        (("events.txt", "--curve", "dump.disc"), "fix ave/time"),
                        (("events.txt", "--log", "broken_bonds.txt"), "thermodynamic output"),
                        (("events.txt", "--curve", "broken_bonds.txt", "--columns", "T", "A"),
                         "--columns"),
                        (("events.txt", "--thickness", "0"), "--thickness"),
                        (("events.txt", "--clusters", "-1"), "--clusters"),
                        (("events.txt", "--complete", "2"), "--clusters"),
                        (("events.txt", "--from", "1"), "--from"),
                        (("events.txt", "--bins", "0"), "--bins")):
        said = tool("cracks.py", *words, fails=True)
        report.true(f"cracks.py {' '.join(words)}", text in said and said.count("\n") == 1,
                    said.strip())
    for words, text in ((("events.txt",), "not a dump of particles"),
                        (("dump.disc", "--names", "ux"), "0 columns"),
                        (("dump.disc", "--bonds", "dump.disc"), "not of bonds"),
                        (("dump.disc", "--bonds", "events.txt"), "no columns of compute"),
                        (("dump.disc", "--out", "nowhere/x"), "cannot write nowhere/x"),
                        (("short.txt",), "breaks off")):
        said = tool("to_vtk.py", *words, fails=True)
        report.true(f"to_vtk.py {' '.join(words)}", text in said and said.count("\n") == 1,
                    said.strip())


if __name__ == "__main__":
    main(counts, other_readers, directions, line, plane, emissions, wrong_files)
