/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Elastic laws: energy, objectivity, small strain, plane states, eight lanes.
------------------------------------------------------------------------- */

#include "body.h"

#include <gtest/gtest.h>

using namespace TMSPH;
using namespace TMSPH_TEST;

namespace {

constexpr double YOUNG = 40.0e9;

template <int D> Matrix<D, double> plain(const Square<D> &A)
{
  Matrix<D, double> B;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) B[i][j] = A(i, j);
  return B;
}

template <int D> Square<D> eigen(const Matrix<D, double> &A)
{
  Square<D> B;
  for (int i = 0; i < D; i++)
    for (int j = 0; j < D; j++) B(i, j) = A[i][j];
  return B;
}

template <int D> Square<D> random_matrix(std::mt19937_64 &engine, double scale)
{
  std::uniform_real_distribution<double> uniform(-scale, scale);
  Square<D> A;
  for (int i = 0; i < D * D; i++) A(i / D, i % D) = uniform(engine);
  return A;
}

/// any angle about a random axis; in the plane the angle only
template <int D> Square<D> rotation(std::mt19937_64 &engine, double angle)
{
  if constexpr (D == 2)
    return Eigen::Rotation2Dd(angle).toRotationMatrix();
  else {
    const Eigen::Vector3d axis = random_matrix<3>(engine, 1.0).col(0).normalized();
    return Eigen::AngleAxisd(angle, axis).toRotationMatrix();
  }
}

template <class Dimension> class Elasticity : public ::testing::Test {
 protected:
  static constexpr int D = Dimension::value;
  std::mt19937_64 engine{21};
  const Elastic m = elastic_constants(D, Plane::STRAIN, YOUNG, 0.3, 0.0);
  const Square<D> one = Square<D>::Identity();

  template <class Law> Square<D> first_piola_of(const Square<D> &H, double thermal) const
  {
    return eigen<D>(Law::first_piola(plain<D>(H), m.lambda, m.shear, thermal));
  }
  template <class Law> Square<D> cauchy_of(const Square<D> &H, double thermal = 0.0) const
  {
    return eigen<D>(cauchy(Law::first_piola(plain<D>(H), m.lambda, m.shear, thermal),
                           deformation(plain<D>(H))));
  }
  Square<D> hooke_of(const Square<D> &e) const
  {
    return m.lambda * e.trace() * one + 2.0 * m.shear * e;
  }
};

TYPED_TEST_SUITE(Elasticity, Dimensions, DimensionName);

// psi is of fourth degree in H, so a central difference with step 1e-4 errs by (1e-4)^2 times the
// moduli; round-off of psi adds 1e-16/1e-4 of it
TYPED_TEST(Elasticity, stress_is_the_gradient_of_the_energy)
{
  constexpr int D = TestFixture::D;
  const double step = 1.0e-4;
  const auto check = [&](auto law, const Square<D> &H, double thermal, double accuracy) {
    using Law = decltype(law);
    const Square<D> P = this->template first_piola_of<Law>(H, thermal);
    for (int e = 0; e < D * D; e++) {
      Square<D> shift = Square<D>::Zero();
      shift(e / D, e % D) = step;
      const auto energy = [&](const Square<D> &A) {
        return Law::energy(plain<D>(A), this->m.lambda, this->m.shear, thermal);
      };
      const double slope = (energy(H + shift) - energy(H - shift)) / (2.0 * step);
      EXPECT_NEAR(P(e / D, e % D), slope, accuracy * step * step * this->m.wave_modulus);
    }
  };
  for (double thermal : {0.0, 0.02, -0.01})
    for (int k = 0; k < 20; k++) {
      const Square<D> H = random_matrix<D>(this->engine, 0.1);
      check(StVenantKirchhoff(), H, thermal, 5.0);
      // J may fall to 1/2: third derivatives up to 2 mu/J^3
      check(NeoHookean(), H, thermal, 50.0);
    }
}

// required accuracy: |sigma| below 1e-12 E under rotation by any angle
TYPED_TEST(Elasticity, rotation_gives_no_stress)
{
  constexpr int D = TestFixture::D;
  for (int degrees = -180; degrees <= 180; degrees += 5) {
    const Square<D> H = rotation<D>(this->engine, degrees * M_PI / 180.0) - this->one;
    EXPECT_LT(this->template cauchy_of<StVenantKirchhoff>(H).norm(), 1.0e-12 * YOUNG) << degrees;
    EXPECT_LT(this->template cauchy_of<AlmansiHooke>(H).norm(), 1.0e-12 * YOUNG) << degrees;
    EXPECT_LT(this->template cauchy_of<NeoHookean>(H).norm(), 1.0e-12 * YOUNG) << degrees;
  }
}

// sigma(Q F) = Q sigma(F) Q^T
TYPED_TEST(Elasticity, objective)
{
  constexpr int D = TestFixture::D;
  for (int k = 0; k < 50; k++) {
    const Square<D> H = random_matrix<D>(this->engine, 0.1);
    const Square<D> Q = rotation<D>(this->engine, 0.1 * k);
    const Square<D> turned = Q * (this->one + H) - this->one;
    const auto check = [&](const Square<D> &after, const Square<D> &before) {
      EXPECT_LT((after - Q * before * Q.transpose()).norm(), 1.0e-12 * YOUNG);
    };
    check(this->template cauchy_of<StVenantKirchhoff>(turned, 0.01),
          this->template cauchy_of<StVenantKirchhoff>(H, 0.01));
    check(this->template cauchy_of<AlmansiHooke>(turned, 0.01),
          this->template cauchy_of<AlmansiHooke>(H, 0.01));
    check(this->template cauchy_of<NeoHookean>(turned, 0.01),
          this->template cauchy_of<NeoHookean>(H, 0.01));
  }
}

// what differs from Hooke is of second order: ten times less strain, a hundred times less
// difference, but for the third order, here below 10 * 1e-4 * |H|
TYPED_TEST(Elasticity, small_strain_is_hooke)
{
  constexpr int D = TestFixture::D;
  for (int k = 0; k < 20; k++) {
    const Square<D> H = random_matrix<D>(this->engine, 1.0);
    const auto difference = [&](double scale, auto stress) {
      const Square<D> small = scale * H;
      return (stress(small) - this->hooke_of(0.5 * (small + small.transpose()))).norm();
    };
    const auto check = [&](auto stress) {
      EXPECT_NEAR(difference(1.0e-4, stress) / difference(1.0e-5, stress), 100.0, 1.0);
    };
    check([&](const Square<D> &A) { return this->template cauchy_of<StVenantKirchhoff>(A); });
    check([&](const Square<D> &A) { return this->template cauchy_of<AlmansiHooke>(A); });
    check([&](const Square<D> &A) { return this->template cauchy_of<NeoHookean>(A); });
  }
}

// at small strain no digits are lost: round-off relative to the stress, not to E
TYPED_TEST(Elasticity, no_cancellation_at_small_strain)
{
  constexpr int D = TestFixture::D;
  const double strain = 1.0e-9;
  Square<D> H = Square<D>::Zero();
  H(0, 0) = strain;
  const double exact =
      (this->m.lambda + 2.0 * this->m.shear) * (strain + 0.5 * strain * strain) * (1.0 + strain);
  EXPECT_NEAR(this->template first_piola_of<StVenantKirchhoff>(H, 0.0)(0, 0) / exact, 1.0, 1.0e-14);
  // mu (F - 1/F) + lambda/2 (F^2 - 1)/F with F = 1 + strain, to the second order
  const double neo = 2.0 * this->m.shear * (strain - 0.5 * strain * strain) +
      this->m.lambda * (strain - 0.5 * strain * strain);
  EXPECT_NEAR(this->template first_piola_of<NeoHookean>(H, 0.0)(0, 0) / neo, 1.0, 1.0e-14);
}

TYPED_TEST(Elasticity, neo_hookean_is_its_definition)
{
  constexpr int D = TestFixture::D;
  for (int k = 0; k < 50; k++) {
    const double thermal = 0.001 * k, lambda = this->m.lambda, shear = this->m.shear;
    const Square<D> H = random_matrix<D>(this->engine, 0.1), F = (this->one + H) / (1.0 + thermal);
    const Square<D> T = F.transpose().inverse();
    const double J = F.determinant();
    const Square<D> P = (shear * (F - T) + 0.5 * lambda * (J * J - 1.0) * T) / (1.0 + thermal);
    EXPECT_LT((this->template first_piola_of<NeoHookean>(H, thermal) - P).norm(),
              1e-14 * 10 * YOUNG);
    const double energy = 0.5 * shear * ((F.transpose() * F).trace() - D) - shear * std::log(J) +
        0.25 * lambda * (J * J - 1.0 - 2.0 * std::log(J));
    EXPECT_NEAR(NeoHookean::energy(plain<D>(H), lambda, shear, thermal), energy,
                1e-14 * 10 * YOUNG);
  }
}

// crushed to nothing it pushes without bound, as the law of St Venant and Kirchhoff does not
TYPED_TEST(Elasticity, neo_hookean_is_stiff_when_crushed)
{
  constexpr int D = TestFixture::D;
  double last = 0.0;
  for (double stretch : {0.5, 0.1, 0.01, 0.001}) {
    Square<D> H = Square<D>::Zero();
    H(0, 0) = stretch - 1.0;
    const double push = -this->template first_piola_of<NeoHookean>(H, 0.0)(0, 0);
    EXPECT_GT(push, 2.0 * last);
    last = push;
  }
}

TYPED_TEST(Elasticity, almansi_is_its_definition)
{
  constexpr int D = TestFixture::D;
  for (int k = 0; k < 50; k++) {
    const double thermal = 0.001 * k;
    const Square<D> H = random_matrix<D>(this->engine, 0.1), F = this->one + H;
    const Square<D> E = 0.5 * (F.transpose() * F - this->one);
    const Square<D> e = F.transpose().inverse() * E * F.inverse() - thermal * this->one;
    const double J = F.determinant();
    EXPECT_LT((eigen<D>(almansi(plain<D>(F), J, thermal)) - e).norm(), 1.0e-14);    // round-off
    const Square<D> sigma = this->hooke_of(e);
    EXPECT_LT((this->template cauchy_of<AlmansiHooke>(H, thermal) - sigma).norm(),
              1.0e-14 * 10.0 * YOUNG);
    EXPECT_LT((this->template first_piola_of<AlmansiHooke>(H, thermal) -
               J * sigma * F.transpose().inverse())
                  .norm(),
              1.0e-14 * 10.0 * YOUNG);
  }
}

// eight different states at once give what each gives alone, to round-off (the compiler may
// contract a product and a sum in one and not in the other)
TYPED_TEST(Elasticity, eight_lanes_equal_one)
{
  constexpr int D = TestFixture::D;
  Square<D> H[LANES];
  Matrix<D, Lanes> many;
  Lanes lambda, shear, thermal;
  for (int l = 0; l < LANES; l++) {
    H[l] = random_matrix<D>(this->engine, 0.1);
    for (int i = 0; i < D; i++)
      for (int j = 0; j < D; j++) many[i][j][l] = H[l](i, j);
    lambda[l] = this->m.lambda * (1.0 + 0.1 * l);
    shear[l] = this->m.shear * (1.0 - 0.1 * l);
    thermal[l] = 0.003 * l;
  }
  const auto check = [&](auto law) {
    using Law = decltype(law);
    const auto P = Law::first_piola(many, lambda, shear, thermal);
    const auto sigma = cauchy(P, deformation(many));
    const auto energy = Law::energy(many, lambda, shear, thermal);
    for (int l = 0; l < LANES; l++) {
      const double a = lambda[l], b = shear[l], t = thermal[l];
      const auto alone = Law::first_piola(plain<D>(H[l]), a, b, t);
      const auto sigma_alone = cauchy(alone, deformation(plain<D>(H[l])));
      EXPECT_NEAR(energy[l], (Law::energy(plain<D>(H[l]), a, b, t)), 1.0e-15 * YOUNG);
      for (int i = 0; i < D; i++)
        for (int j = 0; j < D; j++) {
          EXPECT_NEAR(P[i][j][l], alone[i][j], 1.0e-14 * YOUNG);
          EXPECT_NEAR(sigma[i][j][l], sigma_alone[i][j], 1.0e-14 * YOUNG);
        }
    }
  };
  check(StVenantKirchhoff());
  check(AlmansiHooke());
  check(NeoHookean());
}

/* ----------------------------------------------------------------------
   the plane states are those of a 3-D body that is held, or free, in z
------------------------------------------------------------------------- */

class PlaneState : public ::testing::TestWithParam<double> {
 protected:
  const double nu = GetParam(), alpha = 1.5e-5, heated = 80.0;
  std::mt19937_64 engine{22};

  /// in-plane 3-D Hooke stress of a strain whose zz is given, with thermal strain alpha dT
  Eigen::Matrix3d in_space(const Square<2> &e, double zz) const
  {
    Eigen::Matrix3d strain = Eigen::Matrix3d::Zero();
    strain.topLeftCorner<2, 2>() = e;
    strain(2, 2) = zz;
    strain -= alpha * heated * Eigen::Matrix3d::Identity();
    return YOUNG / (1.0 + nu) *
        (strain + nu / (1.0 - 2.0 * nu) * strain.trace() * Eigen::Matrix3d::Identity());
  }
  Square<2> in_plane(Plane plane, const Square<2> &e) const
  {
    const Elastic m = elastic_constants(2, plane, YOUNG, nu, alpha);
    const Square<2> strain = e - m.expansion * heated * Square<2>::Identity();
    return eigen<2>(hooke(plain<2>(strain), m.lambda, m.shear));
  }
};

TEST_P(PlaneState, strain)
{
  for (int k = 0; k < 10; k++) {
    const Square<2> A = random_matrix<2>(engine, 1.0e-3), e = 0.5 * (A + A.transpose());
    EXPECT_LT((in_plane(Plane::STRAIN, e) - in_space(e, 0.0).topLeftCorner<2, 2>()).norm(),
              1.0e-14 * YOUNG);
  }
}

TEST_P(PlaneState, stress)
{
  for (int k = 0; k < 10; k++) {
    const Square<2> A = random_matrix<2>(engine, 1.0e-3), e = 0.5 * (A + A.transpose());
    const double at_0 = in_space(e, 0.0)(2, 2), at_1 = in_space(e, 1.0)(2, 2);
    const double zz = -at_0 / (at_1 - at_0);    // sigma_zz is linear in it
    EXPECT_LT((in_plane(Plane::STRESS, e) - in_space(e, zz).topLeftCorner<2, 2>()).norm(),
              1.0e-13 * YOUNG);
  }
}

// P-wave modulus and constants of 3-D, whatever the plane option says
TEST_P(PlaneState, constants)
{
  const double bulk = YOUNG / (3.0 * (1.0 - 2.0 * nu)), shear = 0.5 * YOUNG / (1.0 + nu);
  for (Plane plane : {Plane::STRAIN, Plane::STRESS}) {
    const Elastic m = elastic_constants(3, plane, YOUNG, nu, alpha);
    EXPECT_NEAR(m.lambda, bulk - 2.0 / 3.0 * shear, 1.0e-14 * bulk);
    EXPECT_NEAR(m.shear, shear, 1.0e-15 * shear);
    EXPECT_EQ(m.expansion, alpha);
    EXPECT_NEAR(elastic_constants(2, plane, YOUNG, nu, alpha).wave_modulus,
                bulk + 4.0 / 3.0 * shear, 1.0e-14 * bulk);
  }
}

INSTANTIATE_TEST_SUITE_P(Poisson, PlaneState, ::testing::Values(0.0, 0.2, 0.3, 0.45, -0.3),
                         [](const auto &info) { return "case" + std::to_string(info.index); });

}    // namespace
