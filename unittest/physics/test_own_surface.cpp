/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Surfaces of lattices as the bonds of their particles show them, and the
   search of points near a point against all pairs.
------------------------------------------------------------------------- */

#include "tmsph_cells.h"
#include "tmsph_own_surface.h"

#include <gtest/gtest.h>

#include <random>
#include <set>

using namespace TMSPH;

namespace {

constexpr double HORIZON = 3.015;

/// bonds of a particle "depth" rows below the flat top of a lattice of spacing 1 whose rows go
/// along x, y; "shift" moves every second row along x, "stretch" is the distance of rows
template <int D> OwnSurface<D> bonds_below_flat(int depth, double shift = 0.0, double stretch = 1.0)
{
  OwnSurface<D> own;
  const int n = 3;
  for (int i = -n; i <= n; i++)
    for (int j = -n; j <= (D == 2 ? depth : n); j++)
      for (int k = -n; k <= (D == 2 ? -n : depth); k++) {
        double X[3] = {double(i), double(j), double(k)};
        const int row = D == 2 ? j : k;
        X[D - 1] *= stretch;
        X[0] += row % 2 ? shift : 0.0;
        double R = 0.0;
        for (int a = 0; a < D; a++) R += X[a] * X[a];
        R = std::sqrt(R);
        if (R > 0.0 && R < HORIZON) own.add(X, std::pow(1.0 - R / HORIZON, 3));
      }
  return own;
}

template <int D> Surface below_flat(int depth)
{
  return bonds_below_flat<D>(depth).find(1.0);
}

template <int D> void check_flat()
{
  for (int depth = 0; depth < 2; depth++) {
    const Surface s = below_flat<D>(depth);
    ASSERT_EQ(s.exposure, Exposure::SURFACE);
    for (int a = 0; a < D; a++) EXPECT_NEAR(s.normal[a], a == D - 1 ? 1.0 : 0.0, 1e-14);
    EXPECT_NEAR(s.depth, depth + 0.5, 1e-14);
  }
  EXPECT_EQ(below_flat<D>(3).exposure, Exposure::INSIDE);
}

TEST(OwnSurface, flat)
{
  check_flat<2>();
  check_flat<3>();
}

/// half of the distance of the rows outside the outermost one, whatever the depth and the rows
template <int D> void check_rows()
{
  for (double shift : {0.0, 0.5})
    for (double distance : {1.0, std::sqrt(0.75), 1.2})
      for (int depth = 0; depth < 3; depth++) {
        const auto own = bonds_below_flat<D>(depth, shift, distance);
        Surface s;
        s.normal[D - 1] = 1.0;
        s.depth = -1.0;
        EXPECT_NEAR(own.depth_of_rows(s, 1.0), (depth + 0.5) * distance, 1e-14)
            << shift << " " << distance << " " << depth;
      }
}

TEST(OwnSurface, depth_of_rows)
{
  check_rows<2>();
  check_rows<3>();
}

TEST(OwnSurface, depth_without_rows)
{
  OwnSurface<2> own = bonds_below_flat<2>(1);
  Surface s;
  s.normal[0] = std::sin(0.2);    // no rows along this surface
  s.normal[1] = std::cos(0.2);
  s.depth = 1.4;
  EXPECT_EQ(own.depth_of_rows(s, 1.0), 1.4);
  EXPECT_EQ(OwnSurface<2>().depth_of_rows(s, 1.0), 1.4);    // nor without bonds
  s.normal[0] = 0.0;
  s.normal[1] = 1.0;
  const double odd[2] = {0.3, -0.6};    // one particle between the rows
  own.add(odd, 1.0);
  EXPECT_EQ(own.depth_of_rows(s, 1.0), 1.4);
}

/// 0 where bonds pull evenly; in the outermost row below that of a particle with all matter on one
/// side, the mean of a cosine over half a circle or sphere
TEST(OwnSurface, one_sidedness)
{
  EXPECT_EQ(OwnSurface<2>().one_sidedness(), 0.0);
  EXPECT_LT(bonds_below_flat<2>(3).one_sidedness(), 1e-15);
  EXPECT_LT(bonds_below_flat<3>(3).one_sidedness(), 1e-15);
  EXPECT_GT(bonds_below_flat<2>(0).one_sidedness(), 0.3);
  EXPECT_LT(bonds_below_flat<2>(0).one_sidedness(), 2.0 / 3.14159265358979);
  EXPECT_GT(bonds_below_flat<3>(0).one_sidedness(), 0.3);
  EXPECT_LT(bonds_below_flat<3>(0).one_sidedness(), 0.5);
}

TEST(OwnSurface, no_gradient_no_surface)
{
  OwnSurface<2> own;
  EXPECT_EQ(own.find(1.0).exposure, Exposure::LOOSE);
  const double right[2] = {1.0, 0.0}, up[2] = {0.0, 1.0}, both[2] = {1.0, 1.0};
  own.add(right, 1.0);
  own.add(up, 1.0);
  EXPECT_EQ(own.find(1.0).exposure, Exposure::LOOSE);
  EXPECT_DOUBLE_EQ(own.find(1.0).depth, 0.5);
  own.add(both, 1.0);
  const Surface s = own.find(1.0);
  ASSERT_EQ(s.exposure, Exposure::SURFACE);
  EXPECT_NEAR(s.normal[0], -std::sqrt(0.5), 1e-14);
  EXPECT_NEAR(s.normal[1], -std::sqrt(0.5), 1e-14);
}

TEST(Cells, finds_all_within_reach)
{
  std::mt19937 random(7);
  std::uniform_real_distribution<double> uniform(-5.0, 5.0);
  double points[300][3];
  const double *x[300];
  std::vector<int> members;
  for (int i = 0; i < 300; i++) {
    for (double &v : points[i]) v = uniform(random);
    x[i] = points[i];
    if (i % 3) members.push_back(i);
  }
  const double reach = 1.7;
  const Cells cells(x, members, reach);
  int found = 0;
  for (int i = 0; i < 300; i++) {
    std::multiset<int> near;
    cells.near(x[i], [&](int j) { near.insert(j); });
    for (const int j : members) {
      double r2 = 0.0;
      for (int a = 0; a < 3; a++) r2 += (x[j][a] - x[i][a]) * (x[j][a] - x[i][a]);
      EXPECT_LE(near.count(j), 1u);
      if (r2 >= reach * reach) continue;
      EXPECT_EQ(near.count(j), 1u) << i << " " << j;
      found++;
    }
  }
  EXPECT_GT(found, 1000);
  const double far[3] = {100.0, 0.0, 0.0};
  cells.near(far, [](int) { FAIL(); });
  Cells(x, {}, reach).near(far, [](int) { FAIL(); });
}

}    // namespace
