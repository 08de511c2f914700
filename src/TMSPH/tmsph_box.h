/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Ghosts while a fix changes the box: where they are, and how fast.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOX_H
#define LMP_TMSPH_BOX_H

#include "pointers.h"

namespace LAMMPS_NS {

/** A fix that changes the box does so after the forces. If it moves the particles along, ghosts
    stay where they were and outputs have to bring them to their owners. If it leaves them to their
    velocities (fix deform remap v), the box is that of the step before while forces are found:
    ghosts are a step behind and lack its rate. Nothing is sent while the box stays. */
class TMSPHBox : protected Pointers {
 public:
  TMSPHBox(class LAMMPS *lmp) : Pointers(lmp) {}
  void init();
  /// particles cross faces next, in a step of a run
  void meet_exchange();
  /// forces are found next (collective)
  void meet_forces();
  /// an output is (collective)
  void meet_output();
  /// true if velocities of ghosts differ from those of their owners
  bool carries_velocities() const;
  /** Adds the rate of the box between owners and ghosts.
      @param pbc  which image the ghosts are in
      @param list owners of n ghosts
      @param v    their velocities, n rows that are "stride" doubles apart */
  void add_rate(const int *pbc, int n, const int *list, double *v, int stride) const;

 private:
  bool changes = false;    // some fix changes the box
  double rate[3] = {};     // of its edges, in this step or the last one
  double size[3] = {};     // since when it has this size, in the last forces
  double age = 0.0;
  bigint exchanged = -1;    // on this step the box was ahead of LAMMPS

  void grow_older(bool in_step);
  void move_ghosts(double ahead);
};

}    // namespace LAMMPS_NS

#endif
