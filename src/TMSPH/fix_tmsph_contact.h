/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/contact: contact with friction between bodies that are not bonded
   and between the faces of cracks and cuts.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/contact,FixTMSPHContact);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_CONTACT_H
#define LMP_FIX_TMSPH_CONTACT_H

#include "fix.h"
#include "pair_tmsph.h"
#include "tmsph_contact_pair.h"
#include "tmsph_own_surface.h"

#include <cstdint>
#include <unordered_map>

namespace LAMMPS_NS {

class FixTMSPHContact : public Fix, public PairTMSPH::Contact {
 public:
  FixTMSPHContact(class LAMMPS *, int, char **);
  ~FixTMSPHContact() override;
  int setmask() override;
  void init() override;
  void setup_pre_force(int) override;
  void setup(int) override;
  void min_setup(int) override;
  void post_force(int) override;
  void min_post_force(int) override;
  void post_run() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;

  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  bool touching(int, int) const override { return true; }
  unsigned states() const override;
  const std::vector<Couple> &couples() override;
  void add_stress(double *stress) override;
  void touches(std::vector<Touch> &) override;
  void rubbings(std::vector<Rubbing> &) override;

 private:
  /** What a pair remembers, at both ends: the movement of its friction origin against the one
      that the reference positions give. */
  struct Record {
    tagint partner;
    double moved[2];
    bool parted;          // they went out of each other's reach; if they come back they meet anew
  };
  /** A pair of particles that met later, at both ends. */
  struct Met {
    tagint partner;
    double moved[2];
    TMSPH::PairGeometry geometry;
  };
  /** A pair that presses, as heat needs it. */
  struct Pressed {
    tagint partner;
    double weight, distance;
  };
  /** What a particle with contacts remembers of its last step. */
  struct Memory {
    double force[3] = {}, stress[6] = {};               // by contact; stress: share of the Cauchy stress
    double couple[3] = {}, couple_before[3] = {};    // for the next step, and of the last
    std::uint64_t stamp = 0;                         // fingerprint at the end of the run
    std::vector<Record> records;                     // of the reference family, ascending partners
    std::vector<Met> met;                            // ascending partners
    std::vector<Pressed> pressed;                    // ascending partners; only for heat
    double rubbed = 0.0;                             // only for heat: work of friction not yet taken
  };
  /** Two particles, at least one of them local, computed once. */
  struct Pairing {
    int low, high;        // by id
    int kind;             // 0: bodies that are not bonded, 1: faces of a crack or a cut, 2: met later
    double *moved;        // of a local end
    double *copy;         // of the other one if it is local too, or nullptr
    TMSPH::ContactPair pair;
  };
  /** One end of a pair, at a local particle. */
  struct End {
    int j, pairing;
    bool low;             // it has the lower id
    Record *record;       // one of these two, the other is nullptr
    Met *met;
    double *moved() const { return record ? record->moved : met->moved; }
  };
  struct Member {
    int i, first, last;    // local particle, its ends
    Memory *memory;
  };

  PairTMSPH *pair;
  FixTMSPHBond *bonds;
  bool self;                                 // faces of cracks and cuts touch too
  double stiffness;                          // factor to the default
  std::vector<std::vector<double>> friction;    // by type and type

  std::unordered_map<tagint, Memory> memories;    // by id
  std::vector<Member> members;
  std::vector<End> ends;                     // of each member by ascending partner
  std::vector<Pairing> pairings;
  std::vector<Couple> couple_list;
  bool any_pairs;                            // on any processor
  bool resumed;                              // the setup takes the forces of the last step again
  int version, removals;                     // of the bonds when the pairs were listed
  bool distance_checked;                     // of bodies that are not bonded

  std::vector<std::string> region_ids;       // whose surfaces are those of bodies
  std::vector<class Region *> regions;
  bool sides_checked;                        // of the particles at these

  std::vector<TMSPH::Surface> surfaces;      // of local particles
  int surfaces_version, surfaces_removals;   // of the bonds that they were found from
  bigint next_search;                        // for particles that meet
  double search_dt;                          // time step for which that holds

  std::vector<double> rows;                  // [nlocal+nghost][width], sent to ghosts
  int width, sent_first, sent_count;

  enum { FORCE = 0, TORQUE = 3, WORK = 6, TOUCHING, DEEPEST, NORMAL, NTOTALS };
  double totals[NTOTALS];                    // of this processor
  double energy;

  void parse(int, char **);
  void follow(bool after_breaks);
  void list_pairs();
  int list_members();
  bool counts(int state) const { return states() >> state & 1u; }
  void warn_if_apart(double nearest);
  template <int D> void fit_pairs();
  void set_stiffness(Pairing &, double kappa, double ratio, double closure) const;
  TMSPH::Surface given_surface(int i) const;
  template <int D> bool take_given_surfaces(const Pairing &, const double *X,
                                            TMSPH::PairGeometry &);
  template <int D> void find_surfaces();
  template <int D> void search(const std::vector<TMSPH::ContactState<D>> &);
  template <int D> int meet();
  int part();
  bool may_meet(int i, int j) const;
  void plan_search();
  template <int D> void evaluate(double dt);
  template <int D> void apply_again();
  template <int D>
  void keep_touches(const std::vector<TMSPH::ContactState<D>> &, const std::vector<double> &forces,
                    const std::vector<double> &heats);
  void add_virial();
  void send(int first, int count);
  static int exchange_size(int nrecords, int nmet, int npressed);
  int exchange_size(const Memory &, bool at_most) const;
};

}    // namespace LAMMPS_NS

#endif
#endif
