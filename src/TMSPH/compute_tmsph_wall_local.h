/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   compute tmsph/wall/local: where the walls are, a row for each line or triangle.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(tmsph/wall/local,ComputeTMSPHWallLocal);
// clang-format on
#else

#ifndef LMP_COMPUTE_TMSPH_WALL_LOCAL_H
#define LMP_COMPUTE_TMSPH_WALL_LOCAL_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class ComputeTMSPHWallLocal : public Compute {
 public:
  ComputeTMSPHWallLocal(class LAMMPS *, int, char **);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  std::vector<double> values;
  std::vector<double *> rows;
};

}    // namespace LAMMPS_NS

#endif
#endif
