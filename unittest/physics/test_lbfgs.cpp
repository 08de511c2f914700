/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Limited-memory BFGS: the secant condition, minima of ill-conditioned functions,
   with a preconditioner and without; sums that do not depend on their order; the
   coarse grid against the energy of homogeneous deformations.
------------------------------------------------------------------------- */

#include "tmsph_coarse_grid.h"
#include "tmsph_lbfgs.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>
#include <random>

using namespace TMSPH;
using Numbers = std::vector<double>;

namespace {

double dot(const LBFGS::Vector &a, const LBFGS::Vector &b, int n)
{
  double sum = 0.0;
  for (int i = 0; i < n; i++) sum += a.at[i] * b.at[i];
  return sum;
}

/** Follows the directions with the line search of the minimizer: secant steps where the slope
    has turned too far.
    @return evaluations of the force until its norm has fallen by "ratio" */
int minimize(Numbers &x, const std::function<Numbers(const Numbers &)> &force, double ratio,
             const Numbers &compliance)
{
  const int n = x.size();
  LBFGS lbfgs(6);
  std::vector<Numbers> s(6, Numbers(n)), y(6, Numbers(n));
  Numbers f = force(x);
  int evaluations = 1;
  const auto product = [n](const LBFGS::Vector &a, const LBFGS::Vector &b) { return dot(a, b, n); };
  const auto precondition = [&](LBFGS::Vector &v) {
    for (int i = 0; i < n; i++) v.at[i] *= compliance[i];
  };
  const double start = std::sqrt(product({f.data(), 0.0}, {f.data(), 0.0}));
  while (std::sqrt(product({f.data(), 0.0}, {f.data(), 0.0})) > ratio * start &&
         evaluations < 100000) {
    Numbers d = f;
    LBFGS::Vector direction = {d.data(), 0.0};
    lbfgs.direction(
        n, direction, [&](int k) { return s[k].data(); }, [&](int k) { return y[k].data(); },
        product, precondition);
    const double slope = product(direction, {f.data(), 0.0});
    double length = lbfgs.known() ? 1.0 : 1e-4, there;
    Numbers to(n), after;
    for (int trial = 0; trial < 20; trial++) {
      for (int i = 0; i < n; i++) to[i] = x[i] + length * d[i];
      after = force(to);
      evaluations++;
      there = product(direction, {after.data(), 0.0});
      if (there > -0.9 * slope) break;
      length = secant_length(length, slope, there, 0.1, 0.9);
    }
    const int k = lbfgs.next();
    double work = 0.0, scaled = 0.0;
    for (int i = 0; i < n; i++) {
      s[k][i] = length * d[i];
      y[k][i] = f[i] - after[i];
      work += s[k][i] * y[k][i];
      scaled += y[k][i] * y[k][i] * compliance[i];
    }
    if (work > 0.0) lbfgs.take(0.0, 0.0, work, scaled);
    x = to;
    f = after;
  }
  return evaluations;
}

}    // namespace

/* ---------------------------------------------------------------------- */

TEST(LBFGS, TheNewestPairIsReproduced)
{
  const int n = 12;
  std::mt19937_64 engine(3);
  std::normal_distribution<double> random;
  LBFGS lbfgs(4);
  std::vector<Numbers> s(4, Numbers(n)), y(4, Numbers(n));
  for (int pair = 0; pair < 7; pair++) {
    const int k = lbfgs.next();
    double work = 0.0, square = 0.0;
    for (int i = 0; i < n; i++) {
      s[k][i] = random(engine);
      y[k][i] = (1.0 + i) * s[k][i] + 0.01 * random(engine);
      work += s[k][i] * y[k][i];
      square += y[k][i] * y[k][i];
    }
    ASSERT_GT(work, 0.0);
    lbfgs.take(0.0, 0.0, work, square);
    Numbers d = y[k];
    LBFGS::Vector v = {d.data(), 0.0};
    lbfgs.direction(
        n, v, [&](int slot) { return s[slot].data(); }, [&](int slot) { return y[slot].data(); },
        [](const LBFGS::Vector &a, const LBFGS::Vector &b) { return dot(a, b, n); },
        [](LBFGS::Vector &) {});
    for (int i = 0; i < n; i++) EXPECT_NEAR(d[i], s[k][i], 1e-12);
  }
}

TEST(LBFGS, QuadraticFormOfConditionTenThousand)
{
  const int n = 60;
  Numbers stiffness(n), compliance(n, 1.0);
  for (int i = 0; i < n; i++) stiffness[i] = std::pow(10.0, 4.0 * i / (n - 1));
  const auto force = [&](const Numbers &x) {
    Numbers f(n);
    for (int i = 0; i < n; i++) f[i] = stiffness[i] * (1.0 - x[i]);
    return f;
  };
  Numbers x(n, 0.0);
  const int plain = minimize(x, force, 1e-8, compliance);
  for (double value : x) EXPECT_NEAR(value, 1.0, 1e-3);
  for (int i = 0; i < n; i++) compliance[i] = 1.0 / stiffness[i];
  x.assign(n, 0.0);
  const int preconditioned = minimize(x, force, 1e-8, compliance);
  for (double value : x) EXPECT_NEAR(value, 1.0, 1e-7);
  EXPECT_LT(plain, 1000);
  EXPECT_LT(preconditioned, 10);
}

TEST(LBFGS, CurvedValley)
{
  // Rosenbrock's function: minimum at (1, 1)
  const auto force = [](const Numbers &x) {
    const double up = x[1] - x[0] * x[0];
    return Numbers{2.0 * (1.0 - x[0]) + 400.0 * up * x[0], -200.0 * up};
  };
  Numbers x = {-1.2, 1.0};
  EXPECT_LT(minimize(x, force, 1e-9, {1.0, 1.0}), 300);
  EXPECT_NEAR(x[0], 1.0, 1e-6);
  EXPECT_NEAR(x[1], 1.0, 1e-6);
}

/* ---------------------------------------------------------------------- */

TEST(FixedPoint, SumsDoNotDependOnTheirOrder)
{
  const int n = 5000;
  std::mt19937_64 engine(17);
  std::uniform_real_distribution<double> exponent(-12.0, 0.0), sign(-1.0, 1.0);
  Numbers a(n), b(n);
  long double exact = 0.0;
  for (int i = 0; i < n; i++) {
    a[i] = std::pow(10.0, exponent(engine)) * (sign(engine) < 0.0 ? -1.0 : 1.0);
    b[i] = std::pow(10.0, exponent(engine));
    exact += (long double) a[i] * b[i];
  }
  const double bound = n * largest_magnitude(n, a.data()) * largest_magnitude(n, b.data());
  const double scale = fixed_point_scale(bound);
  const std::int64_t sum = fixed_point_dot(n, a.data(), b.data(), scale);
  EXPECT_NEAR(sum / scale, (double) exact, n / scale);
  EXPECT_LT(n / scale, 1e-14 * bound);
  std::vector<int> order(n);
  for (int i = 0; i < n; i++) order[i] = i;
  for (int shuffle = 0; shuffle < 5; shuffle++) {
    std::shuffle(order.begin(), order.end(), engine);
    Numbers p(n), q(n);
    for (int i = 0; i < n; i++) {
      p[i] = a[order[i]];
      q[i] = b[order[i]];
    }
    const int part = n / (shuffle + 2);
    EXPECT_EQ(fixed_point_dot(part, p.data(), q.data(), scale) +
                  fixed_point_dot(n - part, p.data() + part, q.data() + part, scale),
              sum);
  }
}

TEST(FixedPoint, TermsOfOneSignUpToTheBoundDoNotOverflow)
{
  const Numbers ones(1000, 3.0);
  const double scale = fixed_point_scale(1000 * 9.0);
  EXPECT_EQ(fixed_point_dot(1000, ones.data(), ones.data(), scale) / scale, 9000.0);
  EXPECT_EQ(fixed_point_scale(0.0), 0.0);
  EXPECT_EQ(fixed_point_scale(HUGE_VAL), 0.0);
}

/* ----------------------------------------------------------------------
   nodes on which forces of a homogeneous deformation act answer with it: the
   stiffness times a linear field is the force, which solve() must undo
------------------------------------------------------------------------- */

template <int D> void homogeneous()
{
  using Grid = CoarseGrid<D>;
  const double low[3] = {-1.0, 0.5, 2.0}, high[3] = {1.0, 2.1, 3.0};
  const bool periodic[3] = {false, false, false};
  Grid grid(low, high, periodic, 0.4, 100000);
  const int points = D == 2 ? 40 : 16;
  const double lambda = 1.7, shear = 0.9;
  std::vector<std::int64_t> stiffness(grid.entries(), 0);
  const double scale = std::ldexp(1.0, 40);
  // Gauss points would be exact; many even points are so to their own share
  std::vector<Numbers> where;
  for (int m = 0; m < std::pow(points, D); m++) {
    Numbers X(3, 0.0);
    for (int k = 0, rest = m; k < D; k++, rest /= points)
      X[k] = low[k] + (high[k] - low[k]) * (rest % points + 0.5) / points;
    grid.add_stiffness(X.data(), lambda, shear, scale, stiffness.data());
    where.push_back(X);
  }
  const double free = 1e-10;
  ASSERT_TRUE(grid.factorize(stiffness.data(), scale, free));

  // forces of the traction that a strain needs: sum over points of stress times slope, by
  // differences of the shape functions

  Eigen::VectorXd forces = Eigen::VectorXd::Zero(grid.freedoms());
  double strain[D][D], trace = 0.0;
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) strain[a][b] = 0.01 * (a == b ? a + 1 : 0.5);
  for (int a = 0; a < D; a++) trace += strain[a][a];
  for (const Numbers &X : where)
    for (int b = 0; b < D; b++) {
      const double step = 1e-5;
      Numbers up = X, down = X;
      up[b] += step;
      down[b] -= step;
      const auto p = grid.place(up.data()), q = grid.place(down.data());
      for (int c = 0; c < Grid::CORNERS; c++)
        for (int a = 0; a < D; a++) {
          const double stress = 2.0 * shear * strain[a][b] + (a == b ? lambda * trace : 0.0);
          forces[p.node[c] * D + a] += stress * p.weight[c] / (2.0 * step);
          forces[q.node[c] * D + a] -= stress * q.weight[c] / (2.0 * step);
        }
    }
  const Eigen::VectorXd u = grid.solve(forces);

  // the strain at a point inside, whatever rigid motion was added

  const double middle[3] = {0.03, 1.27, 2.52};
  const auto displacement = [&](const Numbers &X, int a) {
    const auto p = grid.place(X.data());
    double value = 0.0;
    for (int c = 0; c < Grid::CORNERS; c++) value += p.weight[c] * u[p.node[c] * D + a];
    return value;
  };
  double found[D][D];
  for (int b = 0; b < D; b++) {
    Numbers up(middle, middle + 3), down = up;
    up[b] += 0.3;
    down[b] -= 0.3;
    for (int a = 0; a < D; a++) found[a][b] = (displacement(up, a) - displacement(down, a)) / 0.6;
  }
  for (int a = 0; a < D; a++)
    for (int b = 0; b < D; b++) EXPECT_NEAR(0.5 * (found[a][b] + found[b][a]), strain[a][b], 1e-6);
}

TEST(CoarseGrid, HomogeneousStrain2D)
{
  homogeneous<2>();
}
TEST(CoarseGrid, HomogeneousStrain3D)
{
  homogeneous<3>();
}

TEST(CoarseGrid, PeriodicPlacesWrapAround)
{
  const double low[3] = {0.0, 0.0, 0.0}, high[3] = {1.0, 1.0, 1.0};
  const bool periodic[3] = {true, false, false};
  const CoarseGrid<2> grid(low, high, periodic, 0.2, 1000);
  const double X[2] = {0.95, 0.37}, wrapped[2] = {-0.05, 0.37};
  const auto p = grid.place(X), q = grid.place(wrapped);
  double sum = 0.0;
  for (int c = 0; c < 4; c++) {
    EXPECT_EQ(p.node[c], q.node[c]);
    EXPECT_NEAR(p.weight[c], q.weight[c], 1e-14);
    sum += p.weight[c];
  }
  EXPECT_NEAR(sum, 1.0, 1e-14);
  EXPECT_EQ(grid.freedoms(), 2 * 5 * 6);
}
