/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Does a wall stand where it makes sense when it starts: a warning at most, with the remedy.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_CHECK_H
#define LMP_TMSPH_WALL_CHECK_H

#include "pointers.h"
#include "tmsph_wall_candidates.h"
#include "tmsph_wall_places.h"
#include "tmsph_wall_scene.h"

namespace LAMMPS_NS {

class TMSPHWallCheck : protected Pointers {
 public:
  TMSPHWallCheck(class LAMMPS *lmp, const TMSPHWallScene &scene,
                 const TMSPHWallCandidates &candidates) :
      Pointers(lmp),
      scene(scene), candidates(candidates)
  {
  }
  /// the first of: it stands in the body, behind it, or overlaps its surface (collective)
  void warn(const TMSPHWallPlaces &) const;

 private:
  const TMSPHWallScene &scene;
  const TMSPHWallCandidates &candidates;

  double depth_in_body(bigint &bonds_cut) const;
  bool cuts(TMSPH::Point from, TMSPH::Point to) const;
  bool all_behind() const;
};

}    // namespace LAMMPS_NS
#endif
