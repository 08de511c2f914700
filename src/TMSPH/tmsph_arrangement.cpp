/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Are particles arranged in balance.
------------------------------------------------------------------------- */

#include "tmsph_arrangement.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_collective.h"

#include <Eigen/Core>
#include <algorithm>
#include <cmath>

using namespace LAMMPS_NS;

// In the interior a particle has partners nearly as far as the horizon even on the side with fewer
// of them. Near a surface it has none beyond: those that it lacks are then too far to weigh.

static constexpr double NEARLY = 0.75;

/* ----------------------------------------------------------------------
   2 |sum_j w_ij X_ij| D/(tr K_i) times its spacing
   return false if local particle i is not in the interior of its type
------------------------------------------------------------------------- */

static bool find_imbalance(LAMMPS *lmp, const FixTMSPHBond &bonds, int i, double &imbalance)
{
  const int *const type = lmp->atom->type;
  const int D = lmp->domain->dimension;
  const auto vector = [&](int j) {
    Eigen::Vector3d X;
    bonds.reference_vector(i, j, X.data());
    if (D == 2) X[2] = 0.0;
    return X;
  };
  Eigen::Vector3d moment = Eigen::Vector3d::Zero();
  double trace = 0.0;
  for (const auto &bond : bonds.family(i, FixTMSPHBond::FORMED)) {
    if (type[bond.j] != type[i]) return false;
    const Eigen::Vector3d X = vector(bond.j);
    const double weight = bonds.weight(i, bond.j);
    moment += weight * X;
    trace += weight * X.squaredNorm();
  }
  if (!(trace > 0.0)) return false;
  imbalance = 2.0 * moment.norm() * D / trace * bonds.spacing(i);
  const Eigen::Vector3d fewer = -moment.normalized();
  double farthest = 0.0, reach = 0.0;
  for (const auto &bond : bonds.family(i, FixTMSPHBond::FORMED)) {
    const Eigen::Vector3d X = vector(bond.j);
    farthest = std::max(farthest, fewer.dot(X));
    reach = std::max(reach, X.norm());
  }
  return farthest >= NEARLY * reach;
}

/* ---------------------------------------------------------------------- */

double LAMMPS_NS::interior_imbalance(LAMMPS *lmp, const FixTMSPHBond &bonds, int type)
{
  std::vector<double> imbalances;
  for (int i = 0; i < lmp->atom->nlocal; i++) {
    double one;
    if (lmp->atom->type[i] == type && find_imbalance(lmp, bonds, i, one)) imbalances.push_back(one);
  }
  return TMSPH::median(imbalances, lmp->world);
}
