/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which particles, or images of them, may touch a wall.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_CANDIDATES_H
#define LMP_TMSPH_WALL_CANDIDATES_H

#include "pointers.h"
#include "tmsph_wall_scene.h"

#include <cmath>
#include <utility>
#include <vector>

namespace LAMMPS_NS {

class TMSPHWallCandidates : protected Pointers {
 public:
  /** A particle that may touch before all have moved "skin" in sum, at an image of it. */
  struct Candidate {
    int i;
    TMSPH::Point shift;    // to the image
  };
  TMSPHWallCandidates(class LAMMPS *lmp, const TMSPHWallScene &scene) : Pointers(lmp), scene(scene)
  {
  }
  std::vector<Candidate> images;    // images of a particle one after the other

  void init();
  /// lists them (collective)
  void list();
  /// after a step: must they be listed again?
  bool outdated();
  /// @param fastest largest speed and spin of the wall over this time
  void move(double duration, std::pair<double, double> fastest);
  /// false if no particle is near enough to touch, on any processor
  bool may_touch() const;
  /// of the fastest particle near the wall, if that went along
  double speed() const;
  /// of the image of a local particle nearest to the middle of the wall; in its plane in 2-D
  TMSPH::Point position_of(int i) const;
  /// takes point p to its periodic image that is nearest to x
  void to_image_near(const TMSPH::Point &x, TMSPH::Point &p) const;
  double bytes() const { return images.capacity() * sizeof(Candidate); }

 private:
  const TMSPHWallScene &scene;
  bool repeats[3] = {};     // the wall is there once in each period
  TMSPH::Point middle{};    // of the wall
  bool warned = false;      // of a wall longer than that
  double skin = 0.0, travel = 0.0;
  double farthest = 0.0;                                    // from the pivot, when they were listed
  TMSPHBondWatch watch;                                     // of the bonds when they were listed
  double way = 0.0, clearance = -HUGE_VAL, radius = 0.0;    // see measure_clearance()

  void find_periods();
  void list_images(int i, double within, double &nearest);
  void measure_clearance(double nearest);
};

}    // namespace LAMMPS_NS
#endif
