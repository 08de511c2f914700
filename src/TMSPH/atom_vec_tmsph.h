/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   atom_style tmsph: particles with a reference position, a reference volume,
   a mass, a temperature and a damage.
------------------------------------------------------------------------- */

#ifdef ATOM_CLASS
// clang-format off
AtomStyle(tmsph,AtomVecTMSPH);
// clang-format on
#else

#ifndef LMP_ATOM_VEC_TMSPH_H
#define LMP_ATOM_VEC_TMSPH_H

#include "atom_vec.h"

namespace LAMMPS_NS {

class AtomVecTMSPH : public AtomVec {
 public:
  AtomVecTMSPH(class LAMMPS *);
  void grow_pointers() override;
  void create_atom_post(int) override;
  void data_atom_post(int) override;
  void pack_data_pre(int) override;

 private:
  double *rmass, *vfrac, *temperature, *damage, **x0;
};

}    // namespace LAMMPS_NS

#endif
#endif
