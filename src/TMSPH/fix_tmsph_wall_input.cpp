/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   Words, checks, migration and restart of fix tmsph/wall.
------------------------------------------------------------------------- */

#include "fix_tmsph_wall.h"

#include "atom.h"
#include "comm.h"
#include "domain.h"
#include "error.h"
#include "fix_tmsph_bond.h"
#include "force.h"
#include "tmsph_last_force.h"
#include "tmsph_restart.h"
#include "tmsph_wall_reader.h"
#include "tmsph_words.h"

#include <algorithm>
#include <cstring>

using namespace LAMMPS_NS;
using namespace FixConst;
using namespace TMSPH;

// grows when what restart files hold of this fix changes

static constexpr double RESTART_FORMAT = 4.0;

/* ---------------------------------------------------------------------- */

FixTMSPHWall::FixTMSPHWall(LAMMPS *lmp, int narg, char **arg) :
    Fix(lmp, narg, arg), drive(lmp, scene), candidates(lmp, scene),
    places(lmp, scene, drive, candidates, memories, totals), started(false)
{
  if (!atom->vfrac_flag || !atom->rmass_flag)
    error->all(FLERR, "Fix tmsph/wall needs an atom style with volume and mass: atom_style tmsph");
  scene.id = id;
  scene.groupbit = groupbit;
  char **next;
  scene.shape = TMSPHWallReader(lmp).read(arg + 3, arg + narg, next);
  parse(next, arg + narg);
  scalar_flag = vector_flag = 1;
  size_vector = NOUTPUT;
  global_freq = 1;
  extscalar = 1;
  extvector = 0;
  energy_global_flag = 1;
  restart_global = restart_peratom = 1;
  maxexchange = 1 + TMSPHWallMemory::MOST;
  atom->add_callback(Atom::GROW);
  atom->add_callback(Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

FixTMSPHWall::~FixTMSPHWall()
{
  atom->delete_callback(id, Atom::GROW);
  atom->delete_callback(id, Atom::RESTART);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::parse(char **next, char **last)
{
  std::vector<TMSPHWord> words = {
      {"friction", "mu",
       [this](TMSPHValues &v) {
         scene.friction = v.number(TMSPHRule::not_negative, "must not be negative");
       }},
      {"side", "one/both",
       [this](TMSPHValues &v) {
         scene.both_sides = v.one_of<bool>({{"one", false}, {"both", true}});
       }},
      {"law", "name", [this](TMSPHValues &v) { scene.law = v.one_of(contact_laws()); }},
      {"stiffness", "factor", [this](TMSPHValues &v) {
         scene.stiffness =
             v.number(TMSPHRule::positive, "must be positive: it is a factor to the default");
       }}};
  const std::vector<TMSPHWord> motion = drive.words();
  words.insert(words.begin() + 2, motion.begin(), motion.end());    // as on the page
  TMSPHWords(lmp, "fix tmsph/wall", std::move(words)).read_all(next, last);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::setmask()
{
  return POST_FORCE | MIN_POST_FORCE;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::init()
{
  scene.pair = dynamic_cast<PairTMSPH *>(force->pair_match("^tmsph", 0));
  if (!scene.pair) error->all(FLERR, "Fix tmsph/wall needs pair style tmsph");
  drive.init();
  places.init();
  candidates.init();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::follow_ids(const TMSPHPresentIds &present)
{
  memories.follow_ids(present, [](TMSPHWallMemory &, tagint, tagint) {});
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::pack_exchange(int i, double *buf)
{
  return memories.pack(FixTMSPHBond::known_id(lmp, i), buf);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::unpack_exchange(int /*nlocal*/, double *buf)
{
  return memories.unpack(buf);
}

/* ----------------------------------------------------------------------
   outputs, stored energy, position and velocity of the wall, loads
------------------------------------------------------------------------- */

void FixTMSPHWall::write_restart(FILE *fp)
{
  TMSPHLastForce::stamp(lmp, memories);
  const RigidMotion &motion = scene.motion;
  std::vector<double> values = {RESTART_FORMAT};
  for (int n = 0; n < NTOTALS; n++) values.push_back(compute_vector(n));
  values.push_back(compute_scalar());
  for (double s : motion.shift) values.push_back(s);
  for (double v : motion.velocity) values.push_back(v);
  for (double value : {motion.angle, motion.spin, started ? 1.0 : 0.0}) values.push_back(value);
  for (double load : drive.loads()) values.push_back(load);
  if (comm->me) return;
  const int size = values.size() * sizeof(double);
  fwrite(&size, sizeof(int), 1, fp);
  fwrite(values.data(), sizeof(double), values.size(), fp);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::restart(char *buf)
{
  RigidMotion &motion = scene.motion;
  double values[1 + NTOTALS + 10 + TMSPHWallDrive::SIZE];
  memcpy(values, buf, sizeof(double));
  check_restart_format(error, "fix tmsph/wall", values[0], RESTART_FORMAT);
  memcpy(values, buf, sizeof(values));
  const double *p = values + 1;
  if (comm->me == 0) {
    for (int n = 0; n < NTOTALS; n++) totals[n] = p[n];
    totals.energy = p[NTOTALS];
  }
  p += NTOTALS + 1;
  for (double &s : motion.shift) s = *p++;
  for (double &v : motion.velocity) v = *p++;
  motion.angle = *p++;
  motion.spin = *p++;
  started = *p++ > 0.0;
  drive.take_loads(p);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::pack_restart(int i, double *buf)
{
  buf[0] = size_restart(i);    // LAMMPS wants the length first
  return 1 + pack_exchange(i, buf + 1);
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::unpack_restart(int nlocal, int nth)
{
  double *extra = atom->extra[nlocal];
  for (int i = 0; i < nth; i++) extra += static_cast<int>(*extra);
  unpack_exchange(nlocal, extra + 1);
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::size_restart(int i)
{
  return 1 + memories.size(FixTMSPHBond::known_id(lmp, i));
}

/* ---------------------------------------------------------------------- */

int FixTMSPHWall::maxsize_restart()
{
  return 1 + maxexchange;
}
