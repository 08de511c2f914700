/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Points found again on a grid are those that a search of all points finds first:
   also across cells, where several are the same, with few and many to a cell, and outside.
------------------------------------------------------------------------- */

#include "tmsph_point_grid.h"

#include <gtest/gtest.h>

#include <random>

using namespace TMSPH;

namespace {

template <int D> void find_all(double half, double cell, double within)
{
  using Vector = typename PointGrid<D>::Vector;
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> place(-1.2, 1.2), shift(-1.0, 1.0);
  PointGrid<D> grid(half, cell);
  std::vector<Vector> points;
  const auto somewhere = [&](auto &distribution) {
    Vector X;
    for (int a = 0; a < D; a++) X[a] = distribution(random);
    return X;
  };
  for (int n = 0; n < 300; n++) {
    Vector X = half * somewhere(place);
    if (n % 3 == 0)    // at the edges of cells
      for (int a = 0; a < D; a++) X[a] = cell * std::round(X[a] / cell);
    if (n % 7 == 6) X = points[n / 2] + 0.1 * within * somewhere(shift);
    points.push_back(X);
    grid.add(X);
  }
  int found = 0;
  for (int n = 0; n < 300; n++) {
    const Vector X = points[n] + (n % 2 ? 1.0 : 0.1) * within * somewhere(shift);
    const auto same = [&](int k) { return (points[k] - X).squaredNorm() < within * within; };
    int first = 0;
    while (first < 300 && !same(first)) first++;
    EXPECT_EQ(grid.find(X, within, same), first < 300 ? first : -1);
    found += first < 300;
  }
  EXPECT_GT(found, 150);
  EXPECT_LT(found, 300);
}

}    // namespace

TEST(PointGrid, finds_the_first)
{
  for (const double cell : {0.01, 0.1, 0.25, 1.0, 5.0})
    for (const double within : {1.0e-4, 1.0e-2}) {
      find_all<2>(1.0, cell, within);
      find_all<3>(1.0, cell, within);
      find_all<3>(1.0e-3, 1.0e-3 * cell, 1.0e-3 * within);
    }
}
