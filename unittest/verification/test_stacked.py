# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Two blocks on top of each other in a box with smooth walls, pressed by 4 %: equal and
different spacings, equal and 10:1 stiffness, contact as it is and 1000 times stiffer. The
force is that of St Venant-Kirchhoff material in oedometric compression, both blocks under
the same force. A contact 1000 times stiffer is to be stable; its force is too large, since
the contact stands for the cells on both sides of the surface.

Each block has the horizon that fits its spacing."""

from scenes.stacked import Stacked
from tmsph_testing import main


def press(report, low, high, ratio=1.0, stiffness=1.0):
    blocks = Stacked(low, high, ratio, stiffness)
    what = f"{low}/{high}" + (f", stiffness {ratio:g}:1" if ratio != 1 else "") + \
        (f", contact x {stiffness:g}" if stiffness != 1 else "")
    if stiffness == 1:
        report.below(f"{what}: force on the floor against exact",
                     abs(blocks.error), 0.03)
    report.below(f"{what}: force of contact against that on the floor",
                 abs(blocks.imbalance), 1e-3)
    report.below(f"{what}: kinetic over strain energy",
                 blocks.kinetic, 1e-6)
    if stiffness == 1:
        report.below(f"{what}: scatter of pressure between the walls", blocks.scatter, 0.05)


def equal(report):
    press(report, 10, 10)
    press(report, 10, 20)
    press(report, 20, 10)
    press(report, 14, 20)


def unequal(report):
    press(report, 10, 10, ratio=10)
    press(report, 14, 20, ratio=10)


def stiff_contact(report):
    press(report, 10, 10, stiffness=1000)
    press(report, 14, 20, stiffness=1000)


if __name__ == "__main__":
    main(equal, unequal, stiff_contact)
