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
#include "tmsph_last_force.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

/* ---------------------------------------------------------------------- */

FixTMSPHContact::FixTMSPHContact(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), pair(nullptr), bonds(nullptr), self(true), stiffness(1.0),
    any_pairs(false), resumed(false), version(-1), removals(0),
    distance_checked(false), width(0), sent_first(0),
    sent_count(0), totals{}, energy(0.0)
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
  maxexchange = exchange_size(0);
  maxexchange_dynamic = 1;
  comm_forward = 20;
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

FixTMSPHContact::~FixTMSPHContact()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
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
    if (word != "friction" && word != "self" && word != "stiffness")
      unknown(arg[iarg], "friction, self or stiffness");
    if (iarg + words > narg)
      utils::missing_cmd_args(FLERR, "fix tmsph/contact " + word, error);
    if (word == "friction") {
      int ilo, ihi, jlo, jhi;
      utils::bounds(FLERR, arg[iarg + 1], 1, atom->ntypes, ilo, ihi, error);
      utils::bounds(FLERR, arg[iarg + 2], 1, atom->ntypes, jlo, jhi, error);
      const double value = utils::numeric(FLERR, arg[iarg + 3], false, lmp);
      if (!(value >= 0.0))
        error->all(FLERR, "Fix tmsph/contact friction {} must not be negative", arg[iarg + 3]);
      for (int i = ilo; i <= ihi; i++)
        for (int j = jlo; j <= jhi; j++) friction[i][j] = friction[j][i] = value;
    }
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
  version = -1;
  TMSPHLastForce::refuse_later_forces(lmp, this);

  bool apart = false;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = i + 1; j <= atom->ntypes; j++) apart = apart || !pair->bonded(i, j);
  if (apart && bonds->formed() && bonds->count_bonds(FixTMSPHBond::UNBONDED) == 0 && comm->me == 0)
    error->warning(FLERR, "No particles of types that are not bonded stood within the horizon of "
                          "each other when the bonds formed: if bodies should touch, define fix "
                          "tmsph/contact before the first run");
}

/* ----------------------------------------------------------------------
   for one particle: number of pairs, forces and couples, then the pairs
------------------------------------------------------------------------- */

int FixTMSPHContact::exchange_size(int nrecords)
{
  return 17 + 3 * nrecords;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::pack_exchange(int i, double *buf)
{
  const auto found = memories.find(atom->tag[i]);
  if (found == memories.end()) {
    buf[0] = ubuf(-1).d;
    return 1;
  }
  const Memory &memory = found->second;
  double *p = buf;
  *p++ = ubuf((int) memory.records.size()).d;
  p = std::copy_n(memory.force, 3, p);
  p = std::copy_n(memory.stress, 6, p);
  p = std::copy_n(memory.couple, 3, p);
  p = std::copy_n(memory.couple_before, 3, p);
  *p++ = ubuf((int64_t) memory.stamp).d;
  for (const Record &r : memory.records) {
    *p++ = ubuf(r.partner).d;
    p = std::copy_n(r.moved, 2, p);
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::unpack_exchange(int nlocal, double *buf)
{
  const double *p = buf;
  const int nrecords = (int) ubuf(*p++).i;
  if (nrecords < 0) return 1;
  const auto take = [&p](double *to, int n) {
    std::copy_n(p, n, to);
    p += n;
  };
  Memory &memory = memories[atom->tag[nlocal]];
  take(memory.force, 3);
  take(memory.stress, 6);
  take(memory.couple, 3);
  take(memory.couple_before, 3);
  memory.stamp = (std::uint64_t) ubuf(*p++).i;
  memory.records.resize(nrecords);
  for (Record &r : memory.records) {
    r.partner = (tagint) ubuf(*p++).i;
    take(r.moved, 2);
  }
  return p - buf;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::write_restart(FILE *fp)
{
  TMSPHLastForce::stamp(atom, memories);
  double list[NTOTALS + 1];
  for (int n = 0; n < NTOTALS; n++) list[n] = compute_vector(n);
  list[NTOTALS] = compute_scalar();
  if (comm->me) return;
  const int size = sizeof(list);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(list, sizeof(double), NTOTALS + 1, fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::restart(char *buf)
{
  double list[NTOTALS + 1];
  memcpy(list, buf, sizeof(list));
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
  return found == memories.end() ? 2 : 1 + exchange_size(found->second.records.size());
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
