/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Sums that do not depend on the order of their terms, and so not on how
   particles are spread over processors: integers in a common unit.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_FIXED_POINT_H
#define LMP_TMSPH_FIXED_POINT_H

#include <algorithm>
#include <cmath>
#include <cstdint>

namespace TMSPH {

/** The number of units in 1 such that terms whose absolute values add up to at most "bound" cannot
    overflow 64 bits with their sign; a power of two in the range of doubles, so that scaling is
    exact. */
inline double fixed_point_scale(double bound)
{
  if (!(bound > 0.0) || !std::isfinite(bound)) return 0.0;
  int exponent;
  std::frexp(bound, &exponent);
  return std::ldexp(1.0, std::clamp(62 - exponent, -1000, 1000));
}

/// the integer sum of a_i b_i over n terms
inline std::int64_t fixed_point_dot(int n, const double *a, const double *b, double scale)
{
  std::int64_t sum = 0;
  for (int i = 0; i < n; i++) sum += (std::int64_t)(a[i] * b[i] * scale);
  return sum;
}

inline double largest_magnitude(int n, const double *a)
{
  double largest = 0.0;
  for (int i = 0; i < n; i++) largest = std::max(largest, std::fabs(a[i]));
  return largest;
}

}    // namespace TMSPH
#endif
