/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Types before the values of a word. A value without its types is a usual mistake,
   for which LAMMPS's own errors name no word.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_TYPES_H
#define LMP_TMSPH_TYPES_H

#include "atom.h"
#include "error.h"
#include "utils.h"

#include <string>

namespace TMSPH {

/// lo and hi of a type or a range of types such as 2, 1*3 or *
/// @param what  style and word, for the error
/// @param usage how the word is to be used
inline void read_types(LAMMPS_NS::LAMMPS *lmp, const std::string &what, const std::string &usage,
                       const char *text, int &lo, int &hi)
{
  const int ntypes = lmp->atom->ntypes;
  LAMMPS_NS::utils::bounds(FLERR, text, 1, ntypes, lo, hi, nullptr);
  if (lo < 1 || hi > ntypes || lo > hi)
    lmp->error->all(FLERR, "{} needs types before the value, and '{}' is no type of 1 to {}: use "
                           "'{}'",
                    what, text, ntypes, usage);
}

}    // namespace TMSPH
#endif
