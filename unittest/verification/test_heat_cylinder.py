# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Hollow cylinder, hot inside and cold outside: the steady temperature and the thermal stress of
the coupled model against the closed form, in plane strain and plane stress. With "all": more
resolutions and lattices, for the report."""

from heat_scenes import listed
from scenes.cylinder import HollowCylinder
from tmsph_testing import main, order, thorough


def cylinder(report):
    sizes = (10, 20, 40) if thorough() else (20, 40)
    for plane in ("strain", "stress") if thorough() else ("strain",):
        for name in ("hex", "square") if thorough() else ("hex",):
            walls = [HollowCylinder(n, plane, name) for n in sizes]
            T, typical, largest, everywhere = zip(
                *[(w.temperature, w.typical, w.largest, w.everywhere) for w in walls])
            what = f"plane {plane}, {name}"
            report.note(f"{what}: temperature, {sizes}", listed(T))
            report.note(f"{what}: stress away from the surfaces, rms and largest",
                        f"{listed(typical)}; {listed(largest)}")
            report.note(f"{what}: stress everywhere, rms", listed(everywhere))
            report.note(f"{what}: orders, rms away and everywhere, largest away",
                        f"{order(typical)} {order(everywhere)} {order(largest)}")
            report.below(f"{what}: temperature at {sizes[-1]}", T[-1], 1e-3)
            report.below(f"{what}: stress away from the surfaces at {sizes[-1]}, largest error",
                         largest[-1], 0.02)
            report.above(f"{what}: order of the stress away from the surfaces", order(typical)[-1],
                         1.0)


if __name__ == "__main__":
    main(cylinder)
