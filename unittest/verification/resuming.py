# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Runs of examples that are killed at random moments and resumed, beside those that are not."""

import os
import random
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from resume import newest, restart_step
from tmsph_testing import read_thermo

ROOT = Path(__file__).resolve().parents[2]
TIMES = {"v_remain", "remaining_s", "cpu", "elapsed_s"}    # columns of the log that tell of the clock
PATIENCE = 600


def children(pid):
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            if int(stat.read_text().rsplit(")", 1)[1].split()[1]) == pid:
                found.append(int(stat.parent.name))
        except OSError:
            pass
    return found


def kill(pid):
    """A process and all that it started, at one moment: stopped first, so that none starts more."""
    known = [pid]
    for one in known:
        os.kill(one, signal.SIGSTOP)
        known += children(one)
    for one in known:
        os.kill(one, signal.SIGKILL)


class Example:
    """An example in a folder of its own, on so many processes.
    @param table  the one whose rows tell how far a run is
    """

    def __init__(self, folder, name, table, arguments, ranks=1):
        self.name, self.table, self.arguments, self.ranks = name, table, arguments, ranks
        self.place = Path(folder, "examples", name)
        shutil.copytree(ROOT / "examples" / name, self.place)
        shutil.copytree(ROOT / "potentials", Path(folder, "potentials"))
        if ranks > 1:    # files in the order of processes: the same grid of them
            path = self.place / f"in.{name}"
            path.write_text(f"processors {ranks} 1 1\n" + path.read_text())

    def command(self, resumed):
        if resumed:
            return [sys.executable, str(ROOT / "tools/resume.py"), f"in.{self.name}"]
        np = str(self.ranks) if self.ranks > 1 else ""
        Path(self.place, f".in.{self.name}.args").write_text("\n".join([np, *self.arguments, ""]))
        mpi = [os.environ.get("TMSPH_MPIRUN", "mpirun"), "-np", np] if np else []
        return [*mpi, os.environ["TMSPH_LMP"], "-in", f"in.{self.name}", *self.arguments]

    def new_rows(self, start):
        """Of the table, in a run that began then; its older part is set aside when it is resumed."""
        table, before = self.place / self.table, self.place / f"{self.table}.before"
        try:
            if table.stat().st_mtime_ns < start or (before.exists() and
                                                    before.stat().st_ctime_ns < start):
                return 0
            return table.read_bytes().count(b"\n")
        except OSError:
            return 0

    def run(self, resumed=False, rows=None, seconds=PATIENCE):
        """To the end, or killed when the table has so many new rows, or after so many seconds. What it
        said, None if it was killed."""
        with open(self.place / "said", "w+") as said:
            start = time.time_ns()
            process = subprocess.Popen(self.command(resumed), cwd=self.place, stdout=said, stderr=said)
            end = time.monotonic() + seconds
            while process.poll() is None and time.monotonic() < end:
                if rows is not None and self.new_rows(start) > rows:
                    break
                time.sleep(0.002)
            killed = process.poll() is None
            if killed:
                kill(process.pid)
            process.wait()
            said.seek(0)
            text = said.read()
        return None if killed else text

    def newest_restart(self):
        return max((restart_step(path), path.read_bytes()) for path in self.place.glob("restart.*"))

    def thermo(self):
        """The first row of each step, without the clock."""
        rows = {}
        for table in read_thermo((self.place / "log.lammps").read_text()):
            names = [name for name in table if name not in TIMES]
            for k, step in enumerate(table["Step"]):
                rows.setdefault(step, {name: table[name][k] for name in names})
        return rows


def compare(report, what, plain, resumed, files):
    """All bits of the last restart file, dumps, tables, log."""
    step, data = plain.newest_restart()
    again, copy = resumed.newest_restart()
    report.true(f"{what}: restart file of step {step}", step == again and data == copy, "same bits")
    for name in files:
        left, right = ((e.place / name).read_bytes() for e in (plain, resumed))
        report.true(f"{what}: {name}", len(left) > 0 and left == right, f"same {len(left)} bytes")
    rows, joined = plain.thermo(), resumed.thermo()    # a run that starts has a row of its own
    other = [f"{rows[step]}, not {joined.get(step)}" for step in rows if rows[step] != joined.get(step)]
    report.true(f"{what}: thermo", rows and not other, other[0] if other else f"same {len(rows)} rows")


def interrupt(report, what, plain, broken, files, kills, life, seed):
    """Kills a run again and again, after up to so many rows of its table or, every third time, while
    it starts; then lets it end."""
    plain.run()
    draw = random.Random(seed)
    resumed, done = 0, broken.run(rows=draw.randrange(1, life))
    for number in range(1, kills + 1):
        limits = dict(rows=draw.randrange(1, life), seconds=PATIENCE if number % 3 else draw.random())
        limits = limits if number < kills else {}
        done = broken.run(resumed=True, **limits)
        if done is not None and "no complete restart file" in done:
            done = broken.run(**limits)
        else:
            resumed += 1
    report.true(f"{what}: killed {kills} times", done is not None and "ERROR" not in done,
                f"{resumed} times resumed")
    compare(report, what, plain, broken, files)
