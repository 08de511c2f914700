# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A column of rock stands on a slope with friction, under its weight and that of many more rows
on top of it. The stress that is reported and tested is that of the continuum at the height of
each row, down to the row at the wall: across the wall the weight above, along it the part of
that which slides, and sideways nu/(1 - nu) of the stress across, as the column is periodic. In
2-D and 3-D, on a line and on a plane.

Bonds alone, which pass the load on over the horizon, give 0.71, 0.81, 0.96, 1.02 of it in the
rows of a square lattice. With the share of the wall, averaged as tmsph_pressed_surfaces.h tells,
the equilibrium of the rows leaves 1.3 %, and the stress of the lowest is that of half a spacing
above, here 1 %: bar 2 %. Friction may hold particles of a row unevenly: their mean counts."""

import numpy as np

from tmsph_testing import Scene, lattice, main, material

SPACING, ROCK = 0.5, material(40e9, 0.25, 2700.0)
GRAVITY, SLOPE = 9.81, 0.3
ABOVE, BAR = 40, 0.02    # rows that the load on top stands for


def column(report, name, cells, wall):
    up, dimension = len(cells) - 1, len(cells)
    cloud = lattice(name, cells, SPACING, periodic="xy"[:up])
    heights = np.unique(np.round(cloud.X[:, up], 9))
    row, half = heights[1] - heights[0], 0.5 * np.mean(cloud.volume) ** (1 / dimension)
    on_top = np.abs(cloud.X[:, up] - heights[-1]) < 1e-6
    weight = 2700 * cloud.volume * GRAVITY * np.where(on_top, 1 + ABOVE, 1)
    scene = Scene(cloud, [ROCK], "hourglass 0.1")
    scene.lines[2] = scene.lines[2].replace(" s", " f")
    low, high = cloud.X[:, up].min() - 10, cloud.X[:, up].max() + 10
    scene.add(f"change_box all {'xyz'[up]} final {low:.6g} {high:.6g}")
    across = "xyz"[up]
    rows = "\n".join(f"{i + 1} {w:.17g}" for i, w in enumerate(weight))
    scene.files["weight"] = f"\n{len(weight)}\n{rows}\n"
    scene.add(f"""variable weight atomfile weight
variable slides atom {SLOPE}*v_weight
variable falls atom -v_weight
variable energy atom v_weight*({across}-{SLOPE}*x)
fix weight all addforce v_slides {'v_falls 0' if up == 1 else '0 v_falls'} energy v_energy
fix floor all tmsph/wall {wall(heights[0] - half)} friction 0.6
compute s all tmsph/property/atom sxx syy szz sxy sxz syz
min_style tmsph/lbfgs
minimize 0 {1e-7 * weight.sum():.6g} 2000 5000
run 0""")
    run = scene.snapshot("end", " ".join(f"c_s[{k}]" for k in range(1, 7))).run()
    report.above(f"{name}, {dimension}-D: in equilibrium", "force tolerance" in run.log, 0.5)
    xx, yy, zz, xy, xz, yz = run.frame("end")(" ".join(f"c_s[{k}]" for k in range(1, 7))).T
    normal, shear, side = (yy, xy, xx) if up == 1 else (zz, xz, yy)
    rows = [np.abs(cloud.X[:, up] - y) < 1e-6 for y in heights[:8]]
    pressure = 2700 * GRAVITY * (heights[-1] + (0.5 + ABOVE) * row - heights[:8])
    for what, stress, exact in (("across the wall", normal, -pressure),
                                ("along it", shear, SLOPE * pressure),
                                ("sideways", side, -pressure / 3)):
        ratio = np.array([stress[here].mean() for here in rows]) / exact
        report.within(f"{name}, {dimension}-D: stress {what}/exact, least", ratio.min(),
                      1 - BAR, 1 + BAR)
        report.within(f"{name}, {dimension}-D: stress {what}/exact, most", ratio.max(),
                      1 - BAR, 1 + BAR)


def columns(report):
    line = lambda y: f"line -1 {y:.9g} 100 {y:.9g}"
    column(report, "square", (8, 16), line)
    column(report, "hex", (8, 9), line)
    column(report, "sc", (7, 7, 12), lambda z: f"plane 0 0 {z:.9g} 0 0 1")


if __name__ == "__main__":
    main(columns)
