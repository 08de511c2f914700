/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Displacement gradient at a particle that has neighbors on one side only.

   A linear fit gives the gradient at the middle of the neighbors, some 0.4
   spacings away, where stresses at an interface have already changed. Here
   second derivatives are fitted along, held down by a ridge, since the few
   neighbors hardly tell them from the gradient.

   Nothing here depends on the axes: with the factor sqrt(2) before the mixed
   products the coefficients turn like vectors of the same length, so that one
   ridge for all of them is a multiple of |grad grad u|^2, and the moments have the
   same eigenvalues in all axes.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_ONE_SIDED_FIT_H
#define LMP_TMSPH_ONE_SIDED_FIT_H

#include <Eigen/Dense>
#include <vector>

namespace TMSPH {

/** Weight of the ridge, in means of the diagonal moments of the second derivatives. 0 reads the
    hoop stress of the inner ring of the heated disc as 1.02 of the exact one but scatters,
    infinity is the linear fit with 0.944; 0.2 reads 0.994 (unittest/verification/test_disc.py). */
constexpr double RIDGE = 0.2;
/// neighbors whose moments have a smaller ratio of eigenvalues do not span the space: at sides and
/// corners of lattices it is above 0.01, of a row and one more at the horizon 6e-4, of a row 0
constexpr double SINGULAR = 1.0e-6;

/** Multipliers g_j of the fit: H = sum_j u_j g_j^T. Exact for linear u, whatever the ridge.
    @param X      vectors to the neighbors, n columns
    @param weight of each neighbor, before its factor |X|^2/size^2
    @param size   length to scale with, the spacing
    @param g      n columns
    @return false if the neighbors do not span the space; g is then not usable */
template <int D>
bool one_sided_fit(const Eigen::Matrix<double, D, Eigen::Dynamic> &X,
                   const std::vector<double> &weight, double size,
                   Eigen::Matrix<double, D, Eigen::Dynamic> &g)
{
  constexpr int SECOND = D * (D + 1) / 2, ALL = D + SECOND;
  constexpr double MIXED = 1.4142135623730951;    // sqrt(2)
  const int n = X.cols();
  Eigen::Matrix<double, ALL, Eigen::Dynamic> P(ALL, n);
  Eigen::Matrix<double, ALL, ALL> M = Eigen::Matrix<double, ALL, ALL>::Zero();
  Eigen::VectorXd w(n);
  for (int j = 0; j < n; j++) {
    for (int a = 0, k = D; a < D; a++) {
      P(a, j) = X(a, j) / size;
      for (int b = a; b < D; b++)
        P(k++, j) = (a == b ? 1.0 : MIXED) * X(a, j) * X(b, j) / (size * size);
    }
    w[j] = weight[j] * P.col(j).template head<D>().squaredNorm();
    M += w[j] * P.col(j) * P.col(j).transpose();
  }
  const double ridge = RIDGE * M.template bottomRightCorner<SECOND, SECOND>().trace() / SECOND;
  for (int k = D; k < ALL; k++) M(k, k) += ridge;
  const Eigen::SelfAdjointEigenSolver<Eigen::Matrix<double, ALL, ALL>> eigen(
      M, Eigen::EigenvaluesOnly);
  const auto &value = eigen.eigenvalues();
  if (eigen.info() != Eigen::Success || !(value[0] > SINGULAR * value[ALL - 1])) return false;
  const Eigen::Matrix<double, ALL, Eigen::Dynamic> solved = M.ldlt().solve(P);
  g = solved.template topRows<D>() * w.asDiagonal() / size;
  return true;
}

}    // namespace TMSPH
#endif
