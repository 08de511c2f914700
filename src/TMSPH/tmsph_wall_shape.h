/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Shapes of rigid walls: where does a point touch them? Vectors have three
   components; the third is zero in 2-D.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_SHAPE_H
#define LMP_TMSPH_WALL_SHAPE_H

#include "tmsph_bounds.h"

#include <array>
#include <vector>

namespace TMSPH {

using Point = std::array<double, 3>;

struct WallTouch {
  Point normal;    ///< unit vector away from the wall
  double gap;      ///< distance from the surface along the normal; negative behind it
  int piece;       ///< which segment or corner
};

/// of two places: in front goes before behind, and of two behind the less deep one
inline bool nearer(const WallTouch &a, const WallTouch &b)
{
  if ((a.gap >= 0.0) != (b.gap >= 0.0)) return a.gap >= 0.0;
  return a.gap >= 0.0 ? a.gap < b.gap : a.gap > b.gap;
}

class WallShape {
 public:
  virtual ~WallShape() = default;
  /** The places where a point is held: one, or two in a concave corner.
      @param reach only places nearer than this count, in front and behind
      @param side  +1: the front is the left side of lines and arcs, where the normal of a plane
                   points; -1: the other
      @return number of places, at most 2 */
  virtual int touches(const Point &x, double reach, int side, WallTouch *found) const = 0;
  /// +1 on the left side of the nearest piece, or where the normal of a plane points; else -1
  virtual int side_of(const Point &x) const = 0;
  /// distance from the surface, without sign; a lower bound will do
  virtual double distance(const Point &x) const = 0;
  /// the box around it, endless where it has no end
  virtual Bounds bounds() const = 0;
  /** Goes on without end along an axis whose period it spans; with period 0 no longer.
      @return true if it is everywhere the same after a period */
  virtual bool goes_on(int axis, double period) = 0;
  /** Corners to draw it: of a line in 2-D, of a quadrangle in 3-D.
      @param middle,size what is to be seen of a shape without end */
  virtual std::vector<Point> picture(const Point &middle, double size) const = 0;
};

/** Straight segments end to end; closed if the last point is the first. They go on without end if
    they are one that is straight along an axis and at least a period long, or end one period from
    where they start. At a convex corner the
    nearest point is the corner itself, so the normal turns steadily. In a concave corner of more
    than CONCAVE degrees a point touches both segments, in a flatter one the nearer: with 5 in place
    of 20 the force on a bumpy floor changes by 0.7 % in a step, with 20 and 60 by 0.1 %
    (unittest/verification/test_wall.py). */
class WallPolyline : public WallShape {
 public:
  static constexpr double CONCAVE = 20.0;
  explicit WallPolyline(const std::vector<Point> &points);
  int touches(const Point &x, double reach, int side, WallTouch *found) const override;
  int side_of(const Point &x) const override;
  double distance(const Point &x) const override;
  Bounds bounds() const override;
  bool goes_on(int axis, double period) override;
  std::vector<Point> picture(const Point &middle, double size) const override;

 private:
  struct Segment {
    Point start, along;    // along: unit vector
    double length;
  };
  std::vector<Segment> segments;
  bool closed;
  Point period;    // from one copy to the next, where it has no end
  int copies;      // of the segments, on either side, that go on from them: 0 or 1

  int count() const { return (1 + 2 * copies) * (int) segments.size(); }
  Segment at(int k) const;    // of all copies, in their order
  Point beside(const Point &x) const;
  int before(int k) const;    // the segment that ends where k starts, or -1
  int after(int k) const;
  bool concave(int k, int l, int side) const;
  int nearest(const Point &x, Point &from_start, double &square) const;
};

/** A part of a circle. */
class WallArc : public WallShape {
 public:
  /** @param from,to angles in radians; from < to: counter-clockwise, the left side is inside;
                    2 pi or more apart: the whole circle */
  WallArc(const Point &centre, double radius, double from, double to);
  int touches(const Point &x, double reach, int side, WallTouch *found) const override;
  int side_of(const Point &x) const override;
  double distance(const Point &x) const override;
  Bounds bounds() const override;
  bool goes_on(int axis, double period) override;
  std::vector<Point> picture(const Point &middle, double size) const override;

 private:
  Point centre;
  double radius, start, sweep;    // sweep: signed
  bool spans(const Point &x) const;
  Point end(int which) const;
};

/** An infinite plane, a straight line in 2-D. */
class WallPlane : public WallShape {
 public:
  WallPlane(const Point &point, const Point &unit_normal);
  int touches(const Point &x, double reach, int side, WallTouch *found) const override;
  int side_of(const Point &x) const override;
  double distance(const Point &x) const override;
  Bounds bounds() const override;
  bool goes_on(int axis, double period) override;
  std::vector<Point> picture(const Point &middle, double size) const override;

 private:
  Point point, normal;
  double height(const Point &x) const;
};

}    // namespace TMSPH
#endif
