# TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
"""Work of RKL2 against explicit Euler steps at equal error, for the report: slabs of 100,000
particles, one whose ends are suddenly hot, one that cools by convection. Two errors are printed:
that of the time steps, against RKL2 steps so many that they have none to speak of, and the whole
one, against the exact solution, with the lattice's. The latter partly cancels that of explicit
steps of the longest stable length, so equal errors are those of the time steps. For each number of
RKL2 steps: how many times fewer applications of the operator and how much less time for heat than
with explicit steps. It takes about ten minutes."""

import sys

import numpy as np

from heat_scenes import SIDES, UNIFORM, Heated, dirichlet, rms, robin, slab

N, MANY = 316, 1600
CASES = {    # time, boundaries, temperature at first, exact solution, numbers of steps
    "Dirichlet": (0.05, "fix b all tmsph/heat/boundary temperature 1.0", 0.0, dirichlet,
                  (200, 140, 100, 60, 40)),
    "Robin": (0.1, SIDES + "fix b right tmsph/heat/boundary convection 2.0 0.0", 1.0,
              lambda x, t: robin(x, t, 2.0), (200, 140, 100, 70, 50)),
}


def solve(case, method, steps):
    """Temperatures, error against the exact ones, applications of the operator, seconds of heat."""
    time, conditions, start, exact, _ = CASES[case]
    cloud = slab(N, "square", width=N)
    scene = Heated(cloud, f"{UNIFORM} subcycle {method}", conditions, start)
    T = scene.run_to(time, steps, columns="step f_heat[8]")
    run = scene.done
    heat = float([line.split("|")[2] for line in run.log.splitlines()
                  if line.startswith("Modify")][0])
    return T, rms(T - exact(cloud.X[:, 0], time)), run.thermo("f_heat[8]")[-1], heat


def longest_step(case):
    """That of explicit steps."""
    scene = Heated(slab(N, "square", width=N), UNIFORM, CASES[case][1])
    return scene.steps(1e-9, 1, "step f_heat[6]").run().thermo("f_heat[6]")[-1]


if __name__ == "__main__":
    for case in sys.argv[1:] or CASES:
        time, *_, numbers = CASES[case]
        lattice, floor, *_ = solve(case, "rkl2", MANY)
        print(f"{case}: {MANY} steps of RKL2: whole error {floor:.3e}", flush=True)
        T, whole, sweeps, seconds = solve(case, "explicit",
                                          int(np.ceil(time / (0.999 * longest_step(case)))))
        print(f"{sweeps:.0f} explicit steps: error {rms(T - lattice):.3e}, whole {whole:.3e}",
              flush=True)
        for steps in numbers:
            T, whole, s, t = solve(case, "rkl2", steps)
            print(f"{steps} steps of RKL2: error {rms(T - lattice):.3e}, whole {whole:.3e}, "
                  f"{sweeps / s:.1f} times fewer sweeps, {seconds / t:.1f} times less time",
                  flush=True)
