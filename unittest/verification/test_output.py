# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What runs leave for other programs: the radius of particles and the walls are where the scene has
them; dumps, tables and logs of every example and of the tutorial have names for their columns,
those of dumps as OVITO maps them (ovito_columns.txt); one header line makes a table that numpy
reads by name."""

import re
import tempfile
from pathlib import Path

import numpy as np

from tmsph_testing import Scene, Script, lattice, main, material

ROOT = Path(__file__).resolve().parents[2]
MATERIALS = {f"potentials/{path.name}": path.read_text()
             for path in ROOT.glob("potentials/*.tmsph")}
COARSE = {"in.disc": "dx 4e-3", "in.brazil": "dx 2e-3", "in.borehole": "dx 5e-3",
          "in.quench": "dx 0.5e-3", "in.toughness": "dx 0.5e-3", "in.disc3d": "n 3",
          "in.branching": "dx 2e-3"}
# what a column of a dump has to be for OVITO; all other names are ours
MEANT = {"id": "Particle Identifier", "type": "Particle Type", "radius": "Radius",
         **{axis: f"Position.{axis.upper()}" for axis in "xyz"},
         **{f"v{axis}": f"Velocity.{axis.upper()}" for axis in "xyz"}}
FIELDS = {"ux", "uy", "uz", "x0", "y0", "z0", "temperature", "damage", "volume", "nbond",
          "nbroken", "ncut", "sxx", "syy", "szz", "sxy", "sxz", "syz", "s1", "s2", "s3", "smean",
          "vonmises", "strength", "load", "radial", "hoop"}
EVENTS = "id1 id2 step time x y z nx ny nz kind energy temperature".split()


def ovito():
    """Property by column of particles and of bonds, and the properties that have full names."""
    blocks, block = {}, None
    for line in (Path(__file__).parent / "ovito_columns.txt").read_text().splitlines():
        if line.startswith("["):
            block = blocks.setdefault(line.strip("[]"), {})
        elif line and not line.startswith("#") and block is not None:
            names, _, value = line.partition("  ")
            for name in names.split() if value else line.split():
                block[name] = value.strip()
    return blocks["particles"], blocks["bonds"], set(blocks["full names"])


def short(text):
    """An input with two steps in place of each run."""
    text = re.sub(r'((?:^|")\s*)run +[^"\n]+', r"\1run 2", text, flags=re.M)
    text = re.sub(r'((?:^|")\s*)tmsph/quasistatic +[^"\n]+', r"\1tmsph/quasistatic 2 change 10",
                  text, flags=re.M)
    return re.sub(r"^minimize .*", "run 0", text, flags=re.M)


def inputs():
    """(name, text) of every example and of the tutorial."""
    for path in sorted(ROOT.glob("examples/*/in.*")):
        head = "variable {} index {}\n".format(*COARSE[path.name].split()) \
            if path.name in COARSE else ""
        bonds = "variable bonds index yes\n" if path.name == "in.disc" else ""
        yield f"{path.parent.name}/{path.name}", head + bonds + path.read_text()
    blocks = re.findall(r"^```lammps\n(.*?)^```", (ROOT / "doc/tutorial.md").read_text(),
                        re.M | re.S)
    yield "tutorial", "variable dx index 2e-3\n" + "".join(blocks)


def header(text):
    return re.search(r"^ITEM: (ATOMS|ENTRIES) (.*)", text, re.M)


def dump_of_particles(report, name, columns):
    particles, _, full = ovito()
    odd = [c for c in columns if c not in MEANT and (c not in FIELDS or c in particles)]
    wrong = [c for c in columns if c in MEANT and particles[c] != MEANT[c]]
    stolen = [c for c in columns if c not in particles
              and any(re.fullmatch(rf"{f}\.?[a-z]{{0,5}}", c) for f in full)]
    report.true(f"{name}: columns", not odd and not wrong and not stolen
                and len(set(columns)) == len(columns)
                and set("id type x y z radius".split()) <= set(columns),
                " ".join(odd + wrong + stolen) or " ".join(columns))


def names_of_everything(report):
    _, bonds, _ = ovito()
    for name, text in inputs():
        run = Script("shell cd examples/name\ninclude in.name",
                     {"examples/name/in.name": short(text), **MATERIALS}).run(
                         keep="examples/name/*", timeout=300)
        written = {file: data.decode(errors="replace") for file, data in run.kept.items()
                   if not file.startswith(("in.", "image.", "restart.", "state."))
                   and file[-4:] != ".png"}
        drawn = False
        for file, data in sorted(written.items()):
            found, what = header(data), f"{name}: {file}"
            if found and found[1] == "ATOMS":
                drawn = True
                dump_of_particles(report, what, found[2].split())
            elif found:
                columns = found[2].split()[1:]
                good = {"dump.bonds": all(c in bonds for c in columns),
                        "events.txt": columns == EVENTS, "dump.walls": len(columns) in (7, 10)}
                report.true(f"{what}: columns", good[file], " ".join(columns))
            elif file.startswith("profile."):
                report.true(f"{what}: columns", "temperature_C" in data.split("\n")[2], "named")
            elif file.startswith("dump."):
                report.true(what, False, "no frame")
            else:
                first = data.split("\n", 1)[0].split()
                report.true(f"{what}: first line", len(first) > 1
                            and all(re.fullmatch(r"[A-Za-z]\w*", word) for word in first),
                            " ".join(first))
        for table in run.tables:
            raw = [c for c in table if re.match(r"[cfv]_", c)]
            report.true(f"{name}: names in the log", not raw, " ".join(raw or table))
        report.true(f"{name}: dumps", drawn or "toughness" in name, "there")


def radii(report):
    """Half a spacing: of a square and a cube lattice half their edge, of a hexagonal one between
    half the root of the area and half the distance, for any thickness, here 1, a spacing and a
    hundredth of one."""
    dx = 2e-3
    for name, cells in (("square", (9, 7)), ("hex", (9, 5)), ("sc", (5, 4, 6))):
        least = (3**0.5 / 2) ** 0.5 if name == "hex" else 1.0
        for thickness in (1.0, dx, 0.01 * dx) if len(cells) == 2 else (1.0,):
            for ranks in (1, 2):
                cloud = lattice(name, cells, dx)
                cloud.volume = cloud.volume * thickness
                scene = Scene(cloud, [material()]).add(
                    "compute p all tmsph/property/atom radius\nrun 0").snapshot("end", "c_p")
                found = scene.run(ranks).frame("end")["c_p"] / (0.5 * dx)
                what = f"radius, {name}, thickness {thickness:g}, {ranks} ranks: in half spacings"
                report.within(f"{what}, least", found.min(), least - 1e-9, 1 + 1e-9)
                report.within(f"{what}, most", found.max(), least - 1e-9, 1 + 1e-9)


def walls(report):
    """A line that moves up and a bent one, in 2-D; a plane in 3-D: rows of the compute are on them,
    and any wall in dump image draws all."""
    dx = 2e-3
    cloud = lattice("square", (6, 6), dx)
    head = "compute w all tmsph/wall/local\nfix move all nve\ntimestep 1e-7\n"
    for ranks in (1, 2):
        scene = Scene(cloud, [material()]).add(
            "fix low all tmsph/wall line -0.1 -0.01 0.1 -0.01 velocity 0 100\n"
            "fix bent all tmsph/wall polyline 3 -0.1 -0.05 0 -0.03 0.1 -0.05\n" + head
            + "run 10\nwrite_dump all local walls.local index c_w[*]\n"
            "write_dump all image low.ppm type type zoom 0.1 size 200 200 fix low type 0.001 0\n"
            "write_dump all image bent.ppm type type zoom 0.1 size 200 200 fix bent type 0.001 0\n"
            "write_dump all image none.ppm type type zoom 0.1 size 200 200")
        run = scene.run(ranks, keep="*.ppm")
        frame = run.frame("walls")
        rows = frame(" ".join(f"c_w[{k}]" for k in range(1, 8)))
        y = -0.01 + 100 * 1e-6
        right = [[1, -0.1, -0.05, 0, 0, -0.03, 0], [1, 0, -0.03, 0, 0.1, -0.05, 0],
                 [2, -0.1, y, 0, 0.1, y, 0]]
        report.true(f"walls in 2-D, {ranks} ranks", np.allclose(rows, right, rtol=0, atol=1e-9),
                    f"{len(rows)} lines")
        pictures = [run.kept[name] for name in ("low.ppm", "bent.ppm", "none.ppm")]
        report.true(f"dump image, {ranks} ranks: any wall draws all",
                    pictures[0] == pictures[1] != pictures[2], "same picture")
    scene = Scene(lattice("sc", (4, 4, 4), dx), [material()]).add(
        "fix low all tmsph/wall plane 0 0 -0.01 1 2 2\n" + head
        + "run 0\nwrite_dump all local walls.local index c_w[*]")
    frame = scene.run().frame("walls")
    rows = frame(" ".join(f"c_w[{k}]" for k in range(2, 11))).reshape(-1, 3)
    height = (rows - [0, 0, -0.01]) @ np.array([1, 2, 2]) / 3
    report.true("plane in 3-D: triangles", len(rows) == 6, "2")
    report.below("plane in 3-D: corners off it, m", np.abs(height).max(), 1e-6)    # %g of the dump


def table_by_name(report):
    """numpy reads the columns of a table under their names."""
    text = (ROOT / "examples/incline/in.incline").read_text()
    run = Script("variable time index 0.05\n" + text, {}).run(keep="speed.txt")
    with tempfile.TemporaryDirectory() as folder:
        (Path(folder) / "speed.txt").write_bytes(run.kept["speed.txt"])
        table = np.genfromtxt(Path(folder) / "speed.txt", names=True)
        plain = np.loadtxt(Path(folder) / "speed.txt", skiprows=1)
    report.true("table by names",
                len(plain) > 20 and table.dtype.names[:3] == ("step", "time_s", "speed_m_per_s")
                and np.array_equal(table["speed_m_per_s"], plain[:, 2]), f"{len(plain)} rows")


if __name__ == "__main__":
    main(names_of_everything, radii, walls, table_by_name)
