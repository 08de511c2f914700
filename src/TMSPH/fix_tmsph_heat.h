/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   fix tmsph/heat: conduction of heat over the intact reference bonds. It hands
   what LAMMPS asks to its parts: the network of conductances, what flows in it and
   to it, the stepper, the ledger.
------------------------------------------------------------------------- */

#ifdef FIX_CLASS
// clang-format off
FixStyle(tmsph/heat,FixTMSPHHeat);
// clang-format on
#else

#ifndef LMP_FIX_TMSPH_HEAT_H
#define LMP_FIX_TMSPH_HEAT_H

#include "fix.h"
#include "tmsph_ghost_rows.h"
#include "tmsph_heat_clock.h"
#include "tmsph_heat_contacts.h"
#include "tmsph_heat_flows.h"
#include "tmsph_heat_ledger.h"
#include "tmsph_heat_materials.h"
#include "tmsph_heat_network.h"
#include "tmsph_heat_sources.h"
#include "tmsph_heat_stepper.h"
#include "tmsph_report.h"

#include <string>
#include <vector>

namespace LAMMPS_NS {

class FixTMSPHHeat : public Fix, public TMSPHHeatClock, public TMSPHReporter {
 public:
  FixTMSPHHeat(class LAMMPS *, int, char **);
  ~FixTMSPHHeat() override;
  int setmask() override;
  void post_constructor() override { network.keep(id); }
  void init() override;
  void setup_pre_force(int) override;
  void pre_force(int) override;
  void end_of_step() override;
  double compute_scalar() override;
  double compute_vector(int) override;
  double memory_usage() override;
  int pack_forward_comm(int, int *, double *, int, int *) override;
  void unpack_forward_comm(int, int, double *) override;
  void grow_arrays(int nmax) override { network.faces().grow(nmax); }
  void copy_arrays(int i, int j, int) override { network.faces().copy(i, j); }
  void set_arrays(int i) override { network.faces().clear(i); }
  int pack_exchange(int, double *) override;
  int unpack_exchange(int, double *) override;
  void write_restart(FILE *) override;
  void restart(char *) override;
  int pack_restart(int, double *) override;
  void unpack_restart(int, int) override;
  int size_restart(int) override;
  int maxsize_restart() override;

  void tell() override;
  int reach(int most, double /*largest_change*/) override { return most; }
  int advance(int most, double largest_change) override;

  // for boundaries

  const TMSPHHeatMaterials &properties() const { return materials; }
  const TMSPHHeatNetwork &body() const { return network; }
  TMSPHHeatLedger &books() { return ledger; }
  /// the time step of the next heat step
  bigint next_step() const { return flows.next_step(); }

 private:
  class PairTMSPH *pair;
  TMSPHGhostSender ghosts;
  TMSPHHeatMaterials materials;
  TMSPHHeatSources sources;
  TMSPHHeatContacts contacts;
  TMSPHHeatNetwork network;
  TMSPHHeatFlows flows;
  TMSPHHeatLedger ledger;
  TMSPHHeatStepper stepper;
  int every;
  double time_scale;
  bool viscous;    // its work heats
  bool told;

  void parse(int, char **);
  double find_diffusivities(class TMSPH::TextTable &, bool &strange);
  void warn_of_time_scale(double step, double diffusivity);
};

}    // namespace LAMMPS_NS

#endif
#endif
