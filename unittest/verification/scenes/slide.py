# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""examples/slide: a block pressed between plates, then slid over the lower one (Mu et al.
2022, Sect. 5.1), against the exact St Venant-Kirchhoff force of uniform compression and
Betti's theorem."""

from pathlib import Path

import numpy as np

from tmsph_testing import Script

ROOT = Path(__file__).resolve().parents[3]
EDGE, MODULUS, POISSON, MU = 0.1, 1e7 / (1 - 0.2**2), 0.2, 0.3
PUSH = 8e-3


class Slide:
    inputs = ROOT / "examples" / "slide"

    def __init__(self, ranks=1, **variables):
        text = (self.inputs / "in.slide").read_text()
        head = "\n".join(f"variable {name} index {value}" for name, value in variables.items())
        self.push = float(variables.get("push", PUSH))
        run = Script(head + "\ninclude in.slide", {"in.slide": text}).run(ranks)
        self.cost = run.cost
        self.time, self.friction = run.thermo("time_s"), run.thermo("below_x_N")
        self.normal, self.torque = -run.thermo("below_y_N"), run.thermo("torque_Nm")
        self.pressed = self.normal[np.argmin(abs(self.time - 1.04))]
        self.slides = self.time > 1.7    # more than 2 mm after all particles have begun to

    def exact(self):
        stretch = 1 - self.push / EDGE
        return MODULUS * EDGE * stretch * (1 - stretch**2) / 2

    def noise(self):
        f = self.friction[self.slides]
        return f.std() / f.mean()

    def ratio(self):
        return abs(self.friction[self.slides] / self.normal[self.slides] - MU).max() / MU

    def betti(self):
        normal = self.normal[self.slides].mean()
        centre = -self.torque[self.slides].mean() / normal
        height = EDGE - MU * POISSON / (1 - POISSON) * centre
        return normal / (MODULUS * EDGE * self.push / height)


def compressed(report, n):
    """By plates without friction; the error of so many particles along an edge is of first
    order."""
    slide = Slide(n=n, mu=0, end=1.05)
    report.below(f"force of frictionless compression against exact, n = {n}",
                 abs(slide.pressed / slide.exact() - 1), 0.2 / n)
