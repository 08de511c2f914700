# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A heated inclusion that is not bonded to its disc, without friction, at 1 mm: the sum of the
contact forces and the pressure in the core against exact ones."""

from scenes.contact_disc import ContactDisc
from tmsph_testing import main


def inclusion(report):
    disc = ContactDisc()
    report.below("kinetic/potential energy", disc.kinetic, 1e-6)
    report.within("sum of the contact forces/exact", disc.force, 0.99, 1.01)
    report.within("pressure in the core/exact", disc.core, 0.975, 1.025)
    for net, name in zip(disc.net, "xy"):
        report.below(f"net force along {name}/sum of forces", net, 1e-6)
    report.note("L2 error of the stresses/p", f"{disc.error:.4f}")


if __name__ == "__main__":
    main(inclusion)
