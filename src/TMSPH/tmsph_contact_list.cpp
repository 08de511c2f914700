/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Which pairs are in contact.
------------------------------------------------------------------------- */

#include "tmsph_contact_list.h"

#include "atom.h"
#include "domain.h"
#include "tmsph_contact_outlines.h"
#include "tmsph_contact_rows.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <tuple>
#include <utility>

using namespace LAMMPS_NS;
using namespace TMSPH;
using Record = TMSPHContactMemory::Record;

/* ----------------------------------------------------------------------
   by more than round-off, which comes in where ids have changed
------------------------------------------------------------------------- */

static bool moved(const ContactPair &was, const ContactPair &is)
{
  static constexpr double ROUND_OFF = 1.0e-9;
  double change = std::fabs(was.distance - is.distance) / is.horizon;
  for (int a = 0; a < 3; a++)
    change = std::max(change, std::fabs(was.normal_low[a] - is.normal_low[a]));
  return change > ROUND_OFF;
}

/* ---------------------------------------------------------------------- */

void TMSPHContactList::take_surfaces(const std::vector<Pairing> &before)
{
  std::sort(fresh.begin(), fresh.end());
  for (size_t n = 0; n < pairings.size(); n++) {
    const Pairing &p = pairings[n];
    const ContactPair &was = before[n].pair, &is = p.pair;
    if (p.meeting == Meeting::LATER) continue;
    if (std::binary_search(fresh.begin(), fresh.end(),
                           std::make_pair(atom->tag[p.low], atom->tag[p.high]))) {
      refits.push_back({(int) n, is});
      refits.back().before.distance = -is.horizon;    // far apart
    } else if (p.has_surface && moved(was, is))
      refits.push_back({(int) n, was});
    pairings[n].has_surface = true;
  }
  fresh.clear();
  for (const Member &m : members)
    for (int n = m.first; n < m.last; n++)
      record(m, ends[n]).geometry = pairings[ends[n].pairing].pair;
}

/* ---------------------------------------------------------------------- */

void TMSPHContactList::opened(int i, int k)
{
  fresh.push_back(std::minmax(atom->tag[i], scene.bonds->partner_tag(i, k)));
}

/* ----------------------------------------------------------------------
   the pairs of the family of local particle i: what is remembered of those that are
   still there is kept
   @return local or ghost partner of each
------------------------------------------------------------------------- */

std::vector<int> TMSPHContactList::list_records(int i, const TMSPHContactMemory &before,
                                                std::vector<Record> &records) const
{
  const FixTMSPHBond &bonds = *scene.bonds;
  std::vector<int> partners;
  for (int k = 0; k < bonds.count(i); k++) {
    if (!scene.counts(bonds.bond_state(i, k))) continue;
    const tagint partner = bonds.partner_tag(i, k);
    const int j = bonds.partner_index(i, k);
    if (j != i && !(atom->mask[j] & scene.groupbit)) continue;
    const Record *known = before.record_of(partner);
    records.push_back(known ? *known : Record{partner});
    records.back().parted = records.back().parted || j == i;
    partners.push_back(j);
  }
  return partners;
}

/* ----------------------------------------------------------------------
   in the order of the partners' ids
------------------------------------------------------------------------- */

void TMSPHContactList::list_ends(int i, const TMSPHContactMemory &memory,
                                 const std::vector<int> &partners)
{
  const int first = ends.size();
  for (int n = 0; n < (int) partners.size(); n++)
    if (!memory.records[n].parted)
      ends.push_back({partners[n], -1, atom->tag[i] < memory.records[n].partner, false, n});
  for (int n = 0; n < (int) memory.met.size(); n++) {
    const tagint partner = memory.met[n].partner;
    const int j = domain->closest_image(i, atom->map(partner));
    if (j >= 0) ends.push_back({j, -1, atom->tag[i] < partner, true, n});
  }
  std::sort(ends.begin() + first, ends.end(),
            [this](const End &a, const End &b) { return atom->tag[a.j] < atom->tag[b.j]; });
}

/* ----------------------------------------------------------------------
   most doubles that a memory takes in steps to come, as long as no pairs are added
------------------------------------------------------------------------- */

int TMSPHContactList::room(const TMSPHContactMemory &m) const
{
  const int pairs = m.records.size() + m.met.size(), pressed = m.pressed.size();
  const int most = pairs + (scene.segments ? SegmentRow::MOST_PRESSED : 0);
  return TMSPHContactMemory::size(m.records.size(), m.met.size(),
                                  scene.segments ? SegmentRow::PLACES : 0,
                                  std::max(scene.pair->keeps_touches() ? most : 0, pressed));
}

/* ----------------------------------------------------------------------
   particles with pairs or at outlines, and their ends
   @param candidates local particles in ascending order, all that may have some
   @return           most doubles of one
------------------------------------------------------------------------- */

int TMSPHContactList::list_members(const TMSPHContactOutlines *outlines,
                                   const std::vector<int> &candidates)
{
  write_back();
  TMSPHContactMemories kept;
  members.clear();
  ends.clear();
  int largest = 0;
  for (const int i : candidates) {
    if (!(atom->mask[i] & scene.groupbit)) continue;
    TMSPHContactMemory before;
    if (TMSPHContactMemory *found = memories.find(atom->tag[i])) before = std::move(*found);
    std::vector<Record> records;
    const std::vector<int> partners = list_records(i, before, records);
    const auto left_group = [&](const Record &met) {    // whose own memory ends with that
      const int j = domain->closest_image(i, atom->map(met.partner));
      return j >= 0 && !(atom->mask[j] & scene.groupbit);
    };
    before.met.erase(std::remove_if(before.met.begin(), before.met.end(), left_group),
                     before.met.end());
    if (records.empty() && before.met.empty() && !(outlines && outlines->faces(i, before.apart)))
      continue;
    TMSPHContactMemory &memory = kept.of(atom->tag[i]);
    memory = std::move(before);
    memory.records = std::move(records);
    const int first = ends.size();
    list_ends(i, memory, partners);
    members.push_back({i, kept.count() - 1, first, (int) ends.size()});
    largest = std::max(largest, room(memory));
  }
  std::swap(memories, kept);
  return largest;
}

/* ---------------------------------------------------------------------- */

Record &TMSPHContactList::record(const Member &m, const End &e)
{
  TMSPHContactMemory &own = memory(m);
  return e.later ? own.met[e.place] : own.records[e.place];
}

/* ---------------------------------------------------------------------- */

void TMSPHContactList::add_pairing(const Member &m, End &e)
{
  const int state = e.later ? -1 : scene.bonds->state_with(m.i, atom->tag[e.j]);
  const Meeting meeting = e.later       ? Meeting::LATER
      : state == FixTMSPHBond::UNBONDED ? Meeting::BODIES
                                        : Meeting::FACES;
  e.pairing = pairings.size();
  const Record &known = record(m, e);
  pairings.push_back(
      {e.low ? m.i : e.j, e.low ? e.j : m.i, meeting, false, known.has_surface(), known.past, {}});
  static_cast<PairGeometry &>(pairings.back().pair) = known.geometry;
}

/* ---------------------------------------------------------------------- */

int TMSPHContactList::make(const TMSPHContactOutlines *outlines, const std::vector<int> *touched)
{
  std::vector<int> candidates;
  if (touched && !outlines) {
    candidates = *touched;
    for (const Member &m : members) candidates.push_back(m.i);
    std::sort(candidates.begin(), candidates.end());
    candidates.erase(std::unique(candidates.begin(), candidates.end()), candidates.end());
  } else {
    candidates.resize(atom->nlocal);
    std::iota(candidates.begin(), candidates.end(), 0);
  }
  const int largest = list_members(outlines, candidates);

  // the higher end, if both are local, comes back to the pair of the lower one

  const tagint *tag = atom->tag;
  std::vector<int> member_of(atom->nlocal, -1);
  for (size_t n = 0; n < members.size(); n++) member_of[members[n].i] = n;
  pairings.clear();
  refits.clear();
  for (const Member &m : members)
    for (int n = m.first; n < m.last; n++)
      if (ends[n].low || ends[n].j >= atom->nlocal) add_pairing(m, ends[n]);
  for (const Member &m : members)
    for (int n = m.first; n < m.last; n++) {
      if (ends[n].pairing >= 0) continue;
      const Member &other = members[member_of[ends[n].j]];
      const auto end =
          std::lower_bound(ends.begin() + other.first, ends.begin() + other.last, tag[m.i],
                           [tag](const End &e, tagint id) { return tag[e.j] < id; });
      ends[n].pairing = end->pairing;
      pairings[end->pairing].both_local = true;
    }

  // restarts are written with one width for all processors

  const bool without = std::any_of(pairings.begin(), pairings.end(),
                                   [](const Pairing &p) { return !p.has_surface; });
  int mine[3] = {largest, !pairings.empty(), without};
  int all[3];
  MPI_Allreduce(mine, all, 3, MPI_INT, MPI_MAX, world);
  anywhere = all[1];
  new_faces = all[2];
  return all[0];
}

/* ---------------------------------------------------------------------- */

void TMSPHContactList::write_back()
{
  if (!ahead) return;
  ahead = false;
  for (const Member &m : members)
    for (int n = m.first; n < m.last; n++) record(m, ends[n]).past = pairings[ends[n].pairing].now;
}

/* ---------------------------------------------------------------------- */

double TMSPHContactList::bytes() const
{
  return pairings.capacity() * sizeof(Pairing) + ends.capacity() * (sizeof(End) + sizeof(Record)) +
      members.capacity() * (sizeof(Member) + sizeof(TMSPHContactMemory));
}
