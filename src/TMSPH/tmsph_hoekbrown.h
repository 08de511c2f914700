/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The Hoek-Brown criterion, edition 2002 (Hoek, Carranza-Torres, Corkum,
   Proc. NARMS-TAC 2002, 267). Stresses come in tension positive; the criterion
   is written compression positive, S1 >= S3.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HOEKBROWN_H
#define LMP_TMSPH_HOEKBROWN_H

#include "tmsph_principal.h"

#include <algorithm>
#include <cmath>

namespace TMSPH {

/** Rock mass constants: failure at S1 - S3 = sigma_c (mb S3/sigma_c + s)^a. */
struct HoekBrown {
  double mb = 0.0, s = 1.0, a = 0.5;
  bool operator==(const HoekBrown &o) const { return mb == o.mb && s == o.s && a == o.a; }
};

/** @param mi          constant of the intact rock, > 0
    @param gsi         geological strength index, 0 < gsi <= 100
    @param disturbance D, 0 to 1 */
inline HoekBrown hoek_brown(double mi, double gsi, double disturbance)
{
  HoekBrown r;
  r.mb = mi * std::exp((gsi - 100.0) / (28.0 - 14.0 * disturbance));
  r.s = std::exp((gsi - 100.0) / (9.0 - 3.0 * disturbance));
  r.a = 0.5 + (std::exp(-gsi / 15.0) - std::exp(-20.0 / 3.0)) / 6.0;
  if (std::fabs(r.a - 0.5) < 1.0e-14) r.a = 0.5;    // gsi = 100, but for round-off
  return r;
}

/// Constants of a bond between two rocks: the means.
inline HoekBrown mean(const HoekBrown &p, const HoekBrown &q)
{
  return {0.5 * (p.mb + q.mb), 0.5 * (p.s + q.s), 0.5 * (p.a + q.a)};
}

/** True if the stress state is at or beyond failure.
    @param stress   principal extremes, tension positive
    @param strength sigma_c of the intact rock, > 0, in the unit of the stress */
inline bool fails(const Extremes &stress, double strength, const HoekBrown &rock)
{
  const double difference = stress.largest - stress.smallest;              // S1 - S3
  const double bracket = rock.s - rock.mb * stress.largest / strength;     // S3 = -largest
  if (bracket <= 0.0) return true;
  if (rock.a == 0.5) return difference * difference >= strength * strength * bracket;
  return difference >= strength * std::pow(bracket, rock.a);
}

/** A cheap, safe bound: false only if fails() is false.
    @param mean       mean stress, of the plane or of all three directions
    @param deviation2 (S1 - S3)^2/4 in the plane, J2 in 3-D, where (S1 - S3)^2 <= 4 J2
    @param reach      the largest principal stress is at most mean + reach sqrt(deviation2):
                      1 in the plane, 2/sqrt(3) in 3-D */
inline bool may_fail(double mean, double deviation2, double reach, double strength,
                     const HoekBrown &rock)
{
  constexpr double ROUNDING = 1.0 - 1.0e-12;
  const double largest = mean + reach * std::sqrt(deviation2);
  const double bracket = rock.s - rock.mb * largest / strength;
  // x^(2a) >= min(x, x^2) for 1/2 <= a <= 1
  const double power = rock.a == 0.5 || bracket > 1.0 ? bracket : bracket * std::fabs(bracket);
  return !(4.0 * deviation2 < strength * strength * power * ROUNDING);    // true where it is 0 inf
}

/** Load factor o: the stress divided by o is just at failure, so that o >= 1 means failure.
    For a = 1/2 the closed form, otherwise by bisection (the safe states form a convex set around
    the stress-free one, so that o is unique). */
inline double load_factor(const Extremes &stress, double strength, const HoekBrown &rock)
{
  const double difference = stress.largest - stress.smallest, s3 = -stress.largest;
  const auto square_root_form = [&]() {
    const double m3 = rock.mb * s3;
    const double root = std::sqrt(m3 * m3 + 4.0 * rock.s * difference * difference);
    // under pressure -m3 + root would cancel
    return m3 > 0.0 ? 2.0 * difference * difference / (strength * (m3 + root))
                    : (root - m3) / (2.0 * rock.s * strength);
  };
  if (rock.a == 0.5) return square_root_form();
  const auto fails_divided_by = [&](double o) {
    return fails({stress.largest / o, stress.smallest / o}, strength, rock);
  };
  double high = std::max(square_root_form(), 1.0e-30), low = high;
  while (fails_divided_by(high)) high *= 2.0;
  while (!fails_divided_by(low) && low > 1.0e-300) low *= 0.5;
  for (int k = 0; k < 60; k++) {
    const double middle = 0.5 * (low + high);
    (fails_divided_by(middle) ? low : high) = middle;
  }
  return high;
}

}    // namespace TMSPH
#endif
