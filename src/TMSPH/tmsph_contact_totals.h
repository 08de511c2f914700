/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Sums over all places of a contact or a wall in a step.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_CONTACT_TOTALS_H
#define LMP_TMSPH_CONTACT_TOTALS_H

#include <algorithm>
#include <mpi.h>

namespace LAMMPS_NS {

/** Of this processor. */
class TMSPHContactTotals {
 public:
  /// force, torque, work lost by friction so far, how many touch, deepest penetration, sum of the
  /// normal forces
  enum { FORCE = 0, TORQUE = 3, WORK = 6, TOUCHING, DEEPEST, NORMAL, COUNT };
  double &operator[](int n) { return values[n]; }
  double energy = 0.0;    ///< stored in the contacts

  /// a new step: all but the work starts again
  void start()
  {
    const double work = values[WORK];
    std::fill_n(values, (int) COUNT, 0.0);
    values[WORK] = work;
    energy = 0.0;
  }
  /// friction at a place
  void add_place(double work, double penetration, double stored)
  {
    values[WORK] += work;
    values[DEEPEST] = std::max(values[DEEPEST], penetration);
    energy += stored;
  }
  /// of all processors (collective)
  double of_all(int n, MPI_Comm world) const
  {
    double all;
    MPI_Allreduce(&values[n], &all, 1, MPI_DOUBLE, n == DEEPEST ? MPI_MAX : MPI_SUM, world);
    return all;
  }
  double energy_of_all(MPI_Comm world) const
  {
    double all;
    MPI_Allreduce(&energy, &all, 1, MPI_DOUBLE, MPI_SUM, world);
    return all;
  }

 private:
  double values[COUNT] = {};
};

}    // namespace LAMMPS_NS
#endif
