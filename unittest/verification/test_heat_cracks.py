# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Layers in series between two temperatures, steady: materials of conductivity 1:10 and 1:1000, an
open crack, which lets nothing through, and a closed one with a film on it, which is a resistance in
series. Two straight lines are exactly steady below a flat interface, but for the depths below it,
which are interpolated in a table of 100 steps. With "all": more resolutions, for the report."""

import numpy as np

from heat_scenes import SIDES, UNIFORM, Heated, listed, slab
from tmsph_testing import main, thorough

EXACT = 1e-4

BETWEEN = (SIDES + "fix a left tmsph/heat/boundary temperature 1.0\n"
           "fix b right tmsph/heat/boundary temperature 0.0")


def layers(n, name, ratio):
    """Flux through two layers, the second of which conducts so much better, over the exact one.
    Its heat capacity is as much larger, so that both take the same time."""
    cloud = slab(n, name)
    cloud.type = 1 + (cloud.X[:, 0] > 0.5)
    words = f"conductivity 1 1.0 conductivity 2 {ratio} specific/heat 1 1.0 specific/heat 2 {ratio}"
    scene = Heated(cloud, words, BETWEEN, start=0.5)
    scene.run_to(6.0, 60, columns="step f_a[1] f_b[1]")
    run = scene.done
    width = np.prod((cloud.box[1] - cloud.box[0])[1:])
    enters, leaves = run.thermo("f_a[1]")[-1] / width, -run.thermo("f_b[1]")[-1] / width
    return enters * (0.5 + 0.5 / ratio), abs(enters / leaves - 1)


def crack(n, name, film=None):
    """A slab cut in the middle, then pressed together by one part in 10000 if the crack has a film:
    temperatures, and the power that enters per area."""
    cloud = slab(n, name)
    x = np.unique(cloud.X[:, 0])
    middle = 0.5 * (x[x < 0.5].max() + x[x > 0.5].min())
    cut = f"line {middle:.17g} -9 {middle:.17g} 9" if cloud.dimension == 2 else \
        f"disc {middle:.17g} 0.5 0.5 1 0 0 9"
    words = UNIFORM + ("" if film is None else f" contact * * {film}")
    scene = Heated(cloud, words, BETWEEN, start=np.where(cloud.X[:, 0] < 0.5, 0.3, 0.6))
    scene.add(f"tmsph/cut all {cut}")
    if film is not None:
        scene.add("fix touch all tmsph/contact friction * * 0.3\ntimestep 1e-9\nrun 0")
        scene.move(cloud.X * ([1 - 1e-4] + [1.0] * (cloud.dimension - 1)))
    T = scene.run_to(12.0, 60, columns="step f_a[1] f_b[1]")
    area = np.prod((cloud.box[1] - cloud.box[0])[1:])
    enters, leaves = (scene.done.thermo(name)[-1] / area for name in ("f_a[1]", "f_b[1]"))
    return cloud, T, enters, abs(enters + leaves)


def two_layers(report):
    sizes = (10, 20, 40, 80) if thorough() else (10, 20, 40)
    for name in ("square", "hex"):
        for ratio in (10.0, 1000.0):
            flux, unsteady = np.transpose([layers(n, name, ratio) for n in sizes])
            what = f"{name}, 1:{ratio:g}"
            report.below(f"{what}: not yet steady", unsteady.max(), 1e-8)
            report.note(f"{what}: errors of the flux", listed(flux - 1))
            report.below(f"{what}: largest error of the flux", abs(flux - 1).max(), EXACT)
    flux, _ = layers(12, "sc", 1000.0)
    report.below("sc, 1:1000: error of the flux at 12", abs(flux - 1), EXACT)


def one_crack(report):
    for name, n in (("square", 20), ("hex", 20), ("sc", 12)):
        cloud, T, power, _ = crack(n, name)
        left = cloud.X[:, 0] < 0.5
        report.below(f"{name}, open crack: power through it", abs(power), 1e-12)
        report.below(f"{name}, open crack: sides at their own temperatures",
                     max(np.abs(T[left] - 1).max(), np.abs(T[~left]).max()), 1e-10)
        for film in (0.5, 2.0, 50.0):
            _, _, power, unsteady = crack(n, name, film)
            what = f"{name}, closed crack, film {film:g}"
            report.below(f"{what}: not yet steady", unsteady, 1e-6)
            report.below(f"{what}: error of the flux of resistances in series",
                         abs(power * (1 + 1 / film) - 1), 0.01)


if __name__ == "__main__":
    main(two_layers, one_crack)
