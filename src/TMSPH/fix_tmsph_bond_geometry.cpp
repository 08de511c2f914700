/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Geometry of the reference bonds: vectors, weights, spacing.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_collective.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::reference_vector(int i, int j, double *X) const
{
  // from the lower id to the higher, so that both ends round alike
  const bool upward = atom->tag[i] < atom->tag[j];
  const double *from = atom->x0[upward ? i : j], *to = atom->x0[upward ? j : i];
  for (int k = 0; k < 3; k++) {
    double d = to[k] - from[k];
    if (period[k] > 0.0) d -= period[k] * std::round(d / period[k]);
    X[k] = upward ? d : -d;
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHBond::reference_in_box(int i, double *X) const
{
  for (int k = 0; k < 3; k++) {
    X[k] = atom->x0[i][k];
    if (period[k] > 0.0) X[k] -= period[k] * std::floor((X[k] - corner[k]) / period[k]);
  }
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBond::reference_distance(int i, int j) const
{
  double X[3];
  reference_vector(i, j, X);
  const double across = domain->dimension == 3 ? X[2] * X[2] : 0.0;
  return std::sqrt(X[0] * X[0] + X[1] * X[1] + across);
}

/* ---------------------------------------------------------------------- */

float FixTMSPHBond::weight(int i, int j) const
{
  return (float) (atom->vfrac[i] * atom->vfrac[j] *
                  TMSPH::kernel_slope(user->kernel_of_bonds(), domain->dimension,
                                      reference_distance(i, j),
                                      user->horizon(atom->type[i], atom->type[j])));
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBond::kernel_mass(int i, int j, double horizon) const
{
  const double R = i == j ? 0.0 : reference_distance(i, j);
  return atom->vfrac[j] *
      TMSPH::kernel_value(user->kernel_of_bonds(), domain->dimension, R, horizon);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBond::spacing(int i) const
{
  return domain->dimension == 3 ? std::cbrt(atom->vfrac[i])
                                : std::sqrt(atom->vfrac[i] / thickness);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHBond::nearest_square(int i) const
{
  double square = HUGE_VAL, X[3];
  for (const auto &bond : family(i, FORMED)) {
    reference_vector(i, bond.j, X);
    const double across = domain->dimension == 3 ? X[2] * X[2] : 0.0;
    square = std::min(square, X[0] * X[0] + X[1] * X[1] + across);
  }
  return square < HUGE_VAL ? square : 0.0;
}

/* ----------------------------------------------------------------------
   In 2-D the volume is an area times the thickness. The area is about the square of
   the distance to the nearest partner: near 1, the thickness is 1.
------------------------------------------------------------------------- */

double FixTMSPHBond::find_thickness() const
{
  static constexpr double NEAR_ONE = 2.5;
  if (domain->dimension == 3) return 1.0;
  std::vector<double> volumes, squares;
  for (int i = 0; i < atom->nlocal; i++) {
    const double nearest = nearest_square(i);
    if (nearest == 0.0) continue;
    volumes.push_back(atom->vfrac[i]);
    squares.push_back(nearest);
  }
  const double square = TMSPH::fixed_point_sum(squares, world);
  const double ratio = square > 0.0 ? TMSPH::fixed_point_sum(volumes, world) / square : 1.0;
  return ratio < NEAR_ONE && ratio > 1.0 / NEAR_ONE ? 1.0 : ratio;
}

/* ----------------------------------------------------------------------
   tr K/D where a particle has all its neighbors
------------------------------------------------------------------------- */

double FixTMSPHBond::largest_kappa() const
{
  const int dimension = domain->dimension;
  double mine = 0.0, all;
  for (int i = 0; i < atom->nlocal; i++) {
    double trace = 0.0, X[3];
    for (const auto &bond : family(i, FORMED)) {
      const int j = bond.j;
      reference_vector(i, j, X);
      for (int c = 0; c < dimension; c++) trace += weight(i, j) * X[c] * X[c];
    }
    mine = std::max(mine, trace / (dimension * atom->vfrac[i]));
  }
  MPI_Allreduce(&mine, &all, 1, MPI_DOUBLE, MPI_MAX, world);
  return all;
}
