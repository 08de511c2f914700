# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The layers of src/TMSPH/README hold: a file includes only those of its own layer and of layers
above it in that list, the physics nothing of LAMMPS, and no two parts include each other."""

import re
import sys
from pathlib import Path

SOURCE = Path(__file__).resolve().parents[2] / "src/TMSPH"


def layers(text):
    """The files of each layer, in order, by the first word of its heading."""
    found, listed = {}, None
    for line in text[text.index("\nFiles, in four layers"):].splitlines()[4:]:
        file = re.match(r"  (\w+)\.(\{h,cpp\}|h|cpp)  ", line)
        if file:
            listed += [f"{file[1]}.{end}" for end in file[2].strip("{}").split(",")]
        elif line:
            listed = found.setdefault(re.match(r"\w+", line)[0], [])
    return found


def part(name, headers):
    """The header that a file belongs to: fix_tmsph_bond of fix_tmsph_bond_ids.cpp."""
    stem = name.rsplit(".", 1)[0]
    owners = [header for header in headers if (stem + "_").startswith(header + "_")]
    return max(owners, key=len, default=stem)


def reached(part_, needs):
    """All parts that one includes, directly or not."""
    seen, todo = set(), [part_]
    while todo:
        new = needs.get(todo.pop(), set()) - seen
        seen |= new
        todo += new
    return seen


def faults(texts, layered):
    """What is wrong with sources (by name) in layers (lists of names, lowest first)."""
    level = {name: k for k, names in enumerate(layered.values()) for name in names}
    titles = list(layered)
    headers = [name[:-2] for name in texts if name.endswith(".h")]
    found, needs = [], {}
    for name, text in texts.items():
        if name not in level:
            found.append(f"{name} is in no layer of src/TMSPH/README")
            continue
        for other in re.findall(r'^#include "(.*)"', text, re.M):
            if other not in texts:
                if level[name] == 0:
                    found.append(f"{name} is {titles[0]} and includes {other} of LAMMPS")
            elif level.get(other, 0) > level[name]:
                found.append(f"{name} is {titles[level[name]]} and includes {other} of "
                             f"{titles[level[other]]}")
            elif part(other, headers) != part(name, headers):
                needs.setdefault(part(name, headers), set()).add(part(other, headers))
        if level[name] == 0 and re.search(r"\bLAMMPS_NS\b|^#include <mpi\.h>", text, re.M):
            found.append(f"{name} is {titles[0]} and uses LAMMPS or MPI")
    circles = {tuple(sorted((a, b))) for a in needs for b in reached(a, needs)
               if a != b and a in reached(b, needs)}
    return found + [f"{a} and {b} include each other" for a, b in sorted(circles)]


def check_the_check():
    """Sources that break each rule are found."""
    layered = {"Physics": ["a.h"], "Bonds": ["b.h", "b_more.cpp"], "Styles": ["c.h", "d.h"]}
    good = {"a.h": "#include <cmath>\n", "b.h": '#include "a.h"\n#include "fix.h"\n',
            "b_more.cpp": '#include "b.h"\n', "c.h": '#include "b.h"\n', "d.h": '#include "c.h"\n'}
    wrong = [("a.h", '#include "b.h"'), ("a.h", '#include "atom.h"'), ("a.h", "#include <mpi.h>"),
             ("b_more.cpp", '#include "c.h"'), ("c.h", '#include "d.h"'), ("e.h", "")]
    missed = ["sound layers"] if faults(good, layered) else []
    for name, line in wrong:
        if len(faults({**good, name: good.get(name, "") + line + "\n"}, layered)) != 1:
            missed.append(f"{line} in {name}")
    return [f"this test misjudges {what}" for what in missed]


def main():
    texts = {path.name: path.read_text() for path in sorted(SOURCE.iterdir())
             if path.suffix in (".h", ".cpp")}
    layered = layers((SOURCE / "README").read_text())
    found = faults(texts, layered) + check_the_check()
    sizes = ", ".join(f"{len(names)} files of {title}" for title, names in layered.items())
    print("\n".join("FAIL " + fault for fault in found) if found else "ok   " + sizes)
    return 1 if found else 0


if __name__ == "__main__":
    sys.exit(main())
