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

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ----------------------------------------------------------------------
   Velocity Verlet with stiffness K and damping C on masses M (viscous forces
   see the velocity of half a step before) is stable while the largest
   eigenvalue of M^-1 (dt^2/4 K + dt/2 C) is at most 1. Power iteration: the
   force sweeps are applied to a trial displacement about the present state,
   with 2/dt times that as the velocity, and dt follows the eigenvalue.
   Power iteration approaches from below; SAFETY covers what is left.
------------------------------------------------------------------------- */

static constexpr int ITERATIONS = 60;
static constexpr double TOLERANCE = 1.0e-3, SAFETY = 1.03;

/* ----------------------------------------------------------------------
   random multiples of the bonds, which turn along with the body; partners of broken ones may be out
   of reach, on how many processors decides
------------------------------------------------------------------------- */

static std::vector<double> trial_displacements(const FixTMSPHBond &bonds, const Atom &atom, int D)
{
  std::vector<double> trial(D * (size_t) atom.nlocal);
  for (int i = 0; i < atom.nlocal; i++)
    for (int n = 0; n < bonds.count(i); n++) {
      if (bonds.bond_state(i, n) != FixTMSPHBond::INTACT) continue;
      double X[3];
      bonds.reference_vector(i, bonds.partner_index(i, n), X);
      const double part = uniform_random(atom.tag[i], 7919, bonds.partner_tag(i, n)) - 0.5;
      for (int k = 0; k < D; k++) trial[D * (size_t) i + k] += part * X[k];
    }
  return trial;
}

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

  std::vector<double> trial = trial_displacements(*bond_fix, *atom, D);
  std::vector<double> at_rest(trial.size()), pushed(trial.size());

  // the velocities that the last step took may be wanted yet

  std::vector<double> velocities(on.viscosity ? (size_t) D * nlocal : 0);
  for (size_t i = 0; i < velocities.size() / D; i++)
    std::copy_n(force_row.data() + i * R::FORCE + R::V, D, velocities.data() + D * i);
  box_moves = false;
  const double step = 1.0e-6 * horizon();
  const Material &first = material(1);
  double dt = horizon() / std::sqrt(first.elastic.wave_modulus / first.density);    // to begin with
  Viscosity linear = viscosity;
  linear.alpha2 = 0.0;

  // forces when the particles are displaced by "push" times the trial vector

  const auto forces = [&](double push, std::vector<double> &f) {
    update_kinematics<D>();
    for (int i = 0; i < nlocal; i++)
      for (int k = 0; k < D; k++) {
        const double p = push * trial[D * (size_t) i + k];
        kinematic[(size_t) i * R::KINEMATIC + R::U + k] += p;
        force_row[(size_t) i * R::FORCE + R::V + k] = 2.0 / dt * p;
      }
    send(DISPLACEMENT);
    GradientOutput out;
    out.force_row = force_row.data();
    if (averaging) {
      gradient.resize((size_t) D * D * nlocal);
      out.gradient = gradient.data();
    }
    gradient_sweep<D>(on, slices(), 0, slices().count(), kinematic.data(), out);
    if (averaging) {
      find_pressures<D>();
      complete_rows<D>();
    }
    send(FORCE_ROWS);
    f.assign(trial.size(), 0.0);
    bond_forces<D>(linear, f.data(), D);
  };

  forces(0.0, at_rest);
  for (int iteration = 0; iteration < ITERATIONS; iteration++) {
    // one scale for all: the longest trial vector is 1
    double largest = 0.0, all = 0.0;
    for (size_t i = 0; i < trial.size(); i += D) {
      double square = 0.0;
      for (int k = 0; k < D; k++) square += trial[i + k] * trial[i + k];
      largest = std::max(largest, std::sqrt(square));
    }
    MPI_Allreduce(&largest, &all, 1, MPI_DOUBLE, MPI_MAX, world);
    if (all == 0.0) {
      dt = HUGE_VAL;
      break;
    }
    for (double &p : trial) p /= all;
    forces(step, pushed);
    double product[2] = {0.0, 0.0}, sum[2];    // p.A p and p.M p, A = dt^2/4 K + dt/2 C
    for (int i = 0; i < nlocal; i++)
      for (int k = 0; k < D; k++) {
        const size_t at = D * (size_t) i + k;
        const double Ap = 0.25 * dt * dt * (at_rest[at] - pushed[at]) / step;
        product[0] += trial[at] * Ap;
        product[1] += trial[at] * trial[at] * atom->rmass[i];
        trial[at] = Ap / atom->rmass[i];
      }
    MPI_Allreduce(product, sum, 2, MPI_DOUBLE, MPI_SUM, world);
    const double eigenvalue = std::fabs(sum[0] / sum[1]);
    dt /= std::sqrt(eigenvalue);
    if (!(std::fabs(eigenvalue - 1.0) > TOLERANCE)) break;
  }
  for (size_t i = 0; i < velocities.size() / D; i++)
    std::copy_n(velocities.data() + D * i, D, force_row.data() + i * R::FORCE + R::V);
  update_kinematics<D>();    // the work of viscosity may be asked for yet
  return dt / std::sqrt(SAFETY);
}
