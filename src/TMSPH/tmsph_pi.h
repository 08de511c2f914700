/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   pi for the layers that know nothing of LAMMPS; C++17 has none.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_PI_H
#define LMP_TMSPH_PI_H

namespace TMSPH {

constexpr double PI = 3.14159265358979323846;

}    // namespace TMSPH
#endif
