/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Ghosts while a fix changes the box.
------------------------------------------------------------------------- */

#include "tmsph_box.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix.h"
#include "modify.h"
#include "update.h"

#include <algorithm>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void TMSPHBox::init()
{
  changes = false;
  for (const auto &fix : modify->get_fix_list())
    changes = changes || (fix->box_change & ~Fix::BOX_CHANGE_DOMAIN);
}

/* ---------------------------------------------------------------------- */

bool TMSPHBox::carries_velocities() const
{
  return changes && domain->deform_vremap;
}

/* ----------------------------------------------------------------------
   LAMMPS knows the rate from the start of a run only if it is constant, and not at all in a run of
   no steps: the last one is the best guess then
------------------------------------------------------------------------- */

void TMSPHBox::grow_older(bool in_step)
{
  const double *now = domain->h_rate;
  if (in_step || now[0] != 0.0 || now[1] != 0.0 || now[2] != 0.0) std::copy_n(now, 3, rate);
  if (!in_step || !std::equal(size, size + 3, domain->prd)) age = 0.0;
  if (in_step) age += update->dt;
  std::copy_n(domain->prd, 3, size);
}

/* ----------------------------------------------------------------------
   particles cross the box as it is on this step, which LAMMPS sets at its end
------------------------------------------------------------------------- */

void TMSPHBox::meet_exchange()
{
  if (!carries_velocities()) return;
  grow_older(true);
  for (int k = 0; k < 3; k++) {
    domain->boxlo[k] += age * domain->h_ratelo[k];
    domain->boxhi[k] += age * (domain->h_ratelo[k] + rate[k]);
  }
  domain->set_global_box();
  domain->set_local_box();
  std::copy_n(domain->prd, 3, size);
  age = 0.0;
  exchanged = update->ntimestep;
}

/* ---------------------------------------------------------------------- */

void TMSPHBox::meet_forces()
{
  if (!carries_velocities()) return;
  const bool in_step = update->whichflag == 1 && !update->setupflag;
  if (in_step && exchanged == update->ntimestep) return;
  grow_older(in_step);
  exchanged = -1;
  if (in_step) move_ghosts(age);
}

/* ---------------------------------------------------------------------- */

void TMSPHBox::meet_output()
{
  if (!changes) return;
  const bool behind = carries_velocities() && std::equal(size, size + 3, domain->prd);
  move_ghosts(behind ? age : 0.0);
}

/* ----------------------------------------------------------------------
   into the images of a box as it will be after a time
------------------------------------------------------------------------- */

void TMSPHBox::move_ghosts(double ahead)
{
  double *const length[3] = {&domain->xprd, &domain->yprd, &domain->zprd};
  for (int k = 0; k < 3; k++) *length[k] = domain->prd[k] + ahead * rate[k];
  comm->forward_comm();
  for (int k = 0; k < 3; k++) *length[k] = domain->prd[k];
}

/* ---------------------------------------------------------------------- */

void TMSPHBox::add_rate(const int *pbc, int n, const int *list, double *v, int stride) const
{
  for (int i = 0; i < n; i++, v += stride)
    if (atom->mask[list[i]] & domain->deform_groupbit)
      for (int k = 0; k < domain->dimension; k++) v[k] += pbc[k] * rate[k];
}
