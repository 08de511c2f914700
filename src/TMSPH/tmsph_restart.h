/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Restart records of the package begin with the number of their format.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_RESTART_H
#define LMP_TMSPH_RESTART_H

#include "error.h"
#include "tmsph_version.h"

#include <string>

namespace LAMMPS_NS {

/** An error if a restart file has another format (collective).
    @param what the style that reads it */
template <class Number>
void check_restart_format(Error *error, const std::string &what, Number found, Number expected)
{
  if (found != expected)
    error->all(FLERR,
               "The restart file was written by another version of {}: continue with that "
               "version, or start anew from a data file. This is TMSPH {}",
               what, TMSPH::VERSION);
}

}    // namespace LAMMPS_NS

#endif
