/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What conduction knows of each particle since the bonds formed: it is frozen
   then, so that broken bonds do not make the others conduct better.

     c = D/sum_j V_j w R^2        over all bonds that the particle had
     depth                        below the interface to another type, 0 far from one
     multipliers                  of an irregular cloud, tmsph_conductance_balance.h

   An internal fix keeps them: they stay with their particles in exchanges and
   restarts.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONDUCTION_NORMS_H
#define LMP_TMSPH_CONDUCTION_NORMS_H

#include "fix_store_atom.h"
#include "pointers.h"
#include "tmsph_bond_user.h"
#include "tmsph_ghost_rows.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;

class TMSPHConductionNorms : protected Pointers {
 public:
  explicit TMSPHConductionNorms(class LAMMPS *lmp) : Pointers(lmp), present(MULTIPLIER) {}
  ~TMSPHConductionNorms() override;
  /// @param id of the fix whose they are
  void keep(const std::string &id);
  void init(const FixTMSPHBond *, const TMSPHBondUser *);

  /// true if some particle has none yet (collective)
  bool lacking() const;
  /// sum_j V_j w R^2 of local particles
  std::vector<double> second_moments() const;
  /** Sets c by such sums (collective).
      @param near surface: the sum lacks terms, and that of the interior is taken */
  void set(const std::vector<double> &second, const std::vector<char> &near);
  void find_depths();

  // of local particles, frozen

  double &frozen_norm(int i) { return store->astore[i][NORM]; }
  double frozen_norm(int i) const { return store->astore[i][NORM]; }
  double *frozen_multipliers(int i) { return store->astore[i] + MULTIPLIER; }

  // of local and ghost particles, since they were completed last (collective)

  void complete(TMSPHGhostSender &);
  double norm(int i) const { return present[i][NORM]; }
  double depth(int i) const { return present[i][DEPTH]; }
  double bytes() const { return present.bytes(); }

 private:
  enum { NORM, DEPTH, MULTIPLIER };    // columns of the store, the first two of the rows
  FixStoreAtom *store = nullptr;
  std::string store_id;
  TMSPHGhostRows present;
  const FixTMSPHBond *bonds = nullptr;
  const TMSPHBondUser *user = nullptr;

  double typical(int type, const std::vector<double> &second, const std::vector<char> &near) const;
};

}    // namespace LAMMPS_NS

#endif
