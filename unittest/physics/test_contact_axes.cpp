// TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
// Slip and surfaces of contacts in turned axes, and where round-off would have to decide.

#include "tmsph_contact_pair.h"
#include "tmsph_plane_fit.h"

#include <Eigen/Geometry>
#include <gtest/gtest.h>

#include <random>

using namespace TMSPH;

namespace {

using Vector = Eigen::Vector3d;
using Tensor = Eigen::Matrix<double, 3, 3, Eigen::RowMajor>;

class ContactAxes : public ::testing::Test {
 protected:
  std::mt19937_64 engine{43};
  std::normal_distribution<double> normal;
  double random() { return normal(engine); }
  Vector vector() { return {random(), random(), random()}; }
  Eigen::Matrix3d rotation()
  {
    return Eigen::Quaterniond(random(), random(), random(), random())
        .normalized()
        .toRotationMatrix();
  }
};

/// slip of a pair in space after the high end has gone to x, both ends having F - I = H
Vector slip(const Vector &N, const Vector &X, const Vector &x, const Tensor &H, double loose)
{
  static constexpr double REST[9] = {};
  ContactPair pair = {};
  for (int a = 0; a < 3; a++) pair.normal_low[a] = pair.normal_high[a] = N[a];
  pair.loose = loose;
  pair.horizon = 3.0;
  double tangent[2][3];
  tangents(N.data(), REST, N.data(), tangent);
  for (int k = 0; k < 2; k++)
    for (int a = 0; a < 3; a++) pair.origin[k] += tangent[k][a] * X[a];
  const ContactEnd<3> low{REST, REST, REST, H.data(), 0.0, true};
  const ContactEnd<3> high{x.data(), REST, REST, H.data(), 0.0, true};
  const auto s = contact_state<3>(pair, low, high, {}, WendlandC2(), 0.0);
  Vector sum = Vector::Zero();
  for (int k = 0; k < 2; k++) sum += s.slip[k] * Vector(s.tangent[k]);
  return sum;
}

TEST_F(ContactAxes, SlipTurnsAlong)
{
  for (int n = 0; n < 500; n++) {
    const Vector N = vector().normalized(), X = vector(), x = X + 0.1 * vector();
    const Tensor H = 0.1 * Tensor::NullaryExpr([this]() { return random(); });
    const Eigen::Matrix3d Q = rotation();
    const Tensor turned = Q * H * Q.transpose();
    for (double loose : {0.0, 1.0}) {
      const Tensor none = Tensor::Zero();
      const Vector before = slip(N, X, x, loose ? none : H, loose);
      const Vector after = slip(Q * N, Q * X, Q * x, loose ? none : turned, loose);
      EXPECT_LT((after - Q * before).norm(), 1.0e-13 * X.norm());
    }
  }
}

// a body that turns does not slip, and a strained one by no more than its strain
TEST_F(ContactAxes, NoSlipWithoutStrain)
{
  for (int n = 0; n < 100; n++) {
    const Vector N = vector().normalized(), X = vector();
    const Eigen::Matrix3d Q = rotation();
    const Tensor H = Q - Eigen::Matrix3d::Identity();
    EXPECT_LT(slip(N, X, Q * X, H, 0.0).norm(), 1.0e-13 * X.norm());
  }
}

// two loose particles one beside the other along an axis resist slip like any others
TEST_F(ContactAxes, LooseParticlesAlongAnAxis)
{
  const Vector N(1.0, 0.0, 0.0);
  ContactPair pair = {};
  for (int a = 0; a < 3; a++) pair.normal_low[a] = pair.normal_high[a] = N[a];
  pair.loose = 1.0;
  pair.horizon = 3.0;
  static constexpr double REST[9] = {};
  const Vector v(0.0, 0.3, 0.4);
  const ContactEnd<3> low{REST, REST, REST, REST, 0.0, true};
  const ContactEnd<3> high{N.data(), v.data(), REST, REST, 0.0, true};
  const auto s = contact_state<3>(pair, low, high, {}, WendlandC2(), 1.0);
  EXPECT_NEAR(std::hypot(s.slip[0], s.slip[1]), 0.5, 1.0e-14);
}

/// marks of a pair along x: the middles of both with a third particle, from which both have parted
template <int D> void check_third()
{
  for (double sign : {-1.0, 1.0}) {
    Moments<D> marks;
    const double first[3] = {0.4, 0.3 * sign, 0.0}, second[3] = {1.4, 0.3 * sign, 0.0};
    marks.add_point(first);
    marks.add_point(second);
    const double direction[3] = {1.0, 0.0, 0.0};
    double plane[D], centre[D];
    fit_plane<D>(marks, direction, 0.1, plane, centre);
    EXPECT_EQ(plane[0], 1.0);    // not the plane through both particles
  }
}

TEST(PlaneFit, LiesBetweenTheParticles)
{
  check_third<2>();
  check_third<3>();
}

}    // namespace
