# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Sphinx builds the manual without a warning, every reference resolved; and it does tell of one
that leads nowhere, to a page of ours, of LAMMPS's manual or a file."""

import os
import shutil
import subprocess
import sys
import tempfile
from importlib.util import find_spec
from pathlib import Path

from tmsph_testing import main

DOC = Path(__file__).resolve().parents[2] / "doc"


def warnings(source, target):
    done = subprocess.run([sys.executable, "-m", "sphinx", "-q", "-n", source, target],
                          text=True, capture_output=True)
    return done.returncode, done.stderr


def manual(report):
    if not (find_spec("sphinx") and find_spec("myst_parser") and find_spec("sphinx_rtd_theme")):
        print("SKIPPED: the manual needs python3-sphinx, python3-sphinx-rtd-theme, "
              "python3-myst-parser")
        sys.exit(77)    # for ctest
    with tempfile.TemporaryDirectory() as folder:
        status, said = warnings(DOC, f"{folder}/html")
        report.true("the manual", status == 0 and not said, said or "no warnings")
        page = Path(folder, "html/src/tmsph_quasistatic.html").read_text()
        report.true("LAMMPS's manual", "https://docs.lammps.org/run.html" in page,
                    "run is linked to")

        page = Path(folder, "html/tutorial.html").read_text()
        report.true("files of the package", 'README.md">Build</a>' in page and "](" not in page,
                    "are linked to")

        source = Path(folder, "doc")
        shutil.copytree(DOC, source, ignore=shutil.ignore_patterns("report"))
        (source / "settings.md").write_text("# A\n\n[b](nowhere.md)\n")
        (source / "output.md").write_text("# B\n\n[c](../nowhere.py)\n")
        (source / "src/tmsph_cut.rst").write_text(
            "C\n=\n\n:doc:`d <fix_tmsph_nothing>` :doc:`e <runn>`\n")
        said = warnings(source, f"{folder}/bad")[1]
        names = ["nowhere.md", "nowhere.py", "fix_tmsph_nothing"]
        tree = Path(os.environ.get("LAMMPS_SOURCE_DIR", "/none"))
        names += ["runn"] if (tree / "doc/src").is_dir() else []
        for name in names:
            report.true(f"a link to {name}", f"{name}" in said, "is told")


if __name__ == "__main__":
    main(manual)
