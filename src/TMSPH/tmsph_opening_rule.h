/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Bonds that open instead of breaking at once: which, and when they begin. How
   they go on is in tmsph_openings.h.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_OPENING_RULE_H
#define LMP_TMSPH_OPENING_RULE_H

#include "pointers.h"
#include "tmsph_openings.h"
#include "tmsph_principal.h"

#include <memory>
#include <string>
#include <vector>

namespace LAMMPS_NS {

class PairTMSPH;
class TMSPHRocks;

class TMSPHOpeningRule : protected Pointers {
 public:
  TMSPHOpeningRule(class LAMMPS *lmp, const TMSPHRocks &rocks) : Pointers(lmp), rocks(rocks) {}
  /// in the init of a fix, which sends, after that of the rocks
  void init(PairTMSPH &, TMSPHGhostSender &);
  /** Limits of the method, when spacings are known: an error beyond them.
      @param style of the fix, to be named (collective) */
  void check(const std::string &style);
  /// nullptr where all bonds break at once
  TMSPHOpenings *openings() const { return opening.get(); }
  /// doubles per particle that are sent at most
  int most_sent() const { return opening ? opening->most_sent() : 0; }

  // in a test of bonds, with the rows of stress of local particles

  /// openings follow, and bonds to look at are found (collective)
  void follow(const double *stress);
  bool opens(int i, int j) const;
  /// bonds at local or ghost particle i are looked at
  bool near(int i) const { return looking && opening->near(i); }
  /// bond k of local particle i is open
  bool is_open(int i, int k) const { return opening->opens_bond(i, k); }
  /** Of a bond that is looked at.
      @param stress mean of its ends, in return with what their fits leave over of it
      @return       its largest principal stress */
  double pull(int i, int j, double *stress) const;
  /// it opens the crack that this stress does
  bool crosses(int i, int j, const double *stress) const { return opening->crosses(i, j, stress); }
  /// what fails in a bond with this largest principal stress is tension, which it takes by opening
  static bool is_tension(double pull, double strength);
  /// bond k of local particle i begins to open
  void begin(int i, int k, const double *stress);
  /// those that began to are known (collective)
  void complete();

  /// for outputs, and those that are finished for restart files, of this processor
  TMSPHOpeningBalance::Figures figures() const;
  TMSPHOpeningBalance::Figures finished() const;
  void resume(const TMSPHOpeningBalance::Figures &sums) { before = sums; }
  double bytes() const;

 private:
  const TMSPHRocks &rocks;
  PairTMSPH *pair = nullptr;    // since init
  FixTMSPHBond *bonds = nullptr;
  std::unique_ptr<TMSPHOpenings> opening;    // with energy or toughness
  TMSPHOpeningBalance::Figures before{};     // from a restart file
  std::vector<double> imbalance;             // of the types, since the first check
  TMSPHBondWatch damage_watch;
  std::vector<char> damaged, watched;    // of local particles: bonds are gone; looked at
  bool began = false;                    // here, in this test
  bool looking = false;                  // at bonds that may open, on some processor

  void check_horizon(const std::string &style, int type) const;
  void check_length(int type, int other) const;
  bool may_open(int i, const double *row) const;
};

}    // namespace LAMMPS_NS
#endif
