# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The script ./tmsph, with commands in the place of apt, cmake, ctest and sudo that note how they
were called: what it installs, builds, waits for and says. Nothing is built or fetched."""

import os
import subprocess
import tempfile
import time
from pathlib import Path

from tmsph_testing import main

ROOT = Path(__file__).resolve().parents[2]

# cmake configures by writing what ninja and the script look for, and builds an lmp that tells its
# words

STUBS = {
    "cmake": r"""
if [ "$1" = --build ]; then
  if [ -n "${SLOW_BUILD:-}" ]; then
    echo "[10/20] half"
    while [ ! -e "$SLOW_BUILD" ]; do sleep 0.05; done
  fi
  printf '#!/bin/sh\n[ "$1" != -h ] || echo "Compiler: stub"\necho "lmp $*"\n' >"$2/lmp"
  chmod +x "$2/lmp"
  echo "[20/20] lmp"
else
  for word; do
    case $word in TMSPH_TESTS=*) echo "TMSPH_TESTS:BOOL=${word#*=}" >"$4/CMakeCache.txt" ;; esac
  done
  touch "$4/build.ninja"
fi""",
    "ctest": 'echo "ctest $*"',
    "dpkg-query": '[ -n "${MISSING:-}" ] || for word; do echo "$word installed"; done',
    "apt-get": r"""case "$*" in
  *indextargets*) echo "bookworm http://mirror.example/debian/ /etc/apt/x:1" ;;
  *install*) echo "E: Unable to locate package cmake"; exit 100 ;;
  *) echo "Err:1 http://mirror.example/debian bookworm InRelease"
     echo "  Temporary failure resolving 'mirror.example'" ;; esac""",
    "apt-cache": "true",
    "curl": 'echo "curl: (6) Could not resolve host: github.com"; exit 6',
    "sudo": "exit 1",
    "id": 'case "$*" in -u) echo "${USER_ID:-0}" ;; *) /usr/bin/id "$@" ;; esac',
}


class Place:
    """A home, a LAMMPS tree and an input of its own."""

    def __init__(self, folder):
        self.folder = Path(folder)
        self.calls = self.folder / "calls"
        for name in ("bin", "lammps/src", "home", "run"):
            (self.folder / name).mkdir(parents=True)
        self.version_file = self.folder / "lammps/src/version.h"
        self.version_file.write_text("")
        (self.folder / "run/in.x").write_text("print done\n")
        for name, text in STUBS.items():
            path = self.folder / "bin" / name
            path.write_text(f'#!/bin/bash\necho "{name} $*" >>"{self.calls}"\n{text}\n')
            path.chmod(0o755)
        past = time.time() - 100
        os.utime(self.version_file, (past, past))

    def environment(self, **more):
        kept = {key: value for key, value in os.environ.items()
                if not key.startswith(("TMSPH", "XDG", "LAMMPS"))}
        return {**kept, "PATH": f"{self.folder}/bin:{os.environ['PATH']}",
                "HOME": str(self.folder / "home"), "LAMMPS_SOURCE_DIR": str(self.folder / "lammps"),
                **more}

    def start(self, *words, **more):
        self.calls.write_text("")
        return subprocess.Popen([ROOT / "tmsph", *words], cwd=self.folder, text=True,
                                env=self.environment(**more), stdout=subprocess.PIPE,
                                stderr=subprocess.PIPE)

    def call(self, *words, **more):
        """Exit status, output, what was said, commands called."""
        process = self.start(*words, **more)
        out, said = process.communicate(timeout=60)
        return process.returncode, out, said, self.calls.read_text()

    @property
    def cache(self):
        return self.folder / "home/.cache/tmsph"


def what_is_built(report, place):
    status, out, said, calls = place.call("--version")
    report.true("--version before a build", status == 0 and "not built yet" in out
                and "cmake -" not in calls and str(place.cache / "build-") in out, out.strip())
    status, out, said, calls = place.call("run", "-np", "1", "nowhere")
    report.true("no input", status == 1 and "no input file 'nowhere'" in said and not calls, said)

    status, out, said, calls = place.call("run", "run/in.x", "-var", "a", "b c")
    report.true("run builds lmp and runs it", status == 0 and out == "lmp -in in.x -var a b c\n",
                out.strip())
    report.true("without the tests", "TMSPH_TESTS=off" in calls and "--target lmp" in calls
                and "--target all" not in calls, "configured without them")
    report.true("and their packages", "libgtest-dev" not in calls and "python3" not in calls
                and "libopenmpi-dev" in calls, "asks for those to build")
    report.true("a second run starts at once", "cmake -" not in place.call("run", "run/in.x")[3],
                "no build")

    status, out, said, calls = place.call("test", "-j1")
    report.true("test adds the tests", "TMSPH_TESTS=on" in calls and "--target all" in calls
                and "--target lmp" not in calls and "libgtest-dev" in calls,
                "and builds lmp no more")
    report.true("test leaves out slow ones", "-LE slow -j1" in out, out.strip())
    for words in (["-L", "slow"], ["-R", "disc"], ["-I", "1,2"]):
        out = place.call("test", *words)[1]
        report.true(f"test {' '.join(words)}", "-LE" not in out, out.strip())
    calls = place.call("run", "run/in.x")[3]
    report.true("run after test", "cmake -" not in calls, "no build")
    place.version_file.touch()
    calls = place.call("run", "run/in.x")[3]
    report.true("run after a change", "--target lmp" in calls and "cmake -S" not in calls,
                "a build")
    out = place.call("--version")[1]
    report.true("--version", "compiler stub" in out and "not built" not in out, out.strip())


def what_waits(report, place):
    """While the tests are being built a run starts, but not while lmp is."""
    place.call("run", "run/in.x")
    ready = place.folder / "ready"
    tests = place.start("test", SLOW_BUILD=str(ready))
    seen = []
    while not seen or "10 of 20" not in seen[-1]:    # arrives while the build goes on
        seen.append(tests.stderr.readline())
        if not seen[-1]:
            break
    report.true("progress while it builds", "10 of 20" in seen[-1], "line by line")
    out = place.call("run", "run/in.x")[1]
    report.true("run while tests build", out == "lmp -in in.x\n" and tests.poll() is None,
                "does not wait")
    place.version_file.touch()
    late = place.start("run", "run/in.x")
    said = late.stderr.readline()
    report.true("run after a change while tests build", "waiting for another call" in said,
                said.strip())
    ready.touch()
    report.true("then it goes on", late.communicate(timeout=60)[0] == "lmp -in in.x\n", "lmp runs")
    tests.communicate(timeout=60)


def what_fails(report, place):
    status, out, said, calls = place.call("tset")
    report.true("a wrong word", status == 2 and "no command 'tset'" in said and not calls,
                said.strip())
    for words, told in ((["-n", "2", "run/in.x"], "not '-n'"),
                        (["run/in.x", "-np", "2"], "-np N comes before"),
                        (["-np", "0", "run/in.x"], "a number of processes"),
                        (["-np"], "a number of processes"), (["run"], "no input file 'run'")):
        status, out, said, calls = place.call("run", *words)
        report.true(f"run {' '.join(words)}", status == 1 and told in said and not calls
                    and said.count("\n") == 1, said.strip())
    status, out, said, calls = place.call("run", "run/in.x", MISSING="yes", USER_ID="1000")
    line = [row for row in said.split("\n") if "apt-get install" in row]
    report.true("without root", status == 1 and line and line[0].strip().startswith("sudo apt-get")
                and " g++ " in line[0] and "libgtest" not in line[0] and "apt-get" not in calls,
                said.strip())
    status, out, said, calls = place.call("run", "run/in.x", MISSING="yes")
    report.true("packages without network", status == 1 and said.rstrip().endswith(
        "failed: installing them, as the network cannot be reached: see above"),
        said.strip().split("\n")[-1])
    status, out, said, calls = place.call("run", "run/in.x", LAMMPS_SOURCE_DIR="")
    report.true("LAMMPS without network", status == 1 and "network cannot be reached" in said
                and "LAMMPS_SOURCE_DIR" in said, said.strip().split("\n")[-1])
    status, out, said, calls = place.call("run", "run/in.x", LAMMPS_SOURCE_DIR="", TMSPH_LAMMPS="1")
    report.true("another LAMMPS", status == 1 and "4Feb2025 or 4Jul2026" in said, said.strip())


def pages_and_make(report):
    """The batch script of README is one, and traditional make is refused in one line."""
    text = (ROOT / "README.md").read_text()
    block = text[text.index("#!/bin/bash"):]
    done = subprocess.run(["bash", "-n"], input=block[:block.index("```")], text=True,
                          capture_output=True)
    report.true("batch script of README", done.returncode == 0,
                done.stderr or "its syntax is right")
    done = subprocess.run(["sh", "Install.sh", "1"], cwd=ROOT / "src/TMSPH", text=True,
                          capture_output=True)
    report.true("make yes-tmsph", done.returncode != 0 and done.stderr.count("\n") == 1
                and "./tmsph" in done.stderr, done.stderr.strip())


def in_a_place(part):
    """A case of a report, in a place of its own."""
    def case(report):
        with tempfile.TemporaryDirectory() as folder:
            part(report, Place(folder))

    case.__name__ = part.__name__
    return case


if __name__ == "__main__":
    main(pages_and_make, *map(in_a_place, (what_is_built, what_waits, what_fails)))
