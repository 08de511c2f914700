# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""LAMMPS's minimize without min_style finds the equilibrium of elastic bodies; any other style
converges to the same, or one line tells which style to use: never another remedy, never silence."""

import numpy as np

from tmsph_testing import Scene, disc_materials, lattice, main, material

RESIDUAL = 1e-6    # of a typical force on a particle, strength 5e6 Pa times its face

STYLES = [(style, line, dmax) for style in ("cg", "sd")
          for line in ("quadratic", "backtrack", "forcezero")
          for dmax in ("0.1", "1e-5")]
STYLES += [(style, "quadratic", "0.1") for style in ("fire", "quickmin", "hftn", "tmsph/lbfgs")]


def strip(spacing, size=(60e-3, 10e-3)):
    """Two layers, heated by 50 degrees: the lower one 4 mm thick, stiffer, and expands more."""
    cells = [round(size[0] / spacing), round(size[1] / spacing / 3**0.5)]
    cloud = lattice("hex", cells, spacing, centre=True)
    cloud.type[cloud.X[:, 1] > -1e-3] = 2
    return cloud, [material(40e9, 0.3, 2700, 1.5e-5), material(20e9, 0.2, 2700, 1e-5)]


def heated(cloud, materials, pair=""):
    return Scene(cloud, materials, pair, temperature=50.0)


def minimized(scene, choice="", iterations=2000):
    d = scene.cloud.dimension
    tolerance = RESIDUAL * 5e6 * scene.cloud.spacing**(d - 1) * len(scene.cloud)**0.5
    return scene.add(f"{choice}\nminimize 0 {tolerance:.6g} {iterations} {3 * iterations}")


def lines(run):
    return [line for line in run.log.splitlines() if line.startswith(("ERROR", "WARNING: Min"))]


def converged(run):
    return not run.failed and "Stopping criterion = force tolerance" in run.log


def evaluations(run):
    return int(run.log.rpartition("Iterations, force evaluations =")[2].split()[1])


def curvature(report):
    """Against Timoshenko, Analysis of bi-metal thermostats, J. Opt. Soc. Am. 11 (1925) 233, in
    plane strain. Beam theory holds to the square of thickness over length, 3 %, less at the
    ends."""
    cloud, rocks = strip(0.5e-3)
    run = minimized(heated(cloud, rocks)).snapshot("end", "x y").run()
    end = run.frame("end")("x y")
    row = (np.abs(cloud.X[:, 0]) < 20e-3) & (np.abs(cloud.X[:, 1]) < 0.3e-3)
    measured = 2 * np.polyfit(cloud.X[row, 0], (end - cloud.X)[row, 1], 2)[0]
    height = np.ptp(cloud.X[:, 1]) + 0.5e-3 * 3**0.5 / 2
    top = (cloud.type == 2).mean() * height
    m, t = (height - top) / top, height
    stiff = [r["young"] / (1 - r["poisson"]**2) for r in rocks]
    swell = [(1 + r["poisson"]) * r["expansion"] for r in rocks]
    n = stiff[0] / stiff[1]
    beam = 6 * (swell[0] - swell[1]) * 50 * (1 + m)**2 / (
        t * (3 * (1 + m)**2 + (1 + m * n) * (m**2 + 1 / (m * n))))
    report.true("a strip of two layers: converged", converged(run) and not lines(run),
                lines(run)[:1])
    report.within("  curvature over Timoshenko's", measured / beam, 0.97, 1.03)
    report.within("  force evaluations", evaluations(run), 1, 60)


def bodies():
    """Name, scene: elastic bodies in 2-D and 3-D with loads of all kinds."""
    yield "strip", heated(*strip(1e-3, (30e-3, 10e-3)))
    yield "strip in plane stress", heated(*strip(1e-3, (30e-3, 10e-3)), "plane stress")
    disc = lattice("hex", [22, 13], 1e-3, centre=True).kept(lambda X: np.hypot(*X.T) < 10e-3)
    disc.type[np.hypot(*disc.X.T) > 4e-3] = 2
    yield "disc", heated(disc, disc_materials(False))
    ball = lattice("fcc", [8, 8, 8], 1e-3,
                   centre=True).kept(lambda X: np.linalg.norm(X, axis=1) < 5e-3)
    ball.type[np.linalg.norm(ball.X, axis=1) > 2.5e-3] = 2
    yield "ball", heated(ball, disc_materials(True))
    block = lattice("sc", [6, 6, 6], 1e-3)
    yield "nearly incompressible block", heated(block, [material(20e9, 0.49, 2700, 1e-5)]).add(
        "region low block INF INF INF INF INF 1e-3 units box\ngroup low region low\n"
        "fix hold low setforce 0 0 0")
    yield "block that is pressed", Scene(block, [material()]).add(
        "region low block INF INF INF INF INF 1e-3 units box\ngroup low region low\n"
        "region top block INF INF INF INF 5e-3 INF units box\ngroup top region top\nrun 0\n"
        "fix hold low setforce 0 0 0\nfix press top addforce 1 0 -2")
    yield "block on a wall", Scene(block, [material()]).add(
        "fix pull all addforce 0 0 -0.02\nfix wall all tmsph/wall plane 0 0 0 0 0 1 friction 0.5")


def defaults(report):
    for name, scene in bodies():
        run = minimized(scene).run(may_fail=True)
        report.true(f"default, {name}", converged(run) and not lines(run),
                    f"{evaluations(run)} force evaluations" if converged(run) else run.log[-300:])


def others(report):
    for body in ("strip", "ball"):
        make = lambda: dict(bodies())[body]
        best = minimized(make()).run().thermo("PotEng")[-1]
        for style, line, dmax in STYLES:
            choice = f"min_style {style}\nmin_modify line {line} dmax {dmax}"
            run = minimized(make(), choice, 400).run(may_fail=True)
            said, name = lines(run), f"{body}, {style} line {line} dmax {dmax}"
            if converged(run):
                energy = run.thermo("PotEng")[-1]
                report.true(name, not said and abs(energy / best - 1) < 1e-6,
                            f"converged in {evaluations(run)} evaluations")
            else:
                report.true(name, len(said) == 1 and "use 'min_style tmsph/lbfgs'" in said[0]
                            and run.status < 128, said)


if __name__ == "__main__":
    main(curvature, defaults, others)
