# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Mistakes of newcomers in inputs that LAMMPS can read: each gets one line, an error or a warning,
that names the mistake and its remedy, and with that remedy the line is gone. Wrong grammar is in
test_bad_inputs.py."""

from tmsph_testing import main
from wrong_inputs import ROCK, complaints, cube, plate, script, tells

# A plate of two rocks that is heated evenly and may break; with nothing to complain about

PLATE = plate(
    15, 9, 7.5,
    skin="neighbor 1e-3 bin",
    pair="pair_style tmsph 3.015e-3 viscosity 1 2",
    coeff=ROCK,
    **{"break": "fix rock all tmsph/hoekbrown strength * 150e6 mi * 8"},
    heat="variable T equal 0.02*step\nfix heat all tmsph/heat/boundary temperature v_T",
    fix="fix move all nve",
    dt="timestep 5e-8",
    more="",
    run="run 10",
    after="")
CUBE = cube(PLATE)
ELASTIC = dict(PLATE, heat="", **{"break": ""})
CONDUCTS = "fix conduct all tmsph/heat conductivity * 2.9 specific/heat * 850 "
KELVIN = dict(PLATE, coeff=PLATE["coeff"] + " reference 293", heat="set group all temperature 20")
FLOW = CONDUCTS + "time/scale 1e5\nfix heat all tmsph/heat/boundary flux 1"
TWO = dict(PLATE, coeff=PLATE["coeff"] + "\npair_coeff 1 2 none")
GAP = "\nregion gap block 7.5e-3 8.5e-3 INF INF INF INF units box\ndelete_atoms region gap"
# torn so slowly that it does not start hot, yet far enough for some bonds to break
BROKEN = dict(PLATE, heat="", run="velocity all ramp vx -12 12 x 0 15e-3 units box\nrun 100")
RESTART = "write_restart r\nclear\nread_restart r\n"
MINIMIZE = "minimize 0 1e-2 500 5000\n"
PERIODIC = "units si\ndimension 2\nboundary p p p"


def replaced(section, old, new, scene=PLATE):
    """A section with a word of it replaced."""
    assert old in scene[section], (section, old)
    return {section: scene[section].replace(old, new)}


# Name, scene, sections with the mistake, sections with the remedy on top of those, what the line
# says: words in their order, "|" between them

MISTAKES = [
    # units
    ("Young's modulus in GPa", PLATE, replaced("coeff", "40e9", "40"), PLATE,
     "No solid has waves of|type 1|Young's modulus, 40, in Pa"),
    ("Young's modulus in MPa", PLATE, replaced("coeff", "40e9", "40e3"), PLATE,
     "No solid has waves of|Young's modulus, 40000, in Pa"),
    ("modulus in GPa and strength in MPa", PLATE,
     dict(replaced("coeff", "40e9", "40"), **replaced("break", "150e6", "150")), PLATE,
     "No solid has waves of|Young's modulus, 40, in Pa"),
    ("density in g/cm3", PLATE, replaced("coeff", "2700", "2.7"), PLATE,
     "No solid has waves of|density, 2.7, in kg/m3"),
    ("expansion in 1e-6", PLATE, replaced("coeff", "1e-5", "10"), PLATE,
     "expands by 10 per degree|type 1|1e-5 for rock"),
    ("strength in MPa", PLATE, replaced("break", "150e6", "150"), PLATE,
     "Strength 150 of type 1|Young's modulus|give both in Pa"),
    ("strength in the place of the modulus", PLATE, replaced("break", "150e6", "40e9"), PLATE,
     "Strength 40000000000 of type 1|give both in Pa|a 25th of the modulus"),
    ("strength in kPa, 3-D", CUBE, replaced("break", "150e6", "15e3"), CUBE,
     "Strength 15000 of type 1|give both in Pa"),
    ("horizon in spacings", PLATE, replaced("pair", "3.015e-3", "3.015"), PLATE,
     "horizon 3.015|particle spacings|as a length"),
    ("horizon in mm, 3-D", CUBE, replaced("pair", "3.015e-3", "3.015"), CUBE,
     "horizon 3.015|particle spacings|as a length"),
    # discretization
    ("horizon of 1.2 spacings", PLATE, replaced("pair", "3.015e-3", "1.2e-3"), PLATE,
     "horizon 0.0012 of type 1|1.2 spacings|give 3.015 of them, 0.003015"),
    ("horizon of 1.8 spacings, 3-D", CUBE, replaced("pair", "3.015e-3", "1.8e-3"), CUBE,
     "horizon 0.0018 of type 1|1.8 spacings|give 3.015 of them, 0.003015"),
    ("horizon of 9 spacings", PLATE, replaced("pair", "3.015e-3", "9e-3"), PLATE,
     "horizon 0.009 of type 1|9 spacings|give 3.015 of them, 0.003015"),
    ("no volume", PLATE, dict(volume=""), PLATE, "volume 0|set group all volume"),
    ("volume in mm2", PLATE, dict(volume="set group all volume 1"), PLATE,
     "body 1e+06 thick|area times thickness|give 1e-06"),
    ("edge in the place of the volume", PLATE, dict(volume="set group all volume 1e-3"),
     PLATE, "thick|area times thickness|give 1e-06"),
    ("area in the place of the volume, 3-D", CUBE, dict(volume="set group all volume 1e-6"), CUBE,
     "times the cube of the spacing|about 1e-09|set type 1 volume"),
    ("density in the place of the mass", PLATE, dict(more="set group all mass 2700"),
     dict(more=""), "mass 2700|density 2700|leave the mass out"),
    ("a body one particle thick",
     dict(PLATE, space=PLATE["space"].replace("boundary s s", "boundary f f"), dt="timestep 2e-8"),
     dict(atoms="region row block INF INF 4e-3 4e-3 INF INF units box\ncreate_atoms 1 region row"),
     PLATE, "neighbors on one line|2 particles thick"),
    ("a row of particles that is straight but for round-off",
     dict(PLATE, space=PLATE["space"].replace("boundary s s", "boundary f f"), dt="timestep 2e-8"),
     dict(atoms="region row block INF INF 4e-3 4e-3 INF INF units box\ncreate_atoms 1 region row\n"
                "displace_atoms all random 0 1e-15 0 4711 units box"),
     PLATE, "neighbors on one line|2 particles thick"),
    ("far from the origin", PLATE, dict(more="displace_atoms all move 1e7 0 0 units box"),
     dict(more=""), "Positions of 1e+07|of the spacing|near the origin"),
    ("far from the origin, 3-D", CUBE, dict(more="displace_atoms all move 0 0 -1e7 units box"),
     dict(more=""), "Positions of 1e+07|of the spacing|near the origin"),
    ("periodic box shorter than two horizons", dict(PLATE, space=PERIODIC),
     replaced("box", "0 9e-3", "0 5e-3"), PLATE, "length 0.005 in y|two horizons|enlarge"),
    ("a thin direction that is not periodic in 2-D", PLATE,
     dict(space="units si\ndimension 2\nboundary s s s"), PLATE, "2d simulation|Z"),
    ("skin of LAMMPS's default with fine particles", PLATE,
     dict(skin="neighbor 5e-3 bin"), dict(skin="neighbor 9e-4 bin"),
     "skin 0.005|longer than the horizon|neighbor 0.0009 bin"),
    # steps
    ("time step too long", PLATE, dict(dt="timestep 1e-6"), dict(dt="timestep 1e-07"),
     "time step 1e-06|above the stable one|set 'timestep 1e-07'"),
    ("time step too long for breaking", PLATE, dict(dt="timestep 2e-7"), dict(dt="timestep 9e-8"),
     "time step 2e-07|as bonds break|below"),
    ("nothing moves", PLATE, {"fix": ""}, PLATE, "No fixes with time integration"),
    ("nothing damps", PLATE, replaced("pair", "viscosity 1 2", ""), PLATE,
     "without artificial viscosity|viscosity 1 2"),
    ("hot start, reference in K and temperatures in C", KELVIN, {},
     dict(coeff=KELVIN["coeff"].replace("293", "20")),
     "break on the first step|'reference' temperature|minimize"),
    ("hot start without equilibrium", KELVIN, {}, dict(run=MINIMIZE + "run 10"),
     "break on the first step|'reference' temperature|minimize"),
    ("minimize by conjugate gradients of the default",
     dict(ELASTIC, heat="set group all temperature 100", run="min_style cg\n" + MINIMIZE), {},
     dict(run=MINIMIZE), "turned inside out|min_style cg|min_style tmsph/lbfgs"),
    ("minimize by steepest descent",
     dict(ELASTIC, heat="set group all temperature 100",
          run="min_style sd\nmin_modify dmax 1e-5\n" + MINIMIZE), {}, dict(run=MINIMIZE),
     "Min_style sd ended|above the tolerance|min_style tmsph/lbfgs"),
    # heat
    ("heat without time/scale",
     dict(PLATE, heat=CONDUCTS + "\nfix heat all tmsph/heat/boundary temperature 20"), {},
     dict(heat=CONDUCTS + "time/scale 5e5\nfix heat all tmsph/heat/boundary temperature 0.1"),
     "Heat is hardly conducted|time/scale' of 3e+04"),
    ("time/scale too large",
     dict(PLATE, heat=CONDUCTS + "time/scale 1e13\nfix heat all tmsph/heat/boundary flux 1"), {},
     dict(heat=FLOW), "Heat crosses the body|inertia matters|keep it below"),
    ("specific heat in kJ", dict(PLATE, heat=FLOW), dict(heat=FLOW.replace("850", "0.85")),
     dict(heat=FLOW), "Hardly a solid has a thermal diffusivity|type 1|specific/heat|J/kg/K"),
    ("conductivity in mW", dict(PLATE, heat=FLOW), dict(heat=FLOW.replace("2.9", "2900")),
     dict(heat=FLOW), "Hardly a solid has a thermal diffusivity|type 1|conductivity|W/m/K"),
    ("temperature of a part without conduction", PLATE,
     dict(heat="group hot region right\nfix heat hot tmsph/heat/boundary temperature 1"),
     dict(heat="group hot region right\nfix heat hot tmsph/heat/boundary temperature 1\n"
               + CONDUCTS + "time/scale 1e5"), "Only group hot|heated|add a fix tmsph/heat"),
    ("flux without conduction", PLATE, dict(heat="fix heat all tmsph/heat/boundary flux 1"),
     dict(heat=FLOW), "conducts heat|add a fix tmsph/heat"),
    ("expansion forgotten", PLATE, replaced("coeff", " expansion 1e-5", ""), PLATE,
     "Temperatures load nothing|expansion alpha"),
    # groups and order
    ("group of a region in lattice units", PLATE,
     dict(more="region end block 14 INF INF INF INF INF units box\ngroup end region end\n"
               "fix hold end setforce 0 0 0"),
     dict(more="region end block 14 INF INF INF INF INF units lattice\ngroup end region end\n"
               "fix hold end setforce 0 0 0"), "Group end of fix hold is empty|region"),
    ("group before the particles", PLATE,
     dict(style="atom_style tmsph",
          box=PLATE["box"] + "\nregion end block 13.5e-3 INF INF INF INF INF "
          "units box\ngroup end region end", more="fix hold end setforce 0 0 0"),
     dict(box=PLATE["box"] + "\nregion end block 13.5e-3 INF INF INF INF INF units box",
          more="group end region end\nfix hold end setforce 0 0 0"),
     "Group end of fix hold is empty|particles were there before"),
    ("compute before the first run", PLATE,
     dict(more="compute c all tmsph/crack\nprint $(c_c[1])"),
     dict(more="compute c all tmsph/crack\nrun 0\nprint $(c_c[1])"),
     "before initialization by a run"),
    ("velocities before the masses", PLATE, dict(more="velocity all create 300 4711"),
     dict(more="run 0\nvelocity all create 1e14 4711"), "velocity|run 0"),
    ("a second pair style in the place of the first", PLATE,
     dict(more="pair_style zero 3e-3\npair_coeff * *"), dict(more=""),
     "tmsph/hoekbrown needs pair style tmsph"),
    ("a type without a material", PLATE, replaced("coeff", "* *", "1 1"),
     dict(coeff=PLATE["coeff"].replace("* *", "1 1") + "\n" + PLATE["coeff"].replace("* *", "2 2")),
     "pair coeffs|not set"),
    ("atom style of another kind", ELASTIC, dict(style="atom_style sphere", volume=""), PLATE,
     "Pair style tmsph needs 'atom_style tmsph'|sphere"),
    ("restart without the fix that breaks", BROKEN, dict(after=RESTART + "fix move all nve\nrun 1"),
     dict(after=RESTART + PLATE["break"] + "\nfix move all nve\nrun 1"),
     "broken before|tmsph/hoekbrown again|read_restart"),
    # walls, cuts, contact
    ("wall through the body", PLATE, dict(more="fix wall all tmsph/wall line -9e-3 4e-3 1 4e-3"),
     dict(more="fix wall all tmsph/wall line -9e-3 -0.5e-3 1 -0.5e-3"),
     "Wall wall stands|in the body|bonds|half a cell"),
    ("wall through the body, 3-D", CUBE,
     dict(more="fix wall all tmsph/wall plane 0 0 2.2e-3 0 0 1"),
     dict(more="fix wall all tmsph/wall plane 0 0 -0.5e-3 0 0 1"),
     "Wall wall stands|in the body|bonds|half a cell"),
    ("wall on its wrong side", PLATE,
     dict(more="fix wall all tmsph/wall line 1 -0.5e-3 -9e-3 -0.5e-3"),
     dict(more="fix wall all tmsph/wall line -9e-3 -0.5e-3 1 -0.5e-3"),
     "Wall wall|behind it|swap its ends"),
    ("wall on its wrong side, 3-D", CUBE,
     dict(more="fix wall all tmsph/wall plane 0 0 -9e-3 0 0 -1"),
     dict(more="fix wall all tmsph/wall plane 0 0 -9e-3 0 0 1"),
     "Wall wall|behind it|turn its normal"),
    ("wall through the outer centres", PLATE, dict(more="fix wall all tmsph/wall line -9e-3 0 1 0"),
     dict(more="fix wall all tmsph/wall line -9e-3 -0.5e-3 1 -0.5e-3"),
     "overlap wall wall|by up to 0.0005|half a cell"),
    ("wall for an empty group", PLATE,
     dict(more="group none empty\nfix wall none tmsph/wall line -9e-3 -0.5e-3 1 -0.5e-3"),
     dict(more="fix wall all tmsph/wall line -9e-3 -0.5e-3 1 -0.5e-3"),
     "Group none of fix wall is empty"),
    ("a plane as a wall in 2-D", PLATE,
     dict(more="fix wall all tmsph/wall plane 0 -0.5e-3 0 0 1 0"),
     dict(more="fix wall all tmsph/wall line -9e-3 -0.5e-3 1 -0.5e-3"),
     "plane|2-D|line, polyline or arc"),
    ("contact defined after the first run", TWO, dict(more="run 0\nfix touch all tmsph/contact"),
     dict(more="fix touch all tmsph/contact\nrun 0"),
     "defined after the first run|define it before"),
    ("bodies that do not quite touch", dict(TWO, more="fix touch all tmsph/contact"),
     dict(atoms=TWO["atoms"] + GAP), TWO, "spacings apart|let them touch"),
    ("cut beside the body", PLATE,
     dict(more="fix touch all tmsph/contact\ntmsph/cut all line 3 3 5 5"),
     dict(more="fix touch all tmsph/contact\ntmsph/cut all line 3e-3 3.3e-3 5e-3 5.4e-3"),
     "cut crosses no intact bond"),
    ("cut whose faces pass through each other", ELASTIC,
     dict(more="tmsph/cut all line 3e-3 3.3e-3 5e-3 5.4e-3"),
     dict(more="fix touch all tmsph/contact\ntmsph/cut all line 3e-3 3.3e-3 5e-3 5.4e-3"),
     "faces of cuts|add a fix tmsph/contact"),
]


# those that are found by looking at all particles

ON_THREE = ["horizon in spacings", "horizon of 1.2 spacings",
            "area in the place of the volume, 3-D",
            "far from the origin", "hot start without equilibrium", "wall through the body",
            "wall on its wrong side", "group before the particles"]


def check(report, name, scene, wrong, remedy, words, ranks=1):
    sections = dict(scene, **wrong)
    run = script(sections).run(ranks, may_fail=True, timeout=60)
    said = complaints(run)
    ended = run.status is not None and 0 <= run.status < 128
    good = ended and tells(said, words)
    report.true(name, good,
                said[0].partition(" (src/")[0] if good else f"{said}, status {run.status}")
    if ranks > 1:
        return
    mended = script(dict(sections, **remedy)).run(may_fail=True, timeout=60)
    report.true("  and its remedy", mended.status == 0 and not complaints(mended),
                complaints(mended) or "nothing is said")


def unchanged(report):
    for scene in (PLATE, CUBE):
        run = script(scene).run()
        report.true("the scenes work unchanged", not complaints(run),
                    complaints(run) or "nothing is said")


def mistaken(report):
    for mistake in MISTAKES:
        check(report, *mistake)


def on_three(report):
    for name, *mistake in MISTAKES:
        if name in ON_THREE:
            check(report, name + ", 3 processes", *mistake, ranks=3)


if __name__ == "__main__":
    main(unchanged, mistaken, on_three)
