# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A closed flat cut through a block, in 2-D and 3-D, pressed and sheared with its faces stuck: as
stiff as the uncut block. The outer layers are moved by a homogeneous strain; the uncut block
follows it exactly. What is measured is the jump of the displacements across the cut, by lines
through those on either side of it, in units of the strain and the spacing, and the stress on the
plane of the cut of the particles near it, in units of the exact one."""

import numpy as np

from tmsph_testing import HORIZON, Scene, lattice, main, material

SPACING, STRAIN, STUCK = 1e-3, 1e-3, 10.0
ROCK = material()
LAYER, NEAR = 3.1, 2.0    # held at the outside; counted as near the cut


class Block:
    def __init__(self, name, cells, angle):
        self.cloud = cloud = lattice(name, cells, SPACING, centre=True)
        c, s = np.cos(np.radians(angle)), np.sin(np.radians(angle))
        between = [0.0] * (len(cells) - 2)
        self.along, self.normal = np.array([c, *between, s]), np.array([-s, *between, c])
        self.place = 1e-4 * SPACING * self.normal    # of the cut: through no particle
        size = np.abs(cloud.X).max(axis=0)
        self.held = (np.abs(cloud.X) > size - LAYER * SPACING).any(axis=1)
        self.depth = (cloud.X - self.place) @ self.normal
        self.middle = np.linalg.norm(cloud.X - np.outer(self.depth, self.normal), axis=1)
        self.half = size.min()

    def cut(self):
        far = 10 * self.half
        if len(self.normal) == 2:
            word, numbers = "line", (*self.place - far * self.along, *self.place + far * self.along)
        else:
            word, numbers = "disc", (*self.place, *self.normal, far)
        return f"{word} " + " ".join(f"{x:.17g}" for x in numbers)

    def strained(self, shear, steps):
        """Equilibrium under pressure, and shear, across the cut."""
        cloud, n, t, d = self.cloud, self.normal, self.along, self.cloud.dimension
        gradient = STRAIN * (-np.outer(n, n) + (0.5 * np.outer(t, n) if shear else 0.0))
        wave = np.sqrt(1.35 * ROCK["young"] / ROCK["density"])
        scene = Scene(cloud, [ROCK], "viscosity 1.0 0.0")
        scene.files["held"] = f"\n{len(cloud)}\n" + "\n".join(
            f"{i + 1} {int(h)}" for i, h in enumerate(self.held)) + "\n"
        scene.add("variable held atomfile held\nvariable isheld atom v_held>0.5\n"
                  "group held variable isheld\ngroup free subtract all held")
        scene.add(f"tmsph/cut all {self.cut()}\nrun 0")
        moved = cloud.X + cloud.X @ gradient.T
        scene.move(moved).add("velocity all set 0 0 0\nfix hold held setforce 0 0 0")
        drag = 0.75 * ROCK["density"] * SPACING**d * wave / (self.half + 0.5 * SPACING) / 2
        scene.add(f"fix drag free viscous {drag:.6g}\nfix move free nve\n"
                  f"fix contact all tmsph/contact friction * * {STUCK}\n"
                  f"timestep {0.6 * SPACING / wave:.6g}\nthermo_style custom step ke f_contact[8]\n"
                  f"compute p all tmsph/property/atom sxx syy szz sxy sxz syz\nrun {steps}")
        scene.snapshot("end", "x y z c_p[*]")
        end = scene.run().frame("end")
        self.away = end("x y z")[:, :d] - moved
        strain = 0.5 * (gradient + gradient.T)
        E, nu = ROCK["young"], ROCK["poisson"]
        lame, G = E * nu / ((1 + nu) * (1 - 2 * nu)), E / (2 * (1 + nu))
        exact = lame * np.trace(strain) * np.eye(d) + 2 * G * strain
        xx, yy, zz, xy, xz, yz = end(" ".join(f"c_p[{k}]" for k in range(1, 7))).T
        stress = np.array([[xx, xy, xz], [xy, yy, yz], [xz, yz, zz]])[:d, :d]
        self.pressure = np.einsum("i,ijk,j->k", n, stress, n) / (n @ exact @ n)
        self.shear = np.einsum("i,ijk,j->k", t, stress, n) / (t @ exact @ n) if shear else None

    def jump(self):
        """Normal and tangential, by lines through the displacements on either side."""
        value = []
        for side in (1, -1):
            depth = side * self.depth / SPACING
            chosen = ~self.held & (depth > HORIZON) & (depth < 9) & (self.middle < 5 * SPACING)
            lines = np.stack([np.ones(chosen.sum()), depth[chosen]], axis=1)
            value.append(np.linalg.lstsq(lines, self.away[chosen], rcond=None)[0][0])
        jump = (value[0] - value[1]) / (STRAIN * SPACING)
        return jump @ self.normal, jump @ self.along

    def near(self):
        return ~self.held & (np.abs(self.depth) < NEAR * SPACING) & (self.middle < 6 * SPACING)


def judge(report, what, block, shear):
    normal, tangential = block.jump()
    report.below(f"{what}: normal jump {normal:.4f}", abs(normal), 0.1)
    report.below(f"{what}: tangential jump {tangential:.4f}", abs(tangential), 0.1)
    near = block.near()
    sheared = [("shear", block.shear)] if shear else []
    for name, stress in [("pressure", block.pressure)] + sheared:
        s = stress[near]
        report.within(f"{what}: mean {name} near the cut", s.mean(), 0.9, 1.1)
        single = f"{what}: {name} of single particles"
        if len(block.normal) == 3:
            report.note(single, f"{s.min():.3f} to {s.max():.3f}")
            continue
        report.within(f"{single}, least", s.min(), 0.9, 1.1)
        report.within(f"{single}, most", s.max(), 0.9, 1.1)


def in_2d(report):
    for name, cells in (("square", (30, 30)), ("hex", (30, 17))):
        for angle in (0, 15, 30, 45):
            for shear in (False, True):
                if not shear and angle in (15, 30):
                    continue    # pressure is a part of both
                block = Block(name, cells, angle)
                block.strained(shear, 1000)
                what = f"{name}, {angle} degrees, {'sheared' if shear else 'pressed'}"
                judge(report, what, block, shear)


def in_3d(report):
    for name, cells, angle in (("sc", (12, 12, 22), 0), ("sc", (14, 14, 22), 25),
                               ("fcc", (9, 9, 16), 0), ("fcc", (9, 9, 16), 25)):
        block = Block(name, cells, angle)
        block.strained(True, 400)
        judge(report, f"3-D, {name}, {angle} degrees, sheared", block, True)


if __name__ == "__main__":
    main(in_2d, in_3d)
