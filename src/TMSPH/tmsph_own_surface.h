/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The surface of a body near one of its particles, as the bonds of the particle
   show it: where it has none is outside. For surfaces that meet other ones
   than those they faced in the reference state.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OWN_SURFACE_H
#define LMP_TMSPH_OWN_SURFACE_H

#include <algorithm>
#include <cmath>
#include <vector>

namespace TMSPH {

/// GIVEN: a surface that is known exactly
enum class Exposure { INSIDE, SURFACE, LOOSE, GIVEN };

/** Reference surface near a particle. */
struct Surface {
  Exposure exposure = Exposure::INSIDE;
  double normal[3] = {};    ///< outward, of unit length; 0 of a loose particle
  double depth = 0.0;       ///< of the particle below it
};

/** Collects the bonds of a particle and finds the surface near it. */
template <int D> class OwnSurface {
 public:
  /// a bond that holds, with reference vector X and weight V w
  void add(const double *X, double weight)
  {
    double R2 = 0.0;
    for (int a = 0; a < D; a++) {
      ends.push_back(X[a]);
      sum[a] -= weight * X[a];
      R2 += X[a] * X[a];
    }
    lengths += weight * std::sqrt(R2);
  }

  /** @param spacing of the particles; a surface is half of it outside the outermost one
      @param least   one_sidedness() that a surface has at least
      @return        LOOSE with too few bonds for a deformation gradient, INSIDE where they pull
                     about evenly */
  Surface find(double spacing, double least = ONE_SIDED) const
  {
    Surface s;
    s.depth = 0.5 * spacing;
    if ((int) ends.size() <= D * D) {
      s.exposure = Exposure::LOOSE;
      return s;
    }
    const double length = length_of_sum();
    if (length < least * lengths) return s;
    s.exposure = Exposure::SURFACE;
    for (int a = 0; a < D; a++) s.normal[a] = sum[a] / length;

    // outermost of the neighbors that stand over the particle rather than beside it

    double above = 0.0;
    for (size_t n = 0; n < ends.size(); n += D) {
      double height = 0.0, R2 = 0.0;
      for (int a = 0; a < D; a++) {
        height += s.normal[a] * ends[n + a];
        R2 += ends[n + a] * ends[n + a];
      }
      if (height > 0.0 && 2.0 * height * height >= R2) above = std::max(above, height);
    }
    s.depth += above;
    return s;
  }

  /// length of the sum of all weighted bonds/sum of their lengths: 0 inside, about 1/2 at a surface
  double one_sidedness() const { return lengths > 0.0 ? length_of_sum() / lengths : 0.0; }

  /// length of the sum of all weighted bonds
  double length_of_sum() const
  {
    double square = 0.0;
    for (int a = 0; a < D; a++) square += sum[a] * sum[a];
    return std::sqrt(square);
  }

  /** Depth below a surface along which the particles stand in rows: half of their distance outside
      the outermost one.
      @param surface as found
      @return        its depth where there are no rows */
  double depth_of_rows(const Surface &surface, double spacing) const
  {
    std::vector<double> heights(1, 0.0);
    for (size_t n = 0; n < ends.size(); n += D) {
      double height = 0.0;
      for (int a = 0; a < D; a++) height += surface.normal[a] * ends[n + a];
      heights.push_back(height);
    }
    std::sort(heights.begin(), heights.end());
    const double outermost = heights.back();
    double gap = 0.0;
    for (size_t n = heights.size() - 1; n > 0; n--) {
      const double next = heights[n] - heights[n - 1];
      if (next < SAME_ROW * spacing) continue;
      if (gap == 0.0) gap = next;
      if (std::fabs(next - gap) > SAME_ROW * spacing) return surface.depth;
    }
    return gap > 0.0 ? outermost + 0.5 * gap : surface.depth;
  }

 private:
  // particles in a row differ in height by less than this fraction of the spacing, which positions
  // lose in files

  static constexpr double SAME_ROW = 1.0e-4;

  // length of the sum of all weighted bonds/sum of their lengths that a surface has at least: of
  // the second row below a flat one it is 0.06 in 2-D, 0.04 in 3-D; the third has none

  static constexpr double ONE_SIDED = 0.03;
  std::vector<double> ends;
  double sum[D] = {}, lengths = 0.0;    // of the weighted bonds
};

}    // namespace TMSPH
#endif
