# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""All C++ stands as clang-format writes it, by .clang-format. Skipped without version 14, that of Debian 12: others
break some lines elsewhere."""

import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from test_layers import SOURCE

ROOT = SOURCE.parents[1]
VERSION = "version 14."


def format_program():
    """The program of that version, or None."""
    for name in ("clang-format-14", "clang-format"):
        program = shutil.which(name)
        if program and VERSION in subprocess.run([program, "--version"], text=True, stdout=subprocess.PIPE).stdout:
            return program
    return None


def misplaced(program, files):
    """Those of the files that it would change."""
    style = f"--style=file:{ROOT / '.clang-format'}"
    return [file for file in files
            if subprocess.run([program, style, str(file)], stdout=subprocess.PIPE).stdout != file.read_bytes()]


def main():
    program = format_program()
    if not program:
        print("skipped: no clang-format", VERSION)
        return 77
    files = [file for folder in ("src/TMSPH", "unittest/physics", "plugin") for ending in ("*.h", "*.cpp")
             for file in sorted((ROOT / folder).glob(ending))]
    found = [f"{file.relative_to(ROOT)}: clang-format -i" for file in misplaced(program, files)]
    with tempfile.TemporaryDirectory() as folder:
        wrong = Path(folder, "wrong.cpp")
        wrong.write_text("int  main( ) { return 0; }\n")
        if not misplaced(program, [wrong]):
            found.append("nothing found in a wrong file")
    print("\n".join("FAIL " + line for line in found) if found else f"ok   {len(files)} files")
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
