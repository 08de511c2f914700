# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Cases of the stability suite: each is run up to failure, and says what was varied, by which
criterion, what limit was found, and what happens beyond it. Every run of lmp must end by itself:
with finite numbers in all dumps and in the log, or with an error of this package that says why.

A case is a function in one of the files by subject (mechanics.py, ...):

    @case("name", "what is varied, from where to where", "criterion", level="quick")
    def some_name(bench):
        run = bench.run(scene, value, "fix 1 all nve\\nrun 1000")
        error = run.measured(...)
        return Found(limit="...", beyond="...", met=error < bar)
"""

import importlib
import inspect
import re
import sys
import time
from dataclasses import dataclass
from pathlib import Path

import numpy as np

sys.path.append(str(Path(__file__).resolve().parents[1] / "verification"))

from tmsph_testing import Script, main

# test: also a test of ./tmsph test; quick: in every report; full: in a report with --full
LEVELS = ("test", "quick", "full")

# ok: reached its end, all numbers finite; stopped: by an error of the package that says why;
# unclear: by an error of LAMMPS itself or without one; the others speak for themselves
GOOD, ENDS = ("ok", "stopped"), ("ok", "stopped", "unclear", "nan", "hang", "crash")

# what is watched in all runs
FIELDS = "sxx syy szz sxy sxz syz temperature damage"
COLUMNS = "x y z vx vy vz fx fy fz c_watch[*]"


@dataclass
class Found:
    """What a case found out: the limit, what happens beyond it, and whether its criterion is
    met."""
    limit: str
    beyond: str
    met: bool


@dataclass
class Case:
    name: str
    varied: str
    criterion: str
    function: object
    level: str
    subject: str

    def source(self, others):
        """Text that the result depends on: of this file and of the file of the case without
        the other cases in it."""
        text = Path(inspect.getsourcefile(self.function)).read_text()
        for other in others:
            if other is not self and other.subject == self.subject:
                text = text.replace(inspect.getsource(other.function), "")
        return text + Path(__file__).read_text()

    def run(self):
        """A record of the case: what was found, its runs, how they ended."""
        bench, start = Bench(), time.monotonic()
        try:
            found = self.function(bench)
        except (KeyError, IndexError):    # output that a case counted on is not there
            last = bench.runs[-1]
            if last.ok:
                raise
            found = Found(f"{last.value}: {last.end}, {last.message}", "", False)
        ends = [run.end for run in bench.runs]
        return {"subject": self.subject, "case": self.name, "varied": self.varied,
                "criterion": self.criterion, "limit": found.limit, "beyond": found.beyond,
                "met": bool(found.met), **{end: ends.count(end) for end in ENDS},
                "seconds": time.monotonic() - start, "runs": [run.record() for run in bench.runs]}


KNOWN = []    # all cases of the files that were imported


def case(name, varied, criterion, level="quick"):
    """Makes a case of a function of a bench."""
    assert level in LEVELS and name not in [known.name for known in KNOWN]

    def keep(function):
        subject = Path(inspect.getsourcefile(function)).stem
        KNOWN.append(Case(name, varied, criterion, function, level, subject))
        return function
    return keep


@dataclass
class Ended:
    """A run of lmp and how it ended."""
    value: object
    run: object
    end: str
    message: str
    figure: object = ""

    @property
    def ok(self):
        return self.end == "ok"

    def measured(self, figure):
        """Keeps a figure of the run for the table of raw data."""
        self.figure = float(figure)
        return self.figure

    def record(self):
        return {"value": self.value, "end": self.end, "measured": self.figure,
                "message": self.message, "steps": self.run.cost.steps}


class Bench:
    """Runs lmp for a case, and keeps how the runs ended."""

    def __init__(self):
        self.runs = []

    def run(self, scene, value, commands="run 0", every=100, timeout=60, ranks=1,
            group="all"):
        """Runs a scene, then the commands, with a dump of all fields of a group each so many steps
        and another one at the end. value: of what is varied, for the table of raw data."""
        script = Script("\n".join(scene.lines), scene.files)
        script.add(f"compute watch all tmsph/property/atom {FIELDS}")
        script.dump("watch", COLUMNS, every, group).add(commands).snapshot("final", COLUMNS, group)
        run = script.run(ranks, may_fail=True, timeout=timeout)
        self.runs.append(Ended(value, run, *classify(run)))
        return self.runs[-1]


def classify(run):
    """How a run ended, and the error if there is one."""
    errors = re.findall(r"^ERROR[^:]*: (.*?)(?: \((\S+):\d+\))?$", run.log, re.M)
    message = errors[0][0] if errors else ""
    if run.status is None:
        return "hang", message
    if run.status < 0 or run.status >= 128:
        return "crash", message
    if not finite(run):
        return "nan", message
    if run.status == 0:
        return "ok", message
    ours = len(errors) == 1 and "TMSPH/" in errors[0][1]
    return "stopped" if ours else "unclear", message or run.log[-200:]


def finite(run):
    """Whether all numbers that the run wrote are."""
    frames = [frame for frames in run.dumps.values() for frame in frames]
    return all(np.isfinite(column).all() for table in frames + run.tables
               for column in table.values())


# ---- what cases share ----

def marching(dt, steps):
    """So many time steps of fix nve."""
    return f"fix 1 all nve\ntimestep {dt:.17g}\nrun {steps}"


def unchecked_step(dt, spacing):
    """Runs with the time step dt even where the package would refuse it: fix dt/reset sets it
    after the first step."""
    return (f"timestep {1e-3 * dt:.17g}\n"
            f"fix unchecked all dt/reset 1 {dt:.17g} {dt * (1 + 1e-12):.17g} {spacing:.17g}\n")


def largest(holds, low, high, precision=0.01):
    """The largest value for which holds(value), by bisection of ratios: it holds at low and
    does not at high."""
    while high / low > 1 + precision:
        middle = (low * high) ** 0.5
        low, high = (middle, high) if holds(middle) else (low, middle)
    return low


def last_of(holds):
    """The last key, in order, up to which all values are true; None if the first is not."""
    last = None
    for value, true in holds.items():
        if not true:
            break
        last = value
    return last


# ---- tests ----

def judged(one):
    """A case of a report."""
    def judge(report):
        record = one.run()
        bad = {end: record[end] for end in ENDS if end not in GOOD and record[end]}
        report.true(f"{one.name}: {one.criterion}", record["met"], record["limit"])
        report.true(f"{one.name}: all runs end well", not bad,
                    ", ".join(f"{n} {end}" for end, n in bad.items()) or record["beyond"])

    judge.__name__ = one.function.__name__
    return judge


def tested(module):
    """Runs the cases of a file that are tests, and ends the test."""
    main(*(judged(one) for one in KNOWN
           if one.subject == module.__name__ and one.level == "test"))


# ---- the whole suite ----

SUBJECTS = ["mechanics", "discretization", "timestep", "dynamics", "fracture", "openings", "contact", "heat",
            "geometry", "units"]


def suite():
    """All cases, by subject."""
    here = Path(__file__).parent
    for subject in SUBJECTS:
        if (here / f"{subject}.py").exists():
            importlib.import_module(subject)
    return KNOWN
