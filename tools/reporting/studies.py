# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What the report measures: scenes with exact solutions, each at several resolutions and with
several choices of method. A scene is a class of unittest/verification/scenes; what it is
made with has .cost afterwards and the errors that the study names."""

from dataclasses import dataclass, field
from importlib.util import find_spec

from scenes.beam import Beam
from scenes.clamped import Wavy
from scenes.disc import Disc
from scenes.dynamics import Spinning
from scenes.expansion import Expansion
from scenes.hoekbrown import Loading
from scenes.patch import Patch
from scenes.slide import Slide
from scenes.sphere import Ball
from scenes.stacked import Stacked
from scenes.waves import StandingWave
from tmsph_testing import disc_materials

from .measure import ROOT


@dataclass
class Study:
    name: str
    title: str
    text: str               # what is computed, and against what
    scene: type
    error: object           # of a scene, function
    error_name: str
    common: dict            # parameters of all runs
    sizes: list             # (size h, parameters), coarse to fine; error ~ h^order
    size_name: str
    choices: dict           # parameters by name; the first is the default
    more_sizes: list = field(default_factory=list)     # these with --full only
    more_choices: dict = field(default_factory=dict)
    exact: bool = False     # no error of discretization: no order
    dimension: int = 2
    target: float = 0.01    # error to which the time is given

    @property
    def default(self):
        return next(iter(self.choices))

    def target_text(self):
        return f"{100 * self.target:g} %" if self.target > 1e-4 else f"{self.target:g}"

    def all_sizes(self, full):
        return self.sizes + (self.more_sizes if full else [])

    def all_choices(self, full):
        return {**self.choices, **(self.more_choices if full else {})}


DEFAULT = "default"
# the options that have a default in the package; others belong to the user and the scene
JUDGED = ("kernel", "horizon", "hourglass", "thermal", "viscosity", "law",
          "subcycle")
KERNELS = {"kernel cubic": {"options": "kernel cubic"},
           "kernel quintic": {"options": "kernel quintic"}}
HORIZONS = {"horizon 2.5 dx": {"horizon": 2.515}, "horizon 4 dx": {"horizon": 4.015}}
MORE_HORIZONS = {"horizon 2 dx": {"horizon": 2.015}, "horizon 3.5 dx": {"horizon": 3.515},
                 "horizon 5 dx": {"horizon": 5.015}}
RANKS = {"2 ranks": {"ranks": 2}}
QUASISTATIC = {}
if (ROOT / "src/TMSPH/min_tmsph_lbfgs.h").exists():
    QUASISTATIC["min_style tmsph/lbfgs"] = {"style": "tmsph/lbfgs"}


def hourglass(*values):
    return {f"hourglass {value}": {"options": f"hourglass {value}"} for value in values}


def viscosity(*pairs):
    return {f"viscosity {a} {b}": {"options": f"viscosity {a} {b}"} for a, b in pairs}


def courant(*values):
    return {f"time step {value} dx/c": {"courant": value} for value in values}


def waves():
    text = ("A standing P wave of strain 1e-6 in a periodic block, {}. Error of the phase speed "
            "against that of the continuum. The time step is 0.5 dx/c, c the speed of P waves.")
    common = {"polarization": 0, "every": 2, "courant": 0.5}
    choices = {DEFAULT: {}, **KERNELS, **HORIZONS, **hourglass(0, 0.02, 0.3, 1),
               **viscosity((1, 2)), "time step 0.25 dx/c": {"courant": 0.25, "every": 4},
               "time step 1 dx/c": {"courant": 1.0, "every": 1}, **RANKS}

    def sizes(*numbers):
        return [(1 / n, {"n": n}) for n in numbers]
    long = {key: value for key, value in choices.items() if key not in RANKS}

    def error(wave):
        return abs(wave.speed_error())
    yield Study("wave2d", "P wave, 2-D", text.format("plane strain"), StandingWave, error,
                "error of the wave's speed", {"d": 2, **common}, sizes(8, 16, 32, 64, 128),
                "particles per wave", long, sizes(256), {**MORE_HORIZONS, **RANKS})
    yield Study("wave3d", "P wave, 3-D", text.format("3-D"), StandingWave, error,
                "error of the wave's speed", {"d": 3, **common}, sizes(8, 16, 32, 64),
                "particles per wave", choices, sizes(128), MORE_HORIZONS, dimension=3)
    yield Study("shear3d", "S wave, 3-D", text.format("3-D").replace("P wave of", "S wave of"),
                StandingWave, error, "error of the wave's speed",
                {**common, "d": 3, "polarization": 1}, sizes(8, 16, 32, 64), "particles per wave",
                {DEFAULT: {}, **KERNELS, **HORIZONS, **hourglass(0, 0.3)}, sizes(128),
                MORE_HORIZONS, dimension=3)


def heated():
    loose = {"residual 1e-3": {"residual": 1e-3}}
    common = {"pair": disc_materials(False)}
    text = ("A disc of radius 50 mm whose inclusion of radius 15 mm expands more than the matrix "
            "(Mu et al. 2022, Table 1) is heated, {}. Equilibrium by minimize to a residual of "
            "1e-5 p dx, p the contact pressure. Root mean square error of the radial and hoop "
            "stress over the area, over p, against Lame's solution. Nearly all of it sits within "
            "a horizon of the interface, where the exact stress jumps.")
    choices = {DEFAULT: {}, **KERNELS, **HORIZONS, **hourglass(0.02, 0.3, 1),
               "thermal strain": {"options": "thermal strain"}, **loose, **QUASISTATIC, **RANKS}

    def spacings(*values):
        return [(dx, {"spacing": dx * 1e-3}) for dx in values]

    def error(body):
        return body.error
    yield Study("disc_strain", "Heated disc with inclusion, plane strain",
                text.format("plane strain"), Disc, error, "L2 error of the stress/p",
                {"plane": "strain", **common}, spacings(2.8, 2, 1.4, 1), "spacing, mm", choices,
                spacings(0.7, 0.5), {**MORE_HORIZONS, **hourglass(0.05), "law almansi":
                                     {"options": "law almansi"}}, target=0.03)
    yield Study("disc_stress", "Heated disc with inclusion, plane stress",
                text.format("plane stress"), Disc, lambda disc: disc.far,
                "L2 error of the stress/p, far field", {"plane": "stress", **common},
                spacings(2, 1.4, 1), "spacing, mm",
                {DEFAULT: {}, **KERNELS, **HORIZONS, **hourglass(0.3),
                 "thermal strain": {"options": "thermal strain"}, **loose},
                spacings(0.7, 0.5), MORE_HORIZONS)
    yield Study("sphere", "Heated sphere in a sphere, 3-D",
                "The same materials as a sphere of radius 20 mm in a shell of radius 50 mm. Root "
                "mean square error of the radial and both hoop stresses over the volume, over p.",
                Ball, error, "L2 error of the stress/p", {}, spacings(6.25, 5, 3.57),
                "spacing, mm",
                {DEFAULT: {}, **KERNELS, "horizon 2.5 dx": {"horizon": 2.515}, **hourglass(0.02, 0.3),
                 "thermal strain": {"options": "thermal strain"}, **loose, **QUASISTATIC, **RANKS},
                spacings(2.5), {"horizon 4 dx": {"horizon": 4.015}}, dimension=3, target=0.03)
    text = ("A block, periodic in all directions, is heated by 1 + cos(2 pi x/L), {}. Root mean "
            "square error of the stresses along and across x over the amplitude of the latter.")
    choices = {DEFAULT: {}, **KERNELS, **HORIZONS, **hourglass(0.02, 0.3, 1),
               "thermal strain": {"options": "thermal strain"},
               "residual 1e-3": {"residual": 1e-3}}

    def numbers(*values):
        return [(1 / n, {"n": n}) for n in values]
    yield Study("clamped2d", "Clamped heating that varies, 2-D", text.format("plane stress"), Wavy,
                error, "L2 error of the stress", {"plane": "plane stress"}, numbers(20, 40, 80, 160),
                "particles per wave", choices, numbers(320), MORE_HORIZONS)
    yield Study("clamped3d", "Clamped heating that varies, 3-D", text.format("3-D"), Wavy, error,
                "L2 error of the stress", {"plane": "3-D"}, numbers(10, 20, 40),
                "particles per wave", choices, numbers(80), {}, dimension=3)
    text = ("A free body of two materials that expand alike, its particles displaced at random by "
            "up to 0.2 spacings, is heated by 200 degrees, {}. Largest error of the strain of any "
            "pair of neighbours, over the strain: zero but for the residual at which minimize "
            "stops, given in units of E alpha dT dx^(d-1).")

    def residuals(*values):
        return [(r, {"residual": r}) for r in values]
    for name, plane, d in (("expansion2d", "plane strain", 2), ("expansion3d", "3-D", 3)):
        yield Study(name, f"Free expansion, {d}-D", text.format(plane), Expansion,
                    lambda body: body.strain_error, "error of the strain",
                    {"plane": plane, "jitter": 0.2, "mode": "bond", "size": 4 - d},
                    residuals(1e-2, 1e-4, 1e-6, 1e-8), "residual",
                    {DEFAULT: {}, "regular lattice": {"jitter": 0.0},
                     "thermal strain": {"mode": "strain"}, **hourglass(0.3)}, residuals(1e-10), KERNELS,
                    exact=True, dimension=d, target=1e-6)


def deformed():
    text = ("First bending mode of a free beam ten times as long as high, {}. Error of its period "
            "against Timoshenko's theory, which is itself good to 1e-3.")

    def rows(*values):
        return [(1 / n, {"rows": n}) for n in values]

    def error(body):
        return abs(body.error)
    choices = {DEFAULT: {}, **KERNELS, **HORIZONS, **hourglass(0.02, 0.3, 1), **viscosity((1, 2)),
               **courant(1)}
    yield Study("beam", "Bending beam, plane strain", text.format("plane strain"), Beam, error,
                "error of the period", {"plane": "strain"}, rows(4, 6, 8, 12, 16, 24),
                "rows across the height", choices, rows(32),
                {"horizon 2 dx": {"horizon": 2.015}, "law almansi": {"options": "law almansi"}})
    yield Study("beam_stress", "Bending beam, plane stress", text.format("plane stress"), Beam,
                error, "error of the period", {"plane": "stress"}, rows(4, 6, 8, 12, 16, 24),
                "rows across the height", {DEFAULT: {}, **KERNELS, "horizon 2.5 dx":
                                           {"horizon": 2.515}, **hourglass(0.3)}, rows(32))
    text = ("Affine patch test: the particles inside a rim of two horizons that is held find their "
            "equilibrium. Root mean square error of their displacement, over strain times edge. "
            "On regular lattices zero but for the residual of 1e-8 E strain dx^(d-1); with "
            "positions displaced at random (by up to 0.2 spacings) of first order.")

    def edges(*values):
        return [(1 / n, {"n": n}) for n in values]
    jittered = {"displaced": {"jitter": 0.2},
                "displaced, hourglass 0.3": {"jitter": 0.2, "options": "hourglass 0.3"},
                "displaced, hourglass 1": {"jitter": 0.2, "options": "hourglass 1"},
                "displaced, kernel cubic": {"jitter": 0.2, "options": "kernel cubic"},
                "displaced, kernel quintic": {"jitter": 0.2, "options": "kernel quintic"},
                "displaced, horizon 4 dx": {"jitter": 0.2, "horizon": 4.015}}
    yield Study("patch2d", "Patch test, 2-D", text, Patch, error, "error of the displacement", {},
                edges(20, 40, 80, 160), "particles along the edge",
                {DEFAULT: {"name": "square"}, "hexagonal": {"name": "hex"},
                 **{key: {"name": "square", **value} for key, value in jittered.items()}},
                edges(320), exact=True)
    yield Study("patch3d", "Patch test, 3-D", text, Patch, error, "error of the displacement", {},
                edges(18, 22, 27), "particles along the edge",
                {DEFAULT: {"name": "sc"}, **{key: {"name": "sc", **value}
                                             for key, value in jittered.items()}},
                edges(36, 48), exact=True, dimension=3)
    text = ("A free block that spins and vibrates, {}. Band in which kinetic plus potential energy "
            "stay, over the energy: of second order in the time step, as velocity Verlet makes it.")

    def steps(*values):
        return [(c, {"courant": c, "steps": int(round(2000 / c)), "every": int(round(200 / c))})
                for c in values]
    for d, cells, spin in ((2, (12, 12), (0, 0, 1)), (3, (12, 4, 4), (1, 2, 3))):
        yield Study(f"energy{d}d", f"Energy of a spinning block, {d}-D", text.format(f"{d}-D"),
                    Spinning, lambda body: body.band, "band of the energy",
                    {"name": "square" if d == 2 else "sc", "cells": cells, "spin": spin},
                    steps(0.8, 0.4, 0.2, 0.1), "time step, dx/sqrt(E/rho)",
                    {DEFAULT: {}, **hourglass(0, 0.3), "law almansi": {"options": "law almansi"}},
                    steps(0.05), dimension=d,
                    target=1e-3)


def touching():
    def edges(*values):
        return [(1 / n, {"n": n}) for n in values]
    yield Study("slide", "Block between plates (Mu et al. 2022, Sect. 5.1)",
                "examples/slide: a block is pressed between smooth plates by 8 %. Error of the "
                "force against that of uniform compression of St Venant-Kirchhoff material. The "
                "time step of the default is 0.5 dx/c, its viscosity 1 0.",
                Slide, lambda slide: abs(slide.pressed / slide.exact() - 1), "error of the force",
                {"mu": 0, "end": 1.05}, edges(5, 7, 10, 14), "particles along the edge",
                {DEFAULT: {}, "law penalty": {"law": "penalty"}, "law paper": {"law": "paper"},
                 "no viscosity": {"visc": 0}, "time step 0.25 dx/c": {"cfl": 0.25},
                 "time step 1 dx/c": {"cfl": 1.0}}, edges(20, 28, 40))

    def both(*values):
        return [(1 / n, {"low": n, "high": n}) for n in values]
    yield Study("stacked", "Two stacked blocks in contact",
                "Two equal blocks on top of each other between smooth walls are pressed by 4 %. "
                "Error of the force on the floor. The time step of the default is 0.4 dx/c.",
                Stacked, lambda blocks: abs(blocks.error), "error of the force", {},
                both(7, 10, 14, 20), "particles along the edge",
                {DEFAULT: {}, **KERNELS, "horizon 2.5 dx": {"horizon": 2.515}, **courant(0.2, 0.8),
                 "pressed twice as fast": {"passes": 10}}, both(28, 40),
                {"horizon 4 dx": {"horizon": 4.015}})

    def steps(*values):
        return [(1 / n, {"steps": n}) for n in values]
    text = ("A homogeneous stress is raised past the Hoek-Brown criterion in equal steps. Error of "
            "the load at which the bonds break: half a step. The load factor that fix "
            "tmsph/hoekbrown reports predicts that load from the first step on.")
    for d in (2, 3):
        pressed = (-1,) + (-0.05,) * (d - 1)
        tension = (1,) + (0,) * (d - 1)
        yield Study(f"hoekbrown{d}d", f"Hoek-Brown states, {d}-D", text, Loading,
                    lambda loading: abs(loading.error), "error of the load", {}, steps(8, 16, 32, 64),
                    "steps", {DEFAULT: {"direction": pressed}, "tension": {"direction": tension},
                              "load factor": {"direction": pressed, "factor": True}},
                    steps(128), dimension=d)


def conducting():
    if find_spec("heat_scenes") is None:    # a package without fix tmsph/heat
        return
    from scenes.conduction import ConductingDisc, ConductingSlab
    from scenes.cylinder import HollowCylinder
    text = {"Dirichlet": "A slab, cold at first, both ends suddenly at 1",
            "Neumann": "A slab, insulated on one side, takes unit flux on the other",
            "Robin": "A warm slab, insulated on one side, cools by convection on the other, Biot "
                     "number 2"}
    rest = " ({}). Root mean square error of the temperature against the series solution. The default is " \
           "RKL2, in 100 steps; explicit steps are 0.7 of the stable one. The body is held still."

    def numbers(*values):
        return [(1 / n, {"n": n}) for n in values]
    choices = {DEFAULT: {}, "subcycle explicit": {"words": "subcycle explicit"},
               "25 steps": {"steps": 25}, "400 steps": {"steps": 400}, "hexagonal": {"name": "hex"},
               "displaced": {"jitter": 0.2}}
    for case, start in text.items():
        yield Study(f"slab_{case.lower()}", f"Conducting slab, {case}", start + rest.format("2-D"),
                    ConductingSlab, lambda body: body.error, "L2 error of the temperature",
                    {"case": case}, numbers(10, 20, 40, 80), "particles across", choices,
                    numbers(160))
    yield Study("slab3d", "Conducting slab, Dirichlet, 3-D", text["Dirichlet"] + rest.format("3-D"),
                ConductingSlab, lambda body: body.error, "L2 error of the temperature",
                {"case": "Dirichlet"}, numbers(10, 20, 40), "particles across",
                {DEFAULT: {"name": "sc"},
                 "subcycle explicit": {"name": "sc", "words": "subcycle explicit"}}, numbers(80),
                dimension=3)
    yield Study("cylinder", "Hollow cylinder, hot inside",
                "Radii 1 and 0.5, hot inside and cold outside, plane strain: conduction to the steady "
                "state in 40 steps of RKL2, then equilibrium by minimize. Root mean square error of the radial "
                "and hoop stress further from the surfaces than 15 % of the wall, over the largest hoop "
                "stress, against the closed form. Run time is that of minimize.",
                HollowCylinder, lambda body: body.typical, "L2 error of the stress", {},
                numbers(8, 12, 20, 30), "particles across the wall",
                {DEFAULT: {}, **KERNELS, "square lattice": {"name": "square"}, **RANKS},
                numbers(40))
    rims = {"Dirichlet": "is suddenly at 1", "Robin": "takes heat by convection, Biot number 2"}
    for case in rims:
        yield Study(f"conduction_{case.lower()}", f"Conducting disc, {case}",
                    f"A cold disc whose rim {rims[case]}. Root mean square error of the "
                    "temperature against the Bessel series.",
                    ConductingDisc, lambda body: body.error, "L2 error of the temperature",
                    {"case": case}, numbers(14, 20, 28, 40), "particles along the radius",
                    {DEFAULT: {}, "subcycle explicit": {"words": "subcycle explicit"},
                     "10 steps": {"steps": 10}, "160 steps": {"steps": 160},
                     "square lattice": {"name": "square"}}, numbers(57, 80))


def studies():
    return [*waves(), *heated(), *deformed(), *touching(), *conducting()]
