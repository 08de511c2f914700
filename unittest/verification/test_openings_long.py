# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Energies of cracks as in test_openings.py on more lattices and at other spacings."""

from test_openings import ENERGY, NOTCH, Strip, TENSILE, WIDTH, YOUNG, energies
from tmsph_testing import main


def lattices(report):
    energies(report, (("square", 15), ("square", 30), ("square", 45), ("hex", 0), ("hex", 30)))


def spacings(report):
    """The energy of the crack at spacings from .18 of the characteristic length on; where the start
    warns, beyond 0.3, it may be any."""
    area = WIDTH - NOTCH
    for spacing in (1e-3, 2e-3, 3e-3):
        strip = Strip("square", 0, spacing)
        run = strip.scene().add(f"run {strip.steps}").run()
        took, gained, lost = (run.thermo(f"f_break[{k}]")[-1] for k in (6, 8, 9))
        ratio = spacing * TENSILE**2 / (YOUNG * ENERGY)
        what, energy = f"{ratio:.2f} of the length", (took + lost) / (ENERGY * area)
        if ratio <= 0.3:
            report.within(f"{what}: energy of the crack/(G area)", energy, 0.95, 1.05)
        else:
            report.note(f"{what}: energy of the crack/(G area)", f"{energy:.3f}")
            report.within(f"{what}: warned", float("of the characteristic length" in run.log), 1, 1)
        report.below(f"{what}: gained by updates/dissipated", gained / took, 1e-4)


if __name__ == "__main__":
    main(lattices, spacings)
