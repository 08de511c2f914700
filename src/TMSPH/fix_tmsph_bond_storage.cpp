/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   How bonds are stored, migrate with their particles and enter restarts.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "modify.h"
#include "tmsph_restart.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <cstring>

using namespace LAMMPS_NS;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 6.0;

/* ---------------------------------------------------------------------- */

tagint FixTMSPHBond::known_id(LAMMPS *lmp, int i)
{
  const auto bonds = dynamic_cast<const FixTMSPHBond *>(lmp->modify->get_fix_by_id(ID));
  return bonds ? bonds->owner_tag(i) : lmp->atom->tag[i];
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBond::memory_usage()
{
  return bytes_of_rows() + bytes_of_references() + slices.bytes();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::grow_arrays(int nmax)
{
  grow_rows(nmax);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::keep_velocities()
{
  if (!user || !user->viscous()) return;
  lag.start(atom->nmax);
  for (int i = 0; i < atom->nlocal; i++) {
    const double *taken = user->step_velocity(i);
    for (int k = 0; k < 3; k++) {
      lag[i][k] = !taken ? NAN : k < domain->dimension ? taken[k] : 0.0;
      lag[i][3 + k] = taken ? atom->v[i][k] : NAN;
    }
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::copy_arrays(int i, int j, int /*delflag*/)
{
  copy_row(i, j);
  moves();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::set_arrays(int i)
{
  clear_row(i);
  moves();
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::pack_exchange(int i, double *buf)
{
  return pack_row(i, buf);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::unpack_exchange(int nlocal, double *buf)
{
  moves();
  return unpack_row(nlocal, buf, atom->nmax);
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
  if (!lag.carried()) return v;
  return std::equal(v, v + 3, lag[i] + 3) ? lag[i] : v;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::write_restart(FILE *fp)
{
  update->update_time();    // a run that goes on from the file counts from here: the same round-off
  if (update->whichflag == 1) keep_velocities();    // in a run: those of this step
  if (comm->me) return;
  std::vector<double> list = {RESTART_FORMAT,
                              (double) bonds_formed,
                              (double) row_length(),
                              (double) faced,
                              kappa,
                              thickness,
                              horizon};
  for (int k = 0; k < 3; k++) list.insert(list.end(), {period[k], corner[k]});
  for (int t = 1; t <= atom->ntypes; t++) list.push_back(bonds_formed ? type_horizons[t] : 0.0);
  for (const double one : list_carried()) list.push_back(one);
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::restart(char *buf)
{
  const auto next = [&buf] {
    double one;
    memcpy(&one, buf, sizeof(double));
    buf += sizeof(double);
    return one;
  };
  check_restart_format(error, "pair style tmsph", next(), RESTART_FORMAT);
  bonds_formed = next() != 0.0;
  resize_rows((int) next(), atom->nmax);
  faced = next() != 0.0;
  kappa = next();
  thickness = next();
  horizon = next();
  for (int k = 0; k < 3; k++) {
    period[k] = next();
    corner[k] = next();
  }
  type_horizons.assign(atom->ntypes + 1, horizon);
  for (int t = 1; t <= atom->ntypes; t++) type_horizons[t] = next();
  take_carried(buf, atom->nmax);
  maxexchange = most_of_row();
  for (int i = 0; i < atom->nlocal; i++) set_arrays(i);
  census.take(atom->natoms);
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
  return 1 + row_size(i);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHBond::maxsize_restart()
{
  return 1 + most_of_row();
}
