/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words, checks, migration and restart of fix tmsph/contact.
------------------------------------------------------------------------- */

#include "fix_tmsph_contact.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "force.h"
#include "modify.h"
#include "region.h"
#include "tmsph_last_force.h"
#include "tmsph_restart.h"
#include "tmsph_types.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using TMSPH::ContactPast;
using TMSPH::PairGeometry;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 3.0;

/* ---------------------------------------------------------------------- */

FixTMSPHContact::FixTMSPHContact(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), bonds(nullptr), self(true),
    law(TMSPH::CONTACT_LAWS[0]), stiffness(1.0),
    records_behind(false), any_pairs(false), resumed(false), version(-1), removals(0),
    distance_checked(false), sides_checked(false), surfaces_version(-1), surfaces_removals(0),
    last_search(0), next_search(0), search_dt(0.0), width(0), sent_first(0), sent_count(0),
    velocities_sent(-1), totals{}, energy(0.0)
{
  friction.assign(atom->ntypes + 1, std::vector<double>(atom->ntypes + 1, 0.0));
  parse(narg, arg);
  scalar_flag = vector_flag = 1;
  size_vector = NTOTALS;
  global_freq = 1;
  extscalar = extvector = 1;
  energy_global_flag = virial_global_flag = virial_peratom_flag = 1;
  thermo_virial = 1;
  restart_global = restart_peratom = 1;
  stores_ids = 1;
  maxexchange = exchange_size(0, 0, 0, 0);
  maxexchange_dynamic = 1;
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

FixTMSPHContact::~FixTMSPHContact()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
  auto user = force ? dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0)) : nullptr;
  if (user && user->contact_of_surfaces() == this) user->set_contact(nullptr);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::parse(int narg, char **arg)
{
  const auto unknown = [&](const char *word, const char *known) {
    error->all(FLERR, "Unknown word '{}' of fix tmsph/contact: use {}", word, known);
  };
  int iarg = 3;
  while (iarg < narg) {
    const std::string word = arg[iarg];
    const int words = word == "friction" ? 4 : 2;
    if (word != "friction" && word != "self" && word != "stiffness" && word != "surface" &&
        word != "law" && word != "method")
      unknown(arg[iarg], "friction, law, method, self, stiffness or surface");
    if (iarg + words > narg)
      utils::missing_cmd_args(
          FLERR, "fix tmsph/contact " + word + (word == "friction" ? " I J mu" : ""), error);
    if (word == "friction") {
      int ilo, ihi, jlo, jhi;
      const std::string what = "Fix tmsph/contact friction", usage = "friction * * mu";
      TMSPH::read_types(lmp, what, usage, arg[iarg + 1], ilo, ihi);
      TMSPH::read_types(lmp, what, usage, arg[iarg + 2], jlo, jhi);
      const double value = utils::numeric(FLERR, arg[iarg + 3], false, lmp);
      if (!(value >= 0.0))
        error->all(FLERR, "Fix tmsph/contact friction {} must not be negative", arg[iarg + 3]);
      for (int i = ilo; i <= ihi; i++)
        for (int j = jlo; j <= jhi; j++) friction[i][j] = friction[j][i] = value;
    }
    if (word == "method") {
      const std::string name = arg[iarg + 1];
      if (name != "kernel" && name != "segment")
        error->all(FLERR, "Unknown method '{}' of fix tmsph/contact: use kernel or segment", name);
      if (name == "segment" && domain->dimension == 3)
        error->all(FLERR, "Fix tmsph/contact method segment needs dimension 2: use method kernel "
                          "in 3-D");
      segments.reset(name == "segment" ? new Segments : nullptr);
    }
    if (word == "law") {
      const TMSPH::ContactLaw *known = TMSPH::contact_law(arg[iarg + 1]);
      if (!known)
        error->all(FLERR, "Unknown law '{}' of fix tmsph/contact: use {}", arg[iarg + 1],
                   TMSPH::contact_laws());
      law = *known;
    }
    if (word == "surface") region_ids.push_back(arg[iarg + 1]);
    if (word == "self") self = utils::logical(FLERR, arg[iarg + 1], false, lmp);
    if (word == "stiffness") {
      stiffness = utils::numeric(FLERR, arg[iarg + 1], false, lmp);
      if (!(stiffness > 0.0))
        error->all(FLERR, "Fix tmsph/contact stiffness {} must be positive: it is a factor to the "
                          "default", arg[iarg + 1]);
    }
    iarg += words;
  }
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::setmask()
{
  return PRE_FORCE | POST_FORCE | MIN_POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::init()
{
  pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix tmsph/contact needs pair style tmsph");
  if (modify->get_fix_by_style("^tmsph/contact$").size() > 1)
    error->all(FLERR, "More than one fix tmsph/contact: give all types in a single one");
  bonds = pair->bonds();
  pair->set_contact(this);
  prescribing = TMSPHLastForce::prescribing(lmp);
  comm_forward = MOST_SENT;    // for LAMMPS's buffers; send() changes it
  bool bodies = false;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = 1; j < i; j++) bodies = bodies || !pair->bonded(i, j);
  if (bodies && bonds->formed() && !bonds->formed_with_contact() && comm->me == 0)
    error->warning(FLERR,
                   "Fix tmsph/contact {} was defined after the first run: bodies that stood "
                   "against each other there touch from where they are when it finds them; define "
                   "it before",
                   id);
  version = surfaces_version = -1;
  regions.clear();
  if (segments && !region_ids.empty())
    error->all(FLERR, "Fix tmsph/contact surface is for method kernel: method segment takes the "
                      "outlines of the bodies");
  for (const std::string &name : region_ids) {
    Region *region = domain->get_region_by_id(name);
    if (!region)
      error->all(FLERR, "Region {} of fix tmsph/contact surface does not exist: define it with the "
                        "command region", name);
    if (region->dynamic || region->varshape)
      error->all(FLERR,
                 "Region {} of fix tmsph/contact surface moves: give the surface of a body in "
                 "the reference positions; it then moves with the body",
                 name);
    regions.push_back(region);
  }
}

/* ----------------------------------------------------------------------
   for one particle: numbers of pairs, forces and moments, then the pairs of the
   reference family (a negative id if they parted), those that met later and those that
   heat passes
------------------------------------------------------------------------- */

static constexpr int GEOMETRY_SIZE = sizeof(PairGeometry) / sizeof(double);
static constexpr int PAST_SIZE = sizeof(ContactPast) / sizeof(double);

int FixTMSPHContact::exchange_size(int nrecords, int nmet, int nanchors, int npressed)
{
  return 25 + (1 + PAST_SIZE) * nrecords + (1 + PAST_SIZE + GEOMETRY_SIZE) * nmet +
      4 * nanchors + 3 * npressed;
}

/* ----------------------------------------------------------------------
   @param at_most in steps to come, as long as no pairs are added
------------------------------------------------------------------------- */

int FixTMSPHContact::exchange_size(const Memory &m, bool at_most) const
{
  const int ends = m.records.size() + m.met.size() + (segments ? PRESSED_AT_SEGMENTS : 0);
  const int pressed = m.pressed.size(), anchors = m.anchors.size();
  return at_most
      ? exchange_size(m.records.size(), m.met.size(), segments ? TMSPH::SegmentRow::PLACES : 0,
                      std::max(pair->keeps_touches() ? ends : 0, pressed))
      : exchange_size(m.records.size(), m.met.size(), anchors, pressed);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::pack_exchange(int i, double *buf)
{
  write_back();
  const auto found = memories.find(atom->tag[i]);
  if (found == memories.end()) {
    buf[0] = ubuf(-1).d;
    return 1;
  }
  const Memory &memory = found->second;
  double *p = buf;
  *p++ = ubuf((int) memory.records.size()).d;
  *p++ = ubuf((int) memory.met.size()).d;
  *p++ = ubuf((int) memory.anchors.size()).d;
  *p++ = ubuf((int) memory.pressed.size()).d;
  p = std::copy_n(memory.force, 3, p);
  p = std::copy_n(memory.stress, 6, p);
  p = std::copy_n(memory.tilt, 9, p);
  *p++ = ubuf((int64_t) memory.stamp).d;
  *p++ = memory.rubbed;
  *p++ = memory.apart;
  for (const Record &r : memory.records) {
    *p++ = ubuf(r.parted ? -r.partner : r.partner).d;
    memcpy(p, &r.past, sizeof(ContactPast));
    p += PAST_SIZE;
  }
  for (const Met &met : memory.met) {
    *p++ = ubuf(met.partner).d;
    memcpy(p, &met.past, sizeof(ContactPast));
    p += PAST_SIZE;
    memcpy(p, &met.geometry, sizeof(PairGeometry));
    p += GEOMETRY_SIZE;
  }
  for (const Anchor &anchor : memory.anchors) {
    *p++ = ubuf(anchor.start).d;
    *p++ = ubuf(anchor.end).d;
    *p++ = anchor.along;
    *p++ = anchor.left;
  }
  for (const Pressed &pressed : memory.pressed) {
    *p++ = ubuf(pressed.partner).d;
    *p++ = pressed.weight;
    *p++ = pressed.distance;
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::unpack_exchange(int nlocal, double *buf)
{
  const double *p = buf;
  const int nrecords = (int) ubuf(*p++).i;
  if (nrecords < 0) return 1;
  const int nmet = (int) ubuf(*p++).i;
  const int nanchors = (int) ubuf(*p++).i;
  const int npressed = (int) ubuf(*p++).i;
  const auto take = [&p](double *to, int n) {
    std::copy_n(p, n, to);
    p += n;
  };
  Memory &memory = memories[atom->tag[nlocal]];
  take(memory.force, 3);
  take(memory.stress, 6);
  take(memory.tilt, 9);
  memory.stamp = (std::uint64_t) ubuf(*p++).i;
  memory.rubbed = *p++;
  memory.apart = *p++;
  memory.records.resize(nrecords);
  for (Record &r : memory.records) {
    const tagint partner = (tagint) ubuf(*p++).i;
    r.parted = partner < 0;
    r.partner = r.parted ? -partner : partner;
    memcpy(&r.past, p, sizeof(ContactPast));
    p += PAST_SIZE;
  }
  memory.met.resize(nmet);
  for (Met &met : memory.met) {
    met.partner = (tagint) ubuf(*p++).i;
    memcpy(&met.past, p, sizeof(ContactPast));
    p += PAST_SIZE;
    memcpy(&met.geometry, p, sizeof(PairGeometry));
    p += GEOMETRY_SIZE;
  }
  memory.anchors.resize(nanchors);
  for (Anchor &anchor : memory.anchors) {
    anchor.start = (tagint) ubuf(*p++).i;
    anchor.end = (tagint) ubuf(*p++).i;
    anchor.along = *p++;
    anchor.left = *p++;
  }
  memory.pressed.resize(npressed);
  for (Pressed &pressed : memory.pressed) {
    pressed.partner = (tagint) ubuf(*p++).i;
    pressed.weight = *p++;
    pressed.distance = *p++;
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::write_restart(FILE *fp)
{
  TMSPHLastForce::stamp(lmp, memories);
  std::vector<double> list = {RESTART_FORMAT, (double) exchange_size(1, 1, 1, 1)};
  for (int n = 0; n < NTOTALS; n++) list.push_back(compute_vector(n));
  list.insert(list.end(), {compute_scalar(), ubuf(last_search).d, ubuf(next_search).d, search_dt,
                           segments && segments->measured ? 1.0 : 0.0});
  if (comm->me) return;
  const int size = list.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list.data(), sizeof(double), list.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::restart(char *buf)
{
  double format[2], list[NTOTALS + 5];
  memcpy(format, buf, sizeof(format));
  check_restart_format(error, "fix tmsph/contact", format[0], RESTART_FORMAT);
  check_restart_format(error, "fix tmsph/contact", (int) format[1], exchange_size(1, 1, 1, 1));
  memcpy(list, buf + sizeof(format), sizeof(list));
  last_search = (bigint) ubuf(list[NTOTALS + 1]).i;
  next_search = (bigint) ubuf(list[NTOTALS + 2]).i;
  search_dt = list[NTOTALS + 3];
  if (segments) segments->measured = list[NTOTALS + 4] != 0.0;
  if (comm->me) return;
  std::copy_n(list, (int) NTOTALS, totals);
  energy = list[NTOTALS];
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);    // LAMMPS wants the length first
  return 1 + pack_exchange(i, buf + 1);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::unpack_restart(int nlocal, int nth)
{
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(*extra);
  unpack_exchange(nlocal, extra + 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::size_restart(int i)
{
  const auto found = memories.find(atom->tag[i]);
  return found == memories.end() ? 2 : 1 + exchange_size(found->second, false);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::maxsize_restart()
{
  return 1 + maxexchange;
}

/* ---------------------------------------------------------------------- */

double FixTMSPHContact::memory_usage()
{
  return pairings.capacity() * sizeof(Pairing) + ends.capacity() * (sizeof(End) + sizeof(Record)) +
      members.capacity() * (sizeof(Member) + sizeof(Memory)) + rows.capacity() * sizeof(double);
}
