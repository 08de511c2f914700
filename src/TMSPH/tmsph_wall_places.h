/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Where particles touch a wall, and the forces that hold them there.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_WALL_PLACES_H
#define LMP_TMSPH_WALL_PLACES_H

#include "pointers.h"
#include "tmsph_contact_totals.h"
#include "tmsph_memories.h"
#include "tmsph_wall_candidates.h"
#include "tmsph_wall_drive.h"
#include "tmsph_wall_scene.h"

#include <cstdint>
#include <vector>

namespace LAMMPS_NS {

/** What a touching particle remembers of its last step. */
struct TMSPHWallMemory {
  /** Where friction is zero, in the coordinates of the wall at the start. */
  struct Anchor {
    int piece;
    TMSPH::Point point;
  };
  double force[3] = {};
  std::uint64_t stamp = 0;    // fingerprint at the end of the run
  int side = 0;               // on which it touched first
  int count = 0;              // of anchors
  Anchor anchors[2] = {};

  /// doubles that pack() writes, and at most
  int size() const { return 6 + 4 * count; }
  static constexpr int MOST = 14;
  int pack(double *) const;
  int unpack(const double *);
};

class TMSPHWallPlaces : protected Pointers {
 public:
  using Memories = TMSPHMemories<TMSPHWallMemory>;

  TMSPHWallPlaces(class LAMMPS *lmp, const TMSPHWallScene &scene, const TMSPHWallDrive &drive,
                  const TMSPHWallCandidates &candidates, Memories &memories,
                  TMSPHContactTotals &totals) :
      Pointers(lmp),
      scene(scene), drive(drive), candidates(candidates), memories(memories), totals(totals)
  {
  }
  void init();
  /// where the candidates touch, and how deep they would be at the end of the step without contact
  /// @param dt 0: as they are
  void find(double dt);
  /// stiffnesses of all places that press
  std::vector<double> stiffnesses() const;
  /** The forces on particles.
      @param dragged dt^2/mass of the wall times the stiffness of all that touch it */
  void hold(double dt, double dragged);
  /// after they were held
  std::vector<TMSPH::Point> forces() const;
  /// most by which a particle overlaps the wall by more than a fraction of half its cell; else 0
  double overlap(double tolerance) const;
  double bytes() const { return touching.capacity() * sizeof(Touching); }

 private:
  using Point = TMSPH::Point;
  using Anchor = TMSPHWallMemory::Anchor;
  /** A particle that may feel the wall in this step. */
  struct Touching {
    int i, places, side;
    Point x;    // at its image
    TMSPH::WallTouch place[2];
    double predicted[2], penetration[2];
    double stiffness;
    Point a;    // acceleration by all other forces, against the wall by its load
  };

  const TMSPHWallScene &scene;
  const TMSPHWallDrive &drive;
  const TMSPHWallCandidates &candidates;
  Memories &memories;
  TMSPHContactTotals &totals;
  std::vector<Touching> touching;
  std::vector<class Fix *> prescribing;    // that act after it

  bool touch(const TMSPHWallCandidates::Candidate &, Touching &) const;
  void predict(Touching &, double dt) const;
  double stiffness(int i, double penetration, double dt) const;
  void hold_one(const Touching &, double dt, double dragged);
  Point moved_along(const Touching &, const Point &anchor) const;
  Point rub(const Touching &, int p, double ahead, double q, double normal, const Point &pushed,
            Anchor &);
};

}    // namespace LAMMPS_NS
#endif
