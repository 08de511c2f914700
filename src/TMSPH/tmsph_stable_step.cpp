/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The stable time step about a state, by power iteration on its forces.
------------------------------------------------------------------------- */

#include "tmsph_stable_step.h"

#include <algorithm>
#include <cmath>

namespace TMSPH {

/* ----------------------------------------------------------------------
   Velocity Verlet with stiffness K and damping C on masses M (viscous forces
   see the velocity of half a step before) is stable while the largest
   eigenvalue of M^-1 (dt^2/4 K + dt/2 C) is at most 1. Power iteration: the
   force sweeps are applied to a trial displacement about the present state,
   with 2/dt times that as the velocity, and dt follows the eigenvalue.
   Power iteration approaches from below; SAFETY covers what is left: the
   largest stable step is 1 to 1.05 of that of whole bodies, 1 to 1.1 of that of
   broken ones (unittest/stability/timestep.py). TOLERANCE ends it after 13 to 46
   of the ITERATIONS in the examples.
------------------------------------------------------------------------- */

static constexpr int ITERATIONS = 60;
static constexpr double TOLERANCE = 1.0e-3, SAFETY = 1.03;

/* ----------------------------------------------------------------------
   one scale for all: the longest trial vector is 1
   @return false if they are all 0
------------------------------------------------------------------------- */

static bool scale(std::vector<double> &trial, int D, MPI_Comm world)
{
  double largest = 0.0, all = 0.0;
  for (size_t i = 0; i < trial.size(); i += D) {
    double square = 0.0;
    for (int k = 0; k < D; k++) square += trial[i + k] * trial[i + k];
    largest = std::max(largest, std::sqrt(square));
  }
  MPI_Allreduce(&largest, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  if (all == 0.0) return false;
  for (double &p : trial) p /= all;
  return true;
}

/* ---------------------------------------------------------------------- */

double stable_step(std::vector<double> trial, int D, const double *mass, double length, double dt,
                   MPI_Comm world, const TrialForces &forces)
{
  std::vector<double> at_rest, pushed;
  forces(trial, 0.0, dt, at_rest);
  for (int iteration = 0; iteration < ITERATIONS; iteration++) {
    if (!scale(trial, D, world)) {
      dt = HUGE_VAL;
      break;
    }
    forces(trial, length, dt, pushed);
    double product[2] = {0.0, 0.0}, sum[2];    // p.A p and p.M p, A = dt^2/4 K + dt/2 C
    for (size_t at = 0; at < trial.size(); at++) {
      const double m = mass[at / D];
      const double Ap = 0.25 * dt * dt * (at_rest[at] - pushed[at]) / length;
      product[0] += trial[at] * Ap;
      product[1] += trial[at] * trial[at] * m;
      trial[at] = Ap / m;
    }
    MPI_Allreduce(product, sum, 2, MPI_DOUBLE, MPI_SUM, world);
    const double eigenvalue = std::fabs(sum[0] / sum[1]);
    dt /= std::sqrt(eigenvalue);
    if (!(std::fabs(eigenvalue - 1.0) > TOLERANCE)) break;
  }
  return dt / std::sqrt(SAFETY);
}

}    // namespace TMSPH
