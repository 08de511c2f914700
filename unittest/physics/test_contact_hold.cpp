// TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
// One step of a contact law at one or two places: forces, friction, anchors.

#include "tmsph_contact_hold.h"

#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <vector>

using namespace TMSPH;

namespace {

const ContactLaw &IMPLICIT = CONTACT_LAWS[0], &PENALTY = CONTACT_LAWS[1];

class ContactHold : public ::testing::Test {
 protected:
  std::mt19937_64 engine{45};
  std::uniform_real_distribution<double> uniform;
  double random(double low, double high) { return low + (high - low) * uniform(engine); }
};

// after the force has acted the spring is compressed by what is left of the penetration
TEST_F(ContactHold, OnePlaceAnswersTheEndOfTheStep)
{
  for (int n = 0; n < 100; n++) {
    const double k = random(0.1, 10.0), q = random(0.0, 5.0), p = random(-1.0, 1.0), closing = 0.3;
    double force;
    hold_across(IMPLICIT, k, q, 1.0, 1, 0.0, &p, &closing, &force);
    EXPECT_NEAR(force, p > 0.0 ? k * (p - q * force / k) : 0.0, 1.0e-14 * k);
  }
}

// two springs, each compressed by what both forces leave; none pulls
TEST_F(ContactHold, CornerHoldsOrLetsGo)
{
  int both = 0;
  for (int n = 0; n < 1000; n++) {
    const double k = random(0.1, 10.0), q = random(0.0, 5.0), cosine = random(-0.9, 0.9);
    const double p[2] = {random(-1.0, 1.0), random(-1.0, 1.0)}, closing[2] = {};
    double force[2];
    hold_across(IMPLICIT, k, q, 1.0, 2, cosine, p, closing, force);
    for (int a = 0; a < 2; a++) {
      const double left = k * p[a] - q * (force[a] + cosine * force[1 - a]);
      EXPECT_GE(force[a], 0.0);
      if (force[a] > 0.0)
        EXPECT_NEAR(force[a], left, 1.0e-12 * k);
      else
        EXPECT_LE(left, 1.0e-12 * k);
    }
    both += force[0] > 0.0 && force[1] > 0.0;
  }
  EXPECT_GT(both, 100);
}

// a dashpot beside the spring of a place that presses, of a share of the critical damping
TEST_F(ContactHold, DampingOfPlacesThatPress)
{
  const double k = 4.0, frequency = 9.0, p[2] = {0.5, -0.1}, closing[2] = {0.2, 0.2};
  double force[2];
  hold_across(PENALTY, k, 0.0, frequency, 2, 0.3, p, closing, force);
  EXPECT_DOUBLE_EQ(force[0], k * 0.5 + PENALTY.damping * 2.0 * k / 3.0 * 0.2);
  EXPECT_EQ(force[1], 0.0);
  const double parting[2] = {-1.0e3, 0.0};
  hold_across(PENALTY, k, 0.0, frequency, 2, 0.3, p, parting, force);
  EXPECT_EQ(force[0], 0.0);    // it does not pull
}

template <int N> void check_friction(const double *slip)
{
  const double k = 3.0, q = 0.5;
  double length = 0.0;
  for (int a = 0; a < N; a++) length += slip[a] * slip[a];
  length = std::sqrt(length);
  const double stick = k * length / (1.0 + q);

  const Friction<N> held = hold_along<N>(k, q, 1.01 * stick, slip);
  EXPECT_EQ(held.work, 0.0);
  const double energy = held_energy<N>(2.0, k, 0.8, held.force);
  EXPECT_NEAR(energy, 0.5 * 0.8 * 0.8 / 2.0 + 0.5 * stick * stick / k, 1.0e-14);

  const double limit = 0.6 * stick;
  const Friction<N> slides = hold_along<N>(k, q, limit, slip);
  double left[N], force = 0.0, way = 0.0;
  for (int a = 0; a < N; a++) {
    EXPECT_NEAR(held.force[a], k * slip[a] / (1.0 + q), 1.0e-14);
    EXPECT_EQ(held.excess[a], 0.0);
    force += slides.force[a] * slides.force[a];
    way += slides.excess[a] * slides.excess[a];
    left[a] = slip[a] - slides.excess[a];
  }
  EXPECT_NEAR(std::sqrt(force), limit, 1.0e-14);
  EXPECT_NEAR(slides.work, limit * std::sqrt(way), 1.0e-14);

  // from the anchor that went along it just sticks, with this force

  const Friction<N> again = hold_along<N>(k, q, limit * (1.0 + 1.0e-12), left);
  for (int a = 0; a < N; a++) EXPECT_NEAR(again.force[a], slides.force[a], 1.0e-14);
  EXPECT_EQ(again.work, 0.0);
}

TEST(ContactFriction, SticksOrSlides)
{
  const double slip[3] = {0.3, -0.4, 1.2};
  check_friction<1>(slip);
  check_friction<2>(slip);
  check_friction<3>(slip);
}

// anchors stay with their pieces; where there is one place only it takes over what is there
TEST(ContactAnchors, GoFromPieceToPiece)
{
  const std::vector<int> pieces = {7, 3};
  const auto find = [&](int piece, int places, char first_taken, char second_taken) {
    const char taken[2] = {first_taken, second_taken};
    return anchor_for((int) pieces.size(), taken, places,
                      [&](int n) { return pieces[n] == piece; });
  };
  EXPECT_EQ(find(3, 2, 0, 0), 1);
  EXPECT_EQ(find(7, 2, 0, 0), 0);
  EXPECT_EQ(find(7, 2, 1, 0), -1);    // another place has it
  EXPECT_EQ(find(5, 2, 0, 0), -1);    // in a corner each has its own
  EXPECT_EQ(find(5, 1, 0, 0), 0);
  EXPECT_EQ(find(3, 1, 0, 0), 1);    // its own first
  EXPECT_EQ(find(5, 1, 1, 0), 1);
  EXPECT_EQ(anchor_for(0, nullptr, 1, [](int) { return true; }), -1);
}

}    // namespace
