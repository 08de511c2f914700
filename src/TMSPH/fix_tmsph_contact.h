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

#include "atom.h"
#include "fix.h"
#include "pair_tmsph.h"
#include "tmsph_contact_pair.h"
#include "tmsph_own_surface.h"
#include "tmsph_plane_fit.h"
#include "tmsph_presses.h"

#include <array>
#include <cstdint>
#include <memory>
#include <tuple>
#include <unordered_map>

namespace TMSPH {

/** Two particles may come closer by this share of the horizon between searches: within it the
    kernel has a thousandth of its middle value. */
constexpr double SEARCH_MARGIN = 0.1;

/** A particle is held at an outline if it is nearer than this many of the coarsest spacing, in
    front and behind. */
constexpr double OUTLINE_REACH = 1.5;

/** What a force evaluation tells of each particle: F - I, velocity, acceleration, 1 if its bonds
    can balance a couple, compliance Kc/m. */
template <int D> struct ContactRow {
  static constexpr int H = 0, V = D * D, A = V + D, BEARS = A + D, COMPLIANCE = BEARS + 1,
                       WIDTH = COMPLIANCE + 1;
};

/** And of its places at segments: the ids of the ends, the share of the second, stiffness; then
    force, from the particle to the place, distance when touching, normal force, heat, share of the
    particle in the sum of the depths, 1/sum of the shares of the ends that can balance a couple. */
struct SegmentRow : ContactRow<2> {
  static constexpr int PLACES = 2;
  static constexpr int START = 0, END = 1, ALONG = 2, STIFFNESS = 3, WHERE_SIZE = 4;
  static constexpr int F = 0, R = 2, TOUCHING = 4, NORMAL = 5, HEAT = 6, SHARE = 7, BORNE = 8,
                       FORCE_SIZE = 9;
  static constexpr int WHERE = ContactRow<2>::WIDTH, FORCE = WHERE + PLACES * WHERE_SIZE,
                       WIDTH = FORCE + PLACES * FORCE_SIZE;
};

}    // namespace TMSPH

namespace LAMMPS_NS {

class FixTMSPHContact : public Fix,
                        public TMSPHSurfaceContact,
                        public TMSPHPresses,
                        public TMSPHStoresIds {
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
  bool has_ids() const override { return !memories.empty(); }

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
  void add_shares(std::vector<Share> &) override;
  int doubles_per_ghost() const override;
  void touches(std::vector<Touch> &) override;
  void rubbings(std::vector<Rubbing> &) override;

 private:
  /** What a pair remembers, at both ends. */
  struct Record {
    tagint partner;
    TMSPH::ContactPast past;
    bool parted;          // they went out of each other's reach; if they come back they meet anew
  };
  /** A pair of particles that met later, at both ends. */
  struct Met {
    tagint partner;
    TMSPH::ContactPast past;
    TMSPH::PairGeometry geometry;
  };
  /** A pair that presses, as heat needs it. */
  struct Pressed {
    tagint partner;
    double weight, distance;
  };
  /** Where friction is zero, of a particle that touches a segment: along it from its first end and
      to its left, in its lengths. */
  struct Anchor {
    tagint start, end;
    double along, left;
  };
  /** What a particle with contacts remembers of its last step. */
  struct Memory {
    double force[3] = {}, stress[6] = {};            // by contact; share of the Cauchy stress
    double tilt[9] = {};                             // moments f x of what bonds have to balance
    std::uint64_t stamp = 0;                         // fingerprint at the end of the run
    std::vector<Record> records;                     // of the reference family, ascending partners
    std::vector<Met> met;                            // ascending partners
    std::vector<Anchor> anchors;                     // of the segments that it touches
    double apart = 0.0;    // from the other body's outline in the reference; 0: not within reach
    std::vector<Pressed> pressed;                    // ascending partners; only for heat
    double rubbed = 0.0;                             // only for heat: friction's work not yet taken
  };
  /** Of bodies without bonds, of faces of a crack or a cut, or not in the reference but later. */
  enum class Meeting { BODIES, FACES, LATER };
  /** Two particles, at least one of them local, computed once. */
  struct Pairing {
    int low, high;        // by id
    Meeting meeting;
    TMSPH::ContactPast *past;    // of the record of a local end
    TMSPH::ContactPast *copy;    // of the other one if it is local too, or nullptr
    TMSPH::ContactPast now;      // the same, ahead of the records: see write_back()
    TMSPH::ContactPair pair;
  };
  /** A pair whose surfaces are found anew, and the former ones. */
  struct Refit {
    int pairing;
    TMSPH::ContactPair before;
  };
  /** Where a particle touches the outline of another body. */
  struct Place {
    int a, b;              // ends of the segment
    double along;          // share of b
    double normal[2];      // towards the particle
    double distance;       // from the line through the centres; negative behind it
    double touching;       // the same when the surfaces just touch
    double predicted, closing;
  };
  /** A local particle that may touch, and the outlines near it. */
  struct Slave {
    int i;
    int first, last;       // its chains
    int count;             // of places
    double stiffness;
    Place place[2];
  };
  /** A local particle of an outline that others may touch. */
  struct Master {
    int i;
    int first, last;       // those that may, by ascending ids
  };
  /** method segment: outlines of bodies, one of which may touch the other. */
  struct Segments {
    std::vector<double> spacing;                     // by type
    double coarsest = 0.0;                           // of them
    std::vector<std::array<tagint, 2>> next;         // of local and ghost particles; 0: none
    std::vector<int> outline;                        // local and ghost particles of outlines
    std::vector<Slave> slaves;
    std::vector<Master> masters;
    std::vector<int> slave_of, master_of;            // of local particles, -1: neither
    std::vector<std::pair<int, int>> chains;         // from, to in nodes
    std::vector<int> nodes, near;
    bool measured = false;                           // distances in the reference
    bool any = false;                                // slaves on any processor
  };
  /** What contacts do to a particle. */
  struct Effect {
    double force[3] = {}, stress[6] = {}, tilt[9] = {};    // stress: times volume
    template <int D>
    void add(double sign, double share, double borne, const double *f, const double *r,
             const double *normal);
    void add(const Effect &);
  };
  /** What a pair does in a step, in the compact form that both ends take it from. */
  struct Act {
    double f[3], r[3], share;
    double borne[2];      // shares of the low and the high end in the couple
  };
  /** One end of a pair, at a local particle. */
  struct End {
    int j, pairing;
    bool low;             // it has the lower id
    Record *record;       // one of these two, the other is nullptr
    Met *met;
    TMSPH::ContactPast *past() const { return record ? &record->past : &met->past; }
  };
  struct Member {
    int i, first, last;    // local particle, its ends
    Memory *memory;
  };

  PairTMSPH *pair;
  FixTMSPHBond *bonds;
  std::unique_ptr<Segments> segments;        // null: kernel-weighted pairs for all
  bool self;                                 // faces of cracks and cuts touch too
  TMSPH::ContactLaw law;
  double stiffness;                          // factor to the default
  std::vector<std::vector<double>> friction;    // by type and type

  std::unordered_map<tagint, Memory> memories;    // by id
  std::vector<Member> members;
  std::vector<End> ends;                     // of each member by ascending partner
  std::vector<Pairing> pairings;
  std::vector<Refit> refits;                 // since the last evaluation
  std::tuple<std::vector<TMSPH::ContactState<2>>, std::vector<TMSPH::ContactState<3>>> states_of;
  std::vector<double> pressing;              // stiffness of each pair that presses, else 0
  std::vector<Act> acts;                     // of those
  bool records_behind;                       // the pairings know more than the records
  std::vector<int> bearers;                  // local particles with a bond to one that may touch
  std::vector<Fix *> prescribing;            // that act after it
  bool any_pairs;                            // on any processor
  bool resumed;                              // the setup takes the forces of the last step again
  int version, removals;                     // of the bonds when the pairs were listed
  bool distance_checked;                     // of bodies that are not bonded

  std::vector<std::string> region_ids;       // whose surfaces are those of bodies
  std::vector<class Region *> regions;
  bool sides_checked;                        // of the particles at these

  std::vector<TMSPH::Surface> surfaces;      // of local particles
  int surfaces_version, surfaces_removals;   // of the bonds that they were found from
  bigint last_search, next_search;           // for particles that meet
  double search_dt;                          // time step for which that holds

  std::vector<double> rows;                  // [nlocal+nghost][width], sent to ghosts
  int width, sent_first, sent_count;
  int velocities_sent;                       // where they begin in the columns sent, or -1

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
  void find_refits(const std::vector<Pairing> &before);
  template <int D> void keep_energy();
  template <int D> TMSPH::ContactEnd<D> end_at(int p, bool expands) const;
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
  template <int D> void fill_rows(bool predicts);
  void acts_on(const Effect &, const Member &);
  void find_bearers();
  template <int D> void balance_couples(bool anew);
  void write_back();
  void add_to_totals(int i, const Effect &);
  template <int D> void apply_again();
  template <int D>
  void keep_touches(const std::vector<TMSPH::ContactState<D>> &, const std::vector<double> &heats);
  void add_virial();
  bool is_slave(int itype, int jtype) const;
  double touching_distance(int i, int a, int b, double along) const;
  void find_outlines();
  void measure();
  void face();
  bool faces(int i, const Memory &) const;
  void find_places(double dt);
  double segment_stiffness(int i) const;
  void hold_places(double dt);
  void hold(Slave &, double dt);
  void add_places(int i, Effect &counted, Effect &other) const;
  void keep_places(int i, Memory &) const;
  template <class Use> void places_at_master(const Master &, Use) const;
  void send(int first, int count);
  static constexpr int MOST_SENT = 2 * TMSPH::Moments<3>::SIZE;    // per particle, by fit_pairs()
  static constexpr int PRESSED_AT_SEGMENTS = 64;    // that a particle of an outline may have
  static int exchange_size(int nrecords, int nmet, int nanchors, int npressed);
  int exchange_size(const Memory &, bool at_most) const;
};

/** An end of a pair, from the rows that an evaluation sends. */
template <int D>
inline TMSPH::ContactEnd<D> FixTMSPHContact::end_at(int p, bool expands) const
{
  using Row = TMSPH::ContactRow<D>;
  const double *row = rows.data() + (size_t) width * p;
  return {atom->x[p], row + Row::V, row + Row::A, row + Row::H,
          expands ? pair->thermal_strain(p) : 0.0, row[Row::BEARS] != 0.0};
}

/** Half of a contact, between two points.
    @param sign  1 at the second of them, on which f acts, -1 at the first
    @param share depth of the particle below its surface/sum of both depths
    @param borne share of the particle in the couple
    @param r     from the first point to the second
    @param normal of the surface, of unit length */
template <int D>
inline void FixTMSPHContact::Effect::add(double sign, double share, double borne, const double *f,
                                         const double *r, const double *normal)
{
  const double part = 0.25 + 0.5 * share;    // of the stress: by depth and evenly, the mean
  for (int a = 0; a < D; a++) {
    force[a] += sign * f[a];
    stress[a] -= part * f[a] * r[a];
  }
  stress[3] -= 0.5 * part * (f[0] * r[1] + f[1] * r[0]);
  if (D == 3) {
    stress[4] -= 0.5 * part * (f[0] * r[2] + f[2] * r[0]);
    stress[5] -= 0.5 * part * (f[1] * r[2] + f[2] * r[1]);
  }
  if (borne != 0.0) TMSPH::add_tilt<D>(borne, f, r, normal, tilt);
}

}    // namespace LAMMPS_NS

#endif
#endif
