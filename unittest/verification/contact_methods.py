# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Contact by pairs of particles and by segments beside each other, in the scenes of test_stacked,
test_contact_disc and test_collision. A study, without bars; some minutes:
    TMSPH_LMP=$(./tmsph where) /usr/bin/python3 unittest/verification/contact_methods.py"""

import numpy as np

from scenes.contact_disc import ContactDisc
from scenes.stacked import Stacked
from test_collision import Pair

METHODS = "kernel", "segment"


def row(what, figures):
    """figures: of a method."""
    print(f"| {what} | " + " | ".join(figures(method) for method in METHODS) + " |", flush=True)


def blocks():
    sizes = (10, 10), (10, 20), (14, 20)
    all_blocks = {method: [Stacked(*size, words=f"method {method}", every=10) for size in sizes]
                  for method in METHODS}
    for what, figure in (
            ("force against exact", lambda b: b.error),
            ("scatter of the pressure of particles", lambda b: b.scatter),
            ("change of the force in the last 100 steps", lambda b: np.ptp(b.contact[-10:])
             / b.contact[-1])):
        row(f"stacked blocks {', '.join(f'{i}/{k}' for i, k in sizes)}: {what}, %",
            lambda method: ", ".join(f"{100 * figure(b):.2g}" for b in all_blocks[method]))


def inclusion(method):
    disc = ContactDisc(f"method {method}")
    return f"{disc.force:.3f}, {disc.core:.3f}"


def energies(method):
    """Of bodies that have slipped past each other freely, nothing touching any more."""
    after = []
    for speed in (0.5, 1.0, 2.0, 4.0):
        for courant in (0.3, 0.15, 0.075):
            pair = Pair(2, method, friction=0.0, speed=speed, courant=courant)
            run = pair.ending(pair.start(), [pair.steps]).run()
            assert run.thermo("f_touch[8]")[-1] == 0
            energy = run.thermo("TotEng")
            after.append(energy[-1] / energy[0])
    return ", ".join(f"{x:.4f}" for x in after)


if __name__ == "__main__":
    blocks()
    row("unbonded inclusion: sum of contact forces, pressure in the core/exact", inclusion)
    row("oblique impact without friction or viscosity, 0.5, 1, 2, 4 m/s, time steps 0.3, 0.15, "
        "0.075: energy after it/before", energies)
