/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Principal stresses against Eigen's iterative solver in the plane, in space against
   those from which a stress in turned axes was made.
------------------------------------------------------------------------- */

#include "tmsph_principal.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <limits>
#include <random>

using namespace TMSPH;

namespace {

const double ROUND_OFF = std::numeric_limits<double>::epsilon();

TEST(Principal, plane)
{
  std::mt19937_64 engine(11);
  std::normal_distribution<double> normal(0.0, 50.0e6);
  for (int k = 0; k < 1000; k++) {
    const double s[3] = {normal(engine), normal(engine), normal(engine)};
    Eigen::Matrix2d A;
    A << s[0], s[2], s[2], s[1];
    const Eigen::Vector2d exact = Eigen::SelfAdjointEigenSolver<Eigen::Matrix2d>(A).eigenvalues();
    const Principals e = principals_2d(s);
    EXPECT_NEAR(e.smallest, exact[0], 10.0 * ROUND_OFF * A.norm());
    EXPECT_NEAR(e.largest, exact[1], 10.0 * ROUND_OFF * A.norm());
    const Invariants m = invariants_2d(s);
    EXPECT_NEAR(m.mean, exact.mean(), 10.0 * ROUND_OFF * A.norm());
    EXPECT_NEAR(m.deviation2, 0.25 * std::pow(exact[1] - exact[0], 2),
                10.0 * ROUND_OFF * A.squaredNorm());
  }
}

// Q diag(values) Q^T with a random rotation Q: right to round-off, equal values too
void check_space(const Eigen::Vector3d &values, std::mt19937_64 &engine)
{
  std::normal_distribution<double> normal;
  Eigen::Quaterniond turn(normal(engine), normal(engine), normal(engine), normal(engine));
  const Eigen::Matrix3d Q = turn.normalized().toRotationMatrix();
  Eigen::Matrix3d A = Q * values.asDiagonal() * Q.transpose();
  A = 0.5 * (A + A.transpose().eval());
  const double s[6] = {A(0, 0), A(1, 1), A(2, 2), A(0, 1), A(0, 2), A(1, 2)};
  Eigen::Vector3d exact = values;
  std::sort(exact.begin(), exact.end());
  const Eigen::Vector3d found = principal_values(s);
  const double tolerance = 20.0 * ROUND_OFF * values.norm();
  for (int k = 0; k < 3; k++) EXPECT_NEAR(found[k], exact[k], tolerance) << values.transpose();
  const Principals e = principals_3d(s);
  EXPECT_NEAR(e.smallest, exact[0], tolerance);
  EXPECT_NEAR(e.largest, exact[2], tolerance);

  // J2 from the principal values, and what the bound of the criterion rests on
  const Invariants m = invariants_3d(s);
  const Eigen::Vector3d deviator = exact.array() - exact.mean();
  const double size = values.squaredNorm();
  EXPECT_NEAR(m.mean, exact.mean(), 10.0 * ROUND_OFF * values.norm());
  EXPECT_NEAR(m.deviation2, 0.5 * deviator.squaredNorm(), 10.0 * ROUND_OFF * size);
  EXPECT_LE(std::pow(exact[2] - exact[0], 2), 4.0 * m.deviation2 + 10.0 * ROUND_OFF * size);
  EXPECT_LE(deviator[2], 2.0 / std::sqrt(3.0) * std::sqrt(m.deviation2) + tolerance);
}

TEST(Principal, space)
{
  std::mt19937_64 engine(12);
  std::normal_distribution<double> normal(0.0, 50.0e6);
  for (int k = 0; k < 1000; k++)
    check_space({normal(engine), normal(engine), normal(engine)}, engine);
}

TEST(Principal, space_with_equal_values)
{
  std::mt19937_64 engine(13);
  std::normal_distribution<double> normal(0.0, 50.0e6);
  for (int k = 0; k < 200; k++) {
    const double p = normal(engine), q = normal(engine);
    check_space({p, p, q}, engine);
    check_space({p, p, p}, engine);
    check_space({p, p * (1.0 + 1.0e-9), q}, engine);
    check_space({0.0, 0.0, p}, engine);
  }
  check_space({0.0, 0.0, 0.0}, engine);
}

}    // namespace
