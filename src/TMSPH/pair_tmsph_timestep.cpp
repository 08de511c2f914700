/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The stable time step of the present state of pair style tmsph.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_tmsph_bond.h"
#include "tmsph_random.h"

#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ----------------------------------------------------------------------
   Velocity Verlet with stiffness K and damping C on masses M is stable while
   dt^2/4 lambda_K + dt/2 lambda_C <= 1, lambda the largest eigenvalue of
   M^-1 K and of M^-1 C. Both come from power iteration: the force sweeps are
   applied to a trial displacement (or velocity) about the present state.
   Power iteration approaches from below; SAFETY covers what is left.
------------------------------------------------------------------------- */

static constexpr int ITERATIONS = 60;
static constexpr double TOLERANCE = 1.0e-3, SAFETY = 1.03;

/* ---------------------------------------------------------------------- */

double PairTMSPH::stable_timestep()
{
  return domain->dimension == 2 ? stable_timestep_in<2>() : stable_timestep_in<3>();
}

/* ---------------------------------------------------------------------- */

template <int D> double PairTMSPH::stable_timestep_in()
{
  using R = Rows<D>;
  const int nlocal = atom->nlocal;
  if (prepared_version != bond_fix->layout_version()) prepare<D>();

  std::vector<double> trial(3 * (size_t) nlocal), at_rest(trial.size()), pushed(trial.size());
  Features elastic = on;
  elastic.viscosity = false;
  Viscosity linear = viscosity;
  linear.alpha2 = 0.0;

  // forces at the present positions plus "step" times the trial displacements

  const auto forces = [&](double step, bool viscous, std::vector<double> &f) {
    update_kinematics<D>();
    for (int i = 0; i < nlocal; i++)
      for (int k = 0; k < D; k++) {
        const double p = step * trial[3 * (size_t) i + k];
        if (viscous)
          force_row[(size_t) i * R::FORCE + R::V + k] = p;
        else
          kinematic[(size_t) i * R::KINEMATIC + R::U + k] += p;
      }
    if (!viscous) send(DISPLACEMENT);
    GradientOutput out;
    out.force_row = force_row.data();
    gradient_sweep<D>(on, slices(), 0, slices().count(), kinematic.data(), out);
    send(FORCE_ROWS);
    f.assign(trial.size(), 0.0);
    force_sweep<D>(viscous ? on : elastic, slices(), linear, kinematic.data(), force_row.data(),
                   f.data());
  };

  const auto largest_eigenvalue = [&](bool viscous) {
    // a linear term takes any step; the elastic one is differentiated with a small one
    const double step = viscous ? 1.0 : 1.0e-6 * cutoff;
    double eigenvalue = 0.0;
    for (int i = 0; i < nlocal; i++)
      for (int k = 0; k < 3; k++)
        trial[3 * (size_t) i + k] =
            k < D ? uniform_random(atom->tag[i], 7919, k) - 0.5 : 0.0;
    forces(0.0, viscous, at_rest);
    for (int iteration = 0; iteration < ITERATIONS; iteration++) {
      // one scale for all: the largest trial component is 1
      double largest = 0.0, all = 0.0;
      for (double p : trial) largest = std::max(largest, std::fabs(p));
      MPI_Allreduce(&largest, &all, 1, MPI_DOUBLE, MPI_MAX, world);
      if (all == 0.0) return 0.0;
      for (double &p : trial) p /= all;
      forces(step, viscous, pushed);
      double product[2] = {0.0, 0.0}, sum[2];    // p.K p and p.M p
      for (int i = 0; i < nlocal; i++)
        for (int k = 0; k < D; k++) {
          const size_t at = 3 * (size_t) i + k;
          const double Kp = (at_rest[at] - pushed[at]) / step;
          product[0] += trial[at] * Kp;
          product[1] += trial[at] * trial[at] * atom->rmass[i];
          trial[at] = Kp / atom->rmass[i];
        }
      MPI_Allreduce(product, sum, 2, MPI_DOUBLE, MPI_SUM, world);
      const double former = eigenvalue;
      eigenvalue = sum[0] / sum[1];
      if (!(std::fabs(eigenvalue - former) > TOLERANCE * std::fabs(eigenvalue))) break;
    }
    return SAFETY * std::fabs(eigenvalue);
  };

  const double stiffness = largest_eigenvalue(false);
  const double damping = on.viscosity ? largest_eigenvalue(true) : 0.0;
  prepared_version = -1;    // the rows hold trial values: fill them anew
  stepped = false;
  if (!(stiffness > 0.0)) return HUGE_VAL;
  return 4.0 / (damping + std::sqrt(damping * damping + 4.0 * stiffness));
}
