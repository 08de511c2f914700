/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Is the time step stable, at the start of a run, and when is that asked anew.
------------------------------------------------------------------------- */

#include "tmsph_timestep_check.h"

#include "comm.h"
#include "error.h"
#include "modify.h"
#include "update.h"

#include <cmath>

using namespace LAMMPS_NS;

// while bonds break the stable step falls: to 0.44 of the intact one with half of them or 80
// percent gone, to 0.3 with 90 percent (unittest/stability/timestep.py)

static constexpr double FRACTURE_MARGIN = 0.4;

/* ---------------------------------------------------------------------- */

void TMSPHTimestepCheck::check(const TMSPHMaterials &materials, const FixTMSPHBond &bonds,
                               bool bonds_may_break, const std::string &doubt,
                               const std::function<double()> &estimate)
{
  const bigint intact = bonds.count_bonds(FixTMSPHBond::INTACT);
  const auto [mass, stiffness] = matter(materials);
  // other masses, not only sums in another order; a hundredth of the bonds, as half of them take
  // the step to 0.44, is about 1 % of it
  const auto other = [](double now, double then) { return std::fabs(now - then) > 1.0e-6 * now; };
  if (!estimated || intact < 0.99 * bonds_at_estimate || other(mass, mass_at_estimate) ||
      other(stiffness, stiffness_at_estimate)) {
    stable_dt = estimate();
    if (!estimated) intact_dt = stable_dt;
    estimated = true;
    bonds_at_estimate = intact;
    mass_at_estimate = mass;
    stiffness_at_estimate = stiffness;
  }
  bool integrates = false;
  for (const auto &fix : modify->get_fix_list()) integrates = integrates || fix->time_integrate;
  if (!integrates || update->nsteps == 0) return;
  if (update->dt > stable_dt && !doubt.empty()) error->all(FLERR, "{}", doubt);
  if (update->dt > stable_dt)
    error->all(FLERR,
               "The time step {} is above the stable one, {:.4g}: set 'timestep {:.2g}' or "
               "less",
               update->dt, stable_dt, FRACTURE_MARGIN * stable_dt);
  if (bonds_may_break && update->dt > FRACTURE_MARGIN * intact_dt && comm->me == 0)
    error->warning(FLERR,
                   "The time step {:.4g} may become unstable as bonds break: with fracture keep it "
                   "below {:.4g}",
                   update->dt, FRACTURE_MARGIN * intact_dt);
  if (bonds_may_break && !materials.viscous() && comm->me == 0)
    error->warning(FLERR,
                   "Bonds that break without artificial viscosity can feed energy: add "
                   "'viscosity 1 2' to pair_style tmsph");
}

/* ----------------------------------------------------------------------
   'set' may change masses, volumes and types between runs
   @return the mass of all particles, and the sum of volume times modulus
------------------------------------------------------------------------- */

std::pair<double, double> TMSPHTimestepCheck::matter(const TMSPHMaterials &materials) const
{
  double mine[2] = {0.0, 0.0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    mine[0] += atom->rmass[i];
    mine[1] += atom->vfrac[i] * materials.elastic(i).wave_modulus;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  return {all[0], all[1]};
}
