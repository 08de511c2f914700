/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Does a bond cross a flaw? Flaws in 2-D: line segment, circular arc; in 3-D:
   flat disc, flat polygon. A particle exactly on a flaw counts to one side of
   it, always the same, so that no bond is cut twice or missed.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_GEOMETRY_H
#define LMP_TMSPH_GEOMETRY_H

#include <Eigen/Geometry>

#include <cmath>
#include <vector>

namespace TMSPH {

using Point2 = Eigen::Vector2d;
using Point3 = Eigen::Vector3d;

inline double cross(const Point2 &a, const Point2 &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

/// Bond from a to b, flaw from p to q.
inline bool crosses_segment(const Point2 &a, const Point2 &b, const Point2 &p, const Point2 &q)
{
  const double sa = cross(q - p, a - p), sb = cross(q - p, b - p);
  if ((sa >= 0.0) == (sb >= 0.0)) return false;
  const Point2 hit = a + sa / (sa - sb) * (b - a);
  const double along = (hit - p).dot(q - p);
  return along >= 0.0 && along <= (q - p).squaredNorm();
}

/// Flaw: arc about "center", counterclockwise from angle "start" (radians) over "sweep" > 0.
inline bool crosses_arc(const Point2 &a, const Point2 &b, const Point2 &center, double radius,
                        double start, double sweep)
{
  const Point2 d = b - a, r = a - center;
  const double A = d.squaredNorm(), B = r.dot(d), C = r.squaredNorm() - radius * radius;
  const double discriminant = B * B - A * C;
  if (discriminant <= 0.0) return false;
  constexpr double TURN = 6.283185307179586;
  for (const double sign : {-1.0, 1.0}) {
    const double t = (-B + sign * std::sqrt(discriminant)) / A;
    if (t < 0.0 || t >= 1.0) continue;
    const Point2 hit = r + t * d;
    double angle = std::fmod(std::atan2(hit[1], hit[0]) - start, TURN);
    if (angle < 0.0) angle += TURN;
    if (angle <= sweep) return true;
  }
  return false;
}

/// Where the bond from a to b meets a plane; false if it does not.
inline bool meets_plane(const Point3 &a, const Point3 &b, const Point3 &point,
                        const Point3 &normal, Point3 &hit)
{
  const double sa = normal.dot(a - point), sb = normal.dot(b - point);
  if ((sa >= 0.0) == (sb >= 0.0)) return false;
  hit = a + sa / (sa - sb) * (b - a);
  return true;
}

inline bool crosses_disc(const Point3 &a, const Point3 &b, const Point3 &center,
                         const Point3 &normal, double radius)
{
  Point3 hit;
  return meets_plane(a, b, center, normal, hit) &&
      (hit - center).squaredNorm() <= radius * radius;
}

/// Area vector of a closed polygon (Newell): normal to it, its length twice the area.
inline Point3 polygon_normal(const std::vector<Point3> &corner)
{
  Point3 normal = Point3::Zero();
  for (size_t k = 0; k < corner.size(); k++)
    normal += (corner[k] - corner[0]).cross(corner[(k + 1) % corner.size()] - corner[0]);
  return normal;
}

/// Flat polygon, convex or not: a point is inside if a ray from it crosses the rim an odd number of
/// times.
inline bool crosses_polygon(const Point3 &a, const Point3 &b, const std::vector<Point3> &corner)
{
  const Point3 normal = polygon_normal(corner);
  Point3 hit;
  if (!meets_plane(a, b, corner[0], normal, hit)) return false;
  int drop;    // project along the largest component of the normal
  normal.cwiseAbs().maxCoeff(&drop);
  const int u = (drop + 1) % 3, v = (drop + 2) % 3;
  bool inside = false;
  for (size_t k = 0; k < corner.size(); k++) {
    const Point3 &p = corner[k], &q = corner[(k + 1) % corner.size()];
    if ((p[v] > hit[v]) != (q[v] > hit[v]) &&
        hit[u] < p[u] + (hit[v] - p[v]) / (q[v] - p[v]) * (q[u] - p[u]))
      inside = !inside;
  }
  return inside;
}

}    // namespace TMSPH
#endif
