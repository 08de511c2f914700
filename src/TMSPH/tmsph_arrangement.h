/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Are particles arranged in balance, as on lattices and in relaxed clouds, or
   only shaken or thrown.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_ARRANGEMENT_H
#define LMP_TMSPH_ARRANGEMENT_H

#include "fix_tmsph_bond.h"

namespace LAMMPS_NS {

/** How far a body with an even stress is from balance: force on a particle/(stress times section of
    the particle), see tmsph_relaxation.h, but with its own shape matrix at both ends.
    @return median over the particles in the interior of a type, when the bonds formed; 0 if there
            are none (collective) */
double interior_imbalance(class LAMMPS *, const FixTMSPHBond &, int type);

}    // namespace LAMMPS_NS

#endif
