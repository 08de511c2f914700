/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The one owner of the reference bonds. An internal fix, made by pair style
   tmsph: families form at the first setup and then travel with their
   particles; after each exchange of particles it lays out the flat arrays
   that the sweeps stream over.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/bond,FixTMSPHBond);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_BOND_H
#define LMP_FIX_TMSPH_BOND_H

#include "fix.h"
#include "tmsph_bond_history.h"
#include "tmsph_bond_user.h"
#include "tmsph_census.h"
#include "tmsph_families.h"
#include "tmsph_reference_geometry.h"
#include "tmsph_sweep.h"

#include <string>
#include <utility>

namespace LAMMPS_NS {

class TMSPHFamilyRange;

class FixTMSPHBond :
    public Fix,
    public TMSPHFamilies,
    public TMSPHReferenceGeometry,
    public TMSPHBondHistory {
 public:
  static constexpr const char *ID = "TMSPH_BOND";

  FixTMSPHBond(class LAMMPS *, int, char **);
  ~FixTMSPHBond() override;
  int setmask() override;
  void init() override;
  void init_list(int, class NeighList *) override;
  void setup_post_neighbor() override;
  void setup(int) override;
  void min_setup(int vflag) override { setup(vflag); }
  void post_run() override;
  void setup_pre_exchange() override { maxexchange = most_of_row(); }
  void pre_exchange() override;
  void post_neighbor() override;
  void min_post_neighbor() override { post_neighbor(); }

  double memory_usage() override;
  void grow_arrays(int) override;
  void copy_arrays(int, int, int) override;
  void set_arrays(int) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  /// id of local particle i as the bonds know it: a former one until the next setup, where all follow
  static tagint known_id(class LAMMPS *, int i);
  bool formed() const { return bonds_formed; }
  /// an error if particles have changed places since the last run
  void need_layout(const std::string &who) const;
  /// true if pairs of types without bonds are in the families too
  bool formed_with_contact() const { return faced; }
  /// for (const auto &bond : family(i, WHOLE)): partners at hand in one of these states, by
  /// ascending ids
  TMSPHFamilyRange family(int i, unsigned states) const;
  /// local or ghost index of partner k of local particle i; i itself where it is not at hand
  int partner_index(int i, int k) const { return slices.partner[slices.at(i, k)]; }
  /// takes the bond from this end, and what it carries; whoever decides must decide alike at the
  /// other end
  void remove_bond(int i, int k, State why);
  /// velocity that the viscosity of a setup takes for local particle i, see lag below
  const double *setup_velocity(int i) const;
  /// sets atom->damage of local particle i from its broken bonds
  /// @param opened of its open bonds the parts of full opening, together
  void update_damage(int i, double opened = 0.0);
  /// number of bonds (each counted once) in a state, on all processors
  bigint count_bonds(State which) const;
  /// fewest and most bonds of a particle, on all processors
  std::pair<int, int> family_sizes() const;
  const TMSPH::Slices &layout() const { return slices; }
  TMSPH::Slices &layout() { return slices; }
  /// square of the distance from local particle i to the nearest partner in the reference state; 0
  /// if none is at hand
  double nearest_square(int i) const;

 private:
  TMSPHCensus census;
  // Velocity Verlet evaluates forces at half-step velocities, but a setup has only those of the
  // full step. For a run to continue bit for bit, viscosity keeps what the last step took, [0..2],
  // and the velocity at its end, [3..5]: as long as that is unchanged, the setup takes the former.
  TMSPHParticleValues &lag;    // carried with viscosity, from the end of a run to the next setup
  class NeighList *list;
  bool bonds_formed;
  bool faced;    // with pairs of types that may touch, see touching()
  TMSPH::Slices slices;

  void form();
  void check_formation() const;
  std::vector<std::pair<tagint, State>> find_members(int) const;
  void refuse_bonds_without() const;
  void send_references();
  void lay_out();
  void stop_lost(int, tagint) const;
  void refuse_changed_images(int i, tagint partner) const;
  void check_families() const;
  double largest_kappa() const;
  double find_thickness() const;
  void keep_velocities();
};

/** Place k in the family of a local particle, local or ghost index of the partner, state. */
struct TMSPHBond {
  int k, j;
  TMSPHFamilies::State state;
};

/** Those of the family of a local particle that are at hand and in one of some states. */
class TMSPHFamilyRange {
 public:
  TMSPHFamilyRange(const FixTMSPHBond *bonds, int i, unsigned states) :
      bonds(bonds), i(i), states(states)
  {
  }

  class iterator {
   public:
    iterator(const TMSPHFamilyRange *range, int k) : range(range), k(k) { skip(); }
    TMSPHBond operator*() const
    {
      return {k, range->bonds->partner_index(range->i, k), range->bonds->bond_state(range->i, k)};
    }
    iterator &operator++()
    {
      k++;
      skip();
      return *this;
    }
    bool operator!=(const iterator &other) const { return k != other.k; }

   private:
    const TMSPHFamilyRange *range;
    int k;
    void skip()
    {
      const FixTMSPHBond *const bonds = range->bonds;
      const int i = range->i, n = bonds->count(i);
      while (k < n &&
             (!(range->states >> bonds->bond_state(i, k) & 1u) || bonds->partner_index(i, k) == i))
        k++;
    }
  };
  iterator begin() const { return {this, 0}; }
  iterator end() const { return {this, bonds->count(i)}; }

 private:
  const FixTMSPHBond *bonds;
  int i;
  unsigned states;
};

inline TMSPHFamilyRange FixTMSPHBond::family(int i, unsigned states) const
{
  return {this, i, states};
}

}    // namespace LAMMPS_NS

#endif
#endif
