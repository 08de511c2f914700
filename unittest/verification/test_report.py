# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The report in doc/report: how it evaluates measurements, that its pages are those that its
data give, and that all they link to is there."""

import importlib.util
import os
import re
import sys
import tempfile
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
sys.path.insert(0, str(ROOT / "tools"))

from reporting import accuracy, fracture, fracture_scenes, peers, plots
from reporting.measure import Progress, Store
from tmsph_testing import main

spec = importlib.util.spec_from_file_location("tmsph_report", ROOT / "tools" / "report.py")
tool = importlib.util.module_from_spec(spec)
spec.loader.exec_module(tool)


def made_up(choice, order, factor, exponent=3.0):
    """Errors of some order in h, and times that grow with the number of particles."""
    return [dict(choice=choice, h=h, error=h**order, seconds=factor * h**-exponent, ranks=1)
            for h in (0.5, 0.25, 0.125, 0.0625)]


def evaluation(report):
    rows = made_up("tmsph", 2.0, 1.0) + made_up("slow", 2.0, 7.0) + made_up("crude", 1.0, 0.5)
    mine = accuracy.of(rows, "tmsph")
    report.within("observed order", accuracy.observed_order(mine), 2.0, 2.0)
    # error h^2 = 0.01, time h^-3 = 1000
    report.within("time to 1 %", accuracy.time_to(mine, 0.01), 1000 - 1e-6, 1000 + 1e-6)
    report.true("time to what is not reached", accuracy.time_to(mine, 1e-9) is None, "none")
    report.true("advantage over a method 7 times as slow",
                peers.advantage(rows, "slow").startswith("7.0 "), "7.0")
    # at the error 0.0625, which it reaches at h = 0.0625: 0.5 * 16^3 against 4^3
    report.true("advantage over a method of first order",
                peers.advantage(rows, "crude").startswith("32.0 "), "32.0")
    stairs = plots.front([(1, 5), (2, 3), (3, 4), (4, 1), (0.5, 5)])
    report.true("Pareto front", stairs == [(0.5, 5), (2, 3), (4, 1)], "as by hand")


class Interrupted(Exception):
    pass


def cracks(report):
    """Runs of a table are taken once, and what was measured stands when it is stopped."""
    taken, stop = [], [True]

    def measure(judge, lattice, angle):
        if angle == 45 and stop[0]:
            raise Interrupted
        taken.append(angle)
        judge.within(f"{lattice} {angle}: peak", 1 + 0.001 * angle, 0.96, 1.04)
        judge.below(f"{lattice} {angle}: gained by updates/dissipated", float("nan") if angle else 0, 1e-4)
        judge.below("peaks between lattices", 1.0, 0.03)
        return [("tmsph", 1.0, 2.0)]

    table = fracture_scenes.Table(
        "made_up", "", "", [{"lattice": "square", "angle": angle} for angle in (0, 20, 45)], measure, (Interrupted,),
        ("peaks between lattices", "peak", ("lattice",), 0.03))
    with tempfile.TemporaryDirectory() as folder:
        def measured():
            store = Store(folder, os.environ["TMSPH_LMP"])
            fracture.measure(table, store, Progress(3), Path(folder))

        def rows(name="made_up"):
            return fracture.read(Path(folder) / f"{name}.csv")
        try:
            measured()
        except Interrupted:
            pass
        report.true("what was measured stands", [row["angle"] for row in rows()] == ["0", "20"], "two of three runs")
        report.true("the page says what is not measured", "Not measured: square, 45." in
                    fracture.section(table, rows()), "one")
        stop[0] = False
        measured()
        report.true("runs are taken once", taken == [0, 20, 45], f"{taken}")
        report.true("a curve of each", len(rows("made_up_curves")) == 3, "one point")
        text = fracture.section(table, rows())
    for what in ("peak 0.96 to 1.04: NOT MET in 1 of 3 runs", "dissipated below 0.0001: NOT MET in 2 of 3 runs",
                 "peaks between lattices below 0.03: NOT MET in 1 of 1 groups (lattice square: 0.045)",
                 "| square | 45 | 1.045 | nan | peak; gained by updates/dissipated |", "| square | 0 | 1 | 0 | none |"):
        report.true("the page says", what in text, what)


def published(report):
    for name, text in tool.pages(tool.all_groups()).items():
        path = tool.REPORT / name
        report.true(f"{name} is what its data give", path.exists() and path.read_text() == text,
                    "./tmsph report --pages")
    for path in sorted(tool.REPORT.glob("*.md")):
        gone = [target for target in re.findall(r"\]\(([^)#\s]+)\)", path.read_text())
                if "://" not in target and not (tool.REPORT / target).exists()]
        report.true(f"{path.name}: links lead somewhere", not gone,
                    ", ".join(gone) or "all of them")
    names = [study.name for _, group in tool.all_groups().values() for study in group]
    names += [fracture.NAME, *(table.name for table in fracture_scenes.tables())]
    report.true("names of studies differ", len(set(names)) == len(names), "by name")


if __name__ == "__main__":
    main(evaluation, cracks, published)
