/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   States of the particles that a run cannot go on from: errors that tell why.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_STOP_H
#define LMP_TMSPH_STOP_H

#include "fix_tmsph_bond.h"
#include "tmsph_materials.h"

namespace LAMMPS_NS {

/// local particle i has no deformation gradient, or one that is inside out
void stop_inverted(class LAMMPS *, const FixTMSPHBond &, int i);
/// some particle has a thermal strain of -1 or less, or none
void stop_thermal(class LAMMPS *, const TMSPHMaterials &);

}    // namespace LAMMPS_NS

#endif
