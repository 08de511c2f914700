/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Eight doubles side by side: loads, stores and the transposing row loads.
------------------------------------------------------------------------- */

#include "tmsph_lanes.h"

#include <gtest/gtest.h>

#include <numeric>
#include <vector>

using namespace TMSPH;

namespace {

TEST(LanesOfEight, load_and_store_need_no_alignment)
{
  std::vector<double> from(LANES + 1), to(LANES + 1, -1.0);
  std::vector<float> narrow(LANES + 1);
  std::iota(from.begin(), from.end(), 0.25);
  std::iota(narrow.begin(), narrow.end(), 0.25f);
  store(to.data() + 1, load(from.data() + 1));
  for (int l = 0; l < LANES; l++) EXPECT_EQ(to[l + 1], from[l + 1]);
  EXPECT_EQ(to[0], -1.0);
  const Lanes wide = load(narrow.data() + 1);
  for (int l = 0; l < LANES; l++) EXPECT_EQ(wide[l], l + 1.25);
}

TEST(LanesOfEight, rows_are_transposed)
{
  constexpr int STRIDE = 16, ROWS = 11;
  std::vector<double> base(STRIDE * ROWS);
  std::iota(base.begin(), base.end(), 0.0);
  const int row[LANES] = {3, 0, 10, 7, 7, 1, 9, 4};
  Lanes out[12];
  load_rows<12>(base.data(), STRIDE, row, out);
  for (int k = 0; k < 12; k++)
    for (int l = 0; l < LANES; l++) EXPECT_EQ(out[k][l], STRIDE * row[l] + k);
}

TEST(LanesOfEight, arithmetic)
{
  const Lanes a = {0.0, 1.0, 2.0, 4.0, 1e-300, 1e300, 9.0, 2.25}, b = broadcast(2.0);
  const Lanes root = square_root(a), least = minimum(a, b);
  for (int l = 0; l < LANES; l++) {
    EXPECT_EQ(b[l], 2.0);
    EXPECT_EQ(root[l], std::sqrt(a[l]));
    EXPECT_EQ(least[l], std::fmin(a[l], 2.0));
  }
}

}    // namespace
