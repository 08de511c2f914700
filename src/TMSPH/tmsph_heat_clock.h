/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_CLOCK_H
#define LMP_TMSPH_HEAT_CLOCK_H

namespace LAMMPS_NS {

/** What conduction of heat offers to a command that steps the thermal clock itself. */
struct TMSPHHeatClock {
  /** Advances the temperatures of local and ghost particles.
      @param duration       time to cover at most
      @param largest_change of any temperature
      @return               time covered, > 0 */
  virtual double advance(double duration, double largest_change) = 0;

 protected:
  ~TMSPHHeatClock() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

#endif
