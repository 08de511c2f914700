/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Command tmsph/cut: pre-existing flaws; the bonds that cross one are gone.
------------------------------------------------------------------------- */

#ifdef COMMAND_CLASS
// clang-format off
CommandStyle(tmsph/cut,TMSPHCut);
// clang-format on
#else

#ifndef LMP_TMSPH_CUT_H
#define LMP_TMSPH_CUT_H

#include "command.h"
#include "tmsph_bounds.h"

#include <functional>
#include <vector>

namespace LAMMPS_NS {

class TMSPHCut : public Command {
 public:
  TMSPHCut(class LAMMPS *lmp) : Command(lmp) {}
  void command(int, char **) override;

 private:
  struct Flaw {
    /// does the bond between two reference points cross it?
    std::function<bool(const double *, const double *)> crosses;
    TMSPH::Bounds bounds;
  };
  Flaw read_flaw(char **next, char **last);
  void read_line(class TMSPHValues &, Flaw &);
  void read_arc(TMSPHValues &, Flaw &);
  void read_disc(TMSPHValues &, Flaw &);
  void read_polygon(TMSPHValues &, Flaw &);
  bool cuts(const Flaw &, const class FixTMSPHBond &, const double *a, const double *X) const;
  void prepare_bonds();
};

}    // namespace LAMMPS_NS

#endif
#endif
