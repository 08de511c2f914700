/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Places where points touch walls, and the laws of the forces there: distances
   against a fine sampling, steadiness around corners, the equations that the
   implicit laws solve.
------------------------------------------------------------------------- */

#include "tmsph_contact_law.h"
#include "tmsph_rigid_motion.h"
#include "tmsph_wall_shape.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

using namespace TMSPH;

namespace {

constexpr double PI = 3.14159265358979323846;

double distance(const Point &a, const Point &b)
{
  return std::hypot(a[0] - b[0], a[1] - b[1], a[2] - b[2]);
}

/// the least distance from points along the segments
double sampled(const std::vector<Point> &points, const Point &x)
{
  double least = HUGE_VAL;
  for (size_t k = 0; k + 1 < points.size(); k++)
    for (int n = 0; n <= 4000; n++) {
      const double s = n / 4000.0;
      least = std::min(least,
                       distance(x,
                                {(1 - s) * points[k][0] + s * points[k + 1][0],
                                 (1 - s) * points[k][1] + s * points[k + 1][1], 0.0}));
    }
  return least;
}

const std::vector<Point> BENT = {
    {-1, 0, 0}, {0, 0, 0}, {0.5, -0.4, 0}, {1.2, -0.4, 0}, {1.2, 0.6, 0}};

}    // namespace

TEST(WallShape, DistanceOfPolylineIsTheLeastOfAllItsPoints)
{
  std::mt19937_64 engine(7);
  std::uniform_real_distribution<double> random(-1.5, 1.5);
  const WallPolyline wall(BENT);
  for (int n = 0; n < 300; n++) {
    const Point x = {random(engine), random(engine), 0.0};
    EXPECT_NEAR(wall.distance(x), sampled(BENT, x), 2.0e-4);
  }
}

// a straight joint and a niche with three equally near sides, in many axes: round-off decides
// nothing
TEST(WallShape, TiesAreDecidedAlikeInTurnedAxes)
{
  const std::vector<Point> niche = {{-3, 0.5, 0},    {-2, 0.5, 0},   {-1, 0.5, 0},  {-0.5, 0.5, 0},
                                    {-0.5, -0.5, 0}, {0.5, -0.5, 0}, {0.5, 0.5, 0}, {2, 0.5, 0}};
  const std::vector<Point> inside = {{0, 0, 0}, {-2.25, 0.9, 0}, {-2, 0.9, 0}, {-1.1, 0.75, 0}};
  for (const Point &x : inside) {
    WallTouch expected[2];
    const int count = WallPolyline(niche).touches(x, 1.0, 1, expected);
    for (int n = 1; n < 300; n++) {
      const double c = std::cos(0.021 * n), s = std::sin(0.021 * n);
      const auto turned = [=](const Point &p) {
        return Point{c * p[0] - s * p[1], s * p[0] + c * p[1], 0.0};
      };
      std::vector<Point> points;
      for (const Point &p : niche) points.push_back(turned(p));
      WallTouch found[2];
      ASSERT_EQ(WallPolyline(points).touches(turned(x), 1.0, 1, found), count);
      for (int k = 0; k < count; k++) {
        EXPECT_LT(distance(found[k].normal, turned(expected[k].normal)), 1.0e-14);
        EXPECT_NEAR(found[k].gap, expected[k].gap, 1.0e-14);
        EXPECT_EQ(found[k].piece, expected[k].piece);
      }
    }
  }
}

TEST(WallShape, PointsInFrontTouchAtTheLeastDistance)
{
  std::mt19937_64 engine(8);
  std::uniform_real_distribution<double> random(-1.0, 1.0);
  const WallPolyline wall(BENT);
  const double reach = 0.15;
  int touching = 0;
  for (int n = 0; n < 5000; n++) {
    const Point x = {random(engine), random(engine), 0.0};
    WallTouch found[2];
    const int count = wall.touches(x, reach, 1, found);
    const double least = sampled(BENT, x);
    if (std::fabs(least - reach) < 1.0e-3) continue;
    const bool at_free_end = distance(x, BENT.front()) < reach || distance(x, BENT.back()) < reach;
    if (at_free_end || wall.side_of(x) < 0) continue;
    ASSERT_EQ(count > 0, least < reach) << x[0] << ' ' << x[1];
    if (!count) continue;
    touching++;
    EXPECT_NEAR(found[0].gap, least, 1.0e-3) << x[0] << ' ' << x[1];
    EXPECT_NEAR(distance(found[0].normal, {0, 0, 0}), 1.0, 1.0e-14);
    EXPECT_GE(found[0].gap, 0.0);
  }
  EXPECT_GT(touching, 300);
}

/// around a convex corner, and over concave and convex kinks, gap and normal are steady
TEST(WallShape, GapIsSteadyAlongPathsOverKinks)
{
  for (double kink : {-70.0, -10.0, 5.0, 15.0}) {
    const double c = std::cos(kink * PI / 180), s = std::sin(kink * PI / 180);
    const WallPolyline wall({{-1, 0, 0}, {0, 0, 0}, {c, s, 0}});
    const double height = 0.05, step = 1.0e-3;
    double before = 0.0;
    for (double x = -0.5; x < 0.4; x += step) {
      const double y = x < 0 ? height : height + (kink < 0 ? 0.5 : 1.0) * x * s / c;
      WallTouch found[2];
      const int count = wall.touches({x, y, 0}, 0.4, 1, found);
      ASSERT_EQ(count, 1) << kink << ' ' << x;
      if (x > -0.5 + 0.5 * step) {
        EXPECT_LT(std::fabs(found[0].gap - before), step * (1 + std::fabs(s / c)) + 1e-12)
            << kink << ' ' << x;
      }
      before = found[0].gap;
    }
  }
}

TEST(WallShape, ConcaveCornerHoldsOnBothSides)
{
  const WallPolyline box({{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 0}});
  const Point corners[] = {{0.05, 0.03, 0}, {0.95, 0.03, 0}, {0.95, 0.97, 0}, {0.05, 0.97, 0}};
  WallTouch found[2];
  for (const Point &x : corners) {
    ASSERT_EQ(box.touches(x, 0.1, 1, found), 2);
    EXPECT_NEAR(found[0].gap, 0.03, 1e-15);
    EXPECT_NEAR(found[1].gap, 0.05, 1e-15);
    EXPECT_GT(found[0].normal[1] * (0.5 - x[1]), 0.0);
    EXPECT_GT(found[1].normal[0] * (0.5 - x[0]), 0.0);
  }
  // pressed through one side, still held by both
  ASSERT_EQ(box.touches({0.05, -0.01, 0}, 0.1, 1, found), 2);
  EXPECT_NEAR(found[0].gap, -0.01, 1e-15);
  // outside nothing is in front
  EXPECT_EQ(box.touches({0.5, -0.2, 0}, 0.1, 1, found), 0);
  // from outside the corner is convex
  ASSERT_EQ(box.touches({-0.03, -0.04, 0}, 0.1, -1, found), 1);
  EXPECT_NEAR(found[0].gap, 0.05, 1e-15);
  EXPECT_NEAR(found[0].normal[0], -0.6, 1e-14);
}

/// a thin wedge: in front of one face near the tip, though less far behind the other
TEST(WallShape, FrontOfWedgeGoesBeforeItsBack)
{
  const double a = 15 * PI / 180;
  const WallPolyline wedge({{-1, -std::sin(a), 0}, {0, 0, 0}, {-1, std::sin(a), 0}});
  WallTouch found[2];
  for (double along : {0.001, 0.01, 0.05}) {
    const double gap = 0.04;
    const double c = std::cos(std::atan(std::sin(a))), s = std::sin(std::atan(std::sin(a)));
    ASSERT_EQ(wedge.touches({-along * c + gap * s, along * s + gap * c, 0}, 0.1, -1, found), 1);
    EXPECT_NEAR(found[0].gap, gap, 1e-14) << along;
    EXPECT_NEAR(found[0].normal[1], c, 1e-14) << along;
  }
}

TEST(WallShape, ArcsInsideOutsideAndEnds)
{
  WallTouch found[2];
  const WallArc bowl({1, 2, 0}, 0.5, PI, 2 * PI), hill({1, 2, 0}, 0.5, PI, 0);
  ASSERT_EQ(bowl.touches({1, 1.6, 0}, 0.2, 1, found), 1);
  EXPECT_NEAR(found[0].gap, 0.1, 1e-15);
  EXPECT_NEAR(found[0].normal[1], 1.0, 1e-15);
  ASSERT_EQ(hill.touches({1, 2.6, 0}, 0.2, 1, found), 1);
  EXPECT_NEAR(found[0].gap, 0.1, 1e-15);
  EXPECT_NEAR(found[0].normal[1], 1.0, 1e-15);
  EXPECT_EQ(bowl.touches({1, 2.45, 0}, 0.2, 1, found), 0);    // the upper half is not there
  EXPECT_EQ(bowl.side_of({1, 2, 0}), 1);
  EXPECT_EQ(hill.side_of({1, 2, 0}), -1);
  ASSERT_EQ(bowl.touches({0.55, 2.05, 0}, 0.2, 1, found), 1);    // beyond its end
  EXPECT_NEAR(found[0].gap, std::hypot(0.05, 0.05), 1e-15);
  EXPECT_NEAR(bowl.distance({0.4, 2.3, 0}), std::hypot(0.1, 0.3), 1e-15);
  const WallArc ring({0, 0, 0}, 1.0, 0, 2 * PI);
  for (int k = 0; k < 12; k++)
    EXPECT_EQ(ring.touches({0.9 * std::cos(k), 0.9 * std::sin(k), 0}, 0.2, 1, found), 1);
}

/// walls that span a period are like long rows of copies of them, wherever the point is
TEST(WallShape, GoesOnWithoutEndOverPeriods)
{
  std::mt19937_64 engine(10);
  std::uniform_real_distribution<double> random(-1.0, 1.0);
  const std::vector<std::vector<Point>> profiles = {
      {{-0.4, 0, 0}, {1.1, 0, 0}},
      {{0, 0, 0}, {0.5, -0.3, 0}, {1, 0, 0}},
      {{0.2, 0.1, 0}, {0.6, 0.5, 0}, {1.2, 0.1, 0}},
      {{1, 0, 0}, {0.7, 0.2, 0}, {0.7, -0.1, 0}, {0, 0, 0}}};
  for (const auto &profile : profiles) {
    const double way = profile.back()[0] > profile.front()[0] ? 1.0 : -1.0;
    std::vector<Point> row;
    for (int copy = -4; copy <= 4; copy++)
      for (Point p : profile) {
        p[0] += way * copy;
        if (row.empty() || distance(row.back(), p) > 1e-9) row.push_back(p);
      }
    if (profile.size() == 2) row = {{-5, 0, 0}, {5, 0, 0}};
    const WallPolyline many(row);
    WallPolyline one(profile);
    EXPECT_FALSE(one.goes_on(1, 1.0));
    ASSERT_TRUE(one.goes_on(0, 1.0));
    int touching = 0;
    for (int n = 0; n < 4000; n++) {
      const Point x = {0.6 * random(engine), 0.7 * random(engine), 0.0};
      const Point there = {x[0] + std::round(50.0 * random(engine)), x[1], 0.0};
      WallTouch expected[2], found[2];
      const int side = n % 2 ? 1 : -1, count = many.touches(x, 0.15, side, expected);
      ASSERT_EQ(one.touches(there, 0.15, side, found), count) << x[0] << ' ' << x[1];
      for (int k = 0; k < count; k++) {
        EXPECT_NEAR(found[k].gap, expected[k].gap, 1e-12) << x[0] << ' ' << x[1];
        EXPECT_LT(distance(found[k].normal, expected[k].normal), 1e-11) << x[0] << ' ' << x[1];
      }
      EXPECT_NEAR(one.distance(there), many.distance(x), 1e-12);
      if (count == 1 && expected[0].piece < (int) row.size() - 1) {    // not of corners
        EXPECT_EQ(one.side_of(there), many.side_of(x));
      }
      touching += count;
    }
    EXPECT_GT(touching, 500);
    one.goes_on(0, 0.0);    // as it was
    WallTouch found[2];
    EXPECT_EQ(one.touches({5.5, 0.05, 0}, 0.1, 1, found), 0);
  }
  EXPECT_FALSE(WallPolyline({{0, 0, 0}, {0.9, 0, 0}}).goes_on(0, 1.0));      // too short
  EXPECT_FALSE(WallPolyline({{0, 0, 0}, {1.0, 0.1, 0}}).goes_on(0, 1.0));    // a step
  EXPECT_TRUE(WallPlane({0, 0, 0}, {0, 0, 1}).goes_on(0, 1.0));
  EXPECT_FALSE(WallPlane({0, 0, 0}, {0, 0, 1}).goes_on(2, 1.0));
}

TEST(WallShape, Bounds)
{
  const Bounds bowl = WallArc({1, 2, 0}, 0.5, -0.75 * PI, 0.25 * PI).bounds();
  const double c = 0.5 * std::sqrt(0.5);
  EXPECT_NEAR(bowl.low[0], 1 - c, 1e-15);
  EXPECT_NEAR(bowl.high[0], 1.5, 1e-15);
  EXPECT_NEAR(bowl.low[1], 1.5, 1e-15);
  EXPECT_NEAR(bowl.high[1], 2 + c, 1e-15);
  const Bounds ring = WallArc({0, 0, 0}, 1.0, 0, -9 * PI).bounds();
  for (int k = 0; k < 2; k++) EXPECT_NEAR(ring.length(k), 2.0, 1e-15);
  const Bounds plane = WallPlane({1, 2, 3}, {0, 1, 0}).bounds();
  EXPECT_TRUE(plane.repeats(1, 1.0));
  EXPECT_FALSE(plane.repeats(0, 1.0));
  EXPECT_FALSE(WallPlane({1, 2, 3}, {0, 0.6, 0.8}).bounds().repeats(1, 1.0));
  int first, last;
  ASSERT_TRUE(bowl.images(0, 3.0, 7.2, 7.4, first, last));
  EXPECT_EQ(first, 2);
  EXPECT_EQ(last, 2);
  EXPECT_FALSE(bowl.images(0, 3.0, 8.6, 9.6, first, last));
  // a place on the shape but for round-off
  const double near = plane.low[1] - 1e-15;
  ASSERT_TRUE(plane.images(1, 5.0, near - 0.1, near, first, last));
  EXPECT_EQ(first, 0);
  EXPECT_EQ(last, 0);
}

TEST(WallShape, MotionThereAndBack)
{
  RigidMotion m;
  m.pivot = {0.3, -0.2, 0.1};
  m.axis = {2.0 / 3, -1.0 / 3, 2.0 / 3};
  m.shift = {1, 2, 3};
  m.angle = 0.7;
  m.velocity = {0.1, 0.2, 0.3};
  m.spin = 1.3;
  const Point x = {0.5, 0.6, -0.7}, there = m.to_space(x), back = m.to_body(there);
  EXPECT_LT(distance(x, back), 1e-15);
  EXPECT_NEAR(distance(there, m.centre()), distance(x, m.pivot), 1e-15);
  // velocity is the rate of the position
  RigidMotion later = m;
  const double dt = 1e-6;
  later.angle += dt * m.spin;
  for (int k = 0; k < 3; k++) later.shift[k] += dt * m.velocity[k];
  const Point after = later.to_space(x), v = m.velocity_at(there);
  for (int k = 0; k < 3; k++) EXPECT_NEAR((after[k] - there[k]) / dt, v[k], 1e-5);
}

TEST(ContactLaw, CornerSolvesBothSpringsAtOnce)
{
  std::mt19937_64 engine(9);
  std::uniform_real_distribution<double> random(-1.0, 1.0);
  for (int n = 0; n < 1000; n++) {
    const double k = 3.0, q = 5.0 * (1 + random(engine)), cosine = 0.9 * random(engine);
    const double p[2] = {random(engine), random(engine)};
    double F[2];
    implicit_corner(k, q, cosine, p, F);
    for (int a = 0; a < 2; a++) {
      // what is left of the overlap when both forces have acted, dt^2/m = q/k
      const double left = p[a] - q / k * (F[a] + cosine * F[1 - a]);
      ASSERT_GE(F[a], 0.0);
      if (F[a] > 0.0)
        EXPECT_NEAR(F[a], k * left, 1e-13);
      else
        EXPECT_LE(left, 1e-13);
    }
  }
}

TEST(ContactLaw, SlidingFrictionIsTheLimitAgainOnTheNextEvaluation)
{
  const double k = 7.0, q = 0.8, limit = 0.5, slip[3] = {0.3, -0.4, 0.1};
  double force[3], excess[3], again[3], none[3], rest[3];
  ASSERT_TRUE(implicit_friction<3>(k, q, limit, slip, force, excess));
  EXPECT_NEAR(std::hypot(force[0], force[1], force[2]), limit, 1e-15);
  for (int a = 0; a < 3; a++) rest[a] = slip[a] - excess[a];
  implicit_friction<3>(k, q, 2 * limit, rest, again, none);
  for (int a = 0; a < 3; a++) EXPECT_NEAR(again[a], force[a], 1e-15);
}
