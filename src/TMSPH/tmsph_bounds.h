/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The box around a shape: does it fit into a period, and which of its periodic
   images reach to a place?
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOUNDS_H
#define LMP_TMSPH_BOUNDS_H

#include <algorithm>
#include <cmath>

namespace TMSPH {

struct Bounds {
  static constexpr double ROUND = 1.0e-9;    // lengths that differ by less are equal: round-off
  static constexpr double NEAR = 1.0e-8;     // of a period: what round-off leaves on a shape, amply
  double low[3] = {HUGE_VAL, HUGE_VAL, HUGE_VAL};
  double high[3] = {-HUGE_VAL, -HUGE_VAL, -HUGE_VAL};

  double length(int k) const { return high[k] - low[k]; }

  template <class Vector> void add(const Vector &x, int dimension = 3)
  {
    for (int k = 0; k < dimension; k++) {
      low[k] = std::min(low[k], x[k]);
      high[k] = std::max(high[k], x[k]);
    }
  }

  /// an arc in the plane, from angle "start" over "sweep" of either sign, in radians
  template <class Vector>
  void add_arc(const Vector &centre, double radius, double start, double sweep)
  {
    const double QUARTER = std::acos(0.0);
    const auto point = [&](double angle) {
      const double x[2] = {centre[0] + radius * std::cos(angle),
                           centre[1] + radius * std::sin(angle)};
      add(x, 2);
    };
    const double first = std::min(start, start + sweep);
    const double last = std::min(std::max(start, start + sweep), first + 4.0 * QUARTER);
    point(first);
    point(last);
    for (double n = std::ceil(first / QUARTER); n * QUARTER < last; n++) point(n * QUARTER);
  }

  /// a shape that is longer than a period would overlap its images
  bool repeats(int k, double period) const
  {
    return period > 0.0 && length(k) <= (1.0 + ROUND) * period;
  }

  /** By how many periods the shape may be shifted to reach to the places between a and b, or next
      to them.
      @return false if by none */
  bool images(int k, double period, double a, double b, int &first, int &last) const
  {
    first = (int) std::ceil((std::min(a, b) - high[k]) / period - NEAR);
    last = (int) std::floor((std::max(a, b) - low[k]) / period + NEAR);
    return first <= last;
  }
};

}    // namespace TMSPH
#endif
