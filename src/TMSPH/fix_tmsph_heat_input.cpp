/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words and report of fix tmsph/heat.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "pair_tmsph.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// scaled time must leave mechanical waves this many passages while heat crosses the body: a load
// that rises over n periods of a vibration excites 1/(pi n) of it (Chopra, Dynamics of Structures,
// Sect. 4.5); a free body has the period of two passages, so here it is 1.3 %

static constexpr double WAVE_PASSAGES = 50.0;

// shorter steps, as parts of the stable one, show that time was not scaled: heat would take a
// thousand of them from a particle to the next. For a warning only

static constexpr double LEAST_STEP = 1.0e-3;

// diffusivities of solids in m2/s: silver has 1.7e-4, plastics have 1e-7; only diamond and graphite
// are above (CRC Handbook of Chemistry and Physics)

static constexpr double LEAST_DIFFUSIVITY = 1.0e-8, MOST_DIFFUSIVITY = 4.0e-4;

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::parse(int narg, char **arg)
{
  TMSPHWords(
      lmp, "fix tmsph/heat",
      {{"conductivity", "I value", [this](TMSPHValues &v) { materials.read_conductivity(v); }},
       {"specific/heat", "I value", [this](TMSPHValues &v) { materials.read_specific_heat(v); }},
       {"source", "I value", [this](TMSPHValues &v) { sources.read(v); }},
       {"contact", "I J h", [this](TMSPHValues &v) { contacts.read(v); }},
       {"friction", "yes/no", [this](TMSPHValues &v) { contacts.set_friction(v.logical()); }},
       {"viscous", "yes/no", [this](TMSPHValues &v) { viscous = v.logical(); }},
       {"subcycle", "way",
        [this](TMSPHValues &v) {
          stepper.set_super_steps(v.one_of<bool>({{"explicit", false}, {"rkl2", true}}));
        }},
       {"time/scale", "S",
        [this](TMSPHValues &v) { time_scale = v.number(TMSPHRule::positive, "must be positive"); }},
       {"every", "N",
        [this](TMSPHValues &v) {
          every = v.integer();
          if (every < 1) v.reject(std::to_string(every), "must be at least 1 step");
        }}})
      .read_all(arg + 3, arg + narg);
  if (viscous && every > 1)
    error->all(FLERR, "Fix tmsph/heat viscous takes the work of each step: remove 'every {}'",
               every);
  materials.check();
}

/* ----------------------------------------------------------------------
   the largest of the types, which the table lists
------------------------------------------------------------------------- */

double FixTMSPHHeat::find_diffusivities(TMSPH::TextTable &table, bool &strange)
{
  const TMSPH::UnitNames unit(update->unit_style);
  double diffusivity = 0.0;
  strange = false;
  for (int type = 1; type <= atom->ntypes; type++) {
    const double largest = materials.conductivity(type).largest() /
        (pair->material(type).density * materials.specific_heat(type).smallest());
    table.add({std::to_string(type), TMSPH::digits(largest)});
    diffusivity = std::max(diffusivity, largest);
    const double metric = unit.square_meters_per_second * largest;
    if (metric == 0.0 || (metric > LEAST_DIFFUSIVITY && metric < MOST_DIFFUSIVITY)) continue;
    if (!strange && pair->plausible(type))
      pair->warn_once(fmt::format(
          "Hardly a solid has a thermal diffusivity of {:.3g} {} as type {}: give fix tmsph/heat "
          "conductivity and specific/heat in the units of the input, in units si W/m/K and J/kg/K",
          largest, unit.diffusivity, type));
    strange = true;
  }
  return diffusivity;
}

/* ----------------------------------------------------------------------
   once, at the first run
------------------------------------------------------------------------- */

void FixTMSPHHeat::tell()
{
  const TMSPH::UnitNames unit(update->unit_style);
  TMSPH::TextTable table({"type", TMSPH::heading("diffusivity", unit.diffusivity)});
  bool strange;
  const double diffusivity = find_diffusivities(table, strange);
  const double step = every * time_scale * update->dt, stable = flows.stable_step();
  if (!told) {
    double bytes = memory_usage(), all_bytes;
    MPI_Allreduce(&bytes, &all_bytes, 1, MPI_DOUBLE, MPI_SUM, world);
    if (comm->me == 0)
      utils::logmesg(lmp,
                     "TMSPH heat: {}, {:.0f} bytes per particle, 1 double sent per ghost and "
                     "stage\n  stable explicit step {:.4g}, heat step {:.4g} every {} steps, "
                     "{:.3g} of it\n{}",
                     stepper.super_steps() ? "RKL2" : "explicit",
                     all_bytes / std::max<bigint>(atom->natoms, 1), stable, step, every,
                     step / stable, table.text());
  }
  told = true;
  if (update->whichflag != 1 || update->nsteps == 0 || strange || !std::isfinite(stable)) return;
  warn_of_time_scale(step, diffusivity);
}

/* ----------------------------------------------------------------------
   one that leaves heat at rest, or waves no time
------------------------------------------------------------------------- */

void FixTMSPHHeat::warn_of_time_scale(double step, double diffusivity)
{
  const double stable = flows.stable_step();
  const double by_the_end = stepper.covered() + update->nsteps * time_scale * update->dt;
  if (step < LEAST_STEP * stable && by_the_end < stable)
    pair->warn_once(fmt::format(
        "Heat is hardly conducted in this run, which covers {:.2g} of the {:.2g} in which it "
        "crosses a spacing: give fix tmsph/heat a 'time/scale' of {:.1g} or more",
        by_the_end, stable, 10.0 * LEAST_STEP * stable / (every * update->dt)));
  bool integrates = false;
  for (const auto &fix : modify->get_fix_list()) integrates = integrates || fix->time_integrate;
  double slowest = HUGE_VAL, size = 0.0;
  for (int type = 1; type <= atom->ntypes; type++)
    slowest = std::min(slowest, PairTMSPH::wave_speed(pair->material(type)));
  for (int k = 0; k < domain->dimension; k++) size = std::max(size, domain->prd[k]);
  const double conduction = size * size / (time_scale * diffusivity), wave = size / slowest;
  if (integrates && conduction < WAVE_PASSAGES * wave)
    pair->warn_once(fmt::format(
        "Heat crosses the body in {:.3g}, waves in {:.3g}: with this time/scale of fix tmsph/heat "
        "inertia matters; keep it below {:.2g}",
        conduction, wave, time_scale * conduction / (WAVE_PASSAGES * wave)));
}
