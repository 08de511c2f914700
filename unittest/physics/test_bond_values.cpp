/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What particles and bonds carry stays with them: on the way to other
   processors and places, and when families change.
------------------------------------------------------------------------- */

#include "tmsph_bond_values.h"

#include <gtest/gtest.h>

using namespace LAMMPS_NS;

static std::vector<double> of_particle(const TMSPHBondValues &values, int i)
{
  std::vector<double> all;
  for (int n = 0; n < values.count(i); n++) {
    all.push_back(values.place(i, n));
    all.insert(all.end(), values.values(i, n), values.values(i, n) + values.width);
  }
  return all;
}

TEST(BondValues, FoundByPlaceInAnyOrderOfInsertion)
{
  TMSPHBondValues values("opening", 2);
  EXPECT_EQ(values.bytes(), 0.0);
  for (const int k : {7, 2, 5}) {
    double *const one = values.insert(1, k, 3);
    EXPECT_EQ(one[0], 0.0);
    one[0] = k;
    one[1] = -k;
  }
  EXPECT_EQ(of_particle(values, 1), (std::vector<double>{2, 2, -2, 5, 5, -5, 7, 7, -7}));
  EXPECT_EQ(values.count(0), 0);
  EXPECT_EQ(values.find(1, 5)[1], -5.0);
  for (const int k : {0, 3, 8}) EXPECT_EQ(values.find(1, k), nullptr);
  values.erase(1, 5);
  values.erase(1, 4);    // has none
  EXPECT_EQ(of_particle(values, 1), (std::vector<double>{2, 2, -2, 7, 7, -7}));
}

TEST(BondValues, FollowTheFamily)
{
  TMSPHBondValues values("opening", 1);
  for (const int k : {0, 1, 3}) values.insert(0, k, 1)[0] = 10 + k;
  values.move(0, {2, -1, 0, 1});    // place 1 is forgotten, the others have other ids
  EXPECT_EQ(of_particle(values, 0), (std::vector<double>{1, 13, 2, 10}));
}

TEST(BondValues, TravelAndAreCopied)
{
  TMSPHBondValues here("opening", 2), there("opening", 2);
  here.insert(0, 4, 2)[1] = 3.5;
  here.insert(0, 9, 2)[0] = 1.5;
  std::vector<double> buf(here.most(10), -1.0);
  ASSERT_EQ(here.pack(0, buf.data()), here.size(0));
  ASSERT_LE(here.size(0), here.most(10));
  EXPECT_EQ(there.unpack(1, buf.data(), 2), here.size(0));
  EXPECT_EQ(of_particle(there, 1), of_particle(here, 0));
  there.copy(1, 0);
  there.clear(1);
  EXPECT_EQ(of_particle(there, 0), of_particle(here, 0));
  EXPECT_EQ(there.count(1), 0);
  TMSPHBondValues nothing("opening", 2);
  EXPECT_EQ(nothing.pack(0, buf.data()), 1);
  EXPECT_EQ(nothing.unpack(0, buf.data(), 1), 1);
  EXPECT_EQ(nothing.bytes(), 0.0);
}

TEST(ParticleValues, OnlyBetweenStartAndStop)
{
  TMSPHParticleValues values("slip", 2);
  double buf[2] = {1.0, 2.0};
  EXPECT_EQ(values.pack(0, buf), 0);
  EXPECT_EQ(values.bytes(), 0.0);
  values.start(2);
  EXPECT_TRUE(std::isnan(values[1][0]));
  EXPECT_EQ(values.unpack(1, buf), 2);
  values.copy(1, 0);
  values.clear(1);
  EXPECT_EQ(values[0][1], 2.0);
  EXPECT_TRUE(std::isnan(values[1][1]));
  values.stop();
  EXPECT_FALSE(values.carried());
  EXPECT_EQ(values.bytes(), 0.0);
}
