#!/usr/bin/env python3
# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Goes on where a run was interrupted: ./tmsph run --resume INPUT.

    tools/resume.py [--np N] INPUT [lmp args]       in the folder of the input; TMSPH_LMP is the lmp

The input writes restart files, with the command restart, and reads the one that the variable
"resume" names instead of making the body (see doc/output.md). The newest complete restart file is
taken; one that was being written when the run was killed lacks LAMMPS's mark at its end. What
dumps, tables and log have beyond its step is cut off, since the run writes it anew; this older part
waits in FILE.before and is put in front again at the end, or by the next --resume if that is killed
too.
What a run before the last ./tmsph run left is not looked at. Without lmp args they are those of the
last ./tmsph run."""

import argparse
import fcntl
import os
import re
import shutil
import signal
import struct
import subprocess
import sys
import time
from pathlib import Path

MAGIC = b"LammpS RestartT\0"
STEP_FLAG = 5          # of the header, as in LAMMPS's lmprestart.h
LOG = "log.lammps"
PATIENCE = 10          # seconds until processes that were killed are gone


def stop(text):
    sys.exit(f"tmsph: {text}")


def read(path):
    try:
        return Path(path).read_text(errors="replace")
    except OSError as error:
        stop(f"cannot read {path}: {error.strerror}")


def written_since(path, since):
    """It is there, and not from a run before that one."""
    try:
        return path.stat().st_mtime_ns >= since
    except FileNotFoundError:
        return False


# ---- Restart files ----

def restart_step(path):
    """The step of a restart file; None if it is not one or not complete."""
    try:
        with open(path, "rb") as file:
            head = file.read(4096)
            file.seek(max(0, os.path.getsize(path) - len(MAGIC)))
            tail = file.read()
    except OSError:
        return None
    if not head.startswith(MAGIC) or tail != MAGIC or os.path.getsize(path) < len(head):
        return None
    at = len(MAGIC) + 8                       # endian flag and revision
    while at + 4 <= len(head):                # integers and texts, each behind its flag
        flag, = struct.unpack_from("=i", head, at)
        if flag == STEP_FLAG:
            return struct.unpack_from("=q", head, at + 4)[0]
        size, = struct.unpack_from("=i", head, at + 4)
        at += 8 + (size if flag in TEXT_FLAGS else 0)
    return None


TEXT_FLAGS = (0, 4)    # the version, the units


def commands(text):
    """The commands of an input or of the log that repeats them, each in one line."""
    return re.sub(r"#[^\n]*", "", text.replace("&\n", " ")).split("\n")


def restart_files(lines):
    """The files that the command restart names: two that take turns, or one for each step. Names
    with variables are in the log, with their values."""
    word = r"\s+([^\s\"$]+)"
    for line in lines:
        found = re.search(rf"(?:^|\")\s*restart\s+[^\s\"]+{word}(?:{word})?(?:\s|\"|$)", line)
        if found and found[2]:
            return [Path(found[1]), Path(found[2])]
        if found:
            name = found[1] if "*" in found[1] else found[1] + ".*"
            return sorted(Path().glob(name))
    return []


def newest(files, since):
    """The step and the path of the newest complete one, not of an earlier run. Of two that take
    turns the first will be written first: so the newest becomes the second."""
    known = [(restart_step(path), path) for path in files if written_since(path, since)]
    known = [pair for pair in known if pair[0] is not None]
    if not known:
        stop("no complete restart file of this run is here, as the command restart writes them: "
             "start it anew")
    step, path = max(known)
    if len(files) == 2 and path == files[0]:
        os.replace(path, files[1])
        path = files[1]
    return step, path


# ---- Dumps, tables, logs ----

def output_files(lines):
    """Dumps and tables with many steps in one file. Those that cannot be cut must not be there, as
    LAMMPS would write over them."""
    names, dump = set(), r"(?:^|\")\s*dump\s+\S+\s+\S+\s+(\S+)\s+\S+\s+([^\s\"]+)"
    for line in lines:
        for style, name in re.findall(dump, line):
            if style in ("custom", "local", "atom") and not name.endswith((".gz", ".zst", ".bin")):
                names.add(name)
            elif "*" not in name and "$" not in name and list(Path().glob(name.replace("%", "*"))):
                stop(f"{name} would be written over, and it is not a text dump that can be cut: "
                     "rename it")
        if re.search(r"(?:^|\")\s*fix\s", line):
            names.update(re.findall(r"\s(?:file|append)\s+([^\s\"]+)", line))
    return [Path(name) for name in sorted(names) if not set(name) & set("*%$")]


def frames(path):
    """The step and the place in the file of each frame of a dump, row of a table, or row of a table
    in a log. A step that was not written to the end is None."""
    with open(path, "rb") as file:
        dump = file.read(5) == b"ITEM:"
        file.seek(0)
        log = path.name.removesuffix(".before") == LOG
        yield from dump_frames(file) if dump else rows(file, log)


def dump_frames(file):
    start, line = 0, file.readline()
    while line:
        step, count = b"", 0
        while line and not line.startswith((b"ITEM: ATOMS", b"ITEM: ENTRIES")):
            if line.startswith(b"ITEM: UNITS"):    # once, before the first frame
                file.readline()
                start = file.tell()
            elif line.startswith(b"ITEM: TIMESTEP"):
                step = file.readline()
            elif line.startswith(b"ITEM: NUMBER OF"):
                count = int(file.readline() or 0)
            line = file.readline()
        for _ in range(count):
            line = file.readline()
        yield (int(step) if line.endswith(b"\n") else None), start
        start, line = file.tell(), file.readline()


def rows(file, log):
    at, columns = 0, None                    # columns of the table in a log that is being read
    for line in file:
        start, at = at, at + len(line)
        words = line.split()
        if not words:
            continue
        if log and words[0] == b"Step":
            columns = len(words)
        elif not line.endswith(b"\n"):
            yield None, start
        elif words[0].isdigit() and (not log or len(words) == columns):
            yield int(words[0]), start
        elif words[0] != b"WARNING:":
            columns = None


def cut(path, step=sys.maxsize):
    """Takes off what was written after that step, and what was not written to its end. The last
    step that stays."""
    last = -1
    for when, place in frames(path):
        if when is None or when > step:
            os.truncate(path, place)
            break
        last = when
    return last


def older_part(path):
    return path.with_name(path.name + ".before")


def set_aside(path, step, since):
    if written_since(path, since):
        cut(path, step)
        os.replace(path, older_part(path))


def join(path, since):
    """Puts the older part in front of what the newer one has beyond it: not its heading, and not
    the step that it began with. If this is stopped anywhere it can be done once more."""
    before = older_part(path)
    if not written_since(before, since):
        return
    if path.exists():
        last = -1 if path.name == LOG else cut(before)
        if last < 0:
            join_whole(before, path)
            return
        place = next((place for when, place in frames(path)
                      if when is not None and when > last), None)
        if place is not None:
            with open(path, "rb") as newer, open(before, "ab") as older:
                newer.seek(place)
                shutil.copyfileobj(newer, older)
    os.replace(before, path)


def join_whole(before, path):
    """A log, or what has no steps. If the newer part begins with the older one, that is a heading,
    or they have been joined already."""
    both = path.with_name(path.name + ".both")
    older = before.read_bytes()
    with open(path, "rb") as newer:
        if newer.read(len(older)) != older:
            newer.seek(0)
            with open(both, "wb") as file:
                file.write(older)
                shutil.copyfileobj(newer, file)
            os.replace(both, path)
    before.unlink()


# ---- Run ----

def last_arguments(record):
    """Number of processes and arguments of the last ./tmsph run, and when it started. The record is
    empty if that was killed while it wrote it."""
    try:
        np, *args = record.read_text().split("\n")[:-1] or [""]
        return np, args, record.stat().st_mtime_ns
    except OSError:
        return "", [], 0


def goes_on(input_file):
    """A process runs that input in this folder. Those of mpirun outlive it by some seconds, and do
    not hold the lock. Without /proc there are none."""
    words, here = b"\0-in\0" + os.fsencode(input_file) + b"\0", os.getcwd()
    for process in filter(str.isdigit, os.listdir("/proc") if os.path.isdir("/proc") else []):
        try:
            if os.readlink(f"/proc/{process}/cwd") == here:
                if words in Path(f"/proc/{process}/cmdline").read_bytes():
                    return True
        except OSError:    # it has ended, or is another user's
            pass
    return False


def wait_until_alone(input_file, record):
    """Returns a file that is locked as long as it is open, here or in lmp, which inherits it. A run
    that was killed a moment ago may still hold it."""
    os.access(".", os.W_OK) or stop("cannot write here")
    alone = open(record, "a") if record.exists() else open(input_file)
    end = time.monotonic() + PATIENCE
    while True:
        try:
            fcntl.flock(alone, fcntl.LOCK_EX | fcntl.LOCK_NB)
            locked = False
        except BlockingIOError:
            locked = True
        except OSError:    # a file system without locks
            locked = False
        if not locked and not goes_on(input_file):
            return alone
        if time.monotonic() > end:
            stop(f"a run of {input_file} is still going on here")
        time.sleep(0.05)


def call(command, alone):
    """Runs it; signals that end a program are handed on, so that lmp does not stay behind."""
    child = subprocess.Popen(command, pass_fds=[alone.fileno()])
    for number in (signal.SIGINT, signal.SIGTERM, signal.SIGHUP):
        signal.signal(number, lambda number, frame: child.send_signal(number))
    status = child.wait()
    return status if status >= 0 else 128 - status


def main():
    parser = argparse.ArgumentParser(description=__doc__.split("\n")[0])
    parser.add_argument("--np", help="number of processes")
    parser.add_argument("input")
    parser.add_argument("args", nargs=argparse.REMAINDER, help="arguments of lmp")
    given = parser.parse_args()
    lmp = os.environ.get("TMSPH_LMP") or stop("TMSPH_LMP, the path of lmp, is not set")
    shutil.which(lmp) or stop(f"there is no program {lmp}: TMSPH_LMP is the path of lmp")
    text = read(given.input)
    if "${resume}" not in text:
        stop(f"{given.input} does not tell how to go on: it needs read_restart ${{resume}}, see "
             "doc/output.md")

    record = Path(f".{given.input}.args")
    alone = wait_until_alone(given.input, record)
    np, args, since = last_arguments(record)
    np, args = given.np or np, given.args or args
    log = Path(LOG)
    join(log, since)       # first, as names with variables are in its older part
    lines = commands(text) + (commands(read(log)) if log.exists() else [])
    files = output_files(lines) + [log]
    for path in files:
        join(path, since)
    step, restart = newest(restart_files(lines), since)
    for path in files:
        set_aside(path, step, since)
    print(f"tmsph: going on from step {step}, {restart}", file=sys.stderr)
    command = [lmp, "-in", given.input, *args, "-var", "resume", str(restart)]
    if np:
        command = [os.environ.get("TMSPH_MPIRUN", "mpirun"), "-np", np, *command]
    status = call(command, alone)
    for path in files:
        join(path, since)
    sys.exit(status)


if __name__ == "__main__":
    main()
