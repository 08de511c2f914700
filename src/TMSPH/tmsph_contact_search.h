/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Particles that meet although they did not face each other in the reference
   state: bodies that collide, surfaces that slip by more than the horizon.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_SEARCH_H
#define LMP_TMSPH_CONTACT_SEARCH_H

#include "pointers.h"
#include "tmsph_contact_list.h"
#include "tmsph_contact_surfaces.h"
#include "tmsph_ghost_rows.h"

#include <array>
#include <vector>

namespace LAMMPS_NS {

class TMSPHContactSearch : protected Pointers {
 public:
  TMSPHContactSearch(class LAMMPS *lmp, const TMSPHContactScene &scene, TMSPHContactList &list,
                     TMSPHContactMemories &memories, TMSPHContactSurfaces &surfaces,
                     TMSPHGhostSender &ghosts) :
      Pointers(lmp),
      scene(scene), list(list), memories(memories), surfaces(surfaces), ghosts(ghosts)
  {
  }
  /// in this step?
  bool due() const;
  /// in the next evaluation
  void ask() { next_step = 0; }
  /** Who meets and who parts, and when to look again (collective).
      @param states of the pairs in this step
      @return       true if pairs have to be listed again */
  template <int D> bool find(const std::vector<TMSPH::ContactState<D>> &states);

  /// for restarts
  static constexpr int SIZE = 3;
  std::array<double, SIZE> plan() const { return {ubuf(last_step).d, ubuf(next_step).d, step_dt}; }
  void take_plan(const double *p)
  {
    last_step = (bigint) ubuf(p[0]).i;
    next_step = (bigint) ubuf(p[1]).i;
    step_dt = p[2];
  }

 private:
  const TMSPHContactScene &scene;
  TMSPHContactList &list;
  TMSPHContactMemories &memories;
  TMSPHContactSurfaces &surfaces;
  TMSPHGhostSender &ghosts;
  bigint last_step = 0, next_step = 0;    // of searches
  double step_dt = 0.0;                   // time step for which that holds

  template <int D>
  void fill_rows(const std::vector<TMSPH::ContactState<D>> &, TMSPHGhostRows &) const;
  int part();
  bool may_meet(int i, int j) const;
  template <int D> int meet(const TMSPHGhostRows &);
  template <int D> bool face(int low, int high, const TMSPHGhostRows &, TMSPH::ContactPair &) const;
  template <int D> bool meet_pair(int i, int j, const TMSPHGhostRows &);
  void plan_next();
};

}    // namespace LAMMPS_NS
#endif
