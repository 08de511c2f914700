/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What has happened to the bonds of this processor, in numbers that grow: new
   layouts and removals. Who keeps something by the bonds compares these.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOND_HISTORY_H
#define LMP_TMSPH_BOND_HISTORY_H

#include <algorithm>
#include <mpi.h>
#include <vector>

namespace LAMMPS_NS {

class TMSPHBondHistory {
 public:
  int layout_version() const { return version; }
  /// bonds were removed outside a force evaluation: shape matrices must follow
  void changed() { version++; }
  /// grows whenever a bond of a local particle is removed
  int removals() const { return forgotten + (int) removed.size(); }
  /// calls use(i) for each end that was removed since there were so many, in the present layout
  template <class Use> void each_removal(int since, Use use) const
  {
    for (size_t n = std::max(0, since - forgotten); n < removed.size(); n++) use(removed[n]);
  }

 protected:
  /// the bonds are laid out by the present places of particles
  void lays_out()
  {
    forgotten = removals();
    removed.clear();
    in_place = true;
    version++;
  }
  /// a particle has changed its place in the arrays, until the next layout
  void moves() { in_place = false; }
  bool all_in_place() const { return in_place; }
  /// local particle i lost a bond
  void loses(int i) { removed.push_back(i); }

 private:
  int version = 0;
  bool in_place = false;
  int forgotten = 0;           // removals before the present layout
  std::vector<int> removed;    // local particle of each since
};

/** What somebody has seen of the bonds and keeps something by. */
class TMSPHBondWatch {
 public:
  /// particles have changed places or hands since
  bool laid_out_anew(const TMSPHBondHistory &bonds) const
  {
    return version != bonds.layout_version();
  }
  /// bonds of this processor are gone, of any processor (collective)
  bool removed(const TMSPHBondHistory &bonds) const { return removals != bonds.removals(); }
  bool removed_anywhere(const TMSPHBondHistory &bonds, MPI_Comm world) const
  {
    int mine = removed(bonds), any;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    return any;
  }
  /// calls use(i) for each end that was removed, in the present layout
  template <class Use> void each_removal(const TMSPHBondHistory &bonds, Use use) const
  {
    bonds.each_removal(removals, use);
  }
  void see(const TMSPHBondHistory &bonds)
  {
    version = bonds.layout_version();
    removals = bonds.removals();
  }
  /// as if particles had changed places
  void forget() { version = -1; }

 private:
  int version = -1, removals = 0;
};

}    // namespace LAMMPS_NS
#endif
