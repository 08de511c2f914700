# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What each feature costs, on the bodies of tools/speed: time, memory, communication and
instructions, alone and all together."""

import csv
import os
import re
import shutil
import subprocess
import tempfile
import time
from pathlib import Path

import speed
from speed import environment, table
from tmsph_testing import ALONE, Cost

from .measure import ROOT, digest, middle

INPUT = Path(speed.INPUTS) / "in.tmsph"
BARE = {"options": "hourglass 0", "expansion": "0"}
OFF = {"options": "hourglass 0 viscosity 0 0 thermal bond law svk kernel wendland", "expansion": "0",
       "break": "no", "contact": "no", "heat": "no"}

# feature: variables of the input besides those of the bare body
FEATURES = {
    "bare": {},
    "all words given, all off": OFF,
    "viscosity": {"options": "hourglass 0 viscosity 0.06 0"},
    "viscosity, 2nd term": {"options": "hourglass 0 viscosity 0.06 0.12"},
    "hourglass": {"options": "hourglass 0.1"},
    "thermal bonds": {"expansion": "1.0e-5"},
    "two materials": {"materials": 2},
    "heat, explicit": {"heat": "yes"},
    "heat, RKL2 over ten stable steps": {"heat": "yes", "heatwords": "subcycle rkl2 time/scale 200"},
    "break test": {"break": "yes"},
    "contact": {"contact": "yes"},
    "all": {"options": "hourglass 0.1 viscosity 0.06 0.12", "expansion": "1.0e-5", "materials": 2,
            "break": "yes", "contact": "yes", "heat": "yes"},
}
BODIES = {"disc": (2, 50, 300), "block": (3, 10, 60)}    # dimension, half width, steps
SMALL = {"disc": (2, 14, 20), "block": (3, 4, 10)}       # the same for counts of instructions
COLUMNS = ["body", "feature", "particles", "us", "ratio", "low", "high", "rounds", "bytes", "doubles",
           "more_doubles", "instructions", "instruction_ratio", "foreign", "commit", "date",
           "machine"]

# classes of the features, by words of their names; a bare body must not execute any of them
CLASSES = ("HoekBrown", "Contact", "Wall", "Heat", "Conduct", "FlatFaces", "BodySurface", "Debris",
           "Crack")


def variables(body, feature, bodies):
    dim, half, steps = bodies[body]
    return {**BARE, **FEATURES[feature], "dim": dim, "R": half, "steps": steps}


def run(lmp, body, feature):
    text, _ = speed.run(lmp, "tmsph", variables(body, feature, BODIES))
    cost = Cost(text, 1)
    more = re.findall(r"(\d+) doubles more per ghost", text)    # of breaking, of contact
    return {"us": 1e6 * cost.seconds / cost.particles / cost.steps, "particles": cost.particles,
            "bytes": cost.memory / cost.particles,
            "doubles": int(re.search(r"(\d+) doubles sent per ghost", text)[1]),
            "more_doubles": sum(map(int, more))}


def rounds_of(full):
    return 9 if full else 5


def number_of_tasks(counts, full):
    """As the progress counts them."""
    rounds = len(BODIES) * rounds_of(full) if counts else 0
    return rounds + (len(BODIES) * len(FEATURES) if "instructions" in counts else 0)


def measure(store, lmp, full, progress):
    depends = digest(INPUT.read_text(), (Path(speed.INPUTS) / "body.lmp").read_text())
    rounds = rounds_of(full)
    rows = []
    for body in BODIES:
        results = {feature: [] for feature in FEATURES}
        for number in range(rounds):
            order = list(FEATURES) if number % 2 == 0 else list(FEATURES)[::-1]
            start = time.monotonic()
            for feature in order:
                what = {"body": body, "feature": feature, "input": variables(body, feature, BODIES)}
                results[feature].append(store.get("costs", what, depends, number,
                                                  lambda: run(lmp, body, feature)))
            progress.tell(f"costs, {body}, round {number + 1}", time.monotonic() - start)
        for feature, runs in results.items():
            ratios = [a["us"] / b["us"] for a, b in zip(runs, results["bare"])]
            rows.append({**{key: runs[0][key] for key in COLUMNS if key in runs[0]},
                         "body": body, "feature": feature, "us": middle([r["us"] for r in runs]),
                         "ratio": middle(ratios), "low": min(ratios), "high": max(ratios),
                         "rounds": rounds})
    return rows


# ---- instructions ----

def portable():
    """An lmp with this package alone, without instructions of this processor that valgrind may not
    know."""
    others = ("MACHDYN", "PERI", "BPM", "GRANULAR", "MOLECULE", "EXTRA-FIX", "PLUGIN")
    options = " ".join(["-D TMSPH_TESTS=off"] + [f"-D PKG_{name}=off" for name in others])
    env = dict(os.environ, TMSPH_NATIVE="off", TMSPH_CMAKE=options)
    return subprocess.check_output([ROOT / "tmsph", "where"], text=True, env=env).strip()


def count(lmp, values):
    """Instructions of a run and the names of the functions that it executed."""
    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder, "profile")
        command = ["valgrind", "--tool=callgrind", f"--callgrind-out-file={out}", lmp, "-nocite", "-in",
                   INPUT, "-log", "none", "-screen", "none", "-var", "folder", speed.INPUTS]
        for key, value in values.items():
            command += ["-var", key, str(value)]
        env = dict(environment(), **ALONE)
        done = subprocess.run(command, cwd=folder, env=env, capture_output=True, text=True)
        if done.returncode:
            raise RuntimeError(done.stderr[-2000:])
        profile = out.read_text()
    total = int(re.search(r"^(?:totals|summary): (\d+)", profile, re.M)[1])
    names = set(re.findall(r"^fn=\(\d+\) (\S.*)", profile, re.M))
    return total, sorted({m[0] for name in names for m in [re.search(r"\w*TMSPH\w*::[~\w]+", name)]
                          if m and any(word in m[0] for word in CLASSES)})


def instructions(lmp, body, feature):
    """Per particle and step: the difference of a long and a short run."""
    values = variables(body, feature, SMALL)
    short, _ = count(lmp, values)
    long, foreign = count(lmp, dict(values, steps=2 * values["steps"]))
    text, _ = speed.run(lmp, "tmsph", values)
    n = Cost(text, 1).particles
    return {"instructions": (long - short) / values["steps"] / n, "foreign": " ".join(foreign)}


def add_instructions(store, rows, progress):
    """To the rows of the costs."""
    lmp = portable()
    depends = digest(INPUT.read_text())
    counts = {}
    for row in rows:
        body, feature = row["body"], row["feature"]
        start = time.monotonic()
        what = {"body": body, "feature": feature, "input": variables(body, feature, SMALL)}
        counts[body, feature] = store.get("instructions", what, depends, 0,
                                          lambda: instructions(lmp, body, feature))
        progress.tell(f"instructions, {body}, {feature}", time.monotonic() - start)
    for row in rows:
        mine, bare = counts[row["body"], row["feature"]], counts[row["body"], "bare"]
        row.update(instructions=mine["instructions"], foreign=mine["foreign"],
                   instruction_ratio=mine["instructions"] / bare["instructions"])


def keep_instructions(rows, before):
    """Those of an earlier report."""
    known = {(row["body"], row["feature"]): row for row in before}
    for row in rows:
        old = known.get((row["body"], row["feature"]), {})
        row.update({key: old.get(key, "") for key in ("instructions", "instruction_ratio", "foreign")})


def can_count():
    return shutil.which("valgrind") is not None


# ---- page ----

def write_table(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{value:.6g}" if isinstance(value, float) else value
                          for key, value in row.items()} for row in rows)


def read_table(path):
    texts = {"body", "feature", "foreign", "commit", "date", "machine"}
    with open(path, newline="") as file:
        return [{key: value if key in texts or value == "" else float(value)
                 for key, value in row.items()} for row in csv.DictReader(file)]


def body_table(rows):
    bare = rows[0]
    lines = []
    for row in rows:
        counted = row["instructions"] != ""
        lines.append([row["feature"], f"{row['ratio']:.2f} ({row['low']:.2f} to {row['high']:.2f})",
                      f"{row['bytes']:.0f}", f"{row['bytes'] - bare['bytes']:+.0f}",
                      f"{row['doubles'] + row['more_doubles']:.0f}",
                      f"{row['instructions']:.0f}" if counted else "",
                      f"{row['instruction_ratio']:.4f}" if counted else ""])
    return table(["feature", "time/bare", "bytes per particle", "more than bare",
                  "doubles per ghost and step", "instructions per particle and step", "/bare"], lines)


def page(rows):
    parts = ["# What each feature costs",
             "A bare elastic body (St Venant-Kirchhoff, no hourglass control) and the same with one "
             "feature each, then with all, from `tools/speed/in.tmsph`. Time is that of the processor in "
             "the loop, as a ratio to the bare body within a round in which all took turns; median, in "
             "brackets the smallest and largest. The microseconds are of a shared machine and differ from "
             "those of [speed](speed.md), which were measured at another time: compare ratios. Bytes are "
             "LAMMPS's own count, for everything. Doubles are "
             "those sent per ghost particle and step besides positions. Instructions are counted by "
             "callgrind on smaller bodies of a build with `TMSPH_NATIVE=off`, as the "
             "difference of a long and a short run, which leaves set-up out."]
    for body in dict.fromkeys(row["body"] for row in rows):
        mine = [row for row in rows if row["body"] == body]
        parts += [f"## {body.capitalize()}, {BODIES[body][0]}-D, {mine[0]['particles']:.0f} particles",
                  f"Bare: {mine[0]['us']:.3f} microseconds per particle and step.", body_table(mine)]
    counted = [row for row in rows if row["instructions"] != ""]
    if counted:
        off = {row["body"]: row["instruction_ratio"] for row in counted
               if row["feature"] == "all words given, all off"}
        foreign = sorted({name for row in counted for name in str(row["foreign"]).split()
                          if row["feature"] in ("bare", "all words given, all off")})
        parts += ["## What is not used costs nothing",
                  "With all words given but all features off, the instructions per particle and step are "
                  + " and ".join(f"{ratio:.5f} of those of the bare {body}" for body, ratio in off.items())
                  + ". Functions of breaking, contact, walls and heat that the bare bodies execute: "
                  + (", ".join(f"`{name}`" for name in foreign) if foreign else "none") + "."]
    first = rows[0]
    parts.append(f"`./tmsph report --only costs instructions`, commit {first['commit']}, {first['date']}; "
                 f"[data](data/costs.csv). Machine: {first['machine']}.")
    return "\n\n".join(parts) + "\n"
