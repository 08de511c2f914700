#!/usr/bin/env python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Measures and writes the tables, plots and pages of doc/report.

  ./tmsph report                  quick: some 10 minutes on two quiet cores
  ./tmsph report --full           more sizes, choices and repetitions: hours; can be stopped and goes on
  ./tmsph report --only NAME ...  only these studies; the pages keep what was measured before
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
from pathlib import Path

ROOT = Path(__file__).resolve().parents[1]
sys.path[:0] = [str(ROOT / "tools"), str(ROOT / "unittest" / "verification")]

from reporting import accuracy
from reporting.measure import Progress, Store
from reporting.studies import studies

REPORT = ROOT / "doc" / "report"


def cache():
    base = os.environ.get("XDG_CACHE_HOME") or os.path.join(os.path.expanduser("~"), ".cache")
    return os.path.join(base, "tmsph", "report")


def options():
    parser = argparse.ArgumentParser(description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("--full", action="store_true", help="more sizes, choices and repetitions")
    parser.add_argument("--only", nargs="+", metavar="NAME", help="only these studies")
    parser.add_argument("--list", action="store_true", help="print the names of the studies")
    parser.add_argument("--pages", action="store_true", help="only make plots and pages from the data")
    parser.add_argument("--results", default=cache(), metavar="FOLDER",
                        help="where finished measurements are kept (%(default)s)")
    return parser.parse_args()


def main():
    option = options()
    everything = studies()
    names = [study.name for study in everything]
    if option.list:
        print("\n".join(names))
        return
    for name in option.only or []:
        if name not in names:
            sys.exit(f"There is no study '{name}': ./tmsph report --list prints their names")
    lmp = os.environ.get("TMSPH_LMP") or subprocess.check_output(
        [ROOT / "tmsph", "where"], text=True).strip()
    os.environ["TMSPH_LMP"] = lmp
    os.environ.setdefault("TMSPH_MPIRUN", shutil.which("mpirun") or "")
    for folder in ("data", "images"):
        (REPORT / folder).mkdir(parents=True, exist_ok=True)

    if not option.pages:
        chosen = [study for study in everything if not option.only or study.name in option.only]
        store = Store(option.results, lmp)
        progress = Progress(sum(len(list(accuracy.cases(study, option.full))) for study in chosen))
        for study in chosen:
            rows = accuracy.measure(study, store, option.full, progress)
            accuracy.write_table(REPORT / "data" / f"{study.name}.csv", rows)

    measured = []
    for study in everything:
        path = REPORT / "data" / f"{study.name}.csv"
        if path.exists():
            rows = accuracy.read_table(path)
            measured.append((study, rows))
            accuracy.picture(study, rows, REPORT / "images")
    (REPORT / "accuracy.md").write_text(accuracy.page(measured))


if __name__ == "__main__":
    main()
