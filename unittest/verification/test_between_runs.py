# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""What an input may do between two runs, and in which order it may define things."""

from tmsph_testing import *

SPACING = 1e-3
REST = "velocity all set 0 0 0"


def blocks(gap):
    """A block on another one that is wider, so many spacings above it; steps of 10 ns."""
    low = lattice("square", (10, 6), SPACING)
    high = lattice("square", (6, 4), SPACING)
    cloud = Cloud(np.concatenate([low.X, high.X + SPACING * np.array([2.0, 6.0 + gap])]),
                  SPACING**2, SPACING)
    cloud.type[len(low):] = 2
    scene = Scene(cloud, [material()] * 2, pair="viscosity 1 2")
    scene.add("pair_coeff 1 2 none\ngroup low type 1\ngroup high type 2\nfix 1 all nve\n"
              "timestep 1e-8")
    return scene


def forget_contact(report):
    """A compute after the contact is gone has the stress by bonds alone, as in a run of no steps."""
    scene = blocks(0.0).add("fix touch all tmsph/contact\ncompute p all tmsph/property/atom syy\n"
                            "compute most all reduce max c_p")
    scene.thermo("step").add("run 0\ndisplace_atoms high move 0 -1e-5 0 units box\nrun 20")
    scene.add("unfix touch\nvariable now equal $(c_most)\n"
              "thermo_style custom step c_most v_now\nrun 0")
    last = scene.run()
    report.true("stress after unfix tmsph/contact", last.thermo("c_most")[-1] == last.thermo("v_now")[-1]
                and last.thermo("c_most")[-1] != 0.0, "that of the bonds")


report = Report()
forget_contact(report)
report.finish()
