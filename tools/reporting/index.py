# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The page that links the others."""

PAGES = {
    "accuracy.md": "Error against run time of scenes with exact solutions, for every option",
    "peers.md": "The same against smd/tlsph, peri and bpm/spring on elastic scenes",
    "fracture.md": "Cracks whose bonds open: energies, peaks and branches beside finite elements, paths, at any spacing",
    "costs.md": "What each feature costs: time, memory, communication, instructions",
    "stability.md": "Stiff and extreme cases, run up to failure: limits, and what happens beyond them",
    "paper.md": "Figures and tables of Mu et al. (2022) beside ours: what agrees, what does not, why",
    "speed.md": "Speed and memory per particle and step against the same methods",
    "contact.md": "Contact and walls with friction: forces against closed forms, the disc with friction, cost",
    "heat.md": "Conduction of heat against closed forms: errors, orders, time steps, cracks",
    "incompressible.md": "Stresses near Poisson's ratio 1/2, one material and two",
    "quasistatic.md": "The minimizer, and the heated disc without inertia beside the dynamic one",
    "quench.md": "Cracks from thermal shock and thermal gradients: hollow cylinders, borehole, quenched plate",
    "peers_verification.md": "The verification problems of other codes, done with this one",
    "robustness.md": "Inputs changed at random, memory errors, sanitizers, other compilers: how runs end",
}

TEXT = """\
# What was measured

{pages}

`./tmsph report` makes {made} and their plots from runs, in some 10 minutes on two quiet cores;
`./tmsph report --full` takes more sizes, choices and repetitions, can be stopped and goes on where it
was; `--only NAME` measures one study, `--list` prints their names, `--pages` only writes the pages
anew from the data. `fracture.md` takes an hour or two and is measured by `--only fracture` or `--full`. Raw
results are in [data](data), one row for each choice and size, or each run. These five pages
have command and commit of the package under each table; on the others the command stands beside the
figures. Errors are reproduced to the digits given; run times to the scatter stated, on the same machine.
"""


def page(folder):
    there = {name: text for name, text in PAGES.items() if (folder / name).exists()}
    known = set(there) | {"README.md"}
    others = sorted(path.name for path in folder.glob("*.md") if path.name not in known)
    lines = [f"| [{name[:-3]}]({name}) | {text} |" for name, text in there.items()]
    lines += [f"| [{name[:-3]}]({name}) | {title(folder / name)} |" for name in others]
    return TEXT.format(pages="\n".join(["| page | |", "| --- | --- |"] + lines),
                       made="`accuracy.md`, `peers.md`, `costs.md` and `stability.md`")


def title(path):
    """The heading of a page."""
    return path.read_text().splitlines()[0].lstrip("# ")
