/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat_boundary.h"

#include "atom.h"
#include "error.h"
#include "input.h"
#include "modify.h"
#include "update.h"
#include "variable.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixTMSPHHeatBoundary::FixTMSPHHeatBoundary(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), value(0.0), variable_index(-1)
{
  if (narg < 5) utils::missing_cmd_args(FLERR, "fix tmsph/heat/boundary", error);
  if (!atom->temperature_flag)
    error->all(FLERR, "Fix tmsph/heat/boundary needs an atom style with temperature: atom_style "
                      "tmsph");
  if (strcmp(arg[3], "temperature") != 0)
    error->all(FLERR, "Unknown word '{}' of fix tmsph/heat/boundary: use 'temperature'", arg[3]);
  if (utils::strmatch(arg[4], "^v_"))
    variable = arg[4] + 2;
  else
    value = utils::numeric(FLERR, arg[4], false, lmp);
  for (int iarg = 5; iarg < narg; iarg += 2) {
    if (strcmp(arg[iarg], "place") != 0)
      error->all(FLERR, "Unknown keyword '{}' of fix tmsph/heat/boundary: use 'place'", arg[iarg]);
    if (iarg + 1 >= narg)
      utils::missing_cmd_args(FLERR, "fix tmsph/heat/boundary place", error);
    if (strcmp(arg[iarg + 1], "body") != 0)
      error->all(FLERR, "Unknown value '{}' of fix tmsph/heat/boundary place: use 'body'",
                 arg[iarg + 1]);
  }
  scalar_flag = 1;
  extscalar = 0;
  global_freq = 1;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeatBoundary::setmask()
{
  return PRE_FORCE | MIN_PRE_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::init()
{
  if (variable.empty()) return;
  variable_index = input->variable->find(variable.c_str());
  if (variable_index < 0)
    error->all(FLERR, "Variable {} of fix tmsph/heat/boundary does not exist: define it first",
               variable);
  if (!input->variable->equalstyle(variable_index))
    error->all(FLERR, "Variable {} of fix tmsph/heat/boundary must be of equal style", variable);
}

/* ----------------------------------------------------------------------
   ghosts are set like their owners: nothing needs to be sent
------------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::pre_force(int /*vflag*/)
{
  if (!variable.empty()) {
    modify->clearstep_compute();
    value = input->variable->compute_equal(variable_index);
    modify->addstep_compute(update->ntimestep + 1);
  }
  if (!std::isfinite(value))
    error->all(FLERR,
               "Temperature of fix tmsph/heat/boundary {} is {} on step {}: check variable {}",
               id, value, update->ntimestep, variable);
  for (int i = 0; i < atom->nlocal + atom->nghost; i++)
    if (atom->mask[i] & groupbit) atom->temperature[i] = value;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::setup_pre_force(int vflag)
{
  pre_force(vflag);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeatBoundary::min_pre_force(int vflag)
{
  pre_force(vflag);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHHeatBoundary::compute_scalar()
{
  return value;
}

/* ----------------------------------------------------------------------
   the variable is asked ahead: 1, 2, 4 ... steps, then by bisection
------------------------------------------------------------------------- */

int FixTMSPHHeatBoundary::reach(int most, double largest_change)
{
  if (variable.empty()) return most;
  const bigint now = update->ntimestep;
  const auto within = [&](int steps) {
    update->ntimestep = now + steps;
    modify->clearstep_compute();
    const double then = input->variable->compute_equal(variable_index);
    update->ntimestep = now;
    return std::fabs(then - value) <= largest_change;
  };
  int good = 1, bad = most + 1;
  while (good < most) {
    const int next = good > most / 2 ? most : 2 * good;
    if (!within(next)) {
      bad = next;
      break;
    }
    good = next;
  }
  while (bad - good > 1) {
    const int middle = good + (bad - good) / 2;
    (within(middle) ? good : bad) = middle;
  }
  return std::min(good, most);
}
