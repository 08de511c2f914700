# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""examples/slide: a block pressed between plates, then slid over the lower one (Mu et al.
2022, Sect. 5.1). Without friction the compression is uniform, and the St Venant-Kirchhoff
force is exact. While it slides friction is mu times the normal force, and the normal force
at small strain follows from Betti's theorem with the centre of pressure of the run,
F = E' W d/(H - mu nu/(1 - nu) x). Neither depends on the time step. Finer, and by the law of
the paper: test_slide_long.py."""

import numpy as np

from scenes.slide import PUSH, Slide, compressed
from tmsph_testing import main


def without_friction(report):
    for n in (10, 20):
        compressed(report, n)
    slide = Slide(n=10, mu=0, end=1.05, push=PUSH / 10)
    report.below("the same at a tenth of the way, n = 10", abs(slide.pressed / slide.exact() - 1),
                 5e-3)


def sliding(report):
    steps = [Slide(cfl=cfl) for cfl in (1.1, 0.55, 0.275)]
    report.below("friction / (mu normal force) - 1 while it slides", steps[0].ratio(), 1e-3)
    report.below("scatter of friction, with viscosity", steps[0].noise(), 1e-3)
    plain = Slide(visc=0)
    report.below("friction / (mu normal force) - 1 without viscosity", plain.ratio(), 1e-3)
    report.below("scatter of friction, without viscosity", plain.noise(), 1e-2)
    for what, force in (("normal force before sliding", [s.pressed for s in steps]),
                        ("normal force while sliding", [s.normal[s.slides].mean() for s in steps]),
                        ("friction", [s.friction[s.slides].mean() for s in steps])):
        report.below(f"{what} at .98, .49 and .25 of the stable step: largest change",
                     np.ptp(force) / force[0], 5e-3)


def betti(report):
    for n in (10, 20):
        slide = Slide(n=n, push=PUSH / 800)
        report.below(f"normal force against Betti's, n = {n}", abs(slide.betti() - 1), 0.01)


if __name__ == "__main__":
    main(without_friction, sliding, betti)
