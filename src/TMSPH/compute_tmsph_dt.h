/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   compute tmsph/dt: the largest stable time step of the present state.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(tmsph/dt,ComputeTMSPHDt);
// clang-format on
#else

#ifndef LMP_COMPUTE_TMSPH_DT_H
#define LMP_COMPUTE_TMSPH_DT_H

#include "compute.h"

namespace LAMMPS_NS {

class ComputeTMSPHDt : public Compute {
 public:
  ComputeTMSPHDt(class LAMMPS *, int, char **);
  void init() override;
  double compute_scalar() override;

 private:
  class PairTMSPH *pair;
};

}    // namespace LAMMPS_NS

#endif
#endif
