# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Stability on stiff and extreme cases: runs the suite of unittest/stability and writes its page."""

import csv

from speed import table

COLUMNS = ["subject", "case", "varied", "criterion", "limit", "beyond", "met", "ok", "stopped",
           "unclear", "nan", "hang", "crash", "level", "commit", "date", "machine"]
RUN_COLUMNS = ["case", "value", "end", "measured", "steps", "message"]
ENDS = COLUMNS[7:13]

INTRO = """\
# Stability on stiff and extreme cases

Each case of `unittest/stability` is run up to failure. A run ends *ok* with finite numbers in every
dump of positions, velocities, forces, stresses, temperatures and damage and in the log, or is
*stopped* by an error of this package that says why and where. Everything else is a fault and is
counted: an *unclear* stop by another error, a *NaN* (or infinite number) in a dump or the log, a
*hang* (no end within the time allowed), a *crash* (a signal). The criterion of a case is from theory
or physics; what is found is the last value at which it holds, and what happens beyond it."""


def chosen(cases, full):
    return [one for one in cases if full or one.level != "full"]


def measure(store, cases, full, progress, data):
    """Runs what is not known yet. Two tables: of cases, and of their runs. Cases that are not
    run this time keep what was measured before."""
    rows, runs = known(data / "stability.csv", "case"), known(data / "stability_runs.csv", "case")
    for one in chosen(cases, full):
        record = store.get("stability", {"case": one.name, "level": one.level}, one.source(cases), 0,
                           one.run)
        progress.tell(f"stability, {one.subject}, {one.name}: {'met' if record['met'] else 'NOT MET'}",
                      record["seconds"])
        rows[one.name] = [dict(record, level=one.level)]
        runs[one.name] = [dict(run, case=one.name) for run in record["runs"]]
    names = [one.name for one in cases]
    write(data / "stability.csv", COLUMNS, [row for name in names for row in rows.get(name, [])])
    write(data / "stability_runs.csv", RUN_COLUMNS, [run for name in names for run in runs.get(name, [])])


def known(path, key):
    """Rows of a table that is there, by one of their columns."""
    found = {}
    for row in read(path) if path.exists() else []:
        found.setdefault(row[key], []).append(row)
    return found


def write(path, columns, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, columns, extrasaction="ignore", lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: f"{value:.6g}" if isinstance(value, float) else value
                          for key, value in row.items()} for row in rows)


def read(path):
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def ends(row):
    return ", ".join(f"{row[end]} {end}" for end in ENDS if int(row[end]))


def page(rows):
    total = {end: sum(int(row[end]) for row in rows) for end in ENDS}
    missed = [row["case"] for row in rows if row["met"] != "True"]
    parts = [INTRO, f"{len(rows)} cases, {sum(total.values())} runs of lmp: "
             + ", ".join(f"{number} {end}" for end, number in total.items()) + ". "
             + ("The criterion is met in all cases." if not missed else
                "The criterion is not met in: " + ", ".join(missed) + ".")]
    for subject in dict.fromkeys(row["subject"] for row in rows):
        mine = [row for row in rows if row["subject"] == subject]
        parts += [f"## {subject.capitalize()}",
                  table(["case", "varied", "criterion", "limit found", "beyond it", "runs"],
                        [[row["case"] + ("" if row["met"] == "True" else " (**not met**)"),
                          row["varied"], row["criterion"], row["limit"], row["beyond"], ends(row)]
                         for row in mine], "---")]
    states = sorted({(row["commit"], row["date"]) for row in rows}, key=lambda state: state[::-1])
    long = [row["case"] for row in rows if row["level"] == "full"]
    parts.append("`./tmsph report --only stability`"
                 + (f", with `--full` for the long cases ({', '.join(long)})" if long else "")
                 + "; some of them are `./tmsph test -R Stability`. Commits "
                 + ", ".join(f"{commit} of {date}" for commit, date in states)
                 + "; [cases](data/stability.csv), [runs](data/stability_runs.csv). "
                 f"Machine: {rows[0]['machine']}.")
    return "\n\n".join(parts) + "\n"
