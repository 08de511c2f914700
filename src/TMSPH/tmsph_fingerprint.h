/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Tells whether a particle was touched between two runs.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_FINGERPRINT_H
#define LMP_TMSPH_FINGERPRINT_H

#include <cstdint>
#include <cstring>

namespace TMSPH {

/** 64 bits that depend on every bit of a position and a velocity, 3 components each. Mixing of the
    SplitMix64 generator: Steele, Lea, Flood, OOPSLA 2014. */
inline std::uint64_t fingerprint(const double *x, const double *v)
{
  std::uint64_t h = 0;
  for (int k = 0; k < 6; k++) {
    std::uint64_t bits;
    std::memcpy(&bits, k < 3 ? x + k : v + k - 3, sizeof(bits));
    h = (h ^ bits) + 0x9e3779b97f4a7c15ull;
    h = (h ^ (h >> 30)) * 0xbf58476d1ce4e5b9ull;
    h = (h ^ (h >> 27)) * 0x94d049bb133111ebull;
    h ^= h >> 31;
  }
  return h;
}

}    // namespace TMSPH
#endif
