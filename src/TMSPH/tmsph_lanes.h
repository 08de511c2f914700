/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Eight doubles side by side. The inner loops treat eight particles at a
   time; one vector holds one quantity of the eight. GCC and Clang lower the
   vector type to whatever the processor has (AVX-512, AVX, SSE2, NEON). Functions
   of such are inlined or local to a file: what GCC warns of, another ABI with
   other processors, is not used (-Wno-psabi).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_LANES_H
#define LMP_TMSPH_LANES_H

#include <cmath>
#include <cstring>

namespace TMSPH {

static constexpr int LANES = 8;    // numbers side by side: a register of AVX-512, a line of caches

typedef double Lanes __attribute__((vector_size(64)));
typedef float FloatLanes __attribute__((vector_size(32)));
typedef double Half __attribute__((vector_size(32)));

#define TMSPH_INLINE [[gnu::always_inline]] inline

TMSPH_INLINE Lanes broadcast(double a)
{
  return Lanes{a, a, a, a, a, a, a, a};
}

/// Loads and stores through memcpy: no alignment is assumed.
TMSPH_INLINE Lanes load(const double *p)
{
  Lanes a;
  std::memcpy(&a, p, sizeof(a));
  return a;
}

TMSPH_INLINE Lanes load(const float *p)
{
  FloatLanes a;
  std::memcpy(&a, p, sizeof(a));
  return __builtin_convertvector(a, Lanes);
}

TMSPH_INLINE void store(double *p, Lanes a)
{
  std::memcpy(p, &a, sizeof(a));
}

TMSPH_INLINE Lanes square_root(Lanes a)
{
  Lanes r = a;
  for (int l = 0; l < LANES; l++) r[l] = std::sqrt(a[l]);
  return r;
}

TMSPH_INLINE double square_root(double a)
{
  return std::sqrt(a);
}

TMSPH_INLINE Lanes log_of_one_plus(Lanes a)
{
  Lanes r = a;
  for (int l = 0; l < LANES; l++) r[l] = std::log1p(a[l]);
  return r;
}

TMSPH_INLINE double log_of_one_plus(double a)
{
  return std::log1p(a);
}

TMSPH_INLINE Lanes minimum(Lanes a, Lanes b)
{
  return a < b ? a : b;
}

TMSPH_INLINE Half load_half(const double *p)
{
  Half a;
  std::memcpy(&a, p, sizeof(a));
  return a;
}

/** Four consecutive doubles of eight rows, transposed: out[k][l] = base[stride*row[l] + k].
    Whole rows are read and shuffled in registers; hardware gathers are slower. */
TMSPH_INLINE void load_rows4(const double *base, int stride, const int *row, Lanes *out)
{
  const auto pair = [&](int a, int b) {
    return __builtin_shufflevector(load_half(base + (size_t) stride * row[a]),
                                   load_half(base + (size_t) stride * row[b]), 0, 1, 2, 3, 4, 5, 6,
                                   7);
  };
  const Lanes r04 = pair(0, 4), r15 = pair(1, 5), r26 = pair(2, 6), r37 = pair(3, 7);
  const Lanes a = __builtin_shufflevector(r04, r15, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes b = __builtin_shufflevector(r04, r15, 1, 9, 3, 11, 5, 13, 7, 15);
  const Lanes c = __builtin_shufflevector(r26, r37, 0, 8, 2, 10, 4, 12, 6, 14);
  const Lanes d = __builtin_shufflevector(r26, r37, 1, 9, 3, 11, 5, 13, 7, 15);
  out[0] = __builtin_shufflevector(a, c, 0, 1, 8, 9, 4, 5, 12, 13);
  out[1] = __builtin_shufflevector(b, d, 0, 1, 8, 9, 4, 5, 12, 13);
  out[2] = __builtin_shufflevector(a, c, 2, 3, 10, 11, 6, 7, 14, 15);
  out[3] = __builtin_shufflevector(b, d, 2, 3, 10, 11, 6, 7, 14, 15);
}

/// N (a multiple of 4) consecutive doubles of eight rows, transposed.
template <int N>
TMSPH_INLINE void load_rows(const double *base, int stride, const int *row, Lanes *out)
{
  static_assert(N % 4 == 0, "rows are read four doubles at a time");
  for (int k = 0; k < N; k += 4) load_rows4(base + k, stride, row, out + k);
}

}    // namespace TMSPH
#endif
