/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Conductances of bonds and surfaces, and the sweep over the bonds against a
   double loop.
------------------------------------------------------------------------- */

#include "tmsph_conduction.h"
#include "tmsph_heat_sweep.h"

#include "body.h"

using namespace TMSPH;
using namespace TMSPH_TEST;

namespace {

template <class Dimension> class Conduction : public ::testing::Test {
 protected:
  static constexpr int D = Dimension::value;

  /// symmetric, positive definite, with principal values of very different size
  static Square<D> tensor(unsigned seed)
  {
    std::srand(seed);
    const Eigen::HouseholderQR<Square<D>> qr(Square<D>::Random());
    const Square<D> Q = qr.householderQ();
    Vector<D> values;
    for (int k = 0; k < D; k++) values[k] = std::pow(5.0, k) * (1.0 + 0.1 * seed);
    return Q * values.asDiagonal() * Q.transpose();
  }

  /// D times the mean over all directions of k(e) e e^T
  static Square<D> mean(const DirectionalConductivity<D> &k)
  {
    constexpr double PI = 3.14159265358979323846;
    Square<D> sum = Square<D>::Zero();
    double weights = 0.0;
    const int turns = 400, heights = D == 2 ? 1 : 800;
    for (int n = 0; n < heights; n++)    // equal areas by Archimedes; midpoint rule
      for (int m = 0; m < turns; m++) {
        const double z = D == 2 ? 0.0 : -1.0 + (2.0 * n + 1.0) / heights;
        const double r = std::sqrt(1.0 - z * z), angle = 2.0 * PI * m / turns;
        const double e3[3] = {r * std::cos(angle), r * std::sin(angle), z};
        const Vector<D> e(e3);
        sum += k(e) * e * e.transpose();
        weights += 1.0;
      }
    return D / weights * sum;
  }
};

TYPED_TEST_SUITE(Conduction, Dimensions, DimensionName);

TYPED_TEST(Conduction, mean_over_directions)
{
  constexpr int D = TestFixture::D;
  for (unsigned seed = 1; seed < 4; seed++) {
    const Square<D> K = TestFixture::tensor(seed);
    const DirectionalConductivity<D> k(K);
    // the midpoint rule converges exponentially around the circle, by its square in height
    EXPECT_LT((TestFixture::mean(k) - K).norm() / K.norm(), D == 2 ? 1e-12 : 1e-4);
  }
}

TYPED_TEST(Conduction, isotropic_limit)
{
  constexpr int D = TestFixture::D;
  const DirectionalConductivity<D> k(Square<D>(3.7 * Square<D>::Identity()));
  for (int n = 0; n < 20; n++) EXPECT_NEAR(k(Vector<D>::Random().normalized()), 3.7, 1e-13);
}

TYPED_TEST(Conduction, positive_in_all_directions)
{
  constexpr int D = TestFixture::D;
  Vector<D> values = Vector<D>::Constant(1e-3);
  values[0] = 1e3;
  const DirectionalConductivity<D> k(Square<D>(values.asDiagonal()));
  for (int n = 0; n < 1000; n++) EXPECT_GT(k(Vector<D>::Random().normalized()), 0.0);
}

TEST(Surface, harmonic_mean)
{
  EXPECT_DOUBLE_EQ(harmonic_mean(2.0, 2.0), 2.0);
  EXPECT_DOUBLE_EQ(harmonic_mean(1.0, 3.0), 1.5);
  EXPECT_EQ(harmonic_mean(1.0, 3.0), harmonic_mean(3.0, 1.0));
  EXPECT_EQ(harmonic_mean(0.0, 3.0), 0.0);
  EXPECT_EQ(harmonic_mean(0.0, 0.0), 0.0);
}

/// heat through a layer of thickness d, and a film in series with it
TEST(Surface, resistances_in_series)
{
  const double k = 2.5, A = 3e-6, d = 5e-4, h = 700.0;
  EXPECT_DOUBLE_EQ(surface_conductance(k, A, d), k * A / d);
  EXPECT_DOUBLE_EQ(1.0 / film_conductance(k, A, d, h), d / (k * A) + 1.0 / (h * A));
  EXPECT_NEAR(film_conductance(k, A, d, 1e30) / surface_conductance(k, A, d), 1.0, 1e-12);
  EXPECT_EQ(film_conductance(k, A, d, 0.0), 0.0);
}

TEST(Surface, radiation)
{
  constexpr double SIGMA = 5.670374419e-8, ZERO = -273.15;
  for (double T : {-100.0, 20.0, 800.0})
    for (double outside : {-273.15, 20.0, 21.0, 1500.0}) {
      const double exact = SIGMA * (std::pow(outside - ZERO, 4) - std::pow(T - ZERO, 4));
      const double h = radiation_film(SIGMA, T, outside, ZERO);
      EXPECT_GE(h, 0.0);
      EXPECT_NEAR(h * (outside - T), exact, 1e-12 * std::fabs(exact) + 1e-12);
    }
}

template <int D> struct Heated {
  Body<D> body = random_body<D>(11);
  Layout<D> layout{body, 0.0};
  std::vector<double> T, k;
  std::vector<float> G;

  explicit Heated(int lanes = LANES) : layout(body, 0.0, lanes)
  {
    std::mt19937_64 engine(5);
    std::uniform_real_distribution<double> uniform(0.0, 100.0);
    for (int i = 0; i < body.size(); i++) {
      T.push_back(uniform(engine));
      k.push_back(uniform(engine));
    }
    for (float w : layout.bonds.weight) G.push_back(3.0f * w);
  }

  std::vector<double> sweep(bool variable) const
  {
    std::vector<double> power(body.size(), -1.0);
    heat_sweep(layout.bonds, G.data(), T.data(), variable ? k.data() : nullptr, power.data());
    return power;
  }
};

TYPED_TEST(Conduction, sweep_is_the_double_loop)
{
  constexpr int D = TestFixture::D;
  const Heated<D> heated;
  for (bool variable : {false, true}) {
    const auto power = heated.sweep(variable);
    double largest = 0.0, sum = 0.0;
    for (double p : power) {
      largest = std::max(largest, std::fabs(p));
      sum += p;
    }
    for (int i = 0; i < heated.body.size(); i++) {
      double p = 0.0;
      for (int j = 0; j < heated.body.size(); j++)
        p += (double) (3.0f * heated.body.W(i, j)) * (heated.T[j] - heated.T[i]) *
            (variable ? harmonic_mean(heated.k[i], heated.k[j]) : 1.0);
      EXPECT_NEAR(power[i], p, 1e-14 * largest);
    }
    EXPECT_GT(largest, 0.0);
    EXPECT_NEAR(sum, 0.0, 1e-14 * largest * heated.body.size());    // no heat is lost
  }
}

/// the same to the last bit with any number of particles in a slice
TYPED_TEST(Conduction, sweep_does_not_depend_on_packing)
{
  constexpr int D = TestFixture::D;
  const Heated<D> one;
  for (int lanes : {1, 3, 5}) {
    const Heated<D> other(lanes);
    for (bool variable : {false, true}) EXPECT_EQ(one.sweep(variable), other.sweep(variable));
  }
}

/// equal temperatures exchange nothing, broken bonds neither
TYPED_TEST(Conduction, sweep_rests)
{
  constexpr int D = TestFixture::D;
  Heated<D> heated;
  std::fill(heated.T.begin(), heated.T.end(), 7.0);
  for (double p : heated.sweep(true)) EXPECT_EQ(p, 0.0);
  Heated<D> cut;
  std::fill(cut.G.begin(), cut.G.end(), 0.0f);
  for (double p : cut.sweep(true)) EXPECT_EQ(p, 0.0);
}

}    // namespace
