/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   compute tmsph/crack: broken and cut bonds, crack area, mean opening.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(tmsph/crack,ComputeTMSPHCrack);
// clang-format on
#else

#ifndef LMP_COMPUTE_TMSPH_CRACK_H
#define LMP_COMPUTE_TMSPH_CRACK_H

#include "compute.h"

namespace LAMMPS_NS {

class ComputeTMSPHCrack : public Compute {
 public:
  ComputeTMSPHCrack(class LAMMPS *, int, char **);
  ~ComputeTMSPHCrack() override;
  void init() override;
  void compute_vector() override;

 private:
  class PairTMSPH *pair;
};

}    // namespace LAMMPS_NS

#endif
#endif
