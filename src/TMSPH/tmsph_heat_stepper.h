/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Advances temperatures in time: by explicit Euler, or RKL2 of tmsph_rkl2.h.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_STEPPER_H
#define LMP_TMSPH_HEAT_STEPPER_H

#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

class TMSPHHeatFlows;
class TMSPHHeatLedger;

class TMSPHHeatStepper : protected Pointers {
 public:
  TMSPHHeatStepper(class LAMMPS *, TMSPHHeatFlows &, TMSPHHeatLedger &);
  /// long steps, by stages of RKL2, or explicit ones only
  void set_super_steps(bool on) { rkl2 = on; }
  bool super_steps() const { return rkl2; }

  // collective

  /// temperatures of local and ghost particles, accounts, atom->heatflow
  void advance(double duration);
  /** The same over at most "most" time steps, as far as no temperature changes by more than
      "largest_change", but at least over one.
      @param time_scale time of heat over that of the run
      @return           time steps covered */
  int advance(int most, double largest_change, double time_scale);

  /// time so far
  double covered() const { return time; }
  /// largest rate of a temperature in the last advance
  double fastest_rate() const { return fastest; }

  // restart

  int comfortable_steps() const { return comfortable; }
  void restart(double covered, double fastest_rate, int comfortable_steps)
  {
    time = covered;
    fastest = fastest_rate;
    comfortable = comfortable_steps;
  }

 private:
  TMSPHHeatFlows &flows;
  TMSPHHeatLedger &ledger;
  bool rkl2 = true;
  double time = 0.0, fastest = 0.0;
  int comfortable = MAXSMALLINT / 2;    // steps of an advance that kept to its largest change
  std::vector<double> y;                // of an attempt, see flows

  void attempt(double duration);
  void commit(double duration);
  void step(double duration, std::vector<double> &);
  void super_step(double duration, std::vector<double> &);
  void euler_step(double duration, std::vector<double> &);
};

}    // namespace LAMMPS_NS

#endif
