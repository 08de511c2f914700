# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""An inclusion that is not bonded to its disc, without friction, heated by 100 degrees: both share
one lattice, and the surface between them is found by the package. A bonded frictionless shrink fit
has the same stresses (Lame)."""

import numpy as np

from scenes.disc import INCLUSION, RADIUS, lattice_disc
from tmsph_testing import Scene, contact_pressure, disc_materials, disc_polar_stress

SPACING, HEATED, STEPS = 1e-3, 100.0, 3000


class ContactDisc:
    """words are of fix tmsph/contact; cloud: the particles, if they are not on a lattice. Forces are in
    units of the exact sum of the contact forces, stresses in those of the exact pressure."""

    def __init__(self, words="", cloud=None):
        cloud = cloud or lattice_disc(SPACING)
        r = np.linalg.norm(cloud.X, axis=1)
        inside = r <= INCLUSION
        cloud.type[~inside] = 2
        V = cloud.volume
        a, R = (V[inside].sum() / np.pi) ** 0.5, (V.sum() / np.pi) ** 0.5
        pair = disc_materials(False)
        p = contact_pressure(pair, "strain", a, R, HEATED)
        run = self.heated(cloud, pair, words)
        xx, yy, xy = run.frame("end")("c_p[1] c_p[2] c_p[3]").T
        ring = p * 2 * np.pi * a
        self.kinetic = run.thermo("KinEng")[-1] / run.thermo("PotEng")[-1]
        self.force = run.thermo("f_contact[10]")[-1] / ring
        self.core = -0.5 * (xx + yy)[r < a - 0.006].mean() / p
        self.net = [abs(run.thermo(f"f_contact[{k}]")[-1]) / ring for k in (1, 2)]
        c, s = cloud.X.T / np.maximum(r, 1e-9)
        radial = c * c * xx + s * s * yy + 2 * c * s * xy
        hoop = s * s * xx + c * c * yy - 2 * c * s * xy
        exact = disc_polar_stress(p, a, R, r, inside)
        square = 0.5 * ((radial - exact[0]) ** 2 + (hoop - exact[1]) ** 2) / p**2
        self.error = np.average(square, weights=V) ** 0.5

    @staticmethod
    def heated(cloud, pair, words):
        wave = np.sqrt(1.35 * pair[0]["young"] / pair[0]["density"])
        drag = 2 * pair[0]["density"] * cloud.volume[0] * wave / RADIUS
        scene = Scene(cloud, pair, "plane strain viscosity 1.0 0.0").add("pair_coeff 1 2 none")
        scene.add(f"variable T equal {HEATED}*((step<{STEPS / 2})*step/{STEPS / 2}"
                  f"+(step>={STEPS / 2}))\n"
                  "fix heat all tmsph/heat/boundary temperature v_T\n"
                  f"fix drag all viscous {drag:.6g}\n"
                  f"fix move all nve\nfix contact all tmsph/contact {words}\n"
                  f"timestep {0.6 * SPACING / wave:.6g}\n"
                  "compute p all tmsph/property/atom sxx syy sxy")
        scene.thermo("step ke pe f_contact[8] f_contact[10] f_contact[1] f_contact[2] f_contact[6]",
                     STEPS // 2)
        return scene.add(f"run {STEPS}").snapshot("end", "c_p[*]").run()
