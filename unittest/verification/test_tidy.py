# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""clang-tidy finds nothing in the headers of the physics, by the checks of .clang-tidy. Skipped
without it."""

import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from test_layers import SOURCE, layers

ROOT = SOURCE.parents[1]
EIGEN = Path("/usr/include/eigen3")


def tidy(file, flags):
    """What clang-tidy says of a file and its headers, a line each."""
    done = subprocess.run(["clang-tidy", "--quiet", f"--config-file={ROOT / '.clang-tidy'}",
                           str(file), "--", "-std=c++17", *flags],
                          text=True, stdout=subprocess.PIPE, stderr=subprocess.DEVNULL)
    found = sorted(set(re.findall(r"^.*: (?:warning|error): .*", done.stdout, re.M)))
    return found or ([f"clang-tidy ended with {done.returncode}"] if done.returncode else [])


def main():
    if not shutil.which("clang-tidy") or not EIGEN.exists():
        print("skipped: no", EIGEN if shutil.which("clang-tidy") else "clang-tidy")
        return 77
    physics = layers((SOURCE / "README").read_text())["Physics"]
    names = [name for name in physics if name.endswith(".h")]
    with tempfile.TemporaryDirectory() as folder:
        headers = Path(folder, "headers.cpp")
        headers.write_text("".join(f'#include "{name}"\n' for name in names))
        found = tidy(headers, ["-I", str(SOURCE), "-isystem", str(EIGEN)])
        wrong = Path(folder, "src/TMSPH/wrong.cpp")
        wrong.parent.mkdir(parents=True)
        wrong.write_text("int *nothing() { return 0; }\n")
        if not tidy(wrong, []):
            found.append("nothing found in a wrong file")
    print("\n".join("FAIL " + line for line in found) if found
          else f"ok   {len(names)} headers of the physics")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
