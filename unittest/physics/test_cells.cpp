/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Points found near others are those that a search of all pairs finds, also
   when some are further away than cells can be numbered, or there are none.
------------------------------------------------------------------------- */

#include "tmsph_cells.h"

#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <limits>
#include <random>

using namespace TMSPH;

namespace {

using Place = std::array<double, 3>;

constexpr double REACH = 0.3;
constexpr double NOT_A_NUMBER = std::numeric_limits<double>::quiet_NaN();

class Found {
 public:
  explicit Found(std::vector<Place> all) : places(std::move(all))
  {
    for (Place &p : places) x.push_back(p.data());
    for (int i = 0; i < (int) places.size(); i++) members.push_back(i);
  }

  /// members within REACH of p, by cells and by all pairs
  std::array<std::vector<int>, 2> near(const Place &p) const
  {
    const auto within = [&](int i) {
      double square = 0.0;
      for (int a = 0; a < 3; a++) square += std::pow(places[i][a] - p[a], 2);
      return square < REACH * REACH;
    };
    std::array<std::vector<int>, 2> found;
    Cells(x.data(), members, REACH).near(p.data(), [&](int i) {
      if (within(i)) found[0].push_back(i);
    });
    std::sort(found[0].begin(), found[0].end());
    std::copy_if(members.begin(), members.end(), std::back_inserter(found[1]), within);
    return found;
  }

 private:
  std::vector<Place> places;
  std::vector<const double *> x;
  std::vector<int> members;
};

/// points in a unit cube, and the same cube shifted by "far" in all directions
std::vector<Place> two_clouds(double far)
{
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> in_cube(0.0, 1.0);
  std::vector<Place> places;
  for (int n = 0; n < 100; n++) {
    const Place p = {in_cube(random), in_cube(random), in_cube(random)};
    places.push_back(p);
    places.push_back({p[0] + far, p[1] + far, p[2] + far});
  }
  return places;
}

}    // namespace

TEST(Cells, FindAllNear)
{
  for (const double far : {0.5, 1.0e3, 1.0e6, 1.0e9, 1.0e300}) {
    const std::vector<Place> places = two_clouds(far);
    const Found all(places);
    int count = 0;
    for (const Place &p : places) {
      const auto found = all.near(p);
      EXPECT_EQ(found[0], found[1]) << "far " << far;
      count += found[1].size();
    }
    EXPECT_GT(count, (int) places.size()) << "far " << far;
  }
}

TEST(Cells, PointsOutside)
{
  const Found all(two_clouds(0.5));
  for (const double x : {-1.0e300, -10.0, -0.29, -0.01, 1.51, 1.79, 10.0, 1.0e300}) {
    const auto found = all.near({x, 0.7, 0.7});
    EXPECT_EQ(found[0], found[1]) << "x " << x;
  }
}

TEST(Cells, NobodyThere)
{
  EXPECT_TRUE(Found({}).near({0.0, 0.0, 0.0})[0].empty());
  EXPECT_TRUE(Found(two_clouds(0.5)).near({NOT_A_NUMBER, 0.5, 0.5})[0].empty());
  EXPECT_TRUE(Found({{NOT_A_NUMBER, 0.0, 0.0}}).near({0.0, 0.0, 0.0})[0].empty());
}
