/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_break_events.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "fix_tmsph_bond.h"
#include "tmsph_materials.h"
#include "update.h"

#include <cmath>
#include <cstring>
#include <numeric>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   under uniform stress in the interior f_ij = 2 W_ij/kappa sigma X_ij, and half of f u' is
   the energy; summed over all bonds this is the strain energy of the body
------------------------------------------------------------------------- */

double TMSPHBreakEvents::strain_energy(const TMSPHMaterials &materials, const FixTMSPHBond &bonds,
                                       int i, int k, const double *stress) const
{
  const int D = domain->dimension, j = bonds.partner_index(i, k);
  double X[3], work = 0.0;
  bonds.reference_vector(i, j, X);
  const int row[3][3] = {{0, D, D + 1}, {D, 1, D + 2}, {D + 1, D + 2, 2}};
  const double young = materials.elastic(i).young + materials.elastic(j).young;
  const double theta = (materials.thermal_push(i) + materials.thermal_push(j)) / young;
  for (int a = 0; a < D; a++) {
    const double u = (atom->x[j][a] - bonds.reference(j)[a]) -
        (atom->x[i][a] - bonds.reference(i)[a]) - theta * X[a];
    for (int b = 0; b < D; b++) work += u * stress[row[a][b]] * X[b];
  }
  return bonds.weight(i, j) * work / bonds.interior_kappa();
}

/* ---------------------------------------------------------------------- */

void TMSPHBreakEvents::record(const FixTMSPHBond &bonds, int i, int k, double energy, Mode mode)
{
  const int j = bonds.partner_index(i, k);
  broken[mode]++;
  broken_now++;
  double X[3];
  bonds.reference_vector(i, j, X);
  const double R = std::sqrt(X[0] * X[0] + X[1] * X[1] + X[2] * X[2]);
  const double time = update->atime + (update->ntimestep - update->atimestep) * update->dt;
  Event event;
  double *c = event.column;
  *c++ = atom->tag[i];
  *c++ = atom->tag[j];
  *c++ = update->ntimestep;
  *c++ = time;
  for (int a = 0; a < 3; a++) *c++ = 0.5 * (atom->x[i][a] + atom->x[j][a]);
  for (int a = 0; a < 3; a++) *c++ = X[a] / R;
  *c++ = mode + 1;
  *c++ = energy;
  *c++ = 0.5 * (atom->temperature[i] + atom->temperature[j]);
  events.push_back(event);
}

/* ----------------------------------------------------------------------
   rows that are known stay unless the events have moved
------------------------------------------------------------------------- */

double **TMSPHBreakEvents::table()
{
  if (!event_rows.empty() && event_rows[0] != events[0].column) event_rows.clear();
  while (event_rows.size() < events.size()) event_rows.push_back(events[event_rows.size()].column);
  return event_rows.data();
}

/* ---------------------------------------------------------------------- */

bigint TMSPHBreakEvents::total(Mode mode) const
{
  bigint all;
  MPI_Allreduce(&broken[mode], &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  return all;
}

/* ---------------------------------------------------------------------- */

double TMSPHBreakEvents::total_now() const
{
  const double mine = broken_now;
  double all;
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_SUM, world);
  return all;
}

/* ----------------------------------------------------------------------
   LAMMPS counts the bytes of a record in an int; beyond that, at some 20 million events, the table
   starts anew.
------------------------------------------------------------------------- */

void TMSPHBreakEvents::gather(std::vector<double> &list) const
{
  const int nprocs = comm->nprocs;
  const int mine = COLUMNS * events.size();
  std::vector<int> sizes(nprocs), starts(nprocs, 0);
  MPI_Allgather(&mine, 1, MPI_INT, sizes.data(), 1, MPI_INT, world);
  const bigint all = std::accumulate(sizes.begin(), sizes.end(), bigint(0));
  const bool fits = (list.size() + nprocs + all) * sizeof(double) < MAXSMALLINT;
  for (const int size : sizes) list.push_back(fits ? size / COLUMNS : 0);
  if (!fits) return;
  std::partial_sum(sizes.begin(), sizes.end() - 1, starts.begin() + 1);
  const size_t head = list.size();
  list.resize(head + (comm->me ? 0 : all));
  MPI_Gatherv(events.data(), mine, MPI_DOUBLE, list.data() + head, sizes.data(), starts.data(),
              MPI_DOUBLE, 0, world);
}

/* ---------------------------------------------------------------------- */

void TMSPHBreakEvents::restart(const double *totals, int nprocs, const char *list)
{
  for (const Mode mode : {TENSION, SHEAR}) broken[mode] = comm->me == 0 ? (bigint) totals[mode] : 0;
  std::vector<double> counts(nprocs);
  memcpy(counts.data(), list, counts.size() * sizeof(double));
  list += counts.size() * sizeof(double);
  for (int proc = 0; proc < nprocs; proc++) {
    const size_t known = events.size(), more = (size_t) counts[proc];
    if (proc % comm->nprocs == comm->me) {
      events.resize(known + more);
      if (more) memcpy(&events[known], list, more * sizeof(Event));
    }
    list += more * sizeof(Event);
  }
}
