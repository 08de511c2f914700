# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""tmsphplugin.so has all styles of the package, and runs with it give the numbers of the built-in
package. By default the plugin is loaded by the lmp that has the package; with TMSPH_STOCK=lmp
and TMSPH_PLUGIN=tmsphplugin.so by another, such as a LAMMPS without the package."""

import os
import re
from pathlib import Path

import numpy as np

from tmsph_testing import Script, main

ROOT = Path(__file__).resolve().parents[2]
LMP = os.environ["TMSPH_LMP"]
HOST = os.environ.get("TMSPH_STOCK", LMP)
PLUGIN = Path(os.environ.get("TMSPH_PLUGIN", Path(LMP).parent / "tmsphplugin.so")).resolve()
# the loader knows no styles of these kinds; they are in the runs below
UNLISTED = {"atom", "minimize"}

HEATED = """
atom_style tmsph
lattice sq 1e-3
region box block -1 13 -1 13 -0.5 0.5
create_box 1 box
region body block 0 12 0 12 -0.5 0.5
create_atoms 1 region body
set group all volume 1e-6 temperature 20
pair_style tmsph 3.015e-3
pair_coeff 1 1 elastic 40e9 0.3 density 2700 expansion 1.5e-5
fix break all tmsph/hoekbrown strength * 1500e6 mi * 8 weibull * 5 4711
fix move all nve
timestep 5e-8
variable hot atom 20+150*(x>0.006)
set group all temperature v_hot
thermo_style custom step pe ke press f_break
thermo_modify format float %.17g
thermo 20
run 100
unfix move
min_style tmsph/lbfgs
minimize 0 1e-3 20 100
"""


def declared():
    """Kinds and names of the styles in the headers of the package."""
    found = set()
    for header in (ROOT / "src/TMSPH").glob("*.h"):
        found.update(re.findall(r"^(\w+)Style\((tmsph[\w/]*),", header.read_text(), re.M))
    return {(kind.lower(), name) for kind, name in found}


def run(lmp, plugin):
    """Twice, with a clear in between, which unloads plugins and loads those of the folder
    again."""
    os.environ["TMSPH_LMP"] = lmp
    folder = {"LAMMPS_PLUGIN_PATH": str(PLUGIN.parent)} if plugin else {}
    os.environ.pop("LAMMPS_PLUGIN_PATH", None)
    os.environ.update(folder)
    head = "units si\ndimension 2\nboundary s s p\n"
    first = "plugin list\n" if plugin else ""
    return Script(first + head + HEATED + "clear\n" + head + HEATED).run()


def plugin(report):
    loaded, own = run(HOST, True), run(LMP, False)
    listed = set(re.findall(r"^ *\d+: (\w+) style plugin (\S+)", loaded.log, re.M))
    missing = {style for style in declared() if style[0] not in UNLISTED} - listed
    report.true("all styles are in the plugin", not missing, ", ".join(map(str, missing))
                or "none missing")
    report.true("runs", len(own.tables) == len(loaded.tables) == 4, "4 with and without the plugin")
    report.above("bonds broken", own.thermo("f_break")[-1], 0)
    for k, (a, b) in enumerate(zip(own.tables, loaded.tables), 1):
        report.true(f"run {k}, numbers of the plugin",
                    all(np.array_equal(a[name], b[name]) for name in a),
                    "those of the package, bit for bit")


if __name__ == "__main__":
    main(plugin)
