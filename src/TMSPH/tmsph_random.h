/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Random numbers that belong to a particle: a function of id, seed and stream,
   so that they do not depend on how particles are spread over processors.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RANDOM_H
#define LMP_TMSPH_RANDOM_H

#include <cmath>
#include <cstdint>

namespace TMSPH {

/// Finalizer of splitmix64 (Steele, Lea, Flood, OOPSLA 2014): a bijective mix of 64 bits.
inline uint64_t mix_bits(uint64_t z)
{
  z = (z ^ (z >> 30)) * UINT64_C(0xbf58476d1ce4e5b9);
  z = (z ^ (z >> 27)) * UINT64_C(0x94d049bb133111eb);
  return z ^ (z >> 31);
}

/// Uniform in (0, 1), never 0 or 1.
inline double uniform_random(int64_t id, int64_t seed, int64_t stream)
{
  constexpr uint64_t GOLDEN = UINT64_C(0x9e3779b97f4a7c15);
  uint64_t z = mix_bits((uint64_t) seed + GOLDEN);
  z = mix_bits(z ^ ((uint64_t) stream + GOLDEN));
  z = mix_bits(z + GOLDEN * (uint64_t) id);
  return ((double) (z >> 12) + 0.5) * 0x1.0p-52;    // 52 bits: the sum is exact, so below 1
}

/** Weibull variate with scale lambda_0: lambda_0 (-ln U)^(1/omega).
    Mu et al. (2022) eq. 49 calls lambda_0 the mean; it is the scale. */
inline double weibull_random(double scale, double modulus, int64_t id, int64_t seed)
{
  return scale * std::pow(-std::log(uniform_random(id, seed, 0)), 1.0 / modulus);
}

}    // namespace TMSPH
#endif
