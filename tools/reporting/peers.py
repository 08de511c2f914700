# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Error against run time of tmsph and of other methods of LAMMPS: studies and their page."""

from speed import table

from .accuracy import noise, of, seconds, section, time_to
from .peer_scenes import LIMIT, NAMES, Tension, Vibration
from .studies import Study

FLOOR = 1e-3    # the theories of bars and beams are not better


def peer_studies():
    def methods(dim):
        return {NAMES[method]: {"method": method} for method in LIMIT[dim]}

    def sizes(*values):
        return [(1 / n, {"n": n}) for n in values]
    text = {
        "bar2d": "A free bar, ten times as long as high, in plane strain, vibrates in its first "
                 "longitudinal mode. Error of the frequency against that of a slender bar with Love's "
                 "correction.",
        "bar3d": "The same in 3-D, with a square section.",
        "beam": "The same bar in its first bending mode, in plane strain, against Timoshenko's theory.",
        "disc": "A free disc in plane strain in its first radial mode, hexagonal lattice.",
        "ball": "A free ball in its first radial mode, cubic lattice.",
        "tension2d": "A bar four times as long as high, in plane strain, is pulled at both ends and "
                     "comes to rest under drag. Error of the strain between the quarters of its length.",
        "tension3d": "The same in 3-D, with a square section."}

    def study(name, title, scene, common, few, more):
        return Study(f"peers_{name}", title, text[name], scene, lambda run: abs(run.error),
                     "error of the strain" if scene is Tension else "error of the frequency",
                     common, sizes(*few), "n", methods(common["dim"]), sizes(*more),
                     dimension=common["dim"])
    return [
        study("bar2d", "Longitudinal vibration of a bar, 2-D", Vibration,
              {"scene": "bar", "dim": 2}, (4, 6, 8, 12), (16, 24, 32)),
        study("bar3d", "Longitudinal vibration of a bar, 3-D", Vibration,
              {"scene": "bar", "dim": 3}, (4, 6, 8), (12, 16)),
        study("beam", "Bending vibration of a beam, 2-D", Vibration,
              {"scene": "beam", "dim": 2}, (4, 6, 8, 12, 16, 24), (32,)),
        study("disc", "Radial vibration of a disc, 2-D", Vibration,
              {"scene": "disc", "dim": 2}, (8, 16, 32), (64, 128)),
        study("ball", "Radial vibration of a ball, 3-D", Vibration,
              {"scene": "ball", "dim": 3}, (5, 8, 12), (18, 27)),
        study("tension2d", "Bar in tension, 2-D", Tension, {"dim": 2}, (4, 6, 8, 12), (16, 24)),
        study("tension3d", "Bar in tension, 3-D", Tension, {"dim": 3}, (4, 6), (8, 12, 16))]


INTRODUCTION = """\
Elastic scenes with exact solutions that other methods of the same LAMMPS can do as well, with
the same particles and the same horizon of 3.015 spacings; inputs in `tools/peers`. Poisson's
ratio is 1/4, the only one of bonds with central forces, whose stiffness is set so that the
inside of a body has the right moduli. tmsph runs with its defaults, smd/tlsph with its usual
hourglass control of 10 and without viscosity, peri and bpm without breaking. Each method takes
0.8 of the largest time step that is stable in its scenes{limits}: found by trying, for peri/pmb
and bpm from the dispersion of their lattices. peri/lps is a 3-D model: it has no plane strain."""


def limits():
    return " (in units of spacing/speed of P waves: " + "; ".join(
        f"{dim}-D " + ", ".join(f"{NAMES[method]} {limit:g}" for method, limit in row.items())
        for dim, row in LIMIT.items()) + ")"


def advantage(rows, label):
    """How many times longer than tmsph a peer takes to an error that both reach."""
    mine, other = of(rows, NAMES["tmsph"]), of(rows, label)
    if not other:
        return ""
    target = max(other[-1]["error"], mine[-1]["error"], FLOOR)
    theirs, ours = time_to(other, target), time_to(mine, target)
    bound = "more than " if ours == mine[0]["seconds"] else ""
    return f"{bound}{theirs / ours:.1f} at {100 * target:.2g} %"


def page(measured):
    """measured: pairs of a study and its rows."""
    labels = [NAMES[method] for method in LIMIT[3] if method != "tmsph"]
    faster, reached = [], []
    for study, rows in measured:
        there = {row["choice"] for row in rows}
        faster.append([study.title] + [advantage(rows, label) if label in there else "cannot"
                                       for label in labels])
        reached.append([study.title] + [seconds(time_to(of(rows, label), study.target))
                                        if label in there else "cannot"
                                        for label in [NAMES["tmsph"]] + labels])
    parts = ["# Error against run time: other methods", INTRODUCTION.format(limits=limits()),
             noise(measured), "## tmsph is faster by", "At the larger of the errors of both at their finest sizes, and not below 0.1 %, as the theories "
             "of bars and beams are not better. \"More than\" where tmsph is better at its coarsest size.",
             table(["scene"] + labels, faster), "## Time to an error of 1 %",
             "\"Not reached\": at the sizes that were run.",
             table(["scene", "tmsph"] + labels, reached)]
    return "\n\n".join(parts + [section(study, rows) for study, rows in measured]) + "\n"
