/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   How bonds are stored, migrate with their particles and enter restarts.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "memory.h"
#include "tmsph_restart.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 3.0;

/* ---------------------------------------------------------------------- */

double FixTMSPHBond::memory_usage()
{
  const double nmax = atom->nmax;
  return nmax * (sizeof(int) + 2 * sizeof(tagint) + maxpartner * (sizeof(tagint) + 1.0)) +
      (lag ? nmax * 6 * sizeof(double) : 0.0) + xref.capacity() * sizeof(double) + slices.bytes();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::grow_arrays(int nmax)
{
  memory->grow(npartner, nmax, "tmsph/bond:npartner");
  memory->grow(own_tag, nmax, "tmsph/bond:own_tag");
  memory->grow(first_tag, nmax, "tmsph/bond:first_tag");
  memory->grow(partner, nmax, maxpartner, "tmsph/bond:partner");
  memory->grow(state, nmax, maxpartner, "tmsph/bond:state");
  if (lag) memory->grow(lag, nmax, 6, "tmsph/bond:lag");
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::keep_velocities()
{
  if (!user || !user->viscous()) return;
  if (!lag) memory->create(lag, atom->nmax, 6, "tmsph/bond:lag");
  for (int i = 0; i < atom->nlocal; i++) {
    const double *taken = user->step_velocity(i);
    for (int k = 0; k < 3; k++) {
      lag[i][k] = !taken ? NAN : k < domain->dimension ? taken[k] : 0.0;
      lag[i][3 + k] = taken ? atom->v[i][k] : NAN;
    }
  }
}

/* ----------------------------------------------------------------------
   new row length; what was stored is lost
------------------------------------------------------------------------- */

void FixTMSPHBond::resize_partners(int length)
{
  maxpartner = length;
  maxexchange = 3 + 2 * maxpartner + 6;
  memory->destroy(partner);
  memory->destroy(state);
  memory->create(partner, atom->nmax, maxpartner, "tmsph/bond:partner");
  memory->create(state, atom->nmax, maxpartner, "tmsph/bond:state");
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::copy_arrays(int i, int j, int /*delflag*/)
{
  npartner[j] = npartner[i];
  own_tag[j] = own_tag[i];
  first_tag[j] = first_tag[i];
  std::copy(partner[i], partner[i] + npartner[i], partner[j]);
  std::copy(state[i], state[i] + npartner[i], state[j]);
  if (lag) std::copy(lag[i], lag[i] + 6, lag[j]);
  laid_out = false;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::set_arrays(int i)
{
  npartner[i] = 0;
  own_tag[i] = first_tag[i] = 0;
  if (lag) std::fill(lag[i], lag[i] + 6, NAN);
  laid_out = false;
}

/* ----------------------------------------------------------------------
   own ids, number of bonds, then id and state of each, then the velocities
------------------------------------------------------------------------- */

int FixTMSPHBond::pack_exchange(int i, double *buf)
{
  int m = 0;
  buf[m++] = ubuf(own_tag[i]).d;
  buf[m++] = ubuf(first_tag[i]).d;
  buf[m++] = ubuf(npartner[i]).d;
  for (int k = 0; k < npartner[i]; k++) {
    buf[m++] = ubuf(partner[i][k]).d;
    buf[m++] = ubuf((int) state[i][k]).d;
  }
  if (lag)
    for (int k = 0; k < 6; k++) buf[m++] = lag[i][k];
  return m;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::unpack_exchange(int nlocal, double *buf)
{
  int m = 0;
  own_tag[nlocal] = (tagint) ubuf(buf[m++]).i;
  first_tag[nlocal] = (tagint) ubuf(buf[m++]).i;
  npartner[nlocal] = (int) ubuf(buf[m++]).i;
  for (int k = 0; k < npartner[nlocal]; k++) {
    partner[nlocal][k] = (tagint) ubuf(buf[m++]).i;
    state[nlocal][k] = (unsigned char) ubuf(buf[m++]).i;
  }
  if (lag)
    for (int k = 0; k < 6; k++) lag[nlocal][k] = buf[m++];
  laid_out = false;
  return m;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::post_run()
{
  keep_velocities();
  user->run_ends();
}

/* ---------------------------------------------------------------------- */

const double *FixTMSPHBond::setup_velocity(int i) const
{
  const double *v = atom->v[i];
  if (!lag) return v;
  return std::equal(v, v + 3, lag[i] + 3) ? lag[i] : v;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::write_restart(FILE *fp)
{
  update->update_time();    // a run that goes on from the file counts from here: the same round-off
  if (update->whichflag == 1) keep_velocities();    // in a run: those of this step
  if (comm->me) return;
  std::vector<double> list = {RESTART_FORMAT,          (double) bonds_formed, (double) maxpartner,
                              (double) (lag != nullptr), (double) faced,        period[0],
                              period[1],                 period[2],             corner[0],
                              corner[1],                 corner[2],             kappa,
                              thickness,                 horizon};
  const size_t first = list.size() - 1;
  list.resize(first + 1 + atom->ntypes);
  for (int t = 1; bonds_formed && t <= atom->ntypes; t++) list[first + t] = type_horizons[t];
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::restart(char *buf)
{
  std::vector<double> list(14 + atom->ntypes);
  memcpy(list.data(), buf, sizeof(double));
  check_restart_format(error, "pair style tmsph", list[0], RESTART_FORMAT);
  memcpy(list.data(), buf, list.size() * sizeof(double));
  bonds_formed = list[1] != 0.0;
  resize_partners((int) list[2]);
  if (list[3] != 0.0) memory->create(lag, atom->nmax, 6, "tmsph/bond:lag");
  faced = list[4] != 0.0;
  for (int k = 0; k < 3; k++) {
    period[k] = list[5 + k];
    corner[k] = list[8 + k];
  }
  kappa = list[11];
  thickness = list[12];
  horizon = list[13];
  type_horizons.assign(list.begin() + 13, list.end());
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
  particles = atom->natoms;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::pack_restart(int i, double *buf)
{
  // LAMMPS wants the length first
  buf[0] = size_restart(i);
  return 1 + pack_exchange(i, buf + 1);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::unpack_restart(int nlocal, int nth)
{
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(*extra);
  unpack_exchange(nlocal, extra + 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::size_restart(int i)
{
  return 4 + 2 * npartner[i] + (lag ? 6 : 0);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::maxsize_restart()
{
  return 4 + 2 * maxpartner + (lag ? 6 : 0);
}
