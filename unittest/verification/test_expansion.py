# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A uniformly heated free body expands without stress, jittered or not: found by
minimizing the energy. The strain is taken from all pairs within the horizon."""

from tmsph_testing import *

SPACING, TEMPERATURE = 1e-3, 200.0
ROCK = material(40e9, 0.3, 2700, 1e-5)
SOFT = material(4e9, 0.3, 2700, 1e-5)    # equal expansion and Poisson's ratio: no stress either
BODIES = {"plane strain": ("square", (12, 9), 1.3e-5), "plane stress": ("hex", (12, 5), 1e-5),
          "3-D": ("sc", (7, 6, 5), 1e-5)}


def pairs(cloud):
    distance = np.linalg.norm(cloud.X[:, None] - cloud.X[None], axis=2)
    return np.nonzero(np.triu(distance < HORIZON * SPACING, 1))


def check(report, plane, jitter, mode):
    name, cells, expansion = BODIES[plane]
    what = f"{plane}, jitter {jitter}, thermal {mode}"
    cloud = lattice(name, cells, SPACING).jitter(jitter, 11)
    d = cloud.dimension
    cloud.type[cloud.X[:, 0] > cloud.X[:, 0].mean()] = 2
    a = expansion * TEMPERATURE
    # Green's strain of the constitutive form is a, the stretch of the thermal bond is 1 + a
    strain = a if mode == "bond" else (1 + 2 * a) ** 0.5 - 1
    stress = ROCK["young"] * ROCK["expansion"] * TEMPERATURE
    keyword = "" if d == 3 else "plane " + plane.split()[1]
    axes = "xx yy xy" if d == 2 else "xx yy zz xy xz yz"
    columns = " ".join("s" + axis for axis in axes.split())
    scene = Scene(cloud, [ROCK, SOFT], f"{keyword} thermal {mode}")
    scene.add(f"compute p all tmsph/property/atom {columns} szz\nrun 0")
    scene.add(f"set group all temperature {TEMPERATURE}")
    scene.minimize(1e-11 * stress * SPACING ** (d - 1)).snapshot("d", "x y z c_p[*]")
    frame = scene.run().frame("d")
    x = frame("x y z")[:, :d]
    i, j = pairs(cloud)
    before = np.linalg.norm(cloud.X[j] - cloud.X[i], axis=1)
    after = np.linalg.norm(x[j] - x[i], axis=1)
    report.below(f"{what}: error of the strain/strain",
                 np.abs((after - before) / before - strain).max() / strain, 1e-8)
    n = len(columns.split())
    values = frame(" ".join(f"c_p[{k + 1}]" for k in range(n)))
    report.below(f"{what}: stress/(E alpha dT)", np.abs(values).max() / stress, 1e-8)
    if plane == "plane strain":
        young = np.where(cloud.type == 1, ROCK["young"], SOFT["young"])
        szz = -young * ROCK["expansion"] * TEMPERATURE
        error = np.abs(frame[f"c_p[{n + 1}]"] - szz).max() / stress
        report.below(f"{what}: error of szz/(E alpha dT)", error, 1e-8)


report = Report()
for plane in BODIES:
    for jitter in (0.0, 0.2):
        for mode in ("bond", "strain"):
            check(report, plane, jitter, mode)
report.finish()
