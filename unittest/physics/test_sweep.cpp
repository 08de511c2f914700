/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The sweeps over the bonds on small irregular bodies.
------------------------------------------------------------------------- */

#include "double_loop.h"

#include <gtest/gtest.h>

#include <limits>

using namespace TMSPH;
using namespace TMSPH_TEST;

namespace {

/// everything the sweeps say about a body
template <int D> struct Swept {
  std::vector<double> force, virial, stress, gradient, energy;
  int inverted = -1;

  Swept(const Body<D> &body, const Features &on, double zeta, const Viscosity &viscosity,
        int lanes = LANES)
  {
    Layout<D> layout(body, zeta, lanes);
    const size_t n = body.size();
    force.assign(3 * n, 0.0);
    virial.assign(6 * n, 0.0);
    stress.assign(STRESS_ROW<D> * n, 0.0);
    gradient.assign(D * D * n, 0.0);
    energy.assign(n, 0.0);
    GradientOutput out;
    out.force_row = layout.force_row.data();
    out.stress = stress.data();
    out.gradient = gradient.data();
    out.inverted = &inverted;
    const int half = layout.bonds.count() / 2;    // a range of slices at a time is as good as all
    gradient_sweep<D>(on, layout.bonds, half, layout.bonds.count(), layout.kinematic.data(), out);
    gradient_sweep<D>(on, layout.bonds, 0, half, layout.kinematic.data(), out);
    force_sweep<D>(on, layout.bonds, viscosity, layout.kinematic.data(), layout.force_row.data(),
                   force.data());
    virial_sweep<D>(on, layout.bonds, viscosity, layout.kinematic.data(), layout.force_row.data(),
                    virial.data());
    energy_sweep<D>(on, layout.bonds, layout.kinematic.data(), energy.data());
  }

  Vector<D> f(int i) const { return Eigen::Map<const Vector<D>>(force.data() + 3 * i); }
  Square<D> H(int i) const
  {
    return Eigen::Map<const Eigen::Matrix<double, D, D, Eigen::RowMajor>>(gradient.data() +
                                                                          D * D * i);
  }
  double total_energy() const { return std::accumulate(energy.begin(), energy.end(), 0.0); }
  double largest_force(int n) const
  {
    double largest = 0.0;
    for (int i = 0; i < n; i++) largest = std::max(largest, f(i).norm());
    return largest;
  }
};

/// the symmetric matrix of a row xx yy zz xy xz yz (3-D) or its 2-D subset, with z left out
template <int D> Square<D> symmetric(const double *row, int diagonal)
{
  Square<D> A;
  for (int i = 0, k = diagonal; i < D; i++) {
    A(i, i) = row[i];
    for (int j = i + 1; j < D; j++) A(i, j) = A(j, i) = row[k++];
  }
  return A;
}

template <class Dimension> class Sweep : public ::testing::Test {
 protected:
  static constexpr int D = Dimension::value;

  /// runs fn(features, zeta, viscosity) for every combination of what a scene can switch on
  template <class FN> void for_all_features(FN fn, const std::vector<ElasticLaw> &laws)
  {
    for (const ElasticLaw &law : laws)
      for (auto thermal : {ThermalStrain::NONE, ThermalStrain::BOND, ThermalStrain::CONSTITUTIVE})
        for (bool hourglass : {false, true})
          for (bool viscous : {false, true}) {
            SCOPED_TRACE(::testing::Message()
                         << "law " << law.index() << " thermal " << (int) thermal << " hourglass "
                         << hourglass << " viscosity " << viscous);
            Viscosity viscosity;
            if (viscous) {
              viscosity = {1.0, 2.0, 1.5e-3};
              viscosity.kappa = random_body<D>(1).kappa();
            }
            fn(Features{law, thermal, hourglass, viscous}, hourglass ? 0.3 : 0.0, viscosity);
          }
  }
  const std::vector<ElasticLaw> all = {StVenantKirchhoff(), AlmansiHooke(), NeoHookean()};
  const std::vector<ElasticLaw> hyperelastic = {StVenantKirchhoff(), NeoHookean()};
};

TYPED_TEST_SUITE(Sweep, Dimensions, DimensionName);

// required: affine deformation is reproduced to 1e-13, irregular and broken as the body may be
TYPED_TEST(Sweep, affine_deformation_is_exact)
{
  constexpr int D = TestFixture::D;
  Body<D> body = random_body<D>(1);
  Square<D> H;
  for (int k = 0; k < D * D; k++) H(k / D, k % D) = 0.03 * (k + 1) * (k % 2 ? -1.0 : 1.0);
  for (auto &p : body.p) p.u = H * p.X;
  const Swept<D> swept(body, Features{}, 0.0, {});
  for (int i = 0; i < body.size(); i++) EXPECT_LT((swept.H(i) - H).norm(), 1.0e-13);
  EXPECT_EQ(swept.inverted, -1);
}

// against the plain double loop; required 1e-12, relative to the largest of each quantity
TYPED_TEST(Sweep, equals_the_double_loop)
{
  constexpr int D = TestFixture::D;
  for (const auto &each : kernels()) {
    Body<D> body = random_body<D>(2, each.second);
    body.p[4].singular = body.p[17].singular = true;
    this->for_all_features(
        [&](const Features &on, double zeta, const Viscosity &viscosity) {
          const Swept<D> swept(body, on, zeta, viscosity);
          const Answer<D> exact = double_loop(body, on, zeta, viscosity);
          const double largest = largest_of(exact.force);
          const double stress = largest_of(exact.cauchy), energy = largest_of(exact.energy);
          const double virial = largest_of(exact.virial);
          for (int i = 0; i < body.size(); i++) {
            EXPECT_LT((swept.f(i) - exact.force[i]).norm(), 1.0e-12 * largest) << i;
            const Square<D> F = swept.H(i) + Square<D>::Identity();
            EXPECT_LT((F - exact.F[i]).norm(), 1.0e-12);
            const Square<D> sigma = symmetric<D>(swept.stress.data() + STRESS_ROW<D> * i, D);
            EXPECT_LT((sigma - exact.cauchy[i]).norm(), 1.0e-12 * stress);
            EXPECT_NEAR(swept.energy[i], exact.energy[i], 1.0e-12 * energy);
            EXPECT_LT((symmetric<D>(swept.virial.data() + 6 * i, 3) - exact.virial[i]).norm(),
                      1.0e-12 * virial);
          }
        },
        this->all);
  }
}

// f_ij = -f_ji: no net force, no net torque. Required 1e-14 and 1e-13; also the virial is
// sum x_i f_i, as for any forces that balance.
TYPED_TEST(Sweep, momentum_is_conserved)
{
  constexpr int D = TestFixture::D;
  const Body<D> body = random_body<D>(3);
  this->for_all_features(
      [&](const Features &on, double zeta, const Viscosity &viscosity) {
        const Swept<D> swept(body, on, zeta, viscosity);
        Vector<D> sum = Vector<D>::Zero(), center = sum;
        for (const auto &p : body.p) center += (p.X + p.u) / body.size();
        Square<D> moment = Square<D>::Zero(), virial = moment;
        double forces = 0.0, arms = 0.0;
        for (int i = 0; i < body.size(); i++) {
          const Vector<D> x = body.p[i].X + body.p[i].u - center;
          sum += swept.f(i);
          moment += x * swept.f(i).transpose();
          forces += swept.f(i).norm();
          arms += x.norm() * swept.f(i).norm();
          virial += symmetric<D>(swept.virial.data() + 6 * i, 3);
        }
        ASSERT_GT(forces, 0.0);
        EXPECT_LT(sum.norm() / forces, 1.0e-14);
        EXPECT_LT((moment - moment.transpose()).norm() / arms, 1.0e-13);
        EXPECT_LT((0.5 * (moment + moment.transpose()) - virial).norm() / arms, 1.0e-13);
      },
      this->all);
}

// required 1e-6. The energy is of fourth degree in u: with a step of 1e-5 spacings the truncation
// is 1e-10 of the stiffness, 1e-8 of the forces at a strain of 1e-2. The Almansi law has no energy.
TYPED_TEST(Sweep, forces_are_the_gradient_of_the_energy)
{
  constexpr int D = TestFixture::D;
  for (const auto &each : kernels())
    this->for_all_features(
        [&](const Features &on, double zeta, const Viscosity &) {
          if (on.viscosity) return;
          Body<D> body = random_body<D>(4, each.second, 0.3);
          const Swept<D> swept(body, on, zeta, {});
          const double step = 1.0e-5 * body.spacing, largest = swept.largest_force(body.size());
          Layout<D> layout(body, zeta);
          std::vector<double> energy(body.size());
          for (int i = 0; i < body.size(); i++)
            for (int k = 0; k < D; k++) {
              double &u = layout.kinematic[i * Rows<D>::KINEMATIC + Rows<D>::U + k];
              const double before = u;
              double total[2];
              for (int side : {0, 1}) {
                u = before + (side ? step : -step);
                energy_sweep<D>(on, layout.bonds, layout.kinematic.data(), energy.data());
                total[side] = std::accumulate(energy.begin(), energy.end(), 0.0);
              }
              u = before;
              const double slope = (total[1] - total[0]) / (2.0 * step);
              EXPECT_NEAR(swept.f(i)[k], -slope, 1.0e-6 * largest) << i;
            }
        },
        this->hyperelastic);
}

// A body of two rocks that is heated evenly rests at the stretch 1 + a with the thermal bond, and
// at sqrt(1 + 2 a), where the Green-Lagrange strain is a, with the constitutive form. Round-off
// is measured by the forces that hold the body at its former size.
TYPED_TEST(Sweep, free_expansion_is_free_of_force)
{
  constexpr int D = TestFixture::D;
  const double a = 0.01;
  for (auto thermal : {ThermalStrain::BOND, ThermalStrain::CONSTITUTIVE})
    for (double zeta : {0.0, 0.3}) {
      Body<D> body = random_body<D>(5);
      for (auto &p : body.p) {
        p.thermal = a;
        p.u.setZero();
      }
      const Features on{StVenantKirchhoff(), thermal, zeta > 0.0, false};
      const double held = Swept<D>(body, on, zeta, {}).largest_force(body.size());
      ASSERT_GT(held, 0.0);
      const double stretch = thermal == ThermalStrain::BOND ? 1.0 + a : std::sqrt(1.0 + 2.0 * a);
      for (auto &p : body.p) p.u = (stretch - 1.0) * p.X;
      const Swept<D> swept(body, on, zeta, {});
      EXPECT_LT(swept.largest_force(body.size()), 1.0e-12 * held);
      for (double s : swept.stress) EXPECT_LT(std::fabs(s), 1.0e-12 * 40.0e9 * a);
      EXPECT_LT(swept.total_energy(), 1.0e-20 * 40.0e9 * body.size() * std::pow(1.0e-3, D));
    }
}

// what a particle gets does not depend on who sits beside it in a slice: to the last bit
TYPED_TEST(Sweep, pads_and_slices_do_not_matter)
{
  constexpr int D = TestFixture::D;
  const Body<D> body = random_body<D>(6);
  this->for_all_features(
      [&](const Features &on, double zeta, const Viscosity &viscosity) {
        const Swept<D> full(body, on, zeta, viscosity);
        for (int lanes : {1, 3, 7}) {
          const Swept<D> padded(body, on, zeta, viscosity, lanes);
          EXPECT_EQ(padded.force, full.force);    // false for NaN
          EXPECT_EQ(padded.virial, full.virial);
          EXPECT_EQ(padded.stress, full.stress);
          EXPECT_EQ(padded.gradient, full.gradient);
          EXPECT_EQ(padded.energy, full.energy);
          EXPECT_EQ(padded.inverted, -1);
        }
      },
      this->all);
}

// a particle without bonds, and one whose bonds cannot tell strains apart, stay finite and still
TYPED_TEST(Sweep, particle_without_bonds_feels_nothing)
{
  constexpr int D = TestFixture::D;
  Body<D> body = random_body<D>(7);
  body.W.row(9).setZero();
  body.W.col(9).setZero();
  body.p[9].singular = true;
  this->for_all_features(
      [&](const Features &on, double zeta, const Viscosity &viscosity) {
        const Swept<D> swept(body, on, zeta, viscosity);
        EXPECT_EQ(swept.f(9).norm(), 0.0);
        EXPECT_EQ(swept.inverted, -1);
        for (const auto *list : {&swept.force, &swept.virial, &swept.stress, &swept.energy})
          for (double value : *list) EXPECT_TRUE(std::isfinite(value));
      },
      this->all);
}

// rigid motion: turning the body turns the forces (the hourglass term and the thermal bond too)
TYPED_TEST(Sweep, forces_turn_with_the_body)
{
  constexpr int D = TestFixture::D;
  Square<D> Q = Square<D>::Identity();
  Q.template topLeftCorner<2, 2>() = Eigen::Rotation2Dd(1.0).toRotationMatrix();
  Body<D> body = random_body<D>(8), turned = body;
  for (auto &p : turned.p) {
    p.u = Q * (p.X + p.u) - p.X;
    p.v = Q * p.v;
  }
  this->for_all_features(
      [&](const Features &on, double zeta, const Viscosity &viscosity) {
        const Swept<D> before(body, on, zeta, viscosity), after(turned, on, zeta, viscosity);
        const double largest = before.largest_force(body.size());
        for (int i = 0; i < body.size(); i++)
          EXPECT_LT((after.f(i) - Q * before.f(i)).norm(), 1.0e-12 * largest);    // round-off
      },
      this->all);
}

TYPED_TEST(Sweep, names_a_particle_turned_inside_out)
{
  constexpr int D = TestFixture::D;
  const auto inverted = [](const Body<D> &body) {
    const Layout<D> layout(body, 0.1);
    int which = -1;
    GradientOutput out;
    out.inverted = &which;
    gradient_sweep<D>(Features{}, layout.bonds, 0, layout.bonds.count(), layout.kinematic.data(),
                      out);
    return which;
  };
  Body<D> body = random_body<D>(9);
  EXPECT_EQ(inverted(body), -1);
  for (auto &p : body.p) p.u[0] = -2.0 * p.X[0];
  EXPECT_GE(inverted(body), 0);
  body = random_body<D>(9);
  body.p[12].u[0] = std::numeric_limits<double>::quiet_NaN();
  EXPECT_GE(inverted(body), 0);
}

}    // namespace
