/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/heat/boundary: prescribed temperature of a group.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/heat/boundary,FixTMSPHHeatBoundary);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_HEAT_BOUNDARY_H
#define LMP_FIX_TMSPH_HEAT_BOUNDARY_H

#include "fix.h"
#include "tmsph_heat_clock.h"

#include <string>

namespace LAMMPS_NS {

class FixTMSPHHeatBoundary : public Fix, public TMSPHHeatClock {
 public:
  FixTMSPHHeatBoundary(class LAMMPS *, int, char **);
  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  void min_pre_force(int) override;
  double compute_scalar() override;
  int reach(int, double) override;

 private:
  double value;            // temperature in force
  std::string variable;    // name of the equal-style variable that gives it, or empty
  int variable_index;
};

}    // namespace LAMMPS_NS

#endif
#endif
