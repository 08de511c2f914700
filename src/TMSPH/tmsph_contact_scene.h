/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What the input of fix tmsph/contact says, and whom its parts ask.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_SCENE_H
#define LMP_TMSPH_CONTACT_SCENE_H

#include "fix_tmsph_bond.h"
#include "pair_tmsph.h"
#include "tmsph_contact_law.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

struct TMSPHContactScene {
  /// Two particles may come closer by this fraction of the horizon between searches: within it the
  /// kernel has a thousandth of its middle value.
  static constexpr double SEARCH_MARGIN = 0.1;

  PairTMSPH *pair = nullptr;
  FixTMSPHBond *bonds = nullptr;
  std::string id;    // of the fix
  int groupbit = 0;
  bool segments = false;      // bodies touch at their outlines, else in pairs
  bool rough_faces = true;    // those of cracks and cuts have friction too
  bool self = true;           // they touch
  TMSPH::ContactLaw law = TMSPH::CONTACT_LAWS[0];
  double stiffness = 1.0;                       // factor to the default
  std::vector<std::vector<double>> friction;    // by type and type

  /// bit 1<<state for each state of a family that contact in pairs sees to
  unsigned states() const
  {
    const unsigned faces = 1u << FixTMSPHBond::BROKEN | 1u << FixTMSPHBond::CUT;
    return (segments ? 0u : 1u << FixTMSPHBond::UNBONDED) | (self ? faces : 0u);
  }
  bool counts(int state) const { return states() >> state & 1u; }
  double search_margin() const { return SEARCH_MARGIN * pair->horizon(); }
};

}    // namespace LAMMPS_NS
#endif
