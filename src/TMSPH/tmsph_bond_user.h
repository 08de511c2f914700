/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What the owner of the bonds asks of others.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_BOND_USER_H
#define LMP_TMSPH_BOND_USER_H

#include "tmsph_kernel.h"

namespace LAMMPS_NS {

/** What the bonds ask of the style that uses them: the pair style. */
struct TMSPHBondUser {
  /// support of the kernel of the bonds, the largest and that of two types, and who may be bonded
  virtual TMSPH::Kernel kernel_of_bonds() const = 0;
  virtual double horizon() const = 0;
  virtual double horizon(int itype, int jtype) const = 0;
  virtual bool bonded(int itype, int jtype) const = 0;
  /// true if two types without bonds may touch: pairs within the horizon are kept as UNBONDED
  virtual bool touching(int itype, int jtype) const = 0;
  /// true if forces depend on velocities
  virtual bool viscous() const = 0;
  /// velocity that viscosity took last for local particle i; nullptr if that was no step or setup
  virtual const double *step_velocity(int i) const = 0;
  /// particles may change hands next, in a step of a run
  virtual void exchange_comes() = 0;
  /// the forces of a setup are there: check and tell
  virtual void run_begins() = 0;
  /// a run or minimization is over
  virtual void run_ends() = 0;

 protected:
  ~TMSPHBondUser() = default;    // never owned through this interface
};

}    // namespace LAMMPS_NS
#endif
