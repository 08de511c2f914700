/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   compute tmsph/property/atom: fields of the particles, one column a word.
------------------------------------------------------------------------- */

#ifdef COMPUTE_CLASS
// clang-format off
ComputeStyle(tmsph/property/atom,ComputeTMSPHPropertyAtom);
// clang-format on
#else

#ifndef LMP_COMPUTE_TMSPH_PROPERTY_ATOM_H
#define LMP_COMPUTE_TMSPH_PROPERTY_ATOM_H

#include "compute.h"

#include <functional>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class ComputeTMSPHPropertyAtom : public Compute {
 public:
  ComputeTMSPHPropertyAtom(class LAMMPS *, int, char **);
  ~ComputeTMSPHPropertyAtom() override;
  void init() override;
  void compute_peratom() override;
  double memory_usage() override;

 private:
  using Column = std::function<double(int)>;
  std::vector<Column> columns;
  bool needs_stress;         // one of the words is a stress or a deformation gradient
  std::string needs_rock;    // one that is a strength or a load factor, or empty
  int nmax;
  double *vector, **array;
  class PairTMSPH *pair;
  class FixTMSPHBreak *breaking;

  std::vector<struct TMSPHWord> fields();
  void find_rock();

  // stress and deformation gradient of this call, and the principal stresses
  std::vector<double> full_stress, principal;
  const double *gradient;
  void evaluate_fields();
};

}    // namespace LAMMPS_NS

#endif
#endif
