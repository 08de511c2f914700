# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""LAMMPS's own checks find nothing in our files: its coding standard (tools/coding_standard), and
its lists of styles and packages (doc/utils) with our pages and doc/lammps-manual.patch added."""

import importlib.util
import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PATCH = ROOT / "doc/lammps-manual.patch"
LAMMPS = Path(os.environ.get("LAMMPS_SOURCE_DIR", "nowhere"))

# What the scripts of the coding standard look at

FOLDERS = ["", "doc/**", "examples/**", "plugin", "potentials", "src/**", "tools/**", "unittest/**"]
SOURCES = ["*.cmake", "*.cpp", "*.h", "*.md", "*.rst", "*.tmsph", "*.yaml", "in.*", ".gitignore",
           "CMakeLists.txt", "README", "LICENSE", "CITATION.cff"]
STANDARD = {"whitespace": SOURCES + ["*.py"], "permissions": SOURCES + ["*.png"],
            "homepage": SOURCES + ["*.py"], "errordocs": ["*.h"], "fmtlib": ["*.h", "*.cpp"],
            "versiontags": SOURCES + ["*.py"]}

# The fix that the pair style makes for itself: LAMMPS writes internal styles in capitals, which
# these scripts go by

INTERNAL = "Fix style entry tmsph/bond is missing"


def run(script, *words):
    """What a script of LAMMPS says, line by line."""
    done = subprocess.run([sys.executable, LAMMPS / script, *map(str, words)], text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    said = done.stdout.splitlines()
    if done.returncode and not any("[Error]" in line for line in said):
        said.append(f"[Error] {script} ended with {done.returncode}: {said[-1:]}")
    return said


def coding_standard(name, root, folder):
    """Faults that one of the scripts finds below root; its settings are written to a folder."""
    settings = Path(folder, f"{name}.yaml")
    settings.write_text(f"recursive: true\nexclude: []\ninclude: {FOLDERS}\n"
                        f"patterns: {STANDARD[name]}\n".replace("'", '"'))
    return [line for line in run(f"tools/coding_standard/{name}.py", "-c", settings, root)
            if "[Error]" in line]


def manual(folder):
    """LAMMPS's lists of styles and packages, patched, and our pages, in doc/src of a folder.
    @return true if the patch could be applied"""
    pages = Path(folder, "doc/src")
    pages.mkdir(parents=True)
    changed = [LAMMPS / name for name in re.findall(r"^\+\+\+ b/(.*)", PATCH.read_text(), re.M)]
    read = [list((LAMMPS / "doc/src").glob(names)) for names in ("Commands_*.rst", "*_style.rst")]
    for page in changed + sum(read, []):
        shutil.copyfile(page, pages / page.name)
    done = subprocess.run(["patch", "-p1", "-i", PATCH], cwd=folder, text=True,
                          stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
    for page in (ROOT / "doc/src").glob("*.rst"):
        shutil.copyfile(page, pages / page.name)
    if done.returncode:
        print(done.stdout)
    return done.returncode == 0


def lists(folder):
    """Styles and packages of ours that LAMMPS's lists or indices lack."""
    sources = Path(folder, "src")
    sources.mkdir()
    (sources / "TMSPH").symlink_to(ROOT / "src/TMSPH")
    said = [line for script in ("styles", "packages")
            for line in run(f"doc/utils/check-{script}.py", "-d", Path(folder, "doc/src"),
                            "-s", sources)]
    if not any("Found 1 packages" in line for line in said):
        return ["the checks did not see the package:"] + said[-5:]
    # of LAMMPS's own pages they say things too
    wrong = re.compile(r"(is missing|missing in|^Missing '|^Have ').*tmsph|"
                       r"tmsph.*(is missing|missing in)|\[Error\]|Traceback", re.I)
    return [line for line in said if wrong.search(line) and not line.startswith(INTERNAL)]


def check_the_check(folder):
    """A file against the standard is found."""
    wrong = Path(folder, "wrong/src/TMSPH")
    wrong.mkdir(parents=True)
    old_homepage = "lammps." + "sandia.gov"    # this file is looked at too
    (wrong / "wrong.h").write_text("/* ERROR/WARNING messages: */\n\tint a; \nfmt::print(\n"
                                   f"{old_homepage}\n.. versionadded:: TBD\n")
    (wrong / "wrong.h").chmod(0o755)
    return [f"{name}.py finds nothing in a wrong file" for name in STANDARD
            if not coding_standard(name, Path(folder, "wrong"), folder)]


def main():
    scripts = [LAMMPS / f"tools/coding_standard/{name}.py" for name in STANDARD]
    scripts += [LAMMPS / f"doc/utils/check-{name}.py" for name in ("styles", "packages")]
    absent = [str(script) for script in scripts if not script.exists()]
    absent += [] if shutil.which("patch") else ["command patch"]
    absent += [] if importlib.util.find_spec("yaml") else ["PyYAML"]
    if absent:
        print("skipped: no", ", ".join(absent))
        return 77
    found = []
    with tempfile.TemporaryDirectory() as folder:
        for name in STANDARD:
            found += coding_standard(name, ROOT, folder)
        if manual(folder):
            found += lists(folder)
        elif re.search(r'"(.*)"', (LAMMPS / "src/version.h").read_text())[1] in PATCH.read_text():
            found.append("doc/lammps-manual.patch cannot be applied")
        else:
            print("     doc/lammps-manual.patch is for another version: lists not checked")
        found += check_the_check(folder)
    print("\n".join("FAIL " + line for line in found) if found
          else f"ok   {len(STANDARD)} scripts of the coding standard, lists of styles and packages")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
