#!/usr/bin/env python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Measures and writes the tables, plots and pages of doc/report.

  ./tmsph report                  quick: some 10 minutes on two quiet cores
  ./tmsph report --full           more sizes, choices and repetitions: hours; can be stopped and goes on
  ./tmsph report --only NAME ...  only these studies; the pages keep what was measured before
  ./tmsph report --only fracture  cracks whose bonds open, an hour or two: with --full or by name only
  ./tmsph report --list           their names
  ./tmsph report --pages          nothing measured: pages and plots from the data in doc/report/data

Finished measurements are kept outside of the checkout, for this state of src/TMSPH, this machine and
this LAMMPS, and not taken twice.
"""

import argparse
import os
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tools")] + [str(ROOT / "unittest" / folder)
                                       for folder in ("verification", "stability")]

from cases import suite
from reporting import accuracy, costs, fracture, fracture_scenes, index, peers, stability
from reporting.measure import Progress, Store
from reporting.studies import studies

REPORT = ROOT / "doc" / "report"
DATA, IMAGES = REPORT / "data", REPORT / "images"


def options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--full", action="store_true", help="more sizes, choices and repetitions")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="only these studies")
    parser.add_argument("--list", action="store_true", help="print the names of the studies")
    parser.add_argument("--pages", action="store_true", help="only make plots and pages from the data")
    parser.add_argument("--results", default=os.path.join(tempfile.gettempdir(), "tmsph-report"),
                        metavar="FOLDER", help="where finished measurements are kept (%(default)s; "
                                               "./tmsph report: in its cache)")
    return parser.parse_args()


def measure(option, chosen, counts, extremes, cracks, lmp):
    """Takes the measurements and writes the tables of those that were chosen; extremes are the
    cases of the stability suite, cracks the tables of fracture."""
    store = Store(option.results, lmp)
    total = sum(len(list(accuracy.cases(study, option.full))) for study in chosen)
    progress = Progress(total + costs.number_of_tasks(counts, option.full)
                        + len(stability.chosen(extremes, option.full))
                        + sum(len(table.runs) for table in cracks))
    for study in chosen:
        rows = accuracy.measure(study, store, option.full, progress)
        accuracy.write_table(DATA / f"{study.name}.csv", rows)
    if counts:
        rows = costs.measure(store, lmp, option.full, progress)
        if "instructions" in counts:
            costs.add_instructions(store, rows, progress)
        elif (DATA / "costs.csv").exists():
            costs.keep_instructions(rows, costs.read_table(DATA / "costs.csv"))
        costs.write_table(DATA / "costs.csv", rows)
    if extremes:
        stability.measure(store, extremes, option.full, progress, DATA)
    for table in cracks:
        fracture.measure(table, store, progress, DATA)


def measured(group, read=accuracy.read_table):
    """The studies of a group that have a table, with its rows."""
    tables = ((study, DATA / f"{study.name}.csv") for study in group)
    return [(study, read(path)) for study, path in tables if path.exists()]


def pages(groups):
    """Text of the pages by name, from the tables in the data folder."""
    texts = {}
    for name, (page, group) in groups.items():
        pairs = measured(group)
        if pairs:
            texts[name] = page(pairs)
    if (DATA / "costs.csv").exists():
        texts["costs.md"] = costs.page(costs.read_table(DATA / "costs.csv"))
    if (DATA / "stability.csv").exists():
        texts["stability.md"] = stability.page(stability.read(DATA / "stability.csv"))
    cracks = measured(fracture_scenes.tables(), fracture.read)
    if cracks:
        texts["fracture.md"] = fracture.page(cracks)
    texts["README.md"] = index.page(REPORT)
    return texts


def all_groups():
    return {"accuracy.md": (accuracy.page, studies()), "peers.md": (peers.page, peers.peer_studies())}


def main():
    option = options()
    groups = all_groups()
    everything = [study for _, group in groups.values() for study in group]
    cracks = fracture_scenes.tables()
    names = [study.name for study in everything] + ["costs", "instructions", "stability"]
    by_name = [fracture.NAME, *(table.name for table in cracks)]    # or --full: long runs
    if option.list:
        print("\n".join(names + by_name))
        return
    for name in option.only or []:
        if name not in names + by_name:
            sys.exit(f"There is no study '{name}': ./tmsph report --list prints their names")
    DATA.mkdir(parents=True, exist_ok=True)
    IMAGES.mkdir(exist_ok=True)
    if not option.pages:
        lmp = os.environ.get("TMSPH_LMP") or subprocess.check_output(
            [ROOT / "tmsph", "where"], text=True).strip()
        os.environ["TMSPH_LMP"] = lmp
        os.environ.setdefault("TMSPH_MPIRUN", shutil.which("mpirun") or "")
        wanted = option.only or (names + by_name if option.full else names)
        counts = {"costs", "instructions"} & set(wanted)
        if not option.only and not (option.full and costs.can_count()):
            counts.discard("instructions")    # they need another build
        measure(option, [study for study in everything if study.name in wanted], counts,
                suite() if "stability" in wanted else [],
                [table for name in wanted for table in cracks if name in (fracture.NAME, table.name)], lmp)
    for study, rows in measured(everything):
        accuracy.picture(study, rows, IMAGES)
    if (DATA / "stability_runs.csv").exists():
        stability.picture(IMAGES / "stability.png", stability.read(DATA / "stability_runs.csv"))
    fracture.pictures(measured(cracks, fracture.read), DATA, IMAGES)
    for _ in range(2):    # the index names the pages that are there
        for name, text in pages(groups).items():
            (REPORT / name).write_text(text)


if __name__ == "__main__":
    try:
        main()
    except KeyboardInterrupt:
        sys.exit("stopped: the same command goes on where it was")
