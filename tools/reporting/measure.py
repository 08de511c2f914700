# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Measurements that are kept: each is taken once for one state of the package, in a folder
outside of the checkout, so that a report that was stopped goes on where it was."""

import hashlib
import inspect
import json
import statistics
import sys
import time
from datetime import date
from pathlib import Path

from speed import commit, machine

ROOT = Path(__file__).resolve().parents[2]


def digest(*parts):
    return hashlib.sha256("\n".join(map(str, parts)).encode()).hexdigest()[:16]


def package_state():
    """Of the sources of the package: what the results depend on."""
    sources = sorted((ROOT / "src/TMSPH").glob("*.[ch]*"))
    return digest(*(path.name + path.read_text() for path in sources))


class Store:
    """Results by key, one line of a file each, in one file per study."""

    def __init__(self, folder, lmp):
        self.folder = Path(folder)
        self.folder.mkdir(parents=True, exist_ok=True)
        self.machine, self.commit = machine(lmp), commit()
        self.state = digest(self.machine, package_state())
        self.known = {}

    def read(self, study):
        path = self.folder / f"{study}.jsonl"
        rows = {}
        if path.exists():
            for line in path.read_text().splitlines():
                try:
                    row = json.loads(line)
                except ValueError:    # cut short when the report was stopped
                    continue
                rows[row["key"], row["round"]] = row
        self.known[study] = rows

    def get(self, study, what, depends, number, measure):
        """The result of one round of what, a dictionary; measured unless it is known. depends
        is text that the result depends on besides the package."""
        if study not in self.known:
            self.read(study)
        key = digest(self.state, json.dumps(what, sort_keys=True), depends)
        row = self.known[study].get((key, number))
        if row is None:
            row = dict(measure(), key=key, round=number, what=what, commit=self.commit,
                       machine=self.machine, date=str(date.today()))
            self.known[study][key, number] = row
            with open(self.folder / f"{study}.jsonl", "a") as file:
                file.write(json.dumps(row) + "\n")
        return row


def source_of(scene):
    """Text of the file in which a scene is defined, and of the inputs that it names."""
    files = [Path(inspect.getsourcefile(scene))]
    if hasattr(scene, "inputs"):
        files += sorted(path for path in scene.inputs.glob("*") if path.name.startswith("in.")
                        or path.suffix == ".lmp")
    return "".join(path.read_text() for path in files)


class Progress:
    """One line for each measurement, with the time that is left at the present pace."""

    def __init__(self, total):
        self.total, self.done, self.start, self.spent = total, 0, time.monotonic(), 0.0

    def tell(self, text, took):
        self.done += 1
        self.spent += took
        left = self.spent / self.done * (self.total - self.done)
        print(f"[{self.done}/{self.total}] {text}: {took:.1f} s, about {left / 60:.0f} min left",
              file=sys.stderr, flush=True)


def rounds_for(result, full):
    """How often a run is repeated: short ones scatter more."""
    seconds = result["seconds"]
    if full:
        return 5 if seconds < 5 else 3
    if result["ranks"] > 1:
        return 1
    return 3 if seconds < 0.1 else 2 if seconds < 1 else 1


def middle(values):
    return statistics.median(values)
