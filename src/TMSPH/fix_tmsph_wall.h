/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/wall: a rigid wall with friction, at rest, moving or under a load.
   It calls its parts in the order of a step.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/wall,FixTMSPHWall);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_WALL_H
#define LMP_FIX_TMSPH_WALL_H

#include "fix.h"
#include "tmsph_contact_totals.h"
#include "tmsph_presses.h"
#include "tmsph_wall_candidates.h"
#include "tmsph_wall_drive.h"
#include "tmsph_wall_picture.h"
#include "tmsph_wall_places.h"
#include "tmsph_wall_scene.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixTMSPHWall : public Fix, public TMSPHPresses, public TMSPHStoresIds {
 public:
  FixTMSPHWall(class LAMMPS *, int, char **);
  ~FixTMSPHWall() override;
  int setmask() override;
  void init() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  void follow_ids(const TMSPHPresentIds &) override;
  void add_loads(std::vector<Load> &) override;
  bool may_press() const override { return candidates.may_touch(); }
  int image(int *&, double **&) override;

  /// where the wall is now
  TMSPHWallPieces pieces() const;

  /// moves a wall over a time to the present step, with its prescribed velocities
  void move(double duration);
  /// of the fastest particle near it, if that went along
  double speed() const { return candidates.speed(); }
  bool loaded() const { return drive.loaded(); }

  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

 private:
  using Totals = TMSPHContactTotals;
  /// outputs: the totals but the sum of the normal forces, then where the wall is
  enum { NTOTALS = Totals::NORMAL, DISPLACEMENT = NTOTALS, ANGLE = NTOTALS + 3, NOUTPUT };

  TMSPHWallScene scene;
  Totals totals;
  TMSPHWallPlaces::Memories memories;
  TMSPHWallDrive drive;
  TMSPHWallCandidates candidates;
  TMSPHWallPlaces places;
  TMSPHWallPicture picture;
  bool started;    // this or an earlier run has been set up

  void parse(char **next, char **last);
  void list_candidates();
  void act(double dt);
  void start();
  double half_row(int i, const TMSPH::Point &normal) const;
  TMSPHPresses::Load load_of(int i, const TMSPHWallMemory &) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
