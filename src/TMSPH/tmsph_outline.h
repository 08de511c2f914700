/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The outline of a body of particles in the plane: segments between its outer
   particles, found by each of them from its neighbors. Holes have one too.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OUTLINE_H
#define LMP_TMSPH_OUTLINE_H

#include <algorithm>
#include <cmath>
#include <utility>
#include <vector>

namespace TMSPH {

/** Radius of the disc that rolls around the outline, in particle spacings: larger than any gap
    between particles inside, also if they are displaced by a fifth of the spacing. It does not
    enter dents that are narrower. */
constexpr double ROLLING = 1.1;

/** Neighbors of a particle of the same body. A segment leads from the particle to a neighbor if a
    disc that touches both from the left has nobody inside (Edelsbrunner's alpha shape). */
class OutlineSegments {
 public:
  /// neighbor with reference vector X
  void add(const double *X) { neighbors.push_back({X[0], X[1]}); }

  /// does a segment lead to the n-th neighbor, with the outside on its left?
  bool leads_to(int n, double radius) const
  {
    const Vector &X = neighbors[n];
    const double square = X.x * X.x + X.y * X.y;
    if (square >= 4.0 * radius * radius) return false;
    const double left = std::sqrt(radius * radius / square - 0.25);
    const Vector centre = {0.5 * X.x - left * X.y, 0.5 * X.y + left * X.x};
    const double inside = radius * radius * (1.0 - TOUCHING);
    for (int k = 0; k < (int) neighbors.size(); k++) {
      const double dx = neighbors[k].x - centre.x, dy = neighbors[k].y - centre.y;
      if (k != n && dx * dx + dy * dy < inside) return false;
    }
    return true;
  }

 private:
  static constexpr double TOUCHING = 1.0e-6;    // of the square of the radius: round-off
  struct Vector {
    double x, y;
  };
  std::vector<Vector> neighbors;
};

/** Puts segments end to end.
    @param segments start and end of each, in an order that does not depend on the processor
    @param nodes    particles of all chains one after the other are added
    @return         number of nodes of each chain; a closed one has its first node at its end too */
inline std::vector<int> chains_of(std::vector<std::pair<int, int>> segments,
                                  std::vector<int> &nodes)
{
  std::vector<int> lengths;
  while (!segments.empty()) {
    const auto starts = [&](const std::pair<int, int> &s) {
      return std::none_of(segments.begin(), segments.end(),
                          [&s](const std::pair<int, int> &t) { return t.second == s.first; });
    };
    auto next = std::find_if(segments.begin(), segments.end(), starts);
    if (next == segments.end()) next = segments.begin();    // a ring
    int count = 1;
    nodes.push_back(next->first);
    while (next != segments.end()) {
      const int end = next->second;
      nodes.push_back(end);
      count++;
      segments.erase(next);
      next = std::find_if(segments.begin(), segments.end(),
                          [end](const std::pair<int, int> &s) { return s.first == end; });
    }
    lengths.push_back(count);
  }
  return lengths;
}

/// square of the distance of p from the segment from a to b
inline double square_from_segment(const double *p, const double *a, const double *b)
{
  const double d[2] = {b[0] - a[0], b[1] - a[1]}, r[2] = {p[0] - a[0], p[1] - a[1]};
  const double length = d[0] * d[0] + d[1] * d[1];
  const double along =
      length > 0.0 ? std::min(1.0, std::max(0.0, (r[0] * d[0] + r[1] * d[1]) / length)) : 0.0;
  const double off[2] = {r[0] - along * d[0], r[1] - along * d[1]};
  return off[0] * off[0] + off[1] * off[1];
}

}    // namespace TMSPH
#endif
