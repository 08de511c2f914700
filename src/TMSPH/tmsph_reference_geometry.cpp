/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_reference_geometry.h"

#include "atom.h"
#include "domain.h"
#include "lammps.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// partners are nearer than the horizon, other images at least another horizon away: any number
// between 1 and 2 tells them apart

static constexpr double ROUNDED = 1.01;

/* ---------------------------------------------------------------------- */

void TMSPHReferenceGeometry::reference_vector(int i, int j, double *X) const
{
  const Atom *const atom = lammps->atom;
  // from the lower id to the higher, so that both ends round alike
  const bool upward = atom->tag[i] < atom->tag[j];
  reference_vector(atom->x0[upward ? i : j], atom->x0[upward ? j : i], X);
  if (!upward)
    for (int k = 0; k < 3; k++) X[k] = -X[k];
}

/* ---------------------------------------------------------------------- */

void TMSPHReferenceGeometry::reference_vector(const double *from, const double *to, double *X) const
{
  for (int k = 0; k < 3; k++) {
    X[k] = to[k] - from[k];
    if (period[k] > 0.0) X[k] -= period[k] * std::round(X[k] / period[k]);
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHReferenceGeometry::reference_in_box(int i, double *X) const
{
  for (int k = 0; k < 3; k++) {
    X[k] = lammps->atom->x0[i][k];
    if (period[k] > 0.0) X[k] -= period[k] * std::floor((X[k] - corner[k]) / period[k]);
  }
}

/* ---------------------------------------------------------------------- */

double TMSPHReferenceGeometry::reference_distance(int i, int j) const
{
  double X[3];
  reference_vector(i, j, X);
  const double across = lammps->domain->dimension == 3 ? X[2] * X[2] : 0.0;
  return std::sqrt(X[0] * X[0] + X[1] * X[1] + across);
}

/* ---------------------------------------------------------------------- */

float TMSPHReferenceGeometry::weight(int i, int j) const
{
  const Atom *const atom = lammps->atom;
  return (float) (atom->vfrac[i] * atom->vfrac[j] *
                  TMSPH::kernel_slope(user->kernel_of_bonds(), lammps->domain->dimension,
                                      reference_distance(i, j),
                                      user->horizon(atom->type[i], atom->type[j])));
}

/* ---------------------------------------------------------------------- */

double TMSPHReferenceGeometry::kernel_mass(int i, int j, double horizon) const
{
  const Atom *const atom = lammps->atom;
  const double R = i == j ? 0.0 : reference_distance(i, j);
  return atom->vfrac[j] *
      TMSPH::kernel_value(user->kernel_of_bonds(), lammps->domain->dimension, R, horizon);
}

/* ---------------------------------------------------------------------- */

double TMSPHReferenceGeometry::spacing(int i) const
{
  const double volume = lammps->atom->vfrac[i];
  return lammps->domain->dimension == 3 ? std::cbrt(volume) : std::sqrt(volume / thickness);
}

/* ---------------------------------------------------------------------- */

void TMSPHReferenceGeometry::take_box()
{
  const Domain *const domain = lammps->domain;
  for (int k = 0; k < 3; k++) {
    period[k] = domain->periodicity[k] && k < domain->dimension ? domain->prd[k] : 0.0;
    corner[k] = domain->boxlo[k];
  }
}

/* ---------------------------------------------------------------------- */

void TMSPHReferenceGeometry::place_local()
{
  const Atom *const atom = lammps->atom;
  xref.resize(3 * (size_t) (atom->nlocal + atom->nghost));
  for (int i = 0; i < atom->nlocal; i++) {
    const imageint image = atom->image[i];
    const int turn[3] = {(int) (image & IMGMASK) - IMGMAX,
                         (int) (image >> IMGBITS & IMGMASK) - IMGMAX,
                         (int) (image >> IMG2BITS) - IMGMAX};
    for (int k = 0; k < 3; k++) xref[3 * (size_t) i + k] = atom->x0[i][k] - turn[k] * period[k];
  }
}

/* ---------------------------------------------------------------------- */

int TMSPHReferenceGeometry::pack_references(int n, const int *list, double *buf, int pbc_flag,
                                            const int *pbc) const
{
  int m = 0;
  double shift[3] = {0.0, 0.0, 0.0};
  if (pbc_flag)
    for (int k = 0; k < 3; k++) shift[k] = pbc[k] * period[k];
  for (int ii = 0; ii < n; ii++)
    for (int k = 0; k < 3; k++) buf[m++] = xref[3 * (size_t) list[ii] + k] + shift[k];
  return m;
}

void TMSPHReferenceGeometry::unpack_references(int n, int first, const double *buf)
{
  std::copy(buf, buf + 3 * (size_t) n, xref.begin() + 3 * (size_t) first);
}

/* ---------------------------------------------------------------------- */

bool TMSPHReferenceGeometry::all_placed() const
{
  return xref.size() == 3 * (size_t) (lammps->atom->nlocal + lammps->atom->nghost);
}

/* ----------------------------------------------------------------------
   nearest in the reference frame
------------------------------------------------------------------------- */

int TMSPHReferenceGeometry::find_image(int i, tagint id) const
{
  Atom *const atom = lammps->atom;
  const double *mine = reference(i);
  const double reach = ROUNDED * user->horizon();
  for (int j = atom->map(id); j >= 0; j = atom->sametag[j]) {
    const double *his = reference(j);
    double R2 = 0.0;
    for (int k = 0; k < 3; k++) R2 += (his[k] - mine[k]) * (his[k] - mine[k]);
    if (R2 < reach * reach) return j;
  }
  return -1;
}
