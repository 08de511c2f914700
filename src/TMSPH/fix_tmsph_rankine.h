/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/rankine: bonds break by Rankine's criterion.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/rankine,FixTMSPHRankine);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_RANKINE_H
#define LMP_FIX_TMSPH_RANKINE_H

#include "fix_tmsph_break.h"
#include "tmsph_rankine.h"

namespace LAMMPS_NS {

using FixTMSPHRankine = FixTMSPHBreakBy<TMSPH::Rankine>;

}    // namespace LAMMPS_NS

#endif
#endif
