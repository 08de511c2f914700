/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a wall is, where it is now, and whom its parts ask.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_SCENE_H
#define LMP_TMSPH_WALL_SCENE_H

#include "fix_tmsph_bond.h"
#include "pair_tmsph.h"
#include "tmsph_contact_law.h"
#include "tmsph_rigid_motion.h"
#include "tmsph_wall_shape.h"

#include <memory>
#include <string>

namespace LAMMPS_NS {

struct TMSPHWallScene {
  /// how far from the surface, in front and behind, a centre is held, in half cells: it touches at
  /// one, and in a step of half a spacing over the wave speed what flies at that speed comes by one
  /// more; 4 does the same in unittest/verification/test_wall.py
  static constexpr double REACH = 2.0;

  PairTMSPH *pair = nullptr;
  std::string id;    // of the fix
  int groupbit = 0;
  std::unique_ptr<TMSPH::WallShape> shape;    // at the start
  TMSPH::RigidMotion motion;
  bool turns = false;
  bool both_sides = false;
  TMSPH::ContactLaw law = TMSPH::CONTACT_LAWS[0];
  double friction = 0.0;
  double stiffness = 1.0;    // factor to the default

  /// half a cell of local particle i
  double gap(int i) const
  {
    return 0.5 * pair->bonds()->spacing(i) * (1.0 + pair->thermal_strain(i));
  }
};

}    // namespace LAMMPS_NS
#endif
