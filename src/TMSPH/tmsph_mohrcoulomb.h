/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The Mohr-Coulomb criterion with a tension cut-off (Jaeger, Cook, Zimmerman, Fundamentals of Rock
   Mechanics, 4th ed., 2007, Sect. 4.5): compression positive, S1 >= S3, failure at
     S1 - N S3 = 2 c sqrt(N),  N = (1 + sin phi)/(1 - sin phi),  or at  -S3 = tensile strength.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_MOHRCOULOMB_H
#define LMP_TMSPH_MOHRCOULOMB_H

#include "tmsph_criterion.h"
#include "tmsph_pi.h"

#include <algorithm>

namespace TMSPH {

struct MohrCoulomb {
  static constexpr const char *TITLE = "Mohr-Coulomb", *STRENGTH = "cohesion";
  static const std::vector<CriterionWord> &words()
  {
    static const std::vector<CriterionWord> all = {
        {"cohesion", REQUIRED, [](double v) { return v > 0.0; }, "it must be positive"},
        {"friction", REQUIRED, [](double v) { return v >= 0.0 && v < 90.0; },
         "the angle must lie between 0 and 90 degrees; 30 to 55 is usual"},
        {"tensile", REQUIRED, [](double v) { return v > 0.0; }, "it must be positive"}};
    return all;
  }
  explicit MohrCoulomb(const std::vector<double> &v)
  {
    const double sine = std::sin(v[1] * PI / 180.0);
    flow = (1.0 + sine) / (1.0 - sine);
    tensile = v[2] / v[0];
  }
  bool operator==(const MohrCoulomb &o) const { return flow == o.flow && tensile == o.tensile; }

  bool fails(const Principals &p, double cohesion) const { return load_factor(p, cohesion) >= 1.0; }
  double load_factor(const Principals &p, double cohesion) const
  {
    return load_factor_of(p.largest, p.largest - p.smallest, cohesion);
  }
  bool may_fail(const Invariants &m, double reach, double cohesion) const
  {
    const double radius = std::sqrt(m.deviation2);
    return !(load_factor_of(m.mean + reach * radius, 2.0 * radius, cohesion) < BELOW_ROUNDING);
  }

  double flow;       ///< N
  double tensile;    ///< strength in tension/cohesion

 private:
  /// of the largest principal stress, tension positive, and S1 - S3; it grows with both
  double load_factor_of(double largest, double difference, double cohesion) const
  {
    const double shear = (difference + (flow - 1.0) * largest) / (2.0 * std::sqrt(flow));
    return std::max({shear, largest / tensile, 0.0}) / cohesion;
  }
};

inline MohrCoulomb mean(MohrCoulomb rock, const MohrCoulomb &other)
{
  rock.flow = 0.5 * (rock.flow + other.flow);
  rock.tensile = 0.5 * (rock.tensile + other.tensile);
  return rock;
}

}    // namespace TMSPH
#endif
