# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Closed forms of what boundaries, sources and tables do: fluxes and sources heat a body by their
power, radiation and convection cool a thin one as a lump, a conductivity that depends on
temperature has Kirchhoff's steady profile, a heat capacity that does has its enthalpy. Variables,
the clock (every, time/scale), and a scene without heat, which knows nothing of it."""

import re

import numpy as np

from heat_scenes import SIDES, UNIFORM, Heated, bisect, listed, rms, slab
from tmsph_testing import LATTICES, Scene, lattice, main, material, order


def block(name="square", n=6, spacing=0.1):
    return lattice(name, (n,) * len(LATTICES[name][0]), spacing)


def sources(report):
    """Number, equal-style and atom-style variables; energy is power times volume times time."""
    for name in ("square", "sc"):
        cloud = block(name)
        cloud.type[: len(cloud) // 2] = 2
        for what, value, density in (
                ("number", "3.0", 3.0), ("equal-style", "v_s", 5.0), ("atom-style", "v_x", None)):
            scene = Heated(cloud, "conductivity * 1 specific/heat 1 2.0 specific/heat 2 5.0 "
                           f"source 2 {value}", "variable s equal 5.0\nvariable x atom 2+x")
            T = scene.run_to(0.5, 5, columns="step f_heat f_heat[3] f_heat[4]")
            power = (cloud.volume * (cloud.type == 2)
                     * (density if density else 2 + cloud.X[:, 0])).sum()
            for column, exact in (("f_heat", 0.5 * power), ("f_heat[3]", power),
                                  ("f_heat[4]", 0.5 * power)):
                report.below(f"source, {name}, {what}: {column}",
                             abs(scene.done.thermo(column)[-1] / exact - 1), 1e-12)
            content = (cloud.volume * np.where(cloud.type == 1, 2.0, 5.0) * T).sum()
            report.below(f"source, {name}, {what}: heat content of the temperatures",
                         abs(content / (0.5 * power) - 1), 1e-12)


def steps_in_time(report):
    """A flux that follows time, with every and time/scale: the heat clock runs S times as fast."""
    cloud = slab(8)
    for every, scale in ((1, 1.0), (4, 1.0), (5, 10.0)):
        scene = Heated(cloud, f"{UNIFORM} every {every} time/scale {scale}",
                       SIDES + "variable q equal 2.0+step/20\n"
                       "fix a left tmsph/heat/boundary flux v_q\nvariable t atom 0.5")
        scene.run_to(0.1, 20, columns="step f_heat f_a[2] f_heat[7]")
        steps = np.arange(every, 21, every)
        width = cloud.box[1][1]
        exact = width * scale * 0.1 / 20 * every * np.sum(2.0 + steps / 20)
        what = f"every {every}, time/scale {scale:g}"
        for column in ("f_heat", "f_a[2]"):
            # areas are sums of single precision weights
            report.below(f"{what}: {column}", abs(scene.done.thermo(column)[-1] / exact - 1), 1e-6)
        report.below(f"{what}: time covered",
                     abs(scene.done.thermo("f_heat[7]")[-1] / (0.1 * scale) - 1), 1e-12)


def lumps(report):
    """Strips so thin and conductive that their temperature is uniform."""
    n, time = 8, 0.6
    words = "conductivity * 1e4 specific/heat * 1.0"
    cloud = slab(n)
    for h, strength, what in ((0.5, 0.0, "convection"), (0.0, 0.02, "radiation")):
        condition = f"convection {h} 0.2" if h else f"radiation {strength} 1.0 zero -2.0"
        steps = [20, 40]
        errors = []
        for count in steps:
            scene = Heated(cloud, words, f"fix b all tmsph/heat/boundary {condition}", start=3.0)
            T = scene.run_to(time, count)
            if h:
                exact = 0.2 + 2.8 * np.exp(-2 * h * time)
            else:
                # absolute temperature y from 5 in surroundings at 3: y' = -2 strength (y^4 - 3^4)
                f = lambda y: (np.log((y + 3) / (y - 3)) + 2 * np.arctan(y / 3)) / (4 * 27)
                exact = bisect(lambda y: f(y) - f(5.0) - 2 * strength * time, 3 + 1e-9, 5.0) - 2.0
            errors.append(np.abs(T - exact).max())
        report.note(f"{what}: errors with {steps} steps", listed(errors))
        # the film coefficient of radiation is that at the start of each step: first order in time
        report.below(f"{what}: error", errors[-1], 1e-3 if h else 5e-3)
        if not h:
            report.above(f"{what}: order in time", order(errors)[0], 0.9)


def tables(report):
    """Steady flux through a slab whose conductivity is 1 + T, 0 and 1 at its ends: Kirchhoff's
    transformation gives flux 3/2 and T + T^2/2 = 3/2 x. And heating of a heat capacity 1 + T."""
    errors = []
    files = {"p.table": "# property of temperature\nk\n0.0 1.0\n0.5 1.5\n1.0 2.0\nother\n0.0 5.0\n"}
    for n in (20, 40):
        cloud = slab(n)
        scene = Heated(cloud, "conductivity * table p.table k specific/heat * 1.0",
                       SIDES + "fix a left tmsph/heat/boundary temperature 0.0\n"
                       "fix b right tmsph/heat/boundary temperature 1.0", start=0.5)
        scene.files.update(files)
        T = scene.run_to(3.0, 60, columns="step f_b[1]")
        exact = np.sqrt(1 + 3 * cloud.X[:, 0]) - 1
        errors.append(max(rms(T - exact),
                          abs(scene.done.thermo("f_b[1]")[-1] / cloud.box[1][1] - 1.5)))
    report.note("conductivity from a table: errors", listed(errors))
    report.below("conductivity from a table: error at 40", errors[1], 1e-3)
    report.above("conductivity from a table: order", order(errors)[0], 1.9)

    cloud = block()
    scene = Heated(cloud, "conductivity * 1.0 specific/heat * table p.table k source * 1.2")
    scene.files.update(files)
    T = scene.run_to(1.0, 4, columns="step f_heat")
    # enthalpy T + T^2/2 = 1.2: inside the table
    report.below("specific heat from a table: temperature", np.abs(T - (np.sqrt(3.4) - 1)).max(),
                 1e-12)


def without_heat(report):
    """Nothing that heat needs is there, and with heat at rest the mechanics are the same."""
    cloud = block("hex", 8, 1e-3)
    state, ends = "x y vx vy fx fy", []
    for words in ("", "fix heat all tmsph/heat conductivity * 1 specific/heat * 1\n"):
        scene = Scene(cloud, [material()])
        scene.add(f"fix move all nve\n{words}velocity all ramp vx 0 1e-3 x 0 0.01\ntimestep 1e-8\n"
                  "run 20\ninfo fixes\nwrite_restart end.restart")
        ends.append(scene.snapshot("end", state).run(keep="*.restart"))
    fixes = [re.findall(r"^Fix\[.*style = +(\S+?),", end.log, re.M) for end in ends]
    report.true("without heat: no fix of it", not any("heat" in f or "STORE" in f for f in fixes[0])
                and any("tmsph/heat" in f for f in fixes[1]), f"{fixes}")
    report.true("without heat: no word of it", "heat" not in ends[0].log.split("run 20")[0], "")
    report.above("without heat: bytes less in a restart",
                 len(ends[1].kept["end.restart"]) - len(ends[0].kept["end.restart"]), 1)
    report.true("heat at rest: mechanics the same to the last bit",
                np.array_equal(ends[0].frame("end")(state), ends[1].frame("end")(state)), state)


if __name__ == "__main__":
    main(sources, steps_in_time, lumps, tables, without_heat)
