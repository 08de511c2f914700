/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Properties over temperature: value, integral and its inverse, inside and
   outside of the table.
------------------------------------------------------------------------- */

#include "tmsph_property_table.h"

#include <gtest/gtest.h>

#include <vector>

using namespace TMSPH;

namespace {

const std::vector<double> T{-50.0, 20.0, 25.0, 300.0, 573.0, 574.0};
const std::vector<double> VALUES{700.0, 760.0, 1400.0, 950.0, 1100.0, 1.0};
const PropertyTable TABLE(T, VALUES);

/// before, at, between and after the points
std::vector<double> temperatures()
{
  std::vector<double> all;
  for (double t = -400.0; t <= 1500.0; t += 7.3) all.push_back(t);
  all.insert(all.end(), T.begin(), T.end());
  return all;
}

TEST(PropertyTable, number)
{
  const PropertyTable k(2.9);
  EXPECT_TRUE(k.constant());
  for (double t : temperatures()) {
    EXPECT_EQ(k(t), 2.9);
    EXPECT_EQ(k.integral(t), 2.9 * t);
    EXPECT_NEAR(k.temperature_at(k.integral(t)), t, 1e-12);
  }
  EXPECT_EQ(k.smallest(), 2.9);
  EXPECT_EQ(k.largest(), 2.9);
}

TEST(PropertyTable, one_point_is_a_number)
{
  const PropertyTable k({100.0}, {2.9});
  EXPECT_TRUE(k.constant());
  for (double t : temperatures()) {
    EXPECT_EQ(k(t), 2.9);
    EXPECT_NEAR(k.temperature_at(k.integral(t)), t, 1e-12);
  }
}

TEST(PropertyTable, points_and_straight_lines)
{
  EXPECT_FALSE(TABLE.constant());
  EXPECT_EQ(TABLE.smallest(), 1.0);
  EXPECT_EQ(TABLE.largest(), 1400.0);
  for (size_t n = 0; n < T.size(); n++) EXPECT_EQ(TABLE(T[n]), VALUES[n]);
  for (size_t n = 1; n < T.size(); n++)
    for (double share : {0.1, 0.5, 0.9}) {
      const double t = T[n - 1] + share * (T[n] - T[n - 1]);
      EXPECT_NEAR(TABLE(t), VALUES[n - 1] + share * (VALUES[n] - VALUES[n - 1]), 1e-10);
    }
  EXPECT_EQ(TABLE(-273.0), VALUES.front());
  EXPECT_EQ(TABLE(2000.0), VALUES.back());
}

/// the trapezoidal rule is exact on straight lines
TEST(PropertyTable, integral)
{
  const auto all = temperatures();
  EXPECT_EQ(TABLE.integral(T[0]), 0.0);
  for (double a : all)
    for (double b : all) {
      if (!(a < b)) continue;
      std::vector<double> ends{a};
      for (double t : T)
        if (t > a && t < b) ends.push_back(t);
      ends.push_back(b);
      double sum = 0.0, size = 0.0;
      for (size_t n = 1; n < ends.size(); n++) {
        sum += 0.5 * (TABLE(ends[n - 1]) + TABLE(ends[n])) * (ends[n] - ends[n - 1]);
        size = std::max(size, std::max(std::fabs(TABLE.integral(a)), std::fabs(TABLE.integral(b))));
      }
      EXPECT_NEAR(TABLE.integral(b) - TABLE.integral(a), sum, 1e-13 * (size + sum));
    }
}

TEST(PropertyTable, inverse)
{
  for (double t : temperatures()) {
    const double h = TABLE.integral(t);
    // round-off of the integral over the property
    EXPECT_NEAR(TABLE.temperature_at(h), t, 1e-13 * 1e6 / TABLE(t)) << h;
  }
}

TEST(PropertyTable, inverse_ascends)
{
  double last = -HUGE_VAL;
  for (double h = -1e5; h < 1e6; h += 997.0) {
    const double t = TABLE.temperature_at(h);
    EXPECT_GT(t, last);
    last = t;
  }
}

}    // namespace
