/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   How fix tmsph/heat keeps flat faces: for the particles near them only, as most are
   inside of the body. They migrate with their particles and enter restarts, and
   after an exchange of particles those of the ghosts are behind the own ones.
------------------------------------------------------------------------- */

#include "fix_tmsph_heat.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"

#include <algorithm>

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::layer_size() const
{
  return domain->dimension == 2 ? Layer<2>::SIZE : Layer<3>::SIZE;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::faces_size() const
{
  return domain->dimension * layer_size();
}

/* ----------------------------------------------------------------------
   nullptr: it has none
------------------------------------------------------------------------- */

const double *FixTMSPHHeat::faces_of(int i) const
{
  return face_row[i] == NONE ? nullptr : &faces[(size_t) face_row[i] * faces_size()];
}

/* ----------------------------------------------------------------------
   near a local or ghost particle; a layer that it has is above 0
------------------------------------------------------------------------- */

int FixTMSPHHeat::count_faces(int i) const
{
  const double *row = faces_of(i);
  int count = 0;
  while (row && count < domain->dimension && row[count * layer_size() + domain->dimension] > 0.0)
    count++;
  return count;
}

/* ----------------------------------------------------------------------
   @return zeros to be filled
------------------------------------------------------------------------- */

double *FixTMSPHHeat::make_faces(int i)
{
  const size_t before = faces.size();
  face_row[i] = before / faces_size();
  faces.resize(before + faces_size(), 0.0);
  return &faces[before];
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::drop_all_faces()
{
  std::fill(face_row.begin(), face_row.end(), (int) NONE);
  faces.clear();
}

/* ----------------------------------------------------------------------
   leaves those of local particles, in their order
------------------------------------------------------------------------- */

void FixTMSPHHeat::tidy_faces()
{
  std::vector<double> before;
  before.swap(faces);
  std::vector<int> where(face_row.begin(), face_row.begin() + atom->nlocal);
  std::fill(face_row.begin(), face_row.end(), (int) NONE);
  const int size = faces_size();
  for (int i = 0; i < atom->nlocal; i++)
    if (where[i] != NONE) std::copy_n(&before[(size_t) where[i] * size], size, make_faces(i));
}

/* ----------------------------------------------------------------------
   layer k of local or ghost particle i
------------------------------------------------------------------------- */

template <int D> Layer<D> FixTMSPHHeat::layer(int i, int k) const
{
  Layer<D> found;
  found.take(faces_of(i) + k * Layer<D>::SIZE);
  return found;
}

template Layer<2> FixTMSPHHeat::layer(int, int) const;
template Layer<3> FixTMSPHHeat::layer(int, int) const;

/* ----------------------------------------------------------------------
   Completes the faces of local particles by those of ghosts. Only a body on a lattice has some, and
   more than one at edges only.
------------------------------------------------------------------------- */

void FixTMSPHHeat::share_layers()
{
  tidy_faces();
  int mine = 0, most;
  for (int i = 0; i < atom->nlocal; i++) mine = std::max(mine, count_faces(i));
  MPI_Allreduce(&mine, &most, 1, MPI_INT, MPI_MAX, world);
  faced = most > 0;
  for (face_sent = 0; face_sent < most; face_sent++) comm->forward_comm(this, layer_size());
  face_sent = NONE;
  faces.shrink_to_fit();
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::pack_forward_comm(int n, int *list, double *buf, int /*pbc_flag*/, int * /*pbc*/)
{
  if (face_sent == NONE) return ghosts.pack(n, list, buf);
  const int size = layer_size();
  for (int k = 0; k < n; k++) {
    const double *row = faces_of(list[k]);
    if (row)
      std::copy_n(row + face_sent * size, size, buf + k * size);
    else
      std::fill_n(buf + k * size, size, 0.0);
  }
  return n * size;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::unpack_forward_comm(int n, int first, double *buf)
{
  if (face_sent == NONE) return ghosts.unpack(n, first, buf);
  const int size = layer_size();
  for (int i = first; i < first + n; i++, buf += size) {
    if (!(buf[domain->dimension] > 0.0)) continue;
    if (face_sent == 0) make_faces(i);
    std::copy_n(buf, size, &faces[(size_t) face_row[i] * faces_size() + face_sent * size]);
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::grow_arrays(int nmax)
{
  face_row.reserve(nmax);    // and no more
  face_row.resize(nmax, NONE);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::copy_arrays(int i, int j, int /*delflag*/)
{
  face_row[j] = face_row[i];
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::set_arrays(int i)
{
  face_row[i] = NONE;
}

/* ----------------------------------------------------------------------
   number of faces, then each
------------------------------------------------------------------------- */

int FixTMSPHHeat::pack_exchange(int i, double *buf)
{
  const int count = count_faces(i);
  buf[0] = count;
  if (count) std::copy_n(faces_of(i), count * layer_size(), buf + 1);
  return 1 + count * layer_size();
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::unpack_exchange(int nlocal, double *buf)
{
  const int count = (int) buf[0];
  face_row[nlocal] = NONE;
  if (count) std::copy_n(buf + 1, count * layer_size(), make_faces(nlocal));
  return 1 + count * layer_size();
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);    // LAMMPS wants the length first
  return 1 + pack_exchange(i, buf + 1);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHHeat::unpack_restart(int nlocal, int nth)
{
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(*extra);
  unpack_exchange(nlocal, extra + 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::size_restart(int i)
{
  return 2 + count_faces(i) * layer_size();
}

/* ---------------------------------------------------------------------- */

int FixTMSPHHeat::maxsize_restart()
{
  return 1 + maxexchange;
}
