/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Contact forces off the line between two particles turn the pair. The bonds of
   both ends balance that in the same step, in the present positions, so that
   angular momentum is kept to round-off.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_COUPLES_H
#define LMP_TMSPH_CONTACT_COUPLES_H

#include "pointers.h"
#include "tmsph_contact_list.h"
#include "tmsph_ghost_rows.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHContactCouples : protected Pointers {
 public:
  TMSPHContactCouples(class LAMMPS *lmp, const TMSPHContactScene &scene, TMSPHContactList &list,
                      TMSPHGhostSender &ghosts) :
      Pointers(lmp),
      scene(scene), list(list), ghosts(ghosts)
  {
  }
  /// pairs were listed
  void list_anew() { bearers_known = false; }
  /// forces in bonds that balance the moments which the members remember (collective)
  /// @param anew the stress of contacts does not know that of these forces yet
  template <int D> void balance(bool anew);
  double bytes() const { return rows.bytes(); }

 private:
  const TMSPHContactScene &scene;
  TMSPHContactList &list;
  TMSPHGhostSender &ghosts;
  bool bearers_known = false;
  std::vector<int> bearers;    // local particles with a bond to one that may touch
  TMSPHGhostRows rows;         // of each particle S, and whether it is a member, and presses

  bool any_tilt() const;
  void find_bearers();
  template <int D> void fill_rows();
  template <int D> void add_forces() const;
  template <int D> void add_stress();
};

}    // namespace LAMMPS_NS
#endif
