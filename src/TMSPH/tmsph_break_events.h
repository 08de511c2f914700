/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What is told of bonds that broke: the table of events, how many.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BREAK_EVENTS_H
#define LMP_TMSPH_BREAK_EVENTS_H

#include "lmptype.h"
#include "pointers.h"

#include <vector>

namespace LAMMPS_NS {

class FixTMSPHBond;
class TMSPHMaterials;

class TMSPHBreakEvents : protected Pointers {
 public:
  static constexpr int COLUMNS = 13;
  enum Mode { TENSION, SHEAR };

  explicit TMSPHBreakEvents(class LAMMPS *lmp) : Pointers(lmp) {}
  void begin_step() { broken_now = 0; }
  /** Strain energy that bond k of local particle i carries at a stress, for small strains. */
  double strain_energy(const TMSPHMaterials &, const FixTMSPHBond &, int i, int k,
                       const double *stress) const;
  /** Bond k of local particle i breaks; to be recorded at one of its ends.
      @param energy that it takes */
  void record(const FixTMSPHBond &, int i, int k, double energy, Mode);
  /// of this processor, as LAMMPS takes it
  double **table();
  int rows() const { return events.size(); }
  /// of all processors, since the first step of all and in this step (collective)
  bigint total(Mode) const;
  double total_now() const;
  /// on processor 0: appends how many events each processor has, and the events
  void gather(std::vector<double> &list) const;
  /** Events return to the processor that they came from, so that the table keeps its order.
      @param totals of both modes
      @param nprocs processors when they were gathered
      @param list   what gather() appended */
  void restart(const double *totals, int nprocs, const char *list);
  double bytes() const { return events.capacity() * (sizeof(Event) + sizeof(double *)); }

 private:
  struct Event {
    double column[COLUMNS];
  };
  bigint broken[2] = {0, 0};    // by mode: events recorded here
  bigint broken_now = 0;
  std::vector<Event> events;
  std::vector<double *> event_rows;
};

}    // namespace LAMMPS_NS
#endif
