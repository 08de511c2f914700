# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Kills at each place where a run or tools/resume.py changes a file, before, in and after it, with
a stand-in for lmp that writes what LAMMPS writes: whatever the places, the end is that of a run
that was not killed."""

import os
import random
import shutil
import signal
import struct
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import resume
from tmsph_testing import main

INPUT = """variable name index state
restart 3 ${name}.1 ${name}.2
if "$(is_defined(variable,resume)) == 1" then "read_restart ${resume}"
fix t all ave/time 1 1 1 v_x file ${name}.txt
fix e all ave/time 1 1 1 v_x start 4 file early.txt
dump d all custom 2 ${name}.dump id x
fix l all ave/time 1 1 1 v_x file late.txt
"""
LAST = 8
CHANGES = ("open", "os.rename", "os.remove", "os.truncate")    # of Python's audit events
HEADING = "step x\n"
EARLY, LATE = 4, 2     # first steps of tables, the latter times the rate
AFRESH = 77            # status of a resumed run that found no restart file


class Clock:
    """Counts the places where files change, and kills its process at one of them."""

    def __init__(self, last):
        self.now, self.last = 0, last

    def tick(self):
        self.now += 1
        if self.now == self.last:
            os.kill(os.getpid(), signal.SIGKILL)

    def audit(self, event, args):
        """Of files in this folder, which are named without it."""
        if event in CHANGES and isinstance(args[0], (str, Path)) and not os.path.isabs(args[0]):
            if event != "open" or args[2] & (os.O_WRONLY | os.O_RDWR | os.O_CREAT):
                self.tick()

    def write(self, file, data):
        for part in (data[:len(data) // 2], data[len(data) // 2:]):
            self.tick()
            file.write(part)
            file.flush()

    def copy(self, source, target):
        self.write(target, source.read())


def state(rate, step):
    return pow(7 + rate, step + 1, 99991)


def table(rows):
    return "".join(f"{step} {x}\n" for step, x in rows)


def frame(step, x):
    return f"ITEM: TIMESTEP\n{step}\nITEM: NUMBER OF ATOMS\n2\nITEM: ATOMS id x\n1 {x}\n2 {x + 1}\n"


def stand_in(clock, words):
    """Of lmp: restart files that take turns, tables, a dump, a log, written in LAMMPS's order. The
    heading of a table comes with its first row; another table begins later. What a resumed run
    writes on its first step is another figure, as those that depend on the box."""
    option = dict(zip(words[1::3], words[2::3]))    # -var NAME VALUE ...
    first, rate, turn, late = 0, int(option["rate"]), 1, None

    def write(file, text):
        clock.write(file, text.encode())

    log = open("log.lammps", "wb")
    write(log, "LAMMPS\n" + INPUT.replace("${name}", "state"))
    if "resume" in option:
        data = Path(option["resume"]).read_bytes()
        first, x = struct.unpack_from("=qq", data, len(resume.MAGIC) + 12)
        assert x == state(rate, first)
    curve, early, dump = (open(name, "wb") for name in ("state.txt", "early.txt", "state.dump"))
    write(log, "Step X\n")
    for step in range(first, LAST + 1):
        x = state(rate, step)
        row = table([(step, x if step > first or first == 0 else 0)])
        write(curve, HEADING * (step == first) + row)
        if step >= EARLY:
            write(early, HEADING * (step == max(first, EARLY)) + row)
        if step >= LATE * rate:
            late = late or open("late.txt", "wb")
            write(late, HEADING * (step == max(first, LATE * rate)) + row)
        if step % 2 == 0:
            write(dump, frame(step, x if step > first or first == 0 else 0))
        if step % 3 == 0 and step > first:
            with open(f"state.{turn}", "wb") as file:
                data = struct.pack("=iiiqq", 1, 1, resume.STEP_FLAG, step, x)
                clock.write(file, resume.MAGIC + data + resume.MAGIC)
            turn = 3 - turn
        if step % 4 == 0 or step in (first, LAST):
            write(log, table([(step, x)]))
    write(log, "Loop time\n")


def start(clock, rate):
    """As ./tmsph run."""
    with open(".in.toy.args", "w") as record:
        clock.write(record, f"\n-var\nrate\n{rate}\n")
    stand_in(clock, ["-var", "rate", str(rate)])


def go_on(clock):
    """As ./tmsph run --resume, in one process with lmp."""
    class Program:
        def __init__(self, command, **options):
            stand_in(clock, command[command.index("in.toy") + 1:])

        def wait(self):
            return 0

    subprocess.Popen, shutil.copyfileobj = Program, clock.copy
    sys.argv = ["resume.py", "in.toy"]
    try:
        resume.main()
    except SystemExit as end:
        if "start it anew" in str(end):
            os._exit(AFRESH)
        if end.code:
            raise


def attempt(place, action, *args, last=0):
    """In a process of its own, killed at that place. Its status, negative for a signal; a file says
    how many places it had."""
    counted = place.parent / "counted"
    pid = os.fork()
    if pid == 0:
        status = 1
        try:
            os.chdir(place)
            sys.stderr = open(place.parent / "said", "w")
            clock = Clock(last)
            sys.addaudithook(clock.audit)
            action(clock, *args)
            counted.write_text(str(clock.now))
            status = 0
        except BaseException as error:
            print(repr(error), file=sys.stderr, flush=True)
        finally:
            os._exit(status)
    return os.waitstatus_to_exitcode(os.waitpid(pid, 0)[1])


def places(place, action, *args):
    """How many places it has; the folder stays as it is."""
    copy = copied(place, place.parent / "counting")
    if attempt(copy, action, *args):
        raise RuntimeError((place.parent / "said").read_text())
    return int((place.parent / "counted").read_text())


def copied(place, to):
    shutil.rmtree(to, ignore_errors=True)
    shutil.copytree(place, to)    # with the times of the files
    return to


def wrong(place, rate, runs):
    """What differs in a folder from a run that was not killed; nothing if all is right."""
    rows = [(k, state(rate, k)) for k in range(LAST + 1)]
    right = {"state.txt": HEADING + table(rows), "early.txt": HEADING + table(rows[EARLY:]),
             "late.txt": HEADING + table(rows[LATE * rate:]),
             "state.dump": "".join(frame(*row) for row in rows[::2])}
    for name, text in right.items():
        if (place / name).read_text() != text:
            return name
    if max((resume.restart_step(path) or -1) for path in place.glob("state.[12]")) != LAST // 3 * 3:
        return "restart file"
    log = (place / "log.lammps").read_text()
    logged = [line for line in log.split("\n") if line[:1].isdigit()]
    steps = [int(line.split()[0]) for line in logged]
    if not {0, 4, LAST} <= set(steps) or not set(logged) <= set(table(rows).split("\n")):
        return "rows of the log"
    if steps != sorted(steps) or log.count("LAMMPS") > runs or log.count("Loop time") != 1:
        return "order of the log"
    began = (place / ".in.toy.args").stat().st_mtime
    left = [path.name for path in place.iterdir() if path.stat().st_mtime >= began
            and path.suffix in (".before", ".both")]
    return f"left: {left}" if left else ""


class Kills:
    """Many runs from one folder, and what was wrong with them."""

    def __init__(self, report, what):
        self.report, self.what = report, what
        self.tried, self.bad = 0, []

    def judge(self, place, rate, plan, anew=False):
        """@param anew  whether the run may have no restart file yet"""
        self.tried += 1
        status = attempt(place, go_on)
        if anew and status == AFRESH:    # as a user would
            status = attempt(place, start, rate)
        fault = f"status {status}: {(place.parent / 'said').read_text()}" if status else \
            wrong(place, rate, len(plan) + 1)
        if fault:
            self.bad.append(f"{plan}: {fault}")

    def done(self):
        self.report.true(self.what, self.tried and not self.bad,
                         f"{len(self.bad)} of {self.tried} wrong, first {self.bad[0]}" if self.bad
                         else f"all {self.tried} end as one that was not killed")


def new(folder):
    place = Path(folder, "new")
    place.mkdir()
    (place / "in.toy").write_text(INPUT + "read_restart ${resume}\n")
    return place


def kills_at_each_place(report, folder, stride):
    """One kill of a first run at each place; of some of them two kills, the second at each place of
    the resumed run, its own steps and those of lmp; three at some."""
    fresh = new(folder)
    one, two, three = (Kills(report, f"{n}") for n in ("one kill", "two kills", "three kills"))
    draw = random.Random(1)
    for i in range(1, places(fresh, start, 1) + 1):
        killed = copied(fresh, Path(folder, "killed"))
        attempt(killed, start, 1, last=i)
        one.judge(copied(killed, Path(folder, "end")), 1, (i,), anew=True)
        if i % stride or attempt(copied(killed, Path(folder, "end")), go_on) == AFRESH:
            continue
        for j in range(1, places(killed, go_on) + 1):
            again = copied(killed, Path(folder, "again"))
            attempt(again, go_on, last=j)
            two.judge(copied(again, Path(folder, "end")), 1, (i, j))
            k = draw.randrange(1, 60)
            attempt(again, go_on, last=k)
            three.judge(again, 1, (i, j, k))
    for kills in (one, two, three):
        kills.done()


def kills_of_another_run(report, folder, stride):
    """What a run with other arguments left, and a resumed one that was killed too, is not mixed
    with what a new run writes, wherever that is killed. Its first place is before its record."""
    killed = new(folder)
    attempt(killed, start, 1, last=places(killed, start, 1) - 9)
    kills = Kills(report, "another run after two kills")
    for j in range(1, places(killed, go_on) + 1, stride):
        left = copied(killed, Path(folder, "again"))
        attempt(left, go_on, last=j)
        past = time.time() - 10
        for path in left.iterdir():
            os.utime(path, (past, past))
        for k in range(2, places(left, start, 2) + 1, 5):
            end = copied(left, Path(folder, "end"))
            attempt(end, start, 2, last=k)
            attempt(end, go_on, last=k + 5)
            kills.judge(end, 2, (j, k, k + 5), anew=True)
    kills.done()


def locks_and_processes(report, folder):
    """A lock that a killed lmp still holds, and processes that go on without it; not for ever."""
    resume.PATIENCE = 1
    killed = new(folder)
    attempt(killed, start, 1, last=places(killed, start, 1) - 9)
    lock = "import fcntl; file = open('.in.toy.args', 'a'); fcntl.flock(file, fcntl.LOCK_EX); "
    for what, code, words in (("a lock", lock, []), ("a process of mpirun", "", ["-in", "in.toy"])):
        for seconds in (0.5, 60):
            place = copied(killed, Path(folder, "end"))
            script = f"{code}import time; print(flush=True); time.sleep({seconds})"
            with subprocess.Popen([sys.executable, "-c", script, *words], cwd=place,
                                  stdout=subprocess.PIPE) as other:
                other.stdout.readline()
                status = attempt(place, go_on)
                said, gone = Path(folder, "said").read_text(), other.poll() is not None
                other.kill()
            if seconds < 1:
                good = status == 0 and gone and not wrong(place, 1, 2)
                report.true(f"{what}, for {seconds} s", good, "waits, then goes on")
            else:
                good = status == 1 and not gone and "going on here" in said
                report.true(f"{what}, for long", good, said.strip())


def in_a_folder(part, report, *args):
    with tempfile.TemporaryDirectory() as folder:
        part(report, folder, *args)


def each_place(report):
    in_a_folder(kills_at_each_place, report, 26)


def afresh(report):
    in_a_folder(kills_of_another_run, report, 9)


def what_it_waits_for(report):
    in_a_folder(locks_and_processes, report)


if __name__ == "__main__":
    os.environ["TMSPH_LMP"] = sys.executable    # only looked for
    main(each_place, afresh, what_it_waits_for)
