# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The version of the package is the same everywhere: in its header, in CITATION.cff and
CHANGELOG.md, of ./tmsph --version, at the start of a run and in restart files, which tell when
another version wrote them. And a run says what to cite."""

import os
import re
import subprocess
import tempfile
from pathlib import Path

from tmsph_testing import Scene, Script, lattice, main, material

ROOT = Path(__file__).resolve().parents[2]
SPACING = 1e-3


def named(path, pattern):
    """What a pattern finds first in a file of the package."""
    found = re.search(pattern, (ROOT / path).read_text(), re.M)
    return found[1] if found else None


VERSION = named("src/TMSPH/tmsph_version.h", r'VERSION\[\] = "(.*)"')


def files(report):
    report.true("version in CITATION.cff", named("CITATION.cff", r"^version: (.*)") == VERSION,
                VERSION)
    report.true("version in CHANGELOG.md", named("CHANGELOG.md", r"^## ([^ ,]+)") == VERSION,
                "of its newest entry")
    said = subprocess.run([ROOT / "tmsph", "--version"], capture_output=True, text=True).stdout
    report.true("version of the script", said.startswith(f"TMSPH    {VERSION}, "),
                said.partition("\n")[0])


def runs(report):
    scene = Scene(lattice("square", (6, 6), SPACING), [material()])
    first = scene.add("run 1\nwrite_restart r").run(keep="r")
    report.true("version at the start of a run", f"\nTMSPH {VERSION}: 3" in first.log, VERSION)
    data = first.kept["r"]
    report.true("version in a restart file", data.count(VERSION.encode() + b"\0") == 1, VERSION)
    # as long as this one, so that the file keeps its layout
    other = "0." + "7" * (len(VERSION) - 2)
    ranks = 2
    for name, expected in ((VERSION, 0), (other, 1)):
        file = data.replace(VERSION.encode() + b"\0", name.encode() + b"\0")
        again = Script("read_restart r\nrun 1", {"r": file}).run(ranks)
        told = again.log.count(f"written by TMSPH {name}, read by TMSPH {VERSION}")
        report.true(f"restart of version {name}", told == expected, f"told {expected} times")


def citation(report):
    """Scripts of the other tests run with -nocite."""
    doi = named("CITATION.cff", r"^ +doi: (.*)")
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "in.cite").write_text("atom_style tmsph\nregion b block 0 1 0 1 0 1\n"
                                           "create_box 1 b\npair_style tmsph 0.1\nclear\n")
        done = subprocess.run([os.environ["TMSPH_LMP"], "-in", "in.cite", "-cite", "cite"],
                              cwd=folder, capture_output=True, text=True)
        cite = Path(folder, "cite")
        report.true("what to cite", done.returncode == 0 and doi in cite.read_text(), doi)


if __name__ == "__main__":
    main(files, runs, citation)
