/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Shape matrices: what the sweeps need of a particle besides its bonds.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_SHAPE_H
#define LMP_TMSPH_SHAPE_H

#include "tmsph_sweep.h"

namespace TMSPH {

/** Of a particle in the sweeps; chi is that of a shape matrix that is not singular. */
struct ParticleConstants {
  double volume, lambda, shear, chi;
};

/** Constants of the particle in lane l of slice q from its remaining bonds: Kbar^-1 V lambda mu
    chi; Kbar^-1 and chi are 0 where Kbar is singular.
    @param kinematic rows of local and ghost particles
    @param kappa     tr K/D of the interior of the intact body */
template <int D>
void update_shape(Slices &bonds, int q, int l, const double *kinematic, double kappa,
                  const ParticleConstants &m);

}    // namespace TMSPH
#endif
