# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Runs that are killed and go on end with the same bits: in the middle of chosen files, which a
limit of their size tears, and at random moments; torn restart files are known. Ten kills each:
test_resume_long; kills at each place where a file changes: test_resume_calls."""

import os
import subprocess
import sys
import tempfile
import time
from pathlib import Path

from resume import commands, frames, newest, restart_files, restart_step
from resuming import ROOT, Example, interrupt, random_kills
from tmsph_testing import main

DYNAMIC = ["-var", "dx", "4e-3", "-var", "rate", "0.1", "-var", "restart", "200"]
SHORT = ["-var", "dx", "5e-3", "-var", "rate", "0.4", "-var", "restart", "100", "-var", "dump",
         "50", "-var", "bonds", "yes"]
QUASISTATIC = ["-var", "dx", "5e-3", "-var", "quasistatic", "yes", "-var", "restart", "1000"]
TABLES = {"disc": "broken_bonds.txt", "quench": "cracks.txt", "borehole": "cracks.txt"}


def killed(report, name, what, arguments, ranks, kills, life, seed, after=None):
    table = TABLES[name]
    with tempfile.TemporaryDirectory() as one, tempfile.TemporaryDirectory() as two:
        plain = Example(one, name, table, arguments, ranks)
        broken = Example(two, name, table, arguments, ranks)
        plain.run()
        interrupt(report, f"{name}, {what}", plain, broken, [f"dump.{name}", table, "events.txt"],
                  random_kills(kills, life, seed))
        if after:
            after(report, plain.place)


def torn_files(report):
    """Where files that grow end is known from a run that was not killed. Its frames of bonds, of
    steps 0, 50 and so on, are almost equally long, a restart file is as long as three of them, and
    the first picture, on step 300, longer."""
    with tempfile.TemporaryDirectory() as folder:
        plain = Example(Path(folder, "plain"), "disc", "broken_bonds.txt", SHORT)
        plain.run()
        frame = [place for _, place in frames(plain.place / "dump.bonds")]
        restart = max(path.stat().st_size for path in plain.place.glob("restart.*"))
        picture = plain.place.joinpath("image.120.png").stat().st_size
        fourth = (restart + frame[4]) // 2    # in it
        report.true("sizes", frame[3] < restart + 1000 < min(fourth, picture),
                    f"frames {frame[1]}, restart files {restart}, picture {picture}")
        for what, sizes, right in (
                ("in the log", [3000], [0]),
                ("in the first restart file, twice", [restart // 3, restart // 2], [0, 0]),
                ("in a frame", [fourth], [100]),
                ("before a frame, in the log", [frame[4], 3000], [100, 100]),
                ("in a frame, before a frame, in a picture", [fourth, frame[4], restart + 1000],
                 [100, 200, 300])):
            broken = Example(Path(folder, what), "disc", "broken_bonds.txt", SHORT)
            steps = interrupt(report, f"killed {what}", plain, broken,
                              ["dump.disc", "dump.bonds", "broken_bonds.txt", "events.txt"],
                              [dict(size=size) for size in sizes])
            report.true(f"killed {what}: steps", steps == right, str(steps))


def torn(report, place):
    """A restart file that was not written to its end is not taken, however much of it is there, nor
    one of an earlier run; the one that is taken is written to last."""
    files = [place / "restart.disc.1", place / "restart.disc.2"]
    steps = {restart_step(path): path for path in files}
    report.true("restart files", sorted(steps) == [2400, 2600], str(sorted(steps)))
    whole, older = steps[2600].read_bytes(), steps[2400]
    for size in (0, 10, 100, 1000, len(whole) // 2, len(whole) - 8, len(whole) - 1):
        steps[2600].write_bytes(whole[:size])
        if restart_step(steps[2600]) is not None:
            report.true(f"torn after {size} bytes", False, "not taken")
    files[0].write_bytes(older.read_bytes())
    files[1].write_bytes(whole[:-1])
    step, path = newest(files, 0)
    report.true("torn restart file", (step, path) == (2400, files[1]),
                "the older one, named second")
    try:
        newest(files, time.time_ns() + 10**9)
        report.true("restart file of an earlier run", False, "refused")
    except SystemExit as end:
        report.true("restart file of an earlier run", "start it anew" in str(end), "refused")


def wrong(report):
    """What cannot go on says so in one line; names with variables are taken from the log."""
    with tempfile.TemporaryDirectory() as folder:
        place = Path(folder)
        (place / "in.x").write_text("variable n index a\nrestart 5 ${n}.1 ${n}.2\n"
                                    "read_restart ${resume}\ndump p all xyz 5 x.xyz\n")
        (place / "in.latin").write_bytes(b"# heated to 260 \xb0C\n")
        (place / "log.lammps").write_text("restart 5 ${n}.1 ${n}.2\nrestart 5 a.1 a.2\n")
        lines = commands((place / "in.x").read_text() + (place / "log.lammps").read_text())
        report.true("restart files named with variables", restart_files(lines) == [Path("a.1"),
                    Path("a.2")], "found in the log")

        def refused(name, words, **environment):
            done = subprocess.run([sys.executable, ROOT / "tools/resume.py", name], cwd=folder,
                                  text=True, capture_output=True, env={**os.environ, **environment})
            report.true(words, done.returncode == 1 and words in done.stderr
                        and done.stderr.count("\n") == 1, done.stderr.strip())

        refused("nowhere", "cannot read nowhere")
        refused("in.latin", "does not tell how to go on")
        refused("in.x", "there is no program", TMSPH_LMP="/nowhere/lmp")
        refused("in.x", "no complete restart file")
        (place / "x.xyz").write_text("")
        refused("in.x", "x.xyz would be written over")


def dynamic(report):
    killed(report, "disc", "dynamic, 1 rank", DYNAMIC, 1, 3, 30, 1, torn)


def quasistatic(report):
    killed(report, "disc", "quasi-static, 2 ranks", QUASISTATIC, 2, 3, 60, 2)


if __name__ == "__main__":
    main(wrong, torn_files, dynamic, quasistatic)
