/* ----------------------------------------------------------------------
   TMSPH - thermal fracture of rock for LAMMPS. GNU General Public License v2.

   What a wall does in a step, and what it tells others.
------------------------------------------------------------------------- */

#include "fix_tmsph_wall.h"

#include "atom.h"
#include "domain.h"
#include "modify.h"
#include "tmsph_last_force.h"
#include "tmsph_wall_check.h"
#include "update.h"

using namespace LAMMPS_NS;
using namespace TMSPH;

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::move(double duration)
{
  candidates.move(duration, drive.move(duration));
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::list_candidates()
{
  candidates.list();
  for (int n = memories.count() - 1; n >= 0; n--) {    // of particles that are gone
    const int i = atom->map(memories.id(n));
    const bool here = i >= 0 && i < atom->nlocal && (atom->mask[i] & groupbit);
    if (!here) memories.erase(memories.id(n));
  }
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::act(double dt)
{
  totals.start();
  places.find(dt);
  const bool drags = drive.loaded() && scene.law.predicts;
  places.hold(dt, drags ? drive.dragged(places.stiffnesses(), dt) : 0.0);
  if (drive.loaded()) drive.push(places.forces(), dt);
}

/* ----------------------------------------------------------------------
   the first forces
------------------------------------------------------------------------- */

void FixTMSPHWall::start()
{
  act(0.0);
  if (!started) TMSPHWallCheck(lmp, scene, candidates).warn(places);
  started = true;
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::setup(int)
{
  if (!started) drive.evaluate();
  list_candidates();
  if (!started || !TMSPHLastForce::untouched(lmp, memories)) {
    start();
    return;
  }
  for (int i = 0; i < atom->nlocal; i++)
    if (const TMSPHWallMemory *memory = memories.find(atom->tag[i]))
      for (int a = 0; a < 3; a++) atom->f[i][a] += memory->force[a];
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::post_force(int)
{
  move(update->dt);
  if (candidates.outdated()) list_candidates();
  act(update->dt);
}

/* ----------------------------------------------------------------------
   equilibrium is looked for: the wall stands still, nothing is predicted
------------------------------------------------------------------------- */

void FixTMSPHWall::min_setup(int vflag)
{
  min_post_force(vflag);
}

void FixTMSPHWall::min_post_force(int)
{
  if (!started) drive.evaluate();
  list_candidates();
  start();
}

/* ---------------------------------------------------------------------- */

void FixTMSPHWall::post_run()
{
  TMSPHLastForce::stamp(lmp, memories);
}

/* ----------------------------------------------------------------------
   energy stored in the contacts
------------------------------------------------------------------------- */

double FixTMSPHWall::compute_scalar()
{
  return totals.energy_of_all(world);
}

/* ----------------------------------------------------------------------
   1-3 force on the wall, 4-6 torque on it, 7 work lost by friction so far, 8
   particles that touch, 9 deepest penetration, 10-12 displacement, 13 angle
------------------------------------------------------------------------- */

double FixTMSPHWall::compute_vector(int n)
{
  if (n == ANGLE) return scene.motion.angle;
  if (n >= DISPLACEMENT) return scene.motion.shift[n - DISPLACEMENT];
  return totals.of_all(n, world);
}

/* ---------------------------------------------------------------------- */

TMSPHWallPieces FixTMSPHWall::pieces() const
{
  return wall_pieces(scene, *domain);
}

/* ----------------------------------------------------------------------
   for dump image, which takes one fix only: any wall draws all of them
------------------------------------------------------------------------- */

int FixTMSPHWall::image(int *&kinds, double **&values)
{
  picture.clear();
  for (Fix *fix : modify->get_fix_by_style("^tmsph/wall$"))
    picture.add(dynamic_cast<FixTMSPHWall *>(fix)->pieces());
  return picture.show(domain->dimension, kinds, values);
}

/* ---------------------------------------------------------------------- */

double FixTMSPHWall::memory_usage()
{
  return candidates.bytes() + places.bytes() +
      memories.count() * (sizeof(TMSPHWallMemory) + sizeof(tagint));
}
