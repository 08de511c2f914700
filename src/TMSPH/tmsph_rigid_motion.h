/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Position of a rigid wall: shifted, and turned about an axis through a pivot
   that moves along. In 2-D the axis is z.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RIGID_MOTION_H
#define LMP_TMSPH_RIGID_MOTION_H

#include "tmsph_wall_shape.h"

#include <cmath>

namespace TMSPH {

struct RigidMotion {
  Point pivot = {0.0, 0.0, 0.0};       ///< at the start
  Point axis = {0.0, 0.0, 1.0};        ///< unit vector
  Point shift = {0.0, 0.0, 0.0};       ///< since then
  double angle = 0.0;                  ///< radians, since then
  Point velocity = {0.0, 0.0, 0.0};    ///< of the pivot
  double spin = 0.0;                   ///< radians per time

  /// where the pivot is now
  Point centre() const { return {pivot[0] + shift[0], pivot[1] + shift[1], pivot[2] + shift[2]}; }

  /// v turned by the angle, or back (Rodrigues' formula)
  Point turned(const Point &v, bool back = false) const
  {
    if (angle == 0.0) return v;
    const double c = std::cos(angle), s = back ? -std::sin(angle) : std::sin(angle);
    double along = 0.0;
    for (int k = 0; k < 3; k++) along += axis[k] * v[k];
    Point r;
    for (int k = 0; k < 3; k++) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      r[k] = c * v[k] + s * (axis[l] * v[m] - axis[m] * v[l]) + (1.0 - c) * along * axis[k];
    }
    return r;
  }

  /// a point in space, as seen by the wall where it stood at the start
  Point to_body(const Point &x) const
  {
    const Point c = centre();
    const Point r = turned({x[0] - c[0], x[1] - c[1], x[2] - c[2]}, true);
    return {pivot[0] + r[0], pivot[1] + r[1], pivot[2] + r[2]};
  }

  /// the inverse of to_body
  Point to_space(const Point &x) const
  {
    const Point c = centre();
    const Point r = turned({x[0] - pivot[0], x[1] - pivot[1], x[2] - pivot[2]});
    return {c[0] + r[0], c[1] + r[1], c[2] + r[2]};
  }

  /// of the wall at a point in space
  Point velocity_at(const Point &x) const
  {
    const Point c = centre();
    Point v = velocity;
    if (spin == 0.0) return v;
    for (int k = 0; k < 3; k++) {
      const int l = (k + 1) % 3, m = (k + 2) % 3;
      v[k] += spin * (axis[l] * (x[m] - c[m]) - axis[m] * (x[l] - c[l]));
    }
    return v;
  }
};

}    // namespace TMSPH
#endif
