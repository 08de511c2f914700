/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/hoekbrown: bonds break by the Hoek-Brown criterion.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/hoekbrown,FixTMSPHHoekBrown);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_HOEKBROWN_H
#define LMP_FIX_TMSPH_HOEKBROWN_H

#include "fix_tmsph_break.h"
#include "tmsph_hoekbrown.h"

namespace LAMMPS_NS {

using FixTMSPHHoekBrown = FixTMSPHBreakBy<TMSPH::HoekBrown>;

}    // namespace LAMMPS_NS

#endif
#endif
