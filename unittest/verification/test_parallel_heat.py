# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A body heated through its surface, with tables, an orthotropic mineral, sources, and bonds that
break on the way: the same to the last bit on any number of processors, balanced or not, in one run
or several, and continued from a restart, in 2-D and 3-D. Accounts are sums over processors and
agree to round-off."""

import numpy as np

from tmsph_testing import Scene, Script, lattice, main, material

SPACING = 1e-3
ROCKS = [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2500, 1e-5)]
STATE = "x y z vx vy vz fx fy fz c_t c_p[*]"
ACCOUNTS = "f_heat f_heat[2] f_heat[4] f_hot[2] f_cold[2] f_sun[2]"
COUNTS = "f_heat[8] f_hb"
# 1 as in an igneous rock, 2 of single precision, so that rounding would show
PROPERTIES = {"rock.table": "k\n0 2.9\n100 2.4\n300 2.0\nc\n0 750\n200 920\n500 1050\n"}


class Body:
    """steps: enough for some bonds to break in the hot corner. touches: fragments by contact, whose
    particles move so little that they keep their places in a run while most bonds break."""

    def __init__(self, dimension, conductivity, jitter=0.0, touches=False):
        two = dimension == 2
        name, n, self.steps = ("hex", (26, 15), 160) if two else ("sc", (9, 9, 9), 120)
        self.cloud = lattice(name, n, SPACING)
        self.cloud.type = 1 + (np.linalg.norm(self.cloud.X - self.cloud.X.mean(axis=0), axis=1)
                               < 3.3 * SPACING)
        self.cloud.jitter(jitter, 11)
        self.conductivity = conductivity
        self.touches = "fix touch all tmsph/contact friction * * 0.3\n" * touches
        top = self.cloud.X[:, dimension - 1].max() - 0.5 * SPACING
        axis = "INF INF " * (dimension - 1)
        self.groups = f"region top block {axis}{top:.17g} INF{' INF INF' * (3 - dimension)}\n" \
            "group top region top\ngroup left id 1:60\n"

    def fixes(self, scene, more=""):
        """All that a restart does not carry."""
        return scene.add(
            "fix move all nve\nvariable hot equal 3000*(1-exp(-step/60))\n"
            "variable sun atom 5e7*(1+x*1e2)\n"
            f"fix heat all tmsph/heat {self.conductivity} "
            "specific/heat * table rock.table c source 2 v_sun time/scale 1e5 every 2\n"
            "fix hot top tmsph/heat/boundary temperature v_hot place surface cracks yes\n"
            "fix cold left tmsph/heat/boundary convection 5e4 -20.0\n"
            "fix sun all tmsph/heat/boundary radiation 5e-8 900.0 zero -273.15\n"
            "fix hb all tmsph/hoekbrown strength 1 60e6 strength 2 50e6 mi * 8 weibull * 10 4711\n"
            "compute t all tmsph/property/atom temperature\n"
            "compute p all tmsph/property/atom damage sxx syy s1\n"
            f"timestep {0.3 * SPACING / 4465:.17g}\nthermo_style custom step {ACCOUNTS} {COUNTS}\n"
            f"thermo_modify norm no format float %.17g\nthermo 20\n{self.touches}{more}")

    def start(self, more=""):
        scene = Scene(self.cloud, ROCKS, "viscosity 1 2").add(self.groups)
        scene.files.update(PROPERTIES)
        return self.fixes(scene, more)

    def ending(self, scene, runs):
        for n in runs:
            scene.add(f"run {n}")
        return scene.snapshot("end", STATE)


def compare(report, what, body):
    def same(run, label):
        names = sorted(reference.frame("end"))
        differ = np.count_nonzero(~(run.frame("end")(" ".join(names)) == state(" ".join(names))))
        report.below(f"{what}, {label}: values that differ", differ, 1)
        for name in COUNTS.split():
            report.true(f"{what}, {label}: {name}",
                        run.thermo(name)[-1] == reference.thermo(name)[-1], "the same")
        scale = np.abs(reference.thermo("f_heat")[-1])
        worst = max(abs(run.thermo(name)[-1] - reference.thermo(name)[-1])
                    for name in ACCOUNTS.split())
        report.below(f"{what}, {label}: accounts, relative", worst / scale, 1e-13)

    n = body.steps
    reference = body.ending(body.start(), [n]).run()
    state = reference.frame("end")
    table = reference.tables[0]
    report.above(f"{what}: bonds broken", table["f_hb"][-1], 20)
    for name in ("f_hot[2]", "f_cold[2]", "f_sun[2]", "f_heat[4]"):
        report.above(f"{what}: {name} relative to the content",
                     abs(table[name][-1] / table["f_heat"][-1]), 1e-6)
    missing = (table["f_heat"] - table["f_heat[2]"] - table["f_heat[4]"])
    report.below(f"{what}: heat that is not accounted for, relative",
                 np.ptp(missing) / table["f_heat"][-1], 1e-12)
    balance = "comm_style tiled\nfix lb all balance 40 0.95 rcb\n"
    for ranks, more, label in ((2, "", "on 2"), (4, "", "on 4"), (4, balance, "balanced on 4")):
        same(body.ending(body.start(more), [n]).run(ranks), label)
    parts = [n // 4, n // 3, n - n // 4 - n // 3]
    same(body.ending(body.start(), parts).run(2), "three runs on 2")
    middle = n // 2
    first = body.start().add(f"run {middle}\nwrite_restart middle.restart")
    written = first.run(2, keep="*.restart")
    report.within(f"{what}: broken at the restart, share",
                  written.thermo("f_hb")[-1] / table["f_hb"][-1], 0.01, 0.99)
    for ranks in (1, 4):
        scene = Script(f"comm_modify cutoff {6 * SPACING}\nread_restart middle.restart",
                       dict(written.kept, **PROPERTIES))
        same(body.ending(body.fixes(scene), [n - middle]).run(ranks), f"continued on {ranks}")


def viscous_heat(report):
    """Of a body in motion heated by its viscosity: stresses as well are the same at the end of a
    step."""
    cloud = lattice("hex", (12, 7), SPACING)
    scene = Scene(cloud, [ROCKS[0]], "viscosity 1 2")
    scene.add("variable fast atom 50*sin(x*1e3)\nset group all vx v_fast\nfix move all nve\n"
              "fix heat all tmsph/heat conductivity * 2.9 specific/heat * 850 viscous yes\n"
              "compute p all tmsph/property/atom sxx syy temperature\n"
              f"timestep {0.2 * SPACING / 4465:.17g}\nrun 10")
    scene.dump("end", "vx fx c_p[*]", 5).add("run 10")
    alone, both = scene.run(), scene.run(ranks=2)
    names = "vx fx c_p[1] c_p[2] c_p[3]"
    differ = np.count_nonzero(alone.frame("end")(names) != both.frame("end")(names))
    report.above("viscous: warmest particle", alone.frame("end")["c_p[3]"].max(), 1e-6)
    report.below("viscous, 2 ranks: values that differ", differ, 1)
    told = Script("\n".join(scene.lines).replace("fix heat", "compute dt all tmsph/dt\n"
                  "fix dt all ave/time 1 1 1 c_dt\nfix heat"), scene.files).run()
    differ = np.count_nonzero(alone.frame("end")(names) != told.frame("end")(names))
    report.below("viscous, with the stable step in each step: values that differ", differ, 1)


def jittered(report):
    compare(report, "2-D, tables, jittered", Body(2, "conductivity * table rock.table k", 0.15))


def orthotropic(report):
    compare(report, "2-D, orthotropic",
            Body(2, "conductivity 1 orthotropic 3.0 1.0 25 conductivity 2 2.0"))


def touching_block(report):
    compare(report, "3-D, with contact", Body(3, "conductivity * 2.5", touches=True))


def block(report):
    compare(report, "3-D",
            Body(3, "conductivity 1 orthotropic 3.0 1.0 2.0 1 1 0 35 conductivity 2 2.0"))


if __name__ == "__main__":
    main(jittered, orthotropic, block, touching_block, viscous_heat)
