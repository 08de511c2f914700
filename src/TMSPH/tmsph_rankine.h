/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Rankine's criterion: failure where the largest principal stress reaches the tensile strength
   (Rankine, Manual of Applied Mechanics, 1858).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RANKINE_H
#define LMP_TMSPH_RANKINE_H

#include "tmsph_criterion.h"

#include <algorithm>

namespace TMSPH {

struct Rankine {
  static constexpr const char *TITLE = "Rankine", *STRENGTH = "strength";
  static const std::vector<CriterionWord> &words()
  {
    static const std::vector<CriterionWord> all = {
        {"tensile", REQUIRED, [](double v) { return v > 0.0; }, "it must be positive"}};
    return all;
  }
  explicit Rankine(const std::vector<double> &) {}
  bool operator==(const Rankine &) const { return true; }

  bool fails(const Principals &p, double strength) const { return p.largest >= strength; }
  double load_factor(const Principals &p, double strength) const
  {
    return std::max(p.largest, 0.0) / strength;
  }
  bool may_fail(const Invariants &m, double reach, double strength) const
  {
    return !(m.mean + reach * std::sqrt(m.deviation2) < strength * BELOW_ROUNDING);
  }
};

inline Rankine mean(const Rankine &rock, const Rankine &)
{
  return rock;
}

}    // namespace TMSPH
#endif
