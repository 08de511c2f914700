/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Outlines of blocks with a hole, on lattices and displaced: one ring around
   each, closed, with the body on the right, around the right area.
------------------------------------------------------------------------- */

#include "tmsph_outline.h"

#include <gtest/gtest.h>

#include <array>
#include <random>

using namespace TMSPH;

namespace {

using Place = std::array<double, 2>;

constexpr double HORIZON = 3.015;
constexpr int N = 20;

/// a block of N x N with a round hole in it; every other row shifted: the rows of a hexagonal
/// lattice
std::vector<Place> block_with_hole(bool hexagonal, double jitter)
{
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> shift(-jitter, jitter);
  std::vector<Place> places;
  for (int i = 0; i < N; i++)
    for (int j = 0; j < N; j++) {
      const Place p = {i + (hexagonal && j % 2 ? 0.5 : 0.0), hexagonal ? j * std::sqrt(0.75) : j};
      if (std::hypot(p[0] - 0.5 * N, p[1] - 0.4 * N) > 4.0)
        places.push_back({p[0] + shift(random), p[1] + shift(random)});
    }
  return places;
}

std::vector<std::pair<int, int>> segments_of(const std::vector<Place> &places)
{
  std::vector<std::pair<int, int>> segments;
  for (int i = 0; i < (int) places.size(); i++) {
    OutlineSegments outline;
    std::vector<int> ends;
    for (int j = 0; j < (int) places.size(); j++) {
      const double X[2] = {places[j][0] - places[i][0], places[j][1] - places[i][1]};
      if (j == i || std::hypot(X[0], X[1]) >= HORIZON) continue;
      outline.add(X);
      ends.push_back(j);
    }
    for (int n = 0; n < (int) ends.size(); n++)
      if (outline.leads_to(n, ROLLING)) segments.emplace_back(i, ends[n]);
  }
  return segments;
}

void check(bool hexagonal, double jitter)
{
  const std::vector<Place> places = block_with_hole(hexagonal, jitter);
  std::vector<int> nodes;
  const std::vector<int> lengths = chains_of(segments_of(places), nodes);
  ASSERT_EQ(lengths.size(), 2u);
  double areas[2];
  for (int c = 0, first = 0; c < 2; first += lengths[c++]) {
    EXPECT_EQ(nodes[first], nodes[first + lengths[c] - 1]);
    areas[c] = 0.0;
    for (int n = first; n + 1 < first + lengths[c]; n++) {
      const Place &p = places[nodes[n]], &q = places[nodes[n + 1]];
      areas[c] += 0.5 * (p[0] * q[1] - p[1] * q[0]);
    }
  }

  // outside clockwise; each goes through particles that are half a spacing inside the body

  const double row = hexagonal ? std::sqrt(0.75) : 1.0, outer = (N - 1) * (N - 1) * row;
  const double hole = 3.14159265358979 * 4.5 * 4.5;
  EXPECT_NEAR(std::min(areas[0], areas[1]), -outer, 0.06 * outer);
  EXPECT_NEAR(std::max(areas[0], areas[1]), hole, 0.15 * hole);
}

}    // namespace

TEST(Outline, Square)
{
  check(false, 0.0);
}

TEST(Outline, Hexagonal)
{
  check(true, 0.0);
}

TEST(Outline, Displaced)
{
  check(false, 0.2);
  check(true, 0.2);
}

TEST(Outline, DistanceFromSegment)
{
  const double a[2] = {1.0, 1.0}, b[2] = {4.0, 1.0};
  const double above[2] = {2.0, 3.0}, beyond[2] = {7.0, 5.0};
  EXPECT_DOUBLE_EQ(square_from_segment(above, a, b), 4.0);
  EXPECT_DOUBLE_EQ(square_from_segment(beyond, a, b), 25.0);
  EXPECT_DOUBLE_EQ(square_from_segment(above, a, a), 5.0);
}
