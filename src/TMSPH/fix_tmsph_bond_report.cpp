/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told and checked at the start of a run: size, features, their cost
   and the stable time step.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// while bonds break the stable step falls: to 0.45 of the intact one with half of them gone

static constexpr double FRACTURE_MARGIN = 0.45;

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::setup(int /*vflag*/)
{
  check_timestep();
  if (!reported) report();
  reported = true;
}

/* ----------------------------------------------------------------------
   the estimate costs some tens of force evaluations: it is repeated only
   when a hundredth of the bonds has gone since, or the coefficients changed
------------------------------------------------------------------------- */

void FixTMSPHBond::check_timestep()
{
  const bigint intact = count_bonds(INTACT);
  if (coefficients_at_estimate != pair->coefficients_version() ||
      intact < 0.99 * bonds_at_estimate) {
    stable_timestep = pair->stable_timestep();
    bonds_at_estimate = intact;
    coefficients_at_estimate = pair->coefficients_version();
  }
  bool integrates = false;
  for (const auto &fix : modify->get_fix_list()) integrates = integrates || fix->time_integrate;
  if (update->whichflag != 1 || !integrates || update->nsteps == 0) return;
  if (update->dt > stable_timestep)
    error->all(FLERR, "The time step {} is above the stable one, {:.4g}: set 'timestep {:.2g}' or "
                      "less",
               update->dt, stable_timestep, FRACTURE_MARGIN * stable_timestep);
  if (pair->breaks() && update->dt > FRACTURE_MARGIN * stable_timestep && comm->me == 0)
    error->warning(FLERR,
                   "The time step {} may become unstable as bonds break: with fracture keep it "
                   "below {:.2g}",
                   update->dt, FRACTURE_MARGIN * stable_timestep);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::report()
{
  const int nlocal = atom->nlocal;
  int range[2] = {0, 0}, extreme[2];    // minus the smallest family, the largest
  range[0] = nlocal ? -npartner[0] : -MAXSMALLINT;
  for (int i = 0; i < nlocal; i++) {
    range[0] = std::max(range[0], -npartner[i]);
    range[1] = std::max(range[1], npartner[i]);
  }
  MPI_Allreduce(range, extreme, 2, MPI_INT, MPI_MAX, world);
  const bigint intact = count_bonds(INTACT), broken = count_bonds(BROKEN), cut = count_bonds(CUT);
  double bytes = memory_usage() + pair->memory_usage(), all_bytes;
  MPI_Allreduce(&bytes, &all_bytes, 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me) return;
  const double natoms = std::max<bigint>(atom->natoms, 1);
  utils::logmesg(lmp,
                 "TMSPH: {} bonds, {:.1f} per particle ({} to {}), {} broken, {} cut\n"
                 "  on: {}\n"
                 "  {:.0f} bytes per particle, {} doubles sent per ghost and step besides positions\n"
                 "  stable time step {:.4g}, {:.2f} of it in use\n",
                 intact + broken + cut, 2.0 * (intact + broken + cut) / natoms, -extreme[0],
                 extreme[1], broken, cut, pair->features(), all_bytes / natoms,
                 pair->doubles_per_ghost(), stable_timestep, update->dt / stable_timestep);
}
