/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Random points in a square and between periodic faces, in space too, are spread evenly; in a body
   of two materials across their interface too. Lattices are not pushed apart, and in
   balance.
------------------------------------------------------------------------- */

#include "tmsph_relaxation.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>

using namespace TMSPH;

namespace {

constexpr double HORIZON = 3.015;    // spacings are 1

/// bodies side by side along the first axis, each so long; periodic in the other directions or not
template <int D> class Row : public BodyShapes<D> {
 public:
  using Vector = Eigen::Matrix<double, D, 1>;
  static constexpr int NOTHING = TangentPlane<D>::NOTHING;

  Row(int bodies, double length, double width, bool periodic) :
      bodies(bodies), length(length), width(width), periodic(periodic)
  {
  }
  bool inside(int body, const Vector &X) const override
  {
    for (int k = 1; k < D; k++)
      if (!periodic && (X[k] < 0.0 || X[k] > width)) return false;
    return X[0] >= body * length && X[0] <= (body + 1) * length;
  }
  std::vector<TangentPlane<D>> planes(int body, const Vector &X, double reach) const override
  {
    std::vector<TangentPlane<D>> found;
    const auto add = [&](int k, double sign, double depth, int beyond) {
      if (depth < reach) found.push_back({sign * Vector::Unit(k), depth, beyond});
    };
    add(0, -1.0, X[0] - body * length, body > 0 ? body - 1 : NOTHING);
    add(0, 1.0, (body + 1) * length - X[0], body + 1 < bodies ? body + 1 : NOTHING);
    for (int k = 1; k < D && !periodic; k++) {
      add(k, -1.0, X[k], NOTHING);
      add(k, 1.0, width - X[k], NOTHING);
    }
    return found;
  }
  CloudBox<D> box() const
  {
    CloudBox<D> box{Vector::Zero(), Vector::Zero()};
    for (int k = 1; k < D && periodic; k++) box.period[k] = width;
    return box;
  }

 private:
  const int bodies;
  const double length, width;
  const bool periodic;
};

template <int D> Relaxation<D> spread(std::vector<CloudParticle<D>> cloud, const Row<D> &row)
{
  const int count = cloud.size();
  return {std::move(cloud),
          row.box(),
          row,
          {WendlandC2(), {{HORIZON, HORIZON}, {HORIZON, HORIZON}}},
          {0, count, [](double *, int) {}}};
}

/// cells of a square or cubic lattice, jittered: any amount makes them random
template <int D>
std::vector<CloudParticle<D>> cells(int bodies, int length, int width, double jitter)
{
  std::mt19937 random(4711);
  std::uniform_real_distribution<double> uniform(-jitter, jitter);
  std::vector<CloudParticle<D>> cloud;
  const int rows = D == 3 ? width : 1;
  for (int x = 0; x < bodies * length; x++)
    for (int y = 0; y < width; y++)
      for (int z = 0; z < rows; z++) {
        const int cell[3] = {x, y, z};
        CloudParticle<D> p;
        for (int k = 0; k < D; k++) p.place[k] = cell[k] + 0.5 + uniform(random);
        p.size = 1.0;
        p.body = p.type = x / length;
        cloud.push_back(p);
      }
  return cloud;
}

struct Worst {
  double nearest = HUGE_VAL, imbalance = 0.0;
};

template <int D> Worst worst(Relaxation<D> &relaxation)
{
  Worst all;
  for (const CloudFigures &f : relaxation.figures()) {
    all.nearest = std::min(all.nearest, f.nearest);
    all.imbalance = std::max(all.imbalance, f.imbalance);
  }
  return all;
}

/* Blue noise has 0.65 to 0.85 of the distance in the densest lattice between its two nearest
   points: Lagae, Dutre, Comput. Graph. Forum 27 (2008) 114. A jittered lattice has an imbalance of
   about the jitter, and bodies a hundredth of that at least. */

template <int D> void becomes_even(int bodies, int length, int width, bool periodic)
{
  const Row<D> row(bodies, length, width, periodic);
  Relaxation<D> relaxation = spread<D>(cells<D>(bodies, length, width, 0.49), row);
  const Worst before = worst(relaxation);
  relaxation.push(relaxation.pushes());
  relaxation.balance(100);
  const Worst after = worst(relaxation);
  const double densest = D == 2 ? std::sqrt(2.0 / std::sqrt(3.0)) : std::pow(2.0, 1.0 / 6.0);
  EXPECT_GT(after.nearest, 0.65 * densest);
  EXPECT_LT(after.imbalance, 0.01 * before.imbalance);
  for (const CloudParticle<D> &p : relaxation.particles()) EXPECT_TRUE(row.inside(p.body, p.place));
}

TEST(Relaxation, SpreadsPointsOverASquare)
{
  becomes_even<2>(1, 12, 12, false);
}

TEST(Relaxation, SpreadsPointsInSpace)
{
  becomes_even<3>(1, 7, 5, true);    // balanced in the middle row, and along both faces
}

TEST(Relaxation, SpreadsPointsBetweenPeriodicFaces)
{
  becomes_even<2>(1, 12, 4, true);    // narrower than two horizons
}

TEST(Relaxation, SpreadsTwoBodiesUpToTheirInterface)
{
  becomes_even<2>(2, 8, 12, false);
}

template <int D> void stays(int bodies, bool periodic)
{
  const auto lattice = cells<D>(bodies, 6, 6, 0.0);
  const Row<D> row(bodies, 6, 6, periodic);
  Relaxation<D> relaxation = spread<D>(lattice, row);
  relaxation.push(3);
  for (size_t i = 0; i < lattice.size(); i++)
    EXPECT_LT((relaxation.particles()[i].place - lattice[i].place).norm(), 1e-12);
}

TEST(Relaxation, PushesNoLatticeApart)
{
  stays<2>(1, false);
  stays<2>(2, false);
  stays<2>(1, true);
  stays<3>(1, false);
  stays<3>(2, true);
}

/// beyond two horizons from its ends; within one of them shape matrices are others
template <int D> void is_balanced(int bodies)
{
  const Row<D> row(bodies, 14 / bodies, 4, true);
  Relaxation<D> relaxation = spread<D>(cells<D>(bodies, 14 / bodies, 4, 0.0), row);
  const auto figures = relaxation.figures();
  int inside = 0;
  for (size_t i = 0; i < figures.size(); i++) {
    if (std::fabs(relaxation.particles()[i].place[0] - 7.0) > 7.0 - 2.0 * HORIZON) continue;
    EXPECT_LT(figures[i].imbalance, 1e-12);
    inside++;
  }
  EXPECT_GT(inside, 0);
}

TEST(Relaxation, LatticesAreInBalance)
{
  is_balanced<2>(1);
  is_balanced<2>(2);    // the interface is in the middle
  is_balanced<3>(1);
}

TEST(Relaxation, FindsTwoAtOnePlace)
{
  auto lattice = cells<2>(1, 6, 6, 0.0);
  lattice[7].place = lattice[20].place;
  const Row<2> row(1, 6, 6, false);
  Relaxation<2> relaxation = spread<2>(lattice, row);
  const auto figures = relaxation.figures();
  EXPECT_EQ(figures[7].nearest, 0.0);
  EXPECT_EQ(figures[7].neighbor, 20);
  EXPECT_EQ(figures[20].neighbor, 7);
}

TEST(Relaxation, LargerBodiesTakeMoreMoves)
{
  const Row<2> small(1, 6, 6, false), large(1, 100, 2, true);
  EXPECT_GT(spread<2>(cells<2>(1, 100, 2, 0.0), large).pushes(),
            spread<2>(cells<2>(1, 6, 6, 0.0), small).pushes());
}

}    // namespace
