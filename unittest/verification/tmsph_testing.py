# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What the verification tests share: clouds of particles, running lmp, reading
its output, and reporting measured values against their bars."""

import os
import re
import shutil
import subprocess
import sys
import tempfile
import time
from pathlib import Path

import numpy as np

HORIZON = 3.015    # in particle spacings, as in the documentation

# Open MPI starts in a fifth of the time if it looks for nobody to talk to

ALONE = {"OMPI_MCA_ess_singleton_isolated": "1", "OMPI_MCA_pml": "ob1", "OMPI_MCA_btl": "self"}

# Cells of the lattices by name: edge lengths and basis, in spacings

LATTICES = {
    "square": ((1.0, 1.0), [(0.0, 0.0)]),
    "hex": ((1.0, 3.0**0.5), [(0.0, 0.0), (0.5, 0.5)]),
    "sc": ((1.0, 1.0, 1.0), [(0.0, 0.0, 0.0)]),
    "fcc": ((2.0**0.5,) * 3, [(0, 0, 0), (0.5, 0.5, 0), (0.5, 0, 0.5), (0, 0.5, 0.5)]),
}


class Cloud:
    """Particles in their reference positions; lengths in metres."""

    def __init__(self, positions, volume, spacing, periodic="", box=None):
        self.X = np.asarray(positions, float)
        n, self.dimension = self.X.shape
        self.spacing = spacing
        self.type = np.ones(n, int)
        self.volume = np.full(n, float(volume))
        self.periodic = periodic    # the periodic directions, such as "xy"
        self.box = box              # (low, high) of the periodic directions

    def __len__(self):
        return len(self.X)

    def kept(self, inside):
        """The particles for which inside(X) holds."""
        chosen = inside(self.X)
        part = Cloud(self.X[chosen], 1.0, self.spacing, self.periodic, self.box)
        part.type, part.volume = self.type[chosen], self.volume[chosen]
        return part

    def jitter(self, amount, seed):
        """Moves every particle by up to amount spacings in each direction."""
        shift = np.random.default_rng(seed).uniform(-amount, amount, self.X.shape)
        self.X = self.X + shift * self.spacing
        return self

    def data(self, temperature):
        """A data file; masses follow from the densities."""
        lines = ["TMSPH", "", f"{len(self)} atoms", f"{self.type.max()} atom types", ""]
        for k, axis in enumerate("xyz"):
            if axis in self.periodic:
                low, high = self.box[0][k], self.box[1][k]
            elif k < self.dimension:
                low, high = self.X[:, k].min() - self.spacing, self.X[:, k].max() + self.spacing
            else:
                low, high = -0.5 * self.spacing, 0.5 * self.spacing
            lines.append(f"{low:.17g} {high:.17g} {axis}lo {axis}hi")
        lines += ["", "Atoms # tmsph", ""]
        temperature = np.broadcast_to(temperature, len(self))
        X = np.zeros((len(self), 3))
        X[:, : self.dimension] = self.X
        for i in range(len(self)):
            lines.append(f"{i + 1} {self.type[i]} {self.volume[i]:.17g} 0 {temperature[i]:.17g} "
                         f"{X[i, 0]:.17g} {X[i, 1]:.17g} {X[i, 2]:.17g}")
        return "\n".join(lines) + "\n"


def lattice(name, cells, spacing, periodic="", centre=False):
    """A block of so many cells in each direction, its cells filling the box from 0."""
    edges, basis = LATTICES[name]
    edges = np.array(edges)
    corner = np.indices(cells).reshape(len(cells), -1).T
    points = (corner[:, None, :] + np.array(basis)[None]).reshape(-1, len(cells))
    points = (points + 0.5 / (2 if len(basis) > 1 else 1)) * edges
    size = np.array(cells) * edges
    low = -0.5 * size if centre else np.zeros(len(cells))
    return Cloud((points + low) * spacing, np.prod(edges) / len(basis) * spacing ** len(cells),
                 spacing, periodic, (low * spacing, (low + size) * spacing))


def material(young=40e9, poisson=0.3, density=2700.0, expansion=0.0):
    return dict(young=young, poisson=poisson, density=density, expansion=expansion)


def disc_materials(swapped):
    """Inclusion and matrix of Mu et al. (2022), Table 1."""
    inner, outer = (1e-5, 1.5e-5) if swapped else (1.5e-5, 1e-5)
    return material(40e9, 0.3, 2700, inner), material(20e9, 0.2, 2700, outer)


def contact_pressure(pair, plane, a, R, heating):
    """Between an inclusion of radius a and a matrix of radius R (Lame)."""
    E, nu, alpha = (np.array([m[key] for m in pair]) for key in ("young", "poisson", "expansion"))
    if plane == "strain":
        E, nu, alpha = E / (1 - nu**2), nu / (1 - nu), (1 + nu) * alpha
    shell = a**2 / (R**2 - a**2) * ((1 - nu[1]) + (1 + nu[1]) * R**2 / a**2) / E[1]
    return (alpha[0] - alpha[1]) * heating / ((1 - nu[0]) / E[0] + shell)


def disc_polar_stress(p, a, R, r, inside):
    """Radial and hoop stress at radii r under the contact pressure p."""
    A = p * a**2 / (R**2 - a**2)
    ratio = (R / np.maximum(r, 0.1 * a)) ** 2
    return np.where(inside, -p, A * (1 - ratio)), np.where(inside, -p, A * (1 + ratio))


def disc_stress(pair, plane, a, R, X, inside):
    """xx, yy and xy of the heated disc per degree, in columns."""
    x, y = X.T
    radial, hoop = disc_polar_stress(contact_pressure(pair, plane, a, R, 1.0), a, R, np.hypot(x, y),
                                     inside)
    angle = np.arctan2(y, x)
    c, s = np.cos(angle), np.sin(angle)
    return np.stack([c * c * radial + s * s * hoop, s * s * radial + c * c * hoop,
                     c * s * (radial - hoop)], axis=1)


class Script:
    """An input script and the files that it names."""

    def __init__(self, text="", files=None):
        self.lines = [text]
        self.files = dict(files or {})

    def add(self, text):
        self.lines.append(text)
        return self

    def dump(self, name, columns, every=1, group="all"):
        self.add(f"dump {name} {group} custom {every} {name}.dump id {columns}\n"
                 f"dump_modify {name} sort id format float %.17g")
        return self

    def snapshot(self, name, columns, group="all"):
        """One dump now: forces and stresses are those of the last run."""
        return self.add(f"write_dump {group} custom {name}.dump id {columns} "
                        "modify sort id format float %.17g")

    def run(self, ranks=1, may_fail=False, keep="", timeout=None):
        """keep: a pattern of files to hold on to, for a script that continues. timeout: seconds
        after which lmp is killed."""
        return Run(self, ranks, may_fail, keep, timeout)


class Scene(Script):
    """A script that starts with the head that all tests of a cloud need."""

    def __init__(self, cloud, materials, pair="", temperature=0.0, horizon=HORIZON):
        d = cloud.dimension
        boundary = " ".join("p" if axis in cloud.periodic or k >= d else "s"
                            for k, axis in enumerate("xyz"))
        self.cloud = cloud
        self.files = {"cloud.data": cloud.data(temperature)}
        self.lines = ["units si", f"dimension {d}", f"boundary {boundary}", "atom_style tmsph",
                      "comm_modify cutoff " + f"{2 * horizon * cloud.spacing:.6g}",
                      "read_data cloud.data",
                      f"pair_style tmsph {horizon * cloud.spacing:.17g} {pair}"]
        for k, m in enumerate(materials, 1):
            self.lines.append(f"pair_coeff {k} {k} elastic {m['young']:.17g} {m['poisson']:.17g} "
                              f"density {m['density']:.17g} expansion {m['expansion']:.17g}"
                              + (f" horizon {m['horizon']:.17g}" if "horizon" in m else ""))
        self.thermo("step pe press")

    def thermo(self, columns, every=1000):
        return self.add(f"thermo_style custom {columns}\n"
                        f"thermo_modify norm no format float %.17g\nthermo {every}")

    def set(self, attributes, values):
        """Sets atom attributes, such as 'x y', to one column of values each."""
        for name, column in zip(attributes.split(), np.atleast_2d(np.transpose(values))):
            file = f"{name}.{len(self.files)}"
            rows = "\n".join(f"{i + 1} {v:.17g}" for i, v in enumerate(column))
            self.files[file] = f"\n{len(column)}\n{rows}\n"
            variable = file.replace(".", "_")
            self.add(f"variable {variable} atomfile {file}\nset group all {name} v_{variable}")
        return self

    def move(self, positions):
        """Takes the particles to new positions: deformation, once the bonds have formed."""
        return self.set("x y z"[: 2 * self.cloud.dimension - 1], positions)

    def minimize(self, residual, iterations=20000, style="cg"):
        """Conjugate gradients down to a root mean square force on a particle."""
        norm = residual * len(self.cloud) ** 0.5
        self.add(f"min_style {style}\n"
                 f"min_modify line forcezero dmax {0.01 * self.cloud.spacing:.6g}\n"
                 f"minimize 0 {norm:.6g} {iterations} {10 * iterations}")
        return self


def launcher_for(ranks):
    """What starts lmp on so many processes; nothing if lmp was built without MPI, which is then
    compared with itself."""
    if ranks == 1:
        return None
    launcher = os.environ.get("TMSPH_MPIRUN")
    if not launcher:
        about = subprocess.run([os.environ["TMSPH_LMP"], "-h"], capture_output=True, text=True)
        if "MPI STUBS" not in about.stdout:
            raise RuntimeError("TMSPH_MPIRUN is not set: this test needs MPI")
        print(f"     lmp without MPI: 1 process instead of {ranks}", flush=True)
    return launcher


def lmp_command(script, folder, ranks, log="none"):
    """Command and environment that run a script on so many processes."""
    command = [os.environ["TMSPH_LMP"], "-in", script, "-log", log, "-nocite"]
    # a folder each: Open MPI's runs that start and end at once take a shared one away from each
    # other
    environment = dict(os.environ, OMP_NUM_THREADS="1", TMPDIR=str(folder))
    launcher = launcher_for(ranks)
    if launcher:
        environment.update(OMPI_ALLOW_RUN_AS_ROOT="1", OMPI_ALLOW_RUN_AS_ROOT_CONFIRM="1",
                           OMPI_MCA_rmaps_base_oversubscribe="1",
                           OMPI_MCA_hwloc_base_binding_policy="none",
                           OMPI_MCA_mpi_yield_when_idle="1")
        return [launcher, "-np", str(ranks)] + command, environment
    environment.update(ALONE)
    return command, environment


class Run:
    """One run of lmp: its thermodynamic output, its dumps (*.dump of particles, *.local of
    rows), the files to keep and its cost. What it said on the screen is log; status is negative
    after a signal, None if it took too long."""

    def __init__(self, scene, ranks, may_fail, keep="", timeout=None):
        folder = Path(tempfile.mkdtemp(prefix="tmsph-"))
        try:
            for name, text in scene.files.items():
                (folder / name).parent.mkdir(parents=True, exist_ok=True)
                (folder / name).write_bytes(text if isinstance(text, bytes) else text.encode())
            (folder / "in.test").write_text("\n".join(scene.lines) + "\n")
            command, environment = lmp_command("in.test", folder, ranks, "log.test")
            try:
                done = subprocess.run(command, cwd=folder, env=environment, timeout=timeout,
                                      stdout=subprocess.PIPE, stderr=subprocess.STDOUT)
                output, self.status = done.stdout, done.returncode
            except subprocess.TimeoutExpired as late:
                output, self.status = late.stdout or b"", None
            self.log = output.decode(errors="replace")
            self.failed = self.status != 0
            self.cost = Cost(self.log, ranks)
            if self.failed and not may_fail:
                raise RuntimeError("lmp stopped:\n" + self.log[-3000:])
            # not from the screen: how long a run takes decides what else is said there
            log = folder / "log.test"
            self.tables = read_thermo(log.read_text(errors="replace")) if log.exists() else []
            self.dumps = {file.stem: read_dump(file) for file in folder.glob("*.dump")}
            self.dumps.update((file.stem, read_dump(file)) for file in folder.glob("*.local"))
            self.kept = {file.name: file.read_bytes() for file in folder.glob(keep)} if keep else {}
        finally:
            shutil.rmtree(folder, ignore_errors=True)

    def thermo(self, name, run=-1):
        """One column of the thermodynamic output of one run."""
        return self.tables[run][name]

    def frame(self, dump, which=-1):
        return self.dumps[dump][which]


class Cost:
    """What a run of lmp took, from its log, all run and minimize commands together: seconds of
    the loops and their steps, particles, and the memory of all ranks in bytes by LAMMPS's own
    count. Seconds are those of a processor: on several ranks of one of them, which is busy
    while it waits."""

    def __init__(self, log, ranks):
        loops = re.findall(r"^Loop time of (\S+) on \d+ procs for (\d+) steps with (\d+) atoms"
                           r"(?:(?!^Loop time)[\s\S])*?^([\d.]+)% CPU use", log, re.M)
        memory = re.findall(r"memory allocation \(min/avg/max\) = \S+ \| (\S+) \|", log)
        self.ranks, self.memory = ranks, float(memory[-1]) * 2**20 * ranks if memory else 0.0
        self.steps = sum(int(steps) for _, steps, _, _ in loops)
        self.seconds = sum(self._busy(float(wall), float(share) / 100)
                           for wall, steps, _, share in loops if int(steps))
        self.particles = int(loops[-1][2]) if loops else 0

    @staticmethod
    def _busy(wall, share):
        """The system counts the time of a processor too coarsely for short loops."""
        return wall if wall < 0.02 else wall * min(1.0, share)


def read_thermo(log):
    """The tables of a log file, one dictionary of columns for each run. Rows cut
    short by an error end a table."""
    tables, rows, names = [], None, None
    for line in log.splitlines():
        words = line.split()
        if words[:1] == ["Step"]:
            names, rows = words, []
            tables.append((names, rows))
        elif rows is not None:
            try:
                values = [float(word) for word in words]
            except ValueError:
                values = []
            if len(values) == len(names):
                rows.append(values)
            elif not line.startswith("WARNING"):
                rows = None
    return [dict(zip(names, np.array(rows, float).reshape(-1, len(names)).T))
            for names, rows in tables]


class Frame(dict):
    """One snapshot: columns by name; several at once, as columns of an array, by
    a text of names."""

    def __call__(self, names):
        return np.stack([self[name] for name in names.split()], axis=1)


def read_dump(path):
    """The snapshots of a text dump, of particles sorted by id or of rows as they stand. One cut
    short by an error is left out."""
    frames = []
    with open(path) as file:
        while line := file.readline():
            if line.startswith("ITEM: TIMESTEP"):
                step = int(file.readline())
            elif line.startswith("ITEM: NUMBER OF"):
                n = int(file.readline())
            elif line.startswith(("ITEM: ATOMS", "ITEM: ENTRIES")):
                names = line.split()[2:]
                words = [file.readline().split() for _ in range(n)]
                if any(len(row) != len(names) for row in words):
                    break
                rows = np.array(words, float).reshape(-1, len(names))
                if "id" in names:
                    rows = rows[rows[:, names.index("id")].argsort()]
                frame = Frame(zip(names, rows.T))
                frame.step = step
                frames.append(frame)
    return frames


class Report:
    """Collects measured values; finish() ends the test."""

    def __init__(self):
        self.failures = 0
        self.start = time.monotonic()

    def _line(self, name, value, bar, good):
        print(f"{'ok  ' if good else 'FAIL'} {name}: {value} ({bar})", flush=True)
        self.failures += not good

    def below(self, name, value, bar):
        """A NaN fails."""
        self._line(name, f"{value:.4g}", f"below {bar:g}", bool(value < bar))

    def above(self, name, value, bar):
        self._line(name, f"{value:.4g}", f"above {bar:g}", bool(value > bar))

    def within(self, name, value, low, high):
        self._line(name, f"{value:.5g}", f"{low:g} to {high:g}", bool(low <= value <= high))

    def true(self, name, value, what):
        self._line(name, "yes" if value else "no", what, bool(value))

    def note(self, name, value):
        """A figure without a bar, for the record."""
        print(f"     {name}: {value}", flush=True)

    def finish(self):
        print(f"     time: {time.monotonic() - self.start:.1f} s")
        sys.exit(1 if self.failures else 0)


def thorough():
    """Whether the command line has the word all, which asks for more than is tested: sizes, ways
    and tables."""
    return "all" in sys.argv[1:]


def main(*cases, more=()):
    """Runs the cases of a test, functions of a report, or those of them that the command line
    names, and ends the test; --list prints their names. more: cases that are run if they or all
    are asked for."""
    known = {case.__name__: case for case in (*cases, *more)}
    words = [word for word in sys.argv[1:] if word != "all"]
    if "--list" in words:
        print("\n".join(known))
        return
    for word in words:
        if word not in known:
            sys.exit(f"There is no case '{word}': --list prints their names")
    report = Report()
    for name, case in known.items():
        if name in words or not words and (case in cases or thorough()):
            case(report)
    report.finish()


def sampled_frequency(q, interval):
    """Of a cosine from samples at equal intervals: q_(m+1) + q_(m-1) = 2 cos(omega dt) q_m."""
    cosine = np.dot(q[2:] + q[:-2], q[1:-1]) / (2 * np.dot(q[1:-1], q[1:-1]))
    return np.arccos(cosine) / interval


def order(errors, refinement=2.0):
    """Observed orders of convergence between successive refinements."""
    errors = np.abs(errors)
    return np.log(errors[:-1] / errors[1:]) / np.log(refinement)
