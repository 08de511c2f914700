/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Numbers that are allowed but make no sense, each with the remedy. All of these
   are collective.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_DOUBTS_H
#define LMP_TMSPH_DOUBTS_H

#include "tmsph_inventory.h"
#include "tmsph_materials.h"
#include "tmsph_notes.h"

#include <string>

namespace LAMMPS_NS {

/// an error, before neighbor lists are made with it, if the horizon was given in spacings
void check_reach(class LAMMPS *, double horizon);
/** @return the first doubt, or nothing; what is derived from the same numbers is not blamed then */
std::string find_doubt(class LAMMPS *, const TMSPHMaterials &, const TMSPHInventory &,
                       double thickness);
/// warns of fixes that act on nobody
void check_groups(class LAMMPS *, TMSPHNotes &);

}    // namespace LAMMPS_NS

#endif
