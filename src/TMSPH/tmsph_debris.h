/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Repulsion of particles that no intact bond joins, so that fragments do not
   pass through each other: a frictionless stand-in for real contact.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_DEBRIS_H
#define LMP_TMSPH_DEBRIS_H

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;
class NeighList;

/** Two particles without an intact bond repel with k (d - r) along the line between them, from the
    distance d = min(|X_ij|, (d_i + d_j)/2) on. d_i is the reference distance of the nearest
    partner of i, k the harmonic mean of E V/d^2 of both: about the stiffness of a cell of rock. */
class TMSPHDebris : protected Pointers {
 public:
  explicit TMSPHDebris(class LAMMPS *lmp) : Pointers(lmp) {}

  /// Young's modulus of each type, [ntypes+1]
  void set_young(const std::vector<double> &values) { young = values; }
  /// bit 1<<state for each State of families that others see to, INTACT among them
  void leave_out(unsigned states) { others = states; }
  /// contact sizes d_i of the local particles
  void measure(const FixTMSPHBond &bonds);
  std::vector<double> &spacings() { return spacing; }    ///< ghosts' ones are filled by the caller
  /// pairs of a full neighbor list that may touch before the next one, which the skin decides
  void list_candidates(const NeighList &list, double neighbor_skin, const FixTMSPHBond &bonds);
  /// a bond of local particle i to j broke: they may touch from now on
  void add(int i, int j, const FixTMSPHBond &bonds);
  /** Adds forces to atom->f of local particles, and to virial (6, or nullptr).
      @return this processor's part of the energy */
  double repel(double *virial);
  int contacts() const { return touching; }    ///< contacts of local particles at the last call

 private:
  struct Candidate {
    int i, j;
    double distance, stiffness;
  };
  std::vector<double> young;
  std::vector<double> spacing;    // [nlocal+nghost]
  unsigned others = 1u;
  double skin = 0.0;
  std::vector<Candidate> candidates;
  bool sorted = true;
  int touching = 0;

  /// before the next neighbor list: no particle moves more than half the skin until then
  bool may_touch(int i, int j) const;
  bool left_out(int state) const { return state >= 0 && (others >> state & 1u); }
  bool make(int i, int j, const FixTMSPHBond &bonds, Candidate &) const;
};

}    // namespace LAMMPS_NS

#endif
