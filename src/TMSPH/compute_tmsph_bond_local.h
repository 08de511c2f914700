/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   compute tmsph/bond/local: the reference bonds, one row each.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(tmsph/bond/local,ComputeTMSPHBondLocal);
// clang-format on
#else

#ifndef LMP_COMPUTE_TMSPH_BOND_LOCAL_H
#define LMP_COMPUTE_TMSPH_BOND_LOCAL_H

#include "compute.h"

#include <vector>

namespace LAMMPS_NS {

class ComputeTMSPHBondLocal : public Compute {
 public:
  ComputeTMSPHBondLocal(class LAMMPS *, int, char **);
  void init() override;
  void compute_local() override;
  double memory_usage() override;

 private:
  enum Word { ID1, ID2, STATE, LENGTH, STRETCH };
  std::vector<Word> words;
  int wanted;    // state of the bonds to list, or -1 for all
  class PairTMSPH *pair;
  std::vector<double> values;
  std::vector<double *> rows;
};

}    // namespace LAMMPS_NS

#endif
#endif
