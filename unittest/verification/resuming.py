# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Runs of examples that are killed and resumed, beside those that are not."""

import os
import random
import re
import shutil
import signal
import subprocess
import sys
import time
from pathlib import Path

from resume import restart_step
from tmsph_testing import ALONE, read_thermo

ROOT = Path(__file__).resolve().parents[2]
TIMES = {"v_remain", "remaining_s", "cpu", "elapsed_s"}    # columns of the log: the clock
PATIENCE = 600


def stat(pid):
    """State and parent of a process."""
    try:
        words = Path(f"/proc/{pid}/stat").read_text().rsplit(")", 1)[1].split()
        return words[0], int(words[1])
    except OSError:
        return "gone", 0


def send(pid, number, states):
    """A signal, and waits for what it does: it may be in the middle of starting another process, or
    have much memory to give back."""
    os.kill(pid, number)
    end = time.monotonic() + PATIENCE
    while stat(pid)[0] not in states and time.monotonic() < end:
        time.sleep(0.001)


def kill(pid):
    """A process and all that it started, at one moment: stopped first, so that none starts more.
    Then they are gone, with the locks that they held."""
    known = [pid]
    for one in known:
        send(one, signal.SIGSTOP, ("T", "Z", "gone"))
        running = (int(path.name) for path in Path("/proc").glob("[0-9]*"))
        known += [child for child in running if stat(child)[1] == one]
    for one in known:
        os.kill(one, signal.SIGKILL)
    for one in known:
        send(one, signal.SIGKILL, ("Z", "gone"))


def limited(folder, size):
    """An lmp that is killed by the first byte that makes a file of its larger than so many."""
    path = Path(folder, "limited")
    path.write_text(f"#!{sys.executable} -SE\nimport os, resource, signal, sys\n"
                    "signal.signal(signal.SIGXFSZ, signal.SIG_DFL)\n"
                    f"resource.setrlimit(resource.RLIMIT_FSIZE, ({size}, {size}))\n"
                    "resource.setrlimit(resource.RLIMIT_CORE, (0, 0))\n"
                    f"os.execv({os.environ['TMSPH_LMP']!r}, sys.argv)\n")
    path.chmod(0o755)
    return dict(ALONE, TMSPH_LMP=str(path))


class Example:
    """An example in a folder of its own, on so many processes.
    @param table  the one whose rows tell how far a run is
    """

    def __init__(self, folder, name, table, arguments, ranks=1):
        self.name, self.table, self.arguments, self.ranks = name, table, arguments, ranks
        self.place = Path(folder, "examples", name)
        self.place.mkdir(parents=True)
        for path in (ROOT / "examples" / name).glob("in.*"):    # not what runs left there
            shutil.copy(path, self.place)
        shutil.copytree(ROOT / "potentials", Path(folder, "potentials"))
        if ranks > 1:    # files in the order of processes: the same grid of them
            path = self.place / f"in.{name}"
            path.write_text(f"processors {ranks} 1 1\n" + path.read_text())

    def command(self, resumed, lmp):
        if resumed:
            return [sys.executable, str(ROOT / "tools/resume.py"), f"in.{self.name}"]
        np = str(self.ranks) if self.ranks > 1 else ""
        Path(self.place, f".in.{self.name}.args").write_text("\n".join([np, *self.arguments, ""]))
        mpi = [os.environ.get("TMSPH_MPIRUN", "mpirun"), "-np", np] if np else []
        return [*mpi, lmp, "-in", f"in.{self.name}", *self.arguments]

    def new_rows(self, start, resumed):
        """Of the table, in a run that began then. One that is resumed sets the older part aside."""
        table, before = self.place / self.table, self.place / f"{self.table}.before"
        try:
            begun = before.stat().st_ctime_ns if resumed else table.stat().st_mtime_ns
            return table.read_bytes().count(b"\n") if begun >= start else 0
        except OSError:
            return 0

    def run(self, resumed=False, rows=None, seconds=PATIENCE, size=None):
        """To the end, or killed when the table has so many new rows, after so many seconds, or by
        what limited() says. Its status, None if it was killed here, and what it said."""
        environment = {**os.environ, "OMPI_MCA_mpi_yield_when_idle": "1"}
        if size is not None:
            environment.update(limited(self.place.parent, size))
        with open(self.place / "said", "w+") as said:
            start = time.time_ns()
            command = self.command(resumed, environment["TMSPH_LMP"])
            process = subprocess.Popen(command, cwd=self.place, env=environment, stdout=said,
                                       stderr=said)
            end = time.monotonic() + seconds
            while process.poll() is None and time.monotonic() < end:
                if rows is not None and self.new_rows(start, resumed) > rows:
                    break
                time.sleep(0.002)
            killed = process.poll() is None
            if killed:
                kill(process.pid)
            status = process.wait()
            said.seek(0)
            return None if killed else status, said.read()

    def newest_restart(self):
        return max((restart_step(path), path.read_bytes()) for path in self.place.glob("restart.*"))

    def thermo(self):
        """The first row of each step, without the clock, and whether steps are in their order."""
        rows, steps = {}, []
        for table in read_thermo((self.place / "log.lammps").read_text()):
            names = [name for name in table if name not in TIMES]
            steps += list(table["Step"])
            for k, step in enumerate(table["Step"]):
                rows.setdefault(step, {name: table[name][k] for name in names})
        return rows, steps == sorted(steps)


def compare(report, what, plain, resumed, files):
    """All bits of the last restart file, dumps, tables, pictures; the log."""
    step, data = plain.newest_restart()
    again, copy = resumed.newest_restart()
    report.true(f"{what}: restart file of step {step}", step == again and data == copy, "same bits")
    files = files + sorted(path.name for path in plain.place.glob("image.*"))
    right = [(plain.place / name).read_bytes() for name in files]
    other = [name for name, bits in zip(files, right)
             if not (resumed.place / name).exists() or (resumed.place / name).read_bytes() != bits]
    report.true(f"{what}: {', '.join(files)}", all(right) and not other,
                f"other: {other}" if other else f"same {sum(map(len, right))} bytes")
    (rows, _), (joined, ordered) = plain.thermo(), resumed.thermo()    # runs begin with a row, too
    other = [f"{rows[step]}, not {joined.get(step)}" for step in rows
             if rows[step] != joined.get(step)]
    report.true(f"{what}: log", rows and ordered and not other, other[0] if other else
                f"same {len(rows)} rows, {'' if ordered else 'not '}in order")
    left = [path.name for path in resumed.place.iterdir() if path.suffix in (".before", ".both")]
    report.true(f"{what}: older parts", not left, f"left: {left}" if left else "none left")


def interrupt(report, what, plain, broken, files, kills):
    """Kills a run, and then what goes on with it, each time as the options of run() say, then lets
    it end. Without a restart file it is started anew.
    @return  the steps from which it went on, 0 for the start
    """
    steps = []
    broken.run(**kills[0])
    for options in [*kills[1:], {}]:
        status, said = broken.run(resumed=True, **options)
        if "start it anew" in said:
            status, said = broken.run(**options)
        found = re.search(r"going on from step (\d+)", said)
        steps.append(int(found[1]) if found else 0)
    report.true(f"{what}: {len(kills)} kills", status == 0, f"went on from {steps}"
                if status == 0 else f"status {status}: {said[-300:]}")
    compare(report, what, plain, broken, files)
    return steps


def random_kills(number, life, seed):
    """After up to so many rows of the table, or, every third one, while the run starts."""
    draw = random.Random(seed)
    kills = [dict(rows=draw.randrange(1, life)) for _ in range(number)]
    for options in kills[3::3]:
        options["seconds"] = draw.random()
    return kills
