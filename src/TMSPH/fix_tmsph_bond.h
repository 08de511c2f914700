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
#include "tmsph_kernel.h"
#include "tmsph_sweep.h"

#include <string>
#include <utility>

namespace LAMMPS_NS {

/** What the bonds ask of the style that uses them: the pair style. */
struct TMSPHBondUser {
  /// support of the kernel of the bonds, the largest and that of two types, and who may be bonded
  virtual TMSPH::Kernel kernel_of_bonds() const = 0;
  virtual double horizon() const = 0;
  virtual double horizon(int itype, int jtype) const = 0;
  virtual bool bonded(int itype, int jtype) const = 0;
  /// true if two types without bonds may touch: pairs within the horizon are kept as UNBONDED
  virtual bool touching(int itype, int jtype) const = 0;
  /// true if forces depend on velocities
  virtual bool viscous() const = 0;
  /// velocity that viscosity took last for local particle i; nullptr if that was no step or setup
  virtual const double *step_velocity(int i) const = 0;
  /// particles may change hands next, in a step of a run
  virtual void exchange_comes() = 0;
  /// the forces of a setup are there: check and tell
  virtual void run_begins() = 0;
  /// a run or minimization is over
  virtual void run_ends() = 0;

 protected:
  ~TMSPHBondUser() = default;    // never owned through this interface
};

/** A fix that knows particles by their ids and cannot follow these. */
struct TMSPHStoresIds {
  /// true if it has stored any on this processor
  virtual bool has_ids() const = 0;

 protected:
  ~TMSPHStoresIds() = default;    // owned as a fix, never through this interface
};

class FixTMSPHBond : public Fix {
 public:
  static constexpr const char *ID = "TMSPH_BOND";
  /// UNBONDED: never was a bond, but the two may be in contact
  enum State : unsigned char { INTACT = 0, BROKEN = 1, CUT = 2, UNBONDED = 3 };
  /// sets of states: bonds that hold, all that ever were bonds, the whole family
  static constexpr unsigned WHOLE = 1u << INTACT;
  static constexpr unsigned FORMED = WHOLE | 1u << BROKEN | 1u << CUT;
  static constexpr unsigned ALL = FORMED | 1u << UNBONDED;
  /** Place k in the family of a local particle, local or ghost index of the partner, state. */
  struct Bond {
    int k, j;
    State state;
  };
  class Family;

  FixTMSPHBond(class LAMMPS *, int, char **);
  ~FixTMSPHBond() override;
  int setmask() override;
  void init() override;
  void init_list(int, class NeighList *) override;
  void setup_post_neighbor() override;
  void setup(int) override;
  void min_setup(int) override;
  void post_run() override;
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

  bool formed() const { return bonds_formed; }
  /// an error if particles have changed places since the last run
  void need_layout(const std::string &who) const;
  /// true if pairs of types without bonds are in the families too
  bool formed_with_contact() const { return faced; }
  /// horizon with which they formed
  double reach() const { return horizon; }
  int count(int i) const { return npartner[i]; }
  /// for (const auto &bond : family(i, WHOLE)): partners at hand in one of these states, by ascending
  /// ids
  Family family(int i, unsigned states) const;
  /// members of the family in these states, at hand or not
  int count_in(int i, unsigned states) const;
  tagint partner_tag(int i, int k) const { return partner[i][k]; }
  State bond_state(int i, int k) const { return (State) state[i][k]; }
  /// id that local particle i had when the bonds formed; reset_atoms does not change it
  tagint first_id(int i) const { return first_tag[i]; }
  /// local or ghost index of partner k of local particle i; i itself where it is not at hand
  int partner_index(int i, int k) const
  {
    return slices.partner[slices.at(i / TMSPH::WIDTH, i % TMSPH::WIDTH, k)];
  }
  /// reference position of a local or ghost particle, in the frame of its present image
  const double *reference(int i) const { return xref.data() + 3 * (size_t) i; }
  /// and in the box in which the bonds formed
  void reference_in_box(int i, double *X) const;
  /// where that begins, and its length if it is periodic in this direction, else 0
  double reference_corner(int k) const { return corner[k]; }
  double reference_period(int k) const { return period[k]; }
  /// X_j - X_i, the nearest image, the same to the last bit (but for sign) from both ends
  void reference_vector(int i, int j, double *X) const;
  /// true if an intact bond joins local particle i to the particle with this id
  bool joined(int i, tagint id) const { return state_with(i, id) == INTACT; }
  /// State of local particle i towards the particle with this id, or -1 if they are no family
  int state_with(int i, tagint id) const;
  /// takes the bond from this end; whoever decides must decide alike at the other end
  void remove_bond(int i, int k, State why);
  /// velocity that the viscosity of a setup takes for local particle i, see lag below
  const double *setup_velocity(int i) const;
  /// bonds were removed outside a force evaluation: shape matrices must follow
  void changed() { version++; }
  /// sets atom->damage of local particle i from its broken bonds
  void update_damage(int i);
  /// number of bonds (each counted once) in a state, on all processors
  bigint count_bonds(State which) const;
  /// fewest and most bonds of a particle, on all processors
  std::pair<int, int> family_sizes() const;
  int layout_version() const { return version; }
  /// grows whenever a bond of a local particle is removed
  int removals() const { return nremoved; }
  const TMSPH::Slices &layout() const { return slices; }
  TMSPH::Slices &layout() { return slices; }
  double reference_distance(int i, int j) const;
  /// V_j W_ij, the part of j in a mean at i; that of i itself with j = i
  double kernel_mass(int i, int j, double horizon) const;
  /// W_ij = V_i V_j w_ij
  float weight(int i, int j) const;
  /// tr K/D of the interior when the bonds formed
  double interior_kappa() const { return kappa; }
  /// edge of the cell of a local or ghost particle, in 2-D in the plane
  double spacing(int i) const;
  /// that the volumes imply in 2-D, else 1; w_ij sums up in proportion to it
  double body_thickness() const { return thickness; }
  /// square of the distance from local particle i to the nearest partner in the reference state; 0
  /// if none is at hand
  double nearest_square(int i) const;

 private:
  TMSPHBondUser *user;
  class NeighList *list;
  bool bonds_formed;
  bool laid_out;                // no particle has changed its place in the arrays since
  bool faced;                   // with pairs of types that may touch, see touching()
  int maxpartner;               // row length of partner and state
  int *npartner;                // bonds of each particle at formation, less those of deleted ones
  tagint **partner;             // ids, ascending
  unsigned char **state;
  tagint *own_tag;              // id of the particle at the last setup; 0: it has no bonds yet
  tagint *first_tag;            // id when its bonds formed: it draws the random numbers
  // Velocity Verlet evaluates forces at half-step velocities, but a setup has only those of the
  // full step. For a run to continue bit for bit, viscosity keeps what the last step took, [0..2],
  // and the velocity at its end, [3..5]: as long as that is unchanged, the setup takes the former.
  double **lag;                 // with viscosity, from the end of a run to the next setup
  double horizon;               // with which the bonds formed, the largest
  std::vector<double> type_horizons;    // and that of each type
  double kappa;
  double thickness;
  double period[3];             // reference box lengths in periodic directions, else 0
  double corner[3];             // and where that box begins
  bigint particles;             // on all processors, when they were counted last
  double volume;                // of all of them; NaN: not known yet
  int version, nremoved;

  std::vector<double> xref;     // [nlocal+nghost][3]
  TMSPH::Slices slices;
  enum { REFERENCE, TAG } what_to_send;
  std::vector<tagint> former_tag;    // of ghosts too, while ids are being followed

  void form();
  void release_list();
  void refuse_equal_ids() const;
  bigint count_particles() const;
  void take_stock();
  void follow_losses();
  bool follow_ids();
  void forget_missing();
  void refuse_other_volumes() const;
  void refuse_bonds_without() const;
  double total_volume() const;
  void refuse_new_ids() const;
  void send_references();
  void lay_out();
  int find_partner(int, tagint) const;
  void stop_lost(int, tagint) const;
  void refuse_changed_images(int i, tagint partner) const;
  void check_families() const;
  double largest_kappa() const;
  double find_thickness() const;
  void resize_partners(int);
  void keep_velocities();
};

/** Those of the family of a local particle that are at hand and in one of some states. */
class FixTMSPHBond::Family {
 public:
  Family(const FixTMSPHBond *bonds, int i, unsigned states) : bonds(bonds), i(i), states(states) {}

  class iterator {
   public:
    iterator(const Family *family, int k) : family(family), k(k) { skip(); }
    Bond operator*() const
    {
      return {k, family->bonds->partner_index(family->i, k),
              family->bonds->bond_state(family->i, k)};
    }
    iterator &operator++()
    {
      k++;
      skip();
      return *this;
    }
    bool operator!=(const iterator &other) const { return k != other.k; }

   private:
    const Family *family;
    int k;
    void skip()
    {
      const FixTMSPHBond *const bonds = family->bonds;
      const int i = family->i, n = bonds->count(i);
      while (k < n && (!(family->states >> bonds->bond_state(i, k) & 1u) ||
                       bonds->partner_index(i, k) == i))
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

inline FixTMSPHBond::Family FixTMSPHBond::family(int i, unsigned states) const
{
  return {this, i, states};
}

}    // namespace LAMMPS_NS

#endif
#endif
