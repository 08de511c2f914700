// TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
// Pairs of crack faces whose surface is found anew as the crack grows: no energy comes of it.

#include "tmsph_contact_pair.h"

#include "gtest/gtest.h"

#include <random>

using namespace TMSPH;

namespace {

constexpr double HORIZON = 3.0;

template <int D> struct Pair {
  ContactPair surface{};
  double X[D];

  // a plane with this normal halfway between the ends
  Pair(const double *X_in, const double *normal)
  {
    surface.stiffness = 2.0;
    surface.shear_ratio = 0.4;
    surface.friction = 0.5;
    surface.depth = 0.5;
    surface.horizon = HORIZON;
    double tangent[D - 1][D];
    static constexpr double REST[9] = {};
    for (int a = 0; a < D; a++) {
      X[a] = X_in[a];
      surface.normal_low[a] = surface.normal_high[a] = normal[a];
      surface.distance += normal[a] * X[a];
    }
    tangents(normal, REST, surface.normal_low, tangent);
    for (int k = 0; k < D - 1; k++)
      for (int a = 0; a < D; a++) surface.origin[k] += tangent[k][a] * X[a];
  }

  ContactState<D> at(const double *x, const ContactPast &past) const
  {
    static constexpr double REST[9] = {};
    const ContactEnd<D> low{REST, REST, REST, REST, 0.0, true};
    const ContactEnd<D> high{x, REST, REST, REST, 0.0, true};
    return contact_state<D>(surface, low, high, past, WendlandC2(), 0.0);
  }
};

template <int D> double energy(const ContactState<D> &s)
{
  if (!(s.penetration > 0.0)) return 0.0;
  double slip = 0.0;
  for (int k = 0; k < D - 1; k++) slip += s.slip[k] * s.slip[k];
  return 0.5 * s.stiffness * (s.penetration * s.penetration + s.shear_ratio * slip);
}

template <int D> void keeps_energy()
{
  std::mt19937 draw(1);
  std::normal_distribution<double> gauss;
  const auto unit = [&](double *n) {
    double square = 0.0;
    for (int a = 0; a < D; a++) {
      n[a] = gauss(draw);
      square += n[a] * n[a];
    }
    for (int a = 0; a < D; a++) n[a] /= std::sqrt(square);
  };
  int pressed = 0, worn = 0;
  for (int n = 0; n < 2000; n++) {
    double X[D], one[D], other[D], x[D], along = 0.0, along_other = 0.0;
    unit(X);
    unit(one);
    unit(other);
    for (int a = 0; a < D; a++) {
      along += one[a] * X[a];
      along_other += other[a] * X[a];
      x[a] = X[a] + 0.1 * gauss(draw);
    }
    if (along < 0.1 || along_other < 0.1) continue;    // surfaces between the ends
    const Pair<D> before(X, one), after(X, other);
    const ContactPast past = {{0.03 * gauss(draw), 0.03 * gauss(draw)},
                              std::max(0.0, 0.02 * gauss(draw))};
    const ContactState<D> was = before.at(x, past);
    const ContactPast next = past_of_refitted(was, after.at(x, {}));
    const ContactState<D> is = after.at(x, next);
    const double had = energy(was);
    EXPECT_LE(energy(is), had * (1.0 + 1.0e-12) + 1.0e-30);
    EXPECT_GE(next.worn, 0.0);
    pressed += had > 0.0;
    worn += next.worn > 0.0;
  }
  EXPECT_GT(pressed, 100);
  EXPECT_GT(worn, 100);
}

// the pair that was observed to throw a disc apart: slip along the surface, which then turns
TEST(ContactRefit, SlipDoesNotBecomeOverlap)
{
  const double X[2] = {0.0, 1.0}, up[2] = {0.0, 1.0}, turned[2] = {std::sqrt(0.5), std::sqrt(0.5)};
  const double x[2] = {-0.2, 0.999};
  const Pair<2> before(X, up), after(X, turned);
  const ContactPast past = {{before.at(x, {}).slip[0], 0.0}, 0.0};    // friction has given way
  const ContactState<2> was = before.at(x, past);
  EXPECT_NEAR(was.penetration, 1.0e-3, 1.0e-14);
  EXPECT_NEAR(was.slip[0], 0.0, 1.0e-14);
  EXPECT_NEAR(after.at(x, past).penetration, std::sqrt(0.5) * 0.201, 1.0e-14);
  const ContactState<2> is = after.at(x, past_of_refitted(was, after.at(x, {})));
  EXPECT_LE(is.penetration, 1.0e-3 * (1.0 + 1.0e-12));
  EXPECT_NEAR(is.slip[0], 0.0, 1.0e-14);
}

TEST(ContactRefit, SameSurfaceKeepsItsPast)
{
  const double X[2] = {0.3, 1.0}, up[2] = {0.0, 1.0}, x[2] = {0.35, 0.97};
  const Pair<2> pair(X, up);
  const ContactPast past = {{0.02, 0.0}, 0.01};
  const ContactPast next = past_of_refitted(pair.at(x, past), pair.at(x, {}));
  EXPECT_NEAR(next.moved[0], past.moved[0], 1.0e-14);
  EXPECT_NEAR(next.worn, past.worn, 1.0e-14);
}

TEST(ContactRefit, EnergyNeverRises2D)
{
  keeps_energy<2>();
}
TEST(ContactRefit, EnergyNeverRises3D)
{
  keeps_energy<3>();
}

}    // namespace
