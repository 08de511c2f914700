/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/mohrcoulomb: bonds break by the Mohr-Coulomb criterion with a tension cut-off.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/mohrcoulomb,FixTMSPHMohrCoulomb);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_MOHRCOULOMB_H
#define LMP_FIX_TMSPH_MOHRCOULOMB_H

#include "fix_tmsph_break.h"
#include "tmsph_mohrcoulomb.h"

namespace LAMMPS_NS {

using FixTMSPHMohrCoulomb = FixTMSPHBreakBy<TMSPH::MohrCoulomb>;

}    // namespace LAMMPS_NS

#endif
#endif
