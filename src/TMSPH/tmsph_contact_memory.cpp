/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Memory of a particle with contacts in exchanges and restarts.
------------------------------------------------------------------------- */

#include "tmsph_contact_memory.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using TMSPH::ContactPast;
using TMSPH::PairGeometry;

static constexpr int GEOMETRY_SIZE = sizeof(PairGeometry) / sizeof(double);
static constexpr int PAST_SIZE = sizeof(ContactPast) / sizeof(double);
static constexpr int RECORD_SIZE = 1 + PAST_SIZE + GEOMETRY_SIZE;

/* ----------------------------------------------------------------------
   numbers of pairs, forces and moments, then the pairs of the reference family (a
   negative id if they parted), those that met later, anchors, and the pairs that heat passes
------------------------------------------------------------------------- */

int TMSPHContactMemory::size(int nrecords, int nmet, int nanchors, int npressed)
{
  return 25 + RECORD_SIZE * (nrecords + nmet) + 4 * nanchors + 3 * npressed;
}

/* ---------------------------------------------------------------------- */

int TMSPHContactMemory::size() const
{
  return size(records.size(), met.size(), anchors.size(), pressed.size());
}

/* ---------------------------------------------------------------------- */

int TMSPHContactMemory::pack(double *buf) const
{
  double *p = buf;
  *p++ = ubuf((int) records.size()).d;
  *p++ = ubuf((int) met.size()).d;
  *p++ = ubuf((int) anchors.size()).d;
  *p++ = ubuf((int) pressed.size()).d;
  p = std::copy_n(force, 3, p);
  p = std::copy_n(stress, 6, p);
  p = std::copy_n(tilt, 9, p);
  *p++ = ubuf((int64_t) stamp).d;
  *p++ = rubbed;
  *p++ = apart;
  for (const auto *some : {&records, &met})
    for (const Record &r : *some) {
      *p++ = ubuf(r.parted ? -r.partner : r.partner).d;
      memcpy(p, &r.past, sizeof(ContactPast));
      p += PAST_SIZE;
      memcpy(p, &r.geometry, sizeof(PairGeometry));
      p += GEOMETRY_SIZE;
    }
  for (const Anchor &anchor : anchors) {
    *p++ = ubuf(anchor.start).d;
    *p++ = ubuf(anchor.end).d;
    *p++ = anchor.along;
    *p++ = anchor.left;
  }
  for (const Pressed &one : pressed) {
    *p++ = ubuf(one.partner).d;
    *p++ = one.weight;
    *p++ = one.distance;
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

int TMSPHContactMemory::unpack(const double *buf)
{
  const double *p = buf;
  records.resize((int) ubuf(*p++).i);
  met.resize((int) ubuf(*p++).i);
  anchors.resize((int) ubuf(*p++).i);
  pressed.resize((int) ubuf(*p++).i);
  const auto take = [&p](double *to, int n) {
    std::copy_n(p, n, to);
    p += n;
  };
  take(force, 3);
  take(stress, 6);
  take(tilt, 9);
  stamp = (std::uint64_t) ubuf(*p++).i;
  rubbed = *p++;
  apart = *p++;
  for (auto *some : {&records, &met})
    for (Record &r : *some) {
      const tagint partner = (tagint) ubuf(*p++).i;
      r.parted = partner < 0;
      r.partner = r.parted ? -partner : partner;
      memcpy(&r.past, p, sizeof(ContactPast));
      p += PAST_SIZE;
      memcpy(&r.geometry, p, sizeof(PairGeometry));
      p += GEOMETRY_SIZE;
    }
  for (Anchor &anchor : anchors) {
    anchor.start = (tagint) ubuf(*p++).i;
    anchor.end = (tagint) ubuf(*p++).i;
    anchor.along = *p++;
    anchor.left = *p++;
  }
  for (Pressed &one : pressed) {
    one.partner = (tagint) ubuf(*p++).i;
    one.weight = *p++;
    one.distance = *p++;
  }
  return p - buf;
}

/* ----------------------------------------------------------------------
   after their ids have changed: those that are gone are forgotten, the others sorted
------------------------------------------------------------------------- */

template <class Pairs> static void follow_partners(Pairs &pairs)
{
  using Pair = typename Pairs::value_type;
  pairs.erase(
      std::remove_if(pairs.begin(), pairs.end(), [](const Pair &one) { return one.partner == 0; }),
      pairs.end());
  std::sort(pairs.begin(), pairs.end(),
            [](const Pair &a, const Pair &b) { return a.partner < b.partner; });
}

/* ---------------------------------------------------------------------- */

const TMSPHContactMemory::Record *TMSPHContactMemory::record_of(tagint partner) const
{
  const auto r = std::lower_bound(records.begin(), records.end(), partner,
                                  [](const Record &a, tagint id) { return a.partner < id; });
  return r != records.end() && r->partner == partner ? &*r : nullptr;
}

/* ---------------------------------------------------------------------- */

bool TMSPHContactMemory::has_met(tagint partner) const
{
  return std::any_of(met.begin(), met.end(),
                     [partner](const Record &one) { return one.partner == partner; });
}

/* ----------------------------------------------------------------------
   The same pair, oriented from its other end. The tangents there are others, in 3-D: what is along
   them is the same vector between the reference positions, turned around like r.
------------------------------------------------------------------------- */

template <int D> static void turn_around(PairGeometry &pair, ContactPast &past)
{
  double before[D - 1][D], after[D - 1][D], along[D] = {};
  TMSPH::reference_tangents<D>(pair, before);
  for (int a = 0; a < 3; a++) {
    const double low = pair.normal_low[a];
    pair.normal_low[a] = -pair.normal_high[a];
    pair.normal_high[a] = -low;
  }
  pair.depth = 1.0 - pair.depth;
  TMSPH::reference_tangents<D>(pair, after);
  for (int k = 0; k < D - 1; k++)
    for (int a = 0; a < D; a++) along[a] -= past.moved[k] * before[k][a];
  for (int k = 0; k < D - 1; k++) {
    past.moved[k] = 0.0;
    for (int a = 0; a < D; a++) past.moved[k] += along[a] * after[k][a];
  }
}

/* ----------------------------------------------------------------------
   as this particle, and each of whom it knows, got another id
------------------------------------------------------------------------- */

void TMSPHContactMemory::follow_ids(const TMSPHPresentIds &present, tagint was, tagint is,
                                    int dimension)
{
  for (auto *some : {&records, &met}) {
    for (Record &r : *some) {
      const tagint id = present(r.partner);
      if (r.has_surface() && (was < r.partner) != (is < id))
        dimension == 2 ? turn_around<2>(r.geometry, r.past) : turn_around<3>(r.geometry, r.past);
      r.partner = id;
    }
    follow_partners(*some);
  }
  for (Pressed &one : pressed) one.partner = present(one.partner);
  follow_partners(pressed);
  for (Anchor &anchor : anchors) {
    anchor.start = present(anchor.start);
    anchor.end = present(anchor.end);
  }
  anchors.erase(std::remove_if(anchors.begin(), anchors.end(),
                               [](const Anchor &a) { return !a.start || !a.end; }),
                anchors.end());
}
