/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which bonds a flaw crosses. Random bonds against an independent answer: the
   sides of both segments, areas, a fan of triangles, many small steps.
------------------------------------------------------------------------- */

#include "tmsph_geometry.h"

#include <gtest/gtest.h>

#include <random>

using namespace TMSPH;

namespace {

class Flaws : public ::testing::Test {
 protected:
  std::mt19937_64 engine{41};
  double random(double low = -1.0, double high = 1.0)
  {
    return std::uniform_real_distribution<double>(low, high)(engine);
  }
  Point2 random2() { return {random(), random()}; }
  Point3 random3() { return {random(), random(), random()}; }
};

/// twice the signed area of a triangle
double area(const Point2 &a, const Point2 &b, const Point2 &c)
{
  return (b[0] - a[0]) * (c[1] - a[1]) - (b[1] - a[1]) * (c[0] - a[0]);
}

/// six times the signed volume of a tetrahedron
double volume(const Point3 &a, const Point3 &b, const Point3 &c, const Point3 &d)
{
  return (b - a).cross(c - a).dot(d - a);
}

TEST_F(Flaws, segment)
{
  int crossed = 0;
  for (int k = 0; k < 20000; k++) {
    const Point2 a = random2(), b = random2(), p = random2(), q = random2();
    const bool expected =
        area(p, q, a) * area(p, q, b) < 0.0 && area(a, b, p) * area(a, b, q) < 0.0;
    EXPECT_EQ(crosses_segment(a, b, p, q), expected);
    EXPECT_EQ(crosses_segment(b, a, p, q), expected);    // both ends decide alike
    EXPECT_EQ(crosses_segment(a, b, q, p), expected);
    crossed += expected;
  }
  EXPECT_GT(crossed, 1000);
}

// the bond is walked in small steps; what enters or leaves the circle within one, off the ends of
// the arc and not by a chord shorter than a step, is a crossing
TEST_F(Flaws, arc)
{
  constexpr int STEPS = 4000;
  const double turn = 2.0 * std::acos(-1.0);
  int crossed = 0, judged = 0;
  for (int k = 0; k < 500; k++) {
    const Point2 a = random2(), b = random2(), center = 0.5 * random2();
    const double radius = random(0.2, 0.8), start = random(-turn, turn), sweep = random(0.1, turn);
    bool expected = false, doubtful = false;
    const auto at = [&](int s) -> Point2 { return a + (b - a) * ((double) s / STEPS) - center; };
    for (int s = 0; s < STEPS; s++) {
      const double before = at(s).norm() - radius, after = at(s + 1).norm() - radius;
      doubtful = doubtful || (before > 0.0 && before < 1.0e-5);    // nearly a tangent
      if ((before < 0.0) == (after < 0.0)) continue;
      double angle = std::atan2(at(s)[1], at(s)[0]) - start;
      while (angle < 0.0) angle += turn;
      while (angle >= turn) angle -= turn;
      for (double end : {0.0, sweep, turn}) doubtful = doubtful || std::fabs(angle - end) < 0.02;
      expected = expected || angle < sweep;
    }
    if (doubtful) continue;
    judged++;
    crossed += expected;
    EXPECT_EQ(crosses_arc(a, b, center, radius, start, sweep), expected);
    EXPECT_EQ(crosses_arc(b, a, center, radius, start, sweep), expected);
  }
  EXPECT_GT(judged, 300);
  EXPECT_GT(crossed, 50);
}

// turned into the plane z = 0 about the origin, the disc is a circle there
TEST_F(Flaws, disc)
{
  int crossed = 0;
  for (int k = 0; k < 20000; k++) {
    const Point3 a = random3(), b = random3(), center = 0.5 * random3(), normal = 3.0 * random3();
    const double radius = random(0.1, 1.0);
    const Eigen::Quaterniond turn =
        Eigen::Quaterniond::FromTwoVectors(normal, Eigen::Vector3d::UnitZ());
    const Point3 u = turn * (a - center), v = turn * (b - center);
    const double t = u[2] / (u[2] - v[2]);
    const bool expected = t > 0.0 && t < 1.0 && (u + t * (v - u)).head<2>().norm() < radius;
    EXPECT_EQ(crosses_disc(a, b, center, normal, radius), expected);
    EXPECT_EQ(crosses_disc(b, a, center, normal, radius), expected);
    crossed += expected;
  }
  EXPECT_GT(crossed, 1000);
}

// an arrow head, which is not convex, in a random plane: two triangles, each crossed if the bond
// sees its three edges under the same sense
TEST_F(Flaws, polygon)
{
  int crossed = 0;
  for (int k = 0; k < 20000; k++) {
    const Point3 origin = 0.3 * random3(), e1 = random3().normalized();
    const Point3 e2 = e1.cross(random3()).normalized();
    const auto place = [&](double x, double y) -> Point3 { return origin + x * e1 + y * e2; };
    const std::vector<Point3> corner = {place(-0.8, -0.6), place(0.0, 0.9), place(0.8, -0.6),
                                        place(0.0, -0.1)};
    const Point3 a = random3(), b = random3();
    const auto triangle = [&](const Point3 &p, const Point3 &q, const Point3 &r) {
      const double x = volume(a, b, p, q), y = volume(a, b, q, r), z = volume(a, b, r, p);
      return (x > 0.0) == (y > 0.0) && (y > 0.0) == (z > 0.0) &&
          volume(p, q, r, a) * volume(p, q, r, b) < 0.0;
    };
    const bool expected = triangle(corner[0], corner[1], corner[3]) ||
        triangle(corner[1], corner[2], corner[3]);
    EXPECT_EQ(crosses_polygon(a, b, corner), expected);
    EXPECT_EQ(crosses_polygon(b, a, corner), expected);
    crossed += expected;
    // Newell's vector: here the area is 1/2 * 0.8 * 1.0 for each of the two triangles
    EXPECT_NEAR(polygon_normal(corner).norm(), 2.0 * 0.8, 1.0e-14);    // round-off
  }
  EXPECT_GT(crossed, 1000);
}

// points of a lattice on the flaw, bonds that meet its rim: the same answers in turned axes
TEST_F(Flaws, ties_in_turned_axes)
{
  int crossed = 0;
  for (int k = 0; k < 200; k++) {
    const Eigen::Rotation2Dd plane(random(-3.0, 3.0));
    const Eigen::Quaterniond space = Eigen::Quaterniond::FromTwoVectors(random3(), random3());
    const std::vector<Point3> square = {{-2, -1, 0}, {2, -1, 0}, {2, 1, 0}, {-2, 1, 0}};
    std::vector<Point3> turned;
    for (const Point3 &p : square) turned.push_back(space * p);
    for (int n = 0; n < 200; n++) {
      const auto lattice = [&]() { return std::round(random(-3.5, 3.5)); };
      const Point2 a(lattice(), lattice()), b(lattice(), lattice());
      if (a == b) continue;
      const auto line = [](const Point2 &u, const Point2 &v, const Eigen::Rotation2Dd &Q) {
        return crosses_segment(u, v, Q * Point2(-2, 0), Q * Point2(2, 0));
      };
      const bool cut = line(a, b, Eigen::Rotation2Dd(0.0));
      EXPECT_EQ(line(plane * a, plane * b, plane), cut);
      EXPECT_EQ(cut, line(b, a, Eigen::Rotation2Dd(0.0)));
      const auto arc = [](const Point2 &u, const Point2 &v, double start) {
        return crosses_arc(u, v, Point2(0, 0), 2.0, start, std::acos(-1.0));
      };
      const bool arced = arc(a, b, 0.0);
      EXPECT_EQ(arc(plane * a, plane * b, plane.angle()), arced);
      EXPECT_EQ(arced, arc(b, a, 0.0));
      const Point3 c(a[0], a[1], lattice()), d(b[0], b[1], lattice());
      const bool holed = crosses_polygon(c, d, square);
      EXPECT_EQ(crosses_polygon(space * c, space * d, turned), holed);
      const bool punched = crosses_disc(c, d, Point3(0, 0, 0), Point3(0, 0, 1), 2.0);
      EXPECT_EQ(crosses_disc(space * c, space * d, Point3(0, 0, 0), space * Point3(0, 0, 1), 2.0),
                punched);
      crossed += cut + arced + holed + punched;
    }
  }
  EXPECT_GT(crossed, 1000);
}

}    // namespace
