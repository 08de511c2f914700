# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Work of RKL2 against explicit Euler steps at equal error, for the report: slabs of 100,000 particles,
one whose ends are suddenly hot, one that cools by convection. Explicit steps are so short that their
error is that of the lattice; some of them tell their cost. For each number of RKL2 steps it
prints the error, and how many times fewer applications of the operator and how much less time for
heat they take."""

from heat_scenes import *

N, SAMPLE = 316, 100
CASES = {    # time, boundaries, temperature at first, exact solution, numbers of steps
    "Dirichlet": (0.05, "fix b all tmsph/heat/boundary temperature 1.0", 0.0, dirichlet,
                  (200, 140, 100, 60)),
    "Robin": (0.1, SIDES + "fix b right tmsph/heat/boundary convection 2.0 0.0", 1.0,
              lambda x, t: robin(x, t, 2.0), (200, 100, 50)),
}


def solve(case, method, time, steps):
    _, conditions, start, exact, _ = CASES[case]
    cloud = slab(N, "square", width=N)
    scene = Heated(cloud, f"{UNIFORM} subcycle {method}", conditions, start)
    T = scene.run_to(time, steps, columns="step f_heat[6] f_heat[8]")
    run = scene.done
    heat = float([line.split("|")[2] for line in run.log.splitlines() if line.startswith("Modify")][0])
    return (rms(T - exact(cloud.X[:, 0], time)), run.thermo("f_heat[8]")[-1], heat,
            run.thermo("f_heat[6]")[-1])


for case in sys.argv[1:] or CASES:
    time, *_, numbers = CASES[case]
    stable = solve(case, "rkl2", 1e-9, 1)[3]
    seconds = solve(case, "explicit", SAMPLE * 0.999 * stable, SAMPLE)[2] * time / stable / SAMPLE
    print(f"{case}: {time / stable:.0f} explicit steps", flush=True)
    for steps in numbers:
        e, s, t, _ = solve(case, "rkl2", time, steps)
        print(f"{steps} steps of RKL2: error {e:.3e}, {time / stable / s:.1f} times fewer sweeps, "
              f"{seconds / t:.1f} times less time", flush=True)
