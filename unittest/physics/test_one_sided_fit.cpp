/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Gradients fitted to neighbors on one side: exact for linear fields, and nearer
   than a linear fit for quadratic ones, where the ridge leaves a part of its error;
   the same in turned axes.
------------------------------------------------------------------------- */

#include "tmsph_one_sided_fit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace TMSPH;

namespace {

constexpr double SIZE = 1.0e-3, HORIZON = 3.015;

/// jittered lattice points within the horizon of the origin, above it; weights fall to 0 there
template <int D> struct HalfSpace {
  Eigen::Matrix<double, D, Eigen::Dynamic> X, g;
  std::vector<double> weight;

  explicit HalfSpace(double jitter)
  {
    std::mt19937_64 engine(11);
    std::uniform_real_distribution<double> random(-jitter, jitter);
    std::vector<Eigen::Matrix<double, D, 1>> points;
    for (int n = 0; n < std::pow(7, D); n++) {
      Eigen::Matrix<double, D, 1> p;
      for (int a = 0, rest = n; a < D; a++, rest /= 7) p[a] = rest % 7 - 3;
      if (p[D - 1] < 0.0 || p.isZero(0.0)) continue;
      for (int a = 0; a < D; a++) p[a] += random(engine);
      if (p.norm() >= HORIZON) continue;
      points.push_back(p * SIZE);
      weight.push_back(std::pow(1.0 - p.norm() / HORIZON, 3));
    }
    X.resize(D, points.size());
    for (size_t j = 0; j < points.size(); j++) X.col(j) = points[j];
  }

  template <class Field> Eigen::Matrix<double, D, D> gradient(const Field &u) const
  {
    Eigen::Matrix<double, D, D> H = Eigen::Matrix<double, D, D>::Zero();
    for (int j = 0; j < X.cols(); j++) H += u(X.col(j)) * g.col(j).transpose();
    return H;
  }

  /// of the linear fit with the same weights: the limit of an infinite ridge
  template <class Field> Eigen::Matrix<double, D, D> linear(const Field &u) const
  {
    Eigen::Matrix<double, D, D> K = Eigen::Matrix<double, D, D>::Zero(), A = K;
    for (int j = 0; j < X.cols(); j++) {
      const double w = weight[j] * X.col(j).squaredNorm();
      K += w * X.col(j) * X.col(j).transpose();
      A += w * u(X.col(j)) * X.col(j).transpose();
    }
    return A * K.inverse();
  }
};

template <int D> void check_linear()
{
  const Eigen::Matrix<double, D, D> exact = Eigen::Matrix<double, D, D>::Random();
  for (double jitter : {0.0, 0.2}) {
    HalfSpace<D> half(jitter);
    ASSERT_TRUE(one_sided_fit<D>(half.X, half.weight, SIZE, half.g));
    const auto H = half.gradient([&](const auto &X) { return (exact * X).eval(); });
    EXPECT_LT((H - exact).norm(), 1.0e-13 * exact.norm());
  }
}

template <int D> void check_quadratic()
{
  HalfSpace<D> half(0.0);
  ASSERT_TRUE(one_sided_fit<D>(half.X, half.weight, SIZE, half.g));
  // strain across the surface changes with depth, as beside an inclusion
  const auto u = [](const Eigen::Matrix<double, D, 1> &X) {
    Eigen::Matrix<double, D, 1> value = Eigen::Matrix<double, D, 1>::Zero();
    value[0] = X[0] * X[D - 1] / SIZE;
    value[D - 1] = X[D - 1] * X[D - 1] / SIZE;
    return value;
  };
  EXPECT_LT(half.gradient(u).norm(), half.linear(u).norm());
}

/// the multipliers of turned neighbors are the turned ones
template <int D> void check_turned(const Eigen::Matrix<double, D, D> &Q)
{
  HalfSpace<D> half(0.2), turned(0.2);
  turned.X = Q * half.X;
  ASSERT_TRUE(one_sided_fit<D>(half.X, half.weight, SIZE, half.g));
  ASSERT_TRUE(one_sided_fit<D>(turned.X, turned.weight, SIZE, turned.g));
  EXPECT_LT((turned.g - Q * half.g).norm(), 1.0e-13 * half.g.norm());
}

}    // namespace

TEST(OneSidedFit, TurnsWithTheNeighbors)
{
  for (double angle : {0.3, 0.7, 1.9}) {
    check_turned<2>(Eigen::Rotation2Dd(angle).toRotationMatrix());
    const Eigen::Vector3d axis = Eigen::Vector3d(1.0, -2.0, 3.0 * angle).normalized();
    check_turned<3>(Eigen::AngleAxisd(angle, axis).toRotationMatrix());
  }
}

TEST(OneSidedFit, LinearFieldsAreExact)
{
  check_linear<2>();
  check_linear<3>();
}

TEST(OneSidedFit, QuadraticFieldsAreNearerThanByALinearFit)
{
  check_quadratic<2>();
  check_quadratic<3>();
}

TEST(OneSidedFit, NeighborsOnALineAreRefused)
{
  Eigen::Matrix<double, 2, Eigen::Dynamic> X(2, 3), g;
  X << 1, 2, -1, 1, 2, -1;
  EXPECT_FALSE(one_sided_fit<2>(X, {1.0, 1.0, 1.0}, 1.0, g));
}
