# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Error against run time: measures the studies, evaluates them and writes their page."""

import csv
import math
import time

from speed import table

from . import plots
from .measure import middle, rounds_for, source_of
from .studies import JUDGED

COLUMNS = ["choice", "size", "h", "error", "seconds", "scatter", "rounds", "steps", "particles",
           "memory_MB", "ranks", "message", "commit", "date", "machine"]


def name_of(h, size):
    """A number of particles or steps, or else the size itself."""
    first = next(iter(size.values()))
    return first if isinstance(first, int) else f"{h:g}"


def cases(study, full):
    for label, choice in study.all_choices(full).items():
        for h, size in study.all_sizes(full):
            yield label, h, size, {**study.common, **size, **choice}


def run(study, parameters, tries=3):
    """One run of a scene; what LAMMPS refuses has no error but a message."""
    try:
        scene = study.scene(**parameters)
    except RuntimeError as error:
        lines = [line for line in str(error).splitlines() if line.startswith("ERROR")]
        if lines:
            return {"stopped": lines[-1][:200]}
        if tries > 1:    # a machine under load: MPI did not start
            return run(study, parameters, tries - 1)
        raise
    cost = scene.cost
    return {"error": float(study.error(scene)), "seconds": cost.seconds, "steps": cost.steps,
            "particles": cost.particles, "memory": cost.memory, "ranks": cost.ranks}


def measure(study, store, full, progress):
    """All rounds of all cases, those of one round one after another: rows of the table."""
    everything = list(cases(study, full))
    depends = source_of(study.scene)
    results = [[] for _ in everything]
    for number in range(5):
        for k, (label, *sizes, parameters) in enumerate(everything):
            done = results[k]
            if done and ("stopped" in done[0] or
                         number >= rounds_for(done[0], full)):
                continue
            start = time.monotonic()
            what = {"study": study.name, **parameters}
            done.append(store.get(study.name, what, depends, number,
                                  lambda: run(study, parameters)))
            if number == 0:
                progress.tell(f"{study.name}, {label}, {name_of(*sizes)}",
                              time.monotonic() - start)
    rows = []
    for (label, h, size, _), done in zip(everything, results):
        row = dict(choice=label, size=name_of(h, size), h=h, rounds=len(done),
                   commit=done[0]["commit"], date=done[0]["date"], machine=done[0]["machine"])
        if "stopped" in done[0]:
            row.update(error="stopped", message=done[0]["stopped"])
        else:
            seconds = [result["seconds"] for result in done]
            row.update(error=done[0]["error"], seconds=middle(seconds),
                       scatter=(max(seconds) - min(seconds)) / middle(seconds),
                       memory_MB=done[0]["memory"] / 2**20,
                       **{key: done[0][key] for key in ("steps", "particles", "ranks")})
        rows.append(row)
    return rows


def rounded(value):
    return f"{value:.4g}" if isinstance(value, float) else value


def write_table(path, rows):
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, COLUMNS, lineterminator="\n")
        writer.writeheader()
        writer.writerows({key: rounded(value) for key, value in row.items()} for row in rows)


def read_table(path):
    numbers = set(COLUMNS) - {"choice", "size", "message", "commit", "date", "machine"}
    with open(path, newline="") as file:
        return [{key: float(value) if key in numbers and value not in ("", "stopped") else value
                 for key, value in row.items()} for row in csv.DictReader(file)]


def of(rows, label):
    """The rows of a choice that ran, coarse to fine."""
    return [row for row in rows if row["choice"] == label and row["error"] != "stopped"]


def labels(rows):
    return list(dict.fromkeys(row["choice"] for row in rows))


def observed_order(rows):
    """Between the two finest sizes."""
    if len(rows) < 2:
        return None
    coarse, fine = rows[-2:]
    if not (coarse["error"] > 0 and fine["error"] > 0):
        return None
    return math.log(coarse["error"] / fine["error"]) / math.log(coarse["h"] / fine["h"])


def time_to(rows, target):
    """Run time to reach an error and to keep below it at all finer sizes, interpolated on log
    axes; None if it is not reached."""
    above = [k for k, row in enumerate(rows) if row["error"] > target]
    first = above[-1] + 1 if above else 0
    if first == len(rows):
        return None
    if not above or rows[first]["error"] <= 0:
        return rows[first]["seconds"]
    a, b = rows[first - 1], rows[first]
    share = math.log(a["error"] / target) / math.log(a["error"] / b["error"])
    return math.exp(math.log(a["seconds"]) * (1 - share) + math.log(b["seconds"]) * share)


def relative_time(study, rows, label):
    """Time of a choice to the error that the default has at its finest but one size, over that
    of the default; None if the choice does not reach it or was not tried."""
    default = of(rows, study.default)
    if len(default) < 2:
        return None
    here = default[-2]
    needed = time_to(of(rows, label), here["error"])
    return needed and needed / here["seconds"]


def against_front(study, rows):
    """How many times longer the default takes than the fastest of the choices that have a
    default in the package, and which choice that is."""
    best, which = 1.0, study.default
    for label in labels(rows):
        ratio = relative_time(study, rows, label) if label.startswith(JUDGED) else None
        if ratio and ratio < best:
            best, which = ratio, label
    return 1 / best, which


def comparison(measured):
    """All options in all scenes."""
    options = [label for label in dict.fromkeys(label for _, rows in measured for label in labels(rows))
               if label.startswith(JUDGED)]
    body = []
    for study, rows in measured:
        tried = set(labels(rows))
        cells = [(number(relative_time(study, rows, label)) or "-") if label in tried else ""
                 for label in options]
        if any(cells):
            body.append([study.title] + cells)
    return table(["scene"] + options, body)


def number(value, digits=2):
    return "" if value is None else f"{value:.{digits}g}"


def seconds(value):
    if value is None:
        return "not reached"
    return f"{value:.2g} s" if value >= 0.1 else f"{1e3 * value:.2g} ms"


def summary_row(study, rows):
    default = of(rows, study.default)
    finest = default[-1]
    ratio = against_front(study, rows)
    order = "exact" if study.exact else number(observed_order(default))
    front = "yes" if ratio[0] < 1.1 else f"no: {ratio[1]} is {ratio[0]:.1f} times faster"
    return [f"[{study.title}](#{anchor(study.title)})", f"{study.dimension}-D", order,
            f"{finest['error']:.2g}", f"{finest['particles']:.0f}", seconds(finest["seconds"]),
            seconds(time_to(default, study.target)) + f" to {study.target_text()}", front]


def anchor(title):
    return "".join(c for c in title.lower().replace(" ", "-") if c.isalnum() or c in "-_")


def section(study, rows):
    lines = [f"## {study.title}", study.text,
             f"![{study.title}: error against run time](images/{study.name}.png)"]
    body = []
    for label in labels(rows):
        runs = of(rows, label)
        tried = [row for row in rows if row["choice"] == label]
        if not runs:
            body.append([label, "", "stops", "", "", "", ""])
            continue
        last = runs[-1]
        order = "" if study.exact and label == study.default else number(observed_order(runs))
        if len(runs) < len(tried):
            label += f" (runs at {len(runs)} of {len(tried)} sizes)"
        body.append([label, order,
                     f"{last['error']:.2g}", seconds(last["seconds"]), f"{last['steps']:.0f}",
                     f"{last['memory_MB']:.0f}", seconds(time_to(runs, study.target))])
    finest = of(rows, study.default)[-1]["size"]
    lines.append(table([f"choice, at {study.size_name} {finest}", "order", study.error_name,
                        "run time", "steps", "memory, MB", f"time to {study.target_text()}"],
                       body))
    commits = "; ".join(dict.fromkeys(f"{row['commit']}, {row['date']}" for row in rows))
    repeated = [row["scatter"] for row in rows if row["error"] != "stopped" and row["rounds"] > 1]
    scatter = middle(repeated or [0.0])
    lines.append(f"`./tmsph report --only {study.name}`, commit {commits}; "
                 f"[data](data/{study.name}.csv). Repeated run times differ by "
                 f"{100 * scatter:.0f} % (median of largest less smallest).")
    return "\n\n".join(lines)


def picture(study, rows, folder):
    curves = {label: [(row["seconds"], max(row["error"], 1e-16)) for row in of(rows, label)]
              for label in labels(rows) if of(rows, label)}
    note = " (2 ranks: of each)" if any(row["ranks"] == 2 for row in rows) else ""
    plots.error_against_time(folder / f"{study.name}.png", study.title, curves, study.error_name,
                             study.default, study.target, note)


INTRODUCTION = """\
Each scene has an exact solution. It is run at several sizes with the defaults and with other
choices; a curve joins the sizes of one choice. The default is black: Wendland kernel, horizon of
3.015 spacings, St Venant-Kirchhoff law, thermal bonds, hourglass 0.1, no viscosity. The grey
staircase is the Pareto front: no point has less error in less time. Run time is that of the
processor in the loop of `run` or `minimize`, without set-up, on one core unless ranks are given;
the median of runs of which all take turns. The order is that between the two finest sizes.
The default counts as on the front if no other kernel, horizon, hourglass, thermal or elastic
law and no viscosity reaches the error of the default at its finest but one size in less than
1/1.1 of its time. A time to an error is that from which on all finer sizes keep below it. Where an
error passes through zero, the order means nothing."""


COMPARISON = """\
Run time to the error that the default has at its finest but one size, over the run time of the
default: below 1 is faster than the default; - does not reach that error at the sizes that were
run. Where the solution is smooth, as in waves and in the far field, a horizon of 2.5 spacings, the
quintic kernel, more hourglass control or the thermal strain in place of thermal bonds can be
faster. At the interface of two materials, where the stress jumps and cracks start, the default is
at the front or near it, and weak hourglass control or the thermal strain do not reach its error."""


def noise(measured):
    """Machine and scatter."""
    rows = [row for _, rows in measured for row in rows]
    machines = "; ".join(dict.fromkeys(row["machine"] for row in rows))
    scatter = sorted(row["scatter"] for row in rows if row["error"] != "stopped" and row["rounds"] > 1)
    text = f"Machine: {machines}."
    if scatter:
        text += (f" Repeated run times differ by {100 * scatter[len(scatter) // 2]:.0f} % (median of largest "
                 f"less smallest) and by more than {100 * scatter[9 * len(scatter) // 10]:.0f} % in a tenth "
                 "of the cases: those below some 20 ms, which are timed by the clock, and all if the "
                 "machine has other work.")
    return text


def page(measured):
    """measured: pairs of a study and its rows."""
    head = ["scene", "", "order", "error at the finest size", "particles", "run time",
            "time to an error", "default on the front"]
    rows = [summary_row(study, rows) for study, rows in measured]
    parts = ["# Error against run time", INTRODUCTION, noise(measured), "## Summary",
             table(head, rows), "## Every option in every scene", COMPARISON, comparison(measured)]
    return "\n\n".join(parts + [section(study, rows) for study, rows in measured]) + "\n"
