# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Work of RKL2 against explicit Euler steps at equal error, for the report: a slab of 100,000 particles
whose ends are suddenly hot. Explicit steps are so short that their error is that of the lattice; a few
hundred of them tell their cost. For each number of RKL2 steps it prints the error, and how
many times fewer applications of the operator and how much less time for heat they take."""

from heat_scenes import *

N, TIME, SAMPLE = 316, 0.05, 200


def solve(method, time, steps):
    cloud = slab(N, "square", width=N)
    scene = Heated(cloud, f"{UNIFORM} subcycle {method}",
                   "fix b all tmsph/heat/boundary temperature 1.0")
    T = scene.run_to(time, steps, columns="step f_heat[6] f_heat[8]")
    run = scene.done
    heat = float([line.split("|")[2] for line in run.log.splitlines() if line.startswith("Modify")][0])
    return (rms(T - dirichlet(cloud.X[:, 0], TIME)), run.thermo("f_heat[8]")[-1], heat,
            run.thermo("f_heat[6]")[-1])


_, _, _, stable = solve("rkl2", 1e-9, 1)
_, _, seconds, _ = solve("explicit", SAMPLE * 0.999 * stable, SAMPLE)
seconds *= TIME / stable / SAMPLE
print(f"explicit: {TIME / stable:.0f} sweeps", flush=True)
for steps in (200, 100, 60, 40, 20):
    e, s, t, _ = solve("rkl2", TIME, steps)
    print(f"{steps} steps of RKL2: error {e:.3e}, {TIME / stable / s:.1f} times fewer sweeps, "
          f"{seconds / t:.1f} times less time", flush=True)
