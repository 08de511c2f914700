// TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
// Cohesive openings: the laws against their definitions, the update against the energy.

#include "tmsph_cohesion.h"

#include <gtest/gtest.h>

#include <random>

using namespace TMSPH;

namespace {

template <class Law> class Cohesion : public ::testing::Test {
 protected:
  Law law;
};

/// as a bond with this traction and with half of the second derivative of its elastic energy
template <class Law> void follow(Law law, Opening &o, double traction, double half)
{
  const double k = stiffness_of_update(law, o, half);
  update(law, o, traction + k * o.now, k);
}

using Laws = ::testing::Types<LinearCohesion, BilinearCohesion>;
struct Names {
  template <class Law> static std::string GetName(int) { return Law::NAME; }
};
TYPED_TEST_SUITE(Cohesion, Laws, Names);

// round-off
TYPED_TEST(Cohesion, area_is_the_integral_of_the_traction)
{
  double sum = 0.0;
  const int n = 90000;    // the kink lies between two steps
  for (int k = 0; k < n; k++) {
    const double a = (double) k / n, b = (k + 1.0) / n;
    sum += 0.5 * (TypeParam::traction(a) + TypeParam::traction(b)) / n;
    if (k % 1000 == 0) { EXPECT_NEAR(TypeParam::area(b), sum, 1e-12) << b; }
  }
  EXPECT_EQ(TypeParam::traction(0.0), 1.0);
  EXPECT_EQ(TypeParam::traction(1.0), 0.0);
  EXPECT_EQ(TypeParam::traction(1.5), 0.0);
  EXPECT_DOUBLE_EQ(TypeParam::area(1.0), TypeParam::area(2.0));
}

TEST(Petersson, end_is_3_6_times_the_mean)
{
  EXPECT_NEAR(BilinearCohesion::area(1.0) * 3.6, 1.0, 1e-15);
  EXPECT_NEAR(LinearCohesion::area(1.0) * 2.0, 1.0, 1e-15);
}

TYPED_TEST(Cohesion, opening_is_where_the_line_meets_the_law)
{
  std::mt19937_64 engine{3};
  std::uniform_real_distribution<double> random;
  for (int n = 0; n < 5000; n++) {
    const double k = std::exp(8.0 * random(engine) - 2.0), q = 1.0 + (k + 1.0) * random(engine);
    const double x = TypeParam::opening(q, k);
    ASSERT_GE(x, 0.0);
    ASSERT_LE(x, 1.0);
    if (x < 1.0) { EXPECT_NEAR(q - k * x, TypeParam::traction(x), 1e-12 * (q + k)); }
    for (int m = 1; m < 50; m++) {    // and the first place: the line is above the law before it
      const double before = x * m / 50.0;
      EXPECT_GE(q - k * before, TypeParam::traction(before) - 1e-12 * (q + k));
    }
  }
}

// A bar of stiffness K per area that is stretched to u and back at will. Whatever the state before, an
// update does not raise K/2 (u - c)^2 + stored + dissipated if k is half of K or more.
TYPED_TEST(Cohesion, energy_never_rises)
{
  std::mt19937_64 engine{4};
  std::uniform_real_distribution<double> random;
  for (int run = 0; run < 300; run++) {
    const double K = std::exp(6.0 * random(engine) - 1.0), k = K * (0.5 + random(engine));
    Opening o;
    o.strength = 2.0;
    o.end = 0.7;
    for (int step = 0; step < 200; step++) {
      const double u = 1.6 * random(engine) - 0.4;
      const auto energy = [&]() {
        return 0.5 * K * (u - o.now) * (u - o.now) + stored_energy(this->law, o) +
            dissipated_energy(this->law, o);
      };
      const double before = energy(), gone = dissipated_energy(this->law, o);
      follow(this->law, o, K * (u - o.now), k);
      ASSERT_LE(energy(), before + 1e-12 * (before + 1.0)) << run << ' ' << step;
      ASSERT_GE(dissipated_energy(this->law, o), gone - 1e-15);
      ASSERT_GE(o.now, 0.0);
      ASSERT_LE(o.now, o.most);
      if (o.now > o.end) {    // it follows, without traction
        ASSERT_EQ(traction(this->law, o), 0.0);
      }
    }
  }
}

// slowly opened: the traction follows the law, and G_f is gone at the end
TYPED_TEST(Cohesion, full_opening_takes_the_fracture_energy)
{
  const double K = 100.0;
  Opening o;
  o.strength = 2.0;
  o.end = 0.7;
  double work = 0.0, last = 0.0, before = 0.0;
  for (int step = 1; step <= 200000; step++) {
    const double u = 1.0e-5 * step;
    follow(this->law, o, K * (u - o.now), K);
    const double t = o.most > 0.0 ? K * (u - o.now) : K * u;
    work += 0.5 * (t + last) * (u - before);
    last = t;
    before = u;
    if (o.now > 0.0 && o.now < o.end) { EXPECT_NEAR(t, traction(this->law, o), 1e-3 * o.strength); }
  }
  const double fracture = TypeParam::area(1.0) * o.strength * o.end;
  EXPECT_NEAR(dissipated_energy(this->law, o), fracture, 1e-12);
  EXPECT_EQ(traction(this->law, o), 0.0);
  EXPECT_NEAR(o.now, before, 2.0e-5);    // within two steps it follows the stretch
}

// closed it is as stiff as before, and what was stored comes back
TYPED_TEST(Cohesion, unloads_to_the_origin)
{
  Opening o;
  o.strength = 2.0;
  o.end = 0.7;
  const double K = 50.0;
  for (int n = 0; n < 200; n++) follow(this->law, o, K * (0.3 - o.now), K);
  const double most = o.most, held = stored_energy(this->law, o);
  EXPECT_GT(held, 0.0);
  for (double u : {0.2, 0.1, 0.05, 0.0}) {
    for (int n = 0; n < 400; n++) follow(this->law, o, K * (u - o.now), K);
    EXPECT_NEAR(K * (u - o.now), traction(this->law, o), 1e-9);
    EXPECT_EQ(o.most, most);
  }
  EXPECT_NEAR(o.now, 0.0, 1e-9);
  follow(this->law, o, -1.0, K);
  EXPECT_EQ(o.now, 0.0);
}

}    // namespace
