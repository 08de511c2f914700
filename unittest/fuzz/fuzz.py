# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Mutated inputs: whatever the words and numbers, lmp ends well or with one error. Crashes,
hangs, NaN in a dump and endings with no or several errors (unclear) fail; their inputs are kept.

    fuzz.py [COUNT] [--seed S] [--keep FOLDER] [--ranks N] [--sanitizer]
"""

import argparse
import collections
import os
import random
import re
import resource
import shutil
import subprocess
import sys
import tempfile
from pathlib import Path

from seeds import SEEDS, t

SECONDS = 10
MEMORY = 4 << 30    # bytes of address space
# An lmp with sanitizers is slow and reserves more addresses than there is memory: it limits itself
SANITIZER_SECONDS = 200
SANITIZER_OPTIONS = ("detect_leaks=0:allocator_may_return_null=1:max_allocation_size_mb=4096:"
                     "hard_rss_limit_mb=4096")
OUT_OF_MEMORY = re.compile(r"AddressSanitizer: (out of memory|allocation-size-too-big|"
                           "requested allocation size)|hard rss limit exhausted")
NUMBERS = ["0", "-1", "1", "2", "3", "1e300", "-1e300", "1e-300", "nan", "inf", "-inf",
           "2147483647", "2147483648", "-2147483648", "99999999999999999999", "1.5", "0.5", "1e",
           "0x10", "*", "2*1"]
WORDS = ["", "NULL", "v_none", "v_T", "c_p", "all", "none", "yes", "*", "\u00e9\u2264", "\"",
         "'a b'", "${x}", "$(1/0)", "x" * 300, "#", "&"]
# Commands that reach out of the input, and loops that never end by themselves
FORBIDDEN = re.compile(r"^\s*(shell|python|plugin|jump|next|log)\b", re.M)
NUMBER = re.compile(r"[-+]?\d[\d.e+-]*$")
# A length of a run that asks for more steps than fit the time is no hang
LONG_RUN = re.compile(r"^\s*(run|minimize|tmsph/quasistatic)\b.*\d{4,}", re.M)
FAILURES = ("crash", "hang", "nan", "unclear")
# Bad endings of LAMMPS itself: what the script or a file has, the words of the ending, and an input
# without TMSPH that must end likewise
FAR = r"(comm_modify +cutoff|pair_style +tmsph) +\S*(\d{9,}|e[+]?\d+)"
WIDE = r"\S*(\d{9,}|e[+]?\d+) .lo .hi"
LIQUID = """units lj
region box block 0 4 0 4 0 4
create_box 1 box
create_atoms 1 random 20 1 NULL
mass * 1
pair_style lj/cut 1
pair_coeff * * 1 1
"""
LAMMPS = [(FAR, "NBinStandard", LIQUID + "comm_modify cutoff 1e300\nrun 0\n"),
          (WIDE, "atom.cpp", LIQUID.replace("box block 0 4", "box block 0 1e300") + "run 0\n"),
          (FAR, "comm_brick.cpp", LIQUID + "comm_modify cutoff 1e300\nrun 0\n"),
          # the words of a first line that lacks a quote were never set
          (r'^\w+ [^"\n]*"[^"\n]*\n', "point_to_error", 'units "\n'),
          (FAR, "MPI_ERR_RANK", LIQUID + "write_restart mid.restart\nclear\n"
           "read_restart mid.restart\ncomm_modify cutoff 1e300\nrun 0\n")]


def scaled(word, chance):
    """The number times a factor, whole if it was whole."""
    try:
        value = float(word) * chance.choice((-1, 0.1, 0.5, 0.9, 1.1, 2, 10, 1e3, 1e6, 1e-3, 1e-6))
    except ValueError:
        return chance.choice(NUMBERS)
    return str(int(value)) if word.isdigit() else f"{value:.9g}"


def mutate_line(line, chance, vocabulary):
    """One line with one word changed."""
    words = line.split(" ")
    at = chance.randrange(len(words))
    numbers = [k for k, word in enumerate(words) if NUMBER.match(word)]
    kind = chance.choice(("number", "number", "factor", "factor", "factor", "word", "drop",
                          "double", "swap", "other"))
    if kind in ("number", "factor") and numbers:
        at = chance.choice(numbers)
        words[at] = chance.choice(NUMBERS) if kind == "number" else scaled(words[at], chance)
    elif kind == "word":
        words[at] = chance.choice(WORDS)
    elif kind == "drop":
        del words[at]
    elif kind == "double":
        words.insert(at, words[at])
    elif kind == "swap":
        other = chance.randrange(len(words))
        words[at], words[other] = words[other], words[at]
    else:
        words[at] = chance.choice(vocabulary)
    return " ".join(words)


def mutate_text(text, chance, vocabulary):
    """One to three changes of words, lines, or the end of the text."""
    lines = text.split("\n")
    for _ in range(chance.choice((1, 1, 1, 2, 3))):
        filled = [k for k, line in enumerate(lines) if line.strip()]
        if not filled:
            break
        at = chance.choice(filled)
        kind = chance.random()
        if kind < 0.8:
            lines[at] = mutate_line(lines[at], chance, vocabulary)
        elif kind < 0.87:
            del lines[at]
        elif kind < 0.92:
            lines.insert(chance.choice(filled), lines[at])
        elif kind < 0.97:
            other = chance.choice(filled)
            lines[at], lines[other] = lines[other], lines[at]
        else:
            whole = "\n".join(lines)
            lines = whole[: chance.randrange(len(whole))].split("\n")
    return "\n".join(lines)


def mutant(number, seed):
    """The input of this number: its seed's name, the script and its files."""
    chance = random.Random(f"{seed} {number}")
    vocabulary = sorted({word for script, _ in SEEDS.values() for word in script.split()})
    name = sorted(SEEDS)[number % len(SEEDS)]
    while True:
        script, files = SEEDS[name][0], dict(SEEDS[name][1])
        if chance.random() < 0.3:
            file = chance.choice(sorted(files))
            files[file] = mutate_text(files[file], chance, vocabulary)
        else:
            script = mutate_text(script, chance, vocabulary)
        if not (FORBIDDEN.search(script) or LONG_RUN.search(script)):
            return name, script, files


def limit(memory):
    resource.setrlimit(resource.RLIMIT_AS, (memory, memory))
    resource.setrlimit(resource.RLIMIT_CORE, (0, 0))
    resource.setrlimit(resource.RLIMIT_FSIZE, (64 << 20, 64 << 20))


def outcome(folder, script, files, options):
    """Runs lmp in the folder, on several processes and with sanitizers if the options say so:
    the kind of ending, and its last words."""
    for name, text in files.items():
        (folder / name).write_text(text)
    (folder / "in.fuzz").write_text(script)
    command, environment = t.lmp_command("in.fuzz", folder, options.ranks)
    seconds, memory = SECONDS, MEMORY
    if options.sanitizer:
        seconds, memory = SANITIZER_SECONDS, resource.RLIM_INFINITY
        environment.update(ASAN_OPTIONS=SANITIZER_OPTIONS, UBSAN_OPTIONS="halt_on_error=1")
    try:
        done = subprocess.run(command, cwd=folder, env=environment, timeout=seconds,
                              stdin=subprocess.DEVNULL, stdout=subprocess.PIPE,
                              stderr=subprocess.STDOUT, preexec_fn=lambda: limit(memory))
    except subprocess.TimeoutExpired as late:
        return "hang", (late.stdout or b"").decode(errors="replace")[-2000:]
    log = done.stdout.decode(errors="replace")
    errors = re.findall(r"^ERROR.*", log, re.M)
    speakers = {re.match(r"ERROR( on proc \d+)?", line)[0] for line in errors}
    if options.sanitizer and re.search("ERROR: AddressSanitizer|hard rss limit|runtime error:",
                                       log):
        return ("memory" if OUT_OF_MEMORY.search(log) else "crash"), log[-2000:]
    if done.returncode < 0 or "Signal: " in log or done.returncode >= 128:
        return ("memory" if "bad_alloc" in log else "crash"), log[-2000:]
    dump = folder / "out.dump"
    if dump.exists() and re.search(r"\b(nan|inf)\b", dump.read_text(errors="replace"), re.I):
        return "nan", log[-2000:]
    if done.returncode == 0:
        return "well", ""
    if errors and len(errors) == len(speakers) <= options.ranks:    # each process at most one
        return "error", errors[0]
    return "unclear", log[-2000:]


def of_lammps(kind, text, words, options):
    """Whether this ending is one of LAMMPS that does not need TMSPH; the text is that of the
    script and its files."""
    for pattern, signature, plain in LAMMPS:
        if re.search(pattern, text) and signature in words:
            with tempfile.TemporaryDirectory(prefix="tmsph-") as folder:
                plain_kind, said = outcome(Path(folder), plain, {}, options)
            return plain_kind == kind and signature in said
    return False


def main():
    parser = argparse.ArgumentParser()
    parser.add_argument("count", nargs="?", type=int, default=60)
    parser.add_argument("--seed", type=int, default=1)
    parser.add_argument("--keep", help="folder for the inputs that fail")
    parser.add_argument("--first", type=int, default=0, help="number of the first input")
    parser.add_argument("--ranks", type=int, default=1, help="number of processes of each run")
    parser.add_argument("--sanitizer", action="store_true", help="lmp was built with sanitizers")
    options = parser.parse_args()
    counts, bad = collections.Counter(), []
    for name, (script, files) in SEEDS.items():
        with tempfile.TemporaryDirectory(prefix="tmsph-") as folder:
            kind, words = outcome(Path(folder), script, files, options)
        if kind != "well":
            bad.append(f"valid input {name}: {kind}: {words}")
    for number in range(options.first, options.first + options.count):
        name, script, files = mutant(number, options.seed)
        with tempfile.TemporaryDirectory(prefix="tmsph-") as folder:
            kind, words = outcome(Path(folder), script, files, options)
            text = "\n".join([script, *files.values()])
            if kind in FAILURES and of_lammps(kind, text, words, options):
                kind = "fails without TMSPH as well"
            if kind in FAILURES and options.keep:
                shutil.copytree(folder, Path(options.keep) / f"{options.seed}-{number}-{kind}",
                                dirs_exist_ok=True)
        counts[kind] += 1
        if kind in FAILURES:
            bad.append(f"input {number} of {name}: {kind}: {words[-400:]}")
            print(bad[-1], flush=True)
    print(f"{options.count} inputs, seed {options.seed}: "
          + ", ".join(f"{kind} {n}" for kind, n in sorted(counts.items())))
    for line in bad:
        print("FAILED", line)
    return 1 if bad else 0


if __name__ == "__main__":
    sys.exit(main())
