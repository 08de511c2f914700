/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The Hoek-Brown criterion, edition 2002 (Hoek, Carranza-Torres, Corkum,
   Proc. NARMS-TAC 2002, 267). Stresses come in tension positive; the criterion
   is written compression positive, S1 >= S3.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HOEKBROWN_H
#define LMP_TMSPH_HOEKBROWN_H

#include "tmsph_criterion.h"

#include <algorithm>

namespace TMSPH {

/** Rock mass constants: failure at S1 - S3 = sigma_c (mb S3/sigma_c + s)^a. */
struct HoekBrown {
  static constexpr const char *TITLE = "Hoek-Brown", *STRENGTH = "UCS";
  static const std::vector<CriterionWord> &words()
  {
    static const std::vector<CriterionWord> all = {
        {"strength", REQUIRED, [](double v) { return v > 0.0; },
         "the uniaxial compressive strength must be positive"},
        {"mi", REQUIRED, [](double v) { return v > 0.0; }, "it must be positive; 4 to 33 is usual"},
        {"gsi", 100.0, [](double v) { return v > 0.0 && v <= 100.0; },
         "it must be above 0 and at most 100 (intact rock)"},
        {"disturbance", 0.0, [](double v) { return v >= 0.0 && v <= 1.0; },
         "it must lie in 0 to 1"}};
    return all;
  }

  double mb = 0.0, s = 1.0, a = 0.5;

  HoekBrown() = default;
  explicit HoekBrown(const std::vector<double> &v)
  {
    const double mi = v[1], gsi = v[2], disturbance = v[3];
    mb = mi * std::exp((gsi - 100.0) / (28.0 - 14.0 * disturbance));
    s = std::exp((gsi - 100.0) / (9.0 - 3.0 * disturbance));
    a = 0.5 + (std::exp(-gsi / 15.0) - std::exp(-20.0 / 3.0)) / 6.0;
    if (std::fabs(a - 0.5) < 1.0e-14) a = 0.5;    // gsi = 100, but for rounding
  }
  bool operator==(const HoekBrown &o) const { return mb == o.mb && s == o.s && a == o.a; }

  bool fails(const Principals &p, double strength) const
  {
    const double difference = p.largest - p.smallest;        // S1 - S3
    const double bracket = s - mb * p.largest / strength;    // S3 = -largest
    if (bracket <= 0.0) return true;
    if (a == 0.5) return difference * difference >= strength * strength * bracket;
    return difference >= strength * std::pow(bracket, a);
  }

  bool may_fail(const Invariants &m, double reach, double strength) const
  {
    const double largest = m.mean + reach * std::sqrt(m.deviation2);
    const double bracket = s - mb * largest / strength;
    // x^(2a) >= min(x, x^2) for 1/2 <= a <= 1
    const double power = a == 0.5 || bracket > 1.0 ? bracket : bracket * std::fabs(bracket);
    return !(4.0 * m.deviation2 < strength * strength * power * BELOW_ROUNDING);    // 0 inf: true
  }

  /// For a = 1/2 the closed form, otherwise by bisection.
  double load_factor(const Principals &p, double strength) const
  {
    const double first = square_root_form(p, strength);
    if (a == 0.5) return first;
    const auto fails_divided_by = [&](double o) {
      return fails({p.largest / o, p.middle / o, p.smallest / o}, strength);
    };
    double high = std::max(first, 1.0e-30), low = high;    // doubling needs more than 0
    while (fails_divided_by(high)) high *= 2.0;
    while (!fails_divided_by(low) && low > 1.0e-300) low *= 0.5;
    for (int k = 0; k < 60; k++) {    // doubles have 53 bits
      const double middle = 0.5 * (low + high);
      (fails_divided_by(middle) ? low : high) = middle;
    }
    return high;
  }

 private:
  double square_root_form(const Principals &p, double strength) const
  {
    const double difference = p.largest - p.smallest, m3 = -mb * p.largest;
    const double root = std::sqrt(m3 * m3 + 4.0 * s * difference * difference);
    // under pressure -m3 + root would cancel
    return m3 > 0.0 ? 2.0 * difference * difference / (strength * (m3 + root))
                    : (root - m3) / (2.0 * s * strength);
  }
};

/// Constants of a bond between two rocks: the means.
inline HoekBrown mean(HoekBrown rock, const HoekBrown &other)
{
  rock.mb = 0.5 * (rock.mb + other.mb);
  rock.s = 0.5 * (rock.s + other.s);
  rock.a = 0.5 * (rock.a + other.a);
  return rock;
}

}    // namespace TMSPH
#endif
