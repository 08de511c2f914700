/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The Hoek-Brown criterion.
------------------------------------------------------------------------- */

#include "tmsph_hoekbrown.h"

#include <gtest/gtest.h>

using namespace TMSPH;

namespace {

constexpr double MI = 8.0, SIGMA_C = 120.0e6;

struct Rock {
  double gsi, disturbance;
  double mb_per_mi, s, a;    // to 16 digits, by arbitrary-precision arithmetic
};

const Rock ROCKS[] = {
    {100.0, 0.0, 1, 1, 0.5},
    {100.0, 1.0, 1, 1, 0.5},
    {75.0, 0.0, 0.40948412515236421, 0.062176524022116313, 0.50091088553295759},
    {75.0, 1.0, 0.1676772487517971, 0.015503853599009319, 0.50091088553295759},
    {50.0, 0.0, 0.1676772487517971, 0.0038659201394728067, 0.50573355992431879},
    {50.0, 1.0, 0.028115659748972038, 0.00024036947641951421, 0.50573355992431879},
};

class Rocks : public ::testing::TestWithParam<Rock> {
 protected:
  const HoekBrown rock = HoekBrown({SIGMA_C, MI, GetParam().gsi, GetParam().disturbance});

  /// strengths from the definitions; for a = 1/2 the roots are closed, else found by bisection
  double compression() const { return SIGMA_C * std::pow(rock.s, rock.a); }
  double biaxial_tension() const { return rock.s * SIGMA_C / rock.mb; }
  double tension() const
  {
    if (rock.a == 0.5)
      return 0.5 * SIGMA_C * (std::sqrt(rock.mb * rock.mb + 4.0 * rock.s) - rock.mb);
    double low = 0.0, high = biaxial_tension();
    for (int k = 0; k < 200; k++) {
      const double t = 0.5 * (low + high);
      (t < SIGMA_C * std::pow(rock.s - rock.mb * t / SIGMA_C, rock.a) ? low : high) = t;
    }
    return low;
  }
};

Principals times(const Principals &e, double factor)
{
  return {e.largest * factor, e.middle * factor, e.smallest * factor};
}

TEST_P(Rocks, constants)
{
  EXPECT_NEAR(rock.mb / (MI * GetParam().mb_per_mi), 1.0, 1.0e-14);
  EXPECT_NEAR(rock.s / GetParam().s, 1.0, 1.0e-14);
  EXPECT_NEAR(rock.a / GetParam().a, 1.0, 1.0e-14);
  EXPECT_EQ(rock.a == 0.5, GetParam().gsi == 100.0);
}

// required: the strength is met within 0.1 %; here to 1e-10
TEST_P(Rocks, strengths)
{
  const double c = compression(), t = tension(), b = biaxial_tension();
  for (const Principals &e :
       {Principals{0.0, 0.0, -c}, Principals{t, 0.0, 0.0}, Principals{b, b, b}}) {
    for (double above : {1.0 + 1.0e-10, 1.001, 2.0, 100.0})
      EXPECT_TRUE(rock.fails(times(e, above), SIGMA_C)) << e.largest << " " << e.smallest;
    for (double below : {1.0 - 1.0e-10, 0.999, 0.5, 0.0})
      EXPECT_FALSE(rock.fails(times(e, below), SIGMA_C)) << e.largest << " " << e.smallest;
    EXPECT_NEAR(rock.load_factor(e, SIGMA_C), 1.0, 1.0e-12);
  }
}

INSTANTIATE_TEST_SUITE_P(All, Rocks, ::testing::ValuesIn(ROCKS), [](const auto &info) {
  return "gsi" + std::to_string((int) info.param.gsi) + "_d" +
      std::to_string((int) info.param.disturbance);
});

}    // namespace
