/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a fix that changes temperatures offers to quasi-static stepping, which
   advances the thermal clock by as many time steps at once as it can.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_CLOCK_H
#define LMP_TMSPH_HEAT_CLOCK_H

namespace LAMMPS_NS {

struct TMSPHHeatClock {
  /** How far temperatures may be known ahead, without changing them.
      @return time steps from the present one, 1 to "most", over which none of those that this fix
      prescribes changes by more than "largest_change"; 1 if the first step already does */
  virtual int reach(int most, double largest_change) = 0;

  /** Advances temperatures from update->ntimestep, which stays as it is, by at most "most" steps of
      update->dt, as far as none changes by more than "largest_change", but at least by one. They
      are those of the new step on return, those of ghosts too. A fix that sets them in
      min_pre_force has nothing to do.
      @return time steps covered, the same on all processors and for any number of them */
  virtual int advance(int most, double /*largest_change*/) { return most; }

 protected:
  ~TMSPHHeatClock() = default;    // owned as a fix, never through this interface
};

}    // namespace LAMMPS_NS

#endif
