/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told once, however many runs there are.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_NOTES_H
#define LMP_TMSPH_NOTES_H

#include "comm.h"
#include "error.h"
#include "lammps.h"

#include <set>
#include <string>

namespace LAMMPS_NS {

class TMSPHNotes {
 public:
  explicit TMSPHNotes(class LAMMPS *lammps) : lammps(lammps) {}
  /// a warning that is given once
  void warn_once(const std::string &text)
  {
    if (warnings.insert(text).second && lammps->comm->me == 0)
      lammps->error->warning(FLERR, "{}", text);
  }
  bool warned() const { return !warnings.empty(); }
  /// true if no style has told this text yet
  bool news(const std::string &text) { return told.insert(text).second; }

 private:
  class LAMMPS *const lammps;
  std::set<std::string> warnings, told;
};

}    // namespace LAMMPS_NS

#endif
