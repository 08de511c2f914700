/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.
------------------------------------------------------------------------- */

#include "tmsph_census.h"

#include "atom.h"
#include "comm.h"
#include "error.h"
#include "fix.h"
#include "modify.h"
#include "output.h"
#include "thermo.h"
#include "tmsph_collective.h"
#include "tmsph_families.h"
#include "tmsph_memories.h"
#include "update.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <unordered_map>
#include <vector>

using namespace LAMMPS_NS;

/* ----------------------------------------------------------------------
   Bonds know particles by id. LAMMPS compares only the largest id of a data
   file with the number of particles. Equal ids meet on the same processor.
------------------------------------------------------------------------- */

void TMSPHCensus::refuse_equal_ids() const
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
   on all processors; none may have come after the others had formed their bonds
------------------------------------------------------------------------- */

bigint TMSPHCensus::count_particles() const
{
  bigint mine[2] = {atom->nlocal, 0}, all[2];
  for (int i = 0; i < atom->nlocal; i++) mine[1] += families.owner_tag(i) == TMSPHFamilies::NOBODY;
  MPI_Allreduce(mine, all, 2, MPI_LMP_BIGINT, MPI_SUM, world);
  if (all[1])
    error->all(FLERR,
               "{} particles were created after the bonds had formed: create all particles before "
               "the first run, or 'clear' and start anew",
               all[1]);
  return all[0];
}

/* ---------------------------------------------------------------------- */

void TMSPHCensus::take()
{
  particles = count_particles();
  volume = total_volume();
}

/* ----------------------------------------------------------------------
   Particles that leave a box with fixed boundaries are lost. LAMMPS notices when it writes
   thermodynamic output; the bonds must know at once. Between runs some may have been deleted.
------------------------------------------------------------------------- */

void TMSPHCensus::follow_losses()
{
  const bigint present = count_particles();
  if (present == particles) return;
  if (present < atom->natoms && output->thermo->lostflag == Thermo::ERROR)
    error->all(FLERR,
               "Lost atoms: original {} current {}: they left the box before step {}; enlarge it, "
               "or go on without them by 'thermo_modify lost ignore'",
               atom->natoms, present, update->ntimestep);
  forget_missing();
  take();
}

/* ----------------------------------------------------------------------
   What the processor that has a particle answers when others ask by its id; 0 if there is none
   (collective)
------------------------------------------------------------------------- */

std::unordered_map<tagint, tagint>
TMSPHCensus::ask_all(std::vector<tagint> mine, const std::function<tagint(tagint)> &answer) const
{
  const auto unique = [](std::vector<tagint> &ids) {
    std::sort(ids.begin(), ids.end());
    ids.erase(std::unique(ids.begin(), ids.end()), ids.end());
  };
  unique(mine);
  int count = mine.size();
  std::vector<int> counts(comm->nprocs), first(comm->nprocs + 1, 0);
  MPI_Allgather(&count, 1, MPI_INT, counts.data(), 1, MPI_INT, world);
  std::partial_sum(counts.begin(), counts.end(), first.begin() + 1);
  std::vector<tagint> asked(first.back());
  MPI_Allgatherv(mine.data(), count, MPI_LMP_TAGINT, asked.data(), counts.data(), first.data(),
                 MPI_LMP_TAGINT, world);
  unique(asked);
  std::vector<tagint> here(asked.size()), anywhere(asked.size());
  std::transform(asked.begin(), asked.end(), here.begin(), answer);
  MPI_Allreduce(here.data(), anywhere.data(), here.size(), MPI_LMP_TAGINT, MPI_MAX, world);
  std::unordered_map<tagint, tagint> answers;
  for (size_t n = 0; n < asked.size(); n++) answers[asked[n]] = anywhere[n];
  return answers;
}

/* ----------------------------------------------------------------------
   Bonds to particles that are nowhere any more are forgotten, broken ones too. Those that are
   only out of reach are known to some processor.
------------------------------------------------------------------------- */

void TMSPHCensus::forget_missing()
{
  std::vector<tagint> mine;
  for (int i = 0; i < atom->nlocal; i++)
    for (int k = 0; k < families.count(i); k++)
      if (const tagint id = families.partner_tag(i, k); atom->map(id) < 0) mine.push_back(id);
  const auto present = ask_all(mine, [this](tagint id) {
    const int i = atom->map(id);
    return i >= 0 && i < atom->nlocal ? id : TMSPHFamilies::NOBODY;
  });
  for (int i = 0; i < atom->nlocal; i++)
    families.rename(i, [&](tagint id) {
      const auto found = present.find(id);
      return found == present.end() ? id : found->second;
    });
}

/* ----------------------------------------------------------------------
   the weights of the bonds and what is measured in those of the interior belong to the volumes
   with which they formed
------------------------------------------------------------------------- */

double TMSPHCensus::total_volume() const
{
  const std::vector<double> volumes(atom->vfrac, atom->vfrac + atom->nlocal);
  return TMSPH::fixed_point_sum(volumes, world);
}

/* ---------------------------------------------------------------------- */

void TMSPHCensus::refuse_other_volumes() const
{
  constexpr double AGREE = 1.0e-12;    // far above what terms lose in the common unit of the sum
  if (count_particles() != particles) return;    // some were deleted
  const double now = total_volume();
  if (std::fabs(now - volume) > AGREE * volume)    // not where that is unknown
    error->all(FLERR,
               "The volumes of the particles add up to {:.8g}, and to {:.8g} in the last run: 'set "
               "volume' before the first run, with which the bonds form, or 'clear' and start anew",
               now, volume);
}

/* ----------------------------------------------------------------------
   bonds whose partners are nowhere are forgotten: they were deleted
------------------------------------------------------------------------- */

bool TMSPHCensus::follow_ids()
{
  count_particles();    // new ones have no ids yet
  const int nlocal = atom->nlocal;
  int other = 0, renamed;
  for (int i = 0; i < nlocal; i++) other |= families.owner_tag(i) != atom->tag[i];
  MPI_Allreduce(&other, &renamed, 1, MPI_INT, MPI_MAX, world);
  if (!renamed) return false;

  former_tag.resize(nlocal + atom->nghost);
  for (int i = 0; i < nlocal; i++) former_tag[i] = families.owner_tag(i);
  comm->forward_comm(owner);
  std::unordered_map<tagint, tagint> own, present;
  for (int i = 0; i < nlocal; i++) own[former_tag[i]] = atom->tag[i];
  for (size_t i = 0; i < former_tag.size(); i++) present[former_tag[i]] = atom->tag[i];
  std::vector<tagint> far;    // partners, of broken bonds
  for (int i = 0; i < nlocal; i++)
    for (int k = 0; k < families.count(i); k++)
      if (!present.count(families.partner_tag(i, k))) far.push_back(families.partner_tag(i, k));
  present.merge(ask_all(far, [&own](tagint id) {
    const auto found = own.find(id);
    return found == own.end() ? TMSPHFamilies::NOBODY : found->second;
  }));
  const auto present_of = [&present](tagint id) {
    const auto found = present.find(id);
    return found == present.end() ? TMSPHFamilies::NOBODY : found->second;
  };
  for (int i = 0; i < nlocal; i++) {
    families.rename(i, present_of);
    families.set_owner_tag(i, atom->tag[i]);
  }
  for (const auto &fix : modify->get_fix_list())
    if (const auto other = dynamic_cast<TMSPHStoresIds *>(fix)) other->follow_ids(present_of);
  former_tag.clear();
  return true;
}

/* ---------------------------------------------------------------------- */

int TMSPHCensus::pack(int n, const int *list, double *buf) const
{
  for (int ii = 0; ii < n; ii++) buf[ii] = ubuf(former_tag[list[ii]]).d;
  return n;
}

void TMSPHCensus::unpack(int n, int first, const double *buf)
{
  for (int ii = 0; ii < n; ii++) former_tag[first + ii] = (tagint) ubuf(buf[ii]).i;
}
