/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told and checked at the start of a run.
------------------------------------------------------------------------- */

#include "tmsph_run_report.h"

#include "comm.h"
#include "domain.h"
#include "error.h"
#include "min.h"
#include "modify.h"
#include "tmsph_doubts.h"
#include "tmsph_report.h"
#include "tmsph_version.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void TMSPHRunReport::begin(const FixTMSPHBond &bonds, const Facts &facts,
                           const std::function<double()> &estimate)
{
  const bool moves = update->whichflag == 1;    // other than a minimization
  const double thickness = bonds.body_thickness();
  const bool changed = inventory.measure(materials, bonds);
  const std::string doubt = changed ? find_doubt(lmp, materials, inventory, thickness) : "";
  if (moves) timestep.check(materials, bonds, participants.bonds_may_break(), doubt, estimate);
  if (!reported) report(bonds, facts);
  reported = true;
  if (changed) inventory.tell(materials, thickness);
  reported_timestep = reported_timestep && !changed;
  if (moves && !reported_timestep && comm->me == 0)
    utils::logmesg(lmp, "  stable time step {:.4g}, {:.2f} of it in use\n", timestep.stable(),
                   update->dt / timestep.stable());
  reported_timestep = reported_timestep || moves;
  if (!doubt.empty()) notes.warn_once(doubt);
  check_groups(lmp, notes);
  if (!facts.expands && participants.bonds_may_break() &&
      !modify->get_fix_by_style("^tmsph/heat").empty())
    notes.warn_once("Temperatures load nothing, because no type expands: add 'expansion alpha' to "
                    "pair_coeff");
  const std::vector<Fix *> fixes = modify->get_fix_list();    // a copy: LAMMPS makes it anew
  for (Fix *fix : fixes)
    if (auto reporter = dynamic_cast<TMSPHReporter *>(fix)) reporter->tell();
}

/* ---------------------------------------------------------------------- */

void TMSPHRunReport::report(const FixTMSPHBond &bonds, const Facts &facts)
{
  const auto [fewest, most] = bonds.family_sizes();
  const bigint intact = bonds.count_bonds(FixTMSPHBond::INTACT);
  const bigint broken = bonds.count_bonds(FixTMSPHBond::BROKEN);
  const bigint cut = bonds.count_bonds(FixTMSPHBond::CUT);
  // intact, but on one line or in one plane
  bigint flat = 0, all_flat;
  for (int i = 0; i < atom->nlocal; i++)
    flat += bonds.count_in(i, FixTMSPHBond::FORMED) >= domain->dimension &&
        *(domain->dimension == 2 ? bonds.layout().constants<2>(i)
                                 : bonds.layout().constants<3>(i)) == 0.0;
  MPI_Allreduce(&flat, &all_flat, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  double bytes = facts.bytes, all_bytes;
  MPI_Allreduce(&bytes, &all_bytes, 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me) return;
  const double natoms = std::max<bigint>(atom->natoms, 1);
  utils::logmesg(lmp,
                 "TMSPH {}: {} bonds, {:.1f} per particle ({} to {}), {} broken, {} cut\n"
                 "  on: {}\n"
                 "  {:.0f} bytes per particle, {} doubles sent per ghost and step besides "
                 "positions\n",
                 VERSION, intact + broken + cut, 2.0 * (intact + broken + cut) / natoms, fewest,
                 most, broken, cut, facts.features, all_bytes / natoms, facts.doubles_per_ghost);
  if (all_flat && !broken && !cut)
    error->warning(FLERR,
                   "{} particles have their neighbors on one {} and carry no stress: bodies "
                   "should be 2 particles thick, better 4",
                   all_flat, domain->dimension == 2 ? "line" : "line or plane");
  const bool may_break = participants.bonds_may_break();
  if (broken && !may_break)    // of an earlier run: a restart has the bonds but not the fix
    error->warning(FLERR,
                   "Bonds have broken before, and now none can: give fix tmsph/hoekbrown "
                   "again after read_restart");
  if (cut && !may_break && !(participants.states_in_contact() >> FixTMSPHBond::CUT & 1u))
    error->warning(FLERR,
                   "The faces of cuts pass through each other: add a fix "
                   "tmsph/contact");
}

/* ---------------------------------------------------------------------- */

void TMSPHRunReport::end()
{
  const int reason = update->whichflag == 2 ? update->minimize->stop_condition : Min::FTOL;
  if (reason == Min::FTOL || reason == Min::ZEROFORCE || reason == Min::TIMEOUT ||
      (reason == Min::ETOL && update->etol > 0.0) ||
      strcmp(update->minimize_style, "tmsph/lbfgs") == 0)
    return;
  notes.warn_once(
      fmt::format("Min_style {} ended with forces of {:.3g}, above the tolerance {:.3g}: use "
                  "'min_style tmsph/lbfgs'",
                  update->minimize_style, std::sqrt(update->minimize->fnorm_sqr()), update->ftol));
}
