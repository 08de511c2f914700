/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Walls to be drawn, where they are now.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_PICTURE_H
#define LMP_TMSPH_WALL_PICTURE_H

#include "domain.h"
#include "tmsph_wall_scene.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <vector>

namespace LAMMPS_NS {

/** Lines of two points in 2-D, triangles in 3-D. */
using TMSPHWallPieces = std::vector<std::vector<TMSPH::Point>>;

/// of a wall: a plane as far as the box is seen
inline TMSPHWallPieces wall_pieces(const TMSPHWallScene &scene, const Domain &domain)
{
  TMSPH::Point middle;
  double square = 0.0;
  for (int k = 0; k < 3; k++) {
    middle[k] = 0.5 * (domain.boxlo[k] + domain.boxhi[k]);
    square += domain.prd[k] * domain.prd[k];
  }
  std::vector<TMSPH::Point> points =
      scene.shape->picture(scene.motion.to_body(middle), std::sqrt(square));
  for (TMSPH::Point &p : points) p = scene.motion.to_space(p);
  TMSPHWallPieces out;
  const bool flat = domain.dimension == 2;
  for (size_t n = flat ? 0 : 1; n + 1 < points.size(); n++) {
    out.emplace_back();
    if (!flat) out.back().push_back(points[0]);    // triangles share the first corner
    out.back().push_back(points[n]);
    out.back().push_back(points[n + 1]);
  }
  return out;
}

/** In the form of Fix::image(). */
class TMSPHWallPicture {
 public:
  void clear() { rows.clear(); }
  void add(const TMSPHWallPieces &pieces)
  {
    for (const auto &piece : pieces) {
      std::array<double, 10> row = {1.0};
      double *to = row.data() + 1;
      for (const TMSPH::Point &p : piece) to = std::copy(p.begin(), p.end(), to);
      rows.push_back(row);
    }
  }
  /// @return number of objects
  int show(int dimension, int *&of_kind, double **&of_row)
  {
    enum { LINE = 1, TRIANGLE = 2 };    // as in dump_image.cpp
    values.clear();
    for (auto &row : rows) values.push_back(row.data());
    kinds.assign(rows.size(), dimension == 2 ? LINE : TRIANGLE);
    of_kind = kinds.data();
    of_row = values.data();
    return rows.size();
  }

 private:
  std::vector<std::array<double, 10>> rows;    // a type, then corners
  std::vector<double *> values;
  std::vector<int> kinds;
};

}    // namespace LAMMPS_NS
#endif
