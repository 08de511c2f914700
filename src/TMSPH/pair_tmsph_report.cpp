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
   when a hundredth of the bonds has gone since, or coefficients or particles
   changed
------------------------------------------------------------------------- */

void PairTMSPH::check_timestep()
{
  const bigint intact = bond_fix->count_bonds(FixTMSPHBond::INTACT);
  const auto [mass, stiffness] = matter();
  const auto other = [](double now, double then) { return std::fabs(now - then) > 1.0e-6 * now; };
  if (coefficients_at_estimate != coefficients || intact < 0.99 * bonds_at_estimate ||
      other(mass, mass_at_estimate) || other(stiffness, stiffness_at_estimate)) {
    stable_dt = stable_timestep();
    if (coefficients_at_estimate != coefficients) intact_dt = stable_dt;
    bonds_at_estimate = intact;
    coefficients_at_estimate = coefficients;
    mass_at_estimate = mass;
    stiffness_at_estimate = stiffness;
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

/* ----------------------------------------------------------------------
   'set' may change masses, volumes and types between runs
   @return the mass of all particles, and the sum of volume times modulus
------------------------------------------------------------------------- */

std::pair<double, double> PairTMSPH::matter() const
{
  double mine[2] = {0.0, 0.0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) {
    mine[0] += atom->rmass[i];
    mine[1] += atom->vfrac[i] * materials[atom->type[i]].elastic.wave_modulus;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  return {all[0], all[1]};
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
