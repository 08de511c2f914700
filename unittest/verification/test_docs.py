# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The documentation agrees with the code: every style has a page with its sections,
every keyword that a style reads is on its page, links lead somewhere, inputs, tools, tests and
styles that pages name exist, and what can be run is run: the inputs of the Howto and of the
tutorial, the usage in the material sets, and the skeletons for developers."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from tmsph_testing import main

ROOT = Path(__file__).resolve().parents[2]
SOURCE, PAGES, MATERIALS = ROOT / "src/TMSPH", ROOT / "doc/src", ROOT / "potentials"
EIGEN = Path("/usr/include/eigen3")
LMP = os.environ.get("TMSPH_LMP")

COMMON = ["Syntax", "Examples", "Description", "Restrictions", "Related commands", "Default"]
SECTIONS = {
    "pair": COMMON[:3] + ["Mixing, shift, table, tail correction, restart, rRESPA info"]
    + COMMON[3:],
    "fix": COMMON[:3] + ["Restart, fix_modify, output, run start/stop, minimize info"] + COMMON[3:],
    "compute": COMMON[:3] + ["Output info"] + COMMON[3:],
    "command": COMMON,
    "minimize": COMMON,
}
INDEX = {"pair": "pair_style {}", "fix": "fix {}", "compute": "compute {}", "command": "{}",
         "minimize": "min_style {}", "atom": "atom_style {}"}
IN_THE_HOWTO = ["atom_style tmsph", "fix tmsph/bond"]

# Styles whose input has words, by their pages: for scenes in 2-D and 3-D, lines with a question mark
# in the place of a word
PAIR, ROCK = "pair_style tmsph 3e-3", "pair_coeff 1 1 elastic 1e9 0.2"
CONTACT, HEAT = "fix 1 all tmsph/contact", "fix 1 all tmsph/heat"
BOUNDARY, WALL = "fix 1 all tmsph/heat/boundary", "fix 1 all tmsph/wall"
CRITERIA = [header.stem.rpartition("_")[2] for header in sorted(SOURCE.glob("fix_*.h"))
            if " = FixTMSPHBreakBy<" in header.read_text()]
BREAKS = [f"fix 1 all tmsph/{{0}} {word}?" for word in ("", "principal ", "scatter ", "softening ")]
WORDS = {
    "pair_tmsph": {2: [f"{PAIR} ?", *(f"{PAIR} {word} ?" for word in (
        "kernel", "plane", "law", "thermal", "dilatation")),
        f"{PAIR}\npair_coeff 1 1 ?", f"{PAIR}\n{ROCK} ?"]},
    **{f"fix_tmsph_{name}": {2: [line.format(name) for line in BREAKS]} for name in CRITERIA},
    "fix_tmsph_contact": {2: [f"{CONTACT} ?", f"{CONTACT} method ?", f"{CONTACT} law ?"]},
    "fix_tmsph_wall": {
        2: [f"{WALL} ?", f"{WALL} polyline ?", *(f"{WALL} line 0 0 1 0 {words}" for words in (
            "?", "side ?", "law ?", "velocity ? 0", "load ? 0 mass 1", "load 0 0 ? 1"))],
        3: [f"{WALL} ?"]},
    "fix_tmsph_heat": {2: [f"{HEAT} {word}?" for word in (
        "", "conductivity 1 ", "specific/heat 1 ", "subcycle ")]},
    "fix_tmsph_heat_boundary": {2: [f"{BOUNDARY} ?", f"{BOUNDARY} flux 1 ?",
                                    f"{BOUNDARY} flux 1 place ?"]},
    "compute_tmsph_property_atom": {2: ["compute 1 all tmsph/property/atom ?"]},
    "compute_tmsph_bond_local": {2: [f"compute 1 all tmsph/bond/local {word}?"
                                     for word in ("", "only ")]},
    "compute_tmsph_crack_tip": {2: [f"compute 1 all tmsph/crack/tip {word}?" for word in ("", "x ")]},
    "tmsph_cut": {2: ["tmsph/cut all ?"], 3: ["tmsph/cut all ?"]},
    "tmsph_relax": {2: ["tmsph/relax all ?"], 3: ["tmsph/relax all ?"]},
    "tmsph_quasistatic": {2: ["tmsph/quasistatic 1 ?"]},
    "min_tmsph_lbfgs": {2: ["min_style tmsph/lbfgs\nmin_modify memory ?"]},
}
NO_WORDS = ["atom_vec_tmsph", "fix_tmsph_bond", "compute_tmsph_crack", "compute_tmsph_dt",
            "compute_tmsph_wall_local"]
SPACE = {d: f"dimension {d}\natom_style tmsph\nregion 1 block -1 1 -1 1 -1 1\ncreate_box 1 1\n"
         for d in (2, 3)}

faults = []


def check(condition, fault):
    if not condition:
        faults.append(fault)


def styles():
    """(kind, name, header) of every style that the headers register."""
    for header in sorted(SOURCE.glob("*.h")):
        found = re.search(r"^(\w+)Style\(([\w/]+),", header.read_text(), re.M)
        if found:
            yield found[1].lower(), found[2], header


def words_on(page):
    """Words in italics in the Syntax section of a page; values of yes and no go without saying."""
    syntax = page[page.index("\nSyntax\n"):page.index("\nExamples\n")]
    syntax = syntax.replace("the group must be *all*", "")
    return set(re.findall(r"(?<![\w*])\*([\w/]+)\*(?![\w*])", syntax)) - {"yes", "no"}


def words_of(lines, space):
    """What lmp knows where each line has a question mark: it is no word, and the error lists them.
    Messages that list nothing are returned as well."""
    known, silent = set(), []
    lists = "Unknown .*: use (.*)|Expected (.*) for .*, not|needs the (mass) of"
    for line in lines:
        said = complain(f"{SPACE[space]}{line}\n")
        found = re.search(lists, said)
        if found:
            listed = re.split(", | or ", next(filter(None, found.groups())))
            listed.append(line.partition(" ?")[0].split()[-1])    # whose value is asked for
            known.update(word for word in listed if re.fullmatch(r"(?!v_)[A-Za-z][\w/]*", word))
        else:
            silent.append(f"{line}: {said}")
    return known, silent


def titles(text):
    """Headings with their underlines, in order."""
    return re.findall(r"^(\S.*)\n([=\"^\-])\2+\n", text, re.M)


def check_page(path):
    text = path.read_text()
    check(text.isascii(), f"{path.name} has characters outside of ASCII")
    lines = text.split("\n")
    for k, (line, below) in enumerate(zip(lines, lines[1:])):
        check(line == line.rstrip(), f"{path.name}:{k + 1} ends with blanks")
        if re.fullmatch(r'(=|"|\^)\1{2,}', below) and line:
            check(len(line) == len(below), f"{path.name}:{k + 1} has an underline of other length")
    for target in re.findall(r":doc:`[^`]*<([^>`]+)>`", text.replace("\n", " ")):
        if "tmsph" in target:
            check((PAGES / (target + ".rst")).exists(),
                  f"{path.name} refers to {target}, no such page")
    for label in re.findall(r":ref:`[^`]*<([^>`]+)>`", text):
        check(f".. _{label}:" in text, f"{path.name} refers to {label}, which is not in it")


def check_styles():
    howto = (PAGES / "Howto_tmsph.rst").read_text()
    package = (SOURCE / "README").read_text()
    for kind, name, header in styles():
        index = INDEX[kind].format(name)
        check(re.search(rf"^ .*{re.escape(name)}\b", package, re.M),
              f"{index} is not in src/TMSPH/README")
        if index in IN_THE_HOWTO:
            check(f".. index:: {index}\n" in howto, f"Howto_tmsph.rst has no index entry {index}")
            continue
        page = PAGES / (header.stem + ".rst")
        if not page.exists():
            faults.append(f"{index} has no page {page.name}")
            continue
        text = page.read_text()
        check(text.startswith(f".. index:: {index}\n"), f"{page.name} has no index entry {index}")
        heads = [title for title, line in titles(text)]
        check(heads[:1] == [f"{index} command"],
              f"the title of {page.name} is not '{index} command'")
        present = [title for title in heads if title in SECTIONS[kind]]
        check(present == SECTIONS[kind],
              f"the sections of {page.name} are {present}, not {SECTIONS[kind]}")
        check(f"({'doc/src/' + page.name})" in (ROOT / "README.md").read_text(),
              f"README.md has no link to {page.name}")


def check_words():
    """What pages say of words is what lmp knows."""
    other = {header.stem for _, _, header in styles()} ^ (set(WORDS) | set(NO_WORDS))
    check(not other, f"WORDS and NO_WORDS of this test have other styles than there are: "
                     f"{sorted(other)}")
    for name, places in WORDS.items():
        page = (PAGES / f"{name}.rst").read_text()
        known = set()
        for space, lines in places.items():
            found, silent = words_of(lines, space)
            known |= found
            for said in silent:
                faults.append(f"lmp does not list the words of {said}")
        for word in sorted(known):
            check(re.search(rf"(?<![\w/]){re.escape(word)}(?![\w/])", page),
                  f"{name}.rst does not mention '{word}', which lmp reads")
        for word in sorted(words_on(page) - known):
            faults.append(f"{name}.rst has '{word}', which lmp does not know")
    print(f"{sum(len(lines) for places in WORDS.values() for lines in places.values())} places")


def check_map_of_files():
    text = (SOURCE / "README").read_text()
    listed = set()
    for name, endings in re.findall(r"^  (\w+)\.(\{h,cpp\}|h|cpp)  ", text, re.M):
        listed.update(f"{name}.{end}" for end in endings.strip("{}").split(","))
    there = {path.name for path in SOURCE.iterdir() if path.suffix in (".h", ".cpp")}
    check(listed == there, f"src/TMSPH/README lists other files than there are: "
                           f"{sorted(listed ^ there)}")


def anchors(path):
    """The names by which sections of a Markdown page can be linked to."""
    return {re.sub(r"[^\w -]", "", head).strip().lower().replace(" ", "-")
            for head in re.findall(r"^#+ (.*)", path.read_text(), re.M)}


def check_markdown(path):
    """Links lead somewhere, and what is named can be run: inputs, tools, tests, styles."""
    text, name = path.read_text(), path.relative_to(ROOT)
    for target in re.findall(r"\]\(([^)\s]+)\)", text):
        file, _, section = target.partition("#")
        there = path.parent / file if file else path
        if "://" in target:
            continue
        if "images/" in file and not (path.parent / file).parent.exists():
            print(f"no pictures in this checkout: {target} not checked")
        elif not there.exists():
            check(False, f"{name} links to {target}, which does not exist")
        elif section:
            check(section in anchors(there), f"{name} links to {target}, no such section")
    for target in re.findall(r"tmsph run ((?:examples|tools)/\S+[\w.])", text):
        check((ROOT / target).exists(), f"{name} runs {target}, which does not exist")
    for target in re.findall(r"(?<![\w/])(?:\.\./)*(tools/\w+\.py)", text):
        check((ROOT / target).exists(), f"{name} names {target}, which does not exist")
    for target in re.findall(r"(?<!\w)test_[a-z]\w+\b(?!\()", text):
        check((ROOT / f"unittest/verification/{target}.py").exists() or target == "test_physics"
              or (ROOT / f"unittest/physics/{target}.cpp").exists(),
              f"{name} names {target}, no such test")
    known = {style for _, style, _ in styles()} | set(IN_THE_HOWTO[1].split())
    for target in re.findall(r"(?<![\w/])tmsph/[a-z][a-z/]*[a-z]", text):
        check(target in known, f"{name} names {target}, no such style")


def check_tutorial():
    """Its blocks one after the other, and with that of contact behind the rocks, coarsely; and its
    other scene, which cracks, but not before it is warm."""
    text = (ROOT / "doc/tutorial.md").read_text()
    blocks = re.findall(r"^```lammps( contact)?\n(.*?)^```", text, re.M | re.S)
    touching = "".join(block for contact, block in blocks if contact)
    plain = [block for contact, block in blocks if not contact]
    check(len(plain) == 4 and touching, "doc/tutorial.md has other blocks than this test knows")
    for what, parts in (("bonded", plain), ("in contact", plain[:2] + [touching] + plain[2:])):
        out = run("variable dx index 1e-3\n" + "\n".join(parts),
                  f"input of doc/tutorial.md, {what}")
        broken = re.findall(r"^ +10000 +260 +(\d+)", out, re.M)
        check(broken and int(broken[0]) > 50,
              f"the disc of doc/tutorial.md, {what}, does not crack")
    square = re.search(r"^```lammps square\n(.*?)^```", text, re.M | re.S)[1]
    out = run("variable dx index 2e-3\n" + square, "the square of doc/tutorial.md")
    broken = [int(count) for count in re.findall(r"^ +(?:20|160) +\d+ +(\d+)", out, re.M)]
    check(len(broken) == 2 and broken[0] == 0 < broken[1],
          f"the square of doc/tutorial.md breaks {broken} bonds by 30 and 100 degrees")


def run(text, what):
    """Runs an input, as from a folder of examples; returns what lmp printed."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder, "examples/name")
        place.mkdir(parents=True)
        Path(folder, "potentials").symlink_to(MATERIALS)
        (place / "in.name").write_text(text)
        done = subprocess.run([LMP, "-in", "in.name", "-log", "none"], cwd=place, text=True,
                              capture_output=True, timeout=600)
    error = re.search(r"^ERROR.*", done.stdout + done.stderr, re.M)
    check(done.returncode == 0 and not error, f"{what}: {error[0] if error else done.returncode}")
    return done.stdout


def complain(text):
    """The error with which an input ends."""
    with tempfile.TemporaryDirectory() as folder:
        done = subprocess.run([LMP, "-log", "none"], cwd=folder, text=True, input=text,
                              capture_output=True, timeout=60)
    error = re.search(r"^ERROR: (.*?)(?: \(\S+:\d+\))?$", done.stdout + done.stderr, re.M)
    return error[1] if error else "no error"


def check_howto():
    text = (PAGES / "Howto_tmsph.rst").read_text()
    text = text[text.index("Quick start"):]
    block = re.search(r"code-block:: LAMMPS\n((?:   .*\n|\s*\n)+)", text)[1]
    out = run(re.sub(r"^   ", "", block, flags=re.M), "input of Howto_tmsph.rst")
    last = re.findall(r"^ +2000 +200 +(\d+)", out, re.M)
    check(last and int(last[0]) > 0, "the disc of Howto_tmsph.rst does not crack")


def check_recipe():
    """The test that unittest/README.md shows how to write."""
    text = (ROOT / "unittest/README.md").read_text()
    block = re.search(r"^```python\n(.*?)^```", text, re.M | re.S)[1]
    with tempfile.TemporaryDirectory() as folder:
        Path(folder, "test_it.py").write_text(block)
        done = subprocess.run([sys.executable, "test_it.py"], cwd=folder, text=True, timeout=600,
                              capture_output=True,
                              env={**os.environ, "PYTHONPATH": str(Path(__file__).parent)})
    check(done.returncode == 0 and done.stdout.count("ok  ") == 2,
          f"the test of unittest/README.md: {done.stdout}{done.stderr}")


def check_developers():
    """Files, functions, classes and constants that doc/developers.md names exist, and what it shows
    in C++ compiles."""
    text = (ROOT / "doc/developers.md").read_text()
    known = {path.name for path in ROOT.rglob("*") if ".git" not in path.parts}
    sources = [path for folder in (SOURCE, ROOT / "unittest/physics") for path in folder.iterdir()
               if path.suffix in (".h", ".cpp")]
    words = set(re.findall(r"\w+", "\n".join(path.read_text() for path in sources)))
    blocks = re.findall(r"^```cpp\n(.*?)^```", text, re.M | re.S)
    for name in re.findall(r"`([^`\n]+)`", re.sub(r"^```.*?^```", "", text, flags=re.M | re.S)):
        file = re.fullmatch(r"(?:[\w/.]+/)?([\w.-]+\.(?:h|cpp|rst|py|patch|txt))", name)
        if file:
            check(file[1] in known or file[1] == "tmsph_tresca.h",
                  f"doc/developers.md names {name}, no such file")
        elif re.fullmatch(r"[A-Z]\w+|(\w+::)?\w+\([^)]*\)", name):
            for word in re.findall(r"\w+", name.partition("(")[0]):
                check(word in words, f"doc/developers.md names {name}, which is not in the code")
    compiler = shutil.which("g++") or shutil.which("c++")
    if not compiler or not EIGEN.exists():
        print("no compiler or no Eigen: C++ of doc/developers.md not checked")
        return
    for block in blocks:
        done = subprocess.run([compiler, "-std=c++17", "-Wall", "-Wextra", "-Werror",
                               "-fsyntax-only", "-I", SOURCE, "-isystem", EIGEN, "-x", "c++", "-"],
                              input=block, capture_output=True, text=True)
        check(done.returncode == 0, f"C++ of doc/developers.md: {done.stderr}")
    check(len(blocks) == 2, "doc/developers.md has other blocks of C++ than this test knows")


BODY = """
units si
dimension 2
boundary s s p
atom_style tmsph
lattice sq 1e-3
region box block 0 0.01 0 0.01 -0.0005 0.0005 units box
create_box 1 box
create_atoms 1 box
set group all volume 1e-9
pair_style tmsph 3.015e-3
"""


def check_materials():
    sets = sorted(MATERIALS.glob("*.tmsph"))
    check(sets, "there are no material sets in potentials")
    for path in sets:
        text = path.read_text()
        check(text.isascii(), f"{path.name} has characters outside of ASCII")
        check(text.startswith("# UNITS: "), f"{path.name} does not start with its units")
        names = re.findall(r"^variable +(\w+) +index +\S", text, re.M)
        check(len(names) == len(re.findall(r"^(?!#)\S", text, re.M)),
              f"{path.name} has other lines than index-style variables")
        example = r"^# ((?:include|pair_coeff|fix) .*|  +expansion.*)"
        usage = "\n".join(re.findall(example, text, re.M))
        check("include" in usage and "pair_coeff" in usage,
              f"{path.name} does not tell how to use it")
        prints = "".join(f'print "value {name} ${{{name}}}"\n' for name in names)
        out = run(BODY + usage + "\nrun 0\n" + prints, path.name)
        values = dict(re.findall(r"^value (\w+) (\S+)$", out, re.M))
        for name in names:
            check(re.fullmatch(r"[0-9.]+(e[+-]?\d+)?", values.get(name, "")),
                  f"{path.name}: {name} is '{values.get(name)}', not a number")


def check_pages():
    for page in sorted(PAGES.glob("*.rst")):
        check_page(page)
    print(f"{len(list(styles()))} styles documented")


def check_texts():
    for page in [*sorted(ROOT.glob("*.md")), ROOT / "examples/README.md",
                 ROOT / "unittest/README.md", *sorted((ROOT / "doc").glob("*.md")),
                 *sorted((ROOT / "doc/report").glob("*.md"))]:
        check_markdown(page)


def case(checks):
    """A case of a report: the checks find no fault."""
    def judged(report):
        faults.clear()
        checks()
        report.true(checks.__name__.replace("check_", ""), not faults,
                    "\n".join(faults) or "no faults")

    judged.__name__ = checks.__name__.replace("check_", "")
    return judged


if __name__ == "__main__":
    CHECKS = [check_pages, check_styles, check_map_of_files, check_developers, check_texts]
    if LMP:
        CHECKS += [check_words, check_tutorial, check_howto, check_recipe, check_materials]
    else:
        print("TMSPH_LMP is not set: nothing run")
    main(*map(case, CHECKS))
