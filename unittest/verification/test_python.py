# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""examples/python/disc.py, with LAMMPS's Python module and a liblammps.so that has the package.
Skipped, and said so, where LAMMPS was built without -D BUILD_SHARED_LIBS=on."""

import os
import subprocess
import sys
from pathlib import Path

from tmsph_testing import main

SCRIPT = Path(__file__).resolve().parents[2] / "examples/python/disc.py"
SKIPPED = 77    # for ctest
BUILD = Path(os.environ["TMSPH_LMP"]).resolve().parent


def script(report):
    if not (BUILD / "liblammps.so").exists():
        print(f'SKIPPED: there is no liblammps.so in {BUILD}: build with TMSPH_CMAKE="-D '
              'BUILD_SHARED_LIBS=on"')
        sys.exit(SKIPPED)
    paths = {"LD_LIBRARY_PATH": str(BUILD),
             "PYTHONPATH": str(Path(os.environ["LAMMPS_SOURCE_DIR"], "python"))}
    done = subprocess.run([sys.executable, str(SCRIPT)], env={**os.environ, **paths}, text=True,
                          capture_output=True, timeout=600)
    rows = [[float(word) for word in line.split()] for line in done.stdout.splitlines()[1:]]
    report.true("the script", done.returncode == 0 and not done.stderr,
                done.stderr or f"{len(rows)} rows")
    heated, broken, damaged, tension = zip(*rows)
    # until it breaks it is linear, but for strains of 1.5e-5 a degree and two digits in the table
    elastic = [s / T for s, T, b in zip(tension, heated, broken) if b == 0]
    report.true("elastic at first", len(elastic) > 2, f"{len(elastic)} rows without broken bonds")
    report.below("tension per degree, spread", max(elastic) / min(elastic) - 1, 0.01)
    report.true("it cracks", broken[-1] > broken[-2] > broken[0] == 0 and damaged[-1] > 0,
                f"{broken[-1]:.0f} bonds broken at {heated[-1]:.0f} degrees")


if __name__ == "__main__":
    main(script)
