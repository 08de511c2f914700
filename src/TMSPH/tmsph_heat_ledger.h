/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The books of fix tmsph/heat: what each boundary and all sources together
   brought to the body.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_LEDGER_H
#define LMP_TMSPH_HEAT_LEDGER_H

#include "pointers.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

struct TMSPHHeatBoundary;

/** Mean power in the last advance and energy so far. */
struct TMSPHHeatAccount {
  double power = 0.0, energy = 0.0;
};

/** All numbers are this processor's parts of sums over all. */
class TMSPHHeatLedger : protected Pointers {
 public:
  explicit TMSPHHeatLedger(class LAMMPS *lmp) : Pointers(lmp) {}
  /** One account for each boundary in this order, then that of the sources. A boundary keeps its
      account from run to run; those that are gone leave their energy in the sum. A restart file has
      them in the order of the fixes. */
  void open(const std::vector<TMSPHHeatBoundary *> &);
  int size() const { return accounts.size(); }
  int of_sources() const { return size() - 1; }

  const std::vector<TMSPHHeatAccount> &books() const { return accounts; }
  /// takes back what was entered since these
  void restore(const std::vector<TMSPHHeatAccount> &former) { accounts = former; }
  /// enters the energies of an advance, one for each account
  void enter(const double *energies, double duration);
  void enter_sources(double energy) { accounts[of_sources()].energy += energy; }
  void enter(const TMSPHHeatBoundary *, double energy);
  /// an empty one without this boundary
  TMSPHHeatAccount account(const TMSPHHeatBoundary *) const;
  /// of all boundaries, or of the sources, on all processors (collective)
  double total_power(bool of_sources) const;
  double total_energy(bool of_sources) const;

  // restart. The sums are with process 0 after writing, as in a run that goes on from the file: the
  // same round-off

  void append_to(std::vector<double> &list);
  /// @return what follows in the list
  const double *take_from(const double *list);
  /// doubles of a list that begins with these two
  static int length(const double *list) { return 2 + 2 * (int) list[1]; }

 private:
  std::vector<const TMSPHHeatBoundary *> boundaries;
  std::vector<std::string> ids;    // of these; none after a restart
  std::vector<TMSPHHeatAccount> accounts;
  double former_energy = 0.0;    // of boundaries that are gone

  int find(const TMSPHHeatBoundary *) const;
  double total(bool of_sources, double TMSPHHeatAccount::*what, double mine) const;
};

}    // namespace LAMMPS_NS

#endif
