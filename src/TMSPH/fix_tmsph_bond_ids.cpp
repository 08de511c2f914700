/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Do ids tell particles apart, and are the particles still those of the bonds:
   new ones, new ids, other places in the arrays.
------------------------------------------------------------------------- */

#include "fix_tmsph_bond.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "modify.h"

#include <algorithm>
#include <cmath>
#include <unordered_map>
#include <vector>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   Bonds know particles by id. LAMMPS compares only the largest id of a data
   file with the number of particles. Equal ids meet on the same processor.
------------------------------------------------------------------------- */

void FixTMSPHBond::refuse_equal_ids() const
{
  const int nlocal = atom->nlocal;
  std::vector<int> destination(nlocal);
  for (int i = 0; i < nlocal; i++) destination[i] = atom->tag[i] % comm->nprocs;
  tagint twice = 0, largest_twice;
  const auto find_equal = [](int n, char *received, int &answer, int *&, char *&, void *result) {
    tagint *const ids = reinterpret_cast<tagint *>(received);
    std::sort(ids, ids + n);
    const tagint *const found = std::adjacent_find(ids, ids + n);
    if (found != ids + n) *static_cast<tagint *>(result) = *found;
    return answer = 0;
  };
  constexpr int ALL_TO_ALL = 1;
  char *none;
  comm->rendezvous(ALL_TO_ALL, nlocal, reinterpret_cast<char *>(atom->tag), sizeof(tagint), 0,
                   destination.data(), find_equal, 0, none, 0, &twice);
  MPI_Allreduce(&twice, &largest_twice, 1, MPI_LMP_TAGINT, MPI_MAX, world);
  if (largest_twice)
    error->all(FLERR,
               "Several particles have the id {}: each needs its own; 'reset_atoms id' right after "
               "read_data gives all new ones",
               largest_twice);
}

/* ----------------------------------------------------------------------
   particles that came after the others had formed their bonds
------------------------------------------------------------------------- */

void FixTMSPHBond::refuse_strangers() const
{
  bigint strangers = 0, all;
  for (int i = 0; i < atom->nlocal; i++) strangers += own_tag[i] == 0;
  MPI_Allreduce(&strangers, &all, 1, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all)
    error->all(FLERR,
               "{} particles were created after the bonds had formed: create all particles before "
               "the first run, or 'clear' and start anew",
               all);
}

/* ----------------------------------------------------------------------
   LAMMPS refuses reset_atoms id by itself as long as there are such fixes, but not the
   compression of ids by delete_atoms
------------------------------------------------------------------------- */

void FixTMSPHBond::refuse_new_ids() const
{
  for (const auto &fix : modify->get_fix_list()) {
    const auto other = dynamic_cast<const TMSPHStoresIds *>(fix);
    if (!other) continue;
    int mine = other->has_ids();
    int any;
    MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
    if (any)
      error->all(FLERR,
                 "Particles got new ids since the last run, by which fix {} {} knows what touches: "
                 "use 'delete_atoms ... compress no'",
                 fix->style, fix->id);
  }
}

/* ----------------------------------------------------------------------
   reset_atoms id and delete_atoms with compression give particles new ids:
   follow them, as long as the partners are still within reach. The bonds of
   deleted particles are forgotten.
------------------------------------------------------------------------- */

void FixTMSPHBond::follow_ids()
{
  const int nlocal = atom->nlocal;
  int other = 0, renamed;
  for (int i = 0; i < nlocal; i++) other |= own_tag[i] != atom->tag[i];
  MPI_Allreduce(&other, &renamed, 1, MPI_INT, MPI_MAX, world);
  const bool deleted = atom->natoms < natoms_at_setup;
  if (!renamed && !deleted) return;
  if (renamed) refuse_new_ids();

  former_tag.assign(own_tag, own_tag + nlocal);
  former_tag.resize(nlocal + atom->nghost);
  what_to_send = TAG;
  comm->forward_comm(this);
  what_to_send = REFERENCE;
  std::unordered_map<tagint, tagint> present;
  for (size_t i = 0; i < former_tag.size(); i++) present[former_tag[i]] = atom->tag[i];
  for (int i = 0; i < nlocal; i++) {
    std::vector<std::pair<tagint, unsigned char>> kept;
    for (int k = 0; k < npartner[i]; k++) {
      const auto found = present.find(partner[i][k]);
      if (found != present.end())
        kept.emplace_back(found->second, state[i][k]);
      else if (!renamed && state[i][k] != INTACT)
        kept.emplace_back(partner[i][k], state[i][k]);    // not deleted, perhaps: out of reach
    }
    std::sort(kept.begin(), kept.end());
    npartner[i] = kept.size();
    for (int k = 0; k < npartner[i]; k++) {
      partner[i][k] = kept[k].first;
      state[i][k] = kept[k].second;
    }
    own_tag[i] = atom->tag[i];
  }
  former_tag.clear();
}

/* ----------------------------------------------------------------------
   A partner that is near, but not in the reference frame, has another image flag than when the
   bonds formed, and did not move by a period.
------------------------------------------------------------------------- */

void FixTMSPHBond::refuse_changed_images(int i, tagint partner) const
{
  for (int j = atom->map(partner); j >= 0; j = atom->sametag[j]) {
    double r2 = 0.0;
    for (int k = 0; k < 3; k++) r2 += std::pow(atom->x[j][k] - atom->x[i][k], 2);
    if (r2 < horizon * horizon)
      error->one(FLERR,
                 "Particles {} and {}, which are bonded, have image flags that were changed since "
                 "the bonds formed: do without 'set image' and 'reset_atoms image', or use them "
                 "before the first run",
                 atom->tag[i], partner);
  }
}

/* ----------------------------------------------------------------------
   what outputs find by local and ghost indices was laid out when ghosts came last;
   between runs particles may have gone to other places since (collective)
------------------------------------------------------------------------- */

void FixTMSPHBond::need_layout(const std::string &who) const
{
  const int nall = atom->nlocal + atom->nghost;
  int mine = !laid_out || xref.size() != 3 * (size_t) nall;
  int any;
  MPI_Allreduce(&mine, &any, 1, MPI_INT, MPI_MAX, world);
  if (any)
    error->all(FLERR, "{} after particles were created, deleted or displaced: do a 'run 0' first",
               who);
}
