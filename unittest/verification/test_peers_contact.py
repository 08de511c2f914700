# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""The closed forms of LAMMPS's tests of granular contact (unittest/granular of 2026), for
deformable bodies: head-on impact, oblique impact on a wall and of a pair, a disc that slides and
then rolls. Two-dimensional: the moment of inertia of a disc is m r^2/2.

What a body does in an impact is the momentum that it takes over: friction takes mu times that along
the normal as long as it slides all the time, whatever the restitution. For bars the restitution
follows from plane waves: the ratio of their lengths (St Venant).

A wall acts on the particles, whose outermost are half a spacing inside of the surface: the arm of
the friction is that much too short. Bars: a spacing over the radius for the spin; 5 % for what
depends on the roughness of the rims and on waves, 1 % for friction on a wall."""

import numpy as np

from tmsph_testing import Cloud, Frame, Scene, lattice, main, material, thorough

ROCK = material(10e6, 0.2, 1000.0)
WAVE = (10e6 * 0.8 / (1.2 * 0.6) / 1000) ** 0.5
MU = 0.2


def rings(radius, n):
    """A disc of particles in n rings and one in the middle, with its true area and a round rim."""
    spacing = radius / (n + 0.5)
    points, volumes = [np.zeros((1, 2))], [np.array([np.pi * 0.25 * spacing**2])]
    for k in range(1, n + 1):
        count = round(2 * np.pi * k)
        angle = 2 * np.pi * (np.arange(count) + 0.5 * (k % 2)) / count
        points.append(k * spacing * np.stack([np.cos(angle), np.sin(angle)], axis=1))
        volumes.append(np.full(count, 2 * np.pi * k * spacing**2 / count))
    cloud = Cloud(np.concatenate(points), 1.0, spacing)
    cloud.volume = np.concatenate(volumes)
    return cloud


def wide(scene):
    scene.lines[2] = "boundary f f p"
    return scene.add("change_box all x final -4 4 y final -4 4\nfix move all nve")


def motion(frame, cloud):
    """Velocity of the centre and spin."""
    m = cloud.volume / cloud.volume.sum()
    x, v = frame("x y"), frame("vx vy")
    x0, v0 = m @ x, m @ v
    r, w = x - x0, v - v0
    return v0, (m @ (r[:, 0] * w[:, 1] - r[:, 1] * w[:, 0])) / (m @ np.square(r).sum(axis=1))


def bars(report, ratio):
    """Bars of lengths 1 and ratio, periodic across: plane waves."""
    n, width, dx, v = 60, 8, 1e-2, 0.1
    cloud = lattice("square", (n * (1 + ratio), width), dx, periodic="y")
    cloud.type[cloud.X[:, 0] > n * dx] = 2
    cloud.X[cloud.type == 2, 0] += 4 * dx
    scene = Scene(cloud, [ROCK] * 2)
    scene.lines[2] = "boundary f p p"
    scene.add(f"pair_coeff 1 2 none\nchange_box all x final -4 8\nset type 1 vx {v}\n"
              f"fix move all nve\nfix touch all tmsph/contact\ntimestep {0.4 * dx / WAVE:.9g}\n"
              f"thermo_style custom step f_touch[8]")
    # until they meet, and while they touch
    time = 4.0 * dx / v + 3 * n * dx / WAVE * ratio
    run = scene.add(f"run {int(time / (0.4 * dx / WAVE))}").snapshot("end", "vx").run()
    vx = run.frame("end")["vx"]
    first, second = vx[cloud.type == 1].mean() / v, vx[cloud.type == 2].mean() / v
    report.below(f"bars of lengths 1:{ratio}: momentum", abs(first + ratio * second - 1), 1e-9)
    report.below(f"bars of lengths 1:{ratio}: velocity of the first after the impact/before",
                 abs(first), 0.05)
    report.below(f"bars of lengths 1:{ratio}: restitution, {second - first:.4f}, against exact",
                 abs((second - first) * ratio - 1), 0.05)


def oblique_wall(report, vx, vy, n):
    radius = 0.1
    cloud = rings(radius, n)
    cloud.X[:, 1] += radius + 0.002
    dt = 0.4 * cloud.spacing / WAVE
    scene = wide(Scene(cloud, [ROCK])).set("vx vy", np.tile([vx, -vy], (len(cloud), 1)))
    scene.add(f"fix w all tmsph/wall line -4 0 4 0 friction {MU}\ntimestep {dt:.9g}")
    scene.add(f"run {int((0.002 / vy + 12 * radius / WAVE) / dt)}")
    run = scene.snapshot("end", "x y vx vy").run()
    v, spin = motion(run.frame("end"), cloud)
    push = v[1] + vy    # of the normal force, per mass
    arms = np.square(cloud.X - [0, radius + 0.002]).sum(axis=1)
    inertia = cloud.volume @ arms / cloud.volume.sum()
    what = f"disc of {n} rings on a wall at {np.degrees(np.arctan2(vx, vy)):.0f} degrees"
    report.note(f"{what}: restitution", f"{v[1] / vy:.4f}")
    report.above(f"{what}: restitution", v[1] / vy, 0.5)
    report.below(f"{what}: tangential impulse/(mu normal impulse) - 1",
                 abs((vx - v[0]) / (MU * push) - 1), 0.01)
    report.below(f"{what}: spin/(mu normal impulse r/I) - 1",
                 abs(-spin * inertia / (MU * push * radius) - 1), cloud.spacing / radius)


def oblique_pair(report):
    """Two discs symmetrically, in gross sliding: the same for each of them."""
    radius, n, vn, vt = 0.1, 20, 0.1, 0.15
    half = rings(radius, n)
    gap = 2 * radius + 0.02
    # so that the line of centres is along x when they touch
    start = 0.5 * np.array([-gap, -0.02 * vt / vn])
    cloud = Cloud(np.concatenate([half.X + start, -half.X - start]), 1.0, half.spacing)
    cloud.volume = np.tile(half.volume, 2)
    cloud.type = np.repeat([1, 2], len(half))
    first = cloud.type == 1
    dt = 0.4 * cloud.spacing / WAVE
    scene = wide(Scene(cloud, [ROCK] * 2)).add("pair_coeff 1 2 none")
    scene.set("vx vy", np.where(first, 1, -1)[:, None] * [vn, vt])
    scene.add(f"fix touch all tmsph/contact friction * * {MU}\ntimestep {dt:.9g}")
    scene.add(f"run {int((0.01 / vn + 12 * radius / WAVE) / dt)}")
    frame = scene.snapshot("end", "x y vx vy").run().frame("end")
    part = Frame((name, column[first]) for name, column in frame.items())
    v, spin = motion(part, half)
    push = vn - v[0]
    inertia = half.volume @ np.square(half.X).sum(axis=1) / half.volume.sum()
    report.note("pair of discs: restitution", f"{-v[0] / vn:.4f}")
    report.below("pair of discs: tangential impulse/(mu normal impulse) - 1",
                 abs((vt - v[1]) / (MU * push) - 1), 0.05)
    report.below("pair of discs: spin/(mu normal impulse r/I) - 1",
                 abs(abs(spin) * inertia / (MU * push * radius) - 1), 0.05)


def rolling(report):
    """Slides on a floor, then rolls with 2/3 of its speed: after u0/(3 mu g)."""
    radius, n, u0, g = 0.1, 20, 1.5, 9.81
    cloud = rings(radius, n)
    cloud.X[:, 1] += radius
    dt = 0.4 * cloud.spacing / WAVE
    mass = ROCK["density"] * cloud.volume.sum()
    scene = wide(Scene(cloud, [ROCK], "viscosity 1.0 0.0")).add(
        f"fix g all gravity {g} vector 0 -1 0\ntimestep {dt:.9g}\n"
        f"fix drag all viscous {mass / len(cloud) * 300:.6g}\n"
        f"fix w all tmsph/wall line -4 0 4 0 friction {MU}\n"
        f"run {int(0.2 / dt)}\nunfix drag").add(f"velocity all set {u0} 0 0 sum yes")
    stop = u0 / (3 * MU * g)
    for k, part in enumerate((0.5, 1.5)):
        scene.add(f"run {int(stop * (part - (0, 0.5)[k]) / dt)}").snapshot(f"at{k}", "x y vx vy")
    run = scene.run()
    for k, (part, u, spin) in enumerate(((0.5, 1 - 1 / 6, 1 / 3), (1.5, 2 / 3, 2 / 3))):
        v, w = motion(run.frame(f"at{k}"), cloud)
        report.below(f"disc on a floor after {part} of the sliding: speed/{u:.3f} of the first - 1",
                     abs(v[0] / (u * u0) - 1), 0.03)
        report.below(f"disc on a floor after {part} of the sliding: spin/exact - 1",
                     abs(-w * radius / (spin * u0) - 1), cloud.spacing / radius)


def two_bars(report):
    bars(report, 1)
    bars(report, 2)


def thrown_at_a_wall(report):
    for n in (10, 20, 40) if thorough() else (20,):
        oblique_wall(report, 0.2, 0.1, n)
    oblique_wall(report, 0.3, 0.1, 20)


if __name__ == "__main__":
    main(two_bars, thrown_at_a_wall, oblique_pair, rolling)
