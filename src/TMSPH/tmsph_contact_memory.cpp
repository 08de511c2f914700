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

/* ----------------------------------------------------------------------
   numbers of pairs, forces and moments, then the pairs of the reference family (a
   negative id if they parted), those that met later, anchors, and the pairs that heat passes
------------------------------------------------------------------------- */

int TMSPHContactMemory::size(int nrecords, int nmet, int nanchors, int npressed)
{
  return 25 + (1 + PAST_SIZE) * nrecords + (1 + PAST_SIZE + GEOMETRY_SIZE) * nmet + 4 * nanchors +
      3 * npressed;
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
  for (const Record &r : records) {
    *p++ = ubuf(r.parted ? -r.partner : r.partner).d;
    memcpy(p, &r.past, sizeof(ContactPast));
    p += PAST_SIZE;
  }
  for (const Met &one : met) {
    *p++ = ubuf(one.partner).d;
    memcpy(p, &one.past, sizeof(ContactPast));
    p += PAST_SIZE;
    memcpy(p, &one.geometry, sizeof(PairGeometry));
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
  for (Record &r : records) {
    const tagint partner = (tagint) ubuf(*p++).i;
    r.parted = partner < 0;
    r.partner = r.parted ? -partner : partner;
    memcpy(&r.past, p, sizeof(ContactPast));
    p += PAST_SIZE;
  }
  for (Met &one : met) {
    one.partner = (tagint) ubuf(*p++).i;
    memcpy(&one.past, p, sizeof(ContactPast));
    p += PAST_SIZE;
    memcpy(&one.geometry, p, sizeof(PairGeometry));
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
                     [partner](const Met &one) { return one.partner == partner; });
}
