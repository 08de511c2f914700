# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""clang-tidy finds nothing in the headers, by the checks of .clang-tidy: in those of the physics,
and where LAMMPS's source and MPI are at hand in those of all layers. Not in the other files, which
take half an hour of one core. Skipped without clang-tidy."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from test_layers import SOURCE, layers

ROOT = SOURCE.parents[1]
EIGEN = Path("/usr/include/eigen3")
LAMMPS = Path(os.environ.get("LAMMPS_SOURCE_DIR", "nowhere")) / "src"
PHYSICS = ["-std=c++17", "-I", str(SOURCE), "-isystem", str(EIGEN)]


def missing():
    """What clang-tidy needs and is not there, or nothing."""
    return "clang-tidy" if not shutil.which("clang-tidy") else "" if EIGEN.exists() else str(EIGEN)


def styles():
    """Flags for all files, or nothing where LAMMPS's source or MPI is not at hand."""
    if not LAMMPS.exists() or not shutil.which("mpicxx"):
        return []
    shown = subprocess.run(["mpicxx", "-show"], text=True, stdout=subprocess.PIPE).stdout
    folders = [str(LAMMPS), *re.findall(r"-I *(\S+)", shown)]
    return PHYSICS + [word for folder in folders for word in ("-isystem", folder)]


def tidy(file, flags):
    """What clang-tidy says of a file and its headers, a line each."""
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={ROOT / '.clang-tidy'}",
                           str(file), "--", *flags],
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    found = sorted(set(re.findall(r"^.*: (?:warning|error): .*", done.stdout, re.M)))
    return found or ([f"clang-tidy ended with {done.returncode}"] if done.returncode else [])


def main():
    if missing():
        print("skipped: no", missing())
        return 77
    by_layer = layers((SOURCE / "README").read_text())
    names = by_layer["Physics"]
    if styles():
        names = [name for layer in by_layer.values() for name in layer]
    names = [name for name in names if name.endswith(".h")]
    with tempfile.TemporaryDirectory() as folder:
        headers = Path(folder, "headers.cpp")
        headers.write_text("".join(f'#include "{name}"\n' for name in names))
        found = tidy(headers, styles() or PHYSICS)
        wrong = Path(folder, "src/TMSPH/wrong.cpp")
        wrong.parent.mkdir(parents=True)
        wrong.write_text("int *nothing() { return 0; }\n")
        if not tidy(wrong, []):
            found.append("nothing found in a wrong file")
    print("\n".join("FAIL " + line for line in found) if found else f"ok   {len(names)} headers")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
