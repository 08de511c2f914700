// TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
// Forces of a contact and the moments that bonds have to balance are the derivatives of its energy,
// by the positions and by the gradients of both ends: so they neither make energy nor angular
// momentum.

#include "tmsph_contact_pair.h"

#include <Eigen/Dense>
#include <gtest/gtest.h>

#include <random>

using namespace TMSPH;

namespace {

class ContactCouples : public ::testing::Test {
 protected:
  std::mt19937_64 engine{44};
  std::normal_distribution<double> normal;
  template <int Rows, int Columns> Eigen::Matrix<double, Rows, Columns> random(double size)
  {
    return size *
        Eigen::Matrix<double, Rows, Columns>::NullaryExpr([this]() { return normal(engine); });
  }
  template <int D> void derivative(const Eigen::Matrix<double, D, D> &F);
};

template <int D> using Vector = Eigen::Matrix<double, D, 1>;
template <int D> using Square = Eigen::Matrix<double, D, D, Eigen::RowMajor>;

/// a pair that is pressed and has slipped; the high end is at x, the low end has the gradient F
template <int D>
ContactState<D> state(const ContactPair &pair, const Vector<D> &x, const Square<D> &F,
                      bool high_bears)
{
  static constexpr double REST[9] = {};
  const Square<D> H = F - Square<D>::Identity();
  return contact_state<D>(pair, {REST, REST, REST, H.data(), 0.0, true},
                          {x.data(), REST, REST, high_bears ? H.data() : REST, 0.0, high_bears}, {},
                          WendlandC2(), 0.0);
}

template <int D> void ContactCouples::derivative(const Eigen::Matrix<double, D, D> &gradient)
{
  const Square<D> F = gradient;
  const Vector<D> N = random<D, 1>(1.0).normalized();
  ContactPair pair = {};
  std::copy_n(N.data(), D, pair.normal_low);
  std::copy_n(N.data(), D, pair.normal_high);
  pair.distance = 1.0;
  pair.stiffness = 1.0;
  pair.shear_ratio = 0.4;
  pair.friction = 1.0e9;
  pair.horizon = 3.0;
  const Vector<D> x = F * N * 0.9 + random<D, 1>(0.2);
  for (const bool high_bears : {false, true}) {
    const ContactState<D> s = state<D>(pair, x, F, high_bears);
    if (!(s.penetration > 0.0)) return;
    const auto energy = [&](const Vector<D> &at, const Square<D> &G) {
      const ContactState<D> moved = state<D>(pair, at, G, high_bears);
      double sum = moved.penetration * moved.penetration;
      for (const double slip : moved.slip) sum += pair.shear_ratio * slip * slip;
      return 0.5 * moved.stiffness * sum;
    };

    Vector<D> f;
    ContactPast past = {};
    double heat = 0.0;
    contact_force<D>(CONTACT_LAWS[1], pair, s, 1.0, 0.0, f.data(), past, heat);
    Square<D> tilt = Square<D>::Zero();
    add_tilt<D>(1.0, f.data(), s.r, s.normal, tilt.data());    // of one end, or of both
    constexpr double STEP = 1.0e-5;
    const double scale = s.stiffness * s.penetration + f.norm();
    for (int a = 0; a < D; a++) {
      const Vector<D> step = STEP * Vector<D>::Unit(a);
      EXPECT_NEAR(f[a], -(energy(x + step, F) - energy(x - step, F)) / (2.0 * STEP), 1e-8 * scale);
    }
    for (int a = 0; a < D; a++)
      for (int b = 0; b < D; b++) {
        Square<D> step = Square<D>::Zero();
        step(a, b) = STEP;
        const Square<D> turn = step * F;    // the particles around move by step x
        EXPECT_NEAR(tilt(a, b), -(energy(x, F + turn) - energy(x, F - turn)) / (2.0 * STEP),
                    1e-8 * scale)
            << a << b;
      }

    double couple[3], moment[3] = {};
    couple_of<D>(tilt.data(), couple);
    for (int a = D == 2 ? 2 : 0; a < 3; a++) {
      const int b = (a + 1) % 3, c = (a + 2) % 3;
      moment[a] = s.r[b] * f[c] - s.r[c] * f[b];
      EXPECT_NEAR(couple[a], -moment[a], 1e-14 * scale);
    }
  }
}

TEST_F(ContactCouples, DerivativesOfTheEnergyInThePlane)
{
  for (int n = 0; n < 300; n++) derivative<2>(Eigen::Matrix2d::Identity() + random<2, 2>(0.1));
}

// In 3-D the tangents turn by the polar decomposition, whose rate is the skew part of the
// gradient's where the surface is not stretched.

TEST_F(ContactCouples, DerivativesOfTheEnergyInSpace)
{
  for (int n = 0; n < 300; n++)
    derivative<3>(Eigen::Quaterniond(random<4, 1>(1.0)).normalized().toRotationMatrix());
}

}    // namespace
