# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Hollow cylinder, hot inside and cold outside: the steady temperature and the thermal stress of
the coupled model against the closed form (Timoshenko and Goodier, Theory of Elasticity, 3rd ed.,
sect. 150), in plane strain and plane stress. Away from the surfaces, which are staircases, is a
horizon of the coarser cylinder. With "all": more resolutions and lattices, for the report."""

from heat_scenes import *

INNER, OUTER, HOT, AWAY = 0.5, 1.0, 100.0, HORIZON / 20
ROCK = material(40e9, 0.25, 2700.0, 1e-5)


def cylinder(n, plane, name="hex"):
    """n particles across the wall: errors of the temperature and of the stress, the latter over the
    largest stress, as root mean square and largest."""
    spacing = (OUTER - INNER) / n
    cells = tuple(int(2.2 * OUTER / spacing / edge) + 2 for edge in LATTICES[name][0])
    wall = lambda X: (np.hypot(*X.T) < OUTER) & (np.hypot(*X.T) > INNER)
    whole = lattice(name, cells, spacing, centre=True)
    cloud = whole.kept(wall)
    cell = whole.volume[0]
    a = np.sqrt(np.count_nonzero(np.hypot(*whole.X.T) <= INNER) * cell / np.pi)
    b = np.sqrt(a**2 + len(cloud) * cell / np.pi)
    edges = (f"region hole sphere 0 0 0 {a:.17g} side out\nregion rim sphere 0 0 0 {b:.17g}\n"
             f"region half sphere 0 0 0 0.75\ngroup inner region half\ngroup outer subtract all inner\n"
             f"fix a inner tmsph/heat/boundary temperature {HOT} region hole\n"
             "fix b outer tmsph/heat/boundary temperature 0.0 region rim")
    r = np.hypot(*cloud.X.T)
    steady = HOT * np.log(b / r) / np.log(b / a)
    diffusivity = 2.9 / (ROCK["density"] * 850)
    scene = Heated(cloud, "conductivity * 2.9 specific/heat * 850", edges, start=0.5 * HOT,
                   materials=[ROCK])
    scene.lines = [line + f" plane {plane}" if line.startswith("pair_style") else line
                   for line in scene.lines]
    scene.add("compute p all tmsph/property/atom sxx syy sxy")
    # the slowest mode decays like exp(-pi^2 kappa t/(b - a)^2)
    scene.thermo("step fnorm f_a[1] f_b[1]").add(
        f"timestep {2.5 * (b - a)**2 / diffusivity / 40:.17g}\nneigh_modify every 1000\nrun 40")
    young, nu = ROCK["young"], ROCK["poisson"]
    scale = young * ROCK["expansion"] * HOT / (2 * np.log(b / a)) / (1 - nu if plane == "strain" else 1)
    scene.minimize(1e-6 * scale * spacing)
    end = scene.snapshot("end", "c_T c_p[*]").run().frame("end")

    ring = a**2 / (b**2 - a**2) * np.log(b / a)
    radial = scale * (-np.log(b / r) - ring * (1 - b**2 / r**2))
    hoop = scale * (1 - np.log(b / r) - ring * (1 + b**2 / r**2))
    c, s = cloud.X.T / r
    xx, yy, xy = end("c_p[1] c_p[2] c_p[3]").T
    measured = (c * c * xx + s * s * yy + 2 * c * s * xy, s * s * xx + c * c * yy - 2 * c * s * xy)
    error = np.stack([measured[0] - radial, measured[1] - hoop]) / np.abs(hoop).max()
    away = np.minimum(r - a, b - r) > AWAY * (b - a)
    return (rms(end["c_T"] - steady) / HOT, rms(error[:, away]), np.abs(error[:, away]).max(),
            rms(error))


report = Report()
sizes = (10, 20, 40) if "all" in sys.argv else (20, 40)
for plane in ("strain", "stress") if "all" in sys.argv else ("strain",):
    for name in ("hex", "square") if "all" in sys.argv else ("hex",):
        T, typical, largest, everywhere = zip(*[cylinder(n, plane, name) for n in sizes])
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
        report.above(f"{what}: order of the stress away from the surfaces", order(typical)[-1], 1.0)
report.finish()
