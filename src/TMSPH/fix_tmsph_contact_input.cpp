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
#include "tmsph_faces.h"
#include "tmsph_last_force.h"
#include "tmsph_restart.h"
#include "tmsph_words.h"
#include "update.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 4.0;

/* ---------------------------------------------------------------------- */

FixTMSPHContact::FixTMSPHContact(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), ghosts(lmp, this), list(lmp, scene, memories), surfaces(lmp, scene),
    fits(lmp, scene, surfaces, ghosts), search(lmp, scene, list, memories, surfaces, ghosts),
    forces(lmp, scene, list, ghosts, totals), couples(lmp, scene, list, ghosts), resumed(false)
{
  scene.id = id;
  scene.groupbit = groupbit;
  scene.friction.assign(atom->ntypes + 1, std::vector<double>(atom->ntypes + 1, 0.0));
  parse(narg, arg);
  if (scene.segments) {
    outlines = std::make_unique<TMSPHContactOutlines>(lmp, scene, memories, ghosts);
    places = std::make_unique<TMSPHContactPlaces>(lmp, scene, memories, *outlines, forces.rows(),
                                                  ghosts, totals);
  }
  scalar_flag = vector_flag = 1;
  size_vector = TMSPHContactTotals::COUNT;
  global_freq = 1;
  extscalar = extvector = 1;
  energy_global_flag = virial_global_flag = virial_peratom_flag = 1;
  thermo_virial = 1;
  restart_global = restart_peratom = 1;
  maxexchange = 1 + TMSPHContactMemory::size(0, 0, 0, 0);
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
  TMSPHWords(
      lmp, "fix tmsph/contact",
      {{"friction", "I J mu", [this](TMSPHValues &v) { read_friction(v); }},
       {"law", "name", [this](TMSPHValues &v) { scene.law = v.one_of(TMSPH::contact_laws()); }},
       {"method", "name", [this](TMSPHValues &v) { read_method(v); }},
       {"self", "yes/no", [this](TMSPHValues &v) { scene.rough_faces = v.logical(); }},
       {"stiffness", "factor",
        [this](TMSPHValues &v) {
          scene.stiffness =
              v.number(TMSPHRule::positive, "must be positive: it is a factor to the default");
        }},
       {"surface", "region-ID", [this](TMSPHValues &v) { surfaces.add_region(v.text()); }}})
      .read_all(arg + 3, arg + narg);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::read_friction(TMSPHValues &values)
{
  int ilo, ihi, jlo, jhi;
  values.types(ilo, ihi);
  values.types(jlo, jhi);
  const double value = values.number(TMSPHRule::not_negative, "must not be negative");
  for (int i = ilo; i <= ihi; i++)
    for (int j = jlo; j <= jhi; j++) scene.friction[i][j] = scene.friction[j][i] = value;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::read_method(TMSPHValues &values)
{
  scene.segments = values.one_of<bool>({{"kernel", false}, {"segment", true}});
  if (scene.segments && domain->dimension == 3)
    values.reject("segment", "needs dimension 2: use method kernel in 3-D");
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::setmask()
{
  return PRE_FORCE | POST_FORCE | MIN_POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::init()
{
  auto *pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!pair) error->all(FLERR, "Fix tmsph/contact needs pair style tmsph");
  if (modify->get_fix_by_style("^tmsph/contact$").size() > 1)
    error->all(FLERR, "More than one fix tmsph/contact: give all types in a single one");
  scene.pair = pair;
  scene.bonds = pair->bonds();
  scene.self = scene.rough_faces || TMSPHFaces::possible(lmp);
  pair->set_contact(this);
  forces.init();
  comm_forward = TMSPHContactFit::MOST_SENT;    // for LAMMPS's buffers
  bool bodies = false;
  for (int i = 1; i <= atom->ntypes; i++)
    for (int j = 1; j < i; j++) bodies = bodies || !pair->bonded(i, j);
  const FixTMSPHBond &bonds = *scene.bonds;
  if (bodies && bonds.formed() && !bonds.formed_with_contact() && scene.id != TMSPHFaces::ID &&
      comm->me == 0)
    error->warning(FLERR,
                   "Fix tmsph/contact {} was defined after the first run: bodies that stood "
                   "against each other there touch from where they are when it finds them; define "
                   "it before",
                   id);
  watch.forget();
  surfaces.init();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::follow_ids(const TMSPHPresentIds &present)
{
  list.write_back();
  memories.follow_ids(present, [&](TMSPHContactMemory &memory, tagint was, tagint is) {
    memory.follow_ids(present, was, is, domain->dimension);
  });
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::pack_exchange(int i, double *buf)
{
  list.write_back();
  return memories.pack(FixTMSPHBond::known_id(lmp, i), buf);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::unpack_exchange(int /*nlocal*/, double *buf)
{
  return memories.unpack(buf);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::write_restart(FILE *fp)
{
  TMSPHLastForce::stamp(lmp, memories);
  std::vector<double> values = {RESTART_FORMAT, (double) TMSPHContactMemory::size(1, 1, 1, 1)};
  for (int n = 0; n < TMSPHContactTotals::COUNT; n++) values.push_back(compute_vector(n));
  values.push_back(compute_scalar());
  for (const double one : search.plan()) values.push_back(one);
  values.push_back(outlines && outlines->measured ? 1.0 : 0.0);
  if (comm->me) return;
  const int size = values.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(values.data(), sizeof(double), values.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHContact::restart(char *buf)
{
  static constexpr int COUNT = TMSPHContactTotals::COUNT, PLAN = COUNT + 1,
                       MEASURED = PLAN + TMSPHContactSearch::SIZE;
  double format[2], values[MEASURED + 1];
  memcpy(format, buf, sizeof(format));
  check_restart_format(error, "fix tmsph/contact", format[0], RESTART_FORMAT);
  check_restart_format(error, "fix tmsph/contact", (int) format[1],
                       TMSPHContactMemory::size(1, 1, 1, 1));
  memcpy(values, buf + sizeof(format), sizeof(values));
  search.take_plan(values + PLAN);
  if (outlines) outlines->measured = values[MEASURED] != 0.0;
  if (comm->me) return;
  for (int n = 0; n < COUNT; n++) totals[n] = values[n];
  totals.energy = values[COUNT];
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
  return 1 + memories.size(FixTMSPHBond::known_id(lmp, i));
}

/* ---------------------------------------------------------------------- */

int FixTMSPHContact::maxsize_restart()
{
  return 1 + maxexchange;
}
