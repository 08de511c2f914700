# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Work of RKL2 against explicit Euler steps at equal error, for the report: a slab of 100,000 particles
whose ends are suddenly hot. Prints, for each number of heat steps, the error, the applications of
the operator, and the time spent on heat, both relative to the explicit run with its longest stable step."""

from heat_scenes import *

N, TIME = 316, 0.005


def solve(method, steps):
    cloud = slab(N, "square", width=N)
    scene = Heated(cloud, f"{UNIFORM} subcycle {method}",
                   "fix b all tmsph/heat/boundary temperature 1.0")
    T = scene.run_to(TIME, steps, columns="step f_heat[6] f_heat[8]")
    run = scene.done
    heat = float([line.split("|")[2] for line in run.log.splitlines() if line.startswith("Modify")][0])
    return (rms(T - dirichlet(cloud.X[:, 0], TIME)), run.thermo("f_heat[8]")[-1], heat,
            run.thermo("f_heat[6]")[-1])


_, _, _, stable = solve("rkl2", 1)
error, sweeps, seconds, _ = solve("explicit", int(np.ceil(TIME / stable * (1 + 1e-9))))
print(f"explicit: error {error:.3e}, {sweeps:.0f} sweeps", flush=True)
for steps in (80, 40, 20, 10, 5):
    e, s, t, _ = solve("rkl2", steps)
    print(f"{steps} steps of RKL2: error {e / error:.3f}, {sweeps / s:.1f} times fewer sweeps, "
          f"{seconds / t:.1f} times less time", flush=True)
