# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Layers in series between two temperatures, steady: materials of conductivity 1:10 and 1:1000, an
open crack, which lets nothing through, and a closed one with a film on it, which is a resistance
in series. With "all": more resolutions, for the report."""

from heat_scenes import *

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


def crack(n, name, more=""):
    """Power of both sides, of a slab cut in the middle."""
    cloud = slab(n, name)
    last = cloud.X[:, 0][cloud.X[:, 0] < 0.5].max()
    first = cloud.X[:, 0][cloud.X[:, 0] > 0.5].min()
    middle = 0.5 * (last + first)
    low, high = cloud.box[0][1] - 1, cloud.box[1][1] + 1
    cut = f"tmsph/cut all line {middle:.17g} {low:.17g} {middle:.17g} {high:.17g}"
    scene = Heated(cloud, UNIFORM + more, BETWEEN, start=np.where(cloud.X[:, 0] < 0.5, 0.3, 0.6))
    scene.add(cut)
    T = scene.run_to(4.0, 40, columns="step f_a[1] f_b[1]")
    return cloud, T, scene.done


report = Report()
sizes = (10, 20, 40, 80) if "all" in sys.argv else (10, 20, 40)
for name in ("square", "hex"):
    for ratio in (10.0, 1000.0):
        flux, unsteady = np.transpose([layers(n, name, ratio) for n in sizes])
        what = f"{name}, 1:{ratio:g}"
        report.below(f"{what}: not yet steady", unsteady.max(), 1e-8)
        report.note(f"{what}: errors of the flux", flux - 1)
        if name == "square":
            report.below(f"{what}: error of the flux at 20", abs(flux[1] - 1), 0.01)
        report.above(f"{what}: lowest order", order(flux - 1).min(), 0.95)
flux, _ = layers(12, "sc", 1000.0)
report.below("sc, 1:1000: error of the flux at 12", abs(flux - 1), 0.01 * 20 / 12)

cloud, T, run = crack(20, "square")
left = cloud.X[:, 0] < 0.5
report.below("open crack: power through it", abs(run.thermo("f_a[1]")[-1]), 1e-12)
report.below("open crack: sides at their own temperatures",
             max(np.abs(T[left] - 1).max(), np.abs(T[~left]).max()), 1e-10)
report.finish()
