# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""No temperature ever leaves the range of the initial temperatures and of those outside, on any
step: random temperatures, boundaries that jump, materials of conductivity 1:1000 and heat capacity
1:100, long RKL2 steps. Heat is conserved to round-off, with bonds that break during the
run; with boundaries and sources the content is that at the start plus what they brought."""

import numpy as np

from heat_scenes import Heated
from tmsph_testing import LATTICES, lattice, main, material

MINERALS = [material(1.0, 0.2, 1.0), material(1.0, 0.2, 4.0)]
UNEQUAL = "conductivity 1 1.0 conductivity 2 1000.0 specific/heat 1 1.0 specific/heat 2 25.0"
STEPS = 60


def speckled(name, n, jitter=0.0):
    """A block of two minerals in random grains of one particle."""
    cells = (n,) * len(LATTICES[name][0])
    cloud = lattice(name, cells, 1.0 / n)
    cloud.type = 1 + (np.random.default_rng(3).uniform(size=len(cloud)) < 0.4)
    return cloud.jitter(jitter, 5) if jitter else cloud


def bounded(report, what, cloud, words, boundary, low, high, length=0.0):
    """length: of a heat step in stable steps; 0: explicit, 0.99 of it."""
    start = np.random.default_rng(1).uniform(0.0, 1.0, len(cloud))
    start[:2] = 0.0, 1.0
    method = "rkl2" if length else "explicit"
    scene = Heated(cloud, f"{words} subcycle {method}", boundary, start, MINERALS)
    scene.files.update(TABLES)
    scene.add("compute hi all reduce max c_T\ncompute lo all reduce min c_T")
    scene.thermo("step c_lo c_hi f_heat[6]", 1).add("timestep 1e-12\nrun 1")
    scene.add(f"variable d equal {length or 0.99}*f_heat[6]\ntimestep $d\nrun {STEPS}")
    run = scene.run()
    highest = run.thermo("c_hi").max() - high
    lowest = low - run.thermo("c_lo").min()
    report.below(f"{what}, {method} {length or 0.99:g}: outside of the range on any "
                 f"of {STEPS} steps",
                 max(highest, lowest), 1e-12)


JUMP = ("variable T equal 2.5*ternary(step%20<10,-1,1)\n"
        "fix b all tmsph/heat/boundary temperature v_T cracks yes")
FILM = "fix b all tmsph/heat/boundary convection 1e4 -1.5"
SUN = "fix b all tmsph/heat/boundary radiation 5.0 3.0 zero -4.0"
# steep ones
TABLES = {"k.table": "1\n-3.0 1.0\n0.2 30.0\n0.4 0.5\n3.0 2.0\n2\n-3.0 500\n3.0 1000\n",
          "c.table": "all\n-3.0 0.1\n0.0 10.0\n0.1 1.0\n1.0 2.0\n"}
BY_TABLE = ("conductivity 1 table k.table 1 conductivity 2 table k.table 2 "
            "specific/heat * table c.table all")


def cracks(report):
    """Heat content while a hot spot breaks bonds around it: insulated, and with all that can bring
    heat. Mechanics and heat on the same clock."""
    cloud = lattice("hex", (30, 17), 1e-3)
    cloud.type = 1 + (cloud.X[:, 0] > 0.015)
    centre = cloud.X.mean(axis=0)
    start = 140.0 * (np.linalg.norm(cloud.X - centre, axis=1) < 6e-3)
    rocks = [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2500, 1e-5)]
    words = "conductivity 1 3000.0 conductivity 2 3.0 specific/heat 1 850 specific/heat 2 600"
    more = ("fix out all tmsph/heat/boundary convection 5000 20.0 cracks yes\n"
            "group low id <= 300\nfix in low tmsph/heat/boundary flux 1e8\n"
            "group one id 500\nfix hold one tmsph/heat/boundary temperature 50.0 place body\n")
    for what, sources, outside in (("insulated", "", ""),
                                   ("boundaries and sources", " source 2 1e9", more)):
        scene = Heated(cloud, words + sources, outside, start, rocks)
        scene.add("fix move all nve\nfix hb all tmsph/hoekbrown strength * 150e6 mi * 8\n"
                  "tmsph/cut all line 5e-3 5e-3 8e-3 9e-3\ntimestep 5e-8")
        scene.thermo("step f_heat f_hb f_heat[2] f_heat[4]", 20).add("run 400")
        scene.add("tmsph/cut all line 20e-3 5e-3 25e-3 9e-3\nrun 200")
        run = scene.run()
        table = {name: np.concatenate([t[name] for t in run.tables]) for name in run.tables[0]}
        report.above(f"{what}: bonds broken", table["f_hb"][-1], 50)
        since = {name: (table[name] - table[name][0]) / table["f_heat"][0]
                 for name in ("f_heat", "f_heat[2]", "f_heat[4]")}
        if outside:
            for name, meaning in (("f_heat[2]", "boundaries"), ("f_heat[4]", "sources")):
                report.above(f"{what}: heat from {meaning}, relative", abs(since[name][-1]), 1e-6)
        missing = since["f_heat"] - since["f_heat[2]"] - since["f_heat[4]"]
        report.below(f"{what}: heat that is not accounted for, relative", np.abs(missing).max(),
                     1e-12 if outside else 1e-13)


def lattices(report):
    for what, cloud in (("square", speckled("square", 12)), ("sc", speckled("sc", 7)),
                        ("jittered", speckled("square", 12, 0.3))):
        bounded(report, f"{what}, insulated", cloud, UNEQUAL, "", 0.0, 1.0)
        for length in (3.0, 100.0, 1e4):
            bounded(report, f"{what}, insulated", cloud, UNEQUAL, "", 0.0, 1.0, length)
            bounded(report, f"{what}, jumps", cloud, UNEQUAL, JUMP, -2.5, 2.5, length)
        bounded(report, f"{what}, convection", cloud, UNEQUAL, FILM, -1.5, 1.0, 300.0)
        bounded(report, f"{what}, radiation", cloud, UNEQUAL, SUN, 0.0, 3.0, 300.0)


def orthotropic(report):
    turned = "conductivity * orthotropic 1000.0 1.0 30 specific/heat * 1.0"
    bounded(report, "orthotropic", speckled("square", 12), turned, JUMP, -2.5, 2.5, 300.0)


def tables(report):
    bounded(report, "tables", speckled("square", 12), BY_TABLE, "", 0.0, 1.0)
    for length in (3.0, 300.0):
        bounded(report, "tables", speckled("square", 12), BY_TABLE, JUMP, -2.5, 2.5, length)


if __name__ == "__main__":
    main(lattices, orthotropic, tables, cracks)
