/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Random numbers by particle id. The seeds are fixed, so a test passes or fails
   for good; bounds are those a true generator violates once in 1e5 or less.
------------------------------------------------------------------------- */

#include "tmsph_random.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <vector>

using namespace TMSPH;

namespace {

constexpr int N = 100000;

std::vector<double> sample(int64_t seed, int64_t stream = 0, int64_t first = 1, int64_t stride = 1)
{
  std::vector<double> u;
  for (int64_t k = 0; k < N; k++) u.push_back(uniform_random(first + stride * k, seed, stream));
  return u;
}

// correlation coefficient of two samples of uniform variates; its deviation is 1/sqrt(N)
double correlation(const std::vector<double> &a, const std::vector<double> &b, size_t lag = 0)
{
  double sum = 0.0;
  const size_t n = a.size() - lag;
  for (size_t k = 0; k < n; k++) sum += (a[k] - 0.5) * (b[k + lag] - 0.5);
  return 12.0 * sum / n;
}

// Kolmogorov-Smirnov: P(D sqrt(N) > z) = 2 exp(-2 z^2) = 1e-5 at z = 2.47
TEST(Random, uniform)
{
  for (int64_t seed : {1, 2, 4711, 2147483647})
    for (int64_t stride : {1, 2, 1024, 1000003}) {
      std::vector<double> u = sample(seed, 0, 1, stride);
      std::sort(u.begin(), u.end());
      double distance = 0.0;
      for (int k = 0; k < N; k++)
        distance = std::max({distance, u[k] - (double) k / N, (k + 1.0) / N - u[k]});
      EXPECT_LT(distance * std::sqrt((double) N), 2.47) << seed << " " << stride;
      EXPECT_GT(distance * std::sqrt((double) N), 0.3);    // nor more even than chance
    }
}

// 4.5 deviations: 7e-6
TEST(Random, independent_of_neighbors_seeds_and_streams)
{
  const double bound = 4.5 / std::sqrt((double) N);
  const std::vector<double> u = sample(4711);
  for (size_t lag : {1, 2, 3, 8, 100}) EXPECT_LT(std::fabs(correlation(u, u, lag)), bound) << lag;
  EXPECT_LT(std::fabs(correlation(u, sample(4712))), bound);
  EXPECT_LT(std::fabs(correlation(u, sample(4711, 1))), bound);
  EXPECT_LT(std::fabs(correlation(sample(1, 2), sample(2, 1))), bound);
  EXPECT_LT(std::fabs(correlation(u, sample(4711, 0, int64_t(1) << 40))), bound);
}

// pairs of neighbors fill the square evenly: chi-square of 20 x 20 cells has mean 399 and
// deviation sqrt(2 * 399) = 28
TEST(Random, pairs_of_neighbors_are_even)
{
  const std::vector<double> u = sample(99);
  std::vector<int> cell(400, 0);
  for (int k = 0; k + 1 < N; k += 2) cell[(int) (20.0 * u[k]) + 20 * (int) (20.0 * u[k + 1])]++;
  double chi2 = 0.0;
  const double expected = 0.5 * N / cell.size();
  for (int count : cell) chi2 += (count - expected) * (count - expected) / expected;
  EXPECT_NEAR(chi2, 399.0, 4.5 * 28.3);
}

TEST(Random, function_of_id_seed_and_stream)
{
  for (int64_t id = 1; id < 1000; id++) {
    EXPECT_EQ(uniform_random(id, 7, 0), uniform_random(id, 7, 0));
    EXPECT_NE(uniform_random(id, 7, 0), uniform_random(id, 8, 0));
    EXPECT_NE(uniform_random(id, 7, 0), uniform_random(id, 7, 1));
    EXPECT_NE(uniform_random(id, 7, 0), uniform_random(id + 1, 7, 0));
  }
}

/// x with x ^ (x >> shift) = z
uint64_t unshift(uint64_t z, int shift)
{
  uint64_t x = z;
  for (int bits = shift; bits < 64; bits += shift) x = z ^ (x >> shift);
  return x;
}

/// inverse of an odd number modulo 2^64, by Newton
uint64_t inverse(uint64_t odd)
{
  uint64_t x = odd;
  for (int k = 0; k < 6; k++) x *= 2 - odd * x;
  return x;
}

// The mix can be undone, so the ids that give the largest and the smallest number are known. At 1
// the Weibull variate would be 0: a particle without strength.
TEST(Random, never_0_or_1)
{
  constexpr uint64_t GOLDEN = UINT64_C(0x9e3779b97f4a7c15);
  const uint64_t start = mix_bits(mix_bits(5 + GOLDEN) ^ GOLDEN);    // of seed 5, stream 0
  for (uint64_t last : {~UINT64_C(0), UINT64_C(0)}) {
    uint64_t z = unshift(last, 31) * inverse(UINT64_C(0x94d049bb133111eb));
    z = unshift(unshift(z, 27) * inverse(UINT64_C(0xbf58476d1ce4e5b9)), 30);
    ASSERT_EQ(mix_bits(z), last);
    const int64_t id = (int64_t) ((z - start) * inverse(GOLDEN));
    const double u = uniform_random(id, 5, 0);
    EXPECT_NEAR(u, last ? 1.0 : 0.0, 1.0e-15);    // it is that id
    EXPECT_GT(u, 0.0);
    EXPECT_LT(u, 1.0);
    EXPECT_GT(weibull_random(1.0, 10.0, id, 5), 0.0);
  }
}

// mean lambda Gamma(1 + 1/k), variance lambda^2 [Gamma(1 + 2/k) - Gamma(1 + 1/k)^2]; 4.5 deviations
// of the sample mean and, with the fourth moment, of the sample variance
TEST(Random, weibull_moments)
{
  for (double modulus : {1.5, 5.0, 10.0, 30.0}) {
    const double scale = 120.0e6;
    const auto raw = [&](int power) { return std::tgamma(1.0 + power / modulus); };
    const double mean = raw(1), variance = raw(2) - mean * mean;
    const double fourth =
        raw(4) - 4.0 * mean * raw(3) + 6.0 * mean * mean * raw(2) - 3.0 * std::pow(mean, 4);
    double sum = 0.0, squares = 0.0;
    for (int id = 1; id <= N; id++) {
      const double x = weibull_random(scale, modulus, id, 4711) / scale;
      sum += x - mean;
      squares += (x - mean) * (x - mean);
    }
    EXPECT_LT(std::fabs(sum / N), 4.5 * std::sqrt(variance / N)) << modulus;
    EXPECT_LT(std::fabs(squares / N - variance),
              4.5 * std::sqrt((fourth - variance * variance) / N))
        << modulus;
  }
}

// the median of a Weibull law is lambda (ln 2)^(1/k); a count is binomial
TEST(Random, weibull_median)
{
  int below = 0;
  for (int id = 1; id <= N; id++)
    below += weibull_random(2.0, 5.0, id, 17) < 2.0 * std::pow(std::log(2.0), 0.2);
  EXPECT_NEAR(below, 0.5 * N, 4.5 * std::sqrt(0.25 * N));
}

}    // namespace
