/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Forces and tractions of opening bonds are the derivatives of their energy;
   turning everything changes nothing.
------------------------------------------------------------------------- */

#include "tmsph_open_bond.h"

#include <gtest/gtest.h>

#include <random>

using namespace TMSPH;

namespace {

/** A particle with some bonds, two of which are open, in any state. */
template <int D> OpenFit<D> some_fit()
{
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> value(-1.0, 1.0);
  const auto vector = [&] {
    Column<D> v;
    for (int k = 0; k < D; k++) v[k] = value(random);
    return v;
  };
  OpenFit<D> fit;
  fit.volume = 0.7;
  fit.lambda = 2.0;
  fit.shear = 1.3;
  fit.chi = 0.4;
  fit.heating = fit.thermal = 0.0;
  SquareMatrix<D> K = SquareMatrix<D>::Zero(), turned;
  turned.setIdentity();
  turned(0, 0) = turned(1, 1) = 0.6;    // turned by 53 degrees, and strained
  turned(1, 0) = 0.8;
  turned(0, 1) = -0.85;
  for (int n = 0; n < 12; n++) {
    FitBond<D> b;
    b.X = vector();
    b.place = n;
    b.weight = 0.5 + 0.4 * value(random);
    b.u = turned * b.X - b.X + 0.05 * vector();
    b.open = n == 3 ? 0.2 : n == 7 ? 0.1 : 0.0;
    b.normal = vector().normalized();
    if (b.normal.dot(b.X) < 0.0) b.normal = -b.normal;
    K += b.weight * b.X * b.X.transpose();
    fit.bonds.push_back(b);
  }
  fit.shape_inverse = K.inverse();
  fit.evaluate(StVenantKirchhoff());
  return fit;
}

template <int D> Column<D> force(const OpenFit<D> &fit, int n)
{
  const auto &b = fit.bonds[n];
  return b.weight * (fit.B_turning * b.X + fit.chi * (b.u - b.open * (fit.rotation * b.normal)));
}

/// central differences of an energy of order 1: truncation h^2, rounding 1e-16/h
constexpr double STEP = 1.0e-5, AGREE = 1.0e-9;

template <int D> void forces_are_derivatives()
{
  const OpenFit<D> fit = some_fit<D>();
  for (size_t n = 0; n < fit.bonds.size(); n++)
    for (int k = 0; k < D; k++) {
      double energy[2];
      for (int side = 0; side < 2; side++) {
        OpenFit<D> moved = fit;
        moved.bonds[n].u[k] += side ? STEP : -STEP;
        moved.evaluate(StVenantKirchhoff());
        energy[side] = moved.energy;
      }
      EXPECT_NEAR(force<D>(fit, n)[k], (energy[1] - energy[0]) / (2.0 * STEP), AGREE);
    }
}

template <int D> void traction_is_derivative()
{
  const OpenFit<D> fit = some_fit<D>();
  for (const int n : {3, 7}) {
    double energy[2];
    for (int side = 0; side < 2; side++) {
      OpenFit<D> moved = fit;
      moved.bonds[n].open += side ? STEP : -STEP;
      moved.evaluate(StVenantKirchhoff());
      energy[side] = moved.energy;
    }
    const auto &b = fit.bonds[n];
    const Eigen::Matrix<double, D, D, Eigen::RowMajor> R = fit.rotation, B = fit.B;
    const double traction = end_traction<D>(R.data(), B.data(), fit.chi, b.X.data(), b.u.data(),
                                            b.normal.data(), b.weight, b.open);
    EXPECT_NEAR(traction, -(energy[1] - energy[0]) / (2.0 * STEP), AGREE);
    const Column<D> X = -b.X, u = -b.u, N = -b.normal;
    EXPECT_EQ(traction,
              end_traction<D>(R.data(), B.data(), fit.chi, X.data(), u.data(), N.data(), b.weight,
                              b.open));
  }
}

/// sum of present bond x force: no torque in whatever state
template <int D> void no_torque()
{
  const OpenFit<D> fit = some_fit<D>();
  Eigen::Vector3d torque = Eigen::Vector3d::Zero();
  double size = 0.0;
  for (size_t n = 0; n < fit.bonds.size(); n++) {
    const Column<D> x = fit.bonds[n].X + fit.bonds[n].u, f = force<D>(fit, n);
    torque += cross<D>(x, f);
    size += x.norm() * f.norm();
  }
  EXPECT_LT(torque.norm(), 1.0e-14 * size);
}

TEST(OpenBond, ForcesAreDerivatives2d)
{
  forces_are_derivatives<2>();
}
TEST(OpenBond, ForcesAreDerivatives3d)
{
  forces_are_derivatives<3>();
}
TEST(OpenBond, TractionIsDerivative2d)
{
  traction_is_derivative<2>();
}
TEST(OpenBond, TractionIsDerivative3d)
{
  traction_is_derivative<3>();
}
TEST(OpenBond, NoTorque2d)
{
  no_torque<2>();
}
TEST(OpenBond, NoTorque3d)
{
  no_torque<3>();
}

}    // namespace
