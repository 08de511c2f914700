/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Smoothing kernels: slope, normalization, support.
------------------------------------------------------------------------- */

#include "tmsph_kernel.h"

#include <gtest/gtest.h>

#include <cmath>
#include <stdexcept>
#include <string>
#include <tuple>

using namespace TMSPH;

namespace {

Kernel named(const std::string &name)
{
  for (const auto &each : kernels())
    if (each.first == name) return each.second;
  throw std::invalid_argument(name);
}

std::vector<std::string> names()
{
  std::vector<std::string> all;
  for (const auto &each : kernels()) all.push_back(each.first);
  return all;
}

class Kernels : public ::testing::TestWithParam<std::tuple<std::string, int>> {
 protected:
  const std::string name = std::get<0>(GetParam());
  const Kernel kernel = named(name);
  const int dimension = std::get<1>(GetParam());
  const double delta = 3.015e-3;
  const double h = delta / support_in_smoothing_lengths(kernel);

  double w(double R) const { return kernel_slope(kernel, dimension, R, delta); }

  /// W up to its normalization: Wendland C2, cubic and quintic spline
  double shape(double R) const
  {
    const double q = R / h;
    const auto power = [](double x, int n) { return x > 0.0 ? std::pow(x, n) : 0.0; };
    if (name == "wendland") return power(1.0 - 0.5 * q, 4) * (1.0 + 2.0 * q);
    if (name == "cubic") return power(2.0 - q, 3) - 4.0 * power(1.0 - q, 3);
    EXPECT_EQ(name, "quintic");    // the shape of a new kernel goes here
    return power(3.0 - q, 5) - 6.0 * power(2.0 - q, 5) + 15.0 * power(1.0 - q, 5);
  }

  /// integral over all space of f(R), a polynomial of degree <= 9 times R^(1-d) between the knots,
  /// which splines have at whole or half values of R/h
  template <class FN> double integral(FN f) const
  {
    const double x[5] = {-0.90617984593866399, -0.53846931010568309, 0.0, 0.53846931010568309,
                         0.90617984593866399};
    const double weight[5] = {0.23692688505618909, 0.47862867049936647, 128.0 / 225.0,
                              0.47862867049936647, 0.23692688505618909};
    double sum = 0.0;
    for (double knot = 0.0; knot < support_in_smoothing_lengths(kernel); knot += 0.5)
      for (int k = 0; k < 5; k++) {
        const double R = h * (knot + 0.25 * (1.0 + x[k]));
        sum += 0.25 * h * weight[k] * f(R) * (dimension == 2 ? 2.0 * M_PI * R : 4.0 * M_PI * R * R);
      }
    return sum;
  }
};

// by parts: integral of W = -(1/d) integral of R W' = (1/d) integral of w R^2; the quadrature is
// exact for these polynomials, so that only round-off remains
TEST_P(Kernels, normalized)
{
  EXPECT_NEAR(integral([&](double R) { return w(R) * R * R; }) / dimension, 1.0, 1.0e-14);
}

// central differences of the closed form: truncation (step/h)^2 = 1e-8 times W'''/W', of order 10
TEST_P(Kernels, slope_of_kernel)
{
  const double norm = 1.0 / integral([&](double R) { return shape(R); });
  const double step = 1.0e-4 * h, scale = w(0.3 * h) * h;
  for (int k = 1; k < 200; k++) {
    const double R = delta * k / 200.0;
    const double slope = norm * (shape(R + step) - shape(R - step)) / (2.0 * step);
    EXPECT_NEAR(w(R) * R, -slope, 1.0e-6 * scale) << "R/h = " << R / h;
  }
}

// central differences, as above, between the places where splines are joined
TEST_P(Kernels, rate_of_slope)
{
  const double step = 1.0e-4 * h, scale = w(0.3 * h) / h;
  for (int k = 1; k < 201; k++) {
    const double R = delta * k / 201.0, rate = (w(R + step) - w(R - step)) / (2.0 * step);
    EXPECT_NEAR(kernel_slope_rate(kernel, dimension, R, delta), rate, 1.0e-6 * scale)
        << "R/h = " << R / h;
  }
}

// the kernel: its integral is 1, its slope is -w R, it vanishes from the support on
TEST_P(Kernels, value)
{
  const auto W = [&](double R) { return kernel_value(kernel, dimension, R, delta); };
  EXPECT_NEAR(integral(W), 1.0, 1.0e-14);    // exact quadrature of the polynomials
  const double step = 1.0e-4 * h, scale = w(0.3 * h) * h;
  for (int k = 1; k < 200; k++) {
    const double R = delta * k / 200.0;
    EXPECT_NEAR(w(R) * R, -(W(R + step) - W(R - step)) / (2.0 * step), 1.0e-6 * scale);
  }
  EXPECT_EQ(W(delta), 0.0);
  EXPECT_EQ(W(1.5 * delta), 0.0);
}

TEST_P(Kernels, support)
{
  for (double R : {delta, 1.0001 * delta, 10.0 * delta}) EXPECT_EQ(w(R), 0.0);
  for (int k = 1; k < 1000; k++) EXPECT_GT(w(delta * k / 1000.0), 0.0);
  // all vanish at the support at least as (delta - R)^2, so a cut-off bond does not jump
  EXPECT_LT(w(delta * (1.0 - 1.0e-6)), 1.0e-10 * w(0.5 * delta));
}

// w scales as length^-(d+2)
TEST_P(Kernels, scales_with_length)
{
  const double ratio =
      kernel_slope(kernel, dimension, 0.7, 2.0) / kernel_slope(kernel, dimension, 0.35, 1.0);
  EXPECT_NEAR(ratio * std::pow(2.0, dimension + 2), 1.0, 1.0e-14);    // round-off
}

std::string name_of(const ::testing::TestParamInfo<Kernels::ParamType> &info)
{
  return std::get<0>(info.param) + std::to_string(std::get<1>(info.param)) + "d";
}

INSTANTIATE_TEST_SUITE_P(All, Kernels,
                         ::testing::Combine(::testing::ValuesIn(names()), ::testing::Values(2, 3)),
                         name_of);

}    // namespace
