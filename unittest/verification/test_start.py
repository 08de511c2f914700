# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What a run tells at its start: tables that a program can read, with the right numbers, and not
again when nothing has changed."""

import re

import numpy as np

from tmsph_testing import Scene, Script, lattice, main, material

HORIZON = 3.015
SPACING = 1e-3


def tables(log):
    """The tables of a log: one dictionary of columns each, by headings without their units."""
    found, names = [], None
    for line in log.splitlines():
        words = line.split()
        if words[:1] == ["type"] and line.startswith("  "):
            names, rows = [word.partition("(")[0] for word in words], []
            found.append((names, rows))
        elif names and line.startswith("  ") and len(words) == len(names):
            rows.append([float(word) if word != "-" else np.nan for word in words])
        else:
            names = None
    return [dict(zip(names, np.transpose(rows))) for names, rows in found]


def block(dimension, pair=""):
    name, cells = ("square", [20, 12]) if dimension == 2 else ("sc", [8, 6, 6])
    cloud = lattice(name, cells, SPACING)
    cloud.type[cloud.X[:, 0] > 0.5 * cells[0] * SPACING] = 2
    rocks = [material(40e9, 0.3, 2700, 1e-5), material(20e9, 0.2, 2500, 1e-5)]
    return Scene(cloud, rocks, pair + " viscosity 1 2").add(
        "fix rock all tmsph/hoekbrown strength 1 150e6 strength 2 90e6 mi * 8\n"
        "fix conduct all tmsph/heat conductivity 1 2.9 conductivity 2 2 specific/heat * 850 "
        "time/scale 1e5\n"
        "fix move all nve\ntimestep 5e-8")


def numbers(report, dimension, pair=""):
    name = f"{dimension}-D{pair}"
    run = block(dimension, pair).add("run 2\nrun 2").run()
    found, blocks = tables(run.log), re.findall(r"^TMSPH \S+: \d+ bonds, ", run.log, re.M)
    report.true(f"{name}: three tables, once", len(found) == 3 and len(blocks) == 1,
                f"{len(found)} tables")
    rocks, strengths, heat = found
    E, nu, rho = np.array([40e9, 20e9]), np.array([0.3, 0.2]), np.array([2700.0, 2500.0])
    close = lambda a, b: np.allclose(a, b, rtol=6e-4)    # four digits are told
    speed = np.sqrt(E * (1 - nu) / ((1 + nu) * (1 - 2 * nu)) / rho)
    report.true("  particles, spacing, horizon",
                sum(rocks["particles"]) == (240 if dimension == 2 else 288)
                and close(rocks["spacing"], SPACING) and close(rocks["horizon/spacing"], HORIZON),
                "right")
    report.true("  constants and speed of waves", close(rocks["E"], E) and close(rocks["nu"], nu)
                and close(rocks["density"], rho) and close(rocks["wave_speed"], speed),
                ", ".join(f"{v:.1f}" for v in rocks["wave_speed"]))
    ucs = np.array([150e6, 90e6])
    tensile = ucs * (np.sqrt(8**2 + 4) - 8) / 2    # sigma = ucs sqrt(1 - m sigma/ucs)
    energy = 15 * tensile**2 * SPACING / (2 * E)
    report.true("  strengths", close(strengths["UCS"], ucs) and close(strengths["tensile"], tensile)
                and close(strengths["UCS/E"], ucs / E),
                ", ".join(f"{v:.4g}" for v in strengths["tensile"]))
    report.true("  energy of cracks, toughness", close(strengths["crack_energy"], energy)
                and close(strengths["toughness"], np.sqrt(E * energy)),
                ", ".join(f"{v:.4g}" for v in strengths["crack_energy"]))
    report.true("  diffusivity", close(heat["diffusivity"], np.array([2.9, 2.0]) / (rho * 850)),
                ", ".join(f"{v:.4g}" for v in heat["diffusivity"]))
    size = "thickness(m) 1  area(m2) 0.00024" if dimension == 2 else "volume(m3) 2.88e-07"
    report.true("  size", size in run.log, size)


def again(report):
    changed = block(2).add("run 2\npair_coeff 1 1 elastic 45e9 0.3 density 2700\nrun 2").run()
    found = tables(changed.log)
    report.true("coefficients that change are told again",
                [t["E"][0] for t in found if "E" in t] == [40e9, 45e9], f"{len(found)} tables")
    parallel = block(2).add("run 2").run(3)
    alone = block(2).add("run 2").run()
    report.true("the same on 3 processes", str(tables(parallel.log)) == str(tables(alone.log)),
                "to the digit")


def many_types(report):
    """98 types without particles are one row; 40 that differ are not all shown."""
    cloud = lattice("square", [40, 8], SPACING)
    cloud.type[:] = 1 + np.arange(len(cloud)) % 2
    cloud.type[0] = 100
    scene = Scene(cloud,
                  [material()] * 100).add("fix rock all tmsph/hoekbrown strength * 150e6 mi * 8\n"
                                          "run 0")
    rows = [line.split()[:2]
            for line in scene.run().log.split("type  particles")[1].split("\n")[1:5]]
    report.true("100 types, most without particles",
                rows == [["1", "159"], ["2", "160"], ["3-99", "0"], ["100", "1"]], str(rows))
    cloud.type[:] = 1 + np.arange(len(cloud)) % 40
    log = Scene(cloud, [material(40e9 + 1e8 * k) for k in range(40)]).add("run 0").run().log
    rows = log.split("type  particles")[1].split("\n")
    report.true("40 types that differ", rows[20].split()[0] == "20" and rows[21] == "  and 20 more",
                rows[21])


def thick(report):
    cloud = lattice("hex", [12, 8], SPACING)
    cloud.volume *= 0.02
    run = Scene(cloud, [material()]).add("run 0").run()
    area = cloud.volume.sum() / 0.02
    line = next(line for line in run.log.splitlines() if "thickness(m)" in line).split()
    # the spacing, by which it is found, does not know the lattice: 0.866 of its square is a cell
    report.within("thickness of a plate of 20 mm", float(line[1]) / 0.02, 0.86, 1.0)
    report.within("  thickness times area over volume",
                  float(line[1]) * float(line[3]) / (0.02 * area), 0.999, 1.001)


def other_units(report):
    for style, length, pressure, density, units in [
            ("cgs", 1e2, 10, 1e-3, "spacing(cm) horizon/spacing E(dyn/cm2) nu density(g/cm3) "
                                   "wave_speed(cm/s)"),
            ("micro", 1e6, 1e-3, 1e-3, "spacing(um) horizon/spacing E(pg/um/us2) nu "
                                       "density(pg/um3) wave_speed(um/us)"),
            ("lj", 1e3, 1, 1, "spacing horizon/spacing E nu density wave_speed")]:
        scene = Script(f"units {style}\ndimension 2\nboundary s s p\natom_style tmsph\n"
                       f"neighbor {SPACING * length:.6g} bin")
        scene.add(f"lattice custom {SPACING * length:.6g} a1 1 0 0 a2 0 1 0 a3 0 0 1 basis 0 0 0\n"
                  "region box block 0 9 0 9 -0.5 0.5\ncreate_box 1 box\ncreate_atoms 1 box\n"
                  f"set group all volume {(SPACING * length)**2:.6g}\n"
                  f"pair_style tmsph {HORIZON * SPACING * length:.6g}\n"
                  f"pair_coeff 1 1 elastic {40e9 * pressure:.6g} 0.3 density {2700 * density:.6g}\n"
                  "run 0")
        run = scene.run()
        heading = next(line for line in run.log.splitlines() if line.startswith("  type "))
        speed = tables(run.log)[0]["wave_speed"][0]
        factor = dict(cgs=1e2, micro=1, lj=1)[style]
        report.true(f"units {style}: names, and no warning", " ".join(heading.split()[2:]) == units
                    and "No solid" not in run.log and abs(speed / factor - 4466) < 1, f"{speed:g}")


def what_is_told(report):
    numbers(report, 2)
    numbers(report, 2, " plane stress")
    numbers(report, 3)


if __name__ == "__main__":
    main(what_is_told, again, many_types, thick, other_units)
