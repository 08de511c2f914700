/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told at the start of a run: size, features, their cost, materials and
   the stable time step. What is checked then besides: pair_tmsph_check.cpp.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "min.h"
#include "modify.h"
#include "tmsph_collective.h"
#include "tmsph_report.h"
#include "tmsph_version.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace TMSPH;

// while bonds break the stable step falls: to 0.44 of the intact one with half of them or 80
// percent gone, to 0.3 with 90 percent (unittest/stability/timestep.py)

static constexpr double FRACTURE_MARGIN = 0.4;

/* ---------------------------------------------------------------------- */

void PairTMSPH::run_begins()
{
  const bool moves = update->whichflag == 1;    // other than a minimization
  const bool changed = measure();
  const std::string doubt = changed ? doubts() : "";
  if (moves) check_timestep(doubt);
  if (!reported) report();
  reported = true;
  if (changed) tell_materials();
  reported_timestep = reported_timestep && !changed;
  if (moves && !reported_timestep && comm->me == 0)
    utils::logmesg(lmp, "  stable time step {:.4g}, {:.2f} of it in use\n", stable_dt,
                   update->dt / stable_dt);
  reported_timestep = reported_timestep || moves;
  if (!doubt.empty()) warn_once(doubt);
  check_groups();
  check_expansion();
  const std::vector<Fix *> fixes = modify->get_fix_list();    // a copy: LAMMPS makes it anew
  for (Fix *fix : fixes)
    if (auto reporter = dynamic_cast<TMSPHReporter *>(fix)) reporter->tell();
}

/* ----------------------------------------------------------------------
   the estimate costs some tens of force evaluations: it is repeated only
   when a hundredth of the bonds has gone since, or coefficients or particles
   changed
   @param doubt what is wrong with a material, if anything: then the time step is not to blame
------------------------------------------------------------------------- */

void PairTMSPH::check_timestep(const std::string &doubt)
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
  if (update->dt > stable_dt && !doubt.empty()) error->all(FLERR, "{}", doubt);
  if (update->dt > stable_dt)
    error->all(FLERR, "The time step {} is above the stable one, {:.4g}: set 'timestep {:.2g}' or "
                      "less",
               update->dt, stable_dt, FRACTURE_MARGIN * stable_dt);
  if (break_test && update->dt > FRACTURE_MARGIN * intact_dt && comm->me == 0)
    error->warning(FLERR,
                   "The time step {:.4g} may become unstable as bonds break: with fracture keep it "
                   "below {:.4g}",
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
    mine[1] += atom->vfrac[i] * elastic(i).wave_modulus;
  }
  MPI_Allreduce(mine, all, 2, MPI_DOUBLE, MPI_SUM, world);
  return {all[0], all[1]};
}

/* ----------------------------------------------------------------------
   numbers, volumes and spacings of the types
   @return true if they or the materials are not those of the last report
------------------------------------------------------------------------- */

bool PairTMSPH::measure()
{
  const int ntypes = atom->ntypes, D = domain->dimension;
  std::vector<bigint> mine(ntypes + 1, 0), count(ntypes + 1);
  for (int i = 0; i < atom->nlocal; i++) mine[atom->type[i]]++;
  MPI_Allreduce(mine.data(), count.data(), ntypes + 1, MPI_LMP_BIGINT, MPI_SUM, world);
  std::vector<Present> types(ntypes + 1);
  bool same = (int) present.size() == ntypes + 1;
  for (int type = 1; type <= ntypes; type++) {
    const Material &m = material(type);
    types[type].particles = count[type];
    types[type].material = {m.young, m.poisson, m.density, m.expansion, horizon(type, type)};
    same = same && types[type].particles == present[type].particles &&
        types[type].material == present[type].material;
  }
  if (same) return false;
  std::vector<double> volumes, distances, cells;
  for (int type = 1; type <= ntypes; type++) {
    volumes.clear(), distances.clear(), cells.clear();
    for (int i = 0; i < atom->nlocal; i++) {
      if (atom->type[i] != type) continue;
      volumes.push_back(atom->vfrac[i]);
      const double square = bond_fix->nearest_square(i);
      if (square == 0.0) continue;
      distances.push_back(std::sqrt(square));
      cells.push_back(std::pow(square, 0.5 * D));
    }
    Present &t = types[type];
    const bigint here = distances.size();
    bigint measured;
    MPI_Allreduce(&here, &measured, 1, MPI_LMP_BIGINT, MPI_SUM, world);
    t.volume = fixed_point_sum(volumes, world);
    if (!measured) continue;
    t.spacing = fixed_point_sum(distances, world) / measured;
    t.cell = fixed_point_sum(cells, world) / measured;
  }
  present = types;
  return true;
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::tell_materials()
{
  if (comm->me) return;
  const UnitNames unit(update->unit_style);
  TextTable table({"type", "particles", heading("spacing", unit.length), "horizon/spacing",
                   heading("E", unit.pressure), "nu", heading("density", unit.density),
                   heading("wave_speed", unit.speed)});
  double volume = 0.0;
  for (int type = 1; type <= atom->ntypes; type++) {
    const Material &m = material(type);
    const Present &t = present[type];
    volume += t.volume;
    const bool known = t.spacing > 0.0;
    table.add({std::to_string(type), std::to_string(t.particles), known ? digits(t.spacing) : "-",
               known ? digits(horizon(type, type) / t.spacing) : "-", digits(m.young),
               digits(m.poisson), digits(m.density), digits(wave_speed(m))});
  }
  const double thickness = bond_fix->body_thickness();
  std::string size = heading("volume", unit.volume) + " " + digits(volume);
  if (domain->dimension == 2)
    size = heading("thickness", unit.length) + " " + digits(thickness) + "  " +
        heading("area", unit.area) + " " + digits(volume / thickness);
  utils::logmesg(lmp, "  {}\n{}", size, table.text());
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::run_ends()
{
  const int reason = update->whichflag == 2 ? update->minimize->stop_condition : Min::FTOL;
  if (reason == Min::FTOL || reason == Min::ZEROFORCE || reason == Min::TIMEOUT ||
      (reason == Min::ETOL && update->etol > 0.0) ||
      strcmp(update->minimize_style, "tmsph/lbfgs") == 0)
    return;
  warn_once(fmt::format("Min_style {} ended with forces of {:.3g}, above the tolerance {:.3g}: use "
                        "'min_style tmsph/lbfgs'", update->minimize_style,
                        std::sqrt(update->minimize->fnorm_sqr()), update->ftol));
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
    flat += bond_fix->count_in(i, FixTMSPHBond::FORMED) >= domain->dimension &&
        *(domain->dimension == 2 ? own_constants<2>(i) : own_constants<3>(i)) == 0.0;
  MPI_Allreduce(&flat, &all_flat, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  double bytes = memory_usage() + bond_fix->memory_usage(), all_bytes;
  MPI_Allreduce(&bytes, &all_bytes, 1, MPI_DOUBLE, MPI_SUM, world);
  if (comm->me) return;
  const double natoms = std::max<bigint>(atom->natoms, 1);
  utils::logmesg(lmp,
                 "TMSPH {}: {} bonds, {:.1f} per particle ({} to {}), {} broken, {} cut\n"
                 "  on: {}\n"
                 "  {:.0f} bytes per particle, {} doubles sent per ghost and step besides "
                 "positions\n",
                 VERSION, intact + broken + cut, 2.0 * (intact + broken + cut) / natoms, fewest,
                 most, broken, cut, features(), all_bytes / natoms, doubles_per_ghost());
  if (all_flat && !broken && !cut)
    error->warning(FLERR, "{} particles have their neighbors on one {} and carry no stress: bodies "
                          "should be 2 particles thick, better 4",
                   all_flat, domain->dimension == 2 ? "line" : "line or plane");
  if (broken && !break_test)    // of an earlier run: a restart has the bonds but not the fix
    error->warning(FLERR, "Bonds have broken before, and now none can: give fix tmsph/hoekbrown "
                          "again after read_restart");
  if (cut && !break_test && !(states_in_contact() >> FixTMSPHBond::CUT & 1u))
    error->warning(FLERR, "The faces of cuts pass through each other: add a fix "
                          "tmsph/contact");
}
