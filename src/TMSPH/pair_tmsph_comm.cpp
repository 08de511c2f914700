/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What force evaluations of pair style tmsph send from owners to ghosts.
------------------------------------------------------------------------- */

#include "pair_tmsph.h"

#include "comm.h"
#include "domain.h"
#include "tmsph_sweep.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

int PairTMSPH::doubles_per_ghost() const
{
  const int d = domain->dimension;
  const int rows = d == 2 ? Rows<2>::communicated(on) : Rows<3>::communicated(on);
  return rows + 2 * averaging + (d * d + 1) * coupling;
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::send(decltype(FORCE_ROWS) what)
{
  what_to_send = what;
  const int d = domain->dimension;
  switch (what) {
    case FORCE_ROWS:
      comm_forward = d == 2 ? Rows<2>::communicated(on) : Rows<3>::communicated(on);
      break;
    case STRESS:
      comm_forward = stress_size();
      break;
    case DISPLACEMENT:
      comm_forward = d;
      break;
    case PRESSES:
      comm_forward = pressed_width();
      break;
    case AVERAGE:
      comm_forward = 1;
      break;
    default:
      comm_forward = d * d + 1;
  }
  comm->forward_comm(this);
}

/* ---------------------------------------------------------------------- */

std::pair<double *, int> PairTMSPH::rows_to_send()
{
  const bool two = domain->dimension == 2;
  switch (what_to_send) {
    case FORCE_ROWS:
      return {force_row.data(), two ? Rows<2>::FORCE : Rows<3>::FORCE};
    case STRESS:
      return {stress.data(), stress_size()};
    case PRESSES:
      return {surfaces.rows.data(), pressed_width()};
    case AVERAGE:
      return {exchanged.data(), 1};
    case COUPLING:
      return {coupling_row.data(), comm_forward};
    default:
      return {kinematic.data() + (two ? Rows<2>::U : Rows<3>::U),
              two ? Rows<2>::KINEMATIC : Rows<3>::KINEMATIC};
  }
}

/* ---------------------------------------------------------------------- */

int PairTMSPH::pack_forward_comm(int n, int *list, double *buf, int pbc_flag, int *pbc)
{
  const auto [rows, stride] = rows_to_send();
  for (int i = 0; i < n; i++)
    std::copy_n(rows + (size_t) stride * list[i], comm_forward, buf + (size_t) comm_forward * i);
  if (what_to_send == FORCE_ROWS && box_moves && pbc_flag)
    the_box.add_rate(pbc, n, list, buf + (domain->dimension == 2 ? Rows<2>::V : Rows<3>::V),
                     comm_forward);
  return n * comm_forward;
}

/* ---------------------------------------------------------------------- */

void PairTMSPH::unpack_forward_comm(int n, int first, double *buf)
{
  const auto [rows, stride] = rows_to_send();
  for (int i = 0; i < n; i++)
    std::copy_n(buf + (size_t) comm_forward * i, comm_forward,
                rows + (size_t) stride * (first + i));
}
