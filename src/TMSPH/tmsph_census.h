/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Are the particles still those whose bonds have formed: new ones, lost and
   deleted ones, other volumes, other ids.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CENSUS_H
#define LMP_TMSPH_CENSUS_H

#include "pointers.h"

#include <functional>
#include <unordered_map>
#include <vector>

namespace LAMMPS_NS {

class TMSPHCensus : protected Pointers {
 public:
  /// owner: the fix whose communication has the ids of ghosts sent by pack() and unpack()
  TMSPHCensus(class LAMMPS *lmp, class TMSPHFamilies &families, class Fix *owner) :
      Pointers(lmp), families(families), owner(owner)
  {
  }

  // all of these are collective

  /// an error if two particles have the same id
  void refuse_equal_ids() const;
  /// counts the particles and adds up their volumes; an error if one has no family
  void take();
  /// the number as it stands in a restart file; volumes are not known then
  void take(bigint count) { particles = count; }
  /// after particles left the box or were deleted: their partners forget them
  void follow_losses();
  /// reset_atoms id and delete_atoms with compression give new ids: families follow.
  /// @return false if all ids are the same
  bool follow_ids();
  /// an error if volumes have changed
  void refuse_other_volumes() const;

  /// true while follow_ids() has them sent
  bool sending() const { return !former_tag.empty(); }
  int pack(int n, const int *list, double *buf) const;
  void unpack(int n, int first, const double *buf);

 private:
  class TMSPHFamilies &families;
  class Fix *owner;
  bigint particles = 0;              // on all processors, when they were counted last
  double volume = NAN;               // of all of them; NaN: not known yet
  std::vector<tagint> former_tag;    // of ghosts too, while ids are being followed

  std::unordered_map<tagint, tagint> ask_all(std::vector<tagint> mine,
                                             const std::function<tagint(tagint)> &answer) const;
  bigint count_particles() const;
  double total_volume() const;
  void forget_missing();
};

}    // namespace LAMMPS_NS
#endif
