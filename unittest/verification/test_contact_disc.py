# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""An inclusion that is not bonded to its disc, without friction, heated by 100 degrees:
both share one lattice, and the surface between them is found by the package. A bonded
frictionless shrink fit has the same stresses (Lame). The sum of the contact forces and
the pressure in the core, at 1 mm."""

from tmsph_testing import *

INCLUSION, RADIUS, SPACING, HEATED, STEPS = 0.015, 0.050, 1e-3, 100.0, 3000

cells = (2 * int(RADIUS / SPACING) + 4, 2 * int(RADIUS / SPACING / 3**0.5) + 4)
cloud = lattice("hex", cells, SPACING, centre=True)
cloud.X += [0.25 * SPACING, 0.25 * 3**0.5 * SPACING]    # a particle in the centre
cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= RADIUS)
r = np.linalg.norm(cloud.X, axis=1)
inside = r <= INCLUSION
cloud.type[~inside] = 2
V = cloud.volume
a, R = (V[inside].sum() / np.pi) ** 0.5, (V.sum() / np.pi) ** 0.5
pair = disc_materials(False)
p = contact_pressure(pair, "strain", a, R, HEATED)
wave = np.sqrt(1.35 * pair[0]["young"] / pair[0]["density"])

scene = Scene(cloud, pair, "plane strain viscosity 1.0 0.0").add("pair_coeff 1 2 none")
scene.add(f"variable T equal {HEATED}*((step<{STEPS / 2})*step/{STEPS / 2}+(step>={STEPS / 2}))\n"
          "fix heat all tmsph/heat/boundary temperature v_T\n"
          f"fix drag all viscous {2 * pair[0]['density'] * V[0] * wave / RADIUS:.6g}\n"
          "fix move all nve\nfix contact all tmsph/contact\n"
          f"timestep {0.6 * SPACING / wave:.6g}\n"
          "compute p all tmsph/property/atom sxx syy sxy")
scene.thermo("step ke pe f_contact[8] f_contact[10] f_contact[1] f_contact[2] f_contact[6]",
             STEPS // 2)
scene.add(f"run {STEPS}").snapshot("end", "c_p[*]")
run = scene.run()
xx, yy, xy = run.frame("end")("c_p[1] c_p[2] c_p[3]").T
core = r < a - 0.006
ring = p * 2 * np.pi * a

report = Report()
report.below("kinetic/potential energy", run.thermo("KinEng")[-1] / run.thermo("PotEng")[-1], 1e-6)
report.within("sum of the contact forces/exact", run.thermo("f_contact[10]")[-1] / ring, 0.99, 1.01)
report.within("pressure in the core/exact", -0.5 * (xx + yy)[core].mean() / p, 0.975, 1.025)
for k, name in ((1, "x"), (2, "y")):
    report.below(f"net force along {name}/sum of forces",
                 abs(run.thermo(f"f_contact[{k}]")[-1]) / ring, 1e-6)
c, s = cloud.X.T / np.maximum(r, 1e-9)
radial, hoop = c * c * xx + s * s * yy + 2 * c * s * xy, s * s * xx + c * c * yy - 2 * c * s * xy
exact = disc_polar_stress(p, a, R, r, inside)
square = 0.5 * ((radial - exact[0]) ** 2 + (hoop - exact[1]) ** 2) / p**2
report.note("L2 error of the stresses/p", f"{np.average(square, weights=V) ** 0.5:.4f}")
report.finish()
