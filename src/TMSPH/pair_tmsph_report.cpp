/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told and checked at the start of a run: size, features, their cost
   and the stable time step.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "modify.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// while bonds break the stable step falls: to 0.44 of the intact one with half of them or 80
// percent gone, to 0.3 with 90 percent (unittest/stability/timestep.py)

static constexpr double FRACTURE_MARGIN = 0.4;

/* ---------------------------------------------------------------------- */

void PairTMSPH::run_begins()
{
  const bool moves = update->whichflag == 1;    // other than a minimization
  if (moves) check_timestep();
  if (!reported) report();
  reported = true;
  if (!moves || reported_timestep) return;
  reported_timestep = true;
  if (comm->me == 0)
    utils::logmesg(lmp, "  stable time step {:.4g}, {:.2f} of it in use\n", stable_dt,
                   update->dt / stable_dt);
}

/* ----------------------------------------------------------------------
   the estimate costs some tens of force evaluations: it is repeated only
   when a hundredth of the bonds has gone since, or the coefficients changed
------------------------------------------------------------------------- */

void PairTMSPH::check_timestep()
{
  const bigint intact = bond_fix->count_bonds(FixTMSPHBond::INTACT);
  if (coefficients_at_estimate != coefficients || intact < 0.99 * bonds_at_estimate) {
    stable_dt = stable_timestep();
    if (coefficients_at_estimate != coefficients) intact_dt = stable_dt;
    bonds_at_estimate = intact;
    coefficients_at_estimate = coefficients;
  }
  bool integrates = false;
  for (const auto &fix : modify->get_fix_list()) integrates = integrates || fix->time_integrate;
  if (!integrates || update->nsteps == 0) return;
  if (update->dt > stable_dt)
    error->all(FLERR, "The time step {} is above the stable one, {:.4g}: set 'timestep {:.2g}' or "
                      "less",
               update->dt, stable_dt, FRACTURE_MARGIN * stable_dt);
  if (break_test && update->dt > FRACTURE_MARGIN * intact_dt && comm->me == 0)
    error->warning(FLERR,
                   "The time step {} may become unstable as bonds break: with fracture keep it "
                   "below {:.2g}",
                   update->dt, FRACTURE_MARGIN * intact_dt);
  if (break_test && !on.viscosity && comm->me == 0)
    error->warning(FLERR, "Bonds that break without artificial viscosity can feed energy: add "
                          "'viscosity 1 2' to pair_style tmsph");
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::report()
{
  const auto [fewest, most] = bond_fix->family_sizes();
  const bigint intact = bond_fix->count_bonds(FixTMSPHBond::INTACT);
  const bigint broken = bond_fix->count_bonds(FixTMSPHBond::BROKEN);
  const bigint cut = bond_fix->count_bonds(FixTMSPHBond::CUT);
  // intact, but on one line or in one plane
  bigint flat = 0, all_flat;
  for (int i = 0; i < atom->nlocal; i++)
    flat += bond_fix->count_formed(i) >= domain->dimension &&
        *(domain->dimension == 2 ? own_constants<2>(i) : own_constants<3>(i)) == 0.0;
  MPI_Allreduce(&flat, &all_flat, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  double bytes = memory_usage() + bond_fix->memory_usage(), all_bytes;
  MPI_Allreduce(&bytes, &all_bytes, 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me) return;
  const double natoms = std::max<bigint>(atom->natoms, 1);
  utils::logmesg(lmp,
                 "TMSPH: {} bonds, {:.1f} per particle ({} to {}), {} broken, {} cut\n"
                 "  on: {}\n"
                 "  {:.0f} bytes per particle, {} doubles sent per ghost and step besides "
                 "positions\n",
                 intact + broken + cut, 2.0 * (intact + broken + cut) / natoms, fewest, most,
                 broken, cut, features(), all_bytes / natoms, doubles_per_ghost());
  if (all_flat && !broken && !cut)
    error->warning(FLERR, "{} particles have their neighbors on one {} and carry no stress: bodies "
                          "should be 2 particles thick, better 4",
                   all_flat, domain->dimension == 2 ? "line" : "line or plane");
  if (cut && !break_test && !(states_in_contact() >> FixTMSPHBond::CUT & 1u))
    error->warning(FLERR, "The faces of cuts pass through each other: add a fix "
                          "tmsph/contact");
}
