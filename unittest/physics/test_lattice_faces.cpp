/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Flat faces of lattices as the families of their particles show them, turned
   about any axis.
------------------------------------------------------------------------- */

#include "tmsph_lattice_faces.h"

#include <gtest/gtest.h>

#include <functional>

using namespace TMSPH;

namespace {

constexpr double HORIZON = 3.015;

double weight(double R)
{
  return R < HORIZON ? std::pow(1.0 - R / HORIZON, 3) : 0.0;
}

template <int D> Eigen::Matrix<double, D, D> turn()
{
  if constexpr (D == 2)
    return Eigen::Rotation2Dd(37.0 / 180.0 * M_PI).toRotationMatrix();
  else
    return Eigen::AngleAxisd(37.0 / 180.0 * M_PI, Eigen::Vector3d(1.0, 2.0, -0.7).normalized())
        .toRotationMatrix();
}

/// family of the particle at the origin of a turned lattice of unit spacing, of those inside
template <int D> LatticeFaces<D> family(const std::function<bool(const int *)> &inside)
{
  LatticeFaces<D> all(HORIZON);
  const int n = 3;
  int x[3] = {};
  for (x[0] = -n; x[0] <= n; x[0]++)
    for (x[1] = -n; x[1] <= n; x[1]++)
      for (x[2] = D == 2 ? 0 : -n; x[2] <= (D == 2 ? 0 : n); x[2]++) {
        Eigen::Matrix<double, D, 1> X;
        for (int a = 0; a < D; a++) X[a] = x[a];
        if (X.norm() == 0.0 || X.norm() > HORIZON || !inside(x)) continue;
        X = turn<D>() * X;
        all.add(X.data());
      }
  return all;
}

/// layer with this normal, before the turn
template <int D>
const Layer<D> *along(const LatticeFaces<D> &faces, Eigen::Matrix<double, D, 1> normal)
{
  for (const Layer<D> &layer : faces.found())
    if (std::fabs(layer.normal.dot(turn<D>() * normal)) > 1.0 - 1e-12) return &layer;
  return nullptr;
}

template <int D> void check_corner()
{
  for (int depth = 0; depth < 3; depth++) {
    auto faces = family<D>(
        [&](const int *x) { return x[0] <= depth && x[1] <= 0 && (D == 2 || x[2] <= 1); });
    ASSERT_TRUE(faces.find(weight));
    ASSERT_EQ(faces.found().size(), (size_t) D);
    for (int a = 0; a < D; a++) {
      Eigen::Matrix<double, D, 1> normal = Eigen::Matrix<double, D, 1>::Unit(a);
      const Layer<D> *layer = along<D>(faces, normal);
      ASSERT_TRUE(layer);
      EXPECT_NEAR(layer->above, 0.5 + (a == 0 ? depth : a == 1 ? 0 : 1), 1e-12);
      EXPECT_EQ(layer->below, 0.0);
    }
  }
}

TEST(LatticeFaces, corners)
{
  check_corner<2>();
  check_corner<3>();
}

// what all rows of a half space or of a plate pull through a face is half the second moment, and
// with the boost they conduct along it like the inside

template <int D> void check_rows(int rows)
{
  const Eigen::Matrix<double, D, 1> up = Eigen::Matrix<double, D, 1>::Unit(D - 1);
  double pull = 0.0, tangential = 0.0, full = 0.0;
  for (int depth = 0; depth < rows; depth++) {
    auto faces =
        family<D>([&](const int *x) { return x[D - 1] <= depth && x[D - 1] > depth - rows; });
    ASSERT_TRUE(faces.find(weight));
    ASSERT_EQ(faces.found().size(), 1u);
    const Layer<D> *layer = along<D>(faces, up);
    ASSERT_TRUE(layer);
    if (layer->below > 0.0) { EXPECT_NEAR(layer->above + layer->below, rows, 1e-12); }
    pull += layer->missing;
    full = faces.second_moment(weight) / D;
    for (int x = -3; x <= 3; x++)
      for (int y = -3; y <= 3; y++)
        for (int z = D == 2 ? 0 : -3; z <= (D == 2 ? 0 : 3); z++) {
          const int height = D == 2 ? y : z;
          const double R2 = x * x + y * y + z * z;
          if (R2 == 0.0 || height > depth || height <= depth - rows) continue;
          tangential += weight(std::sqrt(R2)) * (R2 - height * height) / (D - 1) *
              (height == 0 ? 1.0 + layer->boost : 1.0);
        }
  }
  EXPECT_NEAR(pull, full, 1e-12) << rows;    // of both faces
  EXPECT_NEAR(tangential, rows * full, 1e-11) << rows;
}

TEST(LatticeFaces, plates)
{
  for (int rows : {2, 3, 4}) {
    check_rows<2>(rows);
    check_rows<3>(rows);
  }
}

TEST(LatticeFaces, reentrant)
{
  auto inner = family<2>([](const int *x) { return x[0] <= 1 || x[1] <= 0; });
  ASSERT_TRUE(inner.find(weight));
  ASSERT_EQ(inner.found().size(), 2u);
  EXPECT_NEAR(along<2>(inner, Eigen::Vector2d::UnitX())->above, 1.5, 1e-12);
  EXPECT_NEAR(along<2>(inner, Eigen::Vector2d::UnitY())->above, 0.5, 1e-12);

  auto edge = family<3>([](const int *x) { return (x[0] <= 0 || x[1] <= 0) && x[2] <= 1; });
  ASSERT_TRUE(edge.find(weight));
  EXPECT_EQ(edge.found().size(), 3u);
}

TEST(LatticeFaces, none)
{
  auto inside = family<3>([](const int *) { return true; });
  EXPECT_TRUE(inside.find(weight));
  EXPECT_TRUE(inside.found().empty());

  auto step = family<2>([](const int *x) { return x[1] <= (x[0] < 1 ? 0 : x[0] < 2 ? -1 : -3); });
  EXPECT_FALSE(step.find(weight));
  EXPECT_TRUE(step.found().empty());

  LatticeFaces<2> disorder(HORIZON);
  for (double angle = 0.0; angle < 6.0; angle += 0.7) {
    const double X[3] = {(1.0 + 0.1 * angle) * std::cos(angle),
                         (1.0 + 0.2 * angle) * std::sin(angle)};
    disorder.add(X);
  }
  EXPECT_FALSE(disorder.find(weight));
}

}    // namespace
