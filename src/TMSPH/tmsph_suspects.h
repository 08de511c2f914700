/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which bonds a test looks at. The safe states of a rock form a convex set that
   scales with its strength, so a bond between two ends that are safe on their
   own is safe: only bonds with an end that is not, or is near openings, need the
   test, or those between different rocks.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_SUSPECTS_H
#define LMP_TMSPH_SUSPECTS_H

#include <vector>

namespace LAMMPS_NS {

class Atom;
class FixTMSPHBond;
class TMSPHRocks;

class TMSPHSuspects {
 public:
  /// what makes a particle suspect: it fails itself, it is near openings
  enum : char { BEYOND = 1, NEAR = 2 };
  /// after a new layout of the bonds
  void lay_out(const FixTMSPHBond &, const TMSPHRocks &, const Atom &);
  /// why(i) of all n local and ghost particles
  template <class Why> void find(int n, const FixTMSPHBond &bonds, Why why)
  {
    suspect.resize(n);
    for (int i = 0; i < n; i++) suspect[i] = why(i);
    find_tested(bonds);
  }
  /// a bond of local particle i is to a suspect one, or between different rocks
  bool tested_at(int i) const { return tested[i]; }
  char either(int i, int j) const { return suspect[i] | suspect[j]; }
  double bytes() const { return suspect.capacity() + border.capacity() + tested.capacity(); }

 private:
  enum : char { INSIDE, BESIDE_GHOSTS, MIXED };
  std::vector<char> border;     // [nlocal] of its bonds, as long as no particle moves on
  std::vector<char> suspect;    // [nlocal+nghost]
  std::vector<char> tested;     // [nlocal]

  void find_tested(const FixTMSPHBond &);
};

}    // namespace LAMMPS_NS
#endif
