/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Balanced conductances of irregular clouds: they keep linear fields steady.

   On a lattice the conductances of a particle balance, sum_j G_ij X_ij = 0, so that
   a linear field is steady. In an irregular cloud they do not; the temperatures
   then scatter about the field, by a part of its change over a spacing, and the
   cloud conducts less than the mean of its bonds. The conductances nearest to
   the given ones, sum (dG)^2 R^2/G least, that balance are
     G_ij (1 + X_ij.(m_i - m_j)/R^2)
   with Lagrange multipliers m, one vector a particle. For them
     sum_j G_ij X_ij X_ij.(m_i - m_j)/R^2 = -(sum_j G_ij X_ij + A_i n_i),
   with the area A of the surface and its outward normal n: the equilibrium of a
   network of springs that pull along the bonds, solved by conjugate gradients.
   The outermost particles are left free and take what the guess of their areas
   lacks: as heat is conserved their pulls are then what a field of unit slope
   brings through the inside, and areas follow from them.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONDUCTANCE_BALANCE_H
#define LMP_TMSPH_CONDUCTANCE_BALANCE_H

#include "pointers.h"
#include "tmsph_bond_pull.h"
#include "tmsph_ghost_rows.h"

#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;
class TMSPHConductionNorms;

class TMSPHConductanceBalance : protected Pointers {
 public:
  TMSPHConductanceBalance(class LAMMPS *, TMSPHConductionNorms &, TMSPHGhostSender &);
  void init(const FixTMSPHBond *owner) { bonds = owner; }

  /** Solves for the multipliers of particles whose bonds are all of one material, and scales c so
      that the conductances have the conductivity (collective).
      @param pulls of the bonds as they are
      @param near  a surface */
  void solve(const std::vector<TMSPH::BondPull> &pulls, const std::vector<char> &near);
  /// takes the multipliers that particles keep, those of ghosts too; a body on a lattice has none
  /// (collective)
  void complete();
  void drop() { balanced = false; }

  /// the body is irregular
  bool any() const { return balanced; }
  /// factor to the conductance of a bond with reference vector X from i to j
  double factor(int i, int j, const double *X) const;
  double bytes() const { return multipliers.bytes(); }

 private:
  TMSPHConductionNorms &norms;
  TMSPHGhostSender &ghosts;
  const FixTMSPHBond *bonds = nullptr;
  bool balanced = false;
  TMSPHGhostRows multipliers;    // of local and ghost particles

  template <int D>
  void solve_in(const std::vector<TMSPH::BondPull> &pulls, const std::vector<char> &near);
};

}    // namespace LAMMPS_NS

#endif
