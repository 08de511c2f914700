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
    all += weight * std::sqrt(R2);
  }

  /** @param spacing of the particles; a surface is half of it outside the outermost one
      @return        LOOSE with too few bonds for a deformation gradient, INSIDE where they pull
                     about evenly */
  Surface find(double spacing) const
  {
    Surface s;
    s.depth = 0.5 * spacing;
    if ((int) ends.size() <= D * D) {
      s.exposure = Exposure::LOOSE;
      return s;
    }
    double square = 0.0;
    for (int a = 0; a < D; a++) square += sum[a] * sum[a];
    const double length = std::sqrt(square);
    if (length < ONE_SIDED * all) return s;
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

 private:
  // length of the sum of all weighted bonds/sum of their lengths that a surface has at least: of the
  // second row below a flat one it is 0.06 in 2-D, 0.04 in 3-D; the third has none

  static constexpr double ONE_SIDED = 0.03;
  std::vector<double> ends;
  double sum[D] = {}, all = 0.0;
};

}    // namespace TMSPH
#endif
