/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is measured in the bonds as they form: distances, thickness, the interior.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_collective.h"

#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

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
