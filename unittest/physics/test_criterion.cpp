/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What every failure criterion promises to those that break bonds.
------------------------------------------------------------------------- */

#include "tmsph_hoekbrown.h"
#include "tmsph_mohrcoulomb.h"
#include "tmsph_rankine.h"

#include <gtest/gtest.h>

#include <functional>
#include <random>

using namespace TMSPH;

namespace {

struct Case {
  const char *name;
  std::function<std::unique_ptr<Criterion>()> make;    // its values but for the strength are used
  double strength;
  std::vector<double> constants;
  double spared;    // by the cheap bound, of the states that are safe, at least
};

template <class Law> std::unique_ptr<Criterion> make()
{
  return std::make_unique<CriterionOf<Law>>();
}

const Case CASES[] = {
    {"hoekbrown_gsi100", make<HoekBrown>, 120.0e6, {8.0, 100.0, 0.0}, 0.33},
    {"hoekbrown_gsi75", make<HoekBrown>, 120.0e6, {8.0, 75.0, 0.0}, 0.0},
    {"hoekbrown_gsi75_d1", make<HoekBrown>, 120.0e6, {8.0, 75.0, 1.0}, 0.0},
    {"hoekbrown_gsi50_d1", make<HoekBrown>, 120.0e6, {8.0, 50.0, 1.0}, 0.0},
    {"mohrcoulomb", make<MohrCoulomb>, 25.0e6, {45.0, 7.0e6}, 0.33},
    {"mohrcoulomb_no_friction", make<MohrCoulomb>, 25.0e6, {0.0, 7.0e6}, 0.33},
    {"mohrcoulomb_cut_off_beyond_apex", make<MohrCoulomb>, 25.0e6, {60.0, 30.0e6}, 0.33},
    {"rankine", make<Rankine>, 10.0e6, {}, 0.33},
};

Principals times(const Principals &p, double factor)
{
  return {p.largest * factor, p.middle * factor, p.smallest * factor};
}

class AnyCriterion : public ::testing::TestWithParam<Case> {
 protected:
  const double strength = GetParam().strength;
  const std::unique_ptr<Criterion> law = GetParam().make();
  std::mt19937_64 engine{31};

  AnyCriterion()
  {
    std::vector<double> values = {strength};
    values.insert(values.end(), GetParam().constants.begin(), GetParam().constants.end());
    law->add(values);
  }
  bool fails(const Principals &p, double s) const { return law->fails(1, 1, p, s); }
  double load_factor(const Principals &p, double s) const { return law->load_factor(1, 1, p, s); }

  /// at the stress divided by o it just fails; where o is 0 no multiple of it does
  void check(const Principals &e, double o)
  {
    EXPECT_FALSE(fails(times(e, o > 0.0 ? (1.0 - 1.0e-9) / o : 1.0e9), strength));
    if (o > 0.0) { EXPECT_TRUE(fails(times(e, (1.0 + 1.0e-9) / o), strength)); }
  }

  Eigen::Matrix3d random_stress(double scale)
  {
    std::normal_distribution<double> normal(0.0, scale);
    Eigen::Matrix3d A;
    for (int i = 0; i < 9; i++) A(i / 3, i % 3) = normal(engine);
    // the strength in compression is far above that in tension: shift most states there
    const double pressure = 2.0 * std::fabs(normal(engine));
    return 0.5 * (A + A.transpose()) - pressure * Eigen::Matrix3d::Identity();
  }
};

Principals principals(const Eigen::Matrix3d &A)
{
  const double s[6] = {A(0, 0), A(1, 1), A(2, 2), A(0, 1), A(0, 2), A(1, 2)};
  return principals_3d(s);
}

// the words take the values of the cases, and name a rule for those that they do not take
TEST_P(AnyCriterion, words)
{
  ASSERT_EQ(law->words().size(), 1 + GetParam().constants.size());
  EXPECT_EQ(law->words()[0].standard, REQUIRED);
  for (const CriterionWord &word : law->words()) {
    EXPECT_FALSE(word.allows(-1.0)) << word.name;
    EXPECT_FALSE(word.allows(std::nan(""))) << word.name;
    EXPECT_GT(std::string(word.rule).size(), 0u) << word.name;
    if (word.standard != REQUIRED) { EXPECT_TRUE(word.allows(word.standard)) << word.name; }
  }
}

// pressure alone never breaks rock
TEST_P(AnyCriterion, pressure)
{
  for (double p : {0.0, 1.0e3, 1.0e9, 1.0e12}) {
    EXPECT_FALSE(fails({-p, -p, -p}, strength));
    EXPECT_LT(load_factor({-p, -p, -p}, strength), 1.0e-20);
  }
}

TEST_P(AnyCriterion, load_factor_divides_to_failure)
{
  int beyond = 0;
  for (int k = 0; k < 2000; k++) {
    const Principals e = principals(random_stress(20.0e6));
    const double o = load_factor(e, strength);
    check(e, o);
    EXPECT_EQ(o >= 1.0, fails(e, strength));
    beyond += o >= 1.0;
    for (double factor : {1.0e-3, 0.3, 7.0, 1.0e3})
      EXPECT_NEAR(load_factor(times(e, factor), strength), factor * o, 1.0e-10 * factor * o);
  }
  EXPECT_GT(beyond, 20);    // states on both sides were seen
  EXPECT_LT(beyond, 1980);
}

// far out in compression the factor is small, but keeps its digits
TEST_P(AnyCriterion, load_factor_at_high_pressure)
{
  const double difference = 1.2345e6;
  for (double confinement : {1.0e8, 1.0e9, 1.0e10}) {
    const Principals e = {-confinement, -confinement, -confinement - difference};
    check(e, load_factor(e, strength));
  }
}

// those that break bonds test none between two ends that are safe: their mean stress with their
// mean strength is then safe, in the plane and in space, whatever the strengths
TEST_P(AnyCriterion, mean_of_safe_states_is_safe)
{
  std::uniform_real_distribution<double> uniform(0.3, 1.7);
  int pairs = 0;
  for (int k = 0; k < 20000; k++) {
    const double s[2] = {strength * uniform(engine), strength * uniform(engine)};
    Eigen::Matrix3d stress[2];
    for (int end : {0, 1}) {
      // half of the pairs stand just inside the failure surface
      stress[end] = random_stress(30.0e6);
      const double o = load_factor(principals(stress[end]), s[end]);
      if (k % 2 && o > 0.0) stress[end] *= (1.0 - 1.0e-9) / o;
    }
    const bool planar = k % 4 < 2;
    if (planar)
      for (auto &s : stress) s(2, 0) = s(0, 2) = s(2, 1) = s(1, 2) = 0.0;
    bool safe = true;
    for (int end : {0, 1}) safe = safe && !fails(principals(stress[end]), s[end]);
    if (!safe) continue;
    pairs++;
    EXPECT_FALSE(fails(principals(0.5 * (stress[0] + stress[1])), 0.5 * (s[0] + s[1])));
  }
  EXPECT_GT(pairs, 2000);
}

// the cheap bound never calls a state safe that fails; in intact rock it spares many of the rest
TEST_P(AnyCriterion, bound_is_safe)
{
  int spared = 0, safe = 0;
  for (int k = 0; k < 20000; k++) {
    Eigen::Matrix3d stress = random_stress(30.0e6);
    const bool planar = k % 2;
    if (planar) stress.row(2) = stress.col(2).transpose() = Eigen::Vector3d::Zero().transpose();
    const double row[6] = {stress(0, 0), stress(1, 1), stress(2, 2),
                           stress(0, 1), stress(0, 2), stress(1, 2)};
    const double plane[3] = {row[0], row[1], row[3]};
    const Principals e = planar ? principals_2d(plane) : principals_3d(row);
    const double o = load_factor(e, strength);
    // random, and just beyond failure
    const double at_failure = o > 0.0 ? 1.0 / o : 1.0;
    for (double factor : {1.0, (1.0 + 1.0e-9) * at_failure, 0.3 * at_failure}) {
      double scaled[6];
      for (int c = 0; c < 6; c++) scaled[c] = factor * (planar && c < 3 ? plane[c] : row[c]);
      const Invariants m = planar ? invariants_2d(scaled) : invariants_3d(scaled);
      const bool may = law->may_fail(1, m, planar ? 1.0 : 2.0 / std::sqrt(3.0), strength);
      const bool does = fails(times(e, factor), strength);
      EXPECT_TRUE(may || !does);
      safe += !does;
      spared += !may;
    }
  }
  EXPECT_GT(spared, GetParam().spared * safe);
}

INSTANTIATE_TEST_SUITE_P(All, AnyCriterion, ::testing::ValuesIn(CASES),
                         [](const auto &info) { return std::string(info.param.name); });

}    // namespace
