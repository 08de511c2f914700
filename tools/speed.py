#!/usr/bin/env python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Compares the speed and memory of tmsph with those of other methods in the same lmp, on the same particles.

Disc in 2-D and block in 3-D, each small and large, horizon 3.015 spacings, a linear field of velocities to start
with, constant time step; see the inputs in the folder speed. All cases run once in each round, one after another;
times are CPU seconds of the loop, and what is compared are ratios within a round, by their median.

  tools/speed.py                              all of it, about 5 minutes
  tools/speed.py --quick                      small bodies only, 2 rounds
  tools/speed.py --md doc/report/speed.md     also write the tables into that file
"""

import argparse
import csv
import os
import re
import statistics
import subprocess
import sys
import tempfile

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(HERE)
INPUTS = os.path.join(HERE, "speed")

# name, dimension, half width in spacings, steps of each input
SCENES = {
    "disc":        (2, 50, {"tmsph": 400, "tlsph": 40, "pmb": 100, "bpm": 400}),
    "block":       (3, 10, {"tmsph": 100, "tlsph": 15, "pmb": 40, "bpm": 100}),
    "disc large":  (2, 166, {"tmsph": 60, "tlsph": 6, "pmb": 20, "bpm": 60}),
    "block large": (3, 22, {"tmsph": 20, "tlsph": 3, "pmb": 6, "bpm": 20}),
}
LARGE = ("disc large", "block large")

# case: input, LAMMPS variables, ranks. "tmsph" is what the others are compared with: elastic, thermal bonds,
# hourglass control and viscosity
BARE = "hourglass 0"
CASES = {
    "tmsph":               ("tmsph", {}, 1),
    "smd/tlsph":           ("tlsph", {}, 1),
    "peri/pmb":            ("pmb", {}, 1),
    "bpm/spring":          ("bpm", {}, 1),
    "bare":                ("tmsph", {"options": BARE, "expansion": "0"}, 1),
    "hourglass":           ("tmsph", {"options": "hourglass 0.1", "expansion": "0"}, 1),
    "viscosity":           ("tmsph", {"options": BARE + " viscosity 0.06 0", "expansion": "0"}, 1),
    "viscosity, 2nd term": ("tmsph", {"options": BARE + " viscosity 0.06 0.12", "expansion": "0"}, 1),
    "thermal bonds":       ("tmsph", {"options": BARE}, 1),
    "thermal strain":      ("tmsph", {"options": BARE + " thermal strain"}, 1),
    "break test":          ("tmsph", {"break": "yes"}, 1),
    "2 ranks":             ("tmsph", {}, 2),
}
PEERS = ("smd/tlsph", "peri/pmb", "bpm/spring")
FEATURES = ("hourglass", "viscosity", "viscosity, 2nd term", "thermal bonds", "thermal strain", "tmsph", "break test")
GOALS = {("smd/tlsph", 2): 20, ("peri/pmb", 2): 4, ("smd/tlsph", 3): 10, ("peri/pmb", 3): 2.5,
         ("bpm/spring", 2): 1}


def environment():
    env = dict(os.environ, OMP_NUM_THREADS="1")
    if os.geteuid() == 0:
        env.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1")
    return env


def run(lmp, name, variables, ranks=1):
    """Runs an input; returns its log and the largest resident memory of the process in bytes."""
    with tempfile.TemporaryDirectory() as folder:
        log = os.path.join(folder, "log")
        command = [lmp, "-nocite", "-in", os.path.join(INPUTS, "in." + name), "-log", log, "-screen", "none",
                   "-var", "folder", INPUTS]
        for key, value in variables.items():
            command += ["-var", key, str(value)]
        if ranks > 1:
            command = ["mpirun", "--oversubscribe", "--bind-to", "none", "-np", str(ranks)] + command
        process = subprocess.Popen(command, env=environment(), stdout=subprocess.DEVNULL, cwd=folder)
        _, status, usage = os.wait4(process.pid, 0)
        process.returncode = status
        text = open(log).read() if os.path.exists(log) else ""
        if status:
            sys.exit("failed: %s\n%s" % (" ".join(command), "\n".join(text.splitlines()[-3:])))
        return text, usage.ru_maxrss * 1024


def measure(lmp, scene, case, empty):
    name, variables, ranks = CASES[case]
    dim, half, steps = SCENES[scene]
    text, memory = run(lmp, name, dict(variables, dim=dim, R=half, steps=steps[name]), ranks)
    wall, n = re.findall(r"Loop time of (\S+) on \d+ procs for \d+ steps with (\d+) atoms", text)[-1]
    share = float(re.findall(r"([\d.]+)% CPU use", text)[-1]) / 100
    wall, n = float(wall), int(n)
    own = float(re.findall(r"memory allocation \(min/avg/max\) = \S+ \| (\S+) \|", text)[-1]) * 2**20 * ranks
    seconds = wall if ranks > 1 else wall * min(1.0, share)    # ranks that wait are busy: wall clock
    return {"scene": scene, "case": case, "ranks": ranks, "particles": n, "steps": steps[name],
            "cpu_s": seconds, "wall_s": wall, "us": 1e6 * seconds / n / steps[name],
            "cpu_share": min(1.0, share), "bytes": (memory - empty) / n if ranks == 1 else "", "lammps_bytes": own / n}


def median(rows, key):
    return statistics.median(r[key] for r in rows)


class Results:
    def __init__(self, rows):
        self.rows = rows

    def of(self, scene, case):
        return [r for r in self.rows if r["scene"] == scene and r["case"] == case]

    def scenes(self):
        return [s for s in SCENES if self.of(s, "tmsph")]

    def ratio(self, scene, case, other):
        """Median, smallest and largest over the rounds of time(case)/time(other)."""
        each = [a["us"] / b["us"] for a, b in zip(self.of(scene, case), self.of(scene, other))]
        return statistics.median(each), min(each), max(each)


def table(head, rows, align="--:"):
    lines = ["| " + " | ".join(head) + " |", "| --- |" + f" {align} |" * (len(head) - 1)]
    return "\n".join(lines + ["| " + " | ".join(str(c) for c in row) + " |" for row in rows])


def peers(results):
    rows = []
    for scene in results.scenes():
        dim = SCENES[scene][0]
        for case in ("tmsph",) + PEERS:
            runs = results.of(scene, case)
            ratio, low, high = results.ratio(scene, case, "tmsph")
            rows.append(["%s, %d" % (scene.split()[0], runs[0]["particles"]), case, "%.3f" % median(runs, "us"),
                         "" if case == "tmsph" else "%.2f (%.2f to %.2f)" % (ratio, low, high),
                         GOALS.get((case, dim), ""), "%.0f" % median(runs, "bytes"),
                         "%.0f" % median(runs, "lammps_bytes")])
    return table(["body", "method", "us per particle and step", "tmsph is faster by", "goal", "bytes per particle",
                  "LAMMPS's own count of them"], rows)


def features(results):
    scenes = results.scenes()
    rows = [["bare elastic, us per particle and step"] +
            ["%.3f" % median(results.of(s, "bare"), "us") for s in scenes]]
    for case in FEATURES:
        other = "tmsph" if case == "break test" else "bare"
        label = {"tmsph": "hourglass, viscosity and thermal bonds", "break test": "these and the break test, x these"}
        row = [label.get(case, case)]
        for scene in scenes:
            row.append("%.2f" % results.ratio(scene, case, other)[0])
        rows.append(row)
    rows.append(["bytes per particle, bare"] + ["%.0f" % median(results.of(s, "bare"), "bytes") for s in scenes])
    rows.append(["with all"] + ["%.0f" % median(results.of(s, "tmsph"), "bytes") for s in scenes])
    rows.append(["with all and the break test"] +
                ["%.0f" % median(results.of(s, "break test"), "bytes") for s in scenes])
    return table(["time against bare elastic"] + scenes, rows)


def scaling(results):
    """Wall clock, and only of runs in which every rank had a core of its own: a rank that waits delays the other."""
    rows = []
    for scene in results.scenes():
        one = [r["wall_s"] * r["cpu_share"] for r in results.of(scene, "tmsph")]
        two = [r["wall_s"] for r in results.of(scene, "2 ranks") if r["cpu_share"] > 0.97]
        faster = "%.2f" % (statistics.median(one) / statistics.median(two)) if two else "machine was busy"
        rows.append([scene, "%d" % results.of(scene, "tmsph")[0]["particles"], faster, len(two)])
    return table(["body", "particles", "2 ranks are faster by", "undisturbed runs"], rows)


def machine(lmp):
    help_text = subprocess.run([lmp, "-h"], capture_output=True, text=True, env=environment()).stdout
    version = re.search(r"Simulator - (.*)", help_text)
    compiler = re.search(r"Compiler: (.*?) with", help_text)
    cpu = re.search(r"model name\s*: (.*)", open("/proc/cpuinfo").read()) if os.path.exists("/proc/cpuinfo") else None
    return ", ".join(head + m[1] for head, m in (("", cpu), ("LAMMPS ", version), ("", compiler)) if m)


def commit():
    """Short name of the commit of the checkout, with a + if src/TMSPH differs from it."""
    git = ["git", "-C", ROOT]
    head = subprocess.run(git + ["rev-parse", "--short", "HEAD"], capture_output=True, text=True)
    if head.returncode:
        return "unknown"
    changed = subprocess.run(git + ["status", "--porcelain", "src/TMSPH"], capture_output=True,
                             text=True).stdout.strip()
    return head.stdout.strip() + ("+" if changed else "")


def read(name):
    with open(name, newline="") as file:
        return [{key: value if key in ("scene", "case", "commit") else float(value or 0) for key, value in row.items()}
                for row in csv.DictReader(file)]


def compare(lmp, option):
    empty = run(lmp, "empty", {})[1]
    state = commit()
    rows = []
    for scene in SCENES:
        rounds = option.large if scene in LARGE else option.rounds
        for k in range(rounds):
            print("%s, round %d of %d" % (scene, k + 1, rounds), file=sys.stderr, flush=True)
            cases = list(CASES) if k % 2 == 0 else list(CASES)[::-1]
            rows += [dict(measure(lmp, scene, case, empty), round=k + 1, commit=state) for case in cases]
    with open(option.csv, "w", newline="") as file:
        writer = csv.DictWriter(file, ["round"] + [key for key in rows[0] if key != "round"])
        writer.writeheader()
        writer.writerows(rows)
    return rows


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--lmp", help="the lmp to run; that of ./tmsph where if not given")
    parser.add_argument("--rounds", type=int, default=5, help="rounds of the small bodies")
    parser.add_argument("--large", type=int, default=3, help="rounds of the large bodies; 0 for none")
    parser.add_argument("--quick", action="store_true", help="the same as --rounds 2 --large 0")
    parser.add_argument("--csv", default="speed.csv", help="file for the results of all runs")
    parser.add_argument("--md", help="file for the tables")
    parser.add_argument("--tables", action="store_true", help="only make the tables, of the runs in the csv file")
    option = parser.parse_args()
    if option.quick:
        option.rounds, option.large = 2, 0
    lmp = option.lmp or subprocess.check_output([os.path.join(ROOT, "tmsph"), "where"], text=True).strip()

    rows = read(option.csv) if option.tables else compare(lmp, option)
    results = Results(rows)
    command = "tools/speed.py" + (" --rounds %d --large %d" % (option.rounds, option.large))
    text = "\n\n".join([
        "# Speed and memory",
        "Made by `%s --md doc/report/speed.md`, commit %s, on one core (two for the last table) of: %s. Ratios are "
        "medians over rounds in which all methods took turns; in brackets the smallest and largest."
        % (command, rows[0]["commit"], machine(lmp)),
        "## Against other methods in the same lmp",
        "Same particles, same horizon of 3.015 spacings. tmsph has thermal bonds, hourglass control and viscosity on. "
        "Bytes are the resident memory at its highest, without that of an empty lmp.",
        peers(results),
        "## What features cost", features(results),
        "## Two ranks", scaling(results)]) + "\n"
    print(text)
    if option.md:
        os.makedirs(os.path.dirname(os.path.abspath(option.md)), exist_ok=True)
        with open(option.md, "w") as file:
            file.write(text)


if __name__ == "__main__":
    main()
