/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   The sweep over the bonds that conduct heat, eight particles at a time:
     power_i = sum_j G_ij (T_j - T_i)
   G_ij = G_ji >= 0: no heat is lost, and no temperature leaves the range of
   its neighbors. Each particle sums in the order of its partners' ids.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_HEAT_SWEEP_H
#define LMP_TMSPH_HEAT_SWEEP_H

#include "tmsph_sweep.h"

namespace TMSPH {

/** @param conductance  [row][8] G_ij; with a conductivity G_ij without it
    @param temperature  of local and ghost particles
    @param conductivity of local and ghost particles, whose harmonic mean is a factor; or nullptr
    @param power        of local particles, written */
void heat_sweep(const Slices &bonds, const float *conductance, const double *temperature,
                const double *conductivity, double *power);

}    // namespace TMSPH
#endif
