/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What all fixes that break bonds by a criterion have in common: what LAMMPS
   calls, and the decision which bonds break, at both ends of each. A fix of a
   criterion is this class with its law, see below.
------------------------------------------------------------------------- */

#ifndef LMP_FIX_TMSPH_BREAK_H
#define LMP_FIX_TMSPH_BREAK_H

#include "fix.h"
#include "pair_tmsph.h"
#include "tmsph_break_events.h"
#include "tmsph_debris.h"
#include "tmsph_faces.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_opening_rule.h"
#include "tmsph_report.h"
#include "tmsph_rocks.h"
#include "tmsph_suspects.h"

#include <memory>

namespace LAMMPS_NS {

class FixTMSPHBreak :
    public Fix,
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
  TMSPHOpenings *openings() override { return opening.openings(); }
  void remove_opened(std::vector<int> &) override;
  bool softens() const override { return rock.any_opens(); }
  void tell() override;

  /** What a test in equilibrium found, on all processors. */
  struct Test {
    double largest = 0.0;    // load factor of a bond
    bigint broken = 0;
  };
  /// a step of the thermal clock begins
  void begin_step() { events.begin_step(); }
  /** Bonds are tested in the next force evaluation. Those break whose load factor is at least 1
      and at least "fraction" of the largest. */
  void test_next(double fraction);
  const Test &last_test() const { return test; }
  const TMSPHRocks &rocks() const { return rock; }
  /// a bond broke, in this or an earlier run, or opens
  bool any_damage();
  /// draws strengths of the present particles (collective)
  void find_strengths();

 private:
  /** A bond that fails, seen from one of its ends, with its stress. */
  struct Due {
    int i, k;
    double load, stress[6];
    TMSPH::Principals principals;
    bool opens = false;    // before it is gone
  };

  PairTMSPH *pair;
  FixTMSPHBond *bonds;
  class NeighList *list;    // of all pairs, where contact does not see to them
  TMSPHGhostSender ghosts;
  TMSPHDebris debris;
  TMSPHRocks rock;
  TMSPHOpeningRule opening;
  TMSPHSuspects suspects;
  TMSPHBreakEvents events;
  bool armed;         // in a step of a run, not in setup or minimization
  bool fresh;         // nothing has been tested yet, in this or an earlier run
  double relative;    // in equilibrium, of the largest load factor; else 0
  Test test;
  std::vector<Due> due_bonds;

  void follow_layout();
  void find_due(const double *stress);
  bool softening(Due &, bool looked);
  void keep_most_loaded();
  void warn_of_hot_start();
  std::vector<std::string> described(int type, int other);
  void remove(int i, int k, double energy, bool pulled, std::vector<int> &touched);
  void list_events();
  double largest_load();
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
