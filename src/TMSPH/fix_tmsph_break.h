/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What all fixes that break bonds by a criterion have in common: which bonds break, strengths that
   scatter, the table of events. A fix of a criterion is this class with its law, see below.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_TMSPH_BREAK_H
#define LMP_FIX_TMSPH_BREAK_H

#include "fix.h"
#include "pair_tmsph.h"
#include "tmsph_criterion.h"
#include "tmsph_debris.h"
#include "tmsph_faces.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_openings.h"
#include "tmsph_report.h"

#include <memory>

namespace LAMMPS_NS {

class FixTMSPHBreak : public Fix,
                      public TMSPHBreakTest,
                      public TMSPHOpensBonds,
                      public TMSPHReporter {
 public:
  FixTMSPHBreak(class LAMMPS *, int, char **, std::unique_ptr<TMSPH::Criterion>);
  /// the one of this simulation, or nullptr
  static FixTMSPHBreak *find(class LAMMPS *);
  int setmask() override;
  void init() override;
  void init_list(int, class NeighList *) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;

  bool due() const override { return armed; }
  void break_bonds(const double *, std::vector<int> &) override;
  double repel(double *) override;
  TMSPHOpenings *openings() override { return opening.get(); }
  void remove_opened(std::vector<int> &) override;
  void tell() override;

  /** What a test in equilibrium found, on all processors. */
  struct Test {
    double largest = 0.0;    // load factor of a bond
    bigint broken = 0;
  };
  bool softens() const override;
  /// a step of the thermal clock begins
  void begin_step() { broken_now = 0; }
  /** Bonds are tested in the next force evaluation. Those break whose load factor is at least 1
      and at least "fraction" of the largest. */
  void test_next(double fraction);
  const Test &last_test() const { return test; }
  /// the smallest uniaxial tensile strength of a type, without scatter
  double tensile_strength() const;
  /// and that of one
  double tensile_strength(int type) const;

  /// strengths of the present particles, for the two below (collective)
  void find_strengths();
  /// strength of particle i as the criterion's first word gives it, drawn for its id
  double strength(int i) const;
  /// load factor of a stress (xx yy zz xy xz yz) with particle i's strength
  double load_factor(int i, const double *stress) const;

 private:
  struct Rock {
    double strength = 0.0;
    double modulus = 0.0;    // Weibull; 0: no scatter
    int seed = 0;
    double energy = 0.0;     // G_f of a crack; 0: bonds break at once
    double toughness = 0.0;  // K_Ic in place of it, or 0
    double tensile = 0.0;    // uniaxial tensile strength/strength
  };
  struct Event {
    double column[13];
  };
  /** A bond that fails, seen from one of its ends, with its stress. */
  struct Due {
    int i, k;
    double load, stress[6];
    TMSPH::Principals principals;
  };

  PairTMSPH *pair;
  class FixTMSPHBond *bonds;
  class NeighList *list;
  TMSPHGhostSender ghosts;
  TMSPHDebris debris;
  std::unique_ptr<TMSPH::Criterion> criterion;
  std::vector<Rock> rocks;               // by type
  bool all_principals, one_rock;
  bool armed;                            // in a step of a run, not in setup or minimization
  int version;                           // layout that the arrays below belong to
  std::vector<double> strengths;         // [nlocal+nghost] drawn strengths
  enum : char { BEYOND = 1, NEAR = 2 };
  std::vector<char> suspect;             // [nlocal+nghost] fails itself, or is near openings
  enum : char { INSIDE, BESIDE_GHOSTS, MIXED };
  std::vector<char> border;              // [nlocal] of its bonds, as long as no particle moves on
  std::vector<char> tested;              // [nlocal] in this step
  bigint broken[2];                      // in tension, in shear: events recorded here
  bigint broken_now;
  bool fresh;                            // nothing has been tested yet, in this or an earlier run
  double relative;                       // in equilibrium, of the largest load factor; else 0
  Test test;
  std::vector<Due> due_bonds;
  std::unique_ptr<TMSPHOpenings> opening;    // with energy or toughness
  TMSPHOpenings::Balance before{};       // from a restart file
  TMSPHBondWatch damage_watch;
  std::vector<char> damaged, watched;    // of local particles: bonds are gone; they are looked at
  bool began;                            // here, in this test
  bool looking;                          // at bonds that may open, on some processor
  std::vector<Event> events;
  std::vector<double *> event_rows;

  void parse(int, char **);
  void read_weibull(class TMSPHValues &);
  void follow_layout();
  TMSPH::Principals principals(const double *stress, double zz) const;
  TMSPH::Principals principals_of(int i, const double *stress) const;
  bool may_fail(int i, const double *stress) const;
  void find_tested();
  void find_due(const double *stress);
  void follow_openings(const double *stress);
  bool opens(int i, int j) const;
  bool opens_type(int type) const
  {
    return rocks[type].energy > 0.0 || rocks[type].toughness > 0.0;
  }
  void check_openings() const;
  double characteristic_length(int type) const;
  double tensile_strength_of(int i) const { return strengths[i] * rocks[atom->type[i]].tensile; }
  bool may_open(int i, const double *stress) const;
  bool pulled(const Due &) const;
  double bond_strength(const Due &) const;
  bool begin_opening(Due &);
  void init_openings();
  void complete_openings();
  double crack_energy(int type) const;
  double crack_modulus(int type) const;
  void keep_most_loaded();
  void warn_of_hot_start();
  void record(const Due &);
  void list_events();
  void gather_events(std::vector<double> &);
  double largest_load();
  bigint total(int mode);
};

/** The fix of one law. */
template <class Law> class FixTMSPHBreakBy : public FixTMSPHBreak {
 public:
  FixTMSPHBreakBy(class LAMMPS *lmp, int narg, char **arg) :
      FixTMSPHBreak(lmp, narg, arg, std::make_unique<TMSPH::CriterionOf<Law>>())
  {
  }
};

}    // namespace LAMMPS_NS

#endif
