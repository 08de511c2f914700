# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Stability on stiff and extreme cases: runs the suite of unittest/stability and writes its page
and picture."""

import csv
import re

from speed import table

from .plots import COLORS, MARKERS, plt

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
*hang* (no end within the time allowed), a *crash* (a signal). The criterion of a case is from
theory or physics; what is found is the last value at which it holds, and what happens beyond it."""

# panels of the picture: case, pattern of its runs with the curve and the value, axis, log axis
PANELS = (
    ("stiffness contrast", r"(.-D), 20 spacings, 1e(\d) $", "E1/E2 = 10^x",
     "stress of the soft bar", False),
    ("hourglass", r"(.-D), ([\d.]+)$", "hourglass coefficient", "bending stress", True),
    ("kernels and horizons", r"(.-D, wendland|hexagonal, wendland), ([\d.]+)$", "horizon/spacing",
     "bending stress", False),
    ("jitter", r"(.-D), ([\d.]+), bending", "jitter/spacing", "bending stress", False),
)


def chosen(cases, full):
    return [one for one in cases if full or one.level != "full"]


def measure(store, cases, full, progress, data):
    """Runs what is not known yet. Two tables: of cases, and of their runs. Cases that are not
    run this time keep what was measured before."""
    rows, runs = known(data / "stability.csv", "case"), known(data / "stability_runs.csv", "case")
    for one in chosen(cases, full):
        record = store.get("stability", {"case": one.name, "level": one.level}, one.source(cases),
                           0, one.run)
        progress.tell(f"stability, {one.subject}, {one.name}: "
                      + ("met" if record["met"] else "NOT MET"), record["seconds"])
        rows[one.name] = [dict(record, level=one.level)]
        runs[one.name] = [dict(run, case=one.name) for run in record["runs"]]
    names = [one.name for one in cases]
    write(data / "stability.csv", COLUMNS, [row for name in names for row in rows.get(name, [])])
    write(data / "stability_runs.csv", RUN_COLUMNS,
          [run for name in names for run in runs.get(name, [])])


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


def picture(path, runs):
    """Errors against what is varied, of the cases that have them."""
    figure, axes = plt.subplots(2, 2, figsize=(9, 6.4))
    for ax, (case, pattern, name, quantity, logarithmic) in zip(axes.flat, PANELS):
        curves = {}
        for run in runs:
            found = re.match(pattern, run["value"]) if run["case"] == case else None
            if found and run["measured"]:
                curves.setdefault(found[1], []).append((float(found[2]), float(run["measured"])))
        for k, (label, points) in enumerate(curves.items()):
            ax.plot(*zip(*sorted(points)), color=COLORS[k], marker=MARKERS[k], ms=4, label=label)
        if logarithmic:
            ax.set_xscale("symlog", linthresh=1e-3)
        ax.set_xlabel(name)
        ax.set_ylabel(f"error of the {quantity}")
        ax.set_ylim(bottom=0)
        ax.grid(True, color="0.9", lw=0.6)
        if curves:
            ax.legend(fontsize=8, frameon=False)
        ax.set_title(case.capitalize(), fontsize=10)
    figure.tight_layout()
    figure.savefig(path, dpi=90, pil_kwargs={"optimize": True})
    plt.close(figure)


def cell(text):
    """Of a table."""
    return text.replace("|", "\\|")


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
                          *(cell(row[key]) for key in ("varied", "criterion", "limit", "beyond")),
                          ends(row)]
                         for row in mine], "---")]
    states = sorted({(row["commit"], row["date"]) for row in rows}, key=lambda state: state[::-1])
    parts.append("## Errors at the limits\n\n![Errors of static cases](images/stability.png)\n\n"
                 "Static cases: stress behind an interface, and of a bent bar of 12 rows (2-D), 8 rows "
                 "(3-D) or 14 rows (hexagonal), against the closed form.")
    long = [row["case"] for row in rows if row["level"] == "full"]
    parts.append("`./tmsph report --only stability`"
                 + (f", with `--full` for the long cases ({', '.join(long)})" if long else "")
                 + "; some of them are `./tmsph test -R Stability`. Commits "
                 + ", ".join(f"{commit} of {date}" for commit, date in states)
                 + "; [cases](data/stability.csv), [runs](data/stability_runs.csv). "
                 f"Machine: {rows[0]['machine']}.")
    return "\n\n".join(parts) + "\n"
