/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Closest points on lines, arcs and planes.
------------------------------------------------------------------------- */

#include "tmsph_wall_shape.h"

#include "tmsph_pi.h"

#include <algorithm>
#include <cmath>
#include <utility>

using namespace TMSPH;

namespace {

/// sine of the angle between two segments that are one but for round-off
constexpr double STRAIGHT = 1.0e-9;
/// lengths that differ by a smaller fraction of the reach are equal but for round-off: of two gaps
/// the first one counts
constexpr double EQUALLY_FAR = 1.0e-9;

Point minus(const Point &a, const Point &b)
{
  return {a[0] - b[0], a[1] - b[1], a[2] - b[2]};
}

double dot(const Point &a, const Point &b)
{
  return a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
}

double cross(const Point &a, const Point &b)
{
  return a[0] * b[1] - a[1] * b[0];
}

Point left_of(const Point &along)
{
  return {-along[1], along[0], 0.0};
}

Point scaled(double factor, const Point &a)
{
  return {factor * a[0], factor * a[1], factor * a[2]};
}

/// a corner or an end as the place of touch; straight is the normal where the point is just there
WallTouch touch_corner(const Point &from_corner, const Point &straight, int piece)
{
  const double r = std::sqrt(dot(from_corner, from_corner));
  return {r > 0.0 ? scaled(1.0 / r, from_corner) : straight, r, piece};
}

}    // namespace

/* ---------------------------------------------------------------------- */

WallPolyline::WallPolyline(const std::vector<Point> &points) :
    closed(points.front() == points.back()), period{0.0, 0.0, 0.0}, copies(0)
{
  for (size_t k = 0; k + 1 < points.size(); k++) {
    const Point d = minus(points[k + 1], points[k]);
    const double length = std::sqrt(dot(d, d));
    segments.push_back({points[k], scaled(1.0 / length, d), length});
  }
  closed = closed && segments.size() > 2;
}

/* ---------------------------------------------------------------------- */

Bounds WallPolyline::bounds() const
{
  Bounds box;
  for (const Point &corner : picture({}, 0.0)) box.add(corner);
  return box;
}

/* ---------------------------------------------------------------------- */

bool WallPolyline::goes_on(int axis, double length)
{
  if (axis > 1) return false;
  if (period[axis] != 0.0) {
    period[axis] = 0.0;
    copies = 0;
  }
  if (!(length > 0.0)) return false;
  const std::vector<Point> corners = picture({}, 0.0);
  const Point way = minus(corners.back(), corners.front());
  const double along = std::fabs(way[axis]), across = std::fabs(way[1 - axis]);
  const double small = Bounds::ROUND * length;
  const bool straight = segments.size() == 1 && along >= length - small;
  if (across > small || !(straight || std::fabs(along - length) <= small)) return false;
  period[axis] = std::copysign(length, way[axis]);
  copies = 1;
  return true;
}

/* ----------------------------------------------------------------------
   the copy of a point that is beside the segments in the middle
------------------------------------------------------------------------- */

Point WallPolyline::beside(const Point &x) const
{
  if (copies == 0) return x;
  const double turns = dot(minus(x, segments[0].start), period) / dot(period, period);
  return minus(x, scaled(std::floor(turns), period));
}

/* ---------------------------------------------------------------------- */

WallPolyline::Segment WallPolyline::at(int k) const
{
  const int n = segments.size();
  Segment s = segments[k % n];
  for (int a = 0; a < 2; a++) s.start[a] += (k / n - copies) * period[a];
  return s;
}

int WallPolyline::before(int k) const
{
  return k > 0 ? k - 1 : closed ? count() - 1 : -1;
}

int WallPolyline::after(int k) const
{
  return k + 1 < count() ? k + 1 : closed ? 0 : -1;
}

/* ----------------------------------------------------------------------
   do segments k and l meet in a corner that opens to this side?
------------------------------------------------------------------------- */

bool WallPolyline::concave(int k, int l, int side) const
{
  const int n = count();
  if (k >= n || l >= n) return false;    // corners
  if (after(k) == l && side * cross(at(k).along, at(l).along) > STRAIGHT) return true;
  return after(l) == k && side * cross(at(l).along, at(k).along) > STRAIGHT;
}

/* ----------------------------------------------------------------------
   Behind one segment may be in front of another. What is in front counts;
   what is behind only where both meet in a concave corner, into which the
   point has been pressed, or if there is nothing else.
------------------------------------------------------------------------- */

int WallPolyline::touches(const Point &point, double reach, int side, WallTouch *found) const
{
  std::vector<WallTouch> hits;
  const double same = EQUALLY_FAR * reach;
  const int n = count();
  const Point x = beside(point);
  for (int k = 0; k < n; k++) {
    const Segment s = at(k);
    const Point d = minus(x, s.start);
    const double along = dot(d, s.along);
    const Point normal = scaled(side, left_of(s.along));
    const double gap = dot(d, normal);
    const int previous = before(k), next = after(k);

    // where it meets another in a concave corner it goes on behind that one

    const double first = previous >= 0 && concave(previous, k, side) ? -reach : 0.0;
    const double last = s.length + (next >= 0 && concave(k, next, side) ? reach : 0.0);
    if (along >= first - same && along <= last + same) {
      if (std::fabs(gap) < reach) hits.push_back({normal, gap, k});
      continue;
    }

    // the corner where this segment starts, and the free end of the last one

    if (along < 0.0 && dot(d, d) < reach * reach) {
      if (previous < 0) {
        if (gap >= 0.0) hits.push_back(touch_corner(d, normal, n + k));
      } else {
        const Segment p = at(previous);
        if (dot(minus(x, p.start), p.along) > p.length)
          hits.push_back(touch_corner(d, normal, n + k));
      }
    }
    if (along > s.length && next < 0 && gap >= 0.0) {
      const Point beyond = minus(d, scaled(s.length, s.along));
      if (dot(beyond, beyond) < reach * reach) hits.push_back(touch_corner(beyond, normal, 2 * n));
    }
  }
  if (hits.empty()) return 0;

  const auto in_front = [](const WallTouch &h) { return h.gap >= 0.0; };
  const bool front = std::any_of(hits.begin(), hits.end(), in_front);
  if (front) {
    const std::vector<WallTouch> all = hits;
    const auto is_no_place = [&](const WallTouch &h) {
      return h.gap < 0.0 && std::none_of(all.begin(), all.end(), [&](const WallTouch &f) {
               return in_front(f) && concave(h.piece, f.piece, side);
             });
    };
    hits.erase(std::remove_if(hits.begin(), hits.end(), is_no_place), hits.end());
  }
  const auto least = [&](const auto &counts, double sign) {
    const WallTouch *best = nullptr;
    for (const WallTouch &h : hits)
      if (counts(h) && (!best || sign * (best->gap - h.gap) > same)) best = &h;
    return best;
  };
  found[0] = *least([](const WallTouch &) { return true; }, front ? 1.0 : -1.0);
  const double parallel = std::cos(CONCAVE * PI / 180.0);
  const WallTouch *second = least(
      [&](const WallTouch &h) {
        return dot(h.normal, found[0].normal) <= parallel &&
            ((in_front(h) && in_front(found[0])) || concave(h.piece, found[0].piece, side));
      },
      1.0);
  const int places = second ? 2 : 1;
  if (second) found[1] = *second;
  for (int p = 0; p < places && copies; p++)
    found[p].piece =
        found[p].piece % (int) segments.size() + (found[p].piece < n ? 0 : (int) segments.size());
  return places;
}

/* ---------------------------------------------------------------------- */

int WallPolyline::nearest(const Point &point, Point &from_start, double &square) const
{
  int which = 0;
  square = HUGE_VAL;
  const Point x = beside(point);
  for (int k = 0; k < count(); k++) {
    const Segment s = at(k);
    const Point from = minus(x, s.start);
    const double along = std::min(s.length, std::max(0.0, dot(from, s.along)));
    const Point d = minus(from, scaled(along, s.along));
    if (dot(d, d) >= square) continue;
    square = dot(d, d);
    from_start = from;
    which = k;
  }
  return which;
}

/* ---------------------------------------------------------------------- */

int WallPolyline::side_of(const Point &x) const
{
  Point from_start;
  double square;
  const Segment s = at(nearest(x, from_start, square));
  return cross(s.along, from_start) >= 0.0 ? 1 : -1;
}

/* ---------------------------------------------------------------------- */

double WallPolyline::distance(const Point &x) const
{
  Point from_start;
  double square;
  nearest(x, from_start, square);
  return std::sqrt(square);
}

/* ---------------------------------------------------------------------- */

std::vector<Point> WallPolyline::picture(const Point & /*middle*/, double /*size*/) const
{
  std::vector<Point> corners = {segments.front().start};
  for (const Segment &s : segments) {
    const Point step = scaled(s.length, s.along);
    corners.push_back({s.start[0] + step[0], s.start[1] + step[1], 0.0});
  }
  return corners;
}

/* ---------------------------------------------------------------------- */

WallArc::WallArc(const Point &centre, double radius, double from, double to) :
    centre(centre), radius(radius), start(from), sweep(to - from)
{
}

/* ---------------------------------------------------------------------- */

bool WallArc::spans(const Point &x) const
{
  if (std::fabs(sweep) >= 2.0 * PI) return true;
  const Point d = minus(x, centre);
  const double sign = sweep > 0.0 ? 1.0 : -1.0;
  double turned = std::fmod(sign * (std::atan2(d[1], d[0]) - start), 2.0 * PI);
  if (turned < 0.0) turned += 2.0 * PI;
  return turned <= std::fabs(sweep);
}

/* ---------------------------------------------------------------------- */

Point WallArc::end(int which) const
{
  const double angle = which ? start + sweep : start;
  return {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0.0};
}

/* ---------------------------------------------------------------------- */

int WallArc::touches(const Point &x, double reach, int side, WallTouch *found) const
{
  const Point d = minus(x, centre);
  const double r = std::sqrt(dot(d, d));
  const double inwards = side * (sweep > 0.0 ? 1.0 : -1.0);
  if (r == 0.0) return 0;
  const Point normal = scaled(-inwards / r, d);
  const double gap = inwards * (radius - r);
  if (spans(x)) {
    found[0] = {normal, gap, 0};
    return std::fabs(gap) < reach;
  }
  for (int which = 0; which < 2; which++) {
    const Point from_end = minus(x, end(which));
    if (gap < 0.0 || dot(from_end, from_end) >= reach * reach) continue;
    found[0] = touch_corner(from_end, normal, 1 + which);
    return 1;
  }
  return 0;
}

/* ---------------------------------------------------------------------- */

int WallArc::side_of(const Point &x) const
{
  const Point d = minus(x, centre);
  return (dot(d, d) <= radius * radius) == (sweep > 0.0) ? 1 : -1;
}

/* ---------------------------------------------------------------------- */

double WallArc::distance(const Point &x) const
{
  const Point d = minus(x, centre);
  if (spans(x)) return std::fabs(std::sqrt(dot(d, d)) - radius);
  double square = HUGE_VAL;
  for (int which = 0; which < 2; which++) {
    const Point from_end = minus(x, end(which));
    square = std::min(square, dot(from_end, from_end));
  }
  return std::sqrt(square);
}

/* ---------------------------------------------------------------------- */

Bounds WallArc::bounds() const
{
  Bounds box;
  box.low[2] = box.high[2] = 0.0;
  box.add_arc(centre, radius, start, sweep);
  return box;
}

/* ---------------------------------------------------------------------- */

bool WallArc::goes_on(int /*axis*/, double /*period*/)
{
  return false;
}

/* ---------------------------------------------------------------------- */

std::vector<Point> WallArc::picture(const Point & /*middle*/, double /*size*/) const
{
  const int pieces = 1 + (int) (std::fabs(sweep) / (0.01 * PI));    // smooth to the eye
  std::vector<Point> corners;
  for (int k = 0; k <= pieces; k++) {
    const double angle = start + sweep * k / pieces;
    corners.push_back(
        {centre[0] + radius * std::cos(angle), centre[1] + radius * std::sin(angle), 0.0});
  }
  return corners;
}

/* ---------------------------------------------------------------------- */

WallPlane::WallPlane(const Point &point, const Point &unit_normal) :
    point(point), normal(unit_normal)
{
}

/* ---------------------------------------------------------------------- */

double WallPlane::height(const Point &x) const
{
  return dot(minus(x, point), normal);
}

/* ---------------------------------------------------------------------- */

int WallPlane::touches(const Point &x, double reach, int side, WallTouch *found) const
{
  found[0] = {scaled(side, normal), side * height(x), 0};
  return std::fabs(found[0].gap) < reach;
}

/* ---------------------------------------------------------------------- */

int WallPlane::side_of(const Point &x) const
{
  return height(x) >= 0.0 ? 1 : -1;
}

/* ---------------------------------------------------------------------- */

double WallPlane::distance(const Point &x) const
{
  return std::fabs(height(x));
}

/* ---------------------------------------------------------------------- */

bool WallPlane::goes_on(int axis, double /*period*/)
{
  return std::fabs(normal[axis]) < Bounds::ROUND;
}

/* ---------------------------------------------------------------------- */

Bounds WallPlane::bounds() const
{
  Bounds box;
  for (int k = 0; k < 3; k++) {
    const int l = (k + 1) % 3, m = (k + 2) % 3;
    const bool across = std::max(std::fabs(normal[l]), std::fabs(normal[m])) < Bounds::ROUND;
    box.low[k] = across ? point[k] : -HUGE_VAL;
    box.high[k] = across ? point[k] : HUGE_VAL;
  }
  return box;
}

/* ---------------------------------------------------------------------- */

std::vector<Point> WallPlane::picture(const Point &middle, double size) const
{
  const Point foot = minus(middle, scaled(height(middle), normal));
  Point along = {0.0, 0.0, 0.0};    // the axis farthest from the normal, less its part along that
  int axis = 0;
  for (int a = 1; a < 3; a++)
    if (std::fabs(normal[a]) < std::fabs(normal[axis])) axis = a;
  for (int a = 0; a < 3; a++) along[a] = (a == axis) - normal[axis] * normal[a];
  along = scaled(0.5 * size / std::sqrt(dot(along, along)), along);
  const Point across = {normal[1] * along[2] - normal[2] * along[1],
                        normal[2] * along[0] - normal[0] * along[2],
                        normal[0] * along[1] - normal[1] * along[0]};
  std::vector<Point> corners;
  for (const auto &[s, t] :
       {std::pair(-1, -1), std::pair(1, -1), std::pair(1, 1), std::pair(-1, 1)})
    corners.push_back({foot[0] + s * along[0] + t * across[0],
                       foot[1] + s * along[1] + t * across[1],
                       foot[2] + s * along[2] + t * across[2]});
  return corners;
}
