/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What forces that predict the step from all others have in common: they act
   last, and a continued run takes those of its last step again, since at a
   setup velocities are those of the full step and not of half a step before.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_LAST_FORCE_H
#define LMP_TMSPH_LAST_FORCE_H

#include "atom.h"
#include "tmsph_fingerprint.h"

#include <mpi.h>

namespace LAMMPS_NS {

class Fix;

namespace TMSPHLastForce {

  /// an error if a fix defined after this one adds forces, unless it is of this package
  void refuse_later_forces(class LAMMPS *, const Fix *);

  /// notes positions and velocities; Memories: map from ids to structs with a "stamp"
  template <class Memories> void stamp(Atom *atom, Memories &memories)
  {
    for (int i = 0; i < atom->nlocal; i++) {
      const auto found = memories.find(atom->tag[i]);
      if (found != memories.end())
        found->second.stamp = TMSPH::fingerprint(atom->x[i], atom->v[i]);
    }
  }

  /// true if they are still those noted, on all processors (collective)
  template <class Memories> bool untouched(Atom *atom, const Memories &memories, MPI_Comm world)
  {
    int same = 1, all_same;
    for (int i = 0; i < atom->nlocal; i++) {
      const auto found = memories.find(atom->tag[i]);
      if (found == memories.end()) continue;
      if (found->second.stamp != TMSPH::fingerprint(atom->x[i], atom->v[i])) same = 0;
    }
    MPI_Allreduce(&same, &all_same, 1, MPI_INT, MPI_MIN, world);
    return all_same;
  }

}    // namespace TMSPHLastForce
}    // namespace LAMMPS_NS

#endif
