/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   RKL2 on y' = -z y, with the step 1: after all stages y is the stability
   polynomial R(z).
------------------------------------------------------------------------- */

#include "tmsph_rkl2.h"

#include <gtest/gtest.h>

#include <cmath>

using namespace TMSPH;

namespace {

template <class RATE> double advance(const Rkl2 &scheme, double y0, RATE rate)
{
  double y = y0, last = y0, before_last = 0.0;
  for (int j = 1; j <= scheme.stages; j++) {
    const Rkl2::Stage c = scheme.stage(j);
    y = c.mu * last + c.nu * before_last + (1.0 - c.mu - c.nu) * y0 + c.mu_rate * rate(last) +
        c.gamma_rate * rate(y0);
    before_last = last;
    last = y;
  }
  return y;
}

double polynomial(const Rkl2 &scheme, double z)
{
  return advance(scheme, 1.0, [z](double y) { return -z * y; });
}

/// Legendre polynomial of degree n
double legendre(int n, double x)
{
  double last = 1.0, p = x;
  if (n == 0) return 1.0;
  for (int j = 2; j <= n; j++) {
    const double next = ((2.0 * j - 1.0) * x * p - (j - 1.0) * last) / j;
    last = p;
    p = next;
  }
  return p;
}

/// R(z) = 1 - z + z^2/2 + O(z^3)
TEST(Rkl2, second_order)
{
  for (double ratio : {0.5, 2.0, 10.0, 300.0}) {
    const Rkl2 scheme(ratio);
    const auto error = [&](double z) {
      return std::fabs(polynomial(scheme, z) - (1.0 - z + 0.5 * z * z));
    };
    EXPECT_NEAR(std::log2(error(0.02) / error(0.01)), 3.0, 0.05) << scheme.stages;
    EXPECT_LT(error(0.01), 0.5e-6) << scheme.stages;    // z^3/2: exp(-z) has 1/6
  }
}

/// y' = y^2, whose second derivative does not vanish
TEST(Rkl2, second_order_nonlinear)
{
  const Rkl2 scheme(5.0);
  const auto error = [&](int steps) {
    double y = 1.0;
    const double h = 0.5 / steps;
    for (int n = 0; n < steps; n++) y = advance(scheme, y, [h](double v) { return h * v * v; });
    return std::fabs(y - 2.0);
  };
  EXPECT_NEAR(std::log2(error(40) / error(80)), 2.0, 0.1);
}

/// Meyer et al.: R(z) = 1 - b + b P_s(1 - 2 z/(reach 2)), so |R| <= 1 up to z = 2 reach
TEST(Rkl2, stability_polynomial)
{
  for (double ratio : {1.0, 3.0, 20.0, 400.0}) {
    const Rkl2 scheme(ratio);
    const int s = scheme.stages;
    const double b = (s * (s + 1.0) - 2.0) / (2.0 * s * (s + 1.0));
    for (int n = 0; n <= 1000; n++) {
      const double z = 2.0 * scheme.reach() * n / 1000.0;
      const double R = polynomial(scheme, z);
      EXPECT_NEAR(R, 1.0 - b + b * legendre(s, 1.0 - z / scheme.reach()), 1e-10) << s << " " << z;
      EXPECT_LE(std::fabs(R), 1.0 + 1e-12);
    }
    // at the end of the interval P_s = -1 for odd s: highest modes are damped, not only bounded
    EXPECT_NEAR(polynomial(scheme, 2.0 * scheme.reach()), 1.0 - 2.0 * b, 1e-10);
    EXPECT_LT(std::fabs(1.0 - 2.0 * b), 0.2);
    EXPECT_GT(std::fabs(polynomial(scheme, 2.0 * scheme.reach() * 1.5)), 1.0);
  }
}

TEST(Rkl2, stage_count)
{
  for (double ratio : {0.1, 1.0, 2.4999, 2.5, 2.5001, 7.0, 7.01, 50.0, 1e3, 1e5}) {
    const Rkl2 scheme(ratio);
    EXPECT_EQ(scheme.stages % 2, 1);
    EXPECT_GE(scheme.stages, 3);
    EXPECT_GE(scheme.reach(), ratio * (1.0 - 1e-12));
    if (scheme.stages == 3) continue;
    const double s = scheme.stages - 2;    // the next odd number below does not do
    EXPECT_LT(0.25 * (s * (s + 1.0) - 2.0), ratio);
  }
}

}    // namespace
