/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Shape matrices: what the sweeps need of a particle besides its bonds.
------------------------------------------------------------------------- */

#include "tmsph_shape.h"

#include <Eigen/Eigenvalues>

namespace TMSPH {

// A shape matrix whose smallest eigenvalue is a smaller part than this of those in the interior of
// the intact body cannot tell strains apart. Bonds add positive semidefinite terms, so that this
// eigenvalue only falls as they break: a particle that has lost its stress never gets it back in a
// state that it reached without. By its own largest eigenvalue it would, when a heavy bond goes.
// In parts of the interior one, in a square lattice with the usual horizon: 0.5 at a straight side,
// 0.25 at a corner, 0.16 of a row with one bond across, 0.05 of two bonds 45 degrees apart; of two
// that are nearly parallel 1e-4.

static constexpr double SINGULAR = 0.02;

template <int D>
void update_shape(Slices &bonds, int q, int l, const double *kinematic, double kappa,
                  const ParticleConstants &m)
{
  using R = Rows<D>;
  const int i = bonds.particle[q * LANES + l];
  const double *mine = kinematic + (size_t) i * R::KINEMATIC + R::X;
  Eigen::Matrix<double, D, D> K = Eigen::Matrix<double, D, D>::Zero();
  for (int b = bonds.offset[q]; b < bonds.offset[q + 1]; b++) {
    const size_t at = (size_t) b * LANES + l;
    const double *his = kinematic + (size_t) bonds.partner[at] * R::KINEMATIC + R::X;
    Eigen::Matrix<double, D, 1> X;
    for (int k = 0; k < D; k++) X[k] = his[k] - mine[k];
    K += (double) bonds.weight[at] * X * X.transpose();
  }
  Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, D, D>> eigen;
  eigen.computeDirect(K, Eigen::EigenvaluesOnly);
  const auto &value = eigen.eigenvalues();
  const bool singular = !(value[0] > SINGULAR * m.volume * kappa);
  double *own = bonds.own.data() + (size_t) q * CONSTANTS<D> * LANES + l;
  Eigen::Matrix<double, D, D> inverse = Eigen::Matrix<double, D, D>::Zero();
  if (!singular) inverse = K.inverse();
  int entry = 0;
  for (int a = 0; a < D; a++)
    for (int b = a; b < D; b++) own[LANES * entry++] = inverse(a, b);
  own[LANES * entry++] = m.volume;
  own[LANES * entry++] = m.lambda;
  own[LANES * entry++] = m.shear;
  own[LANES * entry++] = singular ? 0.0 : m.chi;
}

template void update_shape<2>(Slices &, int, int, const double *, double,
                              const ParticleConstants &);
template void update_shape<3>(Slices &, int, int, const double *, double,
                              const ParticleConstants &);

}    // namespace TMSPH
