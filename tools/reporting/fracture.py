# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Cracks whose bonds open: measures the scenes of fracture_scenes.py and writes their page."""

import csv
import time

from speed import table as markdown

from .fracture_plots import PICTURES, gains as gains_picture

NAME = "fracture"    # of all tables together
LAST = ["bars", "missed", "message", "seconds", "commit", "date", "machine"]
UNITS = {"spacing": "spacing, m", "dx": "spacing, m", "strength": "strength, Pa",
         "angle of the crack": "angle of the crack, degrees", "all": "loads behind it, from 0.9 to 0.3 of the peak"}
GAINED, GAINED_BAR = "gained by updates/dissipated", 1e-4    # the bar is that of the verification


class Collector:
    """Takes what a verification reports: values of one run, with their bars."""

    def __init__(self, apart=()):
        self.rows, self.apart = [], apart

    def _add(self, name, value, low=None, high=None):
        quantity = name.rpartition(": ")[2]
        if not any(quantity.endswith(text) for text in self.apart):
            self.rows.append([quantity, value, low, high])

    def below(self, name, value, bar):
        self._add(name, float(value), None, bar)

    def above(self, name, value, bar):
        self._add(name, float(value), bar, None)

    def within(self, name, value, low, high):
        self._add(name, float(value), low, high)

    def note(self, name, value):
        self._add(name, float(value) if isinstance(value, float) else str(value))


def bar_of(low, high):
    if low is None:
        return f"below {high:g}"
    return f"above {low:g}" if high is None else f"{low:g} to {high:g}"


def met(value, low, high):
    """As the verification judges: a NaN does not meet a bar."""
    if low is None:
        return value < high
    return value > low if high is None else low <= value <= high


def take(table, parameters):
    """One run; what LAMMPS refuses has a message."""
    start = time.monotonic()
    collector = Collector(table.spread[:1])
    try:
        curve, message = table.measure(collector, **parameters), ""
    except RuntimeError as error:
        lines = [line for line in str(error).splitlines() if line.startswith("ERROR")]
        if not lines:
            raise
        curve, message = None, lines[-1][:200]
    return {"quantities": collector.rows, "curve": curve or [], "message": message,
            "took": time.monotonic() - start}


def row_of(parameters, result):
    row = {key: str(value) for key, value in parameters.items()}
    bars, missed = [], []
    for name, value, low, high in result["quantities"]:
        row[name] = f"{value:.5g}" if isinstance(value, float) else value
        if low is not None or high is not None:
            bars.append(f"{name} = {bar_of(low, high)}")
            if not met(value, low, high):
                missed.append(name)
    return dict(row, bars="; ".join(bars), missed="; ".join(missed), message=result["message"],
                seconds=f"{result['took']:.3g}",
                **{key: result[key] for key in ("commit", "date", "machine")})


def key_of(table, row):
    return tuple(str(row[name]) for name in table.runs[0])


def measure(table, store, progress, data):
    """Runs what is not known yet. Tables are written after each run, so that one that is stopped has what
    was measured; runs that are not reached keep what was measured before."""
    rows = {key_of(table, row): row for row in read(data / f"{table.name}.csv")}
    curves = {}
    for row in read(data / f"{table.name}_curves.csv"):
        curves.setdefault(key_of(table, row), []).append(row)
    for parameters in table.runs:
        start = time.monotonic()
        result = store.get(table.name, parameters, table.depends(), 0, lambda: take(table, parameters))
        key = key_of(table, parameters)
        rows[key] = row_of(parameters, result)
        curves[key] = [dict(parameters, curve=name, x=f"{x:.5g}", y=f"{y:.5g}") for name, x, y in result["curve"]]
        write(data / f"{table.name}.csv", in_order(table, rows), LAST)
        points = [point for points in in_order(table, curves) for point in points]
        if points:
            write(data / f"{table.name}_curves.csv", points)
        progress.tell(f"{table.name}, {', '.join(key)}", time.monotonic() - start)


def in_order(table, rows):
    return [rows[key] for key in (key_of(table, parameters) for parameters in table.runs) if key in rows]


def write(path, rows, last=()):
    names = [name for row in rows for name in row if name not in last]
    with open(path, "w", newline="") as file:
        writer = csv.DictWriter(file, [*dict.fromkeys(names), *last], lineterminator="\n")
        writer.writeheader()
        writer.writerows(rows)


def read(path):
    if not path.exists():
        return []
    with open(path, newline="") as file:
        return list(csv.DictReader(file))


def number(text):
    """None if it is none."""
    try:
        return float(text)
    except ValueError:
        return None


# ---- Page ----

INTRODUCTION = """\
# Cracks whose bonds open

What `energy` of the breaking fixes gives: the energy of cracks, peaks of loads, their fall, paths of cracks. The
scenes and the bars are those of `unittest/verification`; a run that misses one of its bars says which. The
characteristic length l is E G/strength^2. `./tmsph report --only fracture` measures all tables, in an hour or two, can
be stopped and goes on; `--only fracture_energy` and so on measure one."""

LEFT = """\
## What is not here

Relaxed clouds in the plates, the beam and the test of Kalthoff and Winkler; the heated disc and the quenched plate with
a fracture energy. Inclined cracks: `unittest/verification/test_inclined_long.py`; branching: `test_branching.py`
there. Cost per step and memory: [costs](costs.md)."""


def bars_of(rows):
    """Lines on the bars of a table: of each quantity, how many runs meet it and which do not."""
    found = {}
    for row in rows:
        for text in filter(None, row["bars"].split("; ")):
            name, _, bar = text.partition(" = ")
            found.setdefault((name, bar), []).append(name not in row["missed"].split("; "))
    return [f"- Bar: {name} {bar}: {'met' if all(good) else 'NOT MET'} in {tally(good)}."
            for (name, bar), good in found.items()]


def tally(good):
    if all(good):
        return f"all {len(good)} runs" if len(good) > 1 else "the run"
    return f"{len(good) - sum(good)} of {len(good)} runs"


def spread_of(table, rows):
    """The same of the difference between runs that are to agree."""
    if not table.spread:
        return []
    name, quantity, by, bar = table.spread
    groups = {}
    for row in rows:
        value = number(row[quantity])
        if value is not None:
            groups.setdefault(tuple(row[key] for key in by), []).append(value)
    spreads = {key: max(values) - min(values) for key, values in groups.items() if len(values) > 1}
    if not spreads:
        return []
    good = [value < bar for value in spreads.values()]
    each = "; ".join(f"{', '.join(f'{name} {value}' for name, value in zip(by, key))}: {value:.3g}"
                     for key, value in spreads.items())
    many = tally(good).replace("run", "group")
    return [f"- Bar: {name} below {bar:g}: {'met' if all(good) else 'NOT MET'} in {many} ({each})."]


def cell(text):
    value = number(text)
    return text.strip("[]") if value is None else f"{value:.4g}"


def section(table, rows):
    names = [name for name in rows[0] if name not in LAST]
    judged = any(row["bars"] or row["message"] for row in rows)
    body = [[cell(row[name]) for name in names] + [row["message"] or row["missed"] or "none"] * judged for row in rows]
    missing = [", ".join(filter(None, key)) for key in (key_of(table, run) for run in table.runs)
               if key not in {key_of(table, row) for row in rows}]
    parts = [f"## {table.title}", table.text]
    if table.name in PICTURES:
        parts.append(f"![{table.title}](images/{table.name}.png)")
    parts.append(markdown([*(UNITS.get(name, name) for name in names), *["bars not met"] * judged], body))
    bars = bars_of(rows) + spread_of(table, rows)
    if bars:
        parts.append("\n".join(bars))
    if missing:
        parts.append(f"Not measured: {'; '.join(missing)}.")
    states = "; ".join(dict.fromkeys(f"{row['commit']}, {row['date']}" for row in rows))
    minutes = sum(float(row["seconds"]) for row in rows) / 60
    parts.append(f"`./tmsph report --only {table.name}`, commit {states}; [data](data/{table.name}.csv); "
                 f"{minutes:.0f} min.")
    return "\n\n".join(parts)


def gains(measured):
    """Energy that updates gained in all scenes."""
    body = []
    for table, rows in measured:
        values = gained(rows)
        if values:
            missed = sum(GAINED in row["missed"].split("; ") for row in rows)
            body.append([table.title, len(values), f"{max(values):.2g}", missed or "none"])
    if not body:
        return []
    return ["## Energy gained by updates of openings",
            "Sum of what single updates and removals gained, over what the openings took; from the "
            f"tables above. Bar: below {GAINED_BAR:g}.",
            f"![Energy gained](images/{NAME}_gains.png)",
            markdown(["scene", "runs", "largest gained/dissipated", "runs that miss the bar"], body)]


def page(measured):
    """measured: pairs of a table and its rows."""
    machines = "; ".join(dict.fromkeys(row["machine"] for _, rows in measured for row in rows))
    parts = [INTRODUCTION, f"Machine: {machines}."]
    parts += [section(table, rows) for table, rows in measured]
    return "\n\n".join(parts + gains(measured) + [LEFT]) + "\n"


# ---- Plots ----

def gained(rows):
    return [float(row[GAINED]) for row in rows if number(row.get(GAINED, "")) is not None]


def pictures(measured, data, images):
    """Of the tables that have one, of runs that were not refused."""
    ran = {table.name: [row for row in rows if not row["message"]] for table, rows in measured}
    for name in PICTURES.keys() & ran.keys():
        more = {"opening": ran.get("fracture_plates", [])} if name == "fracture_at_once" else {}
        PICTURES[name](ran[name], read(data / f"{name}_curves.csv"), images / f"{name}.png", **more)
    named = [(table.title, gained(rows)) for table, rows in measured if gained(rows)]
    if named:
        gains_picture(images / f"{NAME}_gains.png", named, GAINED_BAR)
