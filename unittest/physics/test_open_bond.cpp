/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Forces and tractions of opening bonds are the derivatives of their energy;
   turning everything changes nothing.
------------------------------------------------------------------------- */

#include "tmsph_opening_update.h"

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
    b.partner = -1;
    b.number = n == 3 ? 0 : n == 7 ? 1 : -1;
    b.jump = b.open() ? 0.2 * vector() : Column<D>::Zero().eval();
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
  return b.weight * (fit.B_turning * b.X + fit.chi * (b.u - fit.rotation() * b.jump));
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

template <int D> using RowMajor = Eigen::Matrix<double, D, D, Eigen::RowMajor>;

/// as an end with this fit sees it, turned back
template <int D> Column<D> traction(const OpenFit<D> &fit, const FitBond<D> &b)
{
  const RowMajor<D> R = fit.rotation(), T = fit.back();
  return end_traction<D>(T.data(), fit.chi, b.X, turned_back<D>(R.data(), b.u), b.jump, b.weight);
}

template <int D> void traction_is_derivative()
{
  const OpenFit<D> fit = some_fit<D>();
  for (const int n : {3, 7}) {
    FitBond<D> b = fit.bonds[n];
    const Column<D> found = traction<D>(fit, b);
    for (int k = 0; k < D; k++) {
      double energy[2];
      for (int side = 0; side < 2; side++) {
        OpenFit<D> moved = fit;
        moved.bonds[n].jump[k] += side ? STEP : -STEP;
        moved.evaluate(StVenantKirchhoff());
        energy[side] = moved.energy;
      }
      EXPECT_NEAR(found[k], -(energy[1] - energy[0]) / (2.0 * STEP), AGREE);
    }
    b.X = -b.X;    // as the other end sees it
    b.u = -b.u;
    b.jump = -b.jump;
    EXPECT_EQ(-found, traction<D>(fit, b));
  }
}

/** The two ends of bond 3 open, while nothing moves: no update raises what both fits and the opening
    hold and took, and in the end both ends pull alike, as the law has it.
    @param pressed   the faces are pressed together
    @param free      they carry nothing any more
    @param moving_on updates build on each other, as they do; if not, each lowers the energy */
template <int D> void ends_pull_alike(bool pressed, bool free, bool moving_on = false)
{
  OpenFit<D> fit[2] = {some_fit<D>(), some_fit<D>()};
  auto &mine = fit[0].bonds[3], &his = fit[1].bonds[3];
  his.X = -mine.X;
  his.u = -mine.u;
  for (int n = 0; n < (int) fit[1].bonds.size(); n++)    // another state there
    if (n != 3) fit[1].bonds[n].u *= 0.9;
  OpenBond b;
  b.area = 0.6;
  b.opening.strength = 0.05;
  b.opening.end = 3.0;
  if (free) b.settled = b.opening.most = b.opening.end;
  FollowedBond<D> followed;
  followed.bond = &b;
  followed.X = mine.X;
  followed.weight = mine.weight;
  followed.chi_mine = fit[0].chi;
  followed.chi_his = fit[1].chi;
  followed.c.setZero();
  followed.e.setZero();
  // a bound of the second derivative from the shape matrices: H of an opening is W X.Kbar^-1
  followed.stiffness = 0.0;
  for (const auto &f : fit) {
    const double reach = (f.shape_inverse * mine.X).squaredNorm() * mine.weight;
    followed.stiffness = std::max(
        followed.stiffness,
        mine.weight * (3.0 * f.volume * (f.lambda + 2.0 * f.shear) * reach + f.chi) / b.area);
  }
  RowMajor<D> T[2];
  const auto evaluate = [&](const Column<D> &c, const Column<D> &e) {
    mine.jump = c + e;
    his.jump = e - c;
    for (int p = 0; p < 2; p++) {
      fit[p].evaluate(StVenantKirchhoff());
      T[p] = fit[p].back();
    }
    return fit[0].energy + fit[1].energy +
        b.area *
        (stored_energy(LinearCohesion(), b.opening) +
         dissipated_energy(LinearCohesion(), b.opening));
  };
  const Eigen::Map<const Column<D>> c(b.jump), e(b.uneven);
  const double start = evaluate(c, e);
  followed.mine = fit[0].rotation().transpose() * mine.u;
  followed.his = fit[1].rotation().transpose() * his.u;
  Column<D> normal = (traction<D>(fit[0], mine) - traction<D>(fit[1], his)).normalized();
  if (pressed) {    // half against the pull, half across it
    const Column<D> across = Column<D>::Unit(0) - normal[0] * normal;
    normal = (across.normalized() - normal).normalized();
  }
  std::copy_n(normal.data(), D, b.normal);
  double before = start;
  for (int n = 0; n < 4000; n++) {
    followed.update(LinearCohesion(), T[0].data(), T[1].data());
    if (!moving_on) {
      followed.c = c;
      followed.e = e;
    }
    const double now = evaluate(followed.c, followed.e);
    if (!moving_on) { ASSERT_LE(now, before + 1.0e-14 * std::fabs(before)) << n; }
    before = now;
  }
  EXPECT_LT(evaluate(c, e), start);
  const Column<D> pulls[] = {traction<D>(fit[0], mine), traction<D>(fit[1], his)};
  EXPECT_LT((pulls[0] + pulls[1]).norm(), 1.0e-9);
  EXPECT_GT(e.norm(), 1.0e-3);
  EXPECT_NEAR(c.norm(), b.opening.now, 1.0e-14);
  EXPECT_GT(c.dot(normal), -1.0e-14);
  const Column<D> t = (pulls[0] - pulls[1]) / b.area, along = t - t.dot(normal) * normal;
  if (pressed) {
    EXPECT_NEAR(c.dot(normal), 0.0, 1.0e-14);
    EXPECT_LT(t.dot(normal), 0.0);
  } else {
    EXPECT_NEAR(t.dot(normal), free ? 0.0 : TMSPH::traction(LinearCohesion(), b.opening), 1.0e-9);
    EXPECT_GT(c.dot(normal), 1.0e-3);
  }
  if (free) {
    EXPECT_LT(along.norm(), 1.0e-9);
    EXPECT_GT((c - c.dot(normal) * normal).norm(), 1.0e-3);
  } else {
    EXPECT_NEAR((c - c.dot(normal) * normal).norm(), 0.0, 1.0e-14);
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
TEST(OpenBond, EndsPullAlike2d)
{
  ends_pull_alike<2>(false, false);
  ends_pull_alike<2>(false, true);
}
TEST(OpenBond, EndsPullAlike3d)
{
  ends_pull_alike<3>(false, false);
  ends_pull_alike<3>(false, true);
}
TEST(OpenBond, PressedFacesDoNotPass2d)
{
  ends_pull_alike<2>(true, false);
  ends_pull_alike<2>(true, true);
}
TEST(OpenBond, PressedFacesDoNotPass3d)
{
  ends_pull_alike<3>(true, false);
  ends_pull_alike<3>(true, true);
}
TEST(OpenBond, EndsPullAlikeFaster)
{
  for (const bool pressed : {false, true})
    for (const bool free : {false, true}) {
      ends_pull_alike<2>(pressed, free, true);
      ends_pull_alike<3>(pressed, free, true);
    }
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
