/* -*- c++ -*- ----------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What forces that predict the step from all others have in common: they act
   last, wherever the input defines them, and a continued run takes those of its
   last step again, since at a setup velocities are those of the full step and
   not of half a step before.
------------------------------------------------------------------------- */

#ifndef LMP_TMSPH_LAST_FORCE_H
#define LMP_TMSPH_LAST_FORCE_H

#include "atom.h"
#include "domain.h"
#include "lammps.h"
#include "tmsph_fingerprint.h"

#include <algorithm>
#include <mpi.h>
#include <vector>

namespace LAMMPS_NS {

class Fix;

namespace TMSPHLastForce {

/** Puts fixes that predict the step behind all others that act on forces, before LAMMPS lists
      which fix acts when: contact, then walls by their ids, then those that prescribe forces, like
      setforce, unless others act on the same particles after them; then those that only act at
      the end of steps, which may look at the former. All others stay in the order of the input. */
void put_last(class LAMMPS *);

/** Fixes that prescribe forces after the package's have acted. */
std::vector<Fix *> prescribing(class LAMMPS *);

/** While it lives forces are those that such fixes would make of them. */
class Prescribed {
 public:
  Prescribed(class LAMMPS *, const std::vector<Fix *> &);
  ~Prescribed();
  Prescribed(const Prescribed &) = delete;

 private:
  double **const f;
  std::vector<double> before;
};

/** Of a particle, the same in a run and after LAMMPS has put it back into the box, by the
      operations of Domain::pbc(). */
inline std::uint64_t fingerprint(const LAMMPS *lmp, int i)
{
  const Domain *domain = lmp->domain;
  double x[3];
  for (int k = 0; k < 3; k++) {
    x[k] = lmp->atom->x[i][k];
    if (!domain->periodicity[k]) continue;
    if (x[k] < domain->boxlo[k]) x[k] += domain->prd[k];
    if (x[k] >= domain->boxhi[k]) x[k] = std::max(x[k] - domain->prd[k], domain->boxlo[k]);
  }
  return TMSPH::fingerprint(x, lmp->atom->v[i]);
}

/// notes positions and velocities; Memories: TMSPHMemories of structs with a "stamp"
template <class Memories> void stamp(const LAMMPS *lmp, Memories &memories)
{
  for (int i = 0; i < lmp->atom->nlocal; i++) {
    auto *memory = memories.find(lmp->atom->tag[i]);
    if (memory) memory->stamp = fingerprint(lmp, i);
  }
}

/// true if they are still those noted, on all processors (collective)
template <class Memories> bool untouched(const LAMMPS *lmp, const Memories &memories)
{
  int same = 1, all_same;
  for (int i = 0; i < lmp->atom->nlocal; i++) {
    const auto *memory = memories.find(lmp->atom->tag[i]);
    if (memory && memory->stamp != fingerprint(lmp, i)) same = 0;
  }
  MPI_Allreduce(&same, &all_same, 1, MPI_INT, MPI_MIN, lmp->world);
  return all_same;
}

}    // namespace TMSPHLastForce
}    // namespace LAMMPS_NS

#endif
