# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Work that becomes heat. A vibrating block with viscosity: kinetic, elastic energy and heat add up
to what they were, with an error in proportion to the time step, since the law takes the velocity of
half a step before. A block that hits another and slides on it: heat gained is the work of friction,
to the last digits."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material, order

HEAT = "fix heat all tmsph/heat conductivity * 2 specific/heat * 800"


def vibrate(dt):
    """Change of the sum of all energies, and of the kinetic one, over that at the start."""
    cloud = lattice("square", (10, 10), 0.01, centre=True)
    scene = Scene(cloud, [material(1e7, 0.25, 1000.0)], "viscosity 1.0 2.0", temperature=300.0)
    x = cloud.X[:, 0]
    scene.set("vx vy", 5 * np.stack([np.sin(30 * x), np.cos(25 * x + 40 * cloud.X[:, 1])], axis=1))
    scene.add(f"fix move all nve\n{HEAT} viscous yes\ntimestep {dt:.17g}")
    scene.thermo("step ke etotal f_heat", 100000).add(f"run {round(0.01 / dt)}")
    t = scene.run().tables[-1]
    total = t["TotEng"] + t["f_heat"]
    start = t["KinEng"][0]
    return (total[-1] - total[0]) / start, t["KinEng"][-1] / start


def slide(ranks=1):
    """Heat gained over the work of friction."""
    cloud = lattice("square", (16, 12), 0.01, centre=True)
    cloud.type[cloud.X[:, 1] > 0] = 2
    rock = material(1e7, 0.25, 1000.0)
    scene = Scene(cloud, [rock, rock], temperature=20.0)
    scene.add("pair_coeff 1 2 none\ngroup upper type 2\nvelocity upper set 2.0 -2.0 0")
    scene.add("fix move all nve\nfix contact all tmsph/contact friction * * 0.3\n"
              f"{HEAT} friction yes\n"
              "timestep 2e-5")
    scene.thermo("step f_heat f_contact[7]", 300).add("run 300\nrun 1")
    run = scene.run(ranks)
    heat, work = run.thermo("f_heat", 0), run.thermo("f_contact[7]", 0)
    return run.thermo("f_heat")[-1] - heat[0], work[-1]


def of_viscosity(report):
    errors = []
    for dt in (1e-5, 5e-6):
        error, left = vibrate(dt)
        errors.append(error)
        report.below(f"viscosity, time step {dt:g}: change of the total energy/kinetic "
                     "energy at the start",
                     abs(error), 0.01)
        report.below("kinetic energy that is left", left, 0.2)
    report.above("order in the time step", order(errors)[0], 0.8)


def of_friction(report):
    heat, work = slide()
    report.above("work of friction", work, 1.0)
    report.below("heat gained/work of friction - 1", abs(heat / work - 1), 1e-6)


if __name__ == "__main__":
    main(of_viscosity, of_friction)
