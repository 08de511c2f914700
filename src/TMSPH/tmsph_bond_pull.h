/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What the bonds of a particle that it lacks would conduct, and the surface that
   shows by it.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOND_PULL_H
#define LMP_TMSPH_BOND_PULL_H

#include "tmsph_own_surface.h"

namespace TMSPH {

struct BondPull {
  Surface surface;
  double area = 0.0;             ///< 0: the particle is inside
  double conducted[3] = {};      ///< area times normal, by the conductances in force
  double one_sidedness = 0.0;    ///< of its bonds, see OwnSurface
  bool outermost = false;        ///< in the outermost row of a surface
};

}    // namespace TMSPH
#endif
