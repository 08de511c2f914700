/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Does a bond cross a flaw? Flaws in 2-D: line segment, circular arc; in 3-D:
   flat disc, flat polygon. A particle on a flaw counts to one side of it, always
   the same, so that no bond is cut twice or missed; a bond that meets the rim of
   a flaw is cut.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_GEOMETRY_H
#define LMP_TMSPH_GEOMETRY_H

#include "tmsph_pi.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <vector>

namespace TMSPH {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

/// of positions, in sizes of a flaw, at most: far less than a particle spacing
constexpr double ROUND_OFF = 1.0e-9;

inline double cross(const Point2 &a, const Point2 &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/** Which of the two sides of a flaw: a point that is on the flaw but for round-off counts to the
    side of positive heights, in whatever axes.
    @param length size of the flaw */
inline bool above(double height, double length)
{
  return height >= -ROUND_OFF * length;
}

/// Where a bond crosses a flaw of which its ends have heights on different sides: 0 to 1.
inline double crossing(double height_a, double height_b)
{
  return std::clamp(height_a / (height_a - height_b), 0.0, 1.0);
}

/// Bond from a to b, flaw from p to q.
inline bool crosses_segment(const Point2 &a, const Point2 &b, const Point2 &p, const Point2 &q)
{
  const double length = (q - p).norm();
  const Point2 e = (q - p) / length;
  const double ha = cross(e, a - p), hb = cross(e, b - p);
  if (above(ha, length) == above(hb, length)) return false;
  const double along = (a + crossing(ha, hb) * (b - a) - p).dot(e);
  return above(along, length) && above(length - along, length);
}

/// Flaw: arc about "center", counterclockwise from angle "start" (radians) over "sweep" > 0.
inline bool crosses_arc(const Point2 &a, const Point2 &b, const Point2 &center, double radius,
                        double start, double sweep)
{
  const Point2 d = b - a, r = a - center;
  const bool outside_a = above(r.norm() - radius, radius);
  const bool outside_b = above((b - center).norm() - radius, radius);
  if (!outside_a && !outside_b) return false;
  const double A = d.squaredNorm(), B = r.dot(d), C = r.squaredNorm() - radius * radius;
  const Point2 nearest = r + std::clamp(-B / A, 0.0, 1.0) * d;
  if (outside_a && outside_b && above(nearest.norm() - radius, radius)) return false;
  const double root = std::sqrt(std::max(0.0, B * B - A * C));
  constexpr double TURN = 2.0 * PI;
  for (const bool enters : {true, false}) {
    if (!(enters ? outside_a : outside_b)) continue;
    const Point2 hit = r + std::clamp((-B + (enters ? -root : root)) / A, 0.0, 1.0) * d;
    double angle = std::fmod(std::atan2(hit[1], hit[0]) - start, TURN);
    if (angle < 0.0) angle += TURN;
    if (above(sweep - angle, TURN) || above(angle - TURN, TURN)) return true;
  }
  return false;
}

/// Where the bond from a to b meets the plane of a flaw of this size; false if it does not.
inline bool meets_plane(const Point3 &a, const Point3 &b, const Point3 &point,
                        const Point3 &unit_normal, double length, Point3 &hit)
{
  const double ha = unit_normal.dot(a - point), hb = unit_normal.dot(b - point);
  if (above(ha, length) == above(hb, length)) return false;
  hit = a + crossing(ha, hb) * (b - a);
  return true;
}

inline bool crosses_disc(const Point3 &a, const Point3 &b, const Point3 &center,
                         const Point3 &normal, double radius)
{
  Point3 hit;
  return meets_plane(a, b, center, normal.normalized(), radius, hit) &&
      above(radius - (hit - center).norm(), radius);
}

/// Area vector of a closed polygon (Newell): normal to it, its length twice the area.
inline Point3 polygon_normal(const std::vector<Point3> &corner)
{
  Point3 normal = Point3::Zero();
  for (size_t k = 0; k < corner.size(); k++)
    normal += (corner[k] - corner[0]).cross(corner[(k + 1) % corner.size()] - corner[0]);
  return normal;
}

inline double distance_from_edge(const Point3 &x, const Point3 &p, const Point3 &q)
{
  const Point3 d = q - p;
  return (x - p - std::clamp((x - p).dot(d) / d.squaredNorm(), 0.0, 1.0) * d).norm();
}

/// Flat polygon, convex or not: a point is inside if it is on the rim or a ray from it crosses the
/// rim an odd number of times.
inline bool crosses_polygon(const Point3 &a, const Point3 &b, const std::vector<Point3> &corner)
{
  const Point3 normal = polygon_normal(corner);
  const double length = std::sqrt(normal.norm());
  Point3 hit;
  if (!meets_plane(a, b, corner[0], normal.normalized(), length, hit)) return false;
  int drop;    // project along the largest component of the normal
  normal.cwiseAbs().maxCoeff(&drop);
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  bool inside = false;
  for (size_t k = 0; k < corner.size(); k++) {
    const Point3 &p = corner[k], &q = corner[(k + 1) % corner.size()];
    if (above(-distance_from_edge(hit, p, q), length)) return true;
    if ((p[v] > hit[v]) != (q[v] > hit[v]) &&
        hit[u] < p[u] + (hit[v] - p[v]) / (q[v] - p[v]) * (q[u] - p[u]))
      inside = !inside;
  }
  return inside;
}

}    // namespace TMSPH
#endif
