/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Version of the package: that of a release, or of the next one with -dev. It
   is in CITATION.cff and CHANGELOG.md too (unittest/verification/test_version.py).
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_VERSION_H
#define LMP_TMSPH_VERSION_H

namespace TMSPH {

inline constexpr char VERSION[] = "2.0-dev";

}    // namespace TMSPH

#endif
