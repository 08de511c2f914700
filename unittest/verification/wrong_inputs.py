# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What the tests of wrong inputs share: small scenes in sections, of which a case replaces some,
and what lmp says about them."""

import re

from tmsph_testing import Script

LATTICE = "lattice custom 1e-3 a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0 0 0\n"
ROCK = "pair_coeff * * elastic 40e9 0.3 density 2700 expansion 1e-5"


def plate(width, height, middle, **sections):
    """Of two rocks, type 2 right of the middle; lengths in spacings of 1 mm."""
    return {
        "space": "units si\ndimension 2\nboundary s s p",
        "style": "atom_style tmsph",
        "skin": "",
        "box": f"{LATTICE}region box block 0 {width}e-3 0 {height}e-3 -0.5e-3 0.5e-3 units box\n"
               "create_box 2 box",
        "atoms": f"create_atoms 1 box\nregion right block {middle}e-3 INF INF INF INF INF "
                 "units box\nset region right type 2",
        "volume": "set group all volume 1e-6",
        **sections}


def cube(scene):
    """The same in 3-D."""
    return dict(scene, space="units si\ndimension 3\nboundary s s s",
                box=f"{LATTICE}region box block 0 5e-3 0 5e-3 0 5e-3 units box\ncreate_box 2 box",
                volume="set group all volume 1e-9")


def script(sections, files=None):
    return Script("\n".join(sections.values()), files)


def complaints(run, kinds=("ERROR", "WARNING")):
    return [line for line in run.log.splitlines() if line.startswith(kinds)]


def tells(lines, words):
    """Of what was said: one line, with these words in their order, "|" between them."""
    pattern = ".*".join(re.escape(word) for word in words.split("|"))
    return len(lines) == 1 and re.search(pattern, lines[0]) is not None
