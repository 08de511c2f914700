# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""A heated inclusion that is not bonded to its ring turns by five spacings against it, with
friction: far more than the horizon, so that all pairs at the interface are new ones at the
end. The surface of both is given as a region. The torque is that of friction on the present
normal force, and the normal force stays what it was: turned, the two still fit.

The rim of the ring is held, and the ring damped: against a constant friction it would squeal."""

import numpy as np

from tmsph_testing import Scene, disc_materials, lattice, main

INCLUSION, RADIUS, SPACING, HEATED, SLIP = 0.015, 0.030, 1e-3, 100.0, 5
HEATING, TURNING = 3000, 9000    # steps

cells = (2 * int(RADIUS / SPACING) + 4, 2 * int(RADIUS / SPACING / 3**0.5) + 4)
cloud = lattice("hex", cells, SPACING, centre=True)
cloud.X += [0.25 * SPACING, 0.25 * 3**0.5 * SPACING]    # a particle in the centre
cloud = cloud.kept(lambda X: np.linalg.norm(X, axis=1) <= RADIUS)
cloud.type[np.linalg.norm(cloud.X, axis=1) > INCLUSION] = 2
pair = disc_materials(False)
wave = np.sqrt(1.35 * pair[0]["young"] / pair[0]["density"])
step = 0.4 * SPACING / wave
spin = SLIP * SPACING / INCLUSION / (TURNING * step)
drag = f"viscous {2 * pair[0]['density'] * cloud.volume[0] * wave / RADIUS:.6g}"


def turn(report, friction):
    scene = Scene(cloud, pair, "plane strain viscosity 2.0 0.0").add("pair_coeff 1 2 none")
    scene.add(f"""region interface sphere 0 0 0 {INCLUSION} units box
region core sphere 0 0 0 {INCLUSION - 4 * SPACING} units box
region rim sphere 0 0 0 {RADIUS - 2 * SPACING} side out units box
group inclusion type 1
group ring type 2
group core region core
group rim region rim
group rest subtract all core rim
variable T equal {HEATED / HEATING}*(step<{HEATING})*step+{HEATED}*(step>={HEATING})
fix heat all tmsph/heat/boundary temperature v_T
fix drag all {drag}
fix move all nve
fix contact all tmsph/contact friction * * {friction} surface interface
timestep {step:.6g}
run {HEATING}
unfix contact
unfix move
unfix drag
variable vx atom {-spin:.17g}*y
variable vy atom {spin:.17g}*x
velocity inclusion set v_vx v_vy NULL
fix drag ring {drag}
fix move rest nve
fix turn core move rotate 0 0 0 0 0 1 {2 * np.pi / spin:.17g}
fix hold rim move linear 0 0 0
fix contact all tmsph/contact friction * * {friction} surface interface""")
    scene.thermo("step f_contact[6] f_contact[10]", TURNING // 36).add(f"run {TURNING}")
    run = scene.run()
    torque, normal = run.thermo("f_contact[6]"), run.thermo("f_contact[10]")
    sliding = slice(7, None)    # after a spacing of slip
    radius = INCLUSION
    ratio = -torque[sliding] / (friction * normal[sliding] * radius)
    report.within(f"friction {friction}: least torque/exact", ratio.min(), 0.97, 1.03)
    report.within(f"friction {friction}: largest torque/exact", ratio.max(), 0.97, 1.03)
    drift = normal[sliding] / normal[7] - 1
    report.within(f"friction {friction}: least change of the normal force", drift.min(),
                  -0.01, 0.01)
    report.within(f"friction {friction}: largest", drift.max(), -0.01, 0.01)


def turned(report):
    for friction in (0.6, 0.3):
        turn(report, friction)


if __name__ == "__main__":
    main(turned)
